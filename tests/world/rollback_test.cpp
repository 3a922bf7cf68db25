// Returning to a snapshot after bodies, generators and registrations have come and gone.
#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <vector>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

constexpr real STEP = 1.0 / 60;

void frame(World &world) {
    world.startFrame();
    world.runPhysics(STEP);
}

/// Counts those alive.
class Counted : public ForceGenerator {
public:
    explicit Counted(int &count) : alive(count) { ++alive; }
    ~Counted() override { --alive; }
    Counted(const Counted &) = delete;
    Counted &operator=(const Counted &) = delete;
    void updateForce(RigidBody *body, real) override { body->addForce(Vector3(0, 1, 0)); }
    bool actsOnItsBodyOnly() const override { return true; }

private:
    int &alive;
};

struct Rewound : testing::Test {
    int alive = 0;
    World world;
    RigidBody *first = world.createBody(), *second = world.createBody(), *third = world.createBody();
    Snapshot before;

    Rewound() {
        second->setPosition(3, 0, 0);
        third->setPosition(0, 4, 0);
    }
};

TEST_F(Rewound, BodiesThatHaveEndedComeBackAtTheirAddresses) {
    const World::RigidBodies bodies = world.getBodies();
    world.saveState(before);
    const std::uint64_t hash = world.hash();
    world.destroyBody(second);
    EXPECT_NE(world.hash(), hash);
    for (int n = 0; n < 200; ++n) EXPECT_NE(world.createBody(), second) << "its place is kept";
    world.destroyBody(first);
    frame(world);
    world.restoreState(before);
    EXPECT_EQ(world.getBodies(), bodies);
    EXPECT_EQ(second->getPosition(), Vector3(3, 0, 0));
    EXPECT_EQ(world.hash(), hash);
    world.destroyBody(second);  // it is a body as any other
    EXPECT_EQ(world.getBodies(), (World::RigidBodies{first, third}));
}

TEST_F(Rewound, BodiesThatHaveBegunEnd) {
    world.saveState(before);
    RigidBody *const shot = world.createBody();
    frame(world);
    Snapshot after;
    world.saveState(after);
    world.restoreState(before);
    EXPECT_EQ(world.getBodies(), (World::RigidBodies{first, second, third}));
    EXPECT_THROW(world.destroyBody(shot), std::invalid_argument);
    world.restoreState(after);  // and forth again
    EXPECT_EQ(world.getBodies(), (World::RigidBodies{first, second, third, shot}));
}

TEST_F(Rewound, GeneratorsAndRegistrationsComeBackInTheirOrder) {
    Counted &one = world.createForce<Counted>(first, alive), &two = world.createForce<Counted>(second, alive);
    world.getForceRegistry().add(third, &one);
    world.createSpring(first, Vector3(), second, Vector3(0, 1, 0), 5, 1);
    for (int n = 0; n < 5; ++n) frame(world);
    world.saveState(before);
    std::vector<std::uint64_t> hashes;
    for (int n = 0; n < 20; ++n) {
        frame(world);
        hashes.push_back(world.hash());
    }
    for (int repeat = 0; repeat < 3; ++repeat) {
        world.restoreState(before);
        EXPECT_EQ(alive, 2);
        EXPECT_EQ(world.getForceRegistry().size(), 5U);
        for (std::uint64_t hash : hashes) {
            frame(world);
            ASSERT_EQ(world.hash(), hash);
        }
        if (repeat == 0) world.destroyForce(one);
        if (repeat == 1) world.destroyBody(first);
        world.destroyForce(two);
        world.createForce<Counted>(third, alive);
        frame(world);
    }
}

/// What no snapshot can bring back ends at once; the rest with the last such snapshot.
TEST_F(Rewound, WhatHasEndedIsKeptNoLongerThanASnapshotOfIt) {
    world.createForce<Counted>(first, alive);
    {
        Snapshot temporary, copy;
        world.saveState(temporary);
        copy = temporary;
        world.destroyBody(first);
        EXPECT_EQ(alive, 1) << "dormant";
        temporary = Snapshot();
        frame(world);
        EXPECT_EQ(alive, 1) << "the copy can bring it back, too";
    }
    frame(world);
    EXPECT_EQ(alive, 0);

    world.createForce<Counted>(second, alive);
    world.saveState(before);
    world.destroyBody(second);
    world.saveState(before);  // anew: the body is not in it any more
    frame(world);
    EXPECT_EQ(alive, 0);

    // A snapshot that is written by hand is none of the world any more.
    RigidBody *const buoy = world.createBody();
    world.createForce<Counted>(buoy, alive);
    world.saveState(before);
    world.destroyBody(buoy);
    EXPECT_EQ(alive, 1) << "dormant";
    writeSnapshot(world.getBodies().data(), world.getBodies().size(), before);
    frame(world);
    EXPECT_EQ(alive, 0);
    world.saveState(before);

    // What is born and ends between two snapshots is in none of them, whatever it has acted on meanwhile.
    RigidBody *const shot = world.createBody();
    Counted &force = world.createForce<Counted>(shot, alive);
    world.getForceRegistry().add(third, &force);
    world.destroyBody(shot);
    EXPECT_EQ(alive, 1);
    world.destroyForce(force);
    EXPECT_EQ(alive, 0);
}

TEST_F(Rewound, PlacesAreUsedAgainWhenNoSnapshotIsLeft) {
    // A rollback game of a day: eight snapshots in turn, and one of the beginning.
    Snapshot beginning;
    std::array<Snapshot, 8> ring;
    world.saveState(beginning);
    std::vector<const RigidBody *> places;
    for (std::size_t n = 0; n < 500; ++n) {
        world.saveState(ring.at(n % 8));
        RigidBody *const shot = world.createBody();
        if (std::find(places.begin(), places.end(), shot) == places.end()) places.push_back(shot);
        frame(world);
        world.saveState(ring.at(n % 8));
        world.destroyBody(shot);
    }
    EXPECT_LT(places.size(), 70U);
    world.restoreState(beginning);
    EXPECT_EQ(world.getBodies(), (World::RigidBodies{first, second, third}));
}

TEST_F(Rewound, TheCallersPartMustBeThere) {
    RigidBody mine, late;
    Drag drag(1, 0);
    world.addBody(&mine);
    world.getForceRegistry().add(first, &drag);
    world.saveState(before);
    const std::uint64_t hash = world.hash();

    world.removeBody(&mine);
    world.destroyBody(second);
    EXPECT_THROW(world.restoreState(before), std::invalid_argument);
    EXPECT_EQ(world.getBodies(), (World::RigidBodies{first, third})) << "nothing has changed";
    world.addBody(&mine);
    world.getForceRegistry().remove(first, &drag);
    EXPECT_THROW(world.restoreState(before), std::invalid_argument);

    world.getForceRegistry().add(third, &drag);
    world.addBody(&late);
    world.restoreState(before);
    EXPECT_EQ(world.getBodies(), (World::RigidBodies{first, second, third, &mine}));
    EXPECT_EQ(world.getForceRegistry().size(), 1U);
    EXPECT_EQ(world.hash(), hash);
    first->setVelocity(1, 0, 0);
    frame(world);
    EXPECT_LT(first->getVelocity().x, 1) << "the drag acts on the first again";
    world.addBody(&late);  // it had been taken out
}

TEST_F(Rewound, WhatTheCallerRegisteredLaterIsTakenOutOnly) {
    world.saveState(before);
    Drag drag(1, 0);
    world.getForceRegistry().add(first, &drag);
    world.restoreState(before);
    EXPECT_EQ(world.getForceRegistry().size(), 0U);
    world.getForceRegistry().add(first, &drag);  // it is the caller's as before
    first->setVelocity(1, 0, 0);
    frame(world);
    EXPECT_LT(first->getVelocity().x, 1);
}

TEST(Rollback, ToAnEmptyWorldFreesThePlaces) {
    World world;
    Snapshot empty;
    world.saveState(empty);
    std::vector<const RigidBody *> places;
    for (std::size_t n = 0; n < 500; ++n) {
        const RigidBody *const body = world.createBody();
        if (std::find(places.begin(), places.end(), body) == places.end()) places.push_back(body);
        world.restoreState(empty);
    }
    EXPECT_LT(places.size(), 70U);
}

TEST_F(Rewound, BytesAloneKeepTheRuleOfEqualNumbers) {
    world.createForce<Counted>(first, alive);
    world.saveState(before);
    const Snapshot bytes(before.begin(), before.end());
    RigidBody *const fourth = world.createBody();
    EXPECT_THROW(world.restoreState(bytes), std::invalid_argument);
    world.destroyBody(fourth);
    first->setPosition(9, 9, 9);
    world.restoreState(bytes);
    EXPECT_EQ(first->getPosition(), Vector3());

    // Other bytes in the same variable, such as from a network: what it has remembered is not theirs.
    World other;
    for (int n = 0; n < 4; ++n) other.createBody()->setPosition(n, 0, 0);
    Snapshot received;
    other.saveState(received);
    before.assign(received.begin(), received.end());
    EXPECT_THROW(world.restoreState(before), std::invalid_argument);
    world.createBody();
    world.restoreState(before);
    EXPECT_EQ(world.getBodies().back()->getPosition(), Vector3(3, 0, 0));
    world.restoreState(received);  // another world's is bytes, too
}

TEST(SnapshotOfAWorld, MayOutliveIt) {
    Snapshot snapshot;
    int alive = 0;
    {
        World world;
        RigidBody *const body = world.createBody();
        world.createForce<Counted>(body, alive);
        world.saveState(snapshot);
        world.destroyBody(body);
        EXPECT_EQ(alive, 1);
    }
    EXPECT_EQ(alive, 0);
    World another;
    another.createBody();
    another.restoreState(snapshot);
}

/// Random births, deaths and registrations, and jumps to any of eight snapshots: each brings back its hash,
/// its bodies and, run on with the same inputs, the same bits.
TEST(Rollback, ToAnySnapshotAmongRandomBirthsAndDeaths) {
    struct Kept {
        Snapshot snapshot;
        World::RigidBodies bodies;
        std::uint64_t hash = 0, next = 0;
        std::size_t registrations = 0;
    };
    Random random(5);
    const auto below = [&](std::size_t end) {
        return static_cast<std::size_t>(random.between(0, static_cast<real>(end)));
    };
    World world;
    std::array<Kept, 8> kept;
    for (int n = 0; n < 40; ++n) world.createBody()->setPosition(random.vector(10));
    for (std::size_t round = 0; round < 400; ++round) {
        for (int n = 0; n < 6; ++n) {
            const World::RigidBodies &bodies = world.getBodies();
            RigidBody *const any = bodies[below(bodies.size())];
            switch (below(4)) {
                case 0:
                    world.createBody()->setPosition(random.vector(10));
                    break;
                case 1:
                    if (bodies.size() > 10) world.destroyBody(any);
                    break;
                case 2:
                    world.createForce<Drag>(any, 0.5, 0.1);
                    break;
                default:
                    if (bodies.back() != any)
                        world.createSpring<Bungee>(any, random.vector(), bodies.back(), Vector3(), 1, 2);
            }
        }
        Kept &now = kept.at(round % 8);
        world.saveState(now.snapshot);
        now.bodies = world.getBodies();
        now.hash = world.hash();
        now.registrations = world.getForceRegistry().size();
        frame(world);
        now.next = world.hash();
        if (round < 8 || below(3) > 0) continue;
        for (int jump = 0; jump < 3; ++jump) {
            const Kept &then = kept.at(below(8));
            world.restoreState(then.snapshot);
            ASSERT_EQ(world.getBodies(), then.bodies);
            ASSERT_EQ(world.hash(), then.hash);
            ASSERT_EQ(world.getForceRegistry().size(), then.registrations);
            frame(world);
            ASSERT_EQ(world.hash(), then.next) << "round " << round;
        }
    }
}

TEST_F(Rewound, ACutShortSnapshotIsRefused) {
    world.saveState(before);
    for (const std::size_t size : {before.size() - 1, std::size_t(8), std::size_t(7), std::size_t(0)}) {
        before.resize(size);
        first->setPosition(9, 9, 9);
        EXPECT_THROW(world.restoreState(before), std::invalid_argument) << size;
        EXPECT_EQ(first->getPosition(), Vector3(9, 9, 9)) << size;
    }
}

TEST_F(Rewound, ACopyOutlivesTheNextUseOfItsOriginal) {
    world.saveState(before);
    const Snapshot copy = before;
    world.destroyBody(second);
    world.saveState(before);
    world.restoreState(copy);
    EXPECT_EQ(world.getBodies(), (World::RigidBodies{first, second, third}));
    world.restoreState(before);
    EXPECT_EQ(world.getBodies(), (World::RigidBodies{first, third}));
}

}  // namespace
