#include <cyclone/propulsion.h>

namespace cyclone {

Thruster::Thruster(const Vector3 &push, const Vector3 &p, real force) : position(p), maxForce(force) {
    setDirection(push);
    requireVector(p.isFinite(), "Thruster::Thruster", "the position must be finite", p);
    require(force >= 0 && force <= REAL_MAX, "Thruster::Thruster",
            "the greatest force must be finite and not negative", {force});
}

void Thruster::setThrottle(real value) {
    require(value == value, "Thruster::setThrottle", "the throttle must be a number", {value});
    throttle = real_clamp(value, 0, 1);
}

void Thruster::setDirection(const Vector3 &bodyDirection) {
    requireVector(bodyDirection.isFinite() && bodyDirection != Vector3(), "Thruster::setDirection",
                  "the direction must be finite and not zero", bodyDirection);
    direction = bodyDirection.unit();
}

Vector3 Thruster::getForce(const RigidBody &body) const {
    return body.getDirectionInWorldSpace(direction) * (throttle * maxForce);
}

void Thruster::updateForce(RigidBody *body, real) { body->addForceAtBodyPoint(getForce(*body), position); }

Propeller::Propeller(const Vector3 &push, const Vector3 &p, real force, real speed, const Vector3 *wind)
    : Thruster(push, p, force), pitchSpeed(speed), windspeed(wind) {
    require(speed > 0 && speed <= REAL_MAX, "Propeller::Propeller",
            "the pitch speed must be positive and finite", {speed});
}

Vector3 Propeller::getForce(const RigidBody &body) const {
    const Vector3 flow = windspeed != nullptr ? body.getVelocity() + *windspeed : body.getVelocity();
    const real advance =
        real_clamp(flow * body.getDirectionInWorldSpace(direction) / pitchSpeed, 0, REAL_MAX);
    return Thruster::getForce(body) * (1 - advance);
}

}  // namespace cyclone
