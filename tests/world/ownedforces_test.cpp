// Generators that a World owns, and springs between its bodies: when they act and when they end.
#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <vector>

#include "frames.h"
#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

/// Counts those alive, and pushes along X.
class Push : public ForceGenerator {
public:
    Push(real n, int &count) : newtons(n), alive(count) { ++alive; }
    ~Push() override { --alive; }
    Push(const Push &) = delete;
    Push &operator=(const Push &) = delete;
    void updateForce(RigidBody *body, real) override {
        body->addForce(Vector3(newtons, 0, 0));
        if (deed) deed();
    }

    real newtons;
    std::function<void()> deed;

private:
    int &alive;
};

struct OwnedForces : testing::Test {
    int alive = 0;
    World world;
    RigidBody *body = world.createBody(), *another = world.createBody();
};

TEST_F(OwnedForces, ActOnTheirBodyFromCreationOn) {
    Push &push = world.createForce<Push>(body, 6, alive);
    run(world, 1);
    EXPECT_NEAR(body->getVelocity().x, 6 * STEP, 1e-15);
    EXPECT_EQ(another->getVelocity(), Vector3());
    push.newtons = 0;
    run(world, 1);
    EXPECT_NEAR(body->getVelocity().x, 3 * STEP, 1e-15) << "the first call opens with half a kick";
}

TEST_F(OwnedForces, EndWithTheRegistryHoweverMany) {
    for (int n = 0; n < 300; ++n) world.createForce<Push>(body, 1, alive);
    world.getForceRegistry().clear();
    EXPECT_EQ(alive, 0);
    EXPECT_EQ(world.getForceRegistry().size(), 0U);
}

TEST_F(OwnedForces, EndWithTheirBody) {
    RigidBody mine;
    world.addBody(&mine);
    world.createForce<Push>(body, 1, alive);
    world.createForce<Push>(&mine, 1, alive);
    world.createForce<Push>(another, 1, alive);
    EXPECT_EQ(alive, 3);
    world.destroyBody(body);
    EXPECT_EQ(alive, 2);
    world.removeBody(&mine);
    EXPECT_EQ(alive, 1);
    EXPECT_EQ(world.getForceRegistry().size(), 1U);
    run(world, 1);
    EXPECT_NEAR(another->getVelocity().x, STEP, 1e-15);
}

TEST_F(OwnedForces, EndWithTheWorld) {
    {
        World shortLived;
        shortLived.createForce<Push>(shortLived.createBody(), 1, alive);
        EXPECT_EQ(alive, 1);
    }
    EXPECT_EQ(alive, 0);
    world.createForce<Push>(body, 1, alive);
    world.clear();
    EXPECT_EQ(alive, 0);
    EXPECT_TRUE(world.getBodies().empty());
    EXPECT_EQ(world.getForceRegistry().size(), 0U);
    world.createForce<Push>(world.createBody(), 1, alive);
    world.getForceRegistry().clear();
    EXPECT_EQ(alive, 0);
}

TEST_F(OwnedForces, EndByHand) {
    Push &push = world.createForce<Push>(body, 1, alive);
    world.getForceRegistry().add(another, &push);
    world.createForce<Push>(body, 10, alive);
    world.destroyForce(push);
    EXPECT_EQ(alive, 1);
    run(world, 1);
    EXPECT_NEAR(body->getVelocity().x, 10 * STEP, 1e-15);
    EXPECT_EQ(another->getVelocity(), Vector3());
}

TEST_F(OwnedForces, LiveAsLongAsTheyActOnSomeBody) {
    Push &push = world.createForce<Push>(body, 1, alive);
    world.getForceRegistry().add(another, &push);
    world.destroyBody(body);
    EXPECT_EQ(alive, 1);
    run(world, 1);
    EXPECT_NEAR(another->getVelocity().x, STEP, 1e-15);
    world.getForceRegistry().remove(another, &push);
    EXPECT_EQ(alive, 0);
}

TEST_F(OwnedForces, ThatEndThemselvesLiveUntilAllHaveBeenCalled) {
    Push &last = world.createForce<Push>(body, 1, alive);
    Push &withBody = world.createForce<Push>(another, 1, alive);
    last.deed = [&] {
        world.destroyForce(last);
        EXPECT_EQ(alive, 2);
        last.newtons = 7;  // still there
    };
    withBody.deed = [&] {
        world.destroyBody(another);
        EXPECT_EQ(alive, 2);
        withBody.newtons = 7;
    };
    run(world, 1);
    EXPECT_EQ(alive, 0);
    EXPECT_EQ(world.getForceRegistry().size(), 0U);
    EXPECT_EQ(world.getBodies(), World::RigidBodies{body});
}

TEST_F(OwnedForces, ThatEndAndComeAgainInOneCallAreStillTheWorlds) {
    Push &again = world.createForce<Push>(body, 1, alive);
    again.deed = [&] {
        world.getForceRegistry().remove(body, &again);
        world.getForceRegistry().add(body, &again);
    };
    run(world, 3);
    EXPECT_NEAR(body->getVelocity().x, 3 * STEP, 1e-15);
    EXPECT_EQ(alive, 1);
    again.deed = nullptr;
    world.destroyForce(again);
    EXPECT_EQ(alive, 0);
}

TEST_F(OwnedForces, MayEndAndComeAgainWhileOthersEnd) {
    Push &again = world.createForce<Push>(body, 1, alive), &last = world.createForce<Push>(body, 1, alive);
    last.deed = [&] {
        world.getForceRegistry().remove(body, &again);
        world.destroyForce(last);
        world.getForceRegistry().add(body, &again);
        EXPECT_EQ(alive, 2);
        last.newtons = 7;  // still there
    };
    run(world, 1);
    EXPECT_EQ(alive, 1);
    run(world, 1);
    EXPECT_EQ(alive, 1);
    world.destroyForce(again);
    EXPECT_EQ(alive, 0);
}

TEST_F(OwnedForces, MayEndOthersWithThem) {
    class Chain : public ForceGenerator {
    public:
        Chain(World &w, int &count) : world(w), alive(count) { ++alive; }
        ~Chain() override {
            --alive;
            if (next != nullptr) world.destroyForce(*next);
        }
        void updateForce(RigidBody *, real) override {}
        Chain *next = nullptr;

    private:
        World &world;
        int &alive;
    };
    Chain &first = world.createForce<Chain>(body, world, alive);
    first.next = &world.createForce<Chain>(body, world, alive);
    first.next->next = &world.createForce<Chain>(another, world, alive);
    world.destroyForce(first);
    EXPECT_EQ(alive, 0);
}

TEST_F(OwnedForces, MayLookAtTheBodiesAsTheyEndWithTheirs) {
    struct Looking : ForceGenerator {
        explicit Looking(const World &w) : world(w) {}
        Looking(const Looking &) = delete;
        Looking &operator=(const Looking &) = delete;
        ~Looking() override { world.getBodies(); }
        void updateForce(RigidBody *, real) override {}
        const World &world;
    };
    RigidBody *const third = world.createBody(), *const fourth = world.createBody();
    world.createForce<Looking>(third, world);
    world.destroyBody(body);
    world.destroyBody(third);
    EXPECT_EQ(world.getBodies(), (World::RigidBodies{another, fourth}));
}

TEST_F(OwnedForces, AreRefusedToStrangers) {
    RigidBody stranger;
    Push mine(1, alive);
    World elsewhere;
    Push &theirs = elsewhere.createForce<Push>(elsewhere.createBody(), 1, alive);
    EXPECT_THROW(world.createForce<Push>(nullptr, 1, alive), std::invalid_argument);
    EXPECT_THROW(world.createForce<Push>(&stranger, 1, alive), std::invalid_argument);
    EXPECT_THROW(world.createForce<Drag>(body, -1, 0), std::invalid_argument);
    EXPECT_THROW(world.createSpring(body, Vector3(), &stranger, Vector3(), 1, 1), std::invalid_argument);
    EXPECT_THROW(world.createSpring(body, Vector3(), nullptr, Vector3(), 1, 1), std::invalid_argument);
    EXPECT_THROW(world.createSpring(nullptr, Vector3(), body, Vector3(), 1, 1), std::invalid_argument);
    EXPECT_THROW(world.createSpring(body, Vector3(), body, Vector3(1, 0, 0), 1, 1), std::invalid_argument);
    world.getForceRegistry().add(body, &mine);
    EXPECT_THROW(world.destroyForce(mine), std::invalid_argument);
    EXPECT_THROW(world.destroyForce(theirs), std::invalid_argument);
    EXPECT_EQ(alive, 2);
    EXPECT_EQ(world.getForceRegistry().size(), 1U);
}

// ---- Springs between two bodies

struct CreatedSprings : OwnedForces {
    CreatedSprings() {
        body->setMass(2);
        another->setPosition(3, 0.5, 0);
        another->setOrientation(Quaternion::fromAxisAngle(Vector3(1, 2, 3), 1));
    }
};

TEST_F(CreatedSprings, PullBothEndsWithTheSameForce) {
    world.createSpring(body, Vector3(0.5, 0, 0), another, Vector3(0, -0.4, 0.3), 20, 1);
    for (int n = 0; n < 100; ++n) {
        run(world, 1);
        ASSERT_EQ(body->getVelocity() * 2, -another->getVelocity())
            << "exactly: the mirror image of each other";
    }
    EXPECT_GT(body->getVelocity().magnitude(), 0.1);
}

TEST_F(CreatedSprings, AreTwoSpringsByHandBitForBit) {
    World byHand;
    RigidBody *const a = byHand.createBody(), *const b = byHand.createBody();
    *a = *body;
    *b = *another;
    const Vector3 onA(0.5, 0, 0), onB(0, -0.4, 0.3);
    Spring near(onA, b, onB, 20, 1), far(onB, a, onA, 20, 1);
    byHand.getForceRegistry().add(a, &near);
    byHand.getForceRegistry().add(b, &far);
    world.createSpring(body, onA, another, onB, 20, 1);
    run(byHand, 100);
    run(world, 100);
    EXPECT_EQ(world.hash(), byHand.hash());
}

TEST_F(CreatedSprings, EndWithEitherBody) {
    for (bool first : {true, false}) {
        World pair;
        RigidBody *const a = pair.createBody(), *const b = pair.createBody();
        b->setPosition(5, 0, 0);
        pair.createSpring<Bungee>(a, Vector3(), b, Vector3(), 10, 1);
        run(pair, 1);
        EXPECT_GT(a->getVelocity().x, 0);
        pair.destroyBody(first ? a : b);
        EXPECT_EQ(pair.getForceRegistry().size(), 0U);
        RigidBody *const last = pair.getBodies().front();
        run(pair, 1);
        const Vector3 velocity = last->getVelocity();
        run(pair, 5);
        EXPECT_EQ(last->getVelocity(), velocity) << "nothing pulls any more";
    }
}

/// The next body that takes the place of the destroyed one is not pulled towards.
TEST_F(CreatedSprings, OfTheCallersEndWithTheOtherBody) {
    Spring spring(Vector3(), another, Vector3(), 1e5, 0);
    Bungee bungee(Vector3(), another, Vector3(), 1e5, 0);
    AnchoredSpring anchored(Vector3(), Vector3(), 1, 0);
    for (ForceGenerator *force :
         {static_cast<ForceGenerator *>(&spring), static_cast<ForceGenerator *>(&bungee),
          static_cast<ForceGenerator *>(&anchored)})
        world.getForceRegistry().add(body, force);
    world.destroyBody(another);
    EXPECT_EQ(world.getForceRegistry().size(), 1U) << "the anchored one";
    for (int n = 0; n < 64; ++n) world.createBody()->setPosition(1000, 0, 0);
    run(world, 10);
    EXPECT_EQ(body->getPosition(), Vector3());
}

TEST_F(OwnedForces, ThatEndWithOthersInOneCallMayComeAgainAlone) {
    Push &lost = world.createForce<Push>(another, 1, alive), &again = world.createForce<Push>(body, 1, alive);
    again.deed = [&] {
        world.destroyForce(lost);
        world.getForceRegistry().remove(body, &again);
        world.getForceRegistry().add(body, &again);
        again.deed = nullptr;
    };
    run(world, 1);
    EXPECT_EQ(alive, 1);
    EXPECT_EQ(world.getForceRegistry().size(), 1U);
    const Vector3 before = body->getVelocity();
    run(world, 1);
    EXPECT_GT(body->getVelocity().x, before.x);
    world.destroyForce(again);
    EXPECT_EQ(alive, 0);
}

}  // namespace
