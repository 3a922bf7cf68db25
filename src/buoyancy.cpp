#include <cyclone/buoyancy.h>

namespace cyclone {

namespace {

void requirePositive(real value, const char *function, const char *rule) {
    require(value > 0 && value <= REAL_MAX, function, rule, {value});
}

}  // namespace

Waves::Waves(real height, real g) : meanHeight(height), gravity(g) {
    require(real_isfinite(height), "Waves::Waves", "the mean height must be finite", {height});
    requirePositive(g, "Waves::Waves", "gravity must be positive and finite");
}

void Waves::addTrain(const Train &train) {
    require(train.amplitude >= 0 && train.amplitude <= REAL_MAX, "Waves::addTrain",
            "the amplitude must be finite and not negative", {train.amplitude});
    requirePositive(train.wavelength, "Waves::addTrain", "the wavelength must be positive and finite");
    require(real_isfinite(train.direction), "Waves::addTrain", "the direction must be finite",
            {train.direction});
    require(real_isfinite(train.phase), "Waves::addTrain", "the phase must be finite", {train.phase});
    const real k = 2 * REAL_PI / train.wavelength;
    motions.push_back({train.amplitude, k * real_cos(train.direction), k * real_sin(train.direction),
                       real_sqrt(gravity * k), train.phase, 0});
    setTime(time);
}

void Waves::setTime(real seconds) {
    require(real_isfinite(seconds), "Waves::setTime", "the time must be finite", {seconds});
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
    requireVector(centre.isFinite(), "Buoyancy::Buoyancy", "the centre of buoyancy must be finite", centre);
    requirePositive(depth, "Buoyancy::Buoyancy", "maxDepth must be positive and finite");
    requirePositive(v, "Buoyancy::Buoyancy", "the volume must be positive and finite");
    require(real_isfinite(height), "Buoyancy::Buoyancy", "the water's height must be finite", {height});
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
