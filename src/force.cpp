#include <cyclone/force.h>
#include <cyclone/wind.h>

#include <algorithm>

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

// ---- Springs

namespace {

void requireSpringConstant(real value, const char *function) {
    requireNotNegative(value, function, "the spring constant must be finite and not negative");
}

void requireRestLength(real value, const char *function) {
    requireNotNegative(value, function, "the rest length must be finite and not negative");
}

}  // namespace

ElasticForce::ElasticForce(const char *function, const Vector3 &point, real constant, real length)
    : PointForce(function, point), springConstant(constant), restLength(length) {
    requireSpringConstant(constant, function);
    requireRestLength(length, function);
}

void ElasticForce::setSpringConstant(real newtonsPerMetre) {
    requireSpringConstant(newtonsPerMetre, "ElasticForce::setSpringConstant");
    springConstant = newtonsPerMetre;
}

void ElasticForce::setRestLength(real metres) {
    requireRestLength(metres, "ElasticForce::setRestLength");
    restLength = metres;
}

void ElasticForce::setDamping(real newtonSecondsPerMetre) {
    requireNotNegative(newtonSecondsPerMetre, "ElasticForce::setDamping",
                       "the damping must be finite and not negative");
    damping = newtonSecondsPerMetre;
}

real ElasticForce::tensionOf(const Line &line) const {
    const real length = line.separation.magnitude();
    if (length == 0) return 0;
    return springConstant * (length - restLength) + damping * (line.separation * line.velocity / length);
}

Vector3 ElasticForce::getForce(const RigidBody &body) const {
    const Line line = getLine(body);
    const real length = line.separation.magnitude();
    if (length == 0) return Vector3();
    return line.separation * (-tensionOf(line) / length);
}

Spring::Spring(const char *function, const RigidBody *body, const Vector3 &point, const RigidBody *otherBody,
               const Vector3 &otherPoint, real constant, real length)
    : ElasticForce(function, point, constant, length),
      firstBody(body),
      other(requireNonNull(otherBody, function, "the other body must not be null")),
      otherConnectionPoint(otherPoint) {
    requireFinite(otherPoint, function, "the other end must be finite");
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

ElasticForce::Line Spring::getLine(const RigidBody &body) const {
    const RigidBody &far = *getOtherBody(&body);
    const Vector3 here = body.getPointInWorldSpace(getPointOn(body));
    const Vector3 there = far.getPointInWorldSpace(isOther(body) ? position : otherConnectionPoint);
    return {here - there, body.getVelocityAtPoint(here) - far.getVelocityAtPoint(there)};
}

real Bungee::tensionOf(const Line &line) const {
    if (line.separation.magnitude() <= getRestLength()) return 0;
    return std::max<real>(Spring::tensionOf(line), 0);
}

AnchoredSpring::AnchoredSpring(const Vector3 &point, const Vector3 &worldAnchor, real constant, real length)
    : ElasticForce("AnchoredSpring::AnchoredSpring", point, constant, length), anchor(worldAnchor) {
    requireFinite(anchor, "AnchoredSpring::AnchoredSpring", "the anchor must be finite");
}

void AnchoredSpring::setAnchor(const Vector3 &worldPoint) {
    requireFinite(worldPoint, "AnchoredSpring::setAnchor", "the anchor must be finite");
    anchor = worldPoint;
}

ElasticForce::Line AnchoredSpring::getLine(const RigidBody &body) const {
    const Vector3 here = body.getPointInWorldSpace(position);
    return {here - anchor, body.getVelocityAtPoint(here)};
}

}  // namespace cyclone
