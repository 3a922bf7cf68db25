// Memory runs out at every allocation of a game in turn. The call that it happens to has no effect, and the
// game goes on as if memory had sufficed.
#include <cyclone/cyclone.h>
#include <cyclone/print.h>
#include <gtest/gtest.h>

#include <new>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "allocations.h"
#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

/// A force on two bodies. Asked to, it lets another generator act on the second body, too.
class CrossBody : public ForceGenerator {
public:
    CrossBody(ForceRegistry &r, RigidBody *o) : registry(r), other(o) {}
    void enlist(ForceGenerator *generator) { recruit = generator; }
    void updateForce(RigidBody *body, real) override {
        body->addForce(Vector3(0, 1, 0));
        other->addForceAtBodyPoint(Vector3(0, -1, 0), Vector3(0.1, 0, 0));
        if (ForceGenerator *const newcomer = std::exchange(recruit, nullptr)) registry.add(other, newcomer);
    }

private:
    ForceRegistry &registry;
    RigidBody *other;
    ForceGenerator *recruit = nullptr;
};

class Nothing : public JobSystem::Job {
public:
    void run(std::size_t) override {}
};

/// A game that makes every call of the interface that may allocate.
class Game {
public:
    explicit Game(std::size_t threadCount) : threads(threadCount) {}

    /// Plays while memory suffices.
    void play() {
        start();
        changeBodies();
        changeRegistrations();
        ownForces();
        useSnapshots();
        useThreads();
        readBadInput();
        print();
        call([this] { world->clear(); });
        frame();
    }
    /// Plays with one allocation failing. It must have been played before: `costs` says how many allocations
    /// each call makes.
    void playShort(long failingAllocation, const std::vector<long> &callCosts) {
        allocationsLeft = failingAllocation;
        costs = callCosts;
        play();
    }

    bool hasFailed() const { return failed; }
    const std::vector<long> &getCosts() const { return costs; }
    /// All that came of it, the same for every number of threads and whatever failed.
    const std::vector<std::string> &getResults() const { return results; }

private:
    // ---- A game

    void start() {
        call([this] { world.emplace(); });
        call([this] { world->setWorkers(threads); });
        call([this] { sea.addTrain({0.3, 10, 0, 0}); });
        call([this] { sea.addTrain({0.1, 3, 1, 0}); });
        hull.setWater(&sea);
        for (RigidBody &guest : guests) call([&] { world->addBody(&guest); });
        for (int n = 0; n < 140; ++n) {
            const real x = n;
            call([&] { world->createBody()->setPosition(x, 0, 0); });
            if (n % 2 == 0) act(world->getBodies().back(), gravity);
            if (n % 3 == 0) act(world->getBodies().back(), wing);
            if (n % 5 == 0) act(world->getBodies().back(), hull);
        }
        act(&guests[0], pair.emplace(world->getForceRegistry(), &guests[1]));
        frame();
    }

    void changeBodies() {
        for (std::size_t n : {50U, 51U, 90U}) call([&] { world->destroyBody(world->getBodies()[n]); });
        call([this] { world->removeBody(&guests[2]); });
        frame();
        call([this] { world->createBody()->setVelocity(1, 2, 3); });
        call([this] { world->addBody(&guests[2]); });
        act(world->getBodies().back(), drag);
        act(&guests[2], wing);
        frame();
        guests[2].addForce(Vector3(0, QUIET_NAN, 0));  // it faults
        call([this] { world->integrate(STEP); });
    }

    void changeRegistrations() {
        call([this] {
            pair->enlist(&drag);
            world->runPhysics(STEP);
        });
        frame();
        call([this] { world->getForceRegistry().remove(&guests[2], &wing); });
        call([this] { world->getForceRegistry().remove(world->getBodies()[3]); });
        frame();
        call([this] { world->getForceRegistry().clear(); });
        act(&guests[1], drag);
        act(&guests[0], *pair);
        frame();
    }

    void ownForces() {
        call([this] { air.add(&breeze); });
        call([this] {
            owned = &world->createForce<Drag>(world->getBodies()[5], 0.1, 0.1);
            owned->setWind(&air);
        });
        call([this] {
            world->createSpring(world->getBodies()[6], Vector3(), world->getBodies()[7], Vector3(), 10, 1);
        });
        frame();
        call([this] { world->destroyForce(*owned); });
        call([this] { world->destroyBody(world->getBodies()[6]); });
        frame();
    }

    void useSnapshots() {
        call([this] { world->saveState(snapshot); });
        call([this] { world->restoreState(snapshot); });
        frame();
        call([this] { world->createBody(); });
        call([this] { world->destroyBody(world->getBodies()[8]); });
        call([this] { world->restoreState(snapshot); });  // brings one back, and ends the other
        frame();
        call([this] { world->createBody(); });
        call([this] { world->saveState(snapshot); });  // a larger one
    }

    void useThreads() {
        call([this] { world->setWorkers(4); });
        frame();
        call([this] { world->setWorkers(0); });
        call([this] { hostJobs.emplace(2); });
        Nothing job;
        call([&] { hostJobs->parallelFor(5, job); });
        call([this] { world->setJobSystem(&*hostJobs); });
        frame();
    }

    void readBadInput() {
        refuse([this] { guests[0].setMass(-1); });
        refuse([this] { world->addBody(nullptr); });
        refuse([this] { world->setWorkers(1000); });
        refuse([this] { world->restoreState(Snapshot(30)); });
        refuse([this] { sea.addTrain({-1, 0, 0, 0}); });
        refuse([this] { hull.setWater(nullptr), Buoyancy(Vector3(), -1, 1, 0); });
        frame();
    }

    void print() {
        const Vector3 vector(1.0 / 3, -1e300 / 7, 1e-300 / 3);
        printOne(vector);
        printOne(Quaternion(vector.x, vector.y, vector.z, 0.1));
        printOne(Matrix3());
        printOne(Matrix4());
        printOne(guests[0]);
    }

    // ---- Its calls

    void act(RigidBody *body, ForceGenerator &generator) {
        call([&] { world->getForceRegistry().add(body, &generator); });
    }

    void frame() {
        call([this] {
            world->startFrame();
            world->runPhysics(STEP);
        });
        results.push_back(std::to_string(world->hash()));
    }

    template <class Call>
    void refuse(Call function) {
        call([&] {
            bool refused = false;
            try {
                function();
            } catch (const std::invalid_argument &) {
                refused = true;
            }
            EXPECT_TRUE(refused);
        });
    }

    template <class Printed>
    void printOne(const Printed &printed) {
        std::string text;
        call([&] {
            std::ostringstream stream;
            stream << printed;
            if (!stream) throw std::bad_alloc();  // how streams say that memory has run out
            text = stream.str();
        });
        results.push_back(text);
    }

    /// All that can be seen between two frames, and what the next one would give.
    auto look() {
        if (!world) world.emplace();
        world->startFrame();
        const ForceRegistry &registry = world->getForceRegistry();
        Snapshot guestStates, now;
        RigidBody *const guestList[] = {&guests[0], &guests[1], &guests[2]};
        writeSnapshot(guestList, 3, guestStates);
        world->saveState(now);
        const auto seen = std::make_tuple(world->getBodies(), world->getFaultedBodies(), registry.size(),
                                          guestStates, now, snapshot, sea.getHeight(Vector3(1, 2, 3)));
        world->runPhysics(STEP);
        const std::uint64_t next = world->hash();
        world->restoreState(now);
        return std::make_pair(seen, next);
    }

    /// Makes the call. If memory runs out, looks whether that had no effect, and makes it again.
    template <class Call>
    void call(Call function) {
        if (allocationsLeft < 0) {
            const long before = allocations.made;
            function();
            costs.push_back(allocations.made - before);
        } else if (failed || allocationsLeft >= costs[callCount]) {
            function();
            allocationsLeft -= costs[callCount];
        } else {
            fail(function);
            function();
        }
        ++callCount;
    }

    template <class Call>
    void fail(Call function) {
        const auto before = look();
        allocations.untilFailure = allocationsLeft;
        try {
            function();
        } catch (const std::bad_alloc &) {
            failed = true;
        }
        EXPECT_EQ(allocations.untilFailure.exchange(-1), -1) << "there has been no failure";
        EXPECT_TRUE(failed) << "not told";
        EXPECT_TRUE(look() == before);
    }

    static constexpr real STEP = 1.0 / 60;

    std::size_t threads;
    long allocationsLeft = -1;  ///< before the one that fails; negative: none fails
    std::size_t callCount = 0;
    std::vector<long> costs;
    bool failed = false;
    std::vector<std::string> results;

    RigidBody guests[3];
    Waves sea;
    WindSum air;
    WindGradient breeze{Vector3(5, 0, 0), 10};
    Drag *owned = nullptr;
    Gravity gravity;
    Drag drag{0.1, 0.1};
    Aero wing{diagonal(-1, -1, -1), Vector3(0, 0, 1), nullptr};
    Buoyancy hull{Vector3(), 1, 1, 0};
    std::optional<CrossBody> pair;
    Snapshot snapshot;
    std::optional<Workers> hostJobs;
    std::optional<World> world;
};

TEST(Exhaustion, HasNoEffectButBadAlloc) {
    if (!allocationsAreCounted()) GTEST_SKIP();
    Game reference(0);
    reference.play();
    for (std::size_t threads : {0U, 3U}) {
        Game whole(threads);
        whole.play();
        ASSERT_EQ(whole.getResults(), reference.getResults());

        long allocation = 0;
        for (bool more = true; more && !HasFailure(); ++allocation) {
            const long before = allocations.inUse;
            {
                Game game(threads);
                game.playShort(allocation, whole.getCosts());
                more = game.hasFailed();
                EXPECT_EQ(game.getResults(), reference.getResults()) << "allocation " << allocation;
            }
            EXPECT_EQ(allocations.inUse, before) << "allocation " << allocation << " leaks";
        }
        EXPECT_GT(allocation, 100);
    }
}

}  // namespace
