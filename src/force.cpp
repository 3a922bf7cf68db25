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

namespace {

/// How much the velocity of a point of the body, along a unit vector, answers to an impulse along it, 1/kg.
real inverseMassAt(const RigidBody &body, const Vector3 &worldPoint, const Vector3 &direction) {
    if (!body.hasFiniteMass()) return 0;
    const Vector3 turning = (worldPoint - body.getPosition()) % direction;
    return body.getInverseMass() + turning * (body.getInverseInertiaTensorWorld() * turning);
}

}  // namespace

/// What resists the body's own motion as much as c does that of both ends, of which it makes only a part:
/// c·(w + w_far)/w, with w their inverse masses along the line.
real ElasticForce::getPairDamping(const RigidBody &body, const Vector3 &direction) const {
    const real near = inverseMassAt(body, body.getPointInWorldSpace(getPointOn(body)), direction);
    return near > 0 ? damping * (1 + getFarInverseMass(body, direction) / near) : 0;
}

void ElasticForce::updateForce(RigidBody *body, real duration) {
    PointForce::updateForce(body, duration);
    if (damping == 0) return;
    const real most = getPairDamping(*body, getLine(*body).separation.unit());
    body->addResistance(most, most * getPointOn(*body).squareMagnitude());
}

void ElasticForce::addResistance(const RigidBody &body, Resistance &sum) const {
    const Vector3 n = getLine(body).separation.unit();
    const Vector3 column = n * -getPairDamping(body, n);
    sum.add(Matrix3(column * n.x, column * n.y, column * n.z),
            body.getDirectionInWorldSpace(getPointOn(body)), true);
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

Vector3 Spring::getFarPoint(const RigidBody &body) const {
    return getOtherBody(&body)->getPointInWorldSpace(isOther(body) ? position : otherConnectionPoint);
}

ElasticForce::Line Spring::getLine(const RigidBody &body) const {
    const Vector3 here = body.getPointInWorldSpace(getPointOn(body)), there = getFarPoint(body);
    return {here - there, body.getVelocityAtPoint(here) - getOtherBody(&body)->getVelocityAtPoint(there)};
}

real Spring::getFarInverseMass(const RigidBody &body, const Vector3 &direction) const {
    return inverseMassAt(*getOtherBody(&body), getFarPoint(body), direction);
}

/// Slack, it resists nothing.
void Bungee::addResistance(const RigidBody &body, Resistance &sum) const {
    if (getTension(body) > 0) Spring::addResistance(body, sum);
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
