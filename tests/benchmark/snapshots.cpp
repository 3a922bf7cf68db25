#include <cstdio>

#include "benchmark.h"
#include "scene.h"
#include "timing.h"

namespace benchmark {

namespace {

constexpr std::size_t RUNS = 200;

using cyclone::RigidBody;
using cyclone::Snapshot;
using cyclone::World;

void printRow(const char *name, std::size_t count, const Timings &times, const Timings &copying) {
    std::printf("%-24s %9zu %9.1f %9.1f %8.2f\n", name, count, times.least() / static_cast<double>(count),
                times.median() / static_cast<double>(count), times.least() / copying.least());
}

void measureSnapshotsOf(std::size_t count) {
    Scene scene;
    scene.owned = true;
    CycloneRun run(scene, count);
    run.frame();
    World &world = run.getWorld();
    const World::RigidBodies &bodies = world.getBodies();
    std::vector<RigidBody> copies(count);
    Snapshot snapshot;
    world.saveState(snapshot);
    const Snapshot fromElsewhere(snapshot.begin(), snapshot.end());

    Timings copying, saving, restoring, restoringForeign, hashing;
    for (std::size_t n = 0; n < RUNS; ++n) {
        copying.add(timeOf([&] {
            for (std::size_t k = 0; k < count; ++k) copies[k] = *bodies[k];
        }));
        saving.add(timeOf([&] { world.saveState(snapshot); }));
        restoring.add(timeOf([&] { world.restoreState(snapshot); }));
        restoringForeign.add(timeOf([&] { world.restoreState(fromElsewhere); }));
        hashing.add(timeOf([&] { keep(world.hash()); }));
    }
    printRow("plain copy", count, copying, copying);
    printRow("saveState", count, saving, copying);
    printRow("restoreState", count, restoring, copying);
    printRow("  of bytes from elsewhere", count, restoringForeign, copying);
    printRow("hash", count, hashing, copying);
}

/// Microseconds of going back by eight frames, and of stepping and saving each of them anew.
void measureRollbackOf(std::size_t count) {
    constexpr std::size_t FRAMES = 8;
    Scene scene;
    scene.owned = true;
    CycloneRun run(scene, count);
    World &world = run.getWorld();
    std::vector<Snapshot> snapshots(FRAMES + 1);
    world.saveState(snapshots[0]);
    const auto advance = [&](bool save) {
        for (std::size_t n = 0; n < FRAMES; ++n) {
            run.frame();
            if (save) world.saveState(snapshots[n + 1]);
        }
    };

    Timings rollback, frames;
    for (std::size_t n = 0; n < RUNS; ++n) {
        frames.add(timeOf([&] { advance(false); }));
        rollback.add(timeOf([&] {
            world.restoreState(snapshots[0]);
            advance(true);
        }));
    }
    std::printf("%-24s %9zu %9.1f %9.1f %8.2f\n", "", count, rollback.least() / 1000, frames.least() / 1000,
                rollback.least() / frames.least());
}

}  // namespace

void measureSnapshots() {
    std::printf("\nSnapshots: ns per body.\n\n%-24s %9s %9s %9s %8s\n", "", "bodies", "least", "median",
                "ratio");
    for (const std::size_t count : {1000u, 10000u}) measureSnapshotsOf(count);
}

void measureRollback() {
    std::printf("\nRollback by eight frames, each stepped and saved again: µs.\n\n%-24s %9s %9s %9s %8s\n",
                "", "bodies", "rollback", "8 frames", "ratio");
    for (const std::size_t count : {64u, 1000u, 10000u}) measureRollbackOf(count);
}

}  // namespace benchmark
