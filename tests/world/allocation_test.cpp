// No allocation happens in a frame. The counter replaces the operator new of this whole program, save where
// a sanitizer has taken it: there these tests are left out.
#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "allocations.h"
#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

Allocations cyclone_test::allocations;

namespace {

/// Null when it fails. The address of the whole block is kept before what is given out.
void *allocate(std::size_t size, std::size_t alignment) noexcept {
    if (allocations.untilFailure >= 0 && allocations.untilFailure-- == 0) return nullptr;
    void *const block = std::malloc(sizeof(void *) + alignment + size);
    if (block == nullptr) return nullptr;
    ++allocations.made;
    ++allocations.inUse;
    void *memory = static_cast<void **>(block) + 1;
    std::size_t space = alignment + size;
    std::align(alignment, size, memory, space);
    static_cast<void **>(memory)[-1] = block;
    return memory;
}

void *allocateOrThrow(std::size_t size, std::size_t alignment) {
    if (void *memory = allocate(size, alignment)) return memory;
    throw std::bad_alloc();
}

void release(void *memory) noexcept {
    if (memory == nullptr) return;
    --allocations.inUse;
    std::free(static_cast<void **>(memory)[-1]);
}

constexpr std::size_t DEFAULT_ALIGNMENT = alignof(std::max_align_t);

}  // namespace

// Weak, for clang's thread sanitizer insists on its own.
#define REPLACEMENT [[gnu::weak, gnu::noinline]]

REPLACEMENT void *operator new(std::size_t size) { return allocateOrThrow(size, DEFAULT_ALIGNMENT); }
REPLACEMENT void *operator new(std::size_t size, const std::nothrow_t &) noexcept {
    return allocate(size, DEFAULT_ALIGNMENT);
}
REPLACEMENT void *operator new(std::size_t size, std::align_val_t alignment) {
    return allocateOrThrow(size, static_cast<std::size_t>(alignment));
}
REPLACEMENT void operator delete(void *memory) noexcept { release(memory); }
REPLACEMENT void operator delete(void *memory, std::size_t) noexcept { release(memory); }
REPLACEMENT void operator delete(void *memory, std::align_val_t) noexcept { release(memory); }
REPLACEMENT void operator delete(void *memory, std::size_t, std::align_val_t) noexcept { release(memory); }

bool cyclone_test::allocationsAreCounted() {
    const long before = allocations.made;
    ::operator delete(::operator new(100));  // a call, which the compiler may not leave out as it may new int
    return allocations.made > before;
}

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
    const long before = allocations.made;
    for (int n = 0; n < frames; ++n) {
        world.startFrame();
        world.getBodies()[5]->addForce(Vector3(0, 0, 1));
        world.getBodies()[7]->addForce(Vector3(0, n % 3 == 0 ? QUIET_NAN : 1, 0));
        world.runPhysics(1.0 / 60);
    }
    return allocations.made - before;
}

TEST(Allocation, CounterCounts) {
    if (!allocationsAreCounted()) GTEST_SKIP();
    const long made = allocations.made, inUse = allocations.inUse;
    void *const plain = ::operator new(100);
    void *const aligned = ::operator new(100, std::align_val_t(256));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(aligned) % 256, 0U);
    EXPECT_EQ(allocations.inUse, inUse + 2);
    ::operator delete(plain);
    ::operator delete(aligned, std::align_val_t(256));
    EXPECT_EQ(allocations.made, made + 2);
    EXPECT_EQ(allocations.inUse, inUse);
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

/// Bodies and registrations come and go, beside a ring of snapshots that can bring them back.
TEST(Allocation, NoneInASteadyComingAndGoing) {
    if (!allocationsAreCounted()) GTEST_SKIP();
    Gravity gravity;
    Drag drag(1, 1);
    World world;
    std::vector<RigidBody *> bodies;
    std::vector<Snapshot> ring(8);
    const auto replace = [&](RigidBody *&body) {
        if (body != nullptr) world.destroyBody(body);
        body = world.createBody();
        world.getForceRegistry().add(body, &gravity);
        world.getForceRegistry().add(body, &drag);
    };
    bodies.resize(500);
    for (RigidBody *&body : bodies) replace(body);
    const auto runFrames = [&](std::size_t begin, std::size_t end) {
        const long before = allocations.made;
        for (std::size_t frame = begin; frame < end; ++frame) {
            world.saveState(ring[frame % ring.size()]);
            for (std::size_t n = 0; n < 20; ++n) replace(bodies[(20 * frame + n) * 7 % bodies.size()]);
            world.startFrame();
            world.runPhysics(0.01);
        }
        return allocations.made - before;
    };
    EXPECT_GT(runFrames(0, 200), 0) << "the snapshots' memory";
    EXPECT_EQ(runFrames(200, 600), 0);
}

TEST(Allocation, SavingAgainReusesTheSnapshot) {
    World world;
    for (int n = 0; n < 100; ++n) world.createBody();
    Snapshot snapshot;
    world.saveState(snapshot);
    const long before = allocations.made;
    world.saveState(snapshot);
    world.restoreState(snapshot);
    world.hash();
    EXPECT_EQ(allocations.made - before, 0);
}

}  // namespace
