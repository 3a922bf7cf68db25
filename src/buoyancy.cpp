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

HullDrag::HullDrag(const Buoyancy *buoyancy, const Vector3 &centre, const Vector3 &k1, const Vector3 &k2)
    : PointForce("HullDrag::HullDrag", centre),
      hull(requireNonNull(buoyancy, "HullDrag::HullDrag", "the hull must not be null")),
      linear(k1),
      quadratic(k2) {
    for (const real k : {k1.x, k1.y, k1.z})
        requireNotNegative(k, "HullDrag::HullDrag", "linear must be finite and not negative");
    for (const real k : {k2.x, k2.y, k2.z})
        requireNotNegative(k, "HullDrag::HullDrag", "quadratic must be finite and not negative");
}

namespace {

real resistance(real u, real linear, real quadratic) { return -(linear + quadratic * real_abs(u)) * u; }

}  // namespace

Vector3 HullDrag::getForce(const RigidBody &body) const {
    const real submersion = hull->getSubmersion(body);
    if (submersion == 0) return Vector3();
    Vector3 flow = body.getVelocity() + body.getRotation() % body.getDirectionInWorldSpace(position);
    if (const Water *water = hull->getWater())
        flow -= water->getVelocity(body.getPointInWorldSpace(position));
    const Vector3 u = body.getDirectionInLocalSpace(flow);
    const Vector3 force(resistance(u.x, linear.x, quadratic.x), resistance(u.y, linear.y, quadratic.y),
                        resistance(u.z, linear.z, quadratic.z));
    return body.getDirectionInWorldSpace(force) * submersion;
}

}  // namespace cyclone
