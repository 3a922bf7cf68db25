#include <cyclone/propulsion.h>
#include <cyclone/world.h>
#include <gtest/gtest.h>

#include <cmath>

#include "frames.h"
#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

TEST(Thruster, AcceleratesABodyEvenly) {
    Thruster engine(Vector3(2, 0, 0), Vector3(), 30);  // the direction's length does not matter
    World world;
    RigidBody *body = world.createBody();
    body->setMass(3);
    world.getForceRegistry().add(body, &engine);
    run(world, 120);
    EXPECT_EQ(body->getPosition(), Vector3());  // closed at first
    engine.setThrottle(0.5);
    EXPECT_EQ(engine.getThrottle(), 0.5);
    // A throttle that opens between two steps is a force that changed, which the step takes for a smooth
    // change from zero: from there on it is exact.
    run(world, 1);
    const Vector3 position = body->getPosition(), velocity = body->getVelocity();
    run(world, 240);
    EXPECT_TRUE(isNear(body->getVelocity() - velocity, Vector3(10, 0, 0), 1e-11));
    EXPECT_TRUE(isNear(body->getPosition() - position, velocity * 2 + Vector3(10, 0, 0), 1e-11));
}

TEST(Thruster, OffTheCentreSpinsTheBodyUpExactly) {
    // A wheel: constant torque about its axle, and a force that turns with it, so that its mean is nil over
    // whole turns.
    Thruster jet(Vector3(0, 1, 0), Vector3(2, 0, 0), 0.5);
    jet.setThrottle(1);
    World world;
    RigidBody *wheel = world.createBody();
    wheel->setInertiaTensor(diagonal(1, 1, 4));
    world.getForceRegistry().add(wheel, &jet);
    run(world, 1200);
    // rotation = T·t/I, angle = T·t²/2I, with T = 1 N·m and t = 10 s.
    EXPECT_NEAR(wheel->getRotation().z, 2.5, 1e-12);
    const Quaternion wanted = Quaternion::fromAxisAngle(Vector3::Z, 12.5);
    EXPECT_TRUE(turnsLike(wheel->getOrientation(), wanted, 1e-11));
}

TEST(Thruster, PushesAlongTheBodysOwnDirection) {
    Random random(40);
    for (int n = 0; n < 50; ++n) {
        RigidBody body;
        body.setOrientation(random.orientation());
        body.setVelocity(random.vector(100));
        const Vector3 direction = random.vector();
        Thruster engine(direction, random.vector(), 7);
        engine.setThrottle(1);
        const Vector3 force = engine.getForce(body);
        EXPECT_NEAR(force.magnitude(), 7, 1e-13);
        EXPECT_TRUE(isNear(body.getDirectionInLocalSpace(force).unit(), direction.unit(), 1e-14));
    }
}

TEST(Thruster, ThrottleStopsAtTheEnds) {
    Thruster engine(Vector3::X, Vector3(), 10);
    EXPECT_EQ(engine.getThrottle(), 0);
    EXPECT_EQ(engine.getForce(RigidBody()), Vector3());
    for (real value : {1.0, 1.5, 1e300}) {
        engine.setThrottle(value);
        EXPECT_EQ(engine.getThrottle(), 1);
        EXPECT_EQ(engine.getForce(RigidBody()), Vector3(10, 0, 0));
    }
    for (real value : {0.0, -0.5, -1e300}) {
        engine.setThrottle(value);
        EXPECT_EQ(engine.getThrottle(), 0);
    }
}

TEST(Thruster, CanBeTurned) {
    Thruster outboard(Vector3::X, Vector3(-2, 0, 0), 10);
    outboard.setThrottle(1);
    outboard.setDirection(Vector3(0, 0, 5));
    EXPECT_EQ(outboard.getDirection(), Vector3::Z);
    EXPECT_TRUE(isNear(outboard.getForce(RigidBody()), Vector3(0, 0, 10), 1e-15));
    EXPECT_TRUE(outboard.actsOnItsBodyOnly());
}

TEST(Thruster, AtAPointGivesThrustAndTorque) {
    Thruster outboard(Vector3(3, 0, 4), Vector3(-2, -1, 0), 10);
    outboard.setThrottle(1);
    World world;
    RigidBody *boat = world.createBody();
    boat->setPosition(7, 8, 9);
    world.getForceRegistry().add(boat, &outboard);
    run(world, 1);
    EXPECT_TRUE(isNear(boat->getVelocity(), Vector3(6, 0, 8) * STEP, 1e-14));
    EXPECT_TRUE(isNear(boat->getAngularMomentum(), Vector3(-8, 16, 6) * STEP, 1e-14));
}

// ---- Propeller

TEST(Propeller, LosesItsBiteInProportionToTheSpeed) {
    Propeller propeller(Vector3::X, Vector3(), 20, 40, nullptr);
    propeller.setThrottle(1);
    const real speeds[] = {-30, 0, 10, 40, 60}, thrusts[] = {20, 20, 15, 0, -10};
    for (int n = 0; n < 5; ++n) {
        RigidBody body;
        body.setVelocity(speeds[n], 7, -3);  // only the speed along the push counts
        EXPECT_TRUE(isNear(propeller.getForce(body), Vector3(thrusts[n], 0, 0), 1e-13));
    }
    propeller.setThrottle(0.5);
    EXPECT_TRUE(isNear(propeller.getForce(RigidBody()), Vector3(10, 0, 0), 1e-14));
}

TEST(Propeller, FeelsTheWindAndTurnsWithTheBody) {
    Vector3 wind(0, 20, 0);  // from above
    Propeller propeller(Vector3::X, Vector3(), 20, 40, &wind);
    propeller.setThrottle(1);
    RigidBody body;
    body.setOrientation(Quaternion::fromAxisAngle(Vector3::Z, REAL_PI / 2));  // nose up
    EXPECT_TRUE(isNear(propeller.getForce(body), Vector3(0, 10, 0), 1e-13));
    body.setVelocity(0, -20, 0);
    EXPECT_TRUE(isNear(propeller.getForce(body), Vector3(0, 20, 0), 1e-13));
}

TEST(Propeller, ReachesTheSpeedWhereDragEqualsThrust) {
    // F(1 − v/p) = k·v: v = F/(k + F/p), approached exponentially at the rate (k + F/p)/m.
    Propeller propeller(Vector3::X, Vector3(), 20, 40, nullptr);
    propeller.setThrottle(1);
    Drag drag(0.5, 0);
    World world;
    RigidBody *body = world.createBody();
    body->setMass(2);
    world.getForceRegistry().add(body, &propeller);
    world.getForceRegistry().add(body, &drag);
    run(world, 240);
    const real rate = (0.5 + 20.0 / 40) / 2, terminal = 20 / (0.5 + 20.0 / 40);
    EXPECT_NEAR(body->getVelocity().x, terminal * (1 - std::exp(-rate * 2)), 1e-3);
    run(world, 6000);
    EXPECT_NEAR(body->getVelocity().x, terminal, 1e-9);
}

}  // namespace
