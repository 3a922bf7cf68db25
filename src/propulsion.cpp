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

Vector3 Thruster::getForce(const RigidBody &body) const {
    real push = throttle * maxForce;
    if (water != nullptr) {
        const Vector3 point = body.getPointInWorldSpace(position);
        push *= real_clamp((water->getHeight(point) + radius - point.y) / (2 * radius), 0, 1);
    }
    return body.getDirectionInWorldSpace(direction) * push;
}

Propeller::Propeller(const Vector3 &push, const Vector3 &p, real force, real speed, const Vector3 *wind)
    : Thruster("Propeller::Propeller", push, p, force), pitchSpeed(speed), windspeed(wind) {
    requirePositive(speed, "Propeller::Propeller", "the pitch speed must be positive and finite");
}

Vector3 Propeller::getForce(const RigidBody &body) const {
    Vector3 flow = body.getVelocity();
    if (windspeed != nullptr) flow += *windspeed;
    if (water != nullptr) flow -= water->getVelocity(body.getPointInWorldSpace(position));
    const real advance =
        real_clamp(flow * body.getDirectionInWorldSpace(direction) / pitchSpeed, 0, REAL_MAX);
    return Thruster::getForce(body) * (1 - advance);
}

}  // namespace cyclone
