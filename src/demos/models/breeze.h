#pragma once

/// The air above open country.
#include <cyclone/wind.h>

namespace demo {

using cyclone::real;
using cyclone::Vector3;

/// Wind that grows with height, and gusts that an aircraft flies through.
class Breeze : public cyclone::WindField {
public:
    /// windFrom: towards where the wind at 10 m comes from, m/s. gusts: the root mean square of the vertical
    /// ones, m/s.
    Breeze(const Vector3 &windFrom, real gusts, std::uint64_t seed);
    Breeze() : Breeze(Vector3(), 0, 0) {}

    /// Blows the gusts past an aircraft.
    void advance(const Vector3 &velocityThroughAir, real height, real duration) {
        turbulence.advance(velocityThroughAir, height, duration);
    }

    Vector3 getVelocity(const Vector3 &worldPoint) const override {
        return gradient.getVelocity(worldPoint) + turbulence.getVelocity(worldPoint);
    }

private:
    cyclone::WindGradient gradient;
    cyclone::Turbulence turbulence;
};

}  // namespace demo
