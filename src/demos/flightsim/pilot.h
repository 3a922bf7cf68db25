#pragma once

/// A small autopilot that watches the windsock, takes off, flies a left-hand circuit and lands.
#include "flightsim/aircraft.h"

#include <string>

namespace flightsim {

/// The runway lies along +X at z = 0. The pilot knows what a pilot sees: position, velocity, attitude, how
/// the air comes. In a wind that is too much he stays down.
class Pilot {
public:
    enum class Leg {
        WATCH,
        TAKE_OFF,
        CLIMB,
        CROSSWIND,
        DOWNWIND,
        BASE,
        FINAL,
        FLARE,
        ROLL_OUT,
        STOPPED,
        STAY_DOWN
    };

    /// The sticks for the next step of `duration` s.
    FlightControls fly(const Aircraft &aircraft, real duration);

    Leg getLeg() const { return leg; }
    static std::string getName(Leg leg);

    /// What the windsock has shown before the take-off, m/s: the strongest wind, and the gusts' root mean
    /// square.
    real getStrongestWind() const { return strongest; }
    real getGusts() const;

private:
    void chooseLeg(const Aircraft &aircraft);
    void watchTheWind(const Aircraft &aircraft, real duration);
    void steerOnGround(const Aircraft &aircraft);
    void stop(const Aircraft &aircraft);
    void follow(const Aircraft &aircraft, real course, real offTrack);
    void holdClimb(const Aircraft &aircraft, real climb, real duration);
    real chooseClimb(const Aircraft &aircraft) const;

    Leg leg = Leg::WATCH;
    FlightControls sticks;
    real throttleTrim = 0;  ///< what holdClimb has learnt
    real watched = 0;       ///< s
    Vector3 windSum;        ///< m, over that time
    real windSquare = 0;    ///< m²/s
    real strongest = 0;     ///< m/s
};

}  // namespace flightsim
