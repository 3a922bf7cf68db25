#include "models/undercarriage.h"

#include "base/angle.h"

namespace demo {

namespace {

/// The share of full friction at this speed: near ±1, but gentle around 0.
real saturated(real speed, real creepSpeed) {
    return speed / cyclone::real_sqrt(speed * speed + creepSpeed * creepSpeed);
}

}  // namespace

real Wheel::getCompression(const RigidBody &body) const {
    const real height = body.getPointInWorldSpace(point).y;
    return height < 0 ? -height : 0;
}

Vector3 Wheel::getPointVelocity(const RigidBody &body) const {
    return body.getVelocity() + body.getRotation() % body.getDirectionInWorldSpace(point);
}

Vector3 Wheel::getForce(const RigidBody &body) const {
    const real compression = getCompression(body);
    if (compression == 0) return Vector3();
    const Vector3 velocity = getPointVelocity(body);
    const real load = strut.springConstant * compression - strut.damping * velocity.y;
    if (load <= 0) return Vector3();

    Vector3 ahead = body.getDirectionInWorldSpace(towardsBearing(steering));
    ahead.y = 0;
    ahead.normalise();
    const Vector3 across = ahead % Vector3::UP;
    return Vector3::UP * load -
           ahead * (strut.rollingFriction * load * saturated(velocity * ahead, strut.creepSpeed)) -
           across * (strut.grip * load * saturated(velocity * across, strut.creepSpeed));
}

void Wheel::updateForce(RigidBody *body, real) {
    const Vector3 force = getForce(*body);
    if (force != Vector3()) body->addForceAtBodyPoint(force, point);
}

}  // namespace demo
