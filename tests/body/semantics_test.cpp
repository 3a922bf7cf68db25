// What a game relies on, whatever the step's mathematics.
#include <cyclone/cyclone.h>

#include "reference.h"

using namespace cyclone;
using cyclone_test::diagonal;
using cyclone_test::isNear;
using cyclone_test::PLUS_INFINITY;
using cyclone_test::QUIET_NAN;

namespace {

constexpr real STEP = 1.0 / 60;

/// Pulls a body to the origin and upright, with friction.
class Pull : public ForceGenerator {
public:
    static Vector3 force(const RigidBody &body) {
        return body.getPosition() * -8 + body.getVelocity() * -0.5 + Vector3(1, 2, 3);
    }
    static Vector3 torque(const RigidBody &body) {
        return (body.getDirectionInWorldSpace(Vector3::Y) % Vector3::Y) * 4 + body.getRotation() * -0.3;
    }
    void updateForce(RigidBody *body, real) override {
        body->addForce(force(*body));
        body->addTorque(torque(*body));
    }
};

/// Adds what it is told.
class Push : public ForceGenerator {
public:
    Vector3 force, torque;
    void updateForce(RigidBody *body, real) override {
        body->addForce(force);
        body->addTorque(torque);
    }
};

/// A body that a generator has been acting on for a while.
struct Scene {
    World world;
    RigidBody body;
    Pull pull;

    Scene() {
        body.setMass(2);
        body.setInertiaTensor(diagonal(0.3, 0.5, 0.4));
        body.setAcceleration(Vector3::GRAVITY);
        body.setPosition(1, -2, 0.5);
        body.setVelocity(3, 1, -2);
        body.setRotation(0.5, -0.7, 1.1);
        world.addBody(&body);
        registry().add(&body, &pull);
        for (int n = 0; n < 30; ++n) frame();
    }
    ForceRegistry &registry() { return world.getForceRegistry(); }

    void frame(real duration = STEP) {
        world.startFrame();
        world.runPhysics(duration);
    }
};

/// To the last bit.
bool isSameMotion(const RigidBody &a, const RigidBody &b) {
    return a.getTransform() == b.getTransform() && a.getOrientation() == b.getOrientation() &&
           a.getVelocity() == b.getVelocity() && a.getRotation() == b.getRotation() &&
           a.getAngularMomentum() == b.getAngularMomentum();
}

}  // namespace

// ---- A force of one frame

TEST(ForceOfOneFrame, ChangesVelocityAtOnceAndForGood) {
    reference::Random random;
    for (int trial = 0; trial < 100; ++trial) {
        RigidBody body;
        const real mass = random.logBetween(0.01, 100), h = random.logBetween(1e-4, 0.5);
        const Vector3 force = random.vector(10), torque = random.vector(10), velocity = random.vector(10);
        body.setMass(mass);
        body.setVelocity(velocity);
        body.addForce(force);
        body.addTorque(torque);
        const Vector3 expected = velocity + force * (h / mass);
        for (int n = 0; n < 4; ++n) {
            body.integrate(h);
            ASSERT_TRUE(isNear(body.getVelocity(), expected, 1e-15 * (10 + expected.magnitude())));
            ASSERT_TRUE(isNear(body.getAngularMomentum(), torque * h, 1e-14));
        }
    }
}

TEST(ForceOfOneFrame, CountsTheSameBesideGenerators) {
    // The generator's push changes with time alone, so that the difference stays what it was.
    const Vector3 force(30, -20, 10), torque(-1, 3, 2);
    World world;
    RigidBody plain, kicked;
    Push push;
    for (RigidBody *body : {&plain, &kicked}) {
        body->setMass(2);
        world.addBody(body);
        world.getForceRegistry().add(body, &push);
    }
    for (int n = 0; n < 60; ++n) {
        push.force = Vector3(std::sin(0.1 * n), 2, std::cos(0.2 * n));
        push.torque = Vector3(1, std::sin(0.3 * n), 0);
        world.startFrame();
        if (n == 20) {
            kicked.addForce(force);
            kicked.addTorque(torque);
        }
        world.runPhysics(STEP);
        const bool done = n >= 20;
        ASSERT_TRUE(isNear(kicked.getVelocity() - plain.getVelocity(), force * (done * STEP / 2), 1e-14))
            << n;
        ASSERT_TRUE(
            isNear(kicked.getAngularMomentum() - plain.getAngularMomentum(), torque * (done * STEP), 1e-14))
            << n;
    }
}

TEST(ForceOfOneFrame, HasNoEchoWhereForcesDependOnTheMotion) {
    Scene plain, kicked;
    const Vector3 force(60, -30, 90), torque(-3, 1, 2);
    kicked.world.startFrame();
    kicked.body.addForce(force);
    kicked.body.addTorque(torque);
    kicked.world.runPhysics(STEP);
    plain.frame();
    const auto gain = [&] { return kicked.body.getVelocity() - plain.body.getVelocity(); };
    const auto twist = [&] { return kicked.body.getAngularMomentum() - plain.body.getAngularMomentum(); };
    EXPECT_TRUE(isNear(gain(), force * (STEP / 2), 1e-14));
    EXPECT_TRUE(isNear(twist(), torque * STEP, 1e-14));
    for (int n = 0; n < 2; ++n) {
        kicked.frame();
        plain.frame();
        EXPECT_LT((gain() - force * (STEP / 2)).magnitude(), 0.03 * gain().magnitude());
        EXPECT_LT((twist() - torque * STEP).magnitude(), 0.05 * twist().magnitude());
    }
}

TEST(ForceOfOneFrame, CountsPlainlyAfterAGeneratorHasEndedItself) {
    class Once : public ForceGenerator {
    public:
        ForceRegistry *registry = nullptr;
        void updateForce(RigidBody *body, real) override { registry->remove(body, this); }
    };
    World world;
    RigidBody body;
    Push steady;
    Once once;
    once.registry = &world.getForceRegistry();
    world.addBody(&body);
    world.getForceRegistry().add(&body, &steady);
    world.getForceRegistry().add(&body, &once);
    for (int n = 0; n < 10; ++n) {
        world.startFrame();
        if (n == 1) body.addForce(Vector3(6, 0, 0));
        world.runPhysics(STEP);
        ASSERT_TRUE(isNear(body.getVelocity(), Vector3(n >= 1 ? 6 * STEP : 0, 0, 0), 1e-15)) << n;
    }
}

// ---- Impulses and states

TEST(Impulse, ActsAtOnce) {
    RigidBody body;
    body.setInertiaTensor(diagonal(2, 3, 4));
    body.setVelocity(1, 0, 0);
    body.setRotation(0, 1, 0);
    body.addVelocity(Vector3(1, 2, 3));
    body.addRotation(Vector3(-1, 1, 2));
    EXPECT_EQ(body.getVelocity(), Vector3(2, 2, 3));
    EXPECT_EQ(body.getRotation(), Vector3(-1, 2, 2));
    EXPECT_EQ(body.getAngularMomentum(), Vector3(-2, 6, 8));
    body.integrate(STEP);
    EXPECT_EQ(body.getVelocity(), Vector3(2, 2, 3));
    EXPECT_EQ(body.getAngularMomentum(), Vector3(-2, 6, 8));
}

TEST(RestoredState, RunsToTheSameBits) {
    Scene scene;
    const RigidBody::State saved = scene.body.getState();
    for (int n = 0; n < 50; ++n) scene.frame();
    const RigidBody first = scene.body;
    scene.body = RigidBody();
    scene.body.setState(saved);
    for (int n = 0; n < 50; ++n) scene.frame();
    EXPECT_TRUE(isSameMotion(scene.body, first));
}

// ---- Durations

TEST(ZeroDuration, DoesNothing) {
    Scene paused, plain;
    for (Scene *scene : {&paused, &plain}) {
        scene->body.setDamping(0.3, 0.4);
        for (int n = 0; n < 5; ++n) scene->frame();
    }
    const RigidBody before = paused.body;
    for (int n = 0; n < 3; ++n) paused.frame(0);
    EXPECT_TRUE(isSameMotion(paused.body, before));
    for (int n = 0; n < 5; ++n) {
        paused.frame();
        plain.frame();
    }
    EXPECT_TRUE(isSameMotion(paused.body, plain.body));
}

TEST(ZeroDuration, DropsTheForcesOfEachBody) {
    RigidBody first, second;
    RigidBody *const bodies[] = {&first, &second};
    for (RigidBody *body : bodies) body->addForce(Vector3(1, 2, 3));
    RigidBody::integrate(bodies, 2, 0);
    RigidBody::integrate(bodies, 2, STEP);
    for (const RigidBody *body : bodies) EXPECT_EQ(body->getVelocity(), Vector3());
}

TEST(ZeroDuration, DoesNothingAfterTheDampingIsSet) {
    RigidBody body;
    body.setVelocity(1, 2, 3);
    body.setRotation(3, 2, 1);
    body.setDamping(0.5, 0.5);
    body.integrate(0.1);
    body.setDamping(0.9, 0.9);
    const RigidBody before = body;
    body.integrate(0);
    EXPECT_TRUE(isSameMotion(body, before));
}

TEST(Damping, LeavesTheSameForAnySplitOfTheSecond) {
    reference::Random random;
    for (const real damping : {0.9, 0.5, 1e-3, 1.0}) {
        RigidBody body;
        body.setInertiaTensor(diagonal(2, 2, 2));
        body.setDamping(damping, damping / 2);
        body.setVelocity(1, -2, 3);
        body.setRotation(-3, 1, 2);
        const int steps = 1 + random.below(200);
        real left = 1;
        for (int n = 1; n < steps; ++n) {
            const real h = random.between(0, 2 * left / (steps - n + 1));
            body.integrate(h);
            left -= h;
        }
        body.integrate(left);
        EXPECT_TRUE(isNear(body.getVelocity(), Vector3(1, -2, 3) * damping, 1e-12 * damping)) << steps;
        EXPECT_TRUE(isNear(body.getRotation(), Vector3(-3, 1, 2) * (damping / 2), 1e-12 * damping)) << steps;
    }
}

TEST(Damping, CountsFromTheNextStepOn) {
    RigidBody body;
    body.setVelocity(1, 0, 0);
    body.setRotation(0, 1, 0);
    real linear = 1, angular = 1;
    for (const real damping : {0.5, 0.9, 0.1}) {
        body.setDamping(damping, 1 - damping);
        body.integrate(0.5);
        linear *= std::sqrt(damping);
        angular *= std::sqrt(1 - damping);
        EXPECT_TRUE(isNear(body.getVelocity(), Vector3(linear, 0, 0), 1e-15));
        EXPECT_TRUE(isNear(body.getRotation(), Vector3(0, angular, 0), 1e-15));
    }
}

TEST(Damping, OfOneKindMayChangeAlone) {
    RigidBody body;
    body.setVelocity(1, 0, 0);
    body.setRotation(0, 1, 0);
    body.setDamping(0.5, 0.9);
    body.integrate(1);
    body.setDamping(0.5, 0.1);
    body.integrate(1);
    body.setDamping(0.2, 0.1);
    body.integrate(1);
    EXPECT_TRUE(isNear(body.getVelocity(), Vector3(0.5 * 0.5 * 0.2, 0, 0), 1e-15));
    EXPECT_TRUE(isNear(body.getRotation(), Vector3(0, 0.9 * 0.1 * 0.1, 0), 1e-15));
}

TEST(Damping, OfZeroStopsAtOnce) {
    RigidBody body;
    body.setDamping(0, 0);
    body.setVelocity(1, 2, 3);
    body.setRotation(1, 2, 3);
    EXPECT_TRUE(body.integrate(STEP));
    EXPECT_EQ(body.getVelocity(), Vector3());
    EXPECT_EQ(body.getRotation(), Vector3());
    EXPECT_EQ(body.getPosition(), Vector3());
}

// ---- Faults

TEST(Fault, KeepsTheStateExactly) {
    const Vector3 poisons[] = {Vector3(QUIET_NAN, 0, 0), Vector3(0, PLUS_INFINITY, 0),
                               Vector3(0, 0, -PLUS_INFINITY), Vector3(REAL_MAX, 0, 0)};
    for (const Matrix3 &inverseTensor : {diagonal(3, 4, 2), diagonal(3, 0, 2)})
        for (const Vector3 &poison : poisons)
            for (const bool asTorque : {false, true}) {
                RigidBody body;
                body.setMass(1e-3);
                body.setInverseInertiaTensor(inverseTensor);
                body.setVelocity(1, 2, 3);
                body.setRotation(3, 2, 1);
                body.integrate(STEP);
                const RigidBody before = body;
                asTorque ? body.addTorque(poison * 1000) : body.addForce(poison);
                EXPECT_FALSE(body.integrate(1000));
                EXPECT_TRUE(isSameMotion(body, before));
                EXPECT_FALSE(body.getAwake());
                EXPECT_TRUE(body.hasFaulted());
                EXPECT_EQ(body.getState().memory.linearKick, 0) << "nothing is remembered";
                EXPECT_EQ(body.getState().memory.angularKick, 0) << "nothing is remembered";
                EXPECT_TRUE(body.integrate(STEP)) << "asleep";
                EXPECT_TRUE(isSameMotion(body, before));
            }
}

TEST(Fault, IsOverWhenTheBodyIsWoken) {
    RigidBody body, sound;
    for (RigidBody *each : {&body, &sound}) {
        each->setInertiaTensor(diagonal(1, 2, 3));
        each->setVelocity(1, 2, 3);
        each->setRotation(3, 2, 1);
    }
    body.addForceAtBodyPoint(Vector3(QUIET_NAN, 1, 2), Vector3(1, 1, 1));
    EXPECT_FALSE(body.integrate(STEP));
    body.setAwake();
    EXPECT_FALSE(body.hasFaulted());
    for (int n = 0; n < 10; ++n) {
        EXPECT_TRUE(body.integrate(STEP));
        sound.integrate(STEP);
    }
    EXPECT_TRUE(isSameMotion(body, sound));
}

TEST(Fault, OfAGeneratorIsNotRememberedByAnImmovableBody) {
    World world;
    RigidBody body;
    Push push;
    push.force = push.torque = Vector3(QUIET_NAN, PLUS_INFINITY, 0);
    body.setInverseMass(0);
    world.addBody(&body);
    world.getForceRegistry().add(&body, &push);
    world.startFrame();
    world.runPhysics(STEP);
    EXPECT_FALSE(body.hasFaulted()) << "no force moves it";
    world.getForceRegistry().clear();
    body.setMass(1);
    body.setAcceleration(1, 0, 0);
    world.startFrame();
    world.runPhysics(STEP);
    EXPECT_FALSE(body.hasFaulted());
    EXPECT_TRUE(isNear(body.getVelocity(), Vector3(STEP, 0, 0), 1e-16));
}
