// Springs that are damped, their tension, and their settings. The undamped ones are in force_test.cpp.
#include <cyclone/world.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "frames.h"
#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

TEST(DampedSpring, SwingsAsTheTextbookSays) {
    const real mass = 2, k = 50, c = 3, stretch = 0.1;
    AnchoredSpring spring(Vector3(), Vector3(), k, 1.5);
    spring.setDamping(c);
    World world;
    RigidBody *const body = world.createBody();
    body->setMass(mass);
    body->setPosition(0, 1.5 + stretch, 0);
    world.getForceRegistry().add(body, &spring);
    const real decay = c / (2 * mass), omega = std::sqrt(k / mass - decay * decay);
    for (int n = 1; n <= 360; ++n) {
        run(world, 1);
        const real t = n * STEP;
        const real wanted =
            stretch * std::exp(-decay * t) * (std::cos(omega * t) + decay / omega * std::sin(omega * t));
        ASSERT_NEAR(body->getPosition().y - 1.5, wanted, 2e-4) << n;
    }
}

/// Critically damped, two bodies come to rest at the rest length without swinging through.
TEST(DampedSpring, BringsTwoBodiesToRestAndKeepsTheirMomentum) {
    World world;
    RigidBody *const a = world.createBody(), *const b = world.createBody();
    a->setMass(2);
    b->setMass(3);
    b->setPosition(2, 0, 0);
    a->setVelocity(0, 0.5, 0);
    b->setVelocity(0, 0.5, 0);
    const real reduced = 2 * 3 / (2 + 3.0), k = 40;
    Spring &spring = world.createSpring(a, Vector3(), b, Vector3(), k, 1.5);
    spring.setDamping(2 * std::sqrt(k * reduced));
    for (int n = 0; n < 600; ++n) {
        run(world, 1);
        ASSERT_GT(spring.getLength(*a), 1.5);
        ASSERT_EQ(spring.getLength(*a), spring.getLength(*b));
        ASSERT_TRUE(isNear(a->getVelocity() * 2 + b->getVelocity() * 3, Vector3(0, 2.5, 0), 1e-12));
    }
    EXPECT_NEAR(spring.getLength(*a), 1.5, 1e-6);
    EXPECT_TRUE(isNear(a->getVelocity(), Vector3(0, 0.5, 0), 1e-6));
}

/// However strongly it is damped, a pair never moves faster against each other than before, and ends as one,
/// with its common velocity.
TEST(DampedSpring, BearsAnyDamping) {
    for (real c = 1e-2; c < 1e10; c *= 10) {
        World world;
        RigidBody *const a = world.createBody(), *const b = world.createBody();
        a->setMass(2);
        b->setPosition(3, 0, 0);
        b->setVelocity(-3, 0, 0);
        b->setInertiaTensor(diagonal(0.5, 0.6, 0.7));
        Spring &strut = world.createSpring(a, Vector3(), b, Vector3(), 0, 0);
        strut.setDamping(c);
        real last = 3;
        for (int n = 0; n < 240; ++n) {
            run(world, 1);
            const real closing = a->getVelocity().x - b->getVelocity().x;
            ASSERT_LE(closing, last + 1e-12) << c << " N·s/m, frame " << n;
            ASSERT_GE(closing, -1e-12) << c << " N·s/m, frame " << n;
            last = closing;
        }
        ASSERT_NEAR(2 * a->getVelocity().x + b->getVelocity().x, -3, 1e-9);
        const real exact = 3 * std::exp(-c * 1.5 * 240 * STEP);  // 1/m = 1/2 + 1
        ASSERT_NEAR(last, exact, 2e-3) << c;
    }
}

/// Two dampers on one body, off the centres: each is taken into account alone, so some energy may come for a
/// moment, but in the end it goes.
TEST(DampedSpring, OfAnyStrengthOffTheCentresTakesEnergyOut) {
    for (real c = 1e-1; c < 1e8; c *= 10) {
        World world;
        RigidBody *const a = world.createBody(), *const b = world.createBody();
        b->setMass(0.3);
        b->setInertiaTensor(diagonal(0.02, 0.05, 0.04));
        b->setPosition(0, 2, 0);
        b->setRotation(1, 2, -3);
        a->setVelocity(0.5, -1, 0.2);
        world.createSpring(a, Vector3(0.4, 0, 0), b, Vector3(0, -0.3, 0.2), 0, 0).setDamping(c);
        world.createForce<AnchoredSpring>(b, Vector3(0.1, 0, 0), Vector3(0, 5, 0), 0, 0).setDamping(c);
        const auto energy = [&] {
            real sum = 0;
            for (const RigidBody *body : {a, b})
                sum += (body->getMass() * body->getVelocity().squareMagnitude() +
                        body->getRotation() * body->getAngularMomentum()) /
                       2;
            return sum;
        };
        const real before = energy();
        for (int n = 0; n < 600; ++n) {
            run(world, 1);
            ASSERT_LE(energy(), before * 2) << c << " N·s/m, frame " << n;
        }
        EXPECT_LT(energy(), before * 0.8) << c << " N·s/m";
        EXPECT_TRUE(world.getFaultedBodies().empty());
    }
}

/// A slack rope holds nothing up, however strongly it is damped.
TEST(DampedBungee, LetsFallWhileItIsSlack) {
    World world;
    RigidBody *const body = world.createBody(), *const post = world.createBody();
    post->setInverseMass(0);
    body->setPosition(0, -1, 0);
    body->setAcceleration(Vector3::GRAVITY);
    world.createSpring<Bungee>(body, Vector3(), post, Vector3(), 100, 20).setDamping(1e6);
    run(world, 120);
    EXPECT_NEAR(body->getVelocity().y, -9.81, 1e-12);
}

/// A rope without spring between two that drift apart brings them to one velocity, and no nearer.
TEST(DampedBungee, BearsAnyDamping) {
    for (real c = 1e-2; c < 1e10; c *= 10) {
        World world;
        RigidBody *const a = world.createBody(), *const b = world.createBody();
        a->setMass(2);
        b->setPosition(3, 0, 0);
        b->setVelocity(3, 0, 0);
        world.createSpring<Bungee>(a, Vector3(), b, Vector3(), 0, 0).setDamping(c);
        real last = 3;
        for (int n = 0; n < 240; ++n) {
            run(world, 1);
            const real parting = b->getVelocity().x - a->getVelocity().x;
            ASSERT_LE(parting, last + 1e-12) << c << " N·s/m, frame " << n;
            ASSERT_GE(parting, -1e-12) << c << " N·s/m, frame " << n;
            last = parting;
        }
        ASSERT_NEAR(2 * a->getVelocity().x + b->getVelocity().x, 3, 1e-9);
    }
}

/// A heavy rod that turns easily, held far from its centre and near it: the strength is that at the arm's
/// end.
TEST(DampedSpring, OfAnyStrengthStopsARodThatTurns) {
    for (const real arm : {5.0, 0.1}) {
        for (const real c : {1.0, 1e2, 1e4, 1e6}) {
            World world;
            RigidBody *const rod = world.createBody();
            rod->setMass(1000);
            rod->setRotation(0, 0, 0.1);
            world.createForce<AnchoredSpring>(rod, Vector3(arm, 0, 0), Vector3(arm, 100, 0), 0, 0)
                .setDamping(c);
            for (int n = 0; n < 240; ++n) {
                run(world, 1);
                ASSERT_LE(rod->getRotation().magnitude(), 0.1 * (1 + 1e-12))
                    << arm << " m, " << c << " N·s/m, frame " << n;
            }
            // The point's motion decays as e^{−c·(1/m + arm²)·t}.
            const real pace = rod->getVelocityAtPoint(rod->getPointInWorldSpace(Vector3(arm, 0, 0))).y;
            if (c * arm * arm > 10) {
                ASSERT_NEAR(pace, 0, 1e-6) << arm << " m, " << c << " N·s/m";
            }
        }
    }
}

/// What turns about the line, or across it, is not damped.
TEST(DampedSpring, ResistsMotionAlongItsLineOnly) {
    RigidBody body;
    body.setPosition(0, 3, 0);
    body.setVelocity(4, 0, -2);
    AnchoredSpring spring(Vector3(), Vector3(), 10, 3);
    spring.setDamping(7);
    EXPECT_EQ(spring.getForce(body), Vector3());
    body.setVelocity(4, 0.5, -2);
    EXPECT_EQ(spring.getForce(body), Vector3(0, -3.5, 0));
    body.setPosition(Vector3());
    EXPECT_EQ(spring.getForce(body), Vector3()) << "no line, no force";
    EXPECT_EQ(spring.getTension(body), 0);
}

/// A point off the centre moves with the rotation: 1 m aside and 2 rad/s are 2 m/s.
TEST(DampedSpring, KnowsHowItsPointsMove) {
    RigidBody body, other;
    body.setRotation(0, 0, 2);
    other.setPosition(1, -4, 0);
    other.setRotation(0, 0, 3);
    Spring spring(&body, Vector3(1, 0, 0), &other, Vector3(0, 0, 0), 0, 0);
    spring.setDamping(5);
    EXPECT_DOUBLE_EQ(spring.getTension(body), 5 * 2);
    EXPECT_TRUE(isNear(spring.getForce(body), Vector3(0, -10, 0), 1e-14));
    EXPECT_TRUE(isNear(spring.getForce(other), Vector3(0, 10, 0), 1e-14));
    other.setVelocity(0, 2, 0);
    EXPECT_DOUBLE_EQ(spring.getTension(body), 0);
    Spring atTheOthersRim(&body, Vector3(), &other, Vector3(-1, 0, 0), 0, 0);
    atTheOthersRim.setDamping(5);
    EXPECT_DOUBLE_EQ(atTheOthersRim.getTension(body), 5 * (3 - 2)) << "3 m/s by rotation, down, less 2 up";
}

TEST(Tension, IsTheForceOfAHangingWeight) {
    World world;
    RigidBody *const lamp = world.createBody();
    lamp->setMass(4);
    lamp->setAcceleration(Vector3::GRAVITY);
    AnchoredSpring &cord = world.createForce<AnchoredSpring>(lamp, Vector3(), Vector3(0, 10, 0), 500, 2);
    cord.setDamping(50);
    run(world, 3000);
    EXPECT_NEAR(cord.getTension(*lamp), 4 * 9.81, 1e-6);
    EXPECT_NEAR(cord.getLength(*lamp), 2 + 4 * 9.81 / 500, 1e-8);
}

TEST(DampedBungee, NeverPushes) {
    RigidBody body, post;
    Bungee rope(Vector3(), &post, Vector3(), 100, 2);
    rope.setDamping(30);
    body.setPosition(0, 1.9, 0);
    body.setVelocity(0, 5, 0);
    EXPECT_EQ(rope.getTension(body), 0) << "slack, however fast it is being stretched";
    EXPECT_EQ(rope.getForce(body), Vector3());
    body.setPosition(0, 2, 0);
    EXPECT_EQ(rope.getTension(body), 0) << "just taut";
    body.setPosition(0, 2.5, 0);
    EXPECT_DOUBLE_EQ(rope.getTension(body), 100 * 0.5 + 30 * 5);
    body.setVelocity(0, -5, 0);
    EXPECT_EQ(rope.getTension(body), 0) << "recoiling faster than the rope follows";
    EXPECT_EQ(rope.getForce(body), Vector3());
}

/// A winch: the rest length is an input of the game's.
TEST(RestLength, CanBeWoundIn) {
    World world;
    RigidBody *const crate = world.createBody();
    crate->setMass(10);
    crate->setAcceleration(Vector3::GRAVITY);
    AnchoredSpring &rope = world.createForce<AnchoredSpring>(crate, Vector3(), Vector3(0, 20, 0), 4000, 20);
    rope.setDamping(200);
    for (int n = 0; n < 1200; ++n) {
        rope.setRestLength(rope.getRestLength() - 1 * STEP);  // 1 m/s
        run(world, 1);
    }
    // The weight and the damping stretch the rope. Its length is of the last step's start: 1 m/s·STEP ago.
    EXPECT_NEAR(crate->getPosition().y, 10 + 1 * STEP - (10 * 9.81 + 200 * 1) / 4000, 1e-6);
    EXPECT_NEAR(crate->getVelocity().y, 1, 1e-3);
    rope.setSpringConstant(1000);
    EXPECT_EQ(rope.getSpringConstant(), 1000);
    run(world, 1200);
    EXPECT_NEAR(rope.getLength(*crate), rope.getRestLength() + 10 * 9.81 / 1000, 1e-3);
}

TEST(ElasticForces, RefuseBadSettingsAndKeepTheirOwn) {
    AnchoredSpring spring(Vector3(), Vector3(), 5, 2);
    spring.setDamping(3);
    for (real bad : {-1.0, QUIET_NAN, PLUS_INFINITY}) {
        EXPECT_THROW(spring.setSpringConstant(bad), std::invalid_argument);
        EXPECT_THROW(spring.setRestLength(bad), std::invalid_argument);
        EXPECT_THROW(spring.setDamping(bad), std::invalid_argument);
    }
    EXPECT_EQ(spring.getSpringConstant(), 5);
    EXPECT_EQ(spring.getRestLength(), 2);
    EXPECT_EQ(spring.getDamping(), 3);
}

}  // namespace
