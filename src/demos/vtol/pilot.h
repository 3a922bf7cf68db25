#pragma once

/// Flies the jet from one pad to the other: straight up, on her wings, and straight down.
#include "vtol/pad.h"
#include "vtol/stabiliser.h"

namespace vtol {

/// He flies with the stabiliser, and heads into the mean wind, which the windsock shows, when he begins and
/// when he lands. He asks for a push as a vector: upwards what the wings don't carry, ahead what drag and
/// speeding up need. Its direction is where he turns the nozzles, its length the throttle.
class Pilot {
public:
    enum class Leg { LIFT_OFF, HOVER, SPEED_UP, CRUISE, FINAL, SLOW_DOWN, OVER_THE_PAD, LAND, STOPPED };
    static std::string getName(Leg leg);

    /// windFrom: the mean wind at 10 m, m/s, towards where it comes from.
    Pilot(std::size_t home, std::size_t destination, const Vector3 &windFrom);
    Pilot() : Pilot(0, 1, Vector3()) {}

    /// Goes on from where somebody else has flown.
    void takeOver(const Jet &jet);
    Leg getLeg() const { return leg; }
    /// For the next step of `duration` s; to be stabilised.
    JetControls fly(const Jet &jet, real duration);

private:
    /// What he wants of the jet now.
    struct Aim {
        real climb = 0;         ///< m/s
        real acceleration = 0;  ///< ahead, m/s²
        real bank = 0;          ///< rad
        real heading = 0;       ///< rad, in the hover
    };

    /// m: how far a place is short of the pad along the way he lands, and to starboard of that way.
    real getShortOf(const Vector3 &place) const;
    real getOffLine(const Vector3 &place) const;

    void chooseLeg(const Jet &jet, real duration);
    Aim aim(const Jet &jet) const;
    Aim aimAtPlace(const Jet &jet, const Vector3 &place, real climb) const;
    Aim aimAlong(const Jet &jet, real course, real climb) const;
    Aim aimAtLine(const Jet &jet) const;
    JetControls moveTo(const Jet &jet, const Aim &aim) const;

    Vector3 home, pad;
    Vector3 upwind;  ///< unit
    Vector3 gate;    ///< from where the way to the pad begins
    Leg leg = Leg::LIFT_OFF;
    real waited = 0;  ///< s
};

}  // namespace vtol
