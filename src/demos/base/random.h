#pragma once

/// Random numbers and a wind that follows from them: the same on every machine, as the standard library's
/// distributions are not.
#include <cyclone/core.h>

#include <cstdint>

namespace demo {

using cyclone::real;
using cyclone::Vector3;

/// SplitMix64 (Steele, Lea and Flood 2014): every seed is good, and its whole state is one number.
class Random {
public:
    explicit Random(std::uint64_t seed = 0) : state(seed) {}

    std::uint64_t next() {
        std::uint64_t z = (state += 0x9E3779B97F4A7C15u);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }

    /// Evenly between low and high.
    real between(real low, real high) {
        return low + (high - low) * (static_cast<real>(next() >> 11) / 9007199254740992.0);
    }

private:
    std::uint64_t state;
};

/// A steady wind with gusts on top. A gust is a random vector, new at every step, in a recency-weighted
/// average: gust = k·gust + (1 − k)·random, with k the fraction that is left after one step. It forgets with
/// the time constant `memory` and stays smooth enough for the eye and for the integrator: two averages in a
/// row.
class Wind {
public:
    /// windspeed (m/s) points to where the wind comes from. Gusts have the given root mean square (m/s) along
    /// each horizontal axis and half of it along the vertical one. memory in s, positive; step in s.
    Wind(const Vector3 &mean, real gustiness, real memory, real step, std::uint64_t seed);
    Wind() : Wind(Vector3(), 0, 1, 1.0 / 120, 0) {}

    void advance();
    const Vector3 &getWindspeed() const { return windspeed; }
    /// What surfaces are given to read; it stays where it is.
    const Vector3 *getAddress() const { return &windspeed; }

private:
    Random random;
    Vector3 mean, windspeed, first, second;
    real kept, amplitude;
};

}  // namespace demo
