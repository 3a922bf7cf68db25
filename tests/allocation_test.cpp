// No allocation happens in a frame. The counter replaces the operator new of this whole program.
#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "random.h"

namespace {

std::atomic<long> allocations{0};

}  // namespace

[[gnu::noinline]] void *operator new(std::size_t size, const std::nothrow_t &) noexcept {
    ++allocations;
    return std::malloc(size > 0 ? size : 1);
}
[[gnu::noinline]] void *operator new(std::size_t size) {
    if (void *memory = operator new(size, std::nothrow)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void *memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void *memory, std::size_t) noexcept { std::free(memory); }

using namespace cyclone;
using namespace cyclone_test;

namespace {

class Pair : public ForceGenerator {
public:
    explicit Pair(RigidBody *o) : other(o) {}
    void updateForce(RigidBody *body, real) override {
        body->addForce(Vector3(0, 1, 0));
        other->addForce(Vector3(0, -1, 0));
    }

private:
    RigidBody *other;
};

long allocationsIn(World &world, int frames) {
    const long before = allocations;
    for (int n = 0; n < frames; ++n) {
        world.startFrame();
        world.getBodies()[5]->addForce(Vector3(0, 0, 1));
        world.getBodies()[7]->addForce(Vector3(0, n % 3 == 0 ? QUIET_NAN : 1, 0));
        world.runPhysics(1.0 / 60);
    }
    return allocations - before;
}

TEST(Allocation, CounterCounts) {
    const long before = allocations;
    ::operator delete(::operator new(100));  // a call, which the compiler may not leave out as it may new int
    EXPECT_EQ(allocations, before + 1);
}

TEST(Allocation, NoneInAFrame) {
    const Vector3 wind(1, 0, 0);
    Gravity gravity;
    Drag drag(0.1, 0.1);
    Aero wing(diagonal(-1, -1, -1), Vector3(0, 0, 1), &wind);
    Buoyancy hull(Vector3(), 1, 1, 0);
    Waves sea;
    sea.addTrain({0.3, 10, 0, 0});
    hull.setWater(&sea);
    for (std::size_t threads : {0U, 3U}) {
        World world;
        world.setWorkers(threads);
        for (int n = 0; n < 700; ++n) world.createBody();
        ForceRegistry &registry = world.getForceRegistry();
        Pair pair(world.getBodies()[0]);
        for (std::size_t n = 0; n < 700; ++n) {
            RigidBody *body = world.getBodies()[n];
            body->setPosition(static_cast<real>(n), 0, 0);
            for (ForceGenerator *force :
                 {static_cast<ForceGenerator *>(&gravity), static_cast<ForceGenerator *>(&drag),
                  static_cast<ForceGenerator *>(&wing), static_cast<ForceGenerator *>(&hull)})
                registry.add(body, force);
            if (n % 100 == 1) registry.add(body, &pair);
        }
        EXPECT_EQ(allocationsIn(world, 10), 0) << threads << " threads, new world";

        for (int n = 0; n < 100; ++n) {
            world.destroyBody(world.getBodies()[static_cast<std::size_t>(n) + 50]);
            registry.add(world.createBody(), &gravity);
            registry.remove(world.getBodies()[static_cast<std::size_t>(n) + 20], &drag);
        }
        for (int n = 0; n < 500; ++n) registry.add(world.createBody(), &drag);
        EXPECT_EQ(allocationsIn(world, 10), 0) << threads << " threads, after changes";

        registry.clear();
        EXPECT_EQ(allocationsIn(world, 2), 0) << threads << " threads, no registrations";
    }
}

TEST(Allocation, SavingAgainReusesTheSnapshot) {
    World world;
    for (int n = 0; n < 100; ++n) world.createBody();
    Snapshot snapshot;
    world.saveState(snapshot);
    const long before = allocations;
    world.saveState(snapshot);
    world.restoreState(snapshot);
    world.hash();
    EXPECT_EQ(allocations - before, 0);
}

}  // namespace
