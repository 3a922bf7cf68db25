/// Resistance of any strength: the motion through the medium never grows, and ends at the terminal velocity.
#include <cyclone/aero.h>
#include <cyclone/buoyancy.h>
#include <cyclone/propulsion.h>
#include <cyclone/wing.h>
#include <cyclone/world.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

constexpr real H = 1.0 / 60;
const real STRENGTHS[] = {1e-3, 0.01, 0.1, 0.3, 0.49, 0.5, 0.51, 0.6, 0.75, 0.9, 0.99,
                          1,    1.01, 1.5, 2,   3,    5,   10,   100, 1e4,  1e6, 1e9};

/// A push that knows nothing of motion.
class Push : public ForceGenerator {
public:
    explicit Push(const Vector3 &f, const Vector3 &t = Vector3()) : force(f), torque(t) {}
    void updateForce(RigidBody *body, real) override {
        body->addForce(force);
        body->addTorque(torque);
    }
    bool actsOnItsBodyOnly() const override { return true; }

private:
    Vector3 force, torque;
};

Matrix3 isotropic(real c) { return diagonal(-c, -c, -c); }

/// Steps until nothing changes any more or that many seconds are over; checks that the motion through the
/// medium, the velocity less the terminal one, never grows, and that it has gone in the end.
void expectDecay(RigidBody &body, ForceRegistry &registry, const Vector3 &terminal, real strength) {
    const Vector3 start = body.getVelocity() - terminal;
    real distance = start.magnitude(), overshoot = 0;
    const real rounding = 1e-12 * (body.getVelocity().magnitude() + terminal.magnitude());
    const int steps = static_cast<int>(40 / strength) + 60;
    for (int n = 0; n < steps; ++n) {
        registry.updateForces(H);
        ASSERT_TRUE(body.integrate(H));
        const Vector3 motion = body.getVelocity() - terminal;
        EXPECT_LE(motion.magnitude(), distance + rounding) << "frame " << n << ", strength " << strength;
        distance = motion.magnitude();
        overshoot = std::max(overshoot, -(motion * start) / start.squareMagnitude());
    }
    EXPECT_LE(distance, 1e-8 * start.magnitude() + rounding) << strength;
    EXPECT_LE(overshoot, 1e-9) << strength;
}

}  // namespace

TEST(Resistance, FallsAtTheTerminalVelocity) {
    for (const real strength : STRENGTHS) {
        RigidBody body;
        body.setMass(2.5);
        body.setVelocity(30, 5, 0);
        body.setAcceleration(Vector3::GRAVITY);
        const real c = strength * body.getMass() / H;
        Drag drag(c, 0);
        ForceRegistry registry;
        registry.add(&body, &drag);
        expectDecay(body, registry, Vector3::GRAVITY * (body.getMass() / c), strength);
    }
}

TEST(Resistance, OfAFeatherAndOfAShip) {
    for (const real kilograms : {1e-6, 1e6}) {
        for (const real strength : STRENGTHS) {
            RigidBody body;
            body.setMass(kilograms);
            body.setVelocity(3, -5, 0);
            body.setAcceleration(Vector3::GRAVITY);
            const real c = strength * kilograms / H;
            Aero surface(isotropic(c), Vector3(), nullptr);
            ForceRegistry registry;
            registry.add(&body, &surface);
            expectDecay(body, registry, Vector3::GRAVITY * (kilograms / c), strength);
        }
    }
}

TEST(Resistance, GoesWithTheWindWhenTowed) {
    const Vector3 windspeed(-8, 1, 3), pull(40, 11, -7);
    for (const real strength : STRENGTHS) {
        RigidBody body;
        body.setMass(0.2);
        body.setVelocity(-30, 5, 9);
        const real c = strength * body.getMass() / H;
        Aero surface(isotropic(c), Vector3(), &windspeed);
        Push push(pull);
        ForceRegistry registry;
        registry.add(&body, &push);
        registry.add(&body, &surface);
        expectDecay(body, registry, pull * (1 / c) - windspeed, strength);
    }
}

TEST(Resistance, CarriesACallersForce) {
    const Vector3 tow(0, 11, 2);
    for (const real strength : {1.0, 2.0, 10.0, 1e3, 1e6, 1e9}) {
        RigidBody body;
        body.setVelocity(-30, 5, 9);
        const real c = strength / H;
        Drag drag(c, 0);
        ForceRegistry registry;
        registry.add(&body, &drag);
        Vector3 before;
        for (int n = 0; n < 100; ++n) {
            before = body.getPosition();
            body.addForce(tow);
            registry.updateForces(H);
            ASSERT_TRUE(body.integrate(H));
        }
        const Vector3 mean = (body.getPosition() - before) * (1 / H);
        EXPECT_TRUE(isNear(mean, tow * (1 / c), 1e-7 * tow.magnitude() / c + 1e-13));
        // At the frame's time it lags, for a plain kick acts at the start of a step and then decays.
        EXPECT_LE(body.getVelocity().magnitude(), mean.magnitude() * (1 + 1e-12));
    }
}

TEST(Resistance, OfManySurfacesCountsTogether) {
    for (const real strength : STRENGTHS) {
        RigidBody body;
        body.setVelocity(3, 4, 0);
        std::vector<std::unique_ptr<Aero>> surfaces;
        ForceRegistry registry;
        for (int n = 0; n < 10; ++n) {
            surfaces.push_back(
                std::make_unique<Aero>(isotropic(0.1 * strength / H), Vector3(0, n - 4.5, 0), nullptr));
            registry.add(&body, surfaces.back().get());
        }
        expectDecay(body, registry, Vector3(), strength);
    }
}

TEST(Resistance, SlowsASpinToItsTerminalOne) {
    // Paddles at ±arm: together ∂torque/∂rotation = −2·c·arm² about z.
    const Vector3 arm(0.7, 0, 0);
    const real moment = 0.02, terminal = 5;
    for (const real strength : STRENGTHS) {
        for (const real start : {25.0, -25.0}) {
            RigidBody body;
            body.setInertiaTensor(diagonal(moment, moment, moment));
            body.setRotation(0, 0, start);
            const real total = strength * moment / H, c = total / (2 * arm.squareMagnitude());
            Aero left(isotropic(c), arm, nullptr), right(isotropic(c), -arm, nullptr);
            left.setRotationalFlow(true);
            right.setRotationalFlow(true);
            Push push(Vector3(), Vector3(0, 0, terminal * total));
            ForceRegistry registry;
            registry.add(&body, &left);
            registry.add(&body, &right);
            registry.add(&body, &push);
            real distance = real_abs(start - terminal);
            for (int n = 0; n < 40 / strength + 60; ++n) {
                registry.updateForces(H);
                ASSERT_TRUE(body.integrate(H));
                EXPECT_LE(real_abs(body.getRotation().z - terminal), distance + 1e-12) << strength;
                distance = real_abs(body.getRotation().z - terminal);
            }
            EXPECT_LE(distance, 1e-10) << strength;
        }
    }
}

TEST(Resistance, OffTheCentreNeverAddsEnergy) {
    Random random(5);
    for (const real strength : STRENGTHS) {
        for (int trial = 0; trial < 20; ++trial) {
            RigidBody body;
            body.setMass(random.between(0.1, 10));
            body.setInertiaTensor(diagonal(random.between(1, 2), random.between(1, 2), random.between(1, 2)));
            body.setOrientation(random.orientation());
            body.setVelocity(random.vector(10));
            body.setRotation(random.vector(10));
            if (trial % 2 == 1) body.setDamping(0.9, 0.5);
            const real c = strength * body.getMass() / H;
            Aero paddle(diagonal(-c, -0.1 * c, -0.01 * c), random.vector(), nullptr);
            Aero fin(diagonal(0, 0, -c), random.vector(), nullptr);
            paddle.setRotationalFlow(true);
            fin.setRotationalFlow(true);
            ForceRegistry registry;
            registry.add(&body, &paddle);
            registry.add(&body, &fin);
            const auto energy = [&body] {
                return body.getMass() * body.getVelocity().squareMagnitude() / 2 +
                       body.getAngularMomentum() * body.getRotation() / 2;
            };
            const real initial = energy();
            for (int n = 0; n < 300; ++n) {
                registry.updateForces(H);
                ASSERT_TRUE(body.integrate(H));
                // The reported motion holds part of a kick that the next step replaces.
                ASSERT_LE(energy(), 1.01 * initial) << strength << ", frame " << n;
            }
        }
    }
}

TEST(Resistance, AtStepsOfAnyLengthNeverFeedsTheMotion) {
    for (const real strength : STRENGTHS)
        for (const real ratio : {1.5, 3.0, 10.0, 1000.0}) {
            RigidBody body;
            body.setVelocity(3, 0, 0);
            Drag drag(strength / H, 0);
            ForceRegistry registry;
            registry.add(&body, &drag);
            const int steps = static_cast<int>(80 / strength) + 60;
            for (int n = 0; n < steps; ++n) {
                const real duration = n % 2 == 0 ? H : H / ratio;
                registry.updateForces(duration);
                ASSERT_TRUE(body.integrate(duration));
                ASSERT_LE(body.getVelocity().magnitude(), 3) << strength << ", " << ratio << ", frame " << n;
            }
            EXPECT_LE(body.getVelocity().magnitude(), 1e-6) << strength << ", " << ratio;
        }
}

TEST(Resistance, OfAParachuteOnACrate) {
    for (const bool flow : {false, true}) {
        for (const real kilograms : {20.0, 7.0, 1.0, 0.01}) {
            RigidBody crate;
            crate.setMass(kilograms);
            Matrix3 inertia;
            inertia.setBlockInertiaTensor(Vector3(0.5, 0.5, 0.5), kilograms);
            crate.setInertiaTensor(inertia);
            crate.setVelocity(15, 0, 0);
            crate.setAcceleration(Vector3::GRAVITY);
            crate.setAngularDamping(0.5);
            Aero parachute(isotropic(300), Vector3(0, 4, 0), nullptr);
            parachute.setRotationalFlow(flow);
            ForceRegistry registry;
            registry.add(&crate, &parachute);
            for (int n = 0; n < 60 * 60; ++n) {
                registry.updateForces(H);
                ASSERT_TRUE(crate.integrate(H));
                ASSERT_LT(crate.getVelocity().magnitude(), 20);
                ASSERT_LT(crate.getRotation().magnitude(), 1000);
            }
            // With rotational flow it swings from the parachute on, as a pendulum.
            if (!flow) {
                EXPECT_NEAR(crate.getVelocity().y, -9.81 * kilograms / 300, 1e-9) << kilograms;
            }
        }
    }
}

TEST(Resistance, ThatGrowsWithTheSquareHoldsAnySpeed) {
    for (const real speed : {1.0, 1e3, 1e6, 1e9}) {
        RigidBody body;
        body.setVelocity(speed, 0, 0);
        body.setAcceleration(Vector3::GRAVITY);
        Drag drag(0, 0.7);
        ForceRegistry registry;
        registry.add(&body, &drag);
        real fastest = 2 * speed;
        for (int n = 0; n < 3600; ++n) {
            registry.updateForces(H);
            ASSERT_TRUE(body.integrate(H));
            ASSERT_LE(body.getVelocity().magnitude(), std::max(fastest, 5.0));
            fastest = body.getVelocity().magnitude();
        }
        EXPECT_TRUE(isNear(body.getVelocity(), Vector3(0, -real_sqrt(9.81 / 0.7), 0), 1e-6));
    }
}

TEST(Resistance, OfAPropellerEndsAtItsPitchSpeed) {
    for (const real start : {-50.0, 0.0, 80.0}) {
        for (const real force : {1.0, 1e2, 1e4, 1e8}) {
            RigidBody body;
            body.setVelocity(start, 0, 0);
            Propeller propeller(Vector3::X, Vector3(-1, 0, 0), force, 20, nullptr);
            propeller.setThrottle(1);
            ForceRegistry registry;
            registry.add(&body, &propeller);
            for (int n = 0; n < 60 * 1000; ++n) {
                registry.updateForces(H);
                ASSERT_TRUE(body.integrate(H));
                ASSERT_LE(body.getVelocity().x, std::max(start, 20.0) + 1e-9);
            }
            EXPECT_NEAR(body.getVelocity().x, 20, 1e-6);
        }
    }
}

TEST(Resistance, LeavesLockedAxesAndImmovableBodiesAlone) {
    for (const real strength : {0.7, 3.0, 1e9}) {
        RigidBody door, wall;
        door.setInverseInertiaTensor(diagonal(0, 1, 0));
        door.setRotation(0, 5, 0);
        wall.setInverseMass(0);
        wall.setVelocity(1, 2, 3);
        wall.setRotation(3, 2, 1);
        Aero surface(isotropic(strength / H), Vector3(1, 0, 0), nullptr);
        surface.setRotationalFlow(true);
        ForceRegistry registry;
        registry.add(&door, &surface);
        registry.add(&wall, &surface);
        for (int n = 0; n < 600; ++n) {
            registry.updateForces(H);
            ASSERT_TRUE(door.integrate(H));
            ASSERT_TRUE(wall.integrate(H));
            EXPECT_EQ(door.getRotation().x, 0);
            EXPECT_EQ(door.getRotation().z, 0);
            EXPECT_LE(real_abs(door.getRotation().y), 5.0);
        }
        EXPECT_EQ(wall.getVelocity(), Vector3(1, 2, 3));
        EXPECT_TRUE(isNear(wall.getRotation(), Vector3(3, 2, 1), 1e-9));
    }
}

/// What is weak for a heavy rod is strong for its turning, which is easy, when it acts far from the centre.
TEST(Resistance, AtTheEndOfALongArmStopsTheTurning) {
    const Vector3 end(-5, 0, 0);
    Aero paddle(isotropic(100), end, nullptr);
    paddle.setRotationalFlow(true);
    const Buoyancy hull(end, 1, 1, 100);
    HullDrag hullDrag(&hull, end, Vector3(100, 100, 100), Vector3());
    Wing tail(1, 0.1, end, nullptr);
    for (ForceGenerator *force :
         {static_cast<ForceGenerator *>(&paddle), static_cast<ForceGenerator *>(&hullDrag),
          static_cast<ForceGenerator *>(&tail)}) {
        RigidBody rod;
        rod.setMass(1000);
        rod.setInverseInertiaTensor(diagonal(0, 0, 1));
        rod.setVelocity(30, 0, 0);
        rod.setRotation(0, 0, 0.1);
        ForceRegistry registry;
        registry.add(&rod, force);
        for (int n = 0; n < 240; ++n) {
            registry.updateForces(H);
            ASSERT_TRUE(rod.integrate(H));
            ASSERT_LE(real_abs(rod.getRotation().z), 0.1) << "frame " << n;
        }
        EXPECT_LT(real_abs(rod.getRotation().z), 1e-3);
    }
}

// ---- Where it is not strong, and where it begins to be

namespace {

/// An Aero that keeps to itself how its force answers.
class Reticent : public Aero {
public:
    using Aero::Aero;
    void updateForce(RigidBody *body, real) override { body->addForceAtBodyPoint(getForce(*body), position); }
};

/// A body with that surface after some steps.
template <class Surface>
RigidBody after(int steps, real strength) {
    const Vector3 windspeed(1, -2, 3);
    RigidBody body;
    body.setVelocity(5, 3, 1);
    body.setRotation(1, 2, 3);
    body.setAcceleration(Vector3::GRAVITY);
    Surface surface(isotropic(strength / H), Vector3(0.1, 0, 0), &windspeed);
    ForceRegistry registry;
    registry.add(&body, &surface);
    for (int n = 0; n < steps; ++n) {
        registry.updateForces(H);
        body.integrate(H);
    }
    return body;
}

}  // namespace

TEST(Resistance, ThatIsWeakChangesNotOneBit) {
    for (const real strength : {0.01, 0.3, 0.499}) {
        const RigidBody told = after<Aero>(100, strength), untold = after<Reticent>(100, strength);
        EXPECT_EQ(told.getVelocity(), untold.getVelocity());
        EXPECT_EQ(told.getPosition(), untold.getPosition());
        EXPECT_EQ(told.getRotation(), untold.getRotation());
    }
}

TEST(Resistance, MakesNoJumpAtItsLimits) {
    for (const real limit : {0.5, 1.0}) {
        const RigidBody below = after<Aero>(5, limit - 1e-9), above = after<Aero>(5, limit + 1e-9);
        EXPECT_TRUE(isNear(below.getVelocity(), above.getVelocity(), 1e-6));
        EXPECT_TRUE(isNear(below.getPosition(), above.getPosition(), 1e-6));
        EXPECT_TRUE(isNear(below.getRotation(), above.getRotation(), 1e-6));
    }
}

TEST(Resistance, LeavesOtherDirectionsAsTheyWere) {
    RigidBody dinghy, reference;
    for (RigidBody *body : {&dinghy, &reference}) {
        body->setVelocity(3, 0, 0);
        body->setAcceleration(Vector3::GRAVITY);
    }
    Aero daggerboard(diagonal(-0.4, 0, -1e5), Vector3(), nullptr),
        hull(diagonal(-0.4, 0, 0), Vector3(), nullptr);
    ForceRegistry registry;
    registry.add(&dinghy, &daggerboard);
    registry.add(&reference, &hull);
    for (int n = 0; n < 600; ++n) {
        registry.updateForces(H);
        dinghy.integrate(H);
        reference.integrate(H);
    }
    EXPECT_TRUE(isNear(dinghy.getVelocity(), reference.getVelocity(), 1e-4));
    EXPECT_TRUE(isNear(dinghy.getPosition(), reference.getPosition(), 1e-3));
}

TEST(Resistance, ThatIsNotToldIsBoundToTheExplicitLimit) {
    EXPECT_LT(after<Reticent>(600, 0.95).getVelocity().magnitude(), 5);
    EXPECT_GT(after<Reticent>(600, 1.5).getVelocity().magnitude(), 1e10);
    EXPECT_LT(after<Aero>(600, 1.5).getVelocity().magnitude(), 5);
}

namespace {

/// What a user may write: honey, which resists motion and turning. A negative one feeds both.
class Honey : public ForceGenerator {
public:
    explicit Honey(real c) : coefficient(c) {}
    void updateForce(RigidBody *body, real) override {
        body->addForce(body->getVelocity() * -coefficient);
        body->addTorque(body->getRotation() * -coefficient);
        body->addResistance(real_abs(coefficient), real_abs(coefficient));
    }
    void addResistance(const RigidBody &, Resistance &sum) const override {
        sum.forceByVelocity += isotropic(coefficient);
        sum.torqueByRotation += isotropic(coefficient);
    }

private:
    real coefficient;
};

}  // namespace

TEST(Resistance, OfAUsersOwnMayBeToldToo) {
    for (const real strength : STRENGTHS) {
        RigidBody fly;
        fly.setVelocity(1, 2, 3);
        fly.setRotation(3, 2, 1);
        Honey honey(strength / H);
        ForceRegistry registry;
        registry.add(&fly, &honey);
        real spin = fly.getRotation().magnitude();
        const auto step = [&] {
            registry.updateForces(H);
            ASSERT_TRUE(fly.integrate(H));
            EXPECT_LE(fly.getRotation().magnitude(), spin);
            spin = fly.getRotation().magnitude();
        };
        for (int n = 0; n < 60; ++n) step();
        expectDecay(fly, registry, Vector3(), strength);
    }
}

/// What feeds motion as fast as a step can follow is no resistance. Then Δ = c·a + … of RigidBody::resist
/// holds with K = 1/(1 + γ|B|) along all directions, where the true 1/(1 − γ|B|) has no bound.
TEST(Resistance, ThatFeedsMotionIsTakenForOneThatDoesNot) {
    const real root3 = std::sqrt(3.0), gamma = (3 + root3) / 6;
    const real strength = 0.999 / gamma, k = 1 / (1 + gamma * strength);
    RigidBody fly;
    fly.setVelocity(1, 0, 0);
    Honey nectar(-strength / H);
    ForceRegistry registry;
    registry.add(&fly, &nectar);
    registry.updateForces(H);
    ASSERT_TRUE(fly.integrate(H));
    // The first step kicks for half of its length, and closes with a half of what is lasting, K³·a.
    const real kick = gamma * (k + k * k + (1 - root3) * k * k * k), closing = k * k * k;
    EXPECT_NEAR(fly.getVelocity().x, 1 + strength * (kick + closing) / 2, 1e-12);
}

TEST(Resistance, IsTheSameWithThreads) {
    constexpr int COUNT = 5000;
    const auto run = [](std::size_t threads) {
        World world;
        world.setWorkers(threads);
        std::vector<std::unique_ptr<Aero>> surfaces;
        Drag drag(10, 100);
        Honey honey(30);
        for (int n = 0; n < COUNT; ++n) {
            RigidBody *const body = world.createBody();
            body->setVelocity(n, 1, 2);
            body->setRotation(1, 0.1 * n, 0);
            surfaces.push_back(std::make_unique<Aero>(isotropic(n), Vector3(1, 0, 0.01 * n), nullptr));
            surfaces.back()->setRotationalFlow(n % 2 == 0);
        }
        for (std::size_t n = 0; n < COUNT; ++n)
            world.getForceRegistry().add(world.getBodies()[n], surfaces[n].get());
        for (std::size_t n = 0; n < COUNT; n += 7) world.getForceRegistry().add(world.getBodies()[n], &honey);
        for (std::size_t n = 0; n < COUNT; n += 3) world.getForceRegistry().add(world.getBodies()[n], &drag);
        for (int n = 0; n < 10; ++n) {
            world.startFrame();
            world.runPhysics(H);
        }
        return world.hash();
    };
    EXPECT_EQ(run(1), run(3));
}

TEST(Resistance, OfAFewIsTheSameWithThreads) {
    const auto run = [](JobSystem *jobs) {
        RigidBody body;
        body.setVelocity(30, 5, 0);
        Drag drag(2 / H, 0);
        ForceRegistry registry;
        registry.add(&body, &drag);
        for (int n = 0; n < 10; ++n) {
            jobs != nullptr ? registry.updateForces(H, *jobs) : registry.updateForces(H);
            body.integrate(H);
        }
        return body.getVelocity();
    };
    Workers workers(2);
    EXPECT_EQ(run(&workers), run(nullptr));
    EXPECT_LT(run(&workers).x, 1e-3);
}
