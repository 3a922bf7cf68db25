#include <cyclone/force.h>
#include <cyclone/wind.h>

#include "arguments.h"

namespace cyclone {

using namespace detail;

PointForce::PointForce(const char *function, const Vector3 &p) : position(p) {
    requireFinite(p, function, "the position must be finite");
}

PointForce::PointForce(const Vector3 &p) : PointForce("PointForce::PointForce", p) {}

void PointForce::updateForce(RigidBody *body, real) {
    body->addForceAtBodyPoint(getForce(*body), getPointOn(*body));
}

Gravity::Gravity(const Vector3 &a) : acceleration(a) {
    requireFinite(a, "Gravity::Gravity", "the acceleration must be finite");
}

Vector3 Gravity::getForce(const RigidBody &body) const {
    return body.hasFiniteMass() ? acceleration * body.getMass() : Vector3();
}

Drag::Drag(real linear, real quadratic) : k1(linear), k2(quadratic) {
    requireNotNegative(k1, "Drag::Drag", "k1 must be finite and not negative");
    requireNotNegative(k2, "Drag::Drag", "k2 must be finite and not negative");
}

void Drag::updateForce(RigidBody *body, real) {
    body->addForce(getForce(*body));
    body->addResistance(k1 + 2 * k2 * getFlow(*body).magnitude(), 0);
}

Vector3 Drag::getForce(const RigidBody &body) const {
    const Vector3 flow = getFlow(body);
    return flow * -(k1 + k2 * flow.magnitude());
}

Vector3 Drag::getFlow(const RigidBody &body) const {
    const Vector3 velocity = body.getVelocity();
    return windField != nullptr ? velocity - windField->getVelocity(body.getPosition()) : velocity;
}

/// −(k1 + k2·|v|)·1 − k2·v·vᵀ/|v|
void Drag::addResistance(const RigidBody &body, Resistance &sum) const {
    const Vector3 flow = getFlow(body), direction = flow.unit();
    const real across = k1 + k2 * flow.magnitude();
    Matrix3 tensor(flow * (-k2 * direction.x), flow * (-k2 * direction.y), flow * (-k2 * direction.z));
    for (int n = 0; n < 9; n += 4) tensor.data[n] -= across;
    sum.add(tensor, Vector3(), false);
}

namespace {

void requireSpring(const Vector3 &otherEnd, real springConstant, real restLength, const char *function) {
    requireFinite(otherEnd, function, "the other end must be finite");
    requireNotNegative(springConstant, function, "the spring constant must be finite and not negative");
    requireNotNegative(restLength, function, "the rest length must be finite and not negative");
}

/// The force at one end of a spring: −k(|d| − L)·d/|d|, with d from the other end to this one.
Vector3 springForce(const Vector3 &d, real springConstant, real restLength) {
    const real length = d.magnitude();
    if (length == 0) return Vector3();
    return d * (-springConstant * (length - restLength) / length);
}

}  // namespace

Spring::Spring(const char *function, const RigidBody *body, const Vector3 &point, const RigidBody *otherBody,
               const Vector3 &otherPoint, real constant, real length)
    : PointForce(function, point),
      firstBody(body),
      other(requireNonNull(otherBody, function, "the other body must not be null")),
      otherConnectionPoint(otherPoint),
      springConstant(constant),
      restLength(length) {
    requireSpring(otherPoint, constant, length, function);
    require(body != otherBody, function, "the two bodies must be different");
}

Spring::Spring(const Vector3 &point, const RigidBody *otherBody, const Vector3 &otherPoint, real constant,
               real length)
    : Spring("Spring::Spring", nullptr, point, otherBody, otherPoint, constant, length) {}

Spring::Spring(const RigidBody *body, const Vector3 &point, const RigidBody *otherBody,
               const Vector3 &otherPoint, real constant, real length)
    : Spring("Spring::Spring", requireNonNull(body, "Spring::Spring", "the body must not be null"), point,
             otherBody, otherPoint, constant, length) {}

Bungee::Bungee(const Vector3 &point, const RigidBody *otherBody, const Vector3 &otherPoint, real constant,
               real length)
    : Spring("Bungee::Bungee", nullptr, point, otherBody, otherPoint, constant, length) {}

Bungee::Bungee(const RigidBody *body, const Vector3 &point, const RigidBody *otherBody,
               const Vector3 &otherPoint, real constant, real length)
    : Spring("Bungee::Bungee", requireNonNull(body, "Bungee::Bungee", "the body must not be null"), point,
             otherBody, otherPoint, constant, length) {}

const RigidBody *Spring::getOtherBody(const RigidBody *body) const {
    return isOther(*body) ? firstBody : other;
}

Vector3 Spring::getPointOn(const RigidBody &body) const {
    return isOther(body) ? otherConnectionPoint : position;
}

Vector3 Spring::getSeparation(const RigidBody &body) const {
    const RigidBody &far = *getOtherBody(&body);
    const Vector3 &farPoint = isOther(body) ? position : otherConnectionPoint;
    return body.getPointInWorldSpace(getPointOn(body)) - far.getPointInWorldSpace(farPoint);
}

Vector3 Spring::getForce(const RigidBody &body) const {
    return springForce(getSeparation(body), springConstant, restLength);
}

Vector3 Bungee::getForce(const RigidBody &body) const {
    return getSeparation(body).magnitude() > restLength ? Spring::getForce(body) : Vector3();
}

AnchoredSpring::AnchoredSpring(const Vector3 &point, const Vector3 &worldAnchor, real constant, real length)
    : PointForce("AnchoredSpring::AnchoredSpring", point),
      anchor(worldAnchor),
      springConstant(constant),
      restLength(length) {
    requireSpring(worldAnchor, constant, length, "AnchoredSpring::AnchoredSpring");
}

void AnchoredSpring::setAnchor(const Vector3 &worldPoint) {
    requireFinite(worldPoint, "AnchoredSpring::setAnchor", "the anchor must be finite");
    anchor = worldPoint;
}

Vector3 AnchoredSpring::getForce(const RigidBody &body) const {
    return springForce(body.getPointInWorldSpace(position) - anchor, springConstant, restLength);
}

}  // namespace cyclone
