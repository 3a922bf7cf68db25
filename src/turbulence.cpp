#include <cyclone/wind.h>

#include "arguments.h"

namespace cyclone {

using namespace detail;

namespace {

constexpr real METRES_PER_FOOT = 0.3048;
constexpr real ROOT_OF_3 = 1.7320508075688772;
constexpr real FORGOTTEN = 100;  // lengths, after which e^−100 of a gust is left

/// Lengths in m, standard deviations in m/s.
struct Dryden {
    real lengthAlong, lengthUp, deviationAlong, deviationUp;
};

/// MIL-F-8785C, section 3.7.3.4, low altitude.
Dryden atLowAltitude(real windAt6Metres, real height) {
    const real feet = real_clamp(height / METRES_PER_FOOT, 10, 1000);
    const real base = 0.177 + 0.000823 * feet;
    const real deviationUp = 0.1 * windAt6Metres;
    return {feet / real_pow(base, 1.2) * METRES_PER_FOOT, feet * METRES_PER_FOOT,
            deviationUp / real_pow(base, 0.4), deviationUp};
}

/// For variances that come out of a subtraction.
real rootOrZero(real x) { return x > 0 ? real_sqrt(x) : 0; }

}  // namespace

Turbulence::Turbulence(real wind, std::uint64_t seed) : windAt6Metres(wind), bits(seed) {
    requireNotNegative(wind, "Turbulence::Turbulence", "the wind must be finite and not negative");
    real normal[2];
    drawNormals(normal);
    along = normal[0];
    drawNormals(normal);
    across.start(normal);
    drawNormals(normal);
    up.start(normal);
}

void Turbulence::setWindAt6Metres(real speed) {
    requireNotNegative(speed, "Turbulence::setWindAt6Metres", "the wind must be finite and not negative");
    windAt6Metres = speed;
}

void Turbulence::advance(const Vector3 &velocityThroughAir, real height, real duration) {
    requireFinite(velocityThroughAir, "Turbulence::advance", "the velocity must be finite");
    requireFinite(height, "Turbulence::advance", "the height must be finite");
    requireDuration(duration, "Turbulence::advance");

    const Dryden dryden = atLowAltitude(windAt6Metres, height);
    const real way = velocityThroughAir.magnitude() * duration;
    const real lengths = real_clamp(way / dryden.lengthAlong, 0, FORGOTTEN);
    real normal[2];
    drawNormals(normal);
    const real kept = real_exp(-lengths);
    along = along * kept + rootOrZero(1 - kept * kept) * normal[0];
    drawNormals(normal);
    across.advance(lengths, normal);
    drawNormals(normal);
    up.advance(real_clamp(way / dryden.lengthUp, 0, FORGOTTEN), normal);

    const Vector3 horizontal(velocityThroughAir.x, 0, velocityThroughAir.z);
    if (horizontal != Vector3()) forward = horizontal.unit();
    gust = (forward * along + forward % Vector3::UP * across.getGust()) * dryden.deviationAlong +
           Vector3::UP * (up.getGust() * dryden.deviationUp);
}

// With p the derivative over the way in lengths, the spectrum across the flight is that of white noise n of
// intensity 1 through (1 + √3·p)/(1 + p)². With once = n/(1 + p) and twice = once/(1 + p) the gust is
// twice + √3·(once − twice). In the long run the variance of `once` is a half, that of `twice` a quarter, and
// so is their covariance; the variance of the gust is then 1.

void Turbulence::Transverse::start(const real (&normal)[2]) {
    once = real_sqrt(0.5) * normal[0];
    twice = 0.5 * once + real_sqrt(0.125) * normal[1];
}

// Over the way s the noise has added ∫ e^(−2t)·(1 t; t t²) dt, from 0 to s, to the covariance.
void Turbulence::Transverse::advance(real way, const real (&normal)[2]) {
    const real kept = real_exp(-way), square = kept * kept;
    const real onceOnce = 0.5 * (1 - square);
    const real onceTwice = 0.25 * (1 - square * (1 + 2 * way));
    const real twiceTwice = 0.25 * (1 - square * (1 + 2 * way * (1 + way)));

    const real first = rootOrZero(onceOnce);
    const real shared = first > 0 ? onceTwice / first : 0;
    const real second = rootOrZero(twiceTwice - shared * shared);
    twice = kept * (twice + way * once) + shared * normal[0] + second * normal[1];
    once = kept * once + first * normal[0];
}

real Turbulence::Transverse::getGust() const { return twice + ROOT_OF_3 * (once - twice); }

/// SplitMix64 (Steele, Lea and Flood 2014).
std::uint64_t Turbulence::nextBits() {
    std::uint64_t z = (bits += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/// Box and Muller (1958).
void Turbulence::drawNormals(real (&normal)[2]) {
    const real above0 = (static_cast<real>(nextBits() >> 11) + 1) * 0x1p-53;  // to 1
    const real radius = real_sqrt(-2 * real_log(above0));
    const real angle = 2 * REAL_PI * (static_cast<real>(nextBits() >> 11) * 0x1p-53);
    normal[0] = radius * real_cos(angle);
    normal[1] = radius * real_sin(angle);
}

}  // namespace cyclone
