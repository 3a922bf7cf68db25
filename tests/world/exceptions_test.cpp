// Generators and jobs that throw: the frame is called off, and the next one is as if it had never begun.
#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

constexpr real STEP = 1.0 / 60;

/// Pushes, and throws when armed and called for the victim.
class Faulty : public ForceGenerator {
public:
    explicit Faulty(bool c) : crossesBodies(c) {}
    void updateForce(RigidBody *body, real) override {
        body->addForceAtBodyPoint(Vector3(1, 2, 3), Vector3(0, 0.1, 0));
        if (body == victim) throw std::runtime_error("no fuel");
    }
    bool actsOnItsBodyOnly() const override { return !crossesBodies; }

    const RigidBody *victim = nullptr;

private:
    bool crossesBodies;
};

/// A world whose bodies all have gravity, a faulty generator and drag, in this order.
struct Fleet {
    World world;
    Gravity gravity;
    Drag drag{0.3, 0.1};
    Faulty faulty;

    Fleet(std::size_t size, std::size_t threads, bool crossesBodies) : faulty(crossesBodies) {
        Random random(3);
        for (std::size_t n = 0; n < size; ++n) {
            RigidBody *const body = world.createBody();
            body->setVelocity(random.vector(5));
            body->setRotation(random.vector(2));
            for (ForceGenerator *force :
                 {static_cast<ForceGenerator *>(&gravity), static_cast<ForceGenerator *>(&faulty),
                  static_cast<ForceGenerator *>(&drag)})
                world.getForceRegistry().add(body, force);
        }
        world.setWorkers(threads);
    }
    ~Fleet() { world.clear(); }
    Fleet(const Fleet &) = delete;
    Fleet &operator=(const Fleet &) = delete;

    void addCallersForces() {
        world.startFrame();
        for (std::size_t n = 0; n < world.getBodies().size(); n += 5)
            world.getBodies()[n]->addForceAtBodyPoint(Vector3(7, 0, 1), Vector3(0, 0, 0.2));
    }
};

/// The caller's forces stay for another try; generators' are taken back, and nothing has moved.
TEST(AGeneratorThatThrows, LeavesTheFrameToBeTriedAgain) {
    for (bool crossesBodies : {false, true})
        for (std::size_t threads : {1U, 3U})
            for (std::size_t size : {20U, 5000U}) {
                Fleet disturbed(size, threads, crossesBodies), quiet(size, 1, crossesBodies);
                for (std::size_t n = 0; n < 6; ++n) {
                    disturbed.addCallersForces();
                    quiet.addCallersForces();
                    disturbed.faulty.victim = disturbed.world.getBodies()[(n * 1234 + 7) % size];
                    const std::uint64_t before = disturbed.world.hash();
                    ASSERT_THROW(disturbed.world.runPhysics(STEP), std::runtime_error);
                    ASSERT_EQ(disturbed.world.hash(), before) << "added forces are part of it";
                    disturbed.faulty.victim = nullptr;
                    disturbed.world.runPhysics(STEP);
                    quiet.world.runPhysics(STEP);
                    ASSERT_EQ(disturbed.world.hash(), quiet.world.hash())
                        << size << " bodies, " << threads << " threads, frame " << n;
                }
            }
}

TEST(AGeneratorThatThrows, LeavesNothingToTheNextFrame) {
    for (std::size_t threads : {1U, 3U}) {
        Fleet disturbed(5000, threads, false), quiet(5000, 1, false);
        disturbed.addCallersForces();
        disturbed.faulty.victim = disturbed.world.getBodies()[2500];
        EXPECT_THROW(disturbed.world.runPhysics(STEP), std::runtime_error);
        disturbed.faulty.victim = nullptr;
        for (Fleet *fleet : {&disturbed, &quiet}) {
            fleet->world.startFrame();
            fleet->world.runPhysics(STEP);
        }
        EXPECT_EQ(disturbed.world.hash(), quiet.world.hash());
    }
}

/// What it did before it threw holds: a body destroyed, a generator ended, a registration added.
TEST(AGeneratorThatThrows, MayHaveChangedTheWorldBefore) {
    class Saboteur : public ForceGenerator {
    public:
        Saboteur(World &w, RigidBody *v, int &count) : world(w), victim(v), alive(count) { ++alive; }
        ~Saboteur() override { --alive; }
        void updateForce(RigidBody *body, real) override {
            world.destroyBody(victim);
            world.createBody()->setPosition(5, 0, 0);
            world.createForce<Gravity>(body);
            world.destroyForce(*this);
            throw std::runtime_error("done");
        }

    private:
        World &world;
        RigidBody *victim;
        int &alive;
    };
    int alive = 0;
    World world;
    RigidBody *const body = world.createBody(), *const victim = world.createBody();
    world.createForce<Saboteur>(body, world, victim, alive);
    world.createForce<Drag>(victim, 1, 1);
    EXPECT_THROW(world.runPhysics(STEP), std::runtime_error);
    EXPECT_EQ(alive, 0);
    ASSERT_EQ(world.getBodies().size(), 2U);
    EXPECT_EQ(world.getBodies()[1]->getPosition(), Vector3(5, 0, 0));
    EXPECT_EQ(world.getForceRegistry().size(), 1U);
    world.runPhysics(STEP);
    EXPECT_NEAR(body->getVelocity().y, -9.81 * STEP, 1e-15);
}

/// A host's job system that gives up in the middle of a loop.
class GivingUp : public JobSystem {
public:
    bool gives = false;
    std::size_t after = 0;

    void parallelFor(std::size_t count, Job &job) override {
        for (std::size_t n = 0; n < count; ++n) {
            if (gives && n == after) throw std::runtime_error("no thread");
            job.run(n);
        }
    }
};

TEST(AJobSystemThatThrows, LeavesTheWorldUsable) {
    World world;
    GivingUp jobs;
    world.setJobSystem(&jobs);
    for (int n = 0; n < 5000; ++n) world.createBody()->setVelocity(60, 0, 0);
    const World::RigidBodies bodies = world.getBodies();
    for (const std::size_t n : {3U, 4996U}) bodies[n]->addForce(Vector3(QUIET_NAN, 0, 0));
    jobs.gives = true;
    jobs.after = 4;
    EXPECT_THROW(world.integrate(STEP), std::runtime_error);
    EXPECT_EQ(world.getFaultedBodies().size(), 1U) << "the one that it came to is listed all the same";
    const auto positionOf = [&bodies](std::size_t n) { return bodies[n]->getPosition().x; };
    const real first = positionOf(10), last = positionOf(4990);
    EXPECT_NEAR(first + last, 1, 1e-14) << "some have moved, and some have not";
    jobs.gives = false;
    for (const std::size_t n : {3U, 4996U}) world.destroyBody(bodies[n]);
    world.createBody();
    world.startFrame();
    world.runPhysics(STEP);
    EXPECT_NEAR(positionOf(10), first + 1, 1e-14);
    EXPECT_NEAR(positionOf(4990), last + 1, 1e-14);
    EXPECT_TRUE(world.getFaultedBodies().empty());
}

}  // namespace
