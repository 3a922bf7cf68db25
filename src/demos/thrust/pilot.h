#pragma once

/// Who flies the ship when nobody else does.
#include "thrust/level.h"
#include "thrust/ship.h"

namespace thrust {

/// Flies the level's way to the rod's end, and back with the pod into the sky. Both are led by a point that
/// moves along the way and waits for them. With the pod on the rod he flies the pod: he holds the ship where
/// the rod pulls the pod as it should go, so that it hardly swings. Wherever he takes over, he makes for the
/// nearest place on the way.
class Pilot {
public:
    explicit Pilot(const Level &level);

    /// From where the ship has been launched.
    void startOver(const Ship &ship);

    /// Works out what to do now, for a step of `duration` seconds.
    void fly(const Ship &ship, real duration);
    real getHeading() const { return heading; }    ///< rad, as the ship's
    real getThrottle() const { return throttle; }  ///< 0 … 1

private:
    /// What leads: where it is, and how that changes.
    struct Lead {
        Vector3 position, velocity, acceleration;
    };

    Vector3 placeOf(const Ship &ship) const;
    void turnBack(const Ship &ship);
    void joinWay(const Ship &ship);
    void advanceLead(real speed, real duration);
    Vector3 forceAlone(const Ship &ship) const;
    Vector3 forceWithPod(const Ship &ship) const;
    void push(const Ship &ship, Vector3 force);

    std::vector<Vector3> wayIn;
    Vector3 exit;
    real gravity;
    std::vector<Vector3> way;
    std::size_t next = 0;  ///< on the way
    Vector3 marker;        ///< on the way; the lead follows it smoothly
    Lead lead;
    bool isOnWayBack = false;
    real heading = 0, throttle = 0;
};

}  // namespace thrust
