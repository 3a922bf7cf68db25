// Falling asleep and waking.
#include <cyclone/body.h>

#include "reference.h"

using namespace cyclone;

namespace {

/// Seconds until the body sleeps; a hundred if it doesn't.
real timeAwake(RigidBody &body, const std::function<void(RigidBody &)> &act = nullptr) {
    constexpr int STEPS = 6000;
    int n = 0;
    for (; n < STEPS && body.getAwake(); ++n) {
        if (act) act(body);
        body.integrate(1.0 / 60);
    }
    return n / 60.0;
}

RigidBody sleepyBody() {
    RigidBody body;
    body.setCanSleep();
    return body;
}

}  // namespace

TEST(Sleep, ComesWhenAllowedAndIdle) {
    RigidBody wakeful, idle = sleepyBody(), slow = sleepyBody(), fast = sleepyBody(), turning = sleepyBody();
    slow.setVelocity(0.03, 0, 0);
    slow.setRotation(0, 0.04, 0);
    fast.setVelocity(0.2, 0, 0);
    turning.setRotation(0, 0.2, 0);
    EXPECT_EQ(timeAwake(wakeful), 100);
    EXPECT_EQ(timeAwake(fast), 100);
    EXPECT_EQ(timeAwake(turning), 100);
    EXPECT_NEAR(timeAwake(idle), 1, 0.7);
    EXPECT_NEAR(timeAwake(slow), 1, 0.8);
    EXPECT_EQ(slow.getVelocity(), Vector3());
    EXPECT_EQ(slow.getRotation(), Vector3());
    fast.setVelocity(0, 0, 0);
    EXPECT_NEAR(timeAwake(fast), 2, 1.5);
}

TEST(Sleep, DoesNotDependOnTheStep) {
    for (const real h : {0.001, 0.01, 0.1}) {
        RigidBody body = sleepyBody();
        real time = 0;
        while (body.getAwake() && time < 10) {
            body.integrate(h);
            time += h;
        }
        EXPECT_NEAR(time, 0.7, 0.15) << h;
    }
}

TEST(Sleep, NeedsItsTimeAnewAfterWakingAndAChangedLimit) {
    RigidBody body = sleepyBody();
    body.setSleepEpsilon(1);
    EXPECT_NEAR(timeAwake(body), 0.7, 0.15);
    body.setAwake();
    EXPECT_NEAR(timeAwake(body), 0.7, 0.15);
    body.setCanSleep(false);
    EXPECT_EQ(timeAwake(body), 100);
    body.setCanSleep();
    EXPECT_NEAR(timeAwake(body), 0.7, 0.15);
}

TEST(Sleep, DoesNotComeInMidAir) {
    // However slow a body counts as idle, it is awake while something acts on it.
    const auto whileActing = [](const std::function<void(RigidBody &)> &act, const Vector3 &acceleration) {
        RigidBody body = sleepyBody();
        body.setSleepEpsilon(1e12);
        body.setAcceleration(acceleration);
        return timeAwake(body, act);
    };
    EXPECT_EQ(whileActing(nullptr, Vector3::GRAVITY), 100);
    EXPECT_EQ(whileActing([](RigidBody &b) { b.addForce(Vector3(0, 1e-9, 0)); }, Vector3()), 100);
    EXPECT_EQ(whileActing([](RigidBody &b) { b.addTorque(Vector3(1e-9, 0, 0)); }, Vector3()), 100);
    const auto spring = [](RigidBody &b) { b.addForce((b.getPosition() - Vector3(0.01, 0, 0)) * -0.1); };
    EXPECT_EQ(whileActing(spring, Vector3()), 100) << "a slow spring, turning points and all";
    EXPECT_LT(whileActing(nullptr, Vector3()), 2) << "else it would sleep";
}

TEST(Sleep, KeepsABodyWhereItIs) {
    RigidBody body;
    body.setPosition(1, -2, 3);
    body.setVelocity(-1, 0.5, 2);
    body.setRotation(0.3, -0.8, 0.4);
    body.setAcceleration(Vector3::GRAVITY);
    body.setAwake(false);
    EXPECT_FALSE(body.getAwake());
    EXPECT_EQ(body.getVelocity(), Vector3());
    EXPECT_EQ(body.getRotation(), Vector3());
    const Matrix4 transform = body.getTransform();
    EXPECT_TRUE(body.integrate(1));
    EXPECT_EQ(body.getTransform(), transform);
    EXPECT_EQ(body.getVelocity(), Vector3());
}

TEST(Sleep, EndsWhenSomethingActs) {
    struct Event {
        const char *name;
        bool wakes;
        std::function<void(RigidBody &)> make;
    };
    const Event events[] = {
        {"force", true, [](RigidBody &b) { b.addForce(Vector3(0, 0, 1e-30)); }},
        {"force at a point", true, [](RigidBody &b) { b.addForceAtPoint(Vector3::X, Vector3::Y); }},
        {"force at a body point", true, [](RigidBody &b) { b.addForceAtBodyPoint(Vector3::X, Vector3::Y); }},
        {"torque", true, [](RigidBody &b) { b.addTorque(Vector3(0, 1e-30, 0)); }},
        {"setVelocity", true, [](RigidBody &b) { b.setVelocity(0, 1, 0); }},
        {"addVelocity", true, [](RigidBody &b) { b.addVelocity(Vector3::Y); }},
        {"setRotation", true, [](RigidBody &b) { b.setRotation(0, 1, 0); }},
        {"addRotation", true, [](RigidBody &b) { b.addRotation(Vector3::Y); }},
        {"setAwake", true, [](RigidBody &b) { b.setAwake(); }},
        {"forbidding sleep", true, [](RigidBody &b) { b.setCanSleep(false); }},
        {"no force", false, [](RigidBody &b) { b.addForce(Vector3()); }},
        {"no velocity", false, [](RigidBody &b) { b.addVelocity(Vector3()); }},
        {"clearing forces", false, [](RigidBody &b) { b.clearAccumulators(); }},
    };
    for (const Event &event : events) {
        RigidBody body = sleepyBody();
        ASSERT_LT(timeAwake(body), 2);
        event.make(body);
        EXPECT_EQ(body.getAwake(), event.wakes) << event.name;
        body.integrate(1.0 / 60);
        EXPECT_EQ(body.getAwake(), event.wakes) << event.name << ", a step later";
    }
}

TEST(Sleep, ComesAtTheSameStepAfterRestoring) {
    RigidBody body = sleepyBody(), restored;
    for (int n = 0; n < 20; ++n) body.integrate(1.0 / 60);
    restored.setState(body.getState());
    EXPECT_EQ(timeAwake(restored), timeAwake(body));
}
