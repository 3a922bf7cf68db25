#pragma once

/// The scene that is measured: bodies in free flight, each with gravity, damping and one Aero off its centre.
#include <cyclone/cyclone.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "classic.h"

namespace benchmark {

constexpr cyclone::real STEP = 1.0 / 60;

/// What varies between the populations that are measured.
struct Scene {
    const char *name = "";
    bool shuffled = false;   ///< bodies in random order of address
    bool owned = false;      ///< created by the world, rather than allocated one by one
    bool forceFree = false;  ///< no Aero, gravity or damping
    bool halfAsleep = false;
    bool nonDiagonal = false;  ///< an inertia tensor whose principal axes are not the body's
};

/// The same pseudo-random numbers on every machine (a linear congruential generator; Knuth, MMIX).
class Random {
public:
    cyclone::real between(cyclone::real low, cyclone::real high);
    std::size_t below(std::size_t end);
    cyclone::Vector3 vector(cyclone::real size);

private:
    std::uint64_t state = 1;
};

/// The scene in this library.
class CycloneRun {
public:
    CycloneRun(const Scene &scene, std::size_t count);

    cyclone::World &getWorld() { return world; }
    void frame() {
        world.startFrame();
        world.runPhysics(STEP);
    }
    /// Back to the beginning: left alone for long, the bodies would spin ever faster.
    void rewind() { world.restoreState(beginning); }

private:
    cyclone::World world;
    std::vector<cyclone::RigidBody> storage;
    std::deque<cyclone::Aero> surfaces;
    cyclone::Snapshot beginning;
};

/// The scene in the classic engine.
class ClassicRun {
public:
    ClassicRun(const Scene &scene, std::size_t count);

    void frame() {
        world.startFrame();
        world.runPhysics(STEP);
    }
    void rewind() { storage = beginning; }

private:
    classic::World world;
    std::vector<classic::Body> storage, beginning;
    std::deque<classic::Aero> surfaces;
};

}  // namespace benchmark
