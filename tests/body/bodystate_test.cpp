#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "../../src/state.h"
#include "random.h"

using namespace cyclone;
using cyclone_test::PLUS_INFINITY;
using cyclone_test::QUIET_NAN;
using cyclone_test::Random;
using State = RigidBody::State;

namespace {

/// A state whose every number differs from the default.
State unusualState() {
    Random random(3);
    RigidBody body;
    const Matrix3 tilt = cyclone_test::rotationMatrix(random.orientation());
    body.setMass(5);
    body.setInertiaTensor(tilt * cyclone_test::diagonal(2, 4, 3) * tilt.transpose());
    body.setOrientation(random.orientation());
    body.setRotation(random.vector(10));
    State s = body.getState();
    for (Vector3 *v :
         {&s.position, &s.velocity, &s.acceleration, &s.lastFrameAcceleration, &s.added.force,
          &s.added.torque, &s.generated.force, &s.generated.torque, &s.memory.acceleration, &s.memory.torque})
        *v = random.vector(10);
    s.memory.linearKick = 0.02;
    s.memory.angularKick = 0.03;
    s.linearDamping = 0.7;
    s.angularDamping = 0.6;
    s.motion = 0.3;
    s.sleepEpsilon = 0.2;
    s.canSleep = true;
    return s;
}

/// Calls `visit` with the address of every number, or of every flag.
void forEachMember(State &s, const std::function<void(real *, bool *)> &visit) {
    cyclone::detail::StateMembers::visitNumbers(s, [&](auto &member) {
        if constexpr (std::is_same_v<decltype(member), bool &>)
            visit(nullptr, &member);
        else if constexpr (std::is_same_v<decltype(member), std::uint8_t &>)  // the locked directions
            for (unsigned bit = 1; bit < 8; bit *= 2) {
                bool flag = (member & bit) != 0;
                visit(nullptr, &flag);
            }
        else
            visit(&member, nullptr);
    });
}

/// All bits of a state, in the order of forEachMember.
std::vector<std::uint64_t> bitsOf(State s) {
    std::vector<std::uint64_t> result;
    forEachMember(s, [&](const real *number, const bool *flag) {
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
TEST(BodyState, EveryMemberCounts) {
    RigidBody body, restored;
    RigidBody *const bodies[] = {&body}, *const restoredBodies[] = {&restored};
    body.setState(unusualState());
    std::vector<std::uint64_t> hashes = {hashStates(bodies, 1)};
    std::vector<Snapshot> snapshots(1);
    writeSnapshot(bodies, 1, snapshots[0]);

    std::vector<std::function<void(State &)>> changes = {
        [](State &s) { s.canSleep = false; },
        [](State &s) { s.awake = false, s.faulted = true; },
        [](State &s) { s.mass *= 3, s.inverseMass = 1 / s.mass; },
        [](State &s) { s.inverseMass *= 3, s.mass = 1 / s.inverseMass; },
    };
    for (unsigned axis = 0; axis < 3; ++axis) {
        changes.push_back([axis](State &s) {
            s.inertia[axis] *= 1 + 1e-12;
            s.inverseInertia[axis] = 1 / s.inertia[axis];
        });
        changes.push_back([axis](State &s) {
            for (unsigned n = 0; n < 3; ++n) {
                s.inverseInertia[n] *= n == axis ? 1 + 1e-12 : 1;
                s.inertia[n] = 1 / s.inverseInertia[n];
            }
        });
    }
    std::size_t numbers = 0;
    State dummy;
    forEachMember(dummy, [&](real *number, bool *) { numbers += number != nullptr; });
    EXPECT_EQ(numbers, 58u);
    for (std::size_t changed = 0; changed < numbers; ++changed) {
        changes.push_back([changed](State &s) {
            std::size_t n = 0;
            forEachMember(s, [&](real *number, bool *) {
                if (number == nullptr || n++ != changed) return;
                // Mass and inertia are above: each is bound to its inverse.
                if (number == &s.mass || (number >= &s.inertia.x && number <= &s.inverseInertia.z))
                    s.position.x += static_cast<real>(changed);
                else if (number == &s.inverseMass)
                    s.position.y += 1;
                else
                    *number = std::nextafter(*number, 100.0);
            });
        });
    }

    for (const auto &change : changes) {
        State state = unusualState();
        change(state);
        const std::ptrdiff_t number = &change - changes.data();
        body.setState(state);
        EXPECT_EQ(bitsOf(body.getState()), bitsOf(state)) << number;
        EXPECT_EQ(std::count(hashes.begin(), hashes.end(), hashStates(bodies, 1)), 0) << number;
        hashes.push_back(hashStates(bodies, 1));
        Snapshot snapshot;
        writeSnapshot(bodies, 1, snapshot);
        EXPECT_EQ(std::count(snapshots.begin(), snapshots.end(), snapshot), 0) << number;
        snapshots.push_back(snapshot);
        readSnapshot(snapshot, restoredBodies, 1);
        EXPECT_EQ(bitsOf(restored.getState()), bitsOf(state)) << number;
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
        {"orientation", [](State &s) { s.orientation.r *= 1 + 1e-13; }},
        {"orientation", [](State &s) { s.orientation = Quaternion(0, 0, 0, 0); }},
        {"orientation", [](State &s) { s.orientation = Quaternion(1 + 16 * REAL_EPSILON, 0x1p-26, 0, 0); }},
        {"velocity", [](State &s) { s.velocity.x = PLUS_INFINITY; }},
        {"rotation", [](State &s) { s.rotation.x = QUIET_NAN; }},
        {"angular momentum", [](State &s) { s.angularMomentum.z = -PLUS_INFINITY; }},
        {"acceleration", [](State &s) { s.acceleration.x = QUIET_NAN; }},
        {"last frame's acceleration", [](State &s) { s.lastFrameAcceleration.y = QUIET_NAN; }},
        {"remembered acceleration", [](State &s) { s.memory.acceleration.x = QUIET_NAN; }},
        {"remembered acceleration", [](State &s) { s.memory.torque.z = PLUS_INFINITY; }},
        {"remembered kicks", [](State &s) { s.memory.linearKick = -0.01; }},
        {"remembered kicks", [](State &s) { s.memory.angularKick = QUIET_NAN; }},
        {"match the rotation", [](State &s) { s.rotation.y += 1e-6; }},
        {"match the rotation", [](State &s) { s.angularMomentum.y += 1e-6; }},
        {"match the rotation", [](State &s) { s.rotation *= 1e-6, s.angularMomentum *= 1.001e-6; }},
        {"match the rotation", [](State &s) { s.inverseMass = 0, s.mass = REAL_MAX; }},
        {"awake", [](State &s) { s.faulted = true; }},
        {"at rest", [](State &s) { s.awake = false; }},
        {"mass", [](State &s) { s.mass = 0; }},
        {"mass", [](State &s) { s.mass = QUIET_NAN; }},
        {"mass", [](State &s) { s.inverseMass = -1; }},
        {"mass", [](State &s) { s.mass *= 1 + 1e-12; }},
        {"moments of inertia", [](State &s) { s.inverseInertia.y = -1; }},
        {"moments of inertia", [](State &s) { s.inertia.z *= 1.001; }},
        {"moments of inertia", [](State &s) { s.inertia.x = s.inverseInertia.x = 0; }},
        {"principal axes", [](State &s) { s.principalAxes = Quaternion(1, 1, 0, 0); }},
        {"principal axes",
         [](State &s) { s.principalAxes = Quaternion(1 + 4 * REAL_EPSILON, 0x1p-26, 0, 0); }},
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

TEST(BodyState, MayBeOffByRounding) {
    State state;
    state.orientation = Quaternion(1 + 16 * REAL_EPSILON, 0, 0, 0);
    EXPECT_EQ(state.findError(), nullptr) << "32 roundings of the square";
    state.principalAxes = Quaternion(1 + 4 * REAL_EPSILON, 0, 0, 0);
    EXPECT_EQ(state.findError(), nullptr) << "8 roundings of the square";
}

/// Each alone keeps a body awake: what moves it, and what acts on it.
TEST(BodyState, OfASleeperIsAtRestInEveryPart) {
    void (*const disturbances[])(State &) = {
        [](State &s) { s.velocity.x = 1; },
        [](State &s) { s.rotation.x = 1; },         // about the locked axis
        [](State &s) { s.angularMomentum.x = 1; },  // of which there is no rotation
        [](State &s) { s.lastFrameAcceleration.y = 1; },
        [](State &s) { s.added.force.z = 1; },
        [](State &s) { s.added.torque.z = 1; },
        [](State &s) { s.generated.force.z = 1; },
        [](State &s) { s.generated.torque.z = 1; },
    };
    for (const auto &disturb : disturbances) {
        RigidBody body;
        body.setInverseInertiaTensor(cyclone_test::diagonal(0, 1, 1));
        State state = body.getState();
        disturb(state);
        EXPECT_EQ(state.findError(), nullptr) << &disturb - disturbances;
        state.awake = false;
        EXPECT_STREQ(state.findError(), "a sleeping body must be at rest") << &disturb - disturbances;
        state.faulted = true;
        EXPECT_EQ(state.findError(), nullptr) << "its last good state";
    }
}

TEST(BodyState, HasMomentsWithinTheirBounds) {
    for (const real moment : {1e-150, 1e150}) {
        State state;
        state.inertia.z = moment;
        state.inverseInertia.z = 1 / moment;
        EXPECT_STREQ(state.findError(), "the moments of inertia must not be extreme") << moment;
    }
}

/// Of a mass and its inverse, the one that was set has the last bit right.
TEST(BodyState, OfAnInexactInverseComesBackFromASnapshot) {
    RigidBody body, restored;
    body.setInverseMass(49);
    ASSERT_NE(1 / body.getMass(), 49);
    RigidBody *const from[] = {&body}, *const to[] = {&restored};
    Snapshot snapshot;
    writeSnapshot(from, 1, snapshot);
    readSnapshot(snapshot, to, 1);
    EXPECT_EQ(restored.getInverseMass(), 49);
    EXPECT_EQ(bitsOf(restored.getState()), bitsOf(body.getState()));
}

}  // namespace
