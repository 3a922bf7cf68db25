#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

using namespace cyclone;

namespace {

constexpr real STEP = 1.0 / 60;

/// The greatest displacement in the last ten seconds of a minute, of a body that a spring of k = ω² swings by
/// 1 m.
real amplitudeAfterAMinute(const std::function<void(RigidBody &)> &frame, const Vector3 &position,
                           const Vector3 &velocity) {
    RigidBody body;
    body.setPosition(position);
    body.setVelocity(velocity);
    real amplitude = 0;
    for (int n = 0; n < 3600; ++n) {
        frame(body);
        if (n >= 3000) amplitude = std::max(amplitude, real_abs(body.getPosition().x));
    }
    return amplitude;
}

/// A spring that the caller adds in each frame neither grows nor dies out, wherever it starts.
TEST(CallersSpring, KeepsItsAmplitude) {
    for (real frequency : {1.0, 3.0, 10.0, 15.0}) {
        const auto frame = [frequency](RigidBody &body) {
            body.addForce(body.getPosition() * (-frequency * frequency));
            body.integrate(STEP);
        };
        EXPECT_NEAR(amplitudeAfterAMinute(frame, Vector3(1, 0, 0), Vector3()), 1, 0.05) << frequency;
        EXPECT_NEAR(amplitudeAfterAMinute(frame, Vector3(), Vector3(frequency, 0, 0)), 1, 0.05) << frequency;
    }
}

/// Not even when a setter makes every step start afresh.
TEST(CallersSpring, SurvivesASetterInEveryFrame) {
    for (real frequency : {3.0, 10.0}) {
        const auto frame = [frequency](RigidBody &body) {
            body.addForce(body.getPosition() * (-frequency * frequency));
            body.addVelocity(Vector3(0, 1e-9, 0));
            body.integrate(STEP);
        };
        EXPECT_NEAR(amplitudeAfterAMinute(frame, Vector3(1, 0, 0), Vector3()), 1, 0.05) << frequency;
    }
}

/// The same as a torque: a body on a torsion spring about Y, its angle small.
TEST(CallersTorsionSpring, KeepsItsAmplitude) {
    RigidBody body;
    body.setInertiaTensor(Matrix3(2, 0, 0, 0, 3, 0, 0, 0, 4));
    body.setRotation(0, 0.5, 0);
    real amplitude = 0;
    for (int n = 0; n < 3600; ++n) {
        const real angle = 2 * body.getOrientation().j * (body.getOrientation().r < 0 ? -1 : 1);
        body.addTorque(Vector3(0, -3 * 25 * angle, 0));
        body.integrate(STEP);
        if (n >= 3480) amplitude = std::max(amplitude, real_abs(angle));
    }
    EXPECT_NEAR(amplitude, 0.1, 0.005);  // ω = 5 rad/s
}

/// A constant force that the caller adds moves the body on the parabola, exactly, whatever the steps.
TEST(CallersForce, ConstantIsExact) {
    RigidBody body;
    real time = 0;
    for (int n = 0; n < 600; ++n) {
        const real step = STEP * (1 + n % 3);
        body.addForce(Vector3(0, -9.81, 0));
        body.integrate(step);
        time += step;
        ASSERT_NEAR(body.getVelocity().y, -9.81 * time, 1e-11 * (1 + time));
        ASSERT_NEAR(body.getPosition().y, -9.81 * time * time / 2, 1e-11 * (1 + time * time));
    }
}

/// A kick amid forces that go on is felt in full by velocity and position alike.
TEST(CallersForce, KickIsNotSmoothedAway) {
    RigidBody kicked, plain;
    for (int n = 0; n < 120; ++n) {
        for (RigidBody *body : {&kicked, &plain}) body->addForce(Vector3(0, 9.81, 0));
        if (n == 30) kicked.addForce(Vector3(600, 0, 0));
        kicked.integrate(STEP);
        plain.integrate(STEP);
    }
    EXPECT_NEAR(kicked.getVelocity().x, 600 * STEP, 1e-12);
    EXPECT_NEAR(kicked.getPosition().x, 600 * STEP * (89.5 * STEP), 1e-9);
    EXPECT_NEAR(kicked.getPosition().y, plain.getPosition().y, 1e-9);
}

/// A registered spring keeps its amplitude even when a setter makes every step start afresh.
TEST(RegisteredSpring, SurvivesASetterInEveryFrame) {
    const std::function<void(RigidBody &)> setters[] = {
        [](RigidBody &) {},
        [](RigidBody &body) { body.addVelocity(Vector3(0, 1e-9, 0)); },
        [](RigidBody &body) { body.setOrientation(body.getOrientation()); },
        [](RigidBody &body) { body.setMass(body.getMass()); },
    };
    for (real frequency : {3.0, 10.0})
        for (const auto &setter : setters) {
            World world;
            AnchoredSpring spring(Vector3(), Vector3(), frequency * frequency, 0);
            RigidBody *const body = world.createBody();
            body->setPosition(1, 0, 0);
            world.getForceRegistry().add(body, &spring);
            real amplitude = 0;
            for (int n = 0; n < 3600; ++n) {
                world.startFrame();
                setter(*body);
                world.runPhysics(STEP);
                if (n >= 3540) amplitude = std::max(amplitude, real_abs(body->getPosition().x));
            }
            EXPECT_NEAR(amplitude, 1, 0.05) << frequency;
        }
}

/// A faulted body stays asleep and listed under generators' forces, until the caller wakes it.
TEST(Faulted, IsNotWokenByForces) {
    World world;
    Gravity gravity;
    RigidBody *const body = world.createBody();
    world.getForceRegistry().add(body, &gravity);
    const auto frame = [&world](real poison) {
        world.startFrame();
        if (poison != 0) world.getBodies()[0]->addForce(Vector3(poison, 0, 0));
        world.runPhysics(STEP);
    };
    frame(0);
    const Vector3 position = body->getPosition(), velocity = body->getVelocity();
    frame(1 / (1 - real(1)));
    for (int n = 0; n < 3; ++n) {
        frame(0);
        EXPECT_EQ(world.getFaultedBodies(), World::RigidBodies{body});
        EXPECT_FALSE(body->getAwake());
        EXPECT_EQ(body->getPosition(), position);
        EXPECT_EQ(body->getVelocity(), velocity);
    }
    body->setAwake(true);
    frame(0);
    EXPECT_TRUE(world.getFaultedBodies().empty());
    EXPECT_NEAR(body->getVelocity().y, velocity.y - 9.81 * STEP, 1e-12);
}

/// What would pull the frame from under a generator is refused to it.
TEST(FrameCalls, AreRefusedToGenerators) {
    class Meddler : public ForceGenerator {
    public:
        explicit Meddler(World &w) : world(w) {}
        std::function<void(World &)> deed;
        void updateForce(RigidBody *, real) override { deed(world); }

    private:
        World &world;
    };
    World world;
    Snapshot snapshot;
    RigidBody *const body = world.createBody();
    world.saveState(snapshot);
    Meddler meddler(world);
    world.getForceRegistry().add(body, &meddler);
    const std::function<void(World &)> deeds[] = {
        [](World &w) { w.startFrame(); },     [](World &w) { w.integrate(STEP); },
        [](World &w) { w.runPhysics(STEP); }, [&snapshot](World &w) { w.restoreState(snapshot); },
        [](World &w) { w.setWorkers(2); },    [](World &w) { w.setJobSystem(nullptr); },
    };
    for (const auto &deed : deeds) {
        meddler.deed = deed;
        world.startFrame();
        EXPECT_THROW(world.runPhysics(STEP), std::invalid_argument);
        EXPECT_EQ(body->getPosition(), Vector3());
    }
}

}  // namespace
