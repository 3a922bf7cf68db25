// What a body remembers of its last step, and that nothing but sleep, waking, faults and setState touches it.
#include <cyclone/cyclone.h>

#include "reference.h"

using namespace cyclone;
using cyclone_test::isNear;
using cyclone_test::QUIET_NAN;

namespace {

constexpr real STEP = 1.0 / 60;

/// Adds what it is told.
class Push : public ForceGenerator {
public:
    Vector3 force, torque;
    void updateForce(RigidBody *body, real) override {
        body->addForce(force);
        body->addTorque(torque);
    }
};

void runFrame(World &world, real duration = STEP) {
    world.startFrame();
    world.runPhysics(duration);
}

/// What a game may do between two frames without meaning to change anything.
struct Touch {
    const char *name;
    std::function<void(World &, RigidBody &)> apply;
};

Push idle;

const Touch TOUCHES[] = {
    {"setMass", [](World &, RigidBody &b) { b.setMass(b.getMass()); }},
    {"setInverseMass", [](World &, RigidBody &b) { b.setInverseMass(b.getInverseMass()); }},
    {"setInertiaTensor", [](World &, RigidBody &b) { b.setInertiaTensor(b.getInertiaTensor()); }},
    {"setPosition", [](World &, RigidBody &b) { b.setPosition(b.getPosition()); }},
    {"setOrientation", [](World &, RigidBody &b) { b.setOrientation(b.getOrientation()); }},
    {"setVelocity", [](World &, RigidBody &b) { b.setVelocity(b.getVelocity()); }},
    {"setRotation", [](World &, RigidBody &b) { b.setRotation(b.getRotation()); }},
    {"addVelocity", [](World &, RigidBody &b) { b.addVelocity(Vector3()); }},
    {"setAcceleration", [](World &, RigidBody &b) { b.setAcceleration(b.getAcceleration()); }},
    {"setDamping", [](World &, RigidBody &b) { b.setDamping(1, 1); }},
    {"setAwake", [](World &, RigidBody &b) { b.setAwake(); }},
    {"a new registration",
     [](World &w, RigidBody &b) {
         w.getForceRegistry().add(&b, &idle);
         w.getForceRegistry().remove(&b, &idle);
     }},
};

real greatestSwing(World &world, RigidBody &body, const Touch &touch, int every) {
    real swing = 0;
    for (int n = 0; n < 20000; ++n) {
        if (n % every == 0) touch.apply(world, body);
        runFrame(world);
        swing = std::max(swing, real_abs(body.getPosition().x));
    }
    return swing;
}

}  // namespace

// ---- Setters leave it alone

TEST(Memory, SettersDoNotPumpASpring) {
    const real k = std::pow(0.3 / STEP, 2);
    for (const Touch &touch : TOUCHES)
        for (int every : {1, 2, 10, 60}) {
            World world;
            RigidBody body;
            AnchoredSpring spring(Vector3(), Vector3(), k, 0);
            body.setPosition(1, 0, 0);
            world.addBody(&body);
            world.getForceRegistry().add(&body, &spring);
            EXPECT_LT(greatestSwing(world, body, touch, every), 1.001) << touch.name << ", frame " << every;
        }
}

TEST(Memory, SettersDoNotPumpATorsionSpring) {
    /// Turns bodies back upright about X, with ω·h = 0.3 for unit inertia.
    class Torsion : public ForceGenerator {
    public:
        void updateForce(RigidBody *body, real) override {
            const real angle = 2 * body->getOrientation().i * (body->getOrientation().r < 0 ? -1 : 1);
            body->addTorque(Vector3(-std::pow(0.3 / STEP, 2) * angle, 0, 0));
        }
    };
    for (const Touch &touch : TOUCHES) {
        World world;
        RigidBody body;
        Torsion torsion;
        body.setRotation(0.1 * 0.3 / STEP, 0, 0);
        world.addBody(&body);
        world.getForceRegistry().add(&body, &torsion);
        real swing = 0;
        for (int n = 0; n < 20000; ++n) {
            if (n % 2 == 0) touch.apply(world, body);
            runFrame(world);
            swing = std::max(swing, 2 * real_abs(body.getOrientation().i));
        }
        EXPECT_LT(swing, 0.105) << touch.name;
        EXPECT_GT(swing, 0.095) << touch.name;
    }
}

TEST(Memory, AccelerationMayBeASpring) {
    RigidBody body;
    body.setPosition(1, 0, 0);
    real swing = 0;
    for (int n = 0; n < 20000; ++n) {
        body.setAcceleration(body.getPosition() * -std::pow(0.3 / STEP, 2));
        body.integrate(STEP);
        swing = std::max(swing, real_abs(body.getPosition().x));
    }
    EXPECT_LT(swing, 1.001);
}

TEST(Memory, APulsedThrusterGivesItsImpulse) {
    for (const Touch &touch : TOUCHES) {
        World world;
        RigidBody body;
        Thruster thruster(Vector3::X, Vector3(), 100);
        world.addBody(&body);
        world.getForceRegistry().add(&body, &thruster);
        runFrame(world);
        for (int n = 0; n < 600; ++n) {
            thruster.setThrottle(n % 2);
            if (n % 2 == 0) touch.apply(world, body);
            runFrame(world);
        }
        thruster.setThrottle(0);
        for (int n = 0; n < 2; ++n) runFrame(world);
        EXPECT_NEAR(body.getVelocity().x, 100 * 300 * STEP, 1e-9) << touch.name;
    }
}

TEST(Memory, ForcesOnAnotherBodyKeepTheMomentum) {
    /// Throws the body to the one side and another one to the other.
    class Repulsion : public ForceGenerator {
    public:
        RigidBody *other = nullptr;
        real size = 0;
        void updateForce(RigidBody *body, real) override {
            body->addForce(Vector3(size, 0, 0));
            other->addForce(Vector3(-size, 0, 0));
        }
    };
    for (const Touch &touch : TOUCHES) {
        World world;
        RigidBody one, other;
        Repulsion repulsion;
        repulsion.other = &other;
        world.addBody(&one);
        world.addBody(&other);
        world.getForceRegistry().add(&one, &repulsion);
        runFrame(world);
        for (int n = 0; n < 600; ++n) {
            repulsion.size = n % 2 * 100;
            if (n % 2 == 0) touch.apply(world, other);
            runFrame(world);
        }
        repulsion.size = 0;
        for (int n = 0; n < 2; ++n) runFrame(world);
        EXPECT_NEAR(one.getVelocity().x, 500, 1e-9) << touch.name;
        EXPECT_NEAR(other.getVelocity().x, -500, 1e-9) << touch.name;
    }
}

TEST(Memory, OfAGeneratorIsCorrectedForRealAndNotInACopy) {
    /// Keeps a copy of the body that it acts on.
    class Copier : public ForceGenerator {
    public:
        RigidBody copy;
        void updateForce(RigidBody *body, real) override { copy = *body; }
    };
    World world;
    RigidBody body;
    Copier copier;
    world.addBody(&body);
    world.getForceRegistry().add(&body, &copier);
    runFrame(world);
    RigidBody copies[] = {copier.copy, RigidBody(copier.copy)};
    for (RigidBody &copy : copies) {
        copy.addForce(Vector3(60, 0, 0));  // by the caller: at once and for good
        for (int n = 0; n < 3; ++n) {
            copy.integrate(STEP);
            EXPECT_EQ(copy.getVelocity(), Vector3(1, 0, 0));
        }
    }
}

// ---- What it is for

TEST(Memory, TheStepIsStoermersForPositions) {
    // x₊ = x + (x − x₋)·h₊/h₋ + A·h₊·(h₊ + h₋)/2, for any force and any steps.
    reference::Random random;
    World world;
    RigidBody body;
    Push push;
    body.setMass(2);
    world.addBody(&body);
    world.getForceRegistry().add(&body, &push);
    runFrame(world);
    Vector3 before = Vector3(), now = body.getPosition();
    real last = STEP;
    for (int n = 0; n < 200; ++n) {
        const real h = random.between(0.001, 0.05);
        push.force = random.vector(10);
        body.setAcceleration(random.vector(5));
        const Vector3 a = push.force * 0.5 + body.getAcceleration();
        runFrame(world, h);
        const Vector3 expected = now + (now - before) * (h / last) + a * (h * (h + last) / 2);
        ASSERT_TRUE(isNear(body.getPosition(), expected, 1e-13)) << n;
        before = now;
        now = body.getPosition();
        last = h;
    }
}

TEST(Memory, EveryEvaluationCountsInFullAndTheFirstHalf) {
    for (int pulse : {0, 1, 7}) {
        World world;
        RigidBody body;
        Push push;
        world.addBody(&body);
        world.getForceRegistry().add(&body, &push);
        for (int n = 0; n < 10; ++n) {
            push.force = Vector3(n == pulse ? 60 : 0, 0, 0);
            push.torque = push.force;
            runFrame(world);
        }
        EXPECT_NEAR(body.getVelocity().x, pulse == 0 ? 0.5 : 1, 1e-15) << pulse;
        EXPECT_NEAR(body.getAngularMomentum().x, pulse == 0 ? 0.5 : 1, 1e-15) << pulse;
    }
}

TEST(Memory, AForceThatBeginsIsFeltHalfAStepEarly) {
    RigidBody body;
    body.integrate(STEP);
    body.setAcceleration(6, 0, 0);
    for (int n = 1; n < 5; ++n) {
        body.integrate(STEP);
        EXPECT_NEAR(body.getVelocity().x, 6 * STEP * (n + 0.5), 1e-15);
    }
    body.setAcceleration(0, 0, 0);
    for (int n = 0; n < 5; ++n) {
        body.integrate(STEP);
        EXPECT_NEAR(body.getVelocity().x, 6 * STEP * 4, 1e-15);
    }
}

// ---- What ends it

TEST(Memory, EndsWithSleepWakingAndFaults) {
    const Touch endings[] = {
        {"sleep and waking",
         [](World &, RigidBody &b) {
             b.setAwake(false);
             b.setAwake();
         }},
        {"sleep", [](World &, RigidBody &b) { b.setAwake(false); }},  // the generator wakes it
        {"a fault",
         [](World &w, RigidBody &b) {
             w.startFrame();
             b.addForce(Vector3(QUIET_NAN, 0, 0));
             w.runPhysics(STEP);
             b.setAwake();
         }},
        {"a state without it",
         [](World &, RigidBody &b) {
             RigidBody::State state = b.getState();
             state.memory = RigidBody::Memory();
             b.setState(state);
         }},
    };
    for (const Touch &ending : endings) {
        World world;
        RigidBody body;
        Push push;
        push.force = Vector3(60, 0, 0);
        push.torque = Vector3(0, 60, 0);
        world.addBody(&body);
        world.getForceRegistry().add(&body, &push);
        for (int n = 0; n < 3; ++n) runFrame(world);
        ending.apply(world, body);
        const Vector3 velocity = body.getVelocity(), momentum = body.getAngularMomentum();
        push.force = Vector3(0, 0, 120);
        push.torque = Vector3(0, 0, 120);
        runFrame(world);
        EXPECT_TRUE(isNear(body.getVelocity(), velocity + push.force * STEP, 1e-14)) << ending.name;
        EXPECT_TRUE(isNear(body.getAngularMomentum(), momentum + push.torque * STEP, 1e-14)) << ending.name;
    }
}

// ---- The caller's forces have none

TEST(CallersForce, ActsAsInTheClassicStep) {
    // Symplectic Euler, to the bit, where no generator acts and nothing else accelerates.
    RigidBody body;
    body.setMass(2);
    body.setPosition(1, 2, 3);
    Vector3 velocity, position = body.getPosition();
    for (int n = 0; n < 1000; ++n) {
        const Vector3 force = position * -200.0;
        body.addForce(force);
        ASSERT_TRUE(body.integrate(STEP));
        velocity += force * 0.5 * STEP;
        position += velocity * STEP;
        ASSERT_EQ(body.getVelocity(), velocity);
        ASSERT_EQ(body.getPosition(), position);
        ASSERT_EQ(body.getLastFrameAcceleration(), force * 0.5);
    }
}

TEST(CallersForce, PenaltyGroundGivesNoEnergy) {
    for (real frequency : {0.2, 0.4, 1.0}) {
        RigidBody body;
        body.setPosition(0, 1, 0);
        body.setAcceleration(Vector3::GRAVITY);
        real highest = 0;
        for (int n = 0; n < 6000; ++n) {
            const real depth = -body.getPosition().y;
            if (depth > 0) body.addForce(Vector3(0, std::pow(frequency / STEP, 2) * depth, 0));
            body.integrate(STEP);
            highest = std::max(highest, body.getPosition().y);
        }
        EXPECT_LT(highest, 1.5) << frequency;
    }
}

TEST(CallersForce, SpringIsAsStableAsInTheClassicStep) {
    for (real frequency : {0.1, 0.55, 1.0, 1.5, 1.9}) {
        RigidBody body, turning;
        body.setPosition(1, 0, 0);
        turning.setRotation(0.01, 0, 0);
        const real k = std::pow(frequency / STEP, 2);
        real swing = 0, angle = 0;
        for (int n = 0; n < 20000; ++n) {
            body.addForce(body.getPosition() * -k);
            body.integrate(STEP);
            swing = std::max(swing, real_abs(body.getPosition().x));
            angle = 2 * turning.getOrientation().i;
            turning.addTorque(Vector3(-k * angle, 0, 0));
            turning.integrate(STEP);
            ASSERT_LT(real_abs(angle), 0.01) << frequency;
        }
        // Its energy oscillates by this much, and no more: the invariant is v² + ω²·x² − ω²·h·x·v.
        EXPECT_LT(swing, 1.02 / std::sqrt(1 - frequency * frequency / 4)) << frequency;
    }
}

TEST(CallersForce, FadesOutWithoutATrace) {
    RigidBody body;
    for (int n = 0; n < 600; ++n) {
        body.addForce(Vector3(std::max(0.0, 10 - 0.02 * n), 0, 0));
        const Vector3 before = body.getPosition();
        body.integrate(STEP);
        ASSERT_TRUE(isNear((body.getPosition() - before) * (1 / STEP), body.getVelocity(), 1e-11));
    }
}
