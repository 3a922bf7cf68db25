// The simple forces, each against the motion that follows from it in closed form; the registry is in
// registry_test.cpp.
#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "frames.h"
#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

/// A world with one body of 2 kg and one generator.
struct Alone {
    World world;
    RigidBody *body = world.createBody();

    explicit Alone(ForceGenerator &force) {
        body->setMass(2);
        world.getForceRegistry().add(body, &force);
    }
};

TEST(Gravity, MakesAllMassesFallAlike) {
    Gravity gravity;
    World world;
    RigidBody *light = world.createBody(), *heavy = world.createBody(), *fixed = world.createBody();
    light->setMass(0.01);
    heavy->setMass(1e6);
    fixed->setInverseMass(0);
    for (RigidBody *body : {light, heavy, fixed}) world.getForceRegistry().add(body, &gravity);
    run(world, 240);
    for (const RigidBody *body : {light, heavy}) {
        EXPECT_NEAR(body->getPosition().y, -9.81 * 2 * 2 / 2, 1e-10);
        EXPECT_NEAR(body->getVelocity().y, -9.81 * 2, 1e-11);
    }
    EXPECT_EQ(fixed->getPosition(), Vector3());
    EXPECT_EQ(fixed->getVelocity(), Vector3());
}

TEST(Gravity, PullsWhereItIsTold) {
    Gravity gravity(Vector3(0, 0, 1.62));
    Alone alone(gravity);
    run(alone.world, 120);
    EXPECT_TRUE(isNear(alone.body->getVelocity(), Vector3(0, 0, 1.62), 1e-12));
}

TEST(Drag, SlowsExponentiallyWhenLinear) {
    Drag drag(3, 0);
    Alone alone(drag);
    alone.body->setVelocity(10, -20, 5);
    run(alone.world, 120);
    EXPECT_TRUE(isNear(alone.body->getVelocity(), Vector3(10, -20, 5) * std::exp(-1.5), 2e-4));
    EXPECT_TRUE(isNear(alone.body->getPosition(), Vector3(10, -20, 5) * ((1 - std::exp(-1.5)) / 1.5), 2e-3));
}

TEST(Drag, SlowsHyperbolicallyWhenQuadratic) {
    Drag drag(0, 0.5);
    Alone alone(drag);
    alone.body->setVelocity(6, 0, -8);
    run(alone.world, 240);
    // dv/dt = -(k2/m)v²: v = v0/(1 + v0·k2·t/m), from 10 m/s for 2 s.
    EXPECT_TRUE(isNear(alone.body->getVelocity(), Vector3(0.6, 0, -0.8) * (10 / (1 + 10 * 0.25 * 2)), 1e-3));
}

TEST(Drag, LeadsToTheTerminalVelocity) {
    Drag drag(0.3, 0.2);
    Alone alone(drag);
    alone.body->setAcceleration(Vector3::GRAVITY);
    run(alone.world, 2400);
    // Where k1·v + k2·v² = m·g.
    const real terminal = (-0.3 + std::sqrt(0.3 * 0.3 + 4 * 0.2 * 2 * 9.81)) / (2 * 0.2);
    EXPECT_TRUE(isNear(alone.body->getVelocity(), Vector3(0, -terminal, 0), 1e-9));
}

TEST(Drag, OfABodyAtRestIsNothing) {
    Drag drag(1, 1);
    Alone alone(drag);
    run(alone.world, 2);
    EXPECT_EQ(alone.body->getPosition(), Vector3());
}

TEST(AnchoredSpring, SwingsWithItsPeriod) {
    const Vector3 anchor(1, 2, 3), direction(0.6, 0, 0.8);
    AnchoredSpring spring(Vector3(), anchor, 50, 1.5);
    Alone alone(spring);
    alone.body->setPosition(anchor + direction * 1.6);
    const real omega = std::sqrt(50.0 / 2);
    for (int n = 1; n <= 480; ++n) {
        run(alone.world, 1);
        const real length = 1.5 + 0.1 * std::cos(omega * n * STEP);
        ASSERT_TRUE(isNear(alone.body->getPosition(), anchor + direction * length, 2e-3)) << n;
    }
}

TEST(AnchoredSpring, PullsStretchedPushesCompressedAndRestsAtZeroLength) {
    AnchoredSpring spring(Vector3(), Vector3(), 100, 2);
    for (real x : {-3.0, -1.0, 0.0, 0.5, 2.0, 5.0}) {
        Alone alone(spring);
        alone.body->setPosition(x, 0, 0);
        run(alone.world, 1);
        const real away = x > 0 ? 1 : -1;
        const real force = x == 0 ? 0 : -100 * (std::fabs(x) - 2) * away;
        EXPECT_NEAR(alone.body->getVelocity().x, force / 2 * STEP, 1e-13) << x;
    }
}

TEST(AnchoredSpring, FollowsItsAnchorAndTurnsTheBody) {
    // At the end of a lever along X; the force along Z then gives a torque about -Y.
    AnchoredSpring spring(Vector3(2, 0, 0), Vector3(), 10, 0);
    Alone alone(spring);
    spring.setAnchor(Vector3(2, 0, 3));
    EXPECT_EQ(spring.getAnchor(), Vector3(2, 0, 3));
    run(alone.world, 1);
    EXPECT_TRUE(isNear(alone.body->getVelocity(), Vector3(0, 0, 30.0 / 2 * STEP), 1e-14));
    EXPECT_TRUE(isNear(alone.body->getRotation(), Vector3(0, -60 * STEP, 0), 1e-5));

    // The same on a body turned by a quarter about Y: its X axis points to -Z.
    Alone turned(spring);
    turned.body->setOrientation(Quaternion::fromAxisAngle(Vector3::Y, REAL_PI / 2));
    spring.setAnchor(Vector3(3, 0, -2));
    run(turned.world, 1);
    EXPECT_TRUE(isNear(turned.body->getVelocity(), Vector3(30.0 / 2 * STEP, 0, 0), 1e-14));
    EXPECT_TRUE(isNear(turned.body->getRotation(), Vector3(0, -60 * STEP, 0), 1e-5));
}

TEST(Spring, BetweenTwoBodiesSwingsWithTheReducedMassAndKeepsMomentum) {
    World world;
    RigidBody *a = world.createBody(), *b = world.createBody();
    a->setMass(2);
    b->setMass(6);
    a->setPosition(-1, 0, 0);
    b->setPosition(1.2, 0, 0);
    a->setVelocity(0, 3, 0);
    b->setVelocity(0, 3, 0);
    Spring onA(Vector3(), b, Vector3(), 60, 2), onB(Vector3(), a, Vector3(), 60, 2);
    world.getForceRegistry().add(a, &onA);
    world.getForceRegistry().add(b, &onB);
    const real omega = std::sqrt(60 / (2.0 * 6.0 / 8.0));
    for (int n = 1; n <= 480; ++n) {
        run(world, 1);
        const Vector3 momentum = a->getVelocity() * 2 + b->getVelocity() * 6;
        ASSERT_TRUE(isNear(momentum, Vector3(0, 24, 0), 1e-12));
        const real length = (b->getPosition() - a->getPosition()).magnitude();
        ASSERT_NEAR(length, 2 + 0.2 * std::cos(omega * n * STEP), 5e-3) << n;
    }
}

TEST(Spring, OffTheCentresKeepsMomentumAndAngularMomentum) {
    World world;
    RigidBody *a = world.createBody(), *b = world.createBody();
    a->setMass(2);
    b->setMass(1);
    b->setPosition(0, 3, 1);
    b->setInertiaTensor(diagonal(0.5, 1, 1.2));
    Spring onA(Vector3(0.5, 0.2, 0), b, Vector3(0, -0.4, 0.3), 20, 1);
    Spring onB(Vector3(0, -0.4, 0.3), a, Vector3(0.5, 0.2, 0), 20, 1);
    world.getForceRegistry().add(a, &onA);
    world.getForceRegistry().add(b, &onB);
    for (int n = 0; n < 240; ++n) {
        run(world, 1);
        const Vector3 pa = a->getVelocity() * 2, pb = b->getVelocity();
        ASSERT_TRUE(isNear(pa + pb, Vector3(), 1e-12));
        // Angular momentum about the origin: kept to the order of the step.
        const Vector3 turning =
            a->getAngularMomentum() + b->getAngularMomentum() + a->getPosition() % pa + b->getPosition() % pb;
        ASSERT_TRUE(isNear(turning, Vector3(), 5e-2));
    }
    EXPECT_GT(a->getRotation().magnitude(), 0.1);
}

TEST(Spring, PullsAtTheOthersPointHoweverItIsTurned) {
    RigidBody other;
    other.setPosition(5, 0, 0);
    other.setOrientation(Quaternion::fromAxisAngle(Vector3::Z, REAL_PI / 2));
    Spring spring(Vector3(), &other, Vector3(2, 0, 0), 7, 0);  // the other's X axis points to Y
    Alone alone(spring);
    run(alone.world, 1);
    EXPECT_TRUE(isNear(alone.body->getVelocity(), Vector3(35, 14, 0) * (STEP / 2), 1e-13));
}

TEST(Bungee, IsASpringWhenStretchedAndSlackOtherwise) {
    RigidBody other;
    Bungee bungee(Vector3(), &other, Vector3(), 40, 3);
    Spring spring(Vector3(), &other, Vector3(), 40, 3);
    for (real x : {0.0, 1.0, 2.999, 3.0, 3.5, 10.0}) {
        Alone held(bungee), sprung(spring);
        held.body->setPosition(x, 0, 0);
        sprung.body->setPosition(x, 0, 0);
        run(held.world, 1);
        run(sprung.world, 1);
        EXPECT_EQ(held.body->getVelocity(), x > 3 ? sprung.body->getVelocity() : Vector3()) << x;
    }
}

TEST(Bungee, StopsAJumperWhereEnergySays) {
    RigidBody bridge;
    Bungee rope(Vector3(), &bridge, Vector3(), 100, 10);
    Alone jump(rope);
    jump.body->setMass(70);
    jump.body->setAcceleration(Vector3::GRAVITY);
    real lowest = 0;
    for (int n = 0; n < 1200; ++n) {
        run(jump.world, 1);
        lowest = std::fmin(lowest, jump.body->getPosition().y);
        if (n == 167) {
            EXPECT_NEAR(jump.body->getPosition().y, -9.81 * 1.4 * 1.4 / 2, 1e-9);  // free fall until then
        }
    }
    // m·g·d = k(d − L)²/2.
    const real weight = 70 * 9.81, b = 10 + weight / 100;
    EXPECT_NEAR(lowest, -(b + std::sqrt(b * b - 100)), 0.01);
}

// ---- What all tell alike

/// One of each, at points off the centre where they take one.
struct Everything {
    RigidBody other;
    Vector3 wind = Vector3(3, -1, 2);
    Vector3 point = Vector3(0.5, -0.3, 0.8);
    Matrix3 tensor = diagonal(-1, -2, -3);
    Gravity gravity;
    Drag drag{1, 2};
    Spring spring{point, &other, Vector3(1, 0, 0), 10, 0.5};
    Bungee bungee{point, &other, Vector3(0, 1, 0), 10, 0.5};
    AnchoredSpring anchored{point, Vector3(9, 9, 9), 10, 1};
    Aero aero{tensor, point, &wind};
    AeroControl control{tensor, tensor, tensor * 2, point, &wind};
    AngledAero angled{tensor, point, &wind};
    Buoyancy buoyancy{point, 1, 0.1, 2};
    HullDrag hullDrag{&buoyancy, point, Vector3(1, 2, 3), Vector3(4, 5, 6)};
    Thruster thruster{Vector3(1, 2, 3), point, 50};
    Propeller propeller{Vector3(1, 2, 3), point, 50, 20, &wind};

    Everything() {
        aero.setRotationalFlow(true);
        control.setControl(0.5);
        angled.setOrientation(Quaternion(1, 0.2, 0.3, 0));
        thruster.setThrottle(0.5);
        propeller.setThrottle(0.5);
    }
    std::vector<PointForce *> list() {
        return {&gravity, &drag,   &spring,   &bungee,   &anchored, &aero,
                &control, &angled, &buoyancy, &hullDrag, &thruster, &propeller};
    }
};

TEST(PointForce, TellsWhatItDoesToTheBody) {
    Everything all;
    RigidBody body;
    body.setMass(2);
    body.setPosition(1, 2, 3);
    body.setOrientation(0.5, 0.1, -0.3, 0.7);
    body.setVelocity(4, -3, 1);
    body.setRotation(0.3, 0.6, -0.9);
    for (PointForce *force : all.list()) {
        const Vector3 told = force->getForce(body);
        const Vector3 arm = body.getDirectionInWorldSpace(force->getPointOn(body));
        EXPECT_NE(told, Vector3());
        EXPECT_EQ(force->getPointOn(body), force->getPosition());
        EXPECT_EQ(force->getPosition(), force == &all.gravity || force == &all.drag ? Vector3() : all.point);
        body.clearAccumulators();
        force->updateForce(&body, STEP);
        EXPECT_EQ(body.getState().added.force, told);
        EXPECT_TRUE(isNear(body.getState().added.torque, arm % told, 1e-12));
        EXPECT_TRUE(force->actsOnItsBodyOnly());
    }
}

TEST(PointForce, SpringBetweenTwoBodiesTellsWhereItActsOnEach) {
    RigidBody first, second;
    second.setPosition(5, 0, 0);
    const Spring spring(&first, Vector3(1, 0, 0), &second, Vector3(-1, 0, 0), 10, 1);
    EXPECT_EQ(spring.getPointOn(first), Vector3(1, 0, 0));
    EXPECT_EQ(spring.getPointOn(second), Vector3(-1, 0, 0));
    EXPECT_EQ(spring.getForce(first), Vector3(20, 0, 0));
    EXPECT_EQ(spring.getForce(second), Vector3(-20, 0, 0));
}

TEST(PointForce, DerivedClassesTellTheForceOnly) {
    /// A wing that works in thin air.
    class ThinAir : public Aero {
    public:
        using Aero::Aero;
        Vector3 getForce(const RigidBody &body) const override { return Aero::getForce(body) * 0.25; }
    };
    /// A push that follows no law of the library's.
    class Push : public PointForce {
    public:
        Push() : PointForce(Vector3(0, 1, 0)) {}
        Vector3 getForce(const RigidBody &) const override { return Vector3(6, 0, 0); }
    };
    RigidBody body;
    body.setVelocity(10, 0, 0);
    ThinAir wing(diagonal(-1, -1, -1), Vector3(), nullptr);
    wing.updateForce(&body, STEP);
    EXPECT_EQ(body.getState().added.force, Vector3(-2.5, 0, 0));
    Push push;
    body.clearAccumulators();
    push.updateForce(&body, STEP);
    EXPECT_EQ(body.getState().added.force, Vector3(6, 0, 0));
    EXPECT_EQ(body.getState().added.torque, Vector3(0, 0, -6));
}

TEST(Gravity, LeavesTheImmovableAlone) {
    RigidBody rock;
    rock.setInverseMass(0);
    EXPECT_EQ(Gravity().getForce(rock), Vector3());
}

}  // namespace
