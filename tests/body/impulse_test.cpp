// Impulses, and the velocity at a point of a body.
#include <cyclone/world.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

/// A body that tumbles, with an oblique inertia tensor.
RigidBody tumbling(std::uint64_t seed) {
    Random random(seed);
    RigidBody body;
    body.setMass(random.between(0.5, 5));
    body.setInertiaTensor(Matrix3(2, 0.1, -0.2, 0.1, 2.5, 0.3, -0.2, 0.3, 3));
    body.setPosition(random.vector(10));
    body.setOrientation(random.orientation());
    body.setVelocity(random.vector(5));
    body.setRotation(random.vector(3));
    return body;
}

/// About the world's origin.
Vector3 wholeAngularMomentum(const RigidBody &body) {
    return body.getAngularMomentum() + body.getPosition() % (body.getVelocity() * body.getMass());
}

TEST(VelocityAtPoint, IsHowAMarkOnTheBodyMoves) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        RigidBody body = tumbling(seed);
        const Vector3 mark = Random(seed + 100).vector(2);
        const Vector3 told = body.getVelocityAtPoint(body.getPointInWorldSpace(mark));
        constexpr real SHORT = 1e-6;
        RigidBody later = body;
        later.integrate(SHORT);
        const Vector3 moved = later.getPointInWorldSpace(mark) - body.getPointInWorldSpace(mark);
        EXPECT_TRUE(isNear(told, moved * (1 / SHORT), 1e-4));
        EXPECT_EQ(body.getVelocityAtPoint(body.getPosition()), body.getVelocity());
    }
}

TEST(Impulse, ChangesMomentumAtOnce) {
    RigidBody body = tumbling(1);
    const Vector3 rotation = body.getRotation(), momentum = body.getVelocity() * body.getMass();
    body.addImpulse(Vector3(1, -2, 3));
    EXPECT_TRUE(isNear(body.getVelocity() * body.getMass(), momentum + Vector3(1, -2, 3), 1e-13));
    EXPECT_EQ(body.getRotation(), rotation);
}

TEST(Impulse, AtAPointChangesBothMomenta) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        RigidBody body = tumbling(seed);
        Random random(seed + 7);
        const Vector3 impulse = random.vector(4), point = random.vector(8);
        const Vector3 momentum = body.getVelocity() * body.getMass(), angular = wholeAngularMomentum(body);
        body.addImpulseAtPoint(impulse, point);
        EXPECT_TRUE(isNear(body.getVelocity() * body.getMass(), momentum + impulse, 1e-12));
        EXPECT_TRUE(isNear(wholeAngularMomentum(body), angular + point % impulse, 1e-11));
    }
}

/// Two bodies that bounce off each other at a point, without friction and with no loss: energy and both
/// momenta are kept, and the points part as fast as they met.
TEST(Impulse, MakesACollisionThatKeepsEnergy) {
    RigidBody a = tumbling(3), b = tumbling(4);
    const Vector3 point(0.3, -0.2, 0.5), normal = Vector3(1, 2, -2) * (1.0 / 3);
    a.setPosition(point + Vector3(0.5, 1, -0.7));
    b.setPosition(point - Vector3(0.8, 0.6, -1));
    const auto energy = [](const RigidBody &body) {
        return (body.getMass() * body.getVelocity().squareMagnitude() +
                body.getRotation() * body.getAngularMomentum()) /
               2;
    };
    const auto closing = [&] { return (a.getVelocityAtPoint(point) - b.getVelocityAtPoint(point)) * normal; };
    const auto softness = [&](const RigidBody &body) {  // velocity along the normal for 1 N·s along it
        const Vector3 arm = point - body.getPosition();
        return body.getInverseMass() +
               normal * ((body.getInverseInertiaTensorWorld() * (arm % normal)) % arm);
    };
    const real before = energy(a) + energy(b), speed = closing();
    const Vector3 angular = wholeAngularMomentum(a) + wholeAngularMomentum(b);
    const Vector3 impulse = normal * (-2 * speed / (softness(a) + softness(b)));
    a.addImpulseAtPoint(impulse, point);
    b.addImpulseAtPoint(-impulse, point);
    EXPECT_NEAR(closing(), -speed, 1e-12);
    EXPECT_NEAR(energy(a) + energy(b), before, 1e-11);
    EXPECT_TRUE(isNear(wholeAngularMomentum(a) + wholeAngularMomentum(b), angular, 1e-11));
}

TEST(Impulse, LeavesImmovableBodiesAndLockedAxesAlone) {
    RigidBody wall = tumbling(5);
    wall.setInverseMass(0);
    const Vector3 velocity = wall.getVelocity(), rotation = wall.getRotation();
    wall.addImpulse(Vector3(1e6, 0, 0));
    wall.addImpulseAtPoint(Vector3(0, 1e6, 0), Vector3(3, 2, 1));
    EXPECT_EQ(wall.getVelocity(), velocity);
    EXPECT_EQ(wall.getRotation(), rotation);

    RigidBody door;
    door.setInverseInertiaTensor(diagonal(0, 0.5, 0));
    door.addImpulseAtPoint(Vector3(2, 3, 4), Vector3(1, 0, 0));
    EXPECT_EQ(door.getVelocity(), Vector3(2, 3, 4));
    EXPECT_EQ(door.getRotation(), Vector3(0, -2, 0)) << "(1, 0, 0) × (2, 3, 4) = (0, −4, 3)";
}

TEST(Impulse, WakesASleeperUnlessItIsZero) {
    RigidBody body;
    body.setAwake(false);
    body.addImpulse(Vector3());
    body.addImpulseAtPoint(Vector3(), Vector3(1, 1, 1));
    EXPECT_FALSE(body.getAwake());
    body.addImpulseAtPoint(Vector3(0, 1, 0), Vector3(1, 0, 0));
    EXPECT_TRUE(body.getAwake());
    EXPECT_EQ(body.getRotation(), Vector3(0, 0, 1));
}

TEST(Impulse, ThatIsNotFiniteOrLeadsToNoFiniteMotionIsRefused) {
    RigidBody body = tumbling(6);
    const std::uint64_t hash = [&] {
        RigidBody *const its = &body;
        return hashStates(&its, 1);
    }();
    EXPECT_THROW(body.addImpulse(Vector3(0, QUIET_NAN, 0)), std::invalid_argument);
    EXPECT_THROW(body.addImpulseAtPoint(Vector3(PLUS_INFINITY, 0, 0), Vector3()), std::invalid_argument);
    EXPECT_THROW(body.addImpulseAtPoint(Vector3(1, 0, 0), Vector3(0, QUIET_NAN, 0)), std::invalid_argument);
    EXPECT_THROW(body.addImpulseAtPoint(Vector3(1e308, 0, 0), Vector3(0, 1e308, 0)), std::invalid_argument);
    RigidBody wall;
    wall.setInverseMass(0);
    EXPECT_THROW(wall.addImpulse(Vector3(0, QUIET_NAN, 0)), std::invalid_argument);
    EXPECT_THROW(wall.addImpulseAtPoint(Vector3(0, QUIET_NAN, 0), Vector3()), std::invalid_argument);
    RigidBody light;
    light.setMass(1e-5);
    try {
        light.addImpulse(Vector3(1e306, 0, 0));
        FAIL();
    } catch (const std::invalid_argument &error) {
        EXPECT_EQ(std::string(error.what()).find("RigidBody::addImpulse:"), 0U) << error.what();
    }
    EXPECT_EQ(light.getVelocity(), Vector3());
    RigidBody *const its = &body;
    EXPECT_EQ(hashStates(&its, 1), hash);
}

/// Velocity, rotation or angular momentum alone would overflow.
TEST(Impulse, AtAPointThatOverflowsAnyMotionIsRefused) {
    RigidBody light, slender, heavy;
    light.setMass(1e-5);
    EXPECT_THROW(light.addImpulseAtPoint(Vector3(1e306, 0, 0), Vector3()), std::invalid_argument);
    EXPECT_EQ(light.getVelocity(), Vector3());

    slender.setInertiaTensor(diagonal(1e-5, 1e-5, 1e-5));
    EXPECT_THROW(slender.addImpulseAtPoint(Vector3(1e306, 0, 0), Vector3(0, 1, 0)), std::invalid_argument);
    EXPECT_EQ(slender.getVelocity(), Vector3());
    EXPECT_EQ(slender.getRotation(), Vector3());

    heavy.setInertiaTensor(diagonal(1e10, 1e10, 1e10));
    heavy.setRotation(0, 0, -1e298);
    EXPECT_THROW(heavy.addImpulseAtPoint(Vector3(1e308, 0, 0), Vector3(0, 1, 0)), std::invalid_argument);
    EXPECT_EQ(heavy.getVelocity(), Vector3());
    EXPECT_EQ(heavy.getRotation(), Vector3(0, 0, -1e298));
}

}  // namespace
