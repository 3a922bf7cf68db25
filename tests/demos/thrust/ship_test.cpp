#include "thrust/ship.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.h"
#include "base/random.h"
#include "frames.h"

namespace {

using cyclone::real;
using cyclone::REAL_PI;
using cyclone::RigidBody;
using cyclone::Vector3;
using cyclone_test::run;
using cyclone_test::STEP;
using thrust::Ship;

constexpr real G = 1.2, M = Ship::MASS, POD = Ship::POD_MASS, L = Ship::ROD_LENGTH;
/// By which the rod's spring is longer under the pod's weight, and so the pendulum.
constexpr real SAG = 0.005;

/// Ship and pod in a vacuum.
struct Space {
    cyclone::World world;
    Ship ship{world, nullptr};

    explicit Space(real gravity = G) { ship.launch({3, 20, 0}, {3, 20 - L, 0}, gravity); }

    /// On the rod, the pod swung out by this angle, at rest.
    void hookAt(real angle) {
        ship.hook();
        ship.getPod().setPosition(ship.getBody().getPosition() +
                                  Vector3(std::sin(angle), -std::cos(angle), 0) * L);
    }
    void letGo() {
        ship.setThrottle(1e-9);
        ship.setThrottle(0);
    }
    Vector3 momentum() const { return ship.getBody().getVelocity() * M + ship.getPod().getVelocity() * POD; }
    real energy() const {
        const RigidBody &body = ship.getBody(), &pod = ship.getPod();
        return M * (body.getVelocity().squareMagnitude() / 2 + G * body.getPosition().y) +
               POD * (pod.getVelocity().squareMagnitude() / 2 + G * pod.getPosition().y);
    }
    real rodLength() const {
        return (ship.getPod().getPosition() - ship.getBody().getPosition()).magnitude();
    }
    /// s, from one passage through the vertical to the next but one.
    real period() {
        real passages[3];
        int count = 0;
        real last = ship.getSwing();
        for (int n = 1; count < 3 && n < 120 * 60; ++n) {
            run(world, 1);
            const real now = ship.getSwing();
            if ((now > 0) != (last > 0)) passages[count++] = (n - now / (now - last)) * STEP;
            last = now;
        }
        EXPECT_EQ(count, 3);
        return passages[2] - passages[0];
    }
};

// ---- In the plane

TEST(ThrustShip, NeverLeavesThePlaneToTheBit) {
    cyclone::World world;
    Vector3 wind(1, 2, 50);
    Ship ship(world, &wind);
    ship.launch({3, 20, 0}, {3, 15, 0}, G);
    ship.hook();
    demo::Random random(3);
    for (int n = 0; n < 3000; ++n) {
        ship.setHeading(random.between(-3, 3));
        ship.setThrottle(random.between(0, 1));
        world.startFrame();
        for (RigidBody *body : {&ship.getBody(), &ship.getPod()})
            body->addForceAtPoint(Vector3(random.between(-9, 9), 5, random.between(-900, 900)),
                                  Vector3(random.between(-9, 9), random.between(-9, 9), 7));
        world.runPhysics(STEP);
        for (const RigidBody *body : {&ship.getBody(), &ship.getPod()}) {
            ASSERT_EQ(body->getPosition().z, 0) << n;
            ASSERT_EQ(body->getVelocity().z, 0) << n;
            ASSERT_EQ(body->getRotation().x, 0) << n;
            ASSERT_EQ(body->getRotation().y, 0) << n;
            ASSERT_EQ(body->getOrientation().i, 0) << n;
            ASSERT_EQ(body->getOrientation().j, 0) << n;
            ASSERT_FALSE(body->hasFaulted()) << n;
        }
    }
    EXPECT_NE(ship.getBody().getRotation().z, 0);
}

TEST(ThrustShip, HangsWhereItIsUntilTheEngineBurns) {
    Space space;
    run(space.world, 300);
    EXPECT_EQ(space.ship.getBody().getPosition(), Vector3(3, 20, 0));
    EXPECT_EQ(space.ship.getPod().getPosition(), Vector3(3, 20 - L, 0));
    space.letGo();
    run(space.world, 120);
    EXPECT_NEAR(space.ship.getBody().getPosition().y, 20 - G / 2, 0.01);
    EXPECT_EQ(space.ship.getPod().getPosition(), Vector3(3, 20 - L, 0)) << "not hooked";
}

TEST(ThrustShip, TheEnginePushesAlongTheNose) {
    for (const real heading : {0.0, 0.7, -1.2}) {
        Space space;
        space.ship.setHeading(heading);
        run(space.world, 400);
        EXPECT_NEAR(space.ship.getHeading(), heading, 1e-3);
        space.ship.setThrottle(0.5);
        run(space.world, 240);
        const Vector3 push = Vector3(std::sin(heading), std::cos(heading), 0) * (Ship::MAX_PUSH / 2 / M);
        const Vector3 velocity = space.ship.getBody().getVelocity();
        EXPECT_NEAR(velocity.x, 2 * push.x, 0.02);
        EXPECT_NEAR(velocity.y, 2 * (push.y - G), 0.02);
    }
}

TEST(ThrustShip, TurnsTheShorterWayWithinTheTorqueThatTheJetsHave) {
    Space space;
    space.ship.setHeading(-3);
    run(space.world, 400);
    space.ship.setHeading(3);
    real backwards = 0, last = space.ship.getBody().getRotation().z;
    for (int n = 0; n < 240; ++n) {
        run(space.world, 1);
        const real now = space.ship.getBody().getRotation().z;
        const real inertia = 1 / space.ship.getBody().getInverseInertiaTensor().data[8];
        EXPECT_LE(std::fabs(now - last) * inertia, thrust::AttitudeJets::MAX_TORQUE * STEP * 1.6);
        backwards = std::max(backwards, -now);
        last = now;
    }
    EXPECT_NEAR(space.ship.getHeading(), 3, 0.01);
    EXPECT_LT(backwards, 0.1) << "through straight down, 16° to the left, and not 344° to the right";
}

// ---- The pod on its rod

/// The ship held: a pendulum of the rod's length, T = 2π√(L/g)·(1 + θ²/16).
TEST(ThrustShip, BelowAShipThatIsHeldThePodIsAPendulum) {
    Space space;
    const real angle = 0.2;
    space.hookAt(angle);
    EXPECT_NEAR(space.period(), 2 * REAL_PI * std::sqrt((L + SAG) / G) * (1 + angle * angle / 16), 0.02);
}

/// The ship on a level rail: both swing about what they have in common, as if the rod were shorter by the
/// ship's share of the mass, T = 2π√(L/g·M/(M + m)).
TEST(ThrustShip, BelowAShipOnARailBothSwing) {
    Space space;
    space.hookAt(0.1);
    space.ship.getBody().setLockedMotion(false, true, true);
    EXPECT_NEAR(space.period(), 2 * REAL_PI * std::sqrt((L + SAG) / G * M / (M + POD)) * (1 + 0.01 / 16),
                0.02);
}

TEST(ThrustShip, OnARailSwingingKeepsEnergyAndLevelMomentum) {
    Space space;
    space.hookAt(1);
    space.ship.getBody().setLockedMotion(false, true, true);
    run(space.world, 120);  // until the rod has stretched
    const real energy = space.energy(), swing = POD * G * L * (1 - std::cos(1.0));
    for (int n = 0; n < 120 * 30; ++n) {
        run(space.world, 1);
        ASSERT_NEAR(space.momentum().x, 0, 1e-9);
        ASSERT_NEAR(space.energy(), energy, 0.02 * swing);
    }
}

/// Falling freely: the centre of mass on a parabola, and the rod turning about it at an even rate.
TEST(ThrustShip, FallingFreelyBothTurnAboutTheirCentreOfMass) {
    Space space;
    space.hookAt(0.3);
    space.letGo();
    const real rate = 0.8;
    RigidBody &body = space.ship.getBody(), &pod = space.ship.getPod();
    const Vector3 rod = pod.getPosition() - body.getPosition(), across(-rod.y, rod.x, 0);
    pod.setVelocity(across * (rate * M / (M + POD)));
    body.setVelocity(across * (-rate * POD / (M + POD)));
    const Vector3 centre = (body.getPosition() * M + pod.getPosition() * POD) * (1 / (M + POD));
    const real reduced = M * POD / (M + POD);
    for (int n = 1; n <= 600; ++n) {
        run(space.world, 1);
        const real time = n * STEP;
        const Vector3 now = (body.getPosition() * M + pod.getPosition() * POD) * (1 / (M + POD));
        // The first evaluation of a force counts half a step.
        ASSERT_NEAR(now.x, centre.x, 1e-9);
        ASSERT_NEAR(now.y, centre.y - G * time * time / 2, 1e-6 + G * STEP * time);
        const Vector3 apart = pod.getPosition() - body.getPosition();
        const Vector3 relative = pod.getVelocity() - body.getVelocity();
        ASSERT_NEAR((apart % relative).z * reduced, L * L * rate * reduced, 0.005 * L * L * rate * reduced);
        ASSERT_NEAR(demo::wrapAngle(space.ship.getSwing() - 0.3 - rate * time), 0, 0.02 * rate * time + 0.01);
    }
}

TEST(ThrustShip, TheRodKeepsItsLength) {
    Space space;
    space.hookAt(1.5);
    for (int n = 0; n < 1200; ++n) {
        run(space.world, 1);
        ASSERT_NEAR(space.rodLength(), L, 0.02);
    }
}

TEST(ThrustShip, AWinchBringsTheRodToItsLength) {
    Space space;
    space.ship.getBody().setPosition(space.ship.getBody().getPosition());
    space.ship.launch({3, 20.6, 0}, {3, 20 - L, 0}, G);
    space.ship.hook();
    EXPECT_NEAR(space.ship.getRodForce().magnitude(), 0, 1e-9) << "it is taken where it is";
    for (int n = 0; n < 600; ++n) {
        space.ship.advanceWinch(STEP);
        run(space.world, 1);
    }
    EXPECT_NEAR(space.rodLength(), L, 0.01);
}

TEST(ThrustShip, BreaksIntoPartsThatFlyApart) {
    Space space;
    space.hookAt(0);
    space.ship.breakUp();
    EXPECT_TRUE(space.ship.isBroken());
    EXPECT_FALSE(space.ship.isHooked());
    run(space.world, 120);
    EXPECT_EQ(space.ship.getBody().getPosition(), Vector3(3, 20, 0));
    const Vector3 port = space.ship.getWreck(0).getPosition(),
                  starboard = space.ship.getWreck(Ship::WRECK_PARTS - 1).getPosition();
    EXPECT_GT((port - starboard).magnitude(), 3);
    space.ship.setThrottle(1);
    EXPECT_EQ(space.ship.getThrottle(), 0) << "there is no engine any more";
}

}  // namespace
