#include <cstdio>
#include <memory>

#include "benchmark.h"
#include "scene.h"
#include "timing.h"

namespace benchmark {

namespace {

constexpr std::size_t RUNS = 100, CHANGES = 100;

using cyclone::Aero;
using cyclone::Matrix3;
using cyclone::RigidBody;
using cyclone::Vector3;
using cyclone::World;

/// Nanoseconds of ending a body in the midst of the world, and of creating and registering another one.
void measureChurnOf(std::size_t count) {
    World world;
    Aero surface(Matrix3(-1, 0, 0, 0, -1, 0, 0, 0, -1), Vector3(), nullptr);
    const auto createRegistered = [&] { world.getForceRegistry().add(world.createBody(), &surface); };
    for (std::size_t n = 0; n < count; ++n) createRegistered();
    std::vector<std::unique_ptr<RigidBody>> allocated(CHANGES);
    for (std::unique_ptr<RigidBody> &body : allocated) body = std::make_unique<RigidBody>();

    Random random;
    Timings churn, allocation;
    for (std::size_t n = 0; n < RUNS; ++n) {
        std::vector<RigidBody *> ending;
        for (std::size_t k = 0; k < CHANGES; ++k)
            ending.push_back(world.getBodies()[(count / CHANGES) * k + random.below(count / CHANGES)]);
        churn.add(timeOf([&] {
            for (RigidBody *body : ending) {
                world.destroyBody(body);
                createRegistered();
            }
        }));
        world.startFrame();
        world.runPhysics(STEP);
        allocation.add(timeOf([&] {
            for (std::unique_ptr<RigidBody> &body : allocated) {
                body.reset();
                body = std::make_unique<RigidBody>();
            }
        }));
    }
    const double perChange = churn.least() / CHANGES, perAllocation = allocation.least() / CHANGES;
    std::printf("%-24s %9zu %9.1f %9.1f %8.2f\n", "", count, perChange, perAllocation,
                perChange / perAllocation);
}

}  // namespace

void measureChurn() {
    std::printf("\nA body destroyed, another one created and registered: ns.\n\n%-24s %9s %9s %9s %8s\n", "",
                "bodies", "churn", "new", "ratio");
    for (const std::size_t count : {1000u, 10000u, 100000u}) measureChurnOf(count);
}

}  // namespace benchmark
