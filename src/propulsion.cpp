#include <cyclone/propulsion.h>

#include "arguments.h"

namespace cyclone {

using namespace detail;

Thruster::Thruster(const char *function, const Vector3 &push, const Vector3 &p, real force)
    : PointForce(function, p), direction(push.unit()), maxForce(force) {
    requireDirection(push, function, "the direction must be finite and not zero");
    requireNotNegative(force, function, "the greatest force must be finite and not negative");
}

Thruster::Thruster(const Vector3 &push, const Vector3 &p, real force)
    : Thruster("Thruster::Thruster", push, p, force) {}

void Thruster::setThrottle(real value) {
    requireFinite(value, "Thruster::setThrottle", "the throttle must be finite");
    throttle = real_clamp(value, 0, 1);
}

void Thruster::setDirection(const Vector3 &bodyDirection) {
    requireDirection(bodyDirection, "Thruster::setDirection", "the direction must be finite and not zero");
    direction = bodyDirection.unit();
}

void Thruster::setWater(const Water *sea, real r) {
    requirePositive(r, "Thruster::setWater", "the radius must be positive and finite");
    water = sea;
    radius = r;
}

real Thruster::getPush(const RigidBody &body) const {
    const real push = throttle * maxForce;
    if (water == nullptr) return push;
    const Vector3 point = body.getPointInWorldSpace(position);
    return push * real_clamp((water->getHeight(point) + radius - point.y) / (2 * radius), 0, 1);
}

Vector3 Thruster::getForce(const RigidBody &body) const {
    return body.getDirectionInWorldSpace(direction) * getPush(body);
}

Propeller::Propeller(const Vector3 &push, const Vector3 &p, real force, real speed, const Vector3 *wind)
    : Thruster("Propeller::Propeller", push, p, force), pitchSpeed(speed), windspeed(wind) {
    requirePositive(speed, "Propeller::Propeller", "the pitch speed must be positive and finite");
}

Vector3 Propeller::getForce(const RigidBody &body) const {
    Vector3 flow = body.getVelocity();
    if (windspeed != nullptr) flow += *windspeed;
    if (windField != nullptr) flow -= windField->getVelocity(body.getPointInWorldSpace(position));
    if (water != nullptr) flow -= water->getVelocity(body.getPointInWorldSpace(position));
    const real advance =
        real_clamp(flow * body.getDirectionInWorldSpace(direction) / pitchSpeed, 0, REAL_MAX);
    return Thruster::getForce(body) * (1 - advance);
}

void Propeller::updateForce(RigidBody *body, real duration) {
    Thruster::updateForce(body, duration);
    body->addResistance(throttle * maxForce / pitchSpeed, 0);
}

/// Backwards, too, where the push does not answer: one step may end in forward motion.
void Propeller::addResistance(const RigidBody &body, Resistance &sum) const {
    const Vector3 push = body.getDirectionInWorldSpace(direction);
    const Vector3 answer = push * (-getPush(body) / pitchSpeed);
    sum.add(Matrix3(answer * push.x, answer * push.y, answer * push.z),
            body.getDirectionInWorldSpace(position), false);
}

}  // namespace cyclone
