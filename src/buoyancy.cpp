#include <cyclone/buoyancy.h>

#include "arguments.h"

namespace cyclone {

using namespace detail;

Buoyancy::Buoyancy(const Vector3 &centreOfBuoyancy, real depth, real v, real height, real density, real g)
    : PointForce("Buoyancy::Buoyancy", centreOfBuoyancy),
      maxDepth(depth),
      volume(v),
      waterHeight(height),
      liquidDensity(density),
      gravity(g) {
    requirePositive(depth, "Buoyancy::Buoyancy", "maxDepth must be positive and finite");
    requirePositive(v, "Buoyancy::Buoyancy", "the volume must be positive and finite");
    requireFinite(height, "Buoyancy::Buoyancy", "the water's height must be finite");
    requirePositive(density, "Buoyancy::Buoyancy", "the density must be positive and finite");
    requirePositive(g, "Buoyancy::Buoyancy", "gravity must be positive and finite");
}

real Buoyancy::submersionAt(real centreHeight, real surfaceHeight) const {
    return real_clamp((surfaceHeight + maxDepth - centreHeight) / (2 * maxDepth), 0, 1);
}

real Buoyancy::getSubmersion(const RigidBody &body) const {
    const Vector3 centre = body.getPointInWorldSpace(position);
    return submersionAt(centre.y, water != nullptr ? water->getHeight(centre) : waterHeight);
}

Vector3 Buoyancy::getForce(const RigidBody &body) const {
    const Vector3 centre = body.getPointInWorldSpace(position);
    Water::Motion motion;
    motion.height = waterHeight;
    if (water != nullptr) motion = water->getMotion(centre);
    const real displacedMass = liquidDensity * volume * submersionAt(centre.y, motion.height);
    return (Vector3::UP * gravity + motion.acceleration) * displacedMass;
}

}  // namespace cyclone
