// Locked directions of motion: nothing moves a body along them, and along the others it moves as ever.
#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "frames.h"
#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

constexpr real PLANE = 0.1;  // not exact in binary: any arithmetic with it would show

/// Locked to the plane z = 0.1, and moving in it.
RigidBody planar() {
    RigidBody body;
    body.setMass(2);
    body.setInertiaTensor(diagonal(1, 2, 3));
    body.setPosition(1, 2, PLANE);
    body.setLockedMotion(false, false, true);
    body.setVelocity(1, 2, 0);
    return body;
}

/// A force in every direction, as a generator's.
class Push : public ForceGenerator {
public:
    explicit Push(const Vector3 &f) : force(f) {}
    void updateForce(RigidBody *body, real) override { body->addForce(force); }

private:
    Vector3 force;
};

void expectInPlane(const RigidBody &body, const char *after) {
    EXPECT_EQ(body.getPosition().z, PLANE) << after;
    EXPECT_EQ(body.getVelocity().z, 0) << after;
    EXPECT_EQ(body.getState().findError(), nullptr) << after;
}

TEST(LockedMotion, NothingMovesABodyAlongIt) {
    struct Case {
        const char *name;
        std::function<void(RigidBody &)> act;
    };
    const Vector3 skew(3, -4, 5);
    for (const Case &one : {
             Case{"setVelocity", [&](RigidBody &b) { b.setVelocity(skew); }},
             Case{"addVelocity", [&](RigidBody &b) { b.addVelocity(skew); }},
             Case{"setPosition", [&](RigidBody &b) { b.setPosition(skew); }},
             Case{"setAcceleration", [&](RigidBody &b) { b.setAcceleration(skew); }},
             Case{"addForce", [&](RigidBody &b) { b.addForce(skew); }},
             Case{"addForceAtPoint", [&](RigidBody &b) { b.addForceAtPoint(skew, Vector3(9, 8, 7)); }},
             Case{"addForceAtBodyPoint",
                  [&](RigidBody &b) { b.addForceAtBodyPoint(skew, Vector3(1, 1, 1)); }},
             Case{"addWrench",
                  [&](RigidBody &b) {
                      b.addWrench({skew, skew});
                  }},
             Case{"addImpulse", [&](RigidBody &b) { b.addImpulse(skew); }},
             Case{"addImpulseAtPoint", [&](RigidBody &b) { b.addImpulseAtPoint(skew, Vector3(9, 8, 7)); }},
             Case{"setRotation", [&](RigidBody &b) { b.setRotation(skew); }},
             Case{"setMass", [&](RigidBody &b) { b.setMass(0.1); }},
             Case{"setInverseMass", [&](RigidBody &b) { b.setInverseMass(0); }},
             Case{"setDamping", [&](RigidBody &b) { b.setDamping(0.5, 0.5); }},
         }) {
        RigidBody body = planar();
        one.act(body);
        expectInPlane(body, one.name);
        for (int n = 0; n < 3; ++n) {
            one.act(body);
            ASSERT_TRUE(body.integrate(STEP));
            expectInPlane(body, one.name);
        }
    }
}

/// Generators of every strength, stiff ones and springs among them.
TEST(LockedMotion, GeneratorsDoNotMoveABodyAlongIt) {
    const Vector3 windspeed(1, 2, 300);
    for (const real c : {0.1, 50.0, 1e6}) {
        World world;
        RigidBody *const body = world.createBody();
        *body = planar();
        body->setAcceleration(0, -9.81, -9.81);
        world.createForce<Push>(body, Vector3(1, 2, 3));
        auto &plate = world.createForce<Aero>(body, Matrix3(-c, 0, 0.3 * c, 0, -c, 0, 0, 0, -c),
                                              Vector3(0.1, 0.2, 0.3), &windspeed);
        plate.setRotationalFlow(true);
        world.createForce<AnchoredSpring>(body, Vector3(0, 0, 40), Vector3(0, 0.1, 0), 20, 1);
        for (int n = 0; n < 600; ++n) {
            world.runPhysics(STEP);
            ASSERT_EQ(body->getPosition().z, PLANE) << c;
            ASSERT_EQ(body->getVelocity().z, 0) << c;
            ASSERT_FALSE(body->hasFaulted()) << c;
        }
    }
}

/// A stiff resistance that couples directions: with z locked it is as if the body had infinite mass along z.
TEST(LockedMotion, StiffResistanceReachesTheTerminalVelocityOfTheFreeDirections) {
    World world;
    RigidBody *const body = world.createBody();
    *body = planar();
    body->setVelocity(0, 0, 0);
    // Fx = −c·vx + c·vz/2 and so on: with vz = 0 the terminal velocity is force over c.
    const real c = 1e5;
    world.createForce<Aero>(body, Matrix3(-c, 0, c / 2, 0, -c, c / 3, c / 2, c / 3, -c), Vector3(), nullptr);
    world.createForce<Push>(body, Vector3(300, 600, 900));
    for (int n = 0; n < 100; ++n) world.runPhysics(STEP);
    EXPECT_NEAR(body->getVelocity().x, 300 / c, 1e-9);
    EXPECT_NEAR(body->getVelocity().y, 600 / c, 1e-9);
    EXPECT_EQ(body->getVelocity().z, 0);
}

TEST(LockedMotion, AlongFreeDirectionsTheBodyMovesToTheSameBits) {
    RigidBody locked = planar(), free = planar();
    free.setLockedMotion(false, false, false);
    Random random(3);
    for (int n = 0; n < 300; ++n) {
        const Vector3 force = random.vector(5), torque = random.vector(2);
        locked.addWrench({force, torque});
        free.addWrench({force, torque});
        locked.integrate(STEP);
        free.integrate(STEP);
    }
    EXPECT_EQ(locked.getPosition().x, free.getPosition().x);
    EXPECT_EQ(locked.getPosition().y, free.getPosition().y);
    EXPECT_EQ(locked.getOrientation(), free.getOrientation());
    EXPECT_NE(free.getPosition().z, PLANE);
}

TEST(LockedMotion, ManyBodiesStepToTheSameBitsAsOne) {
    std::vector<RigidBody> bodies(40, planar());
    std::vector<RigidBody *> all;
    for (std::size_t n = 0; n < bodies.size(); ++n) {
        if (n % 3 == 0) bodies[n].setLockedMotion(n % 2 == 0, true, false);
        bodies[n].setRotation(0.1 * static_cast<real>(n), 1, 0);
        bodies[n].setAcceleration(1, 2, 3);
        all.push_back(&bodies[n]);
    }
    std::vector<RigidBody> alone = bodies;
    RigidBody::integrate(all.data(), all.size(), STEP);
    for (std::size_t n = 0; n < bodies.size(); ++n) {
        alone[n].integrate(STEP);
        EXPECT_EQ(alone[n].getPosition(), bodies[n].getPosition()) << n;
        EXPECT_EQ(alone[n].getOrientation(), bodies[n].getOrientation()) << n;
    }
}

TEST(LockedMotion, TellsWhatIsLockedAndCanBeUndone) {
    RigidBody body = planar();
    EXPECT_FALSE(body.isMotionLocked(0));
    EXPECT_FALSE(body.isMotionLocked(1));
    EXPECT_TRUE(body.isMotionLocked(2));
    body.setLockedMotion(true, false, false);
    EXPECT_TRUE(body.isMotionLocked(0));
    EXPECT_EQ(body.getVelocity(), Vector3(0, 2, 0)) << "what is locked stops";
    body.setLockedMotion(false, false, false);
    body.setVelocity(1, 2, 3);
    EXPECT_EQ(body.getVelocity(), Vector3(1, 2, 3));
}

TEST(LockedMotion, IsSavedRestoredHashedAndCopied) {
    World world;
    RigidBody *const body = world.createBody();
    *body = planar();
    const std::uint64_t hash = world.hash();
    Snapshot snapshot;
    world.saveState(snapshot);
    body->setLockedMotion(true, false, true);
    EXPECT_NE(world.hash(), hash);
    world.restoreState(snapshot);
    EXPECT_EQ(world.hash(), hash);
    EXPECT_FALSE(body->isMotionLocked(0));
    EXPECT_TRUE(body->isMotionLocked(2));
    const Snapshot bytes(snapshot.begin(), snapshot.end());
    body->setLockedMotion(true, true, true);
    world.restoreState(bytes);
    EXPECT_EQ(world.hash(), hash);
    EXPECT_TRUE(RigidBody(*body).isMotionLocked(2));
}

TEST(LockedMotion, AStateThatMovesAlongItIsRefused) {
    const RigidBody::State good = planar().getState();
    EXPECT_EQ(good.findError(), nullptr);
    const auto errorWith = [&](const std::function<void(RigidBody::State &)> &change) {
        RigidBody::State state = good;
        change(state);
        return state.findError();
    };
    EXPECT_NE(errorWith([](RigidBody::State &s) { s.velocity.z = 1; }), nullptr);
    EXPECT_NE(errorWith([](RigidBody::State &s) { s.acceleration.z = 1; }), nullptr);
    EXPECT_NE(errorWith([](RigidBody::State &s) { s.memory.acceleration.z = 1; }), nullptr);
    EXPECT_NE(errorWith([](RigidBody::State &s) { s.lockedMotion = 8; }), nullptr);
    EXPECT_EQ(errorWith([](RigidBody::State &s) { s.lockedMotion = 0, s.velocity.z = 1; }), nullptr);
}

TEST(LockedMotion, APoisonedForceAlongItDoesNoHarm) {
    const auto positionAfter = [](real resistance, real push) {
        World world;
        RigidBody *const body = world.createBody();
        *body = planar();
        world.createForce<Aero>(body, diagonal(-resistance, -3 * resistance, 0), Vector3(), nullptr);
        world.createForce<Push>(body, Vector3(1, 0, push));
        body->addForce(Vector3(0, 1, push));
        world.runPhysics(STEP);
        expectInPlane(*body, "a poisoned force");
        EXPECT_FALSE(body->hasFaulted());
        return body->getPosition();
    };
    for (const real resistance : {0.0, 150.0, 1e6})
        EXPECT_EQ(positionAfter(resistance, std::nan("")), positionAfter(resistance, 0)) << resistance;
}

TEST(LockedMotion, AForceAlongItDoesNotWakeABody) {
    RigidBody body = planar();
    body.setAwake(false);
    body.addForce(Vector3(0, 0, 5));
    body.addVelocity(Vector3(0, 0, 5));
    body.addImpulse(Vector3(0, 0, 5));
    body.setAcceleration(0, 0, -9.81);
    EXPECT_FALSE(body.getAwake());
    body.addForce(Vector3(0, 1, 5));
    EXPECT_TRUE(body.getAwake());
}

/// Two bodies of a spring, one of which can only move along x: momentum along x is kept.
TEST(LockedMotion, KeepsMomentumAlongFreeDirections) {
    World world;
    RigidBody *const one = world.createBody(), *const other = world.createBody();
    one->setLockedMotion(false, true, true);
    other->setPosition(3, 4, 0);
    world.createSpring(one, Vector3(), other, Vector3(), 10, 2);
    for (int n = 0; n < 1000; ++n) world.runPhysics(STEP);
    EXPECT_NEAR(one->getVelocity().x + other->getVelocity().x, 0, 1e-12);
    EXPECT_EQ(one->getPosition().y, 0);
    EXPECT_GT(std::fabs(one->getPosition().x), 0.01);
}

TEST(LockedMotion, AForceAlongItLeavesASleeperAsItIs) {
    RigidBody body = planar();
    body.setAwake(false);
    const RigidBody::State asleep = body.getState();
    body.addForce(Vector3(0, 0, 5));
    EXPECT_FALSE(body.getAwake());
    EXPECT_EQ(body.getState().findError(), nullptr);
    body.setLockedMotion(false, false, false);
    EXPECT_EQ(body.getState().added.force, asleep.added.force);
}

}  // namespace
