#include <cyclone/buoyancy.h>

#include <algorithm>

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

Vector3 HullDrag::flowInBodyAxes(const RigidBody &body) const {
    Vector3 flow = body.getVelocity() + body.getRotation() % body.getDirectionInWorldSpace(position);
    if (const Water *water = hull->getWater())
        flow -= water->getVelocity(body.getPointInWorldSpace(position));
    return body.getDirectionInLocalSpace(flow);
}

Vector3 HullDrag::getForceOf(const Vector3 &flow, real submersion, const RigidBody &body) const {
    const Vector3 size(real_abs(flow.x), real_abs(flow.y), real_abs(flow.z));
    const Vector3 drag = (linear + quadratic.componentProduct(size)).componentProduct(flow);
    return body.getDirectionInWorldSpace(drag) * -submersion;
}

Vector3 HullDrag::resistanceTo(const Vector3 &flow, real submersion) const {
    const Vector3 size(real_abs(flow.x), real_abs(flow.y), real_abs(flow.z));
    return (linear + quadratic.componentProduct(size) * 2) * submersion;
}

Vector3 HullDrag::getForce(const RigidBody &body) const {
    const real submersion = hull->getSubmersion(body);
    return submersion > 0 ? getForceOf(flowInBodyAxes(body), submersion, body) : Vector3();
}

void HullDrag::updateForce(RigidBody *body, real) {
    const real submersion = hull->getSubmersion(*body);
    if (submersion == 0) return;
    const Vector3 flow = flowInBodyAxes(*body), along = resistanceTo(flow, submersion);
    const real most = std::max({along.x, along.y, along.z});
    body->addForceAtBodyPoint(getForceOf(flow, submersion, *body), position);
    body->addResistance(most, most * position.squareMagnitude());
}

void HullDrag::addResistance(const RigidBody &body, Resistance &sum) const {
    const Vector3 along = resistanceTo(flowInBodyAxes(body), hull->getSubmersion(body));
    Matrix3 turn, tensor;
    turn.setOrientation(body.getOrientation());
    tensor.setDiagonal(-along.x, -along.y, -along.z);
    sum.add(turn * tensor * turn.transpose(), body.getDirectionInWorldSpace(position), true);
}

}  // namespace cyclone
