#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "random.h"

using namespace cyclone;
using cyclone_test::PLUS_INFINITY;
using cyclone_test::QUIET_NAN;
using cyclone_test::Random;
using State = RigidBody::State;

namespace {

/// A state whose every field differs from the default and could be a little different yet.
State unusualState() {
    State s;
    Random random(3);
    s.orientation = random.orientation();
    s.principalAxes = random.orientation();
    for (Vector3 *v : {&s.position, &s.velocity, &s.rotation, &s.angularMomentum, &s.acceleration,
                       &s.lastFrameAcceleration, &s.addedForce, &s.addedTorque, &s.generatedForce,
                       &s.generatedTorque, &s.lastForce, &s.lastTorque, &s.addedForces.last,
                       &s.addedForces.change, &s.addedTorques.last, &s.addedTorques.change})
        *v = random.vector(10);
    s.inertia = Vector3(2, 4, 3);
    s.inverseInertia = Vector3(1.0 / 2, 1.0 / 4, 1.0 / 3);
    s.addedForces.greatestSquare = 7;
    s.addedTorques.greatestSquare = 8;
    s.mass = 5;
    s.inverseMass = 1.0 / 5;
    s.lastDuration = 0.02;
    s.linearDamping = 0.7;
    s.angularDamping = 0.6;
    s.motion = 0.3;
    s.sleepEpsilon = 0.2;
    s.canSleep = s.hasAdded = s.isGenerated = s.startsAfresh = s.hasStartedAfresh = s.wasAdded =
        s.hasAddedAfresh = true;
    return s;
}

/// Calls `visit` with the name and the address of every number, and every flag. Does not compile when a
/// member has been added or removed: then snapshot.cpp, getState and setState want a look too.
void forEachField(State &s, const std::function<void(const char *, real *, bool *)> &visit) {
    auto &[position, orientation, velocity, rotation, angularMomentum, acceleration, lastFrameAcceleration,
           addedForce, addedTorque, generatedForce, generatedTorque, lastForce, lastTorque, lastDuration,
           addedForces, addedTorques, mass, inverseMass, inertia, inverseInertia, principalAxes,
           linearDamping, angularDamping, motion, sleepEpsilon, awake, canSleep, faulted, hasAdded,
           isGenerated, startsAfresh, hasStartedAfresh, wasAdded, hasAddedAfresh] = s;
    const auto vector = [&](const char *name, Vector3 &v) {
        for (real *number : {&v.x, &v.y, &v.z}) visit(name, number, nullptr);
    };
    const auto quaternion = [&](const char *name, Quaternion &q) {
        for (real *number : {&q.r, &q.i, &q.j, &q.k}) visit(name, number, nullptr);
    };
    vector("position", position);
    quaternion("orientation", orientation);
    vector("velocity", velocity);
    vector("rotation", rotation);
    vector("angularMomentum", angularMomentum);
    vector("acceleration", acceleration);
    vector("lastFrameAcceleration", lastFrameAcceleration);
    vector("addedForce", addedForce);
    vector("addedTorque", addedTorque);
    vector("generatedForce", generatedForce);
    vector("generatedTorque", generatedTorque);
    vector("lastForce", lastForce);
    vector("lastTorque", lastTorque);
    visit("lastDuration", &lastDuration, nullptr);
    for (RigidBody::Course *course : {&addedForces, &addedTorques}) {
        auto &[last, change, greatestSquare] = *course;
        vector("added forces' last", last);
        vector("added forces' change", change);
        visit("added forces' greatestSquare", &greatestSquare, nullptr);
    }
    visit("mass", &mass, nullptr);
    visit("inverseMass", &inverseMass, nullptr);
    vector("inertia", inertia);
    vector("inverseInertia", inverseInertia);
    quaternion("principalAxes", principalAxes);
    visit("linearDamping", &linearDamping, nullptr);
    visit("angularDamping", &angularDamping, nullptr);
    visit("motion", &motion, nullptr);
    visit("sleepEpsilon", &sleepEpsilon, nullptr);
    visit("awake", nullptr, &awake);
    visit("canSleep", nullptr, &canSleep);
    visit("faulted", nullptr, &faulted);
    visit("hasAdded", nullptr, &hasAdded);
    visit("isGenerated", nullptr, &isGenerated);
    visit("startsAfresh", nullptr, &startsAfresh);
    visit("hasStartedAfresh", nullptr, &hasStartedAfresh);
    visit("wasAdded", nullptr, &wasAdded);
    visit("hasAddedAfresh", nullptr, &hasAddedAfresh);
}

/// All bits of a state, in the order of forEachField.
std::vector<std::uint64_t> bitsOf(State s) {
    std::vector<std::uint64_t> result;
    forEachField(s, [&](const char *, const real *number, const bool *flag) {
        std::uint64_t bits = flag != nullptr && *flag ? 1 : 0;
        if (number != nullptr) std::memcpy(&bits, number, sizeof bits);
        result.push_back(bits);
    });
    return result;
}

TEST(BodyState, ComesBackBitByBit) {
    RigidBody body;
    EXPECT_EQ(bitsOf(body.getState()), bitsOf(State()));
    body.setState(unusualState());
    EXPECT_EQ(bitsOf(body.getState()), bitsOf(unusualState()));
    EXPECT_EQ(body.getPointInWorldSpace(Vector3()), unusualState().position);
    EXPECT_EQ(body.getTransform(),
              cyclone_test::rigidTransform(unusualState().orientation, unusualState().position));
    body.setState(State());
    EXPECT_EQ(bitsOf(body.getState()), bitsOf(State()));
}

/// The last bit of every number, and every flag, is in the snapshot and in the hash, and comes back from it.
TEST(BodyState, EveryFieldCounts) {
    RigidBody body, restored;
    RigidBody *const bodies[] = {&body}, *const restoredBodies[] = {&restored};
    body.setState(unusualState());
    std::vector<std::uint64_t> hashes = {hashStates(bodies, 1)};
    std::vector<Snapshot> snapshots(1);
    writeSnapshot(bodies, 1, snapshots[0]);

    std::size_t count = 0;
    State dummy;
    forEachField(dummy, [&](const char *, real *, bool *) { ++count; });
    EXPECT_EQ(count, 71U + 9U);
    for (std::size_t changed = 0; changed < count; ++changed) {
        State state = unusualState();
        std::size_t n = 0;
        const char *name = nullptr;
        forEachField(state, [&](const char *field, real *number, bool *flag) {
            if (n++ != changed) return;
            name = field;
            if (number != nullptr) *number = std::nextafter(*number, 100.0);
            if (flag != nullptr) *flag = !*flag;
        });
        body.setState(state);
        EXPECT_EQ(bitsOf(body.getState()), bitsOf(state)) << name;
        EXPECT_EQ(std::count(hashes.begin(), hashes.end(), hashStates(bodies, 1)), 0) << name;
        hashes.push_back(hashStates(bodies, 1));
        Snapshot snapshot;
        writeSnapshot(bodies, 1, snapshot);
        EXPECT_EQ(std::count(snapshots.begin(), snapshots.end(), snapshot), 0) << name;
        snapshots.push_back(snapshot);
        readSnapshot(snapshot, restoredBodies, 1);
        EXPECT_EQ(bitsOf(restored.getState()), bitsOf(state)) << name;
    }
}

/// What the body has computed from another state's damping and inertia must not survive.
TEST(BodyState, OfAnotherDampingAndInertiaStepsAsBefore) {
    RigidBody body;
    body.setVelocity(1, 2, 3);
    body.setRotation(3, 2, 1);
    body.setDamping(0.5, 0.4);
    body.setInertiaTensor(Matrix3(0.5, 0.05, 0.1, 0.05, 0.4, 0, 0.1, 0, 0.6));
    body.integrate(0.02);
    const State before = body.getState();
    body.integrate(0.02);
    const State after = body.getState();

    body.setDamping(0.9, 0.8);
    body.setInertiaTensor(cyclone_test::diagonal(1, 3, 2));
    body.integrate(0.02);
    body.setState(before);
    body.integrate(0.02);
    EXPECT_EQ(bitsOf(body.getState()), bitsOf(after));
}

TEST(BodyState, HashDependsOnOrderAndNumber) {
    RigidBody a, b;
    b.setPosition(1, 0, 0);
    RigidBody *const ab[] = {&a, &b}, *const ba[] = {&b, &a};
    EXPECT_NE(hashStates(ab, 2), hashStates(ba, 2));
    EXPECT_NE(hashStates(ab, 1), hashStates(ab, 2));
    EXPECT_NE(hashStates(ab, 0), hashStates(ab, 1));
    EXPECT_EQ(hashStates(ab, 1), hashStates(ba + 1, 1));
}

TEST(BodyState, ThatNoBodyCanBeInIsRefused) {
    const struct {
        const char *word;
        void (*spoil)(State &);
    } cases[] = {
        {"position", [](State &s) { s.position.y = QUIET_NAN; }},
        {"orientation", [](State &s) { s.orientation.r += 1e-6; }},
        {"orientation", [](State &s) { s.orientation = Quaternion(0, 0, 0, 0); }},
        {"velocity", [](State &s) { s.velocity.x = PLUS_INFINITY; }},
        {"rotation", [](State &s) { s.rotation.x = QUIET_NAN; }},
        {"angular momentum", [](State &s) { s.angularMomentum.z = -PLUS_INFINITY; }},
        {"acceleration", [](State &s) { s.acceleration.x = QUIET_NAN; }},
        {"last step's forces", [](State &s) { s.lastForce.x = QUIET_NAN; }},
        {"last step's forces", [](State &s) { s.lastTorque.z = PLUS_INFINITY; }},
        {"last step's duration", [](State &s) { s.lastDuration = -0.01; }},
        {"mass", [](State &s) { s.mass = 0; }},
        {"mass", [](State &s) { s.mass = QUIET_NAN; }},
        {"inverse mass", [](State &s) { s.inverseMass = -1; }},
        {"moments of inertia", [](State &s) { s.inverseInertia.y = -1; }},
        {"moments of inertia", [](State &s) { s.inertia.z *= 1.001; }},
        {"moments of inertia", [](State &s) { s.inertia.x = s.inverseInertia.x = 0; }},
        {"principal axes", [](State &s) { s.principalAxes = Quaternion(1, 1, 0, 0); }},
        {"damping", [](State &s) { s.linearDamping = 1.01; }},
        {"damping", [](State &s) { s.angularDamping = QUIET_NAN; }},
        {"motion", [](State &s) { s.motion = -1; }},
        {"sleep limit", [](State &s) { s.sleepEpsilon = PLUS_INFINITY; }},
    };
    for (const auto &c : cases) {
        State state = unusualState();
        ASSERT_EQ(state.findError(), nullptr);
        c.spoil(state);
        ASSERT_NE(state.findError(), nullptr) << c.word;
        EXPECT_NE(std::string(state.findError()).find(c.word), std::string::npos) << state.findError();
        RigidBody body;
        body.setVelocity(1, 2, 3);
        const std::vector<std::uint64_t> before = bitsOf(body.getState());
        EXPECT_THROW(body.setState(state), std::invalid_argument) << c.word;
        EXPECT_EQ(bitsOf(body.getState()), before) << c.word;
    }
}

}  // namespace
