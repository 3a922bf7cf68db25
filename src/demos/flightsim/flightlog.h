#pragma once

/// A flight as it is seen from the ground: how far and how high, take-offs, landings, crashes.
#include "flightsim/landing.h"

#include <optional>

namespace flightsim {

class FlightLog {
public:
    /// What the aircraft bears, and how its landings are judged.
    struct Rules {
        real wheelHeight;       ///< m: its centre of mass above its wheels
        real clearance;         ///< m: as high it has taken off
        real hardestTouchDown;  ///< m/s downwards: what is harder is a crash
        Runway runway;          ///< what one aims at
        Landing worstLanding;   ///< that is still fair
    };

    explicit FlightLog(const Rules &r) : rules(r) {}

    /// It goes on with an aircraft that has been put somewhere.
    void launch(bool inTheAir) { airborne = inTheAir; }

    void noteBeforeStep(const RigidBody &body);
    struct News {
        std::string text;  ///< "touched down at …"
        bool isCrash = false;
    };
    /// isTouching: with wheels and skids. brokenPart: see findBrokenPart.
    std::optional<News> watchAfterStep(const RigidBody &body, bool isTouching, const std::string &brokenPart);

    real getHeight(const RigidBody &body) const { return body.getPosition().y - rules.wheelHeight; }
    real getDistance() const { return distance; }  ///< m, flown
    real getHighest() const { return highest; }    ///< m
    /// Landings and crashes.
    std::string getSummary() const;

private:
    std::optional<News> findNews(const RigidBody &body, bool isTouching, const std::string &brokenPart);

    Rules rules;
    Vector3 lastPosition, lastVelocity;  ///< before the step
    bool airborne = false;
    LandingLog landings;
    unsigned crashes = 0;
    real highest = 0, distance = 0;
};

}  // namespace flightsim
