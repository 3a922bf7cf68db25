#include "snapshots.h"

#include <cyclone/cyclone.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace {

/// Microseconds, of the quickest of many runs.
template <class Action>
double leastTime(Action action) {
    double least = 1e300;
    for (int n = 0; n < 200; ++n) {
        const auto begin = std::chrono::steady_clock::now();
        action();
        const std::chrono::duration<double, std::micro> passed = std::chrono::steady_clock::now() - begin;
        least = std::min(least, passed.count());
    }
    return least;
}

}  // namespace

void measureSnapshots() {
    constexpr int COUNT = 1000;
    cyclone::World world;
    for (int n = 0; n < COUNT; ++n) {
        cyclone::RigidBody *const body = world.createBody();
        body->setPosition(n, 0, 0);
        body->setRotation(1, 2, 0.001 * n);
        body->setDamping(0.95, 0.8);
    }
    world.runPhysics(1.0 / 60);

    cyclone::Snapshot one, all;
    world.saveState(all);
    cyclone::writeSnapshot(world.getBodies().data(), 1, one);
    volatile std::uint64_t hash = 0;  // keeps the compiler from leaving the work out
    const double save = leastTime([&] { world.saveState(all); });
    const double restore = leastTime([&] { world.restoreState(all); });
    const double sum = leastTime([&] { hash = world.hash(); });
    std::printf("\nSnapshots: %zu bytes per body; %d bodies: save %.0f µs, restore %.0f µs, hash %.0f µs\n",
                (all.size() - one.size()) / (COUNT - 1), COUNT, save, restore, sum);
}
