#pragma once

/// Who moves the sticks: a stabiliser for whoever flies, and a pilot.
#include "airrace/aircraft.h"
#include "airrace/hoop.h"

namespace airrace {

/// How to fly.
struct Command {
    real bank = 0;      ///< rad, positive to starboard
    real climb = 0;     ///< rad, of the path over the ground
    real throttle = 1;  ///< 0 … 1
};

/// Moves the sticks so that the aircraft takes a bank and a climb, and keeps them: it pulls as much as the
/// turn needs. How soon it gets there, and whether it can, is the aircraft's affair; nothing here prevents a
/// stall.
class Stabiliser {
public:
    static constexpr real MOST_LOAD = 6, LEAST_LOAD = -1;  ///< times its weight: what it lets the wings bear

    Sticks hold(const Aircraft &aircraft, const Command &command, real duration);

private:
    real trim = 0;  ///< of the elevator: what it has learnt
};

/// Flies through the hoops, each in the right way; round again to one that he has missed. He knows what his
/// aircraft can do.
class Pilot {
public:
    /// On to this hoop.
    Command fly(const Aircraft &aircraft, const Hoop &hoop);

private:
    bool goesRound = false;  ///< he is past the hoop, and has to come back
};

}  // namespace airrace
