#include "classic.h"

#include <cmath>

namespace classic {

void Body::calculateDerivedData() {
    orientation.normalise();
    transform.setOrientationAndPos(orientation, position);
    const Matrix3 rotationMatrix = transform.getRotationMatrix();
    inverseInertiaTensorWorld = rotationMatrix * inverseInertiaTensor * rotationMatrix.transpose();
}

void Body::addForceAtBodyPoint(const Vector3 &worldForce, const Vector3 &bodyPoint) {
    const Vector3 arm = transform.transform(bodyPoint) - position;
    force += worldForce;
    torque += arm % worldForce;
    isAwake = true;
}

void Body::clearAccumulators() {
    force.clear();
    torque.clear();
}

void Body::integrate(real duration) {
    if (!isAwake) return;
    lastFrameAcceleration = acceleration;
    lastFrameAcceleration.addScaledVector(force, inverseMass);
    const Vector3 angularAcceleration = inverseInertiaTensorWorld.transform(torque);
    velocity.addScaledVector(lastFrameAcceleration, duration);
    rotation.addScaledVector(angularAcceleration, duration);
    velocity *= std::pow(linearDamping, duration);
    rotation *= std::pow(angularDamping, duration);
    position.addScaledVector(velocity, duration);
    orientation.addScaledVector(rotation, duration);
    calculateDerivedData();
    clearAccumulators();
}

void Aero::updateForce(Body *body, real) {
    const Vector3 flow = body->velocity + *windspeed;
    const Vector3 bodyForce = tensor.transform(body->transform.transformInverseDirection(flow));
    body->addForceAtBodyPoint(body->transform.transformDirection(bodyForce), position);
}

void World::startFrame() {
    for (Body *body : bodies) {
        body->clearAccumulators();
        body->calculateDerivedData();
    }
}

void World::runPhysics(real duration) {
    for (const Registration &r : registrations) r.generator->updateForce(r.body, duration);
    for (Body *body : bodies) body->integrate(duration);
}

}  // namespace classic
