#include <cyclone/world.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

constexpr real STEP = 1.0 / 60;

class Scripted : public ForceGenerator {
public:
    explicit Scripted(std::function<void(RigidBody *)> what) : act(std::move(what)) {}
    void updateForce(RigidBody *body, real) override { act(body); }

private:
    std::function<void(RigidBody *)> act;
};

void frame(World &world) {
    world.startFrame();
    world.runPhysics(STEP);
}

/// A body in tumbling flight, each seed another.
void launch(RigidBody &body, std::uint64_t seed) {
    Random random(seed);
    body.setMass(random.between(0.5, 5));
    body.setInertiaTensor(diagonal(1, random.between(1, 2), random.between(1, 2)));
    body.setPosition(random.vector(10));
    body.setOrientation(random.orientation());
    body.setVelocity(random.vector(5));
    body.setRotation(random.vector(3));
    body.setDamping(0.99, 0.95);
    body.setAcceleration(Vector3::GRAVITY);
}

std::uint64_t hashOf(RigidBody *body) { return hashStates(&body, 1); }

// ---- Bodies

TEST(World, AdvancesBodiesInTheOrderOfAddingAndCreating) {
    World world;
    RigidBody mine, another;
    world.addBody(&mine);
    RigidBody *created = world.createBody();
    world.addBody(&another);
    EXPECT_EQ(world.getBodies(), (World::RigidBodies{&mine, created, &another}));
    for (RigidBody *body : world.getBodies()) body->setVelocity(6, 0, 0);
    frame(world);
    for (const RigidBody *body : world.getBodies()) EXPECT_NEAR(body->getPosition().x, 0.1, 1e-15);

    EXPECT_TRUE(world.removeBody(&mine));
    EXPECT_FALSE(world.removeBody(&mine));
    EXPECT_EQ(world.getBodies(), (World::RigidBodies{created, &another}));
    frame(world);
    EXPECT_NEAR(mine.getPosition().x, 0.1, 1e-15);
    EXPECT_NEAR(created->getPosition().x, 0.2, 1e-15);
    world.addBody(&mine);
    EXPECT_EQ(world.getBodies().back(), &mine);
    world.destroyBody(created);
    EXPECT_EQ(world.getBodies(), (World::RigidBodies{&another, &mine}));
}

TEST(World, IntegrateLeavesTheRegistryOut) {
    World world;
    RigidBody *body = world.createBody();
    Gravity gravity;
    world.getForceRegistry().add(body, &gravity);
    world.integrate(STEP);
    EXPECT_EQ(body->getVelocity(), Vector3());
    world.runPhysics(STEP);
    EXPECT_NEAR(body->getVelocity().y, -9.81 * 1.5 * STEP, 1e-15) << "felt half a step early";
}

TEST(World, CreatedBodiesAreNewAndStayWhereTheyAre) {
    World world;
    std::vector<RigidBody *> created;
    for (int n = 0; n < 5000; ++n) {
        created.push_back(world.createBody());
        created.back()->setPosition(n, 0, 0);
    }
    EXPECT_EQ(std::set<RigidBody *>(created.begin(), created.end()).size(), 5000U);
    for (std::size_t n = 0; n < 5000; n += 3) world.destroyBody(created[n]);
    EXPECT_EQ(world.getBodies().size(), 5000U - 1667U);

    // The freed places are used again, by bodies that know nothing of their forerunners.
    std::set<RigidBody *> living(world.getBodies().begin(), world.getBodies().end());
    for (int n = 0; n < 2000; ++n) {
        RigidBody *body = world.createBody();
        EXPECT_TRUE(living.insert(body).second);
        EXPECT_EQ(body->getPosition(), Vector3());
        body->setPosition(-1, 0, 0);
    }
    frame(world);
    for (std::size_t n = 0; n < 5000; ++n) {
        if (n % 3 != 0) {
            ASSERT_EQ(created[n]->getPosition().x, static_cast<real>(n));
        }
    }
}

TEST(World, RegistrationsGoWithTheirBody) {
    World world;
    RigidBody mine, stays;
    world.addBody(&mine);
    world.addBody(&stays);
    RigidBody *created = world.createBody();
    Gravity gravity;
    for (int n = 0; n < 2; ++n)
        for (RigidBody *body : {&mine, created, &stays}) world.getForceRegistry().add(body, &gravity);
    world.removeBody(&mine);
    EXPECT_EQ(world.getForceRegistry().size(), 4U);
    world.destroyBody(created);
    EXPECT_EQ(world.getForceRegistry().size(), 2U);
    frame(world);
    EXPECT_NEAR(stays.getVelocity().y, 2 * -9.81 * STEP, 1e-15);
    EXPECT_EQ(mine.getVelocity(), Vector3());
}

TEST(World, ClearedItIsEmptyAndTakesTheSameBodiesAgain) {
    World world;
    RigidBody mine, faulty;
    world.addBody(&mine);
    world.createBody();
    world.addBody(&faulty);
    world.createForce<Gravity>(&mine);
    faulty.addForce(Vector3(QUIET_NAN, 0, 0));
    world.runPhysics(STEP);
    ASSERT_EQ(world.getFaultedBodies().size(), 1U);
    Snapshot full, empty;
    world.saveState(full);
    world.saveState(empty);

    world.clear();
    EXPECT_TRUE(world.getBodies().empty());
    EXPECT_TRUE(world.getFaultedBodies().empty());
    EXPECT_EQ(world.getForceRegistry().size(), 0U);
    EXPECT_FALSE(world.removeBody(&mine));
    world.saveState(empty);
    world.addBody(&mine);
    world.addBody(&faulty);
    EXPECT_EQ(world.getBodies(), (World::RigidBodies{&mine, &faulty}));
    world.restoreState(full);
    EXPECT_EQ(world.getBodies().size(), 3U);
    world.restoreState(empty);
    EXPECT_TRUE(world.getBodies().empty());
}

TEST(World, StartFrameDropsWhatWasAddedBefore) {
    World world;
    RigidBody *body = world.createBody();
    body->addForce(Vector3(100, 0, 0));
    body->addTorque(Vector3(0, 100, 0));
    world.startFrame();
    body->addForce(Vector3(0, 0, 6));
    world.runPhysics(STEP);
    EXPECT_TRUE(isNear(body->getVelocity(), Vector3(0, 0, 0.1), 1e-15));
    EXPECT_EQ(body->getRotation(), Vector3());
}

TEST(World, TransformsAreCurrentAfterTheFrame) {
    World world;
    RigidBody *body = world.createBody();
    launch(*body, 1);
    body->setInertiaTensor(Matrix3(3, -0.5, 0.1, -0.5, 4, 0, 0.1, 0, 5));
    for (int n = 0; n < 10; ++n) {
        frame(world);
        EXPECT_TRUE(
            isNear(body->getTransform(), rigidTransform(body->getOrientation(), body->getPosition()), 1e-15));
    }
}

TEST(World, AStepDoesNotDependOnTheCompany) {
    World world;
    std::vector<RigidBody> alone(19);
    for (std::size_t n = 0; n < alone.size(); ++n) {
        launch(alone[n], n);
        if (n % 5 == 2) alone[n].setInverseMass(0);
        if (n % 5 == 3) alone[n].setInverseInertiaTensor(diagonal(1, 0, 1));
        if (n % 5 == 4) alone[n].setAwake(false);
        *world.createBody() = alone[n];
    }
    for (int step = 0; step < 50; ++step) {
        frame(world);
        for (std::size_t n = 0; n < alone.size(); ++n) {
            alone[n].integrate(STEP);
            ASSERT_EQ(hashOf(world.getBodies()[n]), hashOf(&alone[n])) << n;
        }
    }
}

// ---- Changes during the frame

TEST(World, AGeneratorMayDestroyAndRemoveBodies) {
    World world;
    RigidBody *first = world.createBody(), *doomed = world.createBody(), *last = world.createBody();
    RigidBody mine;
    world.addBody(&mine);
    Gravity gravity;
    Scripted destroyer([&](RigidBody *) {
        if (world.getBodies().size() != 4) return;
        world.destroyBody(doomed);
        world.removeBody(&mine);
    });
    world.getForceRegistry().add(doomed, &gravity);
    world.getForceRegistry().add(first, &destroyer);
    for (RigidBody *body : {doomed, &mine, last}) world.getForceRegistry().add(body, &gravity);
    frame(world);
    EXPECT_EQ(world.getBodies(), (World::RigidBodies{first, last}));
    EXPECT_EQ(world.getForceRegistry().size(), 2U);
    EXPECT_EQ(mine.getVelocity(), Vector3());
    EXPECT_NEAR(last->getVelocity().y, -9.81 * STEP, 1e-15);
    frame(world);
    EXPECT_NEAR(last->getVelocity().y, -9.81 * 2 * STEP, 1e-15);
}

TEST(World, AGeneratorMayEndItsOwnBody) {
    World world;
    RigidBody *created = world.createBody();
    auto mine = std::make_unique<RigidBody>();
    world.addBody(mine.get());
    Scripted end([&](RigidBody *body) {
        if (body == created) {
            world.destroyBody(body);
        } else {
            world.removeBody(body);
            mine.reset();  // the body's memory is gone
        }
    });
    Gravity gravity;
    for (RigidBody *body : {created, mine.get()}) {
        world.getForceRegistry().add(body, &gravity);
        world.getForceRegistry().add(body, &end);
        world.getForceRegistry().add(body, &gravity);
    }
    frame(world);
    EXPECT_TRUE(world.getBodies().empty());
    EXPECT_EQ(world.getForceRegistry().size(), 0U);
    EXPECT_EQ(mine, nullptr);
}

TEST(World, ABodyCreatedInThePlaceOfAnotherDuringTheFrameIsNew) {
    World world;
    Gravity gravity;
    RigidBody *old = world.createBody(), *young = nullptr;
    Scripted replace([&](RigidBody *body) {
        if (young != nullptr) return;
        world.destroyBody(body);
        young = world.createBody();
        world.getForceRegistry().add(young, &gravity);
    });
    world.getForceRegistry().add(old, &gravity);
    world.getForceRegistry().add(old, &replace);
    frame(world);
    EXPECT_EQ(world.getBodies(), (World::RigidBodies{young}));
    EXPECT_EQ(young->getVelocity(), Vector3());
    for (int n = 0; n < 3; ++n) frame(world);
    EXPECT_NEAR(young->getVelocity().y, 3.5 * -9.81 * STEP, 1e-14);
    young->addForce(Vector3(60, 0, 0));  // by the caller: for one frame, no more, no less
    world.runPhysics(STEP);
    for (int n = 0; n < 3; ++n) frame(world);
    EXPECT_NEAR(young->getVelocity().x, 1, 1e-14);
}

TEST(World, AGeneratorMayAddBodies) {
    World world;
    RigidBody *first = world.createBody();
    Scripted spawn([&](RigidBody *) { world.createBody()->setVelocity(60, 0, 0); });
    world.getForceRegistry().add(first, &spawn);
    for (int n = 0; n < 600; ++n) frame(world);
    EXPECT_EQ(world.getBodies().size(), 601U);
    EXPECT_NEAR(world.getBodies()[1]->getPosition().x, 600, 1e-9);
}

TEST(World, AnExceptionFromAGeneratorReachesTheCallerAndTheWorldGoesOn) {
    World world;
    RigidBody *body = world.createBody();
    bool fails = true;
    Scripted failing([&](RigidBody *) {
        if (fails) throw std::runtime_error("no fuel");
    });
    world.getForceRegistry().add(body, &failing);
    body->setVelocity(6, 0, 0);
    EXPECT_THROW(frame(world), std::runtime_error);
    EXPECT_EQ(body->getPosition(), Vector3());
    fails = false;
    frame(world);
    EXPECT_NEAR(body->getPosition().x, 0.1, 1e-15);
}

// ---- Faults

TEST(World, APoisonedBodyKeepsItsStateAndReachesNoOther) {
    for (real poison : {QUIET_NAN, PLUS_INFINITY, -PLUS_INFINITY, 1e308 * 1e3}) {
        World world, sound;
        for (std::size_t n = 0; n < 20; ++n) {
            launch(*world.createBody(), n);
            if (n != 11) launch(*sound.createBody(), n);
        }
        RigidBody *victim = world.getBodies()[11];
        bool poisoned = false;
        Scripted force([&](RigidBody *body) {
            body->addForceAtBodyPoint(Vector3(0, poisoned ? poison : 1, 0), Vector3(1, 0, 0));
        });
        world.getForceRegistry().add(victim, &force);
        for (int n = 0; n < 5; ++n) {
            frame(world);
            frame(sound);
        }
        EXPECT_TRUE(world.getFaultedBodies().empty());
        const RigidBody::State good = victim->getState();

        poisoned = true;
        for (int n = 0; n < 3; ++n) {
            frame(world);
            frame(sound);
            EXPECT_EQ(world.getFaultedBodies(), World::RigidBodies{victim});
            EXPECT_TRUE(victim->hasFaulted());
            EXPECT_FALSE(victim->getAwake());
            EXPECT_EQ(victim->getPosition(), good.position);
            EXPECT_EQ(victim->getOrientation(), good.orientation);
            EXPECT_EQ(victim->getVelocity(), good.velocity);
            EXPECT_EQ(victim->getRotation(), good.rotation);
            EXPECT_EQ(victim->getAngularMomentum(), good.angularMomentum);
            EXPECT_EQ(victim->getTransform(), rigidTransform(good.orientation, good.position));
        }
        for (std::size_t n = 0; n < 20; ++n) {
            if (n != 11) {
                EXPECT_EQ(hashOf(world.getBodies()[n]), hashOf(sound.getBodies()[n < 11 ? n : n - 1]));
            }
        }

        poisoned = false;
        victim->setAwake();
        frame(world);
        EXPECT_TRUE(world.getFaultedBodies().empty());
        EXPECT_TRUE(victim->getAwake());
        EXPECT_TRUE(isNear(victim->getPosition(), good.position + good.velocity * STEP, 1e-2));
    }
}

TEST(World, ListsFaultedBodiesInOrderAndForgetsThoseThatLeave) {
    World world;
    for (int n = 0; n < 600; ++n) world.createBody();
    const auto poison = [&](std::size_t n) {
        RigidBody *body = world.getBodies()[n];
        body->addTorque(Vector3(0, QUIET_NAN, 0));
        return body;
    };
    RigidBody *late = poison(599), *early = poison(3), *middle = poison(300);
    world.runPhysics(STEP);
    EXPECT_EQ(world.getFaultedBodies(), (World::RigidBodies{early, middle, late}));
    world.destroyBody(middle);
    EXPECT_EQ(world.getFaultedBodies(), (World::RigidBodies{early, late}));
    late->setVelocity(1, 0, 0);
    frame(world);
    EXPECT_EQ(world.getFaultedBodies(), World::RigidBodies{early});
    RigidBody *more = poison(100);
    world.runPhysics(STEP);
    EXPECT_EQ(world.getFaultedBodies(), (World::RigidBodies{early, more}));
}

TEST(World, AnOverflowingStepIsAFaultToo) {
    World world;
    RigidBody *runaway = world.createBody(), *spinner = world.createBody();
    runaway->setPosition(1.7e308, 0, 0);
    runaway->setVelocity(1.7e308, 0, 0);
    spinner->setRotation(1e150, 0, 0);
    world.integrate(1);
    EXPECT_EQ(runaway->getPosition(), Vector3(1.7e308, 0, 0));
    EXPECT_TRUE(runaway->hasFaulted());
    EXPECT_TRUE(spinner->getOrientation().isFinite());
    EXPECT_TRUE(spinner->getRotation().isFinite());
}

/// A faulted body stays asleep and listed under generators' forces, until the caller wakes it.
TEST(World, DoesNotWakeFaultedBodiesByForces) {
    World world;
    Gravity gravity;
    RigidBody *const body = world.createBody();
    world.getForceRegistry().add(body, &gravity);
    frame(world);
    const Vector3 position = body->getPosition(), velocity = body->getVelocity();
    world.startFrame();
    body->addForce(Vector3(PLUS_INFINITY, 0, 0));
    world.runPhysics(STEP);
    for (int n = 0; n < 3; ++n) {
        frame(world);
        EXPECT_EQ(world.getFaultedBodies(), World::RigidBodies{body});
        EXPECT_FALSE(body->getAwake());
        EXPECT_EQ(body->getPosition(), position);
        EXPECT_EQ(body->getVelocity(), velocity);
    }
    body->setAwake(true);
    frame(world);
    EXPECT_TRUE(world.getFaultedBodies().empty());
    EXPECT_NEAR(body->getVelocity().y, velocity.y - 9.81 * STEP, 1e-12);
}

/// What would pull the frame from under a generator is refused to it.
TEST(World, RefusesItsFrameCallsToGenerators) {
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

// ---- Worlds among themselves

TEST(World, TwoWorldsOnTwoThreadsNeverMeet) {
    const auto simulate = [](std::uint64_t seed) {
        World world;
        Gravity gravity;
        Drag drag(0.1, 0.01);
        for (std::uint64_t n = 0; n < 50; ++n) {
            RigidBody *body = world.createBody();
            launch(*body, seed + n);
            world.getForceRegistry().add(body, &gravity);
            world.getForceRegistry().add(body, &drag);
        }
        for (int n = 0; n < 100; ++n) frame(world);
        return world.hash();
    };
    const std::uint64_t wanted[2] = {simulate(1), simulate(1000)};
    std::uint64_t got[2] = {};
    std::thread other([&] { got[1] = simulate(1000); });
    got[0] = simulate(1);
    other.join();
    EXPECT_EQ(got[0], wanted[0]);
    EXPECT_EQ(got[1], wanted[1]);
    EXPECT_NE(wanted[0], wanted[1]);
}

}  // namespace

TEST(World, ListsThoseThatFaultInTheFrameInWhichAnotherLeaves) {
    World world;
    RigidBody *const first = world.createBody(), *const second = world.createBody();
    world.destroyBody(first);
    second->addForce(Vector3(QUIET_NAN, 0, 0));
    world.runPhysics(STEP);
    EXPECT_EQ(world.getFaultedBodies(), World::RigidBodies{second});
}

TEST(World, ListsFaultedBodiesStillWhenASoundOneLeaves) {
    World world;
    RigidBody *const sound = world.createBody(), *const faulty = world.createBody();
    faulty->addForce(Vector3(QUIET_NAN, 0, 0));
    world.runPhysics(STEP);
    world.destroyBody(sound);
    EXPECT_EQ(world.getFaultedBodies(), World::RigidBodies{faulty});
}
