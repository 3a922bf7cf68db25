#pragma once

/// Angles that go round.
#include <cyclone/core.h>

#include <cmath>

namespace demo {

using cyclone::real;

/// The angle in [−π, π) that differs from this one by whole turns.
inline real wrapAngle(real angle) {
    const real turns = std::floor(angle / (2 * cyclone::REAL_PI) + 0.5);
    return angle - turns * 2 * cyclone::REAL_PI;
}

}  // namespace demo
