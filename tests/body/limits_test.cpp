/// At the limits of numbers and beyond them.
#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

constexpr real H = 1.0 / 60;

void expectPossible(const RigidBody &body) {
    EXPECT_EQ(body.getState().findError(), nullptr) << body.getState().findError();
}

}  // namespace

// ---- Inertia

TEST(Limits, MomentsMayDifferByATrillion) {
    for (const real ratio : {1e3, 1e6, 1e9, 1e12}) {
        for (const Matrix3 &inverse : {diagonal(1, 1 / ratio, 1 / ratio), diagonal(1, 1, 1 / ratio),
                                       diagonal(1 / ratio, 1, 1), diagonal(1, 1 / ratio, 1)}) {
            RigidBody body;
            body.setInverseInertiaTensor(inverse);
            body.setRotation(1, 0.5, -0.25);
            const real speed = body.getRotation().magnitude();
            const real energy = body.getAngularMomentum() * body.getRotation();
            for (int n = 0; n < 6000; ++n) {
                ASSERT_TRUE(body.integrate(H));
                // Two moments are equal, so speed and energy are constant. Where the lesser momentum is a
                // trillionth, rounding of the greater one counts 1e12·1e-16 a step, by √6000 in a random
                // walk.
                ASSERT_NEAR(body.getRotation().magnitude(), speed, 1e-2) << ratio;
                ASSERT_NEAR(body.getAngularMomentum() * body.getRotation(), energy, 1e-9 * energy) << ratio;
            }
        }
    }
}

TEST(Limits, GreaterRatiosAndExtremeMomentsAreRefusedByBothSetters) {
    const Matrix3 tilt = rotationMatrix(Quaternion::fromAxisAngle(Vector3(1, 2, 3), 0.5));
    for (const Vector3 &values :
         {Vector3(1, 1e13, 1e13), Vector3(1e-101, 1e-101, 1e-101), Vector3(1, 1, 1e16),
          Vector3(1e101, 1e101, 1e101), Vector3(1e308, 1e308, 1e308)}) {
        for (const Matrix3 &axes : {diagonal(1, 1, 1), tilt}) {
            const Matrix3 tensor = axes * diagonal(values.x, values.y, values.z) * axes.transpose();
            RigidBody body;
            EXPECT_THROW(body.setInertiaTensor(tensor), std::invalid_argument) << values.z;
            EXPECT_EQ(body.getInertiaTensor(), diagonal(1, 1, 1));
            if (axes == tilt && values.z == 1e16) continue;  // the small ones are rounding, and locked
            EXPECT_THROW(body.setInverseInertiaTensor(tensor), std::invalid_argument) << values.z;
            EXPECT_EQ(body.getInverseInertiaTensor(), diagonal(1, 1, 1));
        }
    }
    RigidBody body;
    EXPECT_THROW(body.setInverseInertiaTensor(diagonal(1e308, 0, 0)), std::invalid_argument);
    EXPECT_THROW(body.setInverseInertiaTensor(diagonal(0, 1e-300, 0)), std::invalid_argument);
    EXPECT_NO_THROW(body.setInverseInertiaTensor(diagonal(1e99, 0, 0)));
    EXPECT_NO_THROW(body.setInertiaTensor(diagonal(1e-99, 1e-99, 1e-99)));
}

/// 1e-100 to 1e100 kg·m², and 1e12 times the least.
TEST(Limits, OfMomentsAreThoseOfTheRule) {
    RigidBody body;
    for (const real good : {1e-100, 1e100})
        EXPECT_NO_THROW(body.setInertiaTensor(diagonal(good, good, good)));
    for (const real bad : {0.9e-100, 1.1e100})
        EXPECT_THROW(body.setInertiaTensor(diagonal(bad, bad, bad)), std::invalid_argument) << bad;
    EXPECT_NO_THROW(body.setInertiaTensor(diagonal(1e12, 2, 1)));
    EXPECT_THROW(body.setInertiaTensor(diagonal(1.1e12, 2, 1)), std::invalid_argument);
    EXPECT_NO_THROW(body.setInverseInertiaTensor(diagonal(1e-100, 0, 0)));
    EXPECT_THROW(body.setInverseInertiaTensor(diagonal(0.9e-100, 0, 0)), std::invalid_argument);
}

// ---- Mass, motion and place

TEST(Limits, TheGreatestMassIsStillOne) {
    RigidBody body;
    body.setMass(REAL_MAX);
    EXPECT_TRUE(body.hasFiniteMass());
    EXPECT_EQ(body.getMass(), REAL_MAX);
    body.setAcceleration(Vector3::GRAVITY);
    body.addForce(Vector3(REAL_MAX, 0, 0));
    ASSERT_TRUE(body.integrate(1));
    EXPECT_NEAR(body.getVelocity().x, 1, 1e-12);
    EXPECT_NEAR(body.getVelocity().y, -9.81, 1e-12);
    expectPossible(body);
}

TEST(Limits, APlaceAsFarAsNumbersGo) {
    RigidBody body;
    body.setPosition(1e308, 1e308, 1e308);
    body.setVelocity(1, 2, 3);
    EXPECT_TRUE(body.integrate(H));
    EXPECT_EQ(body.getPosition(), Vector3(1e308, 1e308, 1e308));
    expectPossible(body);
}

TEST(Limits, WhatSettersAcceptCanBeSaved) {
    RigidBody sleepy;
    sleepy.setSleepEpsilon(1e308);
    expectPossible(sleepy);
    sleepy.setCanSleep();
    sleepy.setVelocity(1e160, 0, 0);
    sleepy.integrate(1e-17);
    expectPossible(sleepy);

    RigidBody heavy;
    heavy.setInertiaTensor(diagonal(1e10, 1e10, 1e10));
    heavy.setInverseMass(0);
    heavy.setRotation(1e300, 0, 0);
    EXPECT_THROW(heavy.setMass(1), std::invalid_argument);
    EXPECT_FALSE(heavy.hasFiniteMass());
    expectPossible(heavy);

    RigidBody needle;
    needle.setInertiaTensor(diagonal(1, 1e10, 1e10));
    needle.setRotation(1e300, 0, 0);
    EXPECT_THROW(needle.setOrientation(Quaternion(1, 0, 0, 1)), std::invalid_argument);
    expectPossible(needle);

    RigidBody fast;
    fast.setRotation(REAL_MAX, -REAL_MAX, REAL_MAX);
    expectPossible(fast);
    fast.setRotation(5e-324, 0, 1e-320);
    expectPossible(fast);
}

TEST(Limits, ForcesThatAreNotFiniteAreSavedAndFaultLater) {
    for (const Vector3 &force : {Vector3(QUIET_NAN, 0, 0), Vector3(0, PLUS_INFINITY, 0)}) {
        RigidBody body, restored;
        body.setVelocity(1, 2, 3);
        body.addForce(force);
        expectPossible(body);
        restored.setState(body.getState());
        EXPECT_FALSE(restored.integrate(H));
        EXPECT_TRUE(restored.hasFaulted());
        EXPECT_EQ(restored.getVelocity(), Vector3(1, 2, 3));
        expectPossible(restored);
    }
}

// ---- Damping and sleep

/// Velocity and place agree however strong the damping: a constant acceleration A against damping d ends at
/// A/(−ln d), which a step of h/2 on either side of the frame cannot miss by more than A·h.
TEST(Limits, DampingNearZeroMovesAsItReads) {
    for (const real damping : {0.0, 5e-324, 1e-300, 1e-100, 1e-10, 1e-3, 0.5}) {
        RigidBody body;
        body.setLinearDamping(damping);
        body.setAcceleration(10, 0, 0);
        real before = 0;
        for (int n = 0; n < 6000; ++n) {
            before = body.getPosition().x;
            ASSERT_TRUE(body.integrate(H));
        }
        const real moved = (body.getPosition().x - before) / H;
        const real terminal = damping > 0 ? 10 / -real_log(damping) : 0;
        EXPECT_NEAR(body.getVelocity().x, terminal, 0.08 * terminal) << damping;
        EXPECT_NEAR(moved, terminal, 0.75 * terminal) << damping;
    }
}

TEST(Limits, ANewAccelerationWakesASleeper) {
    RigidBody body;
    body.setAwake(false);
    body.setAcceleration(0, 0, 0);
    EXPECT_FALSE(body.getAwake());
    body.setAcceleration(0, -1, 0);
    EXPECT_TRUE(body.getAwake());
    body.setAwake(false);
    body.setAcceleration(0, -1, 0);  // none that it had not fallen asleep under
    EXPECT_FALSE(body.getAwake());
    body.setAcceleration(0, -2, 0);
    EXPECT_TRUE(body.getAwake());
}

// ---- What a step cannot bear

/// A spring of ω·h > 2 swings up without limit; its body faults before it is absurd, and nothing else does.
TEST(Limits, AnUnbearableSpringFaultsItsBodyAlone) {
    World world;
    RigidBody *const held = world.createBody(), *const bystander = world.createBody();
    held->setPosition(1.1, 0, 0);
    bystander->setVelocity(1, 0, 0);
    AnchoredSpring spring(Vector3(), Vector3(), 5 / (H * H), 1);
    world.getForceRegistry().add(held, &spring);
    for (int n = 0; n < 2000; ++n) {
        world.startFrame();
        world.runPhysics(H);
        ASSERT_LE(held->getVelocity().magnitude(), RigidBody::MAX_SPEED);
        ASSERT_LE(held->getPosition().magnitude(), RigidBody::MAX_SPEED);
        expectPossible(*held);
    }
    EXPECT_EQ(world.getFaultedBodies(), World::RigidBodies{held});
    EXPECT_NEAR(bystander->getPosition().x, 2000 * H, 1e-9);
}

/// Whether a chain of masses, each bound to the next by a spring, stays together for a minute.
bool holds(int masses, real springConstant, real kilograms) {
    World world;
    for (int n = 0; n < masses; ++n) {
        world.createBody()->setMass(kilograms);
        world.getBodies().back()->setPosition(n + 0.01 * (n % 2), 0, 0);
        if (n > 0)
            world.createSpring(world.getBodies()[static_cast<std::size_t>(n) - 1], Vector3(),
                               world.getBodies().back(), Vector3(), springConstant, 1);
    }
    for (int n = 0; n < 3600; ++n) {
        world.startFrame();
        world.runPhysics(H);
        for (const RigidBody *body : world.getBodies())
            if (body->hasFaulted() || body->getVelocity().magnitude() > 1e3) return false;
    }
    return true;
}

/// ω² is k·(1/m₁ + 1/m₂) of a pair; of a long chain the fastest motion, neighbours against each other, has
/// 4·k/m, of one of N masses 2·k/m·(1 + cos(π/N)).
TEST(Limits, SpringsHoldUpToTwoOverOmega) {
    const real kilograms = 3;
    const auto constantFor = [&](real omegaSteps, real perMass) {
        return omegaSteps * omegaSteps / (H * H) * kilograms / perMass;
    };
    EXPECT_TRUE(holds(2, constantFor(1.95, 2), kilograms));
    EXPECT_FALSE(holds(2, constantFor(2.05, 2), kilograms));
    const real ofTen = 2 * (1 + std::cos(REAL_PI / 10));
    EXPECT_TRUE(holds(10, constantFor(1.95, ofTen), kilograms));
    EXPECT_FALSE(holds(10, constantFor(2.05, ofTen), kilograms));
}

TEST(Limits, ASpringSaysWhatStepItBears) {
    RigidBody light, heavy;
    heavy.setMass(4);
    heavy.setInertiaTensor(diagonal(2, 2, 2));
    heavy.setPosition(5, 0, 0);
    Spring spring(&light, Vector3(), &heavy, Vector3(0, 3, 0), 100, 1);
    // The line is along (5, 3, 0): 1/m + (r × n)²/I of the far end, with r = (0, 3, 0).
    const real lever = 3 * 5 / std::sqrt(34.0);
    const real omega = std::sqrt(100 * (1 + 0.25 + lever * lever / 2));
    EXPECT_NEAR(spring.getLongestStep(light), 2 / omega, 1e-12);
    EXPECT_NEAR(spring.getLongestStep(heavy), 2 / omega, 1e-12);
    AnchoredSpring anchored(Vector3(), Vector3(1, 0, 0), 100, 1);
    EXPECT_NEAR(anchored.getLongestStep(heavy), 2 / std::sqrt(25.0), 1e-12);
    heavy.setInverseMass(0);
    EXPECT_EQ(anchored.getLongestStep(heavy), PLUS_INFINITY);
    EXPECT_NEAR(spring.getLongestStep(light), 0.2, 1e-12);
}

/// An explicit step has z + (ω·h/2)² < 1 for resistance and spring together; an implicit one any resistance.
TEST(Limits, SpringsShareTheStepWithWeakResistance) {
    const real omegaSteps = 1.5;
    for (const real z : {0.0, 0.2, 0.4, 1.0, 3.0, 1e3, 1e9}) {
        RigidBody body;
        body.setPosition(1, 0, 0);
        AnchoredSpring spring(Vector3(), Vector3(), omegaSteps * omegaSteps / (H * H), 0);
        Drag drag(z / H, 0);
        ForceRegistry registry;
        registry.add(&body, &spring);
        registry.add(&body, &drag);
        for (int n = 0; n < 3000; ++n) {
            registry.updateForces(H);
            ASSERT_TRUE(body.integrate(H));
            // Undamped, the scheme swings by at most 1/√(1 − (ω·h/2)²).
            ASSERT_LE(body.getPosition().magnitude(), 1.55) << z;
        }
    }
}

// ---- Snapshots and hashes

TEST(Limits, ZeroHasNoSignInAHash) {
    RigidBody plus, minus;
    minus.setVelocity(-0.0, 0, -0.0);
    minus.setAcceleration(0, -0.0, 0);
    RigidBody *const bodies[] = {&plus, &minus};
    EXPECT_EQ(hashStates(bodies, 1), hashStates(bodies + 1, 1));
}

/// A step's orientation takes over what the principal axes are off; more than their own rounding would add
/// up.
TEST(Limits, PrincipalAxesThatAreNotQuiteUnitAreRefused) {
    Random random(11);
    for (int n = 0; n < 1000; ++n) {
        RigidBody body;
        const Matrix3 tilt = rotationMatrix(random.orientation());
        body.setInertiaTensor(tilt * diagonal(2, 3, 4) * tilt.transpose());
        body.setRotation(random.vector());
        RigidBody::State state = body.getState();
        expectPossible(body);
        state.principalAxes.r *= 1 + random.between(-64, 64) * REAL_EPSILON;
        if (state.findError() != nullptr) continue;
        body.setState(state);
        for (int step = 0; step < 10; ++step) {
            body.integrate(H);
            expectPossible(body);
        }
    }
}

// ---- Mass properties

TEST(Limits, SumsOfMassPropertiesAreThoseOfRealThings) {
    // Each misses what is possible by the rounding that is let pass, in axes of its own.
    const MassProperties parts[] = {MassProperties(1, Vector3(), diagonal(1, 1, 2 + 1.9e-9)),
                                    MassProperties(1, Vector3(), diagonal(2 + 1.9e-9, 1, 1)),
                                    MassProperties(1, Vector3(), diagonal(1, 1, -0.9e-9))};
    for (const MassProperties &a : parts) {
        for (const MassProperties &b : parts) {
            const MassProperties sum = a + b;
            EXPECT_NO_THROW(MassProperties(sum.getMass(), sum.getCentre(), sum.getInertiaTensor()));
        }
    }
}

TEST(Limits, MassPropertiesStayFiniteWhenPlaced) {
    const MassProperties planet(1e300, Vector3(), diagonal(1e308, 1e308, 1e308));
    const MassProperties turned = planet.placedAt(Vector3(1, 2, 3), Quaternion(0.1, 0.2, 0.3, 0.9));
    EXPECT_TRUE(turned.getInertiaTensor().isFinite());
}
