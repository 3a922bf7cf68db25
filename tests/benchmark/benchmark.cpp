/// How long a frame takes: startFrame and runPhysics of many bodies, each with gravity, damping and one Aero
/// off its centre, beside a plain first-order engine that runs the same scene in turn with it.
///
///     cyclone_benchmark [bodies …]        (without numbers: 1000 10000 100000 1000000)
#include <cyclone/cyclone.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "classic.h"
#include "snapshots.h"

namespace {

using cyclone::Matrix3;
using cyclone::real;
using cyclone::Vector3;

constexpr real STEP = 1.0 / 60;
const Vector3 WIND(-3, 0, 1);
const Matrix3 TENSOR(-0.1, 0, 0, 0.3, -0.5, 0, 0, 0, -0.1);
const Vector3 OFF_CENTRE(-0.2, 0.05, 0.1);

/// The same pseudo-random numbers on every machine (a linear congruential generator; Knuth, MMIX).
class Random {
public:
    real between(real low, real high) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return low + (high - low) * static_cast<real>(state >> 11) * 0x1p-53;
    }
    std::size_t below(std::size_t end) {
        return static_cast<std::size_t>(between(0, static_cast<real>(end)));
    }

private:
    std::uint64_t state = 1;
};

template <class T>
void shuffle(std::vector<T> &items, Random &random) {
    for (std::size_t n = items.size(); n > 1; --n) std::swap(items[n - 1], items[random.below(n)]);
}

/// What varies between the populations that are measured.
struct Scene {
    const char *name;
    bool shuffled = false;   ///< bodies in random order of address
    bool owned = false;      ///< created by the world, rather than allocated one by one
    bool forceFree = false;  ///< no Aero, gravity or damping
    bool halfAsleep = false;
    bool nonDiagonal = false;  ///< an inertia tensor whose principal axes are not the body's
    std::size_t threads = 1;
};

class CycloneRun {
public:
    CycloneRun(const Scene &scene, std::size_t count) {
        Random random;
        std::vector<cyclone::RigidBody *> bodies;
        for (std::size_t n = 0; n < count; ++n) bodies.push_back(makeBody(scene));
        if (scene.shuffled) shuffle(bodies, random);
        for (std::size_t n = 0; n < count; ++n) {
            setUp(*bodies[n], scene, random);
            if (!scene.owned) world.addBody(bodies[n]);
            if (scene.forceFree) continue;
            surfaces.emplace_back(TENSOR, OFF_CENTRE, &WIND);
            if (!scene.halfAsleep || n % 2 == 0) world.getForceRegistry().add(bodies[n], &surfaces.back());
        }
        for (std::size_t n = 0; n < count; ++n)
            if (scene.halfAsleep && n % 2 == 1) bodies[n]->setAwake(false);
        world.setWorkers(scene.threads);
    }

    void frame() {
        world.startFrame();
        world.runPhysics(STEP);
    }

private:
    cyclone::RigidBody *makeBody(const Scene &scene) {
        if (scene.owned) return world.createBody();
        storage.emplace_back();
        return &storage.back();
    }

    void setUp(cyclone::RigidBody &body, const Scene &scene, Random &random) const {
        body.setMass(2.5);
        body.setInertiaTensor(scene.nonDiagonal ? Matrix3(0.2, 0.02, 0.01, 0.02, 0.5, 0.03, 0.01, 0.03, 0.4)
                                                : Matrix3(0.2, 0, 0, 0, 0.5, 0, 0, 0, 0.4));
        if (!scene.forceFree) {
            body.setDamping(0.95, 0.8);
            body.setAcceleration(Vector3::GRAVITY);
        }
        body.setPosition(random.between(-100, 100), random.between(0, 100), random.between(-100, 100));
        body.setVelocity(random.between(-10, 10), random.between(-10, 10), random.between(-10, 10));
        body.setRotation(random.between(-2, 2), random.between(-2, 2), random.between(-2, 2));
    }

    cyclone::World world;
    std::deque<cyclone::RigidBody> storage;
    std::deque<cyclone::Aero> surfaces;
};

class ClassicRun {
public:
    ClassicRun(const Scene &scene, std::size_t count) : storage(count) {
        Random random;
        std::vector<classic::Body *> bodies;
        for (classic::Body &body : storage) bodies.push_back(&body);
        if (scene.shuffled) shuffle(bodies, random);
        for (classic::Body *body : bodies) {
            body->inverseMass = 1 / 2.5;
            body->inverseInertiaTensor.setDiagonal(1 / 0.2, 1 / 0.5, 1 / 0.4);
            if (!scene.forceFree) {
                body->linearDamping = 0.95;
                body->angularDamping = 0.8;
                body->acceleration = Vector3::GRAVITY;
            }
            body->velocity =
                Vector3(random.between(-10, 10), random.between(-10, 10), random.between(-10, 10));
            body->rotation = Vector3(random.between(-2, 2), random.between(-2, 2), random.between(-2, 2));
            body->calculateDerivedData();
            world.bodies.push_back(body);
            if (scene.forceFree) continue;
            surfaces.emplace_back(TENSOR, OFF_CENTRE, &WIND);
            world.registrations.push_back({body, &surfaces.back()});
        }
    }

    void frame() {
        world.startFrame();
        world.runPhysics(STEP);
    }

private:
    classic::World world;
    std::deque<classic::Body> storage;
    std::deque<classic::Aero> surfaces;
};

/// Nanoseconds per body and step, of some runs.
class Timings {
public:
    template <class Run>
    void time(Run &run, std::size_t frames, std::size_t count) {
        const auto begin = std::chrono::steady_clock::now();
        for (std::size_t n = 0; n < frames; ++n) run.frame();
        const std::chrono::duration<double, std::nano> passed = std::chrono::steady_clock::now() - begin;
        results.push_back(passed.count() / static_cast<double>(frames * count));
    }
    double least() const { return *std::min_element(results.begin(), results.end()); }
    double median() const {
        std::vector<double> sorted = results;
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
    }

private:
    std::vector<double> results;
};

void measure(const Scene &scene, std::size_t count) {
    constexpr std::size_t RUNS = 9, BODY_STEPS = 2000000;
    const std::size_t frames = std::max<std::size_t>(2, BODY_STEPS / count);
    Timings ours, theirs;
    {
        CycloneRun run(scene, count);
        ClassicRun classicRun(scene, count);
        run.frame();
        classicRun.frame();
        for (std::size_t n = 0; n < RUNS; ++n) {
            ours.time(run, frames, count);
            theirs.time(classicRun, frames, count);
        }
    }
    std::printf("%-28s %9zu %9.1f %9.1f %9.1f %9.1f %8.2f\n", scene.name, count, ours.least(), ours.median(),
                theirs.least(), theirs.median(), theirs.least() / ours.least());
    std::fflush(stdout);
}

Scene scene(
    const char *name, const std::function<void(Scene &)> &change = [](Scene &) {}) {
    Scene result;
    result.name = name;
    change(result);
    return result;
}

}  // namespace

int main(int argc, char **argv) {
    std::vector<std::size_t> counts;
    for (int n = 1; n < argc; ++n) {
        const long count = std::strtol(argv[n], nullptr, 10);
        if (count < 1) {
            std::fprintf(stderr, "cyclone_benchmark: '%s' is not a number of bodies\n", argv[n]);
            return 2;
        }
        counts.push_back(static_cast<std::size_t>(count));
    }
    if (counts.empty()) counts = {1000, 10000, 100000, 1000000};

    const Scene scenes[] = {
        scene("in order"),
        scene("shuffled", [](Scene &s) { s.shuffled = true; }),
        scene("owned by the world", [](Scene &s) { s.owned = true; }),
        scene("force-free", [](Scene &s) { s.forceFree = true; }),
        scene("half asleep", [](Scene &s) { s.halfAsleep = true; }),
        scene("non-diagonal inertia", [](Scene &s) { s.nonDiagonal = true; }),
        scene("in order, 2 threads", [](Scene &s) { s.threads = 2; }),
    };
    std::printf("ns per body and step; the classic's is first order. A body takes %zu bytes.\n\n",
                sizeof(cyclone::RigidBody));
    std::printf("%-28s %9s %9s %9s %9s %9s %8s\n", "", "bodies", "least", "median", "classic", "median",
                "ratio");
    for (const Scene &s : scenes)
        for (std::size_t count : counts) measure(s, count);
    measureSnapshots();
    return 0;
}
