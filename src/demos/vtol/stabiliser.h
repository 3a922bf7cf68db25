#pragma once

/// What keeps the jet upright for whoever holds the sticks.
#include "vtol/jet.h"

namespace vtol {

/// Turns what the sticks ask for into what puffers and surfaces do:
///
///     stick to and fro     the pitch, up to 20°, held
///     stick to a side      the bank, up to 40°, held
///     pedals               the rate of turning, up to 40°/s, on top of that of a clean turn
///     throttle             less when she rises, more when she sinks
///
/// When she is slow, she also leans against her drift over the ground, so that with the sticks centred she
/// comes to a stop. All that she does about drift, rise and sinking fades with the speed over the ground,
/// between 8 and 16 m/s.
class Stabiliser {
public:
    static constexpr real MOST_PITCH = 20 * cyclone::REAL_PI / 180;  ///< rad
    static constexpr real MOST_BANK = 40 * cyclone::REAL_PI / 180;   ///< rad
    static constexpr real MOST_TURN = 40 * cyclone::REAL_PI / 180;   ///< rad/s

    /// What it adds on its own, to the pitch (rad), the bank (rad) and the throttle.
    struct Correction {
        real pitch = 0, bank = 0, throttle = 0;
    };
    static Correction getCorrection(const Jet &jet);

    /// The controls that do what these ask for.
    static JetControls hold(const Jet &jet, const JetControls &asked);
};

}  // namespace vtol
