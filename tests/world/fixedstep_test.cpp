#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

// ---- The clock

TEST(FixedStep, CountsStepsAndKeepsTheRest) {
    FixedStep clock(1.0 / 64, 1);  // binary fractions: every number below is exact
    EXPECT_EQ(clock.getStep(), 1.0 / 64);
    EXPECT_EQ(clock.getFraction(), 0);
    EXPECT_EQ(clock.advance(0), 0U);
    EXPECT_EQ(clock.advance(1.0 / 128), 0U);
    EXPECT_EQ(clock.getFraction(), 0.5);
    EXPECT_EQ(clock.advance(1.0 / 128), 1U);
    EXPECT_EQ(clock.getFraction(), 0);
    EXPECT_EQ(clock.advance(5.0 / 64 + 1.0 / 256), 5U);
    EXPECT_EQ(clock.getFraction(), 0.25);
    EXPECT_EQ(clock.advance(3.0 / 256), 1U);
    EXPECT_EQ(clock.getFraction(), 0);
}

TEST(FixedStep, SixtyADefaultAndAQuarterOfASecondAtOnce) {
    FixedStep clock;
    EXPECT_EQ(clock.getStep(), 1.0 / 60);
    EXPECT_EQ(clock.advance(1.0 / 60), 1U);
    EXPECT_EQ(clock.advance(100), 15U);
}

/// An hour of uneven frames, measured in whole nanoseconds as clocks do, against counting in integers.
TEST(FixedStep, DoesNotDriftInAnHour) {
    Random random(1);
    for (std::int64_t stepsPerSecond : {50, 60, 90, 144}) {
        FixedStep clock(1 / static_cast<real>(stepsPerSecond), 1);
        std::int64_t nanoseconds = 0, steps = 0;
        constexpr std::int64_t BILLION = 1000000000;
        while (nanoseconds < 3600 * BILLION) {
            const std::int64_t elapsed = static_cast<std::int64_t>(random.between(1e6, 6e7));
            nanoseconds += elapsed;
            steps += clock.advance(static_cast<real>(elapsed) / 1e9);
            ASSERT_GE(clock.getFraction(), 0);
            ASSERT_LT(clock.getFraction(), 1);

            const std::int64_t wanted = nanoseconds * stepsPerSecond;  // billionths of a step
            const std::int64_t whole = wanted / BILLION;
            const real difference = static_cast<real>(steps - whole) +
                                    (clock.getFraction() - static_cast<real>(wanted % BILLION) / 1e9);
            ASSERT_NEAR(difference, 0, 0.1 + 1e-9) << "after " << steps << " steps";
        }
    }
}

/// A display of 60 Hz whose frames jitter by 0.1 ms: one step a frame, and no time lost.
TEST(FixedStep, GivesOneStepToEachFrameThatIsNearlyOne) {
    for (const bool ofFrames : {false, true}) {
        Random random(3);
        FixedStep clock(1.0 / 60);
        real jitter = 0, wall = 0, steps = 0;
        int uneven = 0;
        for (int n = 0; n < 60000; ++n) {
            const real before = jitter;
            jitter = random.between(-1e-4, 1e-4);
            const real elapsed = 1.0 / 60 + jitter - (ofFrames ? 0 : before);
            wall += elapsed;
            const unsigned now = clock.advance(elapsed);
            steps += now;
            uneven += now != 1;
            ASSERT_NEAR((steps + clock.getFraction()) / 60, wall, 0.1001 / 60);
        }
        // Where each frame's own length jitters, the sum walks at random, by a step now and then.
        EXPECT_LE(uneven, ofFrames ? 20 : 0);
    }
}

TEST(FixedStep, ASimulationAheadOfTheClockWaits) {
    FixedStep clock(1.0 / 64, 1);
    EXPECT_EQ(clock.advance(0.95 / 64), 1U);
    EXPECT_EQ(clock.getFraction(), 0);
    EXPECT_EQ(clock.advance(0.03 / 64), 0U);
    EXPECT_EQ(clock.getFraction(), 0);
    EXPECT_EQ(clock.advance(0.5 / 64), 0U);
    EXPECT_NEAR(clock.getFraction(), 0.48, 1e-12);
    EXPECT_EQ(clock.advance(0.6 / 64), 1U);
    EXPECT_NEAR(clock.getFraction(), 0.08, 1e-12);
}

/// Elapsed times as close to whole steps as numbers come.
TEST(FixedStep, FractionIsAlwaysBelowOne) {
    Random random(2);
    for (int n = 0; n < 20000; ++n) {
        const real step = random.between(0.001, 0.1);
        FixedStep clock(step, 100 * step);
        const real whole = std::floor(random.between(1, 90));
        real elapsed = whole * step;
        for (int nudge = static_cast<int>(random.between(-3, 4)); nudge != 0; nudge += nudge < 0 ? 1 : -1)
            elapsed = std::nextafter(elapsed, nudge < 0 ? 0.0 : 1e9);
        const real steps = clock.advance(elapsed);
        ASSERT_GE(clock.getFraction(), 0);
        ASSERT_LT(clock.getFraction(), 1) << step << " " << elapsed;
        ASSERT_NEAR(steps + clock.getFraction(), whole, 1e-12);
    }
}

/// A simulation that takes longer than the time it simulates must not owe ever more.
TEST(FixedStep, DropsWhatItCannotMakeGood) {
    FixedStep clock(1.0 / 64, 0.25);
    EXPECT_EQ(clock.advance(1000), 16U);
    EXPECT_EQ(clock.getFraction(), 0);
    EXPECT_EQ(clock.advance(0), 0U);
    real elapsed = 0.02;
    for (int frame = 0; frame < 100; ++frame) {
        const unsigned steps = clock.advance(elapsed);
        ASSERT_LE(steps, 16U);
        elapsed = steps * 0.03;  // each step takes twice its own length
    }
    EXPECT_LE(clock.advance(elapsed) * clock.getStep(), 0.25);
    EXPECT_EQ(clock.advance(REAL_MAX), 16U);
}

TEST(FixedStep, ResetForgets) {
    FixedStep clock(1.0 / 64, 1);
    clock.advance(1.75 / 64);
    EXPECT_EQ(clock.getFraction(), 0.75);
    clock.reset();
    EXPECT_EQ(clock.getFraction(), 0);
    EXPECT_EQ(clock.advance(0.5 / 64), 0U);
    EXPECT_EQ(clock.getStep(), 1.0 / 64);
}

TEST(FixedStep, RefusesBadArguments) {
    for (real step : {0.0, -1.0, PLUS_INFINITY, QUIET_NAN})
        EXPECT_THROW(FixedStep(step, 1), std::invalid_argument) << step;
    for (real longest : {0.0, -1.0, 0.009, 1e5, PLUS_INFINITY, QUIET_NAN})
        EXPECT_THROW(FixedStep(0.01, longest), std::invalid_argument) << longest;
    EXPECT_THROW(FixedStep(0.5, 0.55e6), std::invalid_argument);
    EXPECT_NO_THROW(FixedStep(0.5, 0.5e6));
    EXPECT_NO_THROW(FixedStep(0.5, 0.5));
    FixedStep clock(1.0 / 64, 1);
    clock.advance(0.5 / 64);
    for (real elapsed : {-1e-9, PLUS_INFINITY, QUIET_NAN})
        EXPECT_THROW(clock.advance(elapsed), std::invalid_argument) << elapsed;
    EXPECT_EQ(clock.getFraction(), 0.5);
}

/// The states that a game goes through, whatever its frame rate.
std::uint64_t playTwoSeconds(real framesPerSecond) {
    World world;
    Drag drag(0.1, 0.2);
    RigidBody *const body = world.createBody();
    body->setVelocity(3, 20, 0);
    body->setAcceleration(Vector3::GRAVITY);
    world.getForceRegistry().add(body, &drag);
    FixedStep clock(1.0 / 60);
    for (unsigned steps = 0; steps < 120;) {
        for (unsigned n = clock.advance(1 / framesPerSecond); n > 0 && steps < 120; --n, ++steps) {
            world.startFrame();
            world.runPhysics(clock.getStep());
        }
    }
    return world.hash();
}

TEST(FixedStep, SameBitsAtEveryFrameRate) {
    const std::uint64_t hash = playTwoSeconds(60);
    for (real rate : {20.0, 37.0, 144.0, 1000.0}) EXPECT_EQ(playTwoSeconds(rate), hash) << rate;
}

// ---- Drawing between two states

TEST(StateInterpolation, MovesInAStraightLine) {
    RigidBody::State a, b;
    a.position = Vector3(1, 2, 3);
    a.velocity = Vector3(0, 0, 1);
    a.rotation = Vector3(1, 0, 0);
    b.position = Vector3(2, 0, 3);
    b.velocity = Vector3(4, 0, 1);
    b.rotation = Vector3(0, 1, 0);
    const RigidBody::State s = RigidBody::State::linearInterpolate(a, b, 0.25);
    EXPECT_EQ(s.position, Vector3(1.25, 1.5, 3));
    EXPECT_EQ(s.velocity, Vector3(1, 0, 1));
    EXPECT_EQ(s.rotation, Vector3(0.75, 0.25, 0));
    EXPECT_EQ(RigidBody::State::linearInterpolate(a, b, 0).position, a.position);
    EXPECT_EQ(RigidBody::State::linearInterpolate(a, b, 1).position, b.position);
}

TEST(StateInterpolation, TurnsTheShortWay) {
    const real degree = REAL_PI / 180;
    RigidBody::State a, b;
    const Vector3 axis(1, -2, 0.5);
    a.orientation = Quaternion::fromAxisAngle(axis, 350 * degree);
    b.orientation = Quaternion::fromAxisAngle(axis, 10 * degree);
    for (real sign : {1.0, -1.0}) {
        const Quaternion &q = b.orientation;
        b.orientation = Quaternion(sign * q.r, sign * q.i, sign * q.j, sign * q.k);
        const auto between = [&](real prop) {
            return RigidBody::State::linearInterpolate(a, b, prop).orientation;
        };
        EXPECT_TRUE(turnsLike(between(0), a.orientation, 1e-15));
        EXPECT_TRUE(turnsLike(between(1), b.orientation, 1e-15));
        EXPECT_TRUE(turnsLike(between(0.5), Quaternion(), 1e-15));
        EXPECT_TRUE(turnsLike(between(0.25), Quaternion::fromAxisAngle(axis, 355 * degree), 1e-4));
        EXPECT_NEAR(between(0.3).squareMagnitude(), 1, 1e-15);
    }
}

/// Between two steps of a top, against the orientation that it really has then.
TEST(StateInterpolation, DrawsASpinningBodyWhereItIs) {
    RigidBody body;
    body.setRotation(0, 6, 0);  // 0.1 rad a step
    const real step = 1.0 / 60;
    for (int n = 0; n < 50; ++n) {
        const RigidBody::State before = body.getState();
        body.integrate(step);
        const real prop = n / 50.0;
        const Quaternion drawn =
            RigidBody::State::linearInterpolate(before, body.getState(), prop).orientation;
        EXPECT_TRUE(turnsLike(drawn, Quaternion::fromAxisAngle(Vector3::Y, 6 * step * (n + prop)), 5e-6))
            << n;
    }
}

TEST(StateInterpolation, TakesTheRestFromTheLaterState) {
    RigidBody::State a, b;
    b.mass = 3;
    b.inverseMass = 1.0 / 3;
    b.awake = false;
    b.acceleration = Vector3::GRAVITY;
    const RigidBody::State s = RigidBody::State::linearInterpolate(a, b, 0.1);
    EXPECT_EQ(s.mass, 3);
    EXPECT_FALSE(s.awake);
    EXPECT_EQ(s.acceleration, Vector3::GRAVITY);
    EXPECT_EQ(s.findError(), nullptr);
}

}  // namespace
