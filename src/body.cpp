#include <cyclone/body.h>

#include <algorithm>

#include "arguments.h"
#include "principalaxes.h"

namespace cyclone {

using namespace detail;

// ---- Mass and inertia

void RigidBody::setMass(real kilograms) {
    require(kilograms > 0 && kilograms <= REAL_MAX && real_isfinite(1 / kilograms), "RigidBody::setMass",
            "the mass must be positive and finite", {kilograms});
    makeMovable("RigidBody::setMass");
    mass = kilograms;
    inverseMass = 1 / kilograms;
}

void RigidBody::setInverseMass(real inverse) {
    require(inverse == 0 || (inverse > 0 && inverse <= REAL_MAX && real_isfinite(1 / inverse)),
            "RigidBody::setInverseMass", "the inverse mass must be finite and not negative", {inverse});
    if (inverse > 0)
        makeMovable("RigidBody::setInverseMass");
    else
        angularMomentum = Vector3();
    inverseMass = inverse;
    mass = inverse > 0 ? 1 / inverse : REAL_MAX;
}

/// An immovable body turns without angular momentum; a movable one has that of its rotation.
void RigidBody::makeMovable(const char *function) {
    if (hasFiniteMass()) return;
    const Vector3 momentum = angularMomentumFor(rotation, orientation);
    requireVector(momentum.isFinite(), function, "the angular momentum must stay finite", rotation);
    angularMomentum = momentum;
}

namespace {

Vector3 reciprocals(const Vector3 &v) { return Vector3(1 / v.x, 1 / v.y, 1 / v.z); }

std::uint8_t axisOfIntermediateValue(const Vector3 &v) {
    const auto isBetween = [](real value, real a, real b) {
        return (a <= value && value <= b) || (b <= value && value <= a);
    };
    if (isBetween(v.y, v.x, v.z)) return 1;
    return isBetween(v.x, v.y, v.z) ? 0 : 2;
}

Matrix3 rotationMatrix(const Quaternion &q) {
    Matrix3 matrix;
    matrix.setOrientation(q);
    return matrix;
}

}  // namespace

void RigidBody::setPrincipalInertia(const Matrix3 &tensor, bool isInverse, const char *function) {
    requireFinite(tensor, function, "the tensor must be finite");
    requireMatrix(isSymmetric(tensor), function, "the tensor must be symmetric", tensor);

    Vector3 values;
    Quaternion axes;
    findPrincipalAxes(symmetricPart(tensor), values, axes);
    const real rounding = 16 * REAL_EPSILON * std::max({values.x, values.y, values.z});
    if (isInverse) {
        requireMatrix(std::min({values.x, values.y, values.z}) >= (axes == Quaternion() ? 0 : -rounding),
                      function, "no principal value may be negative", tensor);
        const real least = axes == Quaternion() ? 0 : rounding;
        for (unsigned axis = 0; axis < 3; ++axis)
            if (values[axis] <= least || !real_isfinite(1 / values[axis])) values[axis] = 0;
    } else {
        requireMatrix(std::min({values.x, values.y, values.z}) > rounding, function,
                      "the tensor must be positive definite", tensor);
    }

    RigidBody changed = *this;
    changed.inertia = isInverse ? reciprocals(values) : values;
    requireMatrix(areBearable(changed.inertia), function,
                  "the moments must be between 1e-100 and 1e100 kg·m², and none 1e12 times another", tensor);
    changed.setPrincipalFrame(isInverse ? values : reciprocals(values), axes);
    if (hasFiniteMass()) changed.angularMomentum = changed.angularMomentumFor(rotation, orientation);
    requireMatrix(changed.angularMomentum.isFinite(), function, "the angular momentum must stay finite",
                  tensor);
    *this = changed;
}

void RigidBody::setPrincipalFrame(const Vector3 &inverseMoments, const Quaternion &axes) {
    inverseInertia = inverseMoments;
    principalAxes = axes;
    updatePrincipalFrame();
}

void RigidBody::updatePrincipalFrame() {
    principalFrame.intermediateAxis = axisOfIntermediateValue(inverseInertia) & 3;
    principalFrame.hasLockedAxis = inverseInertia.x == 0 || inverseInertia.y == 0 || inverseInertia.z == 0;
    principalFrame.isTurned = principalAxes != Quaternion();
}

void RigidBody::setInertiaTensor(const Matrix3 &inertiaTensor) {
    setPrincipalInertia(inertiaTensor, false, "RigidBody::setInertiaTensor");
}

void RigidBody::setInverseInertiaTensor(const Matrix3 &inverseInertiaTensor) {
    setPrincipalInertia(inverseInertiaTensor, true, "RigidBody::setInverseInertiaTensor");
}

Matrix3 RigidBody::getInertiaTensor() const {
    requireVector(!principalFrame.hasLockedAxis, "RigidBody::getInertiaTensor", "no axis may be locked",
                  inverseInertia);
    return tensorFromPrincipalAxes(principalAxes, inertia);
}

Matrix3 RigidBody::getInverseInertiaTensor() const {
    return tensorFromPrincipalAxes(principalAxes, inverseInertia);
}

Matrix3 RigidBody::getInertiaTensorWorld() const {
    requireVector(!principalFrame.hasLockedAxis, "RigidBody::getInertiaTensorWorld", "no axis may be locked",
                  inverseInertia);
    return tensorFromPrincipalAxes(orientation * principalAxes, inertia);
}

Matrix3 RigidBody::getInverseInertiaTensorWorld() const {
    return tensorFromPrincipalAxes(orientation * principalAxes, inverseInertia);
}

Matrix3 RigidBody::getPrincipalAxesInWorld() const { return rotationMatrix(orientation * principalAxes); }

/// The angular momentum of a rotation of a movable body; locked axes have no part in it.
Vector3 RigidBody::angularMomentumFor(const Vector3 &turning, const Quaternion &bodyToWorld) const {
    const Matrix3 axes = rotationMatrix(bodyToWorld * principalAxes);
    Vector3 momentum = axes.transformTranspose(turning);
    for (unsigned axis = 0; axis < 3; ++axis)
        momentum[axis] = inverseInertia[axis] > 0 ? momentum[axis] * inertia[axis] : 0;
    return axes.transform(momentum);
}

// ---- Damping

namespace {

void requireDamping(real damping, const char *function) {
    require(damping >= 0 && damping <= 1, function, "the damping must be between 0 and 1", {damping});
}

}  // namespace

void RigidBody::setDamping(real linear, real angular) {
    requireDamping(linear, "RigidBody::setDamping");
    requireDamping(angular, "RigidBody::setDamping");
    if (linear != linearDamping || angular != angularDamping) dampedDuration = 0;
    linearDamping = linear;
    angularDamping = angular;
}

void RigidBody::setLinearDamping(real damping) {
    requireDamping(damping, "RigidBody::setLinearDamping");
    setDamping(damping, angularDamping);
}

void RigidBody::setAngularDamping(real damping) {
    requireDamping(damping, "RigidBody::setAngularDamping");
    setDamping(linearDamping, damping);
}

// ---- Motion

void RigidBody::setLockedMotion(bool x, bool y, bool z) {
    lockedMotion = static_cast<std::uint8_t>((x ? 1 : 0) | (y ? 2 : 0) | (z ? 4 : 0));
    for (Vector3 *locked : {&velocity, &acceleration, &memory.acceleration}) *locked = possible(*locked);
}

void RigidBody::setPosition(const Vector3 &worldPoint) {
    requireFinite(worldPoint, "RigidBody::setPosition", "the position must be finite");
    transform.setAxisVector(3, possible(worldPoint, getPosition()));
}

void RigidBody::setOrientation(const Quaternion &bodyToWorld) {
    const Quaternion &q = bodyToWorld;
    requireRotation(q, "RigidBody::setOrientation", "the quaternion must be finite and not zero");
    Quaternion unit = q;
    if (real_abs(q.squareMagnitude() - 1) > 4 * REAL_EPSILON) unit.normalise();
    const Vector3 momentum = hasFiniteMass() ? angularMomentumFor(rotation, unit) : Vector3();
    requireVector(momentum.isFinite(), "RigidBody::setOrientation", "the angular momentum must stay finite",
                  rotation);
    orientation = unit;
    angularMomentum = momentum;
    calculateDerivedData();
}

void RigidBody::setVelocity(const Vector3 &metresPerSecond) {
    requireFinite(metresPerSecond, "RigidBody::setVelocity", "the velocity must be finite");
    const Vector3 changed = possible(metresPerSecond);
    if (!awake && changed != Vector3()) setAwake(true);
    velocity = changed;
}

void RigidBody::setRotation(const Vector3 &radiansPerSecond) {
    requireFinite(radiansPerSecond, "RigidBody::setRotation", "the rotation must be finite");
    const Vector3 momentum = hasFiniteMass() ? angularMomentumFor(radiansPerSecond, orientation) : Vector3();
    requireVector(momentum.isFinite(), "RigidBody::setRotation", "the angular momentum must stay finite",
                  radiansPerSecond);
    if (!awake && radiansPerSecond != Vector3()) setAwake(true);
    rotation = radiansPerSecond;
    angularMomentum = momentum;
}

void RigidBody::addVelocity(const Vector3 &change) {
    requireVector((velocity + change).isFinite(), "RigidBody::addVelocity", "the change must be finite",
                  change);
    setVelocity(velocity + change);
}

void RigidBody::addRotation(const Vector3 &change) {
    requireVector((rotation + change).isFinite(), "RigidBody::addRotation", "the change must be finite",
                  change);
    setRotation(rotation + change);
}

void RigidBody::addImpulse(const Vector3 &impulse) {
    const Vector3 changed = velocity + impulse * inverseMass;
    requireVector(impulse.isFinite() && changed.isFinite(), "RigidBody::addImpulse",
                  "the impulse and the velocity must be finite", impulse);
    setVelocity(changed);
}

void RigidBody::addImpulseAtPoint(const Vector3 &impulse, const Vector3 &worldPoint) {
    constexpr const char *FUNCTION = "RigidBody::addImpulseAtPoint";
    requireFinite(impulse, FUNCTION, "the impulse must be finite");
    requireFinite(worldPoint, FUNCTION, "the point must be finite");
    if (!hasFiniteMass()) return;
    const Vector3 changedVelocity = velocity + impulse * inverseMass;
    const Vector3 changedRotation =
        rotation + getInverseInertiaTensorWorld() * ((worldPoint - getPosition()) % impulse);
    requireVector(changedVelocity.isFinite() && changedRotation.isFinite() &&
                      angularMomentumFor(changedRotation, orientation).isFinite(),
                  FUNCTION, "the motion must stay finite", impulse);
    setVelocity(changedVelocity);
    setRotation(changedRotation);
}

void RigidBody::setAcceleration(const Vector3 &metresPerSecondSquared) {
    requireFinite(metresPerSecondSquared, "RigidBody::setAcceleration", "the acceleration must be finite");
    const Vector3 changed = possible(metresPerSecondSquared);
    if (!awake && changed != acceleration && changed != Vector3()) setAwake(true);
    acceleration = changed;
}

void RigidBody::calculateDerivedData() { transform.setOrientationAndPos(orientation, getPosition()); }

// ---- Forces and sleep

void RigidBody::dropLockedForces() {
    generated.force = possible(generated.force);
    added.force = possible(added.force);
}

void RigidBody::wakeForForce(Vector3 force, Vector3 torque) {
    if (faulted) return;
    if (possible(force) != Vector3() || torque != Vector3())
        setAwake(true);
    else
        dropLockedForces();  // nothing lies on a sleeping body
}

void RigidBody::setAwake(bool wake) {
    if (wake) {
        motion = std::min(2 * sleepEpsilon, REAL_MAX);
        if (!awake) forgetForces();
        if (faulted) clearForces();
        faulted = false;
    } else {
        velocity = rotation = angularMomentum = lastFrameAcceleration = Vector3();
        motion = 0;
        clearForces();
        forgetForces();
    }
    awake = wake;
}

void RigidBody::setCanSleep(bool may) {
    canSleep = may;
    motion = std::min(2 * sleepEpsilon, REAL_MAX);
    if (!may && !awake && !faulted) setAwake(true);
}

void RigidBody::setSleepEpsilon(real epsilon) {
    requireNotNegative(epsilon, "RigidBody::setSleepEpsilon", "the limit must be finite and not negative");
    sleepEpsilon = epsilon;
    motion = std::min(2 * sleepEpsilon, REAL_MAX);
}

void RigidBody::fallAsleepIfIdle(real duration) {
    const real kept = 1 / (1 + duration);  // of the mean, about a second
    const real current = velocity.squareMagnitude() + rotation.squareMagnitude();
    motion = std::min(kept * motion + (1 - kept) * current, std::min(10 * sleepEpsilon, REAL_MAX));
    const bool isTorqueFree = !hasFiniteMass() || generated.torque + added.torque == Vector3();
    const bool nothingActs = isTorqueFree && lastFrameAcceleration == Vector3();
    if (nothingActs && motion < sleepEpsilon) setAwake(false);
}

void RigidBody::markFaulted() {
    clearForces();
    forgetForces();
    awake = false;
    faulted = true;
}

}  // namespace cyclone
