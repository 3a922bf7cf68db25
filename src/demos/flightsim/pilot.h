#pragma once

/// A small autopilot that takes off, flies a left-hand circuit and lands.
#include "flightsim/aircraft.h"

#include <string>

namespace flightsim {

/// The runway lies along +X at z = 0. The pilot knows what a pilot sees (position, velocity, attitude) but
/// not the wind.
class Pilot {
public:
    enum class Leg { TAKE_OFF, CLIMB, CROSSWIND, DOWNWIND, BASE, FINAL, FLARE, ROLL_OUT, STOPPED };

    /// The sticks for the next step of `duration` s.
    FlightControls fly(const Aircraft &aircraft, real duration);

    Leg getLeg() const { return leg; }
    static std::string getName(Leg leg);

private:
    void chooseLeg(const Aircraft &aircraft);
    void steerOnGround(const Aircraft &aircraft);
    void follow(const Aircraft &aircraft, real course, real offTrack);
    void holdClimb(const Aircraft &aircraft, real climb, real duration);
    real chooseClimb(const Aircraft &aircraft) const;

    Leg leg = Leg::TAKE_OFF;
    FlightControls sticks;
    real throttleTrim = 0;  ///< what holdClimb has learnt
};

}  // namespace flightsim
