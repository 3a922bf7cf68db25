#pragma once

/// @file
/// The game loop's clock: wall-clock time in, fixed physics steps out.
#include <cyclone/precision.h>

namespace cyclone {

/// Says how many steps of a fixed length the simulation has to run to keep up with the wall clock.
///
///     for (unsigned n = clock.advance(elapsed); n > 0; --n) {
///         before = body.getState();
///         world.startFrame();
///         world.runPhysics(clock.getStep());
///     }
///     draw(RigidBody::State::linearInterpolate(before, body.getState(), clock.getFraction()));
///
/// Only the number of steps depends on the clock, never their length: the same inputs at the same steps give
/// the same bits, at every frame rate.
class CYCLONE_API FixedStep {
public:
    /// The step's length (s, positive), and the longest wall-clock time (s, between one step and a million
    /// steps) that is made good at once. What is beyond is dropped: the simulation slows down rather than
    /// fall ever further behind.
    FixedStep(real step, real maxElapsed);
    /// With a longest time of a quarter of a second, within those limits.
    explicit FixedStep(real length = 1.0 / 60) : FixedStep(length, real_clamp(0.25, length, 1e6 * length)) {}

    /// Takes the time that has passed since the last call (s, not negative) and says how many steps to run
    /// now. Where that is close to a whole number of steps, to within a tenth of one, it is this number, so
    /// that a display of the same rate, whose frames are never quite even, gets one step a frame. What is
    /// left out counts later: no time is lost.
    unsigned advance(real elapsed);
    /// How much of the next step the wall clock has covered already, from 0 to less than 1: draw this far
    /// between the last two states.
    real getFraction() const;
    real getStep() const { return step; }

    /// Forgets what has not been run yet: after a pause, a load, a rewind.
    void reset() { remainder = 0; }

private:
    /// In steps: how far from a whole number of them a frame may be, and the remainder beyond its bounds.
    static constexpr real SLACK = 0.1;

    real step, maxElapsed;
    real remainder = 0;  ///< s, owed to the wall clock; below 0 where the simulation is ahead
};

}  // namespace cyclone
