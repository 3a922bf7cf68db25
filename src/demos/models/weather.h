#pragma once

/// The air over an airfield.
#include <cyclone/wind.h>

#include <vector>

namespace demo {

using cyclone::real;
using cyclone::Vector3;

/// Wind that grows with height, gusts that the aircraft flies through, and thermals around the airfield.
/// Where the air rises is chosen from the seed: six thermals between 700 and 2000 m away.
class Weather : public cyclone::WindField {
public:
    Weather() : Weather(0, Vector3(), 0) {}
    /// windFrom: towards where the wind at 10 m comes from, m/s. gusts: the root mean square of the vertical
    /// ones, m/s. lift: how fast a usual thermal rises at most, m/s; with 0 there are none.
    Weather(std::uint64_t seed, const Vector3 &windFrom, real gusts, real lift = 0);

    /// Blows the gusts past an aircraft.
    void advance(const Vector3 &velocityThroughAir, real height, real duration);

    Vector3 getVelocity(const Vector3 &worldPoint) const override;
    const std::vector<cyclone::Thermal> &getThermals() const { return thermals; }
    /// Where the thermals end: the middle of each cloud's base, which has drifted up to 80 m off the
    /// thermal's axis.
    const std::vector<Vector3> &getClouds() const { return clouds; }

private:
    cyclone::WindGradient gradient;
    cyclone::Turbulence turbulence;
    std::vector<cyclone::Thermal> thermals;
    std::vector<Vector3> clouds;
};

}  // namespace demo
