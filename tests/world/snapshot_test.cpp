#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "../golden/scene.h"
#include "random.h"

using namespace cyclone;
using cyclone_test::PLUS_INFINITY;
using cyclone_test::QUIET_NAN;
using cyclone_test::Random;
using golden::Scene;

namespace {

// ---- Going on from a snapshot

constexpr int FRAMES = 700;

/// What a run that was never stopped goes through: the hash after each frame's step.
const std::vector<std::uint64_t> &uninterruptedRun() {
    static const std::vector<std::uint64_t> hashes = [] {
        std::vector<std::uint64_t> result;
        Scene scene;
        for (int n = 0; n < FRAMES; ++n) {
            scene.steer();
            scene.step();
            result.push_back(scene.getWorld().hash());
        }
        return result;
    }();
    return hashes;
}

void expectToGoOnAlike(Scene &scene, int frames) {
    for (int end = std::min(scene.getFrame() + frames, FRAMES); scene.getFrame() < end;) {
        const std::size_t frame = static_cast<std::size_t>(scene.getFrame());
        scene.steer();
        scene.step();
        ASSERT_EQ(scene.getWorld().hash(), uninterruptedRun()[frame]) << "frame " << frame;
    }
}

TEST(Restoring, IntoAnotherProcessGivesTheSameBits) {
    Scene original;
    Random random(1);
    Snapshot snapshot;
    for (int n = 0; n < 25; ++n) {
        while (original.getFrame() < FRAMES - 40 && random.between(0, 1) < 0.96) {
            original.steer();
            original.step();
        }
        original.getWorld().saveState(snapshot);

        Scene restored(n % 5 == 0 ? 2 : 0);
        while (restored.getFrame() < original.getFrame()) {
            restored.steer();
            restored.skip();
        }
        restored.getWorld().restoreState(snapshot);
        EXPECT_EQ(restored.getWorld().hash(), original.getWorld().hash());
        expectToGoOnAlike(restored, 40);
        if (HasFailure()) FAIL() << "restored at frame " << original.getFrame();
    }
}

/// The forces that the caller has added for this frame are in the snapshot.
TEST(Restoring, InMidFrameGivesTheSameBits) {
    Scene original;
    Snapshot snapshot;
    for (int frame = 0; frame < 360; ++frame) {
        original.steer();
        if (frame % 29 == 28 || frame == 349) {  // 349: sleepers are being woken
            original.getWorld().saveState(snapshot);
            Scene restored;
            while (restored.getFrame() < frame) {
                restored.steer();
                restored.skip();
            }
            restored.steer();
            for (RigidBody *body : restored.getWorld().getBodies()) body->clearAccumulators();
            restored.getWorld().restoreState(snapshot);
            restored.step();
            ASSERT_EQ(restored.getWorld().hash(), uninterruptedRun()[static_cast<std::size_t>(frame)]);
            expectToGoOnAlike(restored, 5);
        }
        original.step();
    }
}

TEST(Restoring, RewindsAsOftenAsWanted) {
    Scene scene;
    while (scene.getFrame() < 91) {
        scene.steer();
        scene.step();
    }
    Snapshot snapshot;
    scene.getWorld().saveState(snapshot);
    for (int n = 0; n < 5; ++n) {
        expectToGoOnAlike(scene, 10 * n);
        scene.getWorld().restoreState(snapshot);
        scene.rewind(91);
    }
    expectToGoOnAlike(scene, 200);
}

/// Between the generators' turn and the step, for worlds that are advanced by hand.
TEST(Restoring, BetweenForcesAndStepGivesTheSameBits) {
    Drag drag(0.3, 0.1);
    Gravity gravity;
    const auto build = [&](World &world) {
        RigidBody *const body = world.createBody();
        body->setVelocity(1, 2, 3);
        body->setRotation(3, 2, 1);
        world.getForceRegistry().add(body, &drag);
        world.getForceRegistry().add(body, &gravity);
        world.createBody()->setAwake(false);
    };
    World original, restored;
    build(original);
    build(restored);
    Snapshot snapshot;
    for (int frame = 0; frame < 20; ++frame) {
        original.startFrame();
        original.getForceRegistry().updateForces(0.02);
        if (frame == 10) {
            original.saveState(snapshot);
            restored.restoreState(snapshot);
        } else if (frame > 10) {
            restored.startFrame();
            restored.getForceRegistry().updateForces(0.02);
        }
        original.integrate(0.02);
        if (frame < 10) continue;
        restored.integrate(0.02);
        ASSERT_EQ(restored.hash(), original.hash()) << frame;
    }
}

TEST(Restoring, BringsBackWhichBodiesHaveFaulted) {
    World world;
    RigidBody *const sound = world.createBody(), *const poisoned = world.createBody();
    Snapshot before, after;
    world.saveState(before);
    sound->setVelocity(1, 0, 0);
    poisoned->addForce(Vector3(QUIET_NAN, 0, 0));
    world.integrate(0.01);
    ASSERT_EQ(world.getFaultedBodies(), World::RigidBodies{poisoned});
    world.saveState(after);

    world.restoreState(before);
    EXPECT_TRUE(world.getFaultedBodies().empty());
    EXPECT_FALSE(poisoned->hasFaulted());
    world.restoreState(after);
    EXPECT_EQ(world.getFaultedBodies(), World::RigidBodies{poisoned});
    EXPECT_TRUE(poisoned->hasFaulted());
    EXPECT_FALSE(poisoned->getAwake());
    EXPECT_TRUE(sound->getAwake());
}

// ---- The bytes

constexpr std::size_t HEADER = 8, WORDS_PER_BODY = 56;  // 54 numbers, flags, and zero
constexpr std::size_t FLAGS = 54, PADDING = 55;

std::uint64_t wordAt(const Snapshot &snapshot, std::size_t index) {
    std::uint64_t word = 0;
    for (std::size_t n = 8; n-- > 0;) word = word << 8 | snapshot.at(8 * index + n);
    return word;
}

void setWord(Snapshot &snapshot, std::size_t index, std::uint64_t word) {
    for (std::size_t n = 0; n < 8; ++n, word >>= 8)
        snapshot.at(8 * index + n) = static_cast<std::uint8_t>(word);
}

/// As a forger would do it, who makes the checksum fit.
void sign(Snapshot &snapshot) {
    const auto mixed = [](std::uint64_t word) {
        word *= 0x9e3779b97f4a7c15;
        return word >> 32 | word << 32;
    };
    std::uint64_t lanes[] = {1, 2, 3, 4, 5, 6, 7, 8};
    const std::size_t last = snapshot.size() / 8 - 1;
    for (std::size_t n = 0; n < last; ++n) lanes[n % 8] = mixed(lanes[n % 8] ^ wordAt(snapshot, n));
    std::uint64_t sum = 0x656e6f6c637943;
    for (const std::uint64_t lane : lanes) sum = mixed(sum ^ lane);
    setWord(snapshot, last, sum);
}

void buildSmallWorld(World &world, std::size_t count) {
    Random random(7);
    for (std::size_t n = 0; n < count; ++n) {
        RigidBody *const body = world.createBody();
        body->setPosition(random.vector(10));
        body->setVelocity(random.vector(10));
        body->setRotation(random.vector());
        body->setDamping(0.9, 0.8);
        body->setInertiaTensor(Matrix3(0.5, 0.05, 0.1, 0.05, 0.4, 0, 0.1, 0, 0.6));
        body->addForce(random.vector());
    }
}

/// Refused with a clear word, the same from both functions, and nothing changes.
void expectRefusal(World &world, const Snapshot &snapshot, const std::string &word) {
    const std::uint64_t hash = world.hash();
    const char *const error = findSnapshotError(snapshot, world.getBodies().size());
    ASSERT_NE(error, nullptr);
    ASSERT_NE(std::string(error).find(word), std::string::npos) << error;
    try {
        world.restoreState(snapshot);
        FAIL() << "not refused";
    } catch (const std::invalid_argument &refusal) {
        ASSERT_NE(std::string(refusal.what()).find(error), std::string::npos) << refusal.what();
    }
    ASSERT_EQ(world.hash(), hash);
}

/// The format, byte by byte, as another program would read it.
TEST(SnapshotBytes, AreTheSameOnEveryMachine) {
    World world;
    world.createBody()->setPosition(1, -2, 0.15625);
    world.createBody();
    Snapshot snapshot;
    world.saveState(snapshot);
    const std::vector<std::uint8_t> begin = {
        'C', 'y', 'c', 'l', 'o', 'n', 'e', 0,  // mark
        4,   0,   0,   0,   0,   0,   0,   0,  // version
        2,   0,   0,   0,   0,   0,   0,   0,  // bodies
    };
    ASSERT_EQ(snapshot.size(), 8 * (HEADER + 2 * WORDS_PER_BODY + 1));
    EXPECT_TRUE(std::equal(begin.begin(), begin.end(), snapshot.begin()));
    const std::vector<std::uint8_t> position = {
        0, 0, 0, 0, 0, 0, 0xf0, 0x3f,  // 1 = +1.0·2⁰
        0, 0, 0, 0, 0, 0, 0,    0xc0,  // −2 = −1.0·2¹
        0, 0, 0, 0, 0, 0, 0xc4, 0x3f,  // 0.15625 = +1.25·2⁻³
    };
    EXPECT_TRUE(std::equal(position.begin(), position.end(), snapshot.begin() + 8 * HEADER));
    EXPECT_EQ(wordAt(snapshot, HEADER + FLAGS), 0x20fU);  // awake; mass and three moments were given
    EXPECT_EQ(wordAt(snapshot, HEADER + PADDING), 0U);

    const std::uint64_t checksum = wordAt(snapshot, snapshot.size() / 8 - 1);
    sign(snapshot);
    EXPECT_EQ(wordAt(snapshot, snapshot.size() / 8 - 1), checksum);
}

TEST(SnapshotBytes, EveryFlippedBitIsNoticed) {
    World world, other;
    buildSmallWorld(world, 2);
    buildSmallWorld(other, 2);
    other.getBodies()[0]->setPosition(9, 9, 9);
    Snapshot snapshot;
    world.saveState(snapshot);
    for (std::size_t bit = 0; bit < 8 * snapshot.size(); ++bit) {
        const std::uint8_t mask = static_cast<std::uint8_t>(1 << bit % 8);
        snapshot[bit / 8] ^= mask;
        expectRefusal(other, snapshot, "snapshot");
        if (HasFatalFailure()) FAIL() << "bit " << bit;
        snapshot[bit / 8] ^= mask;
    }
    EXPECT_EQ(findSnapshotError(snapshot, 2), nullptr);
}

/// A second flipped bit hides the first nowhere in the same 64 bytes.
TEST(SnapshotBytes, TwoFlippedBitsAreNoticed) {
    World world;
    buildSmallWorld(world, 1);
    Snapshot snapshot;
    world.saveState(snapshot);
    const auto flip = [&](std::size_t bit) { snapshot[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8); };
    const std::size_t begin = 8 * 8 * HEADER, end = begin + 8 * 64;
    for (std::size_t one = begin; one < end; ++one) {
        flip(one);
        for (std::size_t two = one + 1; two < end; ++two) {
            flip(two);
            const char *const error = findSnapshotError(snapshot, 1);
            ASSERT_STREQ(error, "the snapshot must be undamaged") << "bits " << one << " and " << two;
            flip(two);
        }
        flip(one);
    }
}

TEST(SnapshotBytes, OfAnotherLengthAreRefused) {
    World world;
    buildSmallWorld(world, 2);
    Snapshot whole;
    world.saveState(whole);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const Snapshot part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        expectRefusal(world, part, size < 72 ? "must be a snapshot" : "complete");
        if (HasFatalFailure()) FAIL() << size << " bytes";
    }
    for (std::size_t more : {std::size_t(1), std::size_t(8), 8 * WORDS_PER_BODY}) {
        Snapshot longer = whole;
        longer.resize(whole.size() + more);
        expectRefusal(world, longer, "complete");
    }
    expectRefusal(world, Snapshot(whole.size(), 0), "must be a snapshot");
}

TEST(SnapshotBytes, OfAnotherWorldOrVersionAreRefused) {
    World one, two, none;
    buildSmallWorld(one, 1);
    buildSmallWorld(two, 2);
    Snapshot snapshot;
    two.saveState(snapshot);
    expectRefusal(one, snapshot, "as many bodies");
    expectRefusal(none, snapshot, "as many bodies");
    one.saveState(snapshot);
    expectRefusal(two, snapshot, "as many bodies");

    const std::uint64_t version = wordAt(snapshot, 1);
    setWord(snapshot, 1, version - 1);
    sign(snapshot);
    expectRefusal(one, snapshot, "version");
    setWord(snapshot, 1, version);
    setWord(snapshot, 2, std::uint64_t(1) << 61);  // a count whose size in bytes overflows
    sign(snapshot);
    expectRefusal(one, snapshot, "as many bodies");

    none.saveState(snapshot);
    EXPECT_EQ(snapshot.size(), 72U);
    none.restoreState(snapshot);
}

/// The second body's state is impossible: the first must not have been restored either.
TEST(SnapshotBytes, OfImpossibleStatesAreRefused) {
    World world;
    buildSmallWorld(world, 2);
    Snapshot snapshot;
    world.saveState(snapshot);
    world.getBodies()[0]->setPosition(9, 9, 9);
    setWord(snapshot, HEADER + WORDS_PER_BODY, 0x7ff0000000000000);  // infinity, along x
    sign(snapshot);
    expectRefusal(world, snapshot, "the position must be finite");
}

/// Those that come from elsewhere are checked state by state, those just written are not.
TEST(SnapshotBytes, FromElsewhereMeanTheSame) {
    World world;
    buildSmallWorld(world, 3);
    Snapshot written;
    world.saveState(written);
    const std::uint64_t hash = world.hash();
    const Snapshot received(written.begin(), written.end());
    for (const Snapshot &snapshot : {written, received}) {
        world.runPhysics(0.02);
        ASSERT_NE(world.hash(), hash);
        world.restoreState(snapshot);
        ASSERT_EQ(world.hash(), hash);
    }
}

/// What means nothing is zero, so that the same states are the same bytes.
TEST(SnapshotBytes, WithUnknownBitsAreRefused) {
    World world;
    buildSmallWorld(world, 2);
    Snapshot snapshot;
    for (std::size_t word : {FLAGS, PADDING}) {
        world.saveState(snapshot);
        const std::size_t index = HEADER + WORDS_PER_BODY + word;
        setWord(snapshot, index, wordAt(snapshot, index) | 0x400);
        sign(snapshot);
        expectRefusal(world, snapshot, "unused bits");
    }
}

/// −0.0 equals 0.0, so the motions are the same; a snapshot brings back even that bit.
TEST(SnapshotBytes, KeepTheSignOfZeroWhichHashesDoNotSee) {
    RigidBody plus, minus;
    minus.setPosition(-0.0, 0, 0);
    minus.setVelocity(0, -0.0, -0.0);
    RigidBody *const bodies[] = {&plus, &minus};
    EXPECT_EQ(hashStates(&bodies[0], 1), hashStates(&bodies[1], 1));
    Snapshot snapshot;
    writeSnapshot(&bodies[1], 1, snapshot);
    readSnapshot(snapshot, &bodies[0], 1);
    EXPECT_TRUE(std::signbit(plus.getPosition().x));
    EXPECT_TRUE(std::signbit(plus.getVelocity().z));
    EXPECT_FALSE(std::signbit(plus.getPosition().y));
}

/// Changes that come in pairs, such as a velocity that is turned round or two numbers that change places.
TEST(Hash, NoticesPairs) {
    const auto hashOf = [](const Vector3 &position, const Vector3 &velocity) {
        RigidBody body;
        body.setPosition(position);
        body.setVelocity(velocity);
        RigidBody *const bodies[] = {&body};
        return hashStates(bodies, 1);
    };
    std::set<std::uint64_t> hashes;
    std::size_t count = 0;
    for (int x : {-2, -1, 1, 2})
        for (int y : {-2, -1, 1, 2})
            for (int z : {-2, -1, 1, 2})
                for (int vx : {-2, -1, 1, 2})
                    for (int vy : {-2, -1, 1, 2})
                        for (int vz : {-2, -1, 1, 2}) {
                            hashes.insert(hashOf(Vector3(x, y, z), Vector3(vx, vy, vz)));
                            ++count;
                        }
    EXPECT_EQ(hashes.size(), count);
}

/// A NaN has many bit patterns, and processors differ in which of them they make.
TEST(SnapshotBytes, AndHashesKnowOneNaNOnly) {
    const std::uint64_t patterns[] = {0x7ff8000000000000, 0xfff8000000000000, 0x7ff800000000abcd};
    RigidBody poisoned[3];
    Snapshot snapshots[3];
    std::uint64_t hashes[3];
    for (std::size_t n = 0; n < 3; ++n) {
        RigidBody::State state;
        std::memcpy(&state.added.force.x, &patterns[n], 8);
        poisoned[n].setState(state);
        RigidBody *const body = &poisoned[n];
        hashes[n] = hashStates(&body, 1);
        writeSnapshot(&body, 1, snapshots[n]);
        EXPECT_EQ(hashes[n], hashes[0]);
        EXPECT_EQ(snapshots[n], snapshots[0]);
    }
    RigidBody restored;
    RigidBody *const body = &restored;
    readSnapshot(snapshots[1], &body, 1);
    EXPECT_FALSE(restored.integrate(0.01)) << "the poison has been restored";
}

}  // namespace
