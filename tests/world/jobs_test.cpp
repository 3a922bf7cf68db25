// Threads: the loop itself, and that a world's result does not depend on how its work is shared out.
#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

constexpr real STEP = 1.0 / 60;

// ---- The loop

struct Counting : JobSystem::Job {
    std::vector<std::atomic<int>> runs;
    std::size_t failing = ~std::size_t(0);

    explicit Counting(std::size_t count) : runs(count) {}
    void run(std::size_t index) override {
        if (index == failing) throw std::runtime_error("part failed");
        ++runs.at(index);
    }
};

TEST(Workers, RunEachPartOnce) {
    for (std::size_t threads : {1U, 2U, 3U, 8U}) {
        Workers workers(threads);
        for (std::size_t count : {0U, 1U, 2U, 7U, 1000U})
            for (int repeat = 0; repeat < 5; ++repeat) {
                Counting job(count);
                workers.parallelFor(count, job);
                for (const std::atomic<int> &runs : job.runs) ASSERT_EQ(runs, 1);
            }
    }
}

TEST(Workers, MayBeAsManyAsTheLimitSays) {
    Workers workers(Workers::MAX_THREADS);
    Counting job(1000);
    workers.parallelFor(1000, job);
    for (const std::atomic<int> &runs : job.runs) ASSERT_EQ(runs, 1);
    EXPECT_THROW(Workers(Workers::MAX_THREADS + 1), std::invalid_argument);
}

TEST(Workers, ShareTheWorkWithTheCaller) {
    // Each part waits until all four have begun: it takes four threads at once, which sleep at first.
    struct Meeting : JobSystem::Job {
        std::atomic<int> begun{0};
        void run(std::size_t) override {
            ++begun;
            while (begun < 4) std::this_thread::yield();
        }
    } job;
    Workers workers(4);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    workers.parallelFor(4, job);
    EXPECT_EQ(job.begun, 4);
}

TEST(Workers, PassAnExceptionOnAndGoOn) {
    for (std::size_t threads : {1U, 3U}) {
        Workers workers(threads);
        for (std::size_t failing : {0U, 50U, 99U}) {
            Counting job(100);
            job.failing = failing;
            EXPECT_THROW(workers.parallelFor(100, job), std::runtime_error);
            for (const std::atomic<int> &runs : job.runs) EXPECT_LE(runs, 1);
            Counting next(100);
            workers.parallelFor(100, next);
            for (const std::atomic<int> &runs : next.runs) EXPECT_EQ(runs, 1);
        }
    }
}

TEST(Workers, RunALoopWithinALoopToTheEnd) {
    struct Outer : JobSystem::Job {
        explicit Outer(Workers &w) : workers(w) {}
        Workers &workers;
        std::atomic<int> runs{0};
        void run(std::size_t) override {
            Counting inner(37);
            workers.parallelFor(37, inner);
            for (const std::atomic<int> &run : inner.runs) runs += run;
        }
    };
    for (std::size_t threads : {1U, 3U}) {
        Workers workers(threads);
        Outer outer(workers);
        workers.parallelFor(100, outer);
        EXPECT_EQ(outer.runs, 3700) << threads << " threads";
        Counting after(100);
        workers.parallelFor(100, after);
        for (const std::atomic<int> &runs : after.runs) EXPECT_EQ(runs, 1);
    }
}

// ---- A world with a bit of everything

/// An elastic band that pulls its body and another at once.
class Band : public ForceGenerator {
public:
    explicit Band(RigidBody *o) : other(o) {}
    void updateForce(RigidBody *body, real) override {
        const Vector3 pull = (other->getPosition() - body->getPosition()) * 0.1;
        body->addForce(pull);
        other->addForceAtBodyPoint(-pull, Vector3(0.1, 0.2, 0.3));
    }

private:
    RigidBody *other;
};

/// Depends on the body alone; an absurd force for the poisoned ones.
class Poison : public ForceGenerator {
public:
    void updateForce(RigidBody *body, real) override {
        if (body->getVelocity().y < -2) body->addForce(Vector3(0, QUIET_NAN, 0));
    }
    bool actsOnItsBodyOnly() const override { return true; }
};

class RichScene {
public:
    static constexpr std::size_t SIZE = 4500;  ///< enough to be shared out

    World world;

    RichScene() {
        Random random(77);
        for (std::size_t n = 0; n < SIZE; ++n) addBody(random);
        const World::RigidBodies &bodies = world.getBodies();
        ForceRegistry &registry = world.getForceRegistry();
        for (std::size_t n = 0; n < SIZE; ++n) {
            RigidBody *body = bodies[n], *next = bodies[(n + 1) % SIZE], *far = bodies[(7 * n + 3) % SIZE];
            registry.add(body, &gravity);
            registry.add(body, keep<Spring>(random.vector(), next, random.vector(), 5.0, 1.0));
            if (n % 1500 == 0) registry.add(body, keep<Band>(far));
            registry.add(body, &wing);
            registry.add(body, &drag);
            if (n % 50 == 17) registry.add(body, &poison);
            if (n % 1500 == 11) registry.add(far, keep<Band>(body));
        }
        // One body with more registrations than a share of the work holds.
        for (int n = 0; n < 700; ++n)
            registry.add(bodies[n % 2 == 0 ? 400 : 401],
                         keep<Bungee>(random.vector(), bodies[5], random.vector(), 0.01, 1.0));
    }

    std::uint64_t run(int frames) {
        for (int n = 0; n < frames; ++n) {
            world.startFrame();
            for (std::size_t body = 0; body < SIZE; body += 13)
                world.getBodies()[body]->addForceAtBodyPoint(Vector3(1, 0, n), Vector3(0, 1, 0));
            wind.x += 0.1;
            world.runPhysics(STEP);
        }
        return world.hash();
    }

private:
    void addBody(Random &random) {
        RigidBody *body = world.createBody();
        body->setPosition(random.vector(30));
        body->setOrientation(random.orientation());
        body->setVelocity(random.vector());
        body->setRotation(random.vector());
        body->setMass(random.between(0.5, 2));
        if (random.between(0, 1) < 0.5) body->setInertiaTensor(Matrix3(2, 0.1, 0, 0.1, 2.5, 0.2, 0, 0.2, 3));
        if (random.between(0, 1) < 0.1) body->setInverseMass(0);
        if (random.between(0, 1) < 0.1) body->setInverseInertiaTensor(diagonal(1, 0, 0.5));
        if (random.between(0, 1) < 0.3) body->setCanSleep();
        if (random.between(0, 1) < 0.1) body->setAwake(false);
    }
    template <class Force, class... Arguments>
    ForceGenerator *keep(Arguments... arguments) {
        forces.push_back(std::make_unique<Force>(arguments...));
        return forces.back().get();
    }

    Vector3 wind = Vector3(1, 0, 2);
    Gravity gravity{Vector3(0, -1, 0)};
    Drag drag{0.05, 0.01};
    Aero wing{Matrix3(-0.1, 0, 0, 0.2, -0.3, 0, 0, 0, -0.1), Vector3(0.1, 0, 0.2), &wind};
    Poison poison;
    std::vector<std::unique_ptr<ForceGenerator>> forces;
};

/// A host's job system that runs the parts from the last to the first.
class Backwards : public JobSystem {
public:
    std::size_t longest = 0;

    void parallelFor(std::size_t count, Job &job) override {
        longest = count > longest ? count : longest;
        while (count-- > 0) job.run(count);
    }
};

std::uint64_t wantedHash() {
    static const std::uint64_t hash = RichScene().run(40);
    return hash;
}

TEST(WorldOnThreads, GivesTheSameBits) {
    for (std::size_t threads : {0U, 1U, 2U, 3U, 8U}) {
        RichScene scene;
        scene.world.setWorkers(threads);
        EXPECT_EQ(scene.run(40), wantedHash()) << threads << " threads";
        EXPECT_FALSE(scene.world.getFaultedBodies().empty());
    }
}

TEST(WorldOnThreads, GivesTheSameBitsInAnyOrderOfTheParts) {
    RichScene scene;
    Backwards backwards;
    scene.world.setJobSystem(&backwards);
    EXPECT_EQ(scene.run(40), wantedHash());
    EXPECT_GT(backwards.longest, 2U);
}

/// Two threads meet in a frame: each call waits for one on another thread, for ten seconds at most.
TEST(WorldOnThreads, TwoWorkersAreTwoThreads) {
    class Meeting : public ForceGenerator {
    public:
        void updateForce(RigidBody *, real) override {
            const std::thread::id none, self = std::this_thread::get_id();
            std::thread::id seen = none;
            if (first.compare_exchange_strong(seen, self) || seen == self) {
                while (!hasMet && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
            } else {
                hasMet = true;
            }
        }
        bool actsOnItsBodyOnly() const override { return true; }
        std::atomic<bool> hasMet{false};

    private:
        std::atomic<std::thread::id> first{};
        const std::chrono::steady_clock::time_point deadline =
            std::chrono::steady_clock::now() + std::chrono::seconds(10);
    } meeting;
    World world;
    world.setWorkers(2);
    for (int n = 0; n < 5000; ++n) world.getForceRegistry().add(world.createBody(), &meeting);
    world.runPhysics(STEP);
    EXPECT_TRUE(meeting.hasMet);
}

TEST(WorldOnThreads, SmallWorldsStayOnTheCallersThread) {
    class Witness : public ForceGenerator {
    public:
        void updateForce(RigidBody *, real) override {
            if (std::this_thread::get_id() != caller) ++strangers;
        }
        bool actsOnItsBodyOnly() const override { return true; }
        std::atomic<int> strangers{0};

    private:
        const std::thread::id caller = std::this_thread::get_id();
    } witness;
    World world;
    world.setWorkers(2);
    for (int n = 0; n < 1000; ++n) world.getForceRegistry().add(world.createBody(), &witness);
    for (int n = 0; n < 100; ++n) world.runPhysics(STEP);
    EXPECT_EQ(witness.strangers, 0);
}

TEST(WorldOnThreads, HostsJobSystemIsUsedForWhateverHasTwoParts) {
    class Counted : public JobSystem {
    public:
        int loops = 0;
        void parallelFor(std::size_t count, Job &job) override {
            ++loops;
            for (std::size_t n = 0; n < count; ++n) job.run(n);
        }
    } counted;
    Gravity gravity;
    for (int size : {200, 300, 5000}) {
        World world;
        world.setJobSystem(&counted);
        for (int n = 0; n < size; ++n) world.getForceRegistry().add(world.createBody(), &gravity);
        counted.loops = 0;
        world.runPhysics(STEP);
        EXPECT_EQ(counted.loops, size == 200 ? 0 : 2) << "one for the forces, one for the steps";
        for (const RigidBody *body : world.getBodies())
            ASSERT_NEAR(body->getVelocity().y, -9.81 * STEP, 1e-15);
    }
}

TEST(WorldOnThreads, MayChangeItsJobSystemAtAnyTime) {
    RichScene scene;
    Backwards backwards;
    scene.run(10);
    scene.world.setWorkers(3);
    scene.run(10);
    scene.world.setJobSystem(&backwards);
    scene.run(10);
    scene.world.setWorkers(2);
    scene.run(10);
    scene.world.setJobSystem(nullptr);
    scene.run(10);
    scene.world.setWorkers(0);
    EXPECT_GT(backwards.longest, 0U);
    scene.run(10);
}

TEST(WorldOnThreads, SceneChangesWithEachOfItsParts) {
    // Lest the comparisons above compare nothing: another frame is another hash.
    RichScene scene;
    EXPECT_NE(scene.run(39), wantedHash());
    EXPECT_EQ(RichScene().run(40), wantedHash());
}

TEST(WorldOnThreads, WorldsWithWorkersOfTheirOwnNeverMeet) {
    std::array<std::uint64_t, 2> hashes = {};
    const auto simulate = [&](std::size_t n) {
        RichScene scene;
        scene.world.setWorkers(2);
        hashes.at(n) = scene.run(40);
    };
    std::thread other([&] { simulate(1); });
    simulate(0);
    other.join();
    EXPECT_EQ(hashes[0], wantedHash());
    EXPECT_EQ(hashes[1], wantedHash());
}

// ---- Generators that misbehave on a worker

/// Says that it acts on its body only, and does what it is told when called for one of the bodies.
class Trap : public ForceGenerator {
public:
    explicit Trap(RigidBody *v) : victim(v) {}
    void updateForce(RigidBody *body, real) override {
        body->addForce(Vector3(60, 0, 0));
        if (body == victim) spring();
    }
    bool actsOnItsBodyOnly() const override { return true; }

protected:
    virtual void spring() = 0;
    RigidBody *victim;
};

struct Trapped : testing::Test {
    World world;
    std::size_t size = 5000;

    Trapped() {
        for (std::size_t n = 0; n < size; ++n) world.createBody();
        world.setWorkers(3);
    }
    RigidBody *victim() { return world.getBodies()[777]; }
    void registerForAll(ForceGenerator &force) {
        for (RigidBody *body : world.getBodies()) world.getForceRegistry().add(body, &force);
    }
    void frame() {
        world.startFrame();
        world.runPhysics(STEP);
    }
};

using WorldWithTrap = Trapped;

TEST_F(WorldWithTrap, ExceptionReachesTheCallerAndTheWorldGoesOn) {
    struct Throwing : Trap {
        using Trap::Trap;
        bool armed = true;
        void spring() override {
            if (armed) throw std::runtime_error("no fuel");
        }
    } force(victim());
    registerForAll(force);
    EXPECT_THROW(frame(), std::runtime_error);
    for (const RigidBody *body : world.getBodies()) EXPECT_EQ(body->getVelocity(), Vector3());
    force.armed = false;
    frame();
    for (const RigidBody *body : world.getBodies()) EXPECT_NEAR(body->getVelocity().x, 1, 1e-14);
}

struct Calling : Trap {
    using Trap::Trap;
    std::function<void()> call;
    void spring() override { call(); }
};

TEST_F(WorldWithTrap, RegistrationsMayNotChangeOnAWorker) {
    RigidBody stranger;
    Calling force(victim());
    ForceRegistry &registry = world.getForceRegistry();
    const std::function<void()> calls[] = {
        [&] { registry.add(victim(), &force); },
        [&] { registry.remove(victim(), &force); },
        [&] { registry.remove(victim()); },
        [&] { registry.remove(&force); },
        [&] { world.createForce<Gravity>(victim()); },
        [&] { world.addBody(&stranger); },
        [&] { world.createBody(); },
    };
    for (const std::function<void()> &call : calls) {
        force.call = call;
        registerForAll(force);
        EXPECT_THROW(frame(), std::invalid_argument) << &call - calls;
        EXPECT_EQ(registry.size(), size) << &call - calls;
        EXPECT_EQ(world.getBodies().size(), size) << &call - calls;
        registry.clear();
    }
    Gravity gravity;
    registerForAll(gravity);
    frame();
    EXPECT_NEAR(victim()->getVelocity().y, -9.81 * STEP, 1e-15);
}

TEST_F(WorldWithTrap, BodiesMayNotLeaveOnAWorker) {
    Calling force(victim());
    force.call = [&] { world.destroyBody(victim()); };
    registerForAll(force);
    RigidBody *body = victim();
    EXPECT_THROW(frame(), std::invalid_argument);
    EXPECT_EQ(world.getBodies().size(), size);
    EXPECT_EQ(victim(), body);
    EXPECT_THROW(world.addBody(body), std::invalid_argument);  // it is still a member
    EXPECT_NO_THROW(world.destroyBody(body));
}

TEST_F(WorldWithTrap, GeneratorsThatSayTheyActOnMoreMayChangeAnything) {
    struct Ending : ForceGenerator {
        explicit Ending(World &w) : world(w) {}
        void updateForce(RigidBody *body, real) override { world.destroyBody(body); }
        World &world;
    } end(world);
    Gravity gravity;
    registerForAll(gravity);
    for (std::size_t n = 0; n < size; n += 2) world.getForceRegistry().add(world.getBodies()[n], &end);
    registerForAll(gravity);
    frame();
    ASSERT_EQ(world.getBodies().size(), size / 2);
    for (const RigidBody *body : world.getBodies())
        ASSERT_NEAR(body->getVelocity().y, 2 * -9.81 * STEP, 1e-15);
    frame();
    EXPECT_NEAR(world.getBodies()[3]->getVelocity().y, 4 * -9.81 * STEP, 1e-15);
}

}  // namespace

/// Two parts throw at once.
TEST(Workers, PassOneOfTwoExceptionsOn) {
    struct Failing : JobSystem::Job {
        std::atomic<int> begun{0};
        void run(std::size_t) override {
            ++begun;
            while (begun < 2) std::this_thread::yield();
            throw std::runtime_error("part failed");
        }
    } job;
    Workers workers(2);
    EXPECT_THROW(workers.parallelFor(2, job), std::runtime_error);
    Counting next(100);
    workers.parallelFor(100, next);
    for (const std::atomic<int> &runs : next.runs) EXPECT_EQ(runs, 1);
}

/// Generators that act on their body only, some of them removed, before and after one that may act on any.
TEST(WorldOnThreads, CallsEachGeneratorOnceAroundGaps) {
    World world;
    Backwards hostJobs;
    world.setJobSystem(&hostJobs);
    struct MayActOnAny : ForceGenerator {
        void updateForce(RigidBody *, real) override {}
    } other;
    Gravity gravity;
    ForceRegistry &registry = world.getForceRegistry();
    const auto add = [&] {
        for (int n = 0; n < 600; ++n) registry.add(world.createBody(), &gravity);
    };
    add();
    registry.add(world.getBodies()[0], &other);
    add();
    for (const std::size_t n : {100U, 900U}) registry.remove(world.getBodies()[n], &gravity);
    world.startFrame();
    world.runPhysics(STEP);
    EXPECT_GT(hostJobs.longest, 1U);
    for (std::size_t n = 0; n < 1200; ++n)
        ASSERT_NEAR(world.getBodies()[n]->getVelocity().y, n == 100 || n == 900 ? 0 : -9.81 * STEP, 1e-15)
            << n;
}
