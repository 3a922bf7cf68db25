#include "flightsim/weather.h"

#include "base/random.h"

namespace flightsim {

namespace {

constexpr int THERMALS = 6;
constexpr real CLOUD_BASE = 1300, CLOUD_DRIFT = 80;  // m

}  // namespace

Weather::Weather(std::uint64_t seed, const Vector3 &windFrom, real gusts, real lift)
    : breeze(windFrom, gusts, seed) {
    if (lift == 0) return;
    demo::Random random(seed);
    for (int n = 0; n < THERMALS; ++n) {
        const real angle = 2 * cyclone::REAL_PI * (n + random.between(0, 0.7)) / THERMALS;
        const real distance = random.between(700, 2000);
        const Vector3 foot(distance * cyclone::real_cos(angle), 0, distance * cyclone::real_sin(angle));
        thermals.emplace_back(foot, lift * random.between(0.8, 1.2), random.between(170, 240), CLOUD_BASE);
        const real drift = random.between(0, CLOUD_DRIFT), towards = random.between(0, 2 * cyclone::REAL_PI);
        clouds.push_back(foot + Vector3(drift * cyclone::real_cos(towards), CLOUD_BASE,
                                        drift * cyclone::real_sin(towards)));
    }
}

void Weather::advance(const Vector3 &velocityThroughAir, real height, real duration) {
    breeze.advance(velocityThroughAir, height, duration);
}

Vector3 Weather::getVelocity(const Vector3 &worldPoint) const {
    Vector3 velocity = breeze.getVelocity(worldPoint);
    for (const cyclone::Thermal &thermal : thermals) velocity += thermal.getVelocity(worldPoint);
    return velocity;
}

}  // namespace flightsim
