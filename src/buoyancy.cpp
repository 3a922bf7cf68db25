#include <cyclone/buoyancy.h>

#include "arguments.h"

namespace cyclone {

using namespace detail;

Waves::Waves(real height, real g) : meanHeight(height), gravity(g) {
    requireFinite(height, "Waves::Waves", "the mean height must be finite");
    requirePositive(g, "Waves::Waves", "gravity must be positive and finite");
}

void Waves::addTrain(const Train &train) {
    requireNotNegative(train.amplitude, "Waves::addTrain", "the amplitude must be finite and not negative");
    requirePositive(train.wavelength, "Waves::addTrain", "the wavelength must be positive and finite");
    requireFinite(train.direction, "Waves::addTrain", "the direction must be finite");
    requireFinite(train.phase, "Waves::addTrain", "the phase must be finite");
    const real k = 2 * REAL_PI / train.wavelength;
    motions.push_back({train.amplitude, k * real_cos(train.direction), k * real_sin(train.direction),
                       real_sqrt(gravity * k), train.phase, 0});
    setTime(time);
}

void Waves::setTime(real seconds) {
    requireFinite(seconds, "Waves::setTime", "the time must be finite");
    time = seconds;
    for (Motion &motion : motions) motion.phaseNow = motion.frequency * time - motion.phase;
}

real Waves::getHeight(const Vector3 &worldPoint) const {
    real height = meanHeight;
    for (const Motion &motion : motions)
        height += motion.amplitude *
                  real_sin(motion.alongX * worldPoint.x + motion.alongZ * worldPoint.z - motion.phaseNow);
    return height;
}

Buoyancy::Buoyancy(const Vector3 &centre, real depth, real v, real height, real density, real g)
    : centreOfBuoyancy(centre),
      maxDepth(depth),
      volume(v),
      waterHeight(height),
      liquidDensity(density),
      gravity(g) {
    requireFinite(centre, "Buoyancy::Buoyancy", "the centre of buoyancy must be finite");
    requirePositive(depth, "Buoyancy::Buoyancy", "maxDepth must be positive and finite");
    requirePositive(v, "Buoyancy::Buoyancy", "the volume must be positive and finite");
    requireFinite(height, "Buoyancy::Buoyancy", "the water's height must be finite");
    requirePositive(density, "Buoyancy::Buoyancy", "the density must be positive and finite");
    requirePositive(g, "Buoyancy::Buoyancy", "gravity must be positive and finite");
}

real Buoyancy::getSubmersion(const RigidBody &body) const {
    const Vector3 centre = body.getPointInWorldSpace(centreOfBuoyancy);
    const real height = water != nullptr ? water->getHeight(centre) : waterHeight;
    return real_clamp((height + maxDepth - centre.y) / (2 * maxDepth), 0, 1);
}

Vector3 Buoyancy::getForce(const RigidBody &body) const {
    return Vector3(0, liquidDensity * volume * gravity * getSubmersion(body), 0);
}

void Buoyancy::updateForce(RigidBody *body, real) {
    body->addForceAtBodyPoint(getForce(*body), centreOfBuoyancy);
}

}  // namespace cyclone
