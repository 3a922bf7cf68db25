#pragma once

/// Angles that go round, and lengths over the ground.
#include <cyclone/core.h>

#include <cmath>

namespace demo {

using cyclone::real;

/// The angle in [−π, π) that differs from this one by whole turns.
inline real wrapAngle(real angle) {
    const real turns = std::floor(angle / (2 * cyclone::REAL_PI) + 0.5);
    return angle - turns * 2 * cyclone::REAL_PI;
}

/// The compass direction of a vector in the world: 0 is north, which is +X, and π/2 east, +Z.
inline real bearing(const cyclone::Vector3 &worldDirection) {
    return cyclone::real_atan2(worldDirection.z, worldDirection.x);
}

/// The unit vector that way.
inline cyclone::Vector3 towardsBearing(real bearing) {
    return cyclone::Vector3(cyclone::real_cos(bearing), 0, cyclone::real_sin(bearing));
}

/// The length of a vector's part along the ground, as of a speed over it.
inline real horizontalLength(const cyclone::Vector3 &v) { return cyclone::real_sqrt(v.x * v.x + v.z * v.z); }

}  // namespace demo
