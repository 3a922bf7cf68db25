// A flight is its inputs: recorded, replayed, rewound and played over a network, to the same bits.
#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "random.h"

using namespace cyclone;
using cyclone_test::Random;

namespace {

constexpr real STEP = 1.0 / 60;

/// What a player does in one frame.
struct Sticks {
    real pitch = 0, roll = 0, rudder = 0, throttle = 0;
    bool fires = false;

    bool operator==(const Sticks &s) const {
        return pitch == s.pitch && roll == s.roll && rudder == s.rudder && throttle == s.throttle &&
               fires == s.fires;
    }
};

const Matrix3 TAILPLANE(-0.1, 0, 0, 1, -0.5, 0, 0, 0, -0.1);
const Matrix3 WING_DOWN(-0.2, 0, 0, -0.2, -0.5, 0, 0, 0, -0.1);
const Matrix3 WING_UP(-0.2, 0, 0, 1.4, -0.5, 0, 0, 0, -0.1);

Matrix3 rudderTensor(real side) { return Matrix3(-0.1, 0, 0, 0, -0.1, 0, side, 0, -0.5); }

/// A model aircraft with controls, all of its settings taken from the sticks in each frame.
class Aircraft {
public:
    Aircraft(World &world, const Vector3 &position, const Vector3 *wind)
        : body(world.createBody()),
          port(TAILPLANE, WING_DOWN, WING_UP, Vector3(0.25, 0.35, -0.2), wind),
          starboard(TAILPLANE, WING_DOWN, WING_UP, Vector3(0.25, 0.35, 0.2), wind),
          rudder(rudderTensor(0), rudderTensor(-0.4), rudderTensor(0.4), Vector3(-0.85, 0.3, 0), wind),
          tailplane(TAILPLANE, Vector3(-0.6, 0.4, 0), wind),
          propeller(Vector3(1, 0, 0), Vector3(0.45, 0.1, 0), 20, 14, wind) {
        body->setMass(2.5);
        body->setInertiaTensor(Matrix3(0.05, 0.004, 0, 0.004, 0.14, 0, 0, 0, 0.1));
        body->setAcceleration(Vector3::GRAVITY);
        body->setPosition(position);
        body->setVelocity(8.2, 0, 0);
        for (Aero *surface : {static_cast<Aero *>(&port), static_cast<Aero *>(&starboard),
                              static_cast<Aero *>(&rudder), &tailplane}) {
            surface->setRotationalFlow(true);
            world.getForceRegistry().add(body, surface);
        }
        world.getForceRegistry().add(body, &propeller);
    }

    Aircraft(const Aircraft &) = delete;
    Aircraft &operator=(const Aircraft &) = delete;

    void set(const Sticks &sticks) {
        port.setControl(sticks.pitch + sticks.roll);
        starboard.setControl(sticks.pitch - sticks.roll);
        rudder.setControl(sticks.rudder);
        propeller.setThrottle(sticks.throttle);
    }
    /// A shot that leaves the nose, and pushes back.
    RigidBody *fire(World &world) {
        RigidBody *const shot = world.createBody();
        const Vector3 muzzle = body->getPointInWorldSpace(Vector3(0.6, 0, 0));
        const Vector3 kick = body->getDirectionInWorldSpace(Vector3(0.4, 0, 0));  // N·s
        shot->setMass(0.01);
        shot->setPosition(muzzle);
        shot->setVelocity(body->getVelocityAtPoint(muzzle));
        shot->setAcceleration(Vector3::GRAVITY);
        shot->addImpulse(kick);
        body->addImpulseAtPoint(-kick, muzzle);
        world.createForce<Drag>(shot, 0, 1e-4);
        return shot;
    }
    const RigidBody &getBody() const { return *body; }

private:
    RigidBody *body;
    AeroControl port, starboard, rudder;
    Aero tailplane;
    Propeller propeller;
};

/// A sky with two aircraft in it, their shots, and a wind that turns.
class Sky {
public:
    using Inputs = std::array<Sticks, 2>;
    /// What the game itself knows of a shot.
    struct Shot {
        RigidBody *body;
        int endFrame;
    };
    /// To return to: the world, and what the game itself remembers.
    struct Saved {
        Snapshot world;
        std::vector<Shot> shots;
    };

    void save(Saved &saved) const {
        world.saveState(saved.world);
        saved.shots = shots;
    }
    void restore(const Saved &saved) {
        world.restoreState(saved.world);
        shots = saved.shots;  // whose bodies are at the same addresses again
    }

    void step(int frame, const Inputs &inputs) {
        wind = Vector3(0.5 * real_sin(0.4 * frame * STEP), 0, 0.3 * real_cos(0.7 * frame * STEP));
        for (; !shots.empty() && shots.front().endFrame <= frame; shots.erase(shots.begin()))
            world.destroyBody(shots.front().body);
        for (std::size_t player = 0; player < 2; ++player) {
            aircraft[player].set(inputs[player]);
            if (inputs[player].fires) shots.push_back({aircraft[player].fire(world), frame + SHOT_FRAMES});
        }
        world.startFrame();
        world.runPhysics(STEP);
    }

    static constexpr int SHOT_FRAMES = 20;

    World world;
    Vector3 wind;
    std::vector<Shot> shots;  // the oldest first
    std::array<Aircraft, 2> aircraft{Aircraft(world, Vector3(0, 50, 0), &wind),
                                     Aircraft(world, Vector3(0, 50, 20), &wind)};
};

/// A pilot who watches the aircraft and has a nervous hand. Now and then he holds the sticks for a while.
class Pilot {
public:
    explicit Pilot(std::uint64_t seed) : random(seed) {}

    Sticks steer(const RigidBody &body) {
        if (random.between(0, 1) < 0.7) return sticks;
        const real bank = body.getDirectionInWorldSpace(Vector3::Z).y;
        const real sinking = -body.getVelocity().y + 0.2 * (50 - body.getPosition().y);
        sticks.pitch = real_clamp(0.02 * sinking + random.between(-0.03, 0.03), -0.1, 0.1);
        sticks.roll =
            real_clamp(0.3 * bank - 0.1 * body.getRotation().x + random.between(-0.05, 0.05), -0.1, 0.1);
        sticks.rudder = random.between(-0.05, 0.05);
        sticks.throttle = random.between(0.3, 0.5);
        return sticks;
    }

private:
    Random random;
    Sticks sticks;
};

struct Flight {
    std::vector<Sky::Inputs> inputs;
    std::vector<std::uint64_t> hashes;  // after each frame
    std::vector<Snapshot> snapshots;    // after each hundredth frame
};

constexpr int FRAMES = 1200;

const Flight &recordedFlight() {
    static const Flight flight = [] {
        Flight result;
        Sky sky;
        Pilot first(1), second(2);
        for (int frame = 0; frame < FRAMES; ++frame) {
            result.inputs.push_back(
                {first.steer(sky.aircraft[0].getBody()), second.steer(sky.aircraft[1].getBody())});
            sky.step(frame, result.inputs.back());
            result.hashes.push_back(sky.world.hash());
            if (frame % 100 != 99) continue;
            result.snapshots.emplace_back();
            sky.world.saveState(result.snapshots.back());
        }
        return result;
    }();
    return flight;
}

/// The number of frames from `begin` on that give the recorded hashes.
int framesAlike(Sky &sky, int begin, const std::vector<Sky::Inputs> &inputs) {
    for (int frame = begin; frame < FRAMES; ++frame) {
        const std::size_t n = static_cast<std::size_t>(frame);
        sky.step(frame, inputs[n]);
        if (sky.world.hash() != recordedFlight().hashes[n]) return frame - begin;
    }
    return FRAMES - begin;
}

/// A recording of two aircraft that fell out of the sky or stood still would prove little.
TEST(Replay, TheRecordedFlightIsOne) {
    Sky sky;
    ASSERT_EQ(framesAlike(sky, 0, recordedFlight().inputs), FRAMES);
    for (const Aircraft &aircraft : sky.aircraft) {
        EXPECT_NEAR(aircraft.getBody().getPosition().y, 50, 20);
        EXPECT_NEAR(aircraft.getBody().getVelocity().magnitude(), 8, 4);
        EXPECT_GT(aircraft.getBody().getDirectionInWorldSpace(Vector3::Y).y, 0.5);
    }
}

TEST(Replay, FromTheStartGivesTheSameBits) {
    for (std::size_t threads : {0U, 2U}) {
        Sky sky;
        sky.world.setWorkers(threads);
        EXPECT_EQ(framesAlike(sky, 0, recordedFlight().inputs), FRAMES);
    }
}

TEST(Replay, FromASnapshotInTheMiddleGivesTheSameBits) {
    Sky rewound;
    for (int n : {11, 5, 8, 0}) {
        const int begin = 100 * (n + 1);
        const Snapshot &snapshot = recordedFlight().snapshots[static_cast<std::size_t>(n)];
        Sky fresh;
        for (Sky *sky : {&fresh, &rewound}) {
            sky->world.restoreState(snapshot);
            EXPECT_EQ(sky->world.hash(), recordedFlight().hashes[static_cast<std::size_t>(begin) - 1]);
            EXPECT_EQ(framesAlike(*sky, begin, recordedFlight().inputs), FRAMES - begin);
        }
    }
}

/// The comparison notices the smallest difference: the hash is worth something.
TEST(Replay, OneStickHeldABitDifferentlyIsNoticedAtOnce) {
    std::vector<Sky::Inputs> inputs = recordedFlight().inputs;
    inputs[500][1].throttle *= 1 + 1e-12;
    Sky sky;
    EXPECT_EQ(framesAlike(sky, 0, inputs), 500);
}

// ---- Rollback: each machine plays on with what it knows, and mends the past when it learns more

/// One of two machines. It knows its own player's sticks at once and the other's LATENCY frames late; until
/// then it takes it that the other still holds them as last heard.
class Peer {
public:
    static constexpr std::size_t LATENCY = 7;

    explicit Peer(std::size_t player) : own(player), other(1 - player) {}

    /// Plays one frame. `heard` are the other's sticks LATENCY frames ago, null at first.
    void play(const Sticks &sticks, const Sticks *heard) {
        if (heard != nullptr) hear(inputs.size() - LATENCY, *heard);
        Sky::Inputs now;
        now[own] = sticks;
        now[other] = lastHeard;
        inputs.push_back(now);
        simulate(inputs.size() - 1);
    }
    /// After the last frame, what has been on its way still.
    void hear(std::size_t frame, const Sticks &sticks) {
        lastHeard = sticks;
        if (inputs[frame][other] == sticks) return;
        ++rollbacks;
        for (std::size_t n = frame; n < inputs.size(); ++n) inputs[n][other] = sticks;
        sky.restore(before[frame % before.size()]);
        for (std::size_t n = frame; n < inputs.size(); ++n) simulate(n);
    }
    const std::vector<std::uint64_t> &getHashes() const { return hashes; }
    int getRollbacks() const { return rollbacks; }

private:
    void simulate(std::size_t frame) {
        sky.save(before[frame % before.size()]);
        sky.step(static_cast<int>(frame), inputs[frame]);
        hashes.resize(inputs.size());
        hashes[frame] = sky.world.hash();
    }

    const std::size_t own, other;
    Sky sky;
    Sticks lastHeard;
    std::vector<Sky::Inputs> inputs;
    std::vector<std::uint64_t> hashes;
    std::array<Sky::Saved, LATENCY + 1> before;  // the worlds at the beginning of the last frames
    int rollbacks = 0;
};

/// Two machines play, each with the other's inputs late, and end up with the hashes of those who knew all at
/// once.
void expectRollbackToEndIn(const std::vector<Sky::Inputs> &inputs, const std::vector<std::uint64_t> &hashes) {
    Peer peers[2] = {Peer(0), Peer(1)};
    for (std::size_t player = 0; player < 2; ++player) {
        Peer &peer = peers[player];
        for (std::size_t frame = 0; frame < inputs.size(); ++frame) {
            const bool hears = frame >= Peer::LATENCY;
            peer.play(inputs[frame][player], hears ? &inputs[frame - Peer::LATENCY][1 - player] : nullptr);
            if (!hears) continue;
            // What can no longer change is what really happened.
            const std::size_t settled = frame - Peer::LATENCY;
            ASSERT_EQ(peer.getHashes()[settled], hashes[settled]) << settled;
        }
        for (std::size_t frame = inputs.size() - Peer::LATENCY; frame < inputs.size(); ++frame)
            peer.hear(frame, inputs[frame][1 - player]);
        EXPECT_GT(peer.getRollbacks(), 100);
        EXPECT_EQ(peer.getHashes(), hashes);
    }
}

TEST(Rollback, EndsAsIfNothingHadEverBeenMispredicted) {
    expectRollbackToEndIn(recordedFlight().inputs, recordedFlight().hashes);
}

/// Shots are bodies that come and go, some of them only in a past that never was.
TEST(Rollback, WithShotsToo) {
    std::vector<Sky::Inputs> inputs = recordedFlight().inputs;
    Random random(9);
    for (Sky::Inputs &frame : inputs)
        for (Sticks &sticks : frame) sticks.fires = random.between(0, 1) < 0.1;

    Sky sky;
    std::vector<std::uint64_t> hashes;
    std::size_t mostShots = 0;
    for (std::size_t frame = 0; frame < inputs.size(); ++frame) {
        sky.step(static_cast<int>(frame), inputs[frame]);
        hashes.push_back(sky.world.hash());
        mostShots = std::max(mostShots, sky.shots.size());
    }
    EXPECT_GE(mostShots, 6U);
    expectRollbackToEndIn(inputs, hashes);
}

}  // namespace
