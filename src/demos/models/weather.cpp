#include "models/weather.h"

#include "base/angle.h"
#include "base/random.h"

namespace demo {

namespace {

constexpr int THERMALS = 6;
constexpr real CLOUD_BASE = 1300, CLOUD_DRIFT = 80;  // m
constexpr real GUSTS_OF_WIND =
    0.1;  // MIL-F-8785C: the vertical gusts' root mean square over the wind at 20 feet

}  // namespace

Weather::Weather(std::uint64_t seed, const Vector3 &windFrom, real gusts, real lift)
    : gradient(-windFrom, 10), turbulence(gusts / GUSTS_OF_WIND, seed) {
    if (lift == 0) return;
    Random random(seed);
    for (int n = 0; n < THERMALS; ++n) {
        const real angle = 2 * cyclone::REAL_PI * (n + random.between(0, 0.7)) / THERMALS;
        const real distance = random.between(700, 2000);
        const Vector3 foot = towardsBearing(angle) * distance;
        thermals.emplace_back(foot, lift * random.between(0.8, 1.2), random.between(170, 240), CLOUD_BASE);
        const real drift = random.between(0, CLOUD_DRIFT), towards = random.between(0, 2 * cyclone::REAL_PI);
        clouds.push_back(foot + Vector3::UP * CLOUD_BASE + towardsBearing(towards) * drift);
    }
}

void Weather::advance(const Vector3 &velocityThroughAir, real height, real duration) {
    turbulence.advance(velocityThroughAir, height, duration);
}

Vector3 Weather::getVelocity(const Vector3 &worldPoint) const {
    Vector3 velocity = gradient.getVelocity(worldPoint) + turbulence.getVelocity(worldPoint);
    for (const cyclone::Thermal &thermal : thermals) velocity += thermal.getVelocity(worldPoint);
    return velocity;
}

}  // namespace demo
