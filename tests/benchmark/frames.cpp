#include <algorithm>
#include <cstdio>

#include "benchmark.h"
#include "scene.h"
#include "timing.h"

namespace benchmark {

namespace {

/// Fewer of worlds so large that one run is long.
std::size_t runsFor(std::size_t count) { return count < 500000 ? 60 : 15; }

/// Enough for a good clock reading, and at most two seconds of flight.
std::size_t framesFor(std::size_t count) {
    return std::min<std::size_t>(120, std::max<std::size_t>(2, 50000 / count));
}

/// Nanoseconds per body and step.
template <class Run>
double timeFrames(Run &run, std::size_t count) {
    const std::size_t frames = framesFor(count);
    run.rewind();
    run.frame();
    const double time = timeOf([&] {
        for (std::size_t n = 0; n < frames; ++n) run.frame();
    });
    return time / static_cast<double>(frames * count);
}

void measureScene(const Scene &scene, std::size_t count) {
    CycloneRun run(scene, count);
    ClassicRun classicRun(scene, count);
    Timings ours, theirs;
    for (std::size_t n = 0; n < runsFor(count); ++n) {
        ours.add(timeFrames(run, count));
        theirs.add(timeFrames(classicRun, count));
    }
    std::printf("%-24s %9zu %9.1f %9.1f %9.1f %9.1f %8.2f\n", scene.name, count, ours.least(), ours.median(),
                theirs.least(), theirs.median(), theirs.least() / ours.least());
    std::fflush(stdout);
}

}  // namespace

void measureFrames(const Counts &counts) {
    Scene inOrder, shuffled, owned, forceFree, halfAsleep, nonDiagonal;
    inOrder.name = "in order";
    shuffled.name = "shuffled", shuffled.shuffled = true;
    owned.name = "owned by the world", owned.owned = true;
    forceFree.name = "force-free", forceFree.forceFree = true;
    halfAsleep.name = "half asleep", halfAsleep.halfAsleep = true;
    nonDiagonal.name = "non-diagonal inertia", nonDiagonal.nonDiagonal = true;

    std::printf("A frame: ns per body. The classic step is of first order. A body takes %zu bytes.\n\n",
                sizeof(cyclone::RigidBody));
    std::printf("%-24s %9s %9s %9s %9s %9s %8s\n", "", "bodies", "least", "median", "classic", "median",
                "ratio");
    for (const Scene &scene : {inOrder, shuffled, owned, forceFree, halfAsleep, nonDiagonal})
        for (const std::size_t count : counts) measureScene(scene, count);
}

void measureThreads(const Counts &counts) {
    std::printf("\nThreads: ns per body and frame.\n\n%-24s %9s %9s %9s %8s\n", "", "bodies", "one", "two",
                "ratio");
    for (const std::size_t count : counts) {
        Scene scene;
        scene.owned = true;
        CycloneRun run(scene, count);
        Timings one, two;
        for (std::size_t n = 0; n < runsFor(count); ++n) {
            run.getWorld().setWorkers(1);
            one.add(timeFrames(run, count));
            run.getWorld().setWorkers(2);
            two.add(timeFrames(run, count));
        }
        std::printf("%-24s %9zu %9.1f %9.1f %8.2f\n", scene.name, count, one.least(), two.least(),
                    one.least() / two.least());
        std::fflush(stdout);
    }
}

}  // namespace benchmark
