#pragma once

/// Frames of a world, for tests that watch motion.
#include <cyclone/world.h>

namespace cyclone_test {

constexpr cyclone::real STEP = 1.0 / 120;

inline void run(cyclone::World &world, int steps) {
    for (int n = 0; n < steps; ++n) {
        world.startFrame();
        world.runPhysics(STEP);
    }
}

}  // namespace cyclone_test
