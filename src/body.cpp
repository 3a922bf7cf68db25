#include <cyclone/body.h>

#include <algorithm>

namespace cyclone {

// ---- Mass and inertia

void RigidBody::setMass(real kilograms) {
    require(kilograms > 0 && kilograms <= REAL_MAX && real_isfinite(1 / kilograms), "RigidBody::setMass",
            "the mass must be positive and finite", {kilograms});
    mass = kilograms;
    inverseMass = 1 / kilograms;
    setMomentumFromRotation();
}

void RigidBody::setInverseMass(real inverse) {
    require(inverse == 0 || (inverse > 0 && inverse <= REAL_MAX && real_isfinite(1 / inverse)),
            "RigidBody::setInverseMass", "the inverse mass must be finite and not negative", {inverse});
    inverseMass = inverse;
    mass = inverse > 0 ? 1 / inverse : REAL_MAX;
    setMomentumFromRotation();
}

namespace {

Vector3 reciprocals(const Vector3 &v) { return Vector3(1 / v.x, 1 / v.y, 1 / v.z); }

bool isSymmetric(const Matrix3 &m) {
    const real size = std::max({real_abs(m.data[0]), real_abs(m.data[4]), real_abs(m.data[8])});
    const real tolerance = 1e-9 * size;
    return real_abs(m.data[1] - m.data[3]) <= tolerance && real_abs(m.data[2] - m.data[6]) <= tolerance &&
           real_abs(m.data[5] - m.data[7]) <= tolerance;
}

std::uint8_t axisOfMiddleValue(const Vector3 &v) {
    if ((v.x <= v.y) == (v.y <= v.z)) return 1;
    if ((v.y <= v.x) == (v.x <= v.z)) return 0;
    return 2;
}

/// R·diag(values)·Rᵀ, symmetric to the last bit.
Matrix3 tensorInFrame(const Matrix3 &axes, const Vector3 &values) {
    const Vector3 x = axes.getRowVector(0), y = axes.getRowVector(1), z = axes.getRowVector(2);
    const Vector3 vx = values.componentProduct(x), vy = values.componentProduct(y);
    const real xy = vx * y, xz = vx * z, yz = vy * z;
    return Matrix3(vx * x, xy, xz, xy, vy * y, yz, xz, yz, values.componentProduct(z) * z);
}

Matrix3 rotationMatrix(const Quaternion &q) {
    Matrix3 matrix;
    matrix.setOrientation(q);
    return matrix;
}

}  // namespace

void RigidBody::setPrincipalInertia(const Matrix3 &tensor, bool isInverse, const char *function) {
    requireMatrix(tensor.isFinite(), function, "the tensor must be finite", tensor);
    requireMatrix(isSymmetric(tensor), function, "the tensor must be symmetric", tensor);

    Vector3 values;
    Quaternion axes;
    findPrincipalAxes((tensor + tensor.transpose()) * 0.5, values, axes);
    const real rounding = 16 * REAL_EPSILON * std::max({values.x, values.y, values.z});
    if (isInverse) {
        requireMatrix(std::min({values.x, values.y, values.z}) >= (axes == Quaternion() ? 0 : -rounding),
                      function, "no principal value may be negative", tensor);
        const real least = axes == Quaternion() ? 0 : rounding;
        for (unsigned axis = 0; axis < 3; ++axis)
            if (values[axis] <= least || !real_isfinite(1 / values[axis])) values[axis] = 0;
    } else {
        requireMatrix(std::min({values.x, values.y, values.z}) > rounding && reciprocals(values).isFinite(),
                      function, "the tensor must be positive definite", tensor);
    }

    RigidBody changed = *this;
    changed.inertia = isInverse ? reciprocals(values) : values;
    changed.setPrincipalFrame(isInverse ? values : reciprocals(values), axes);
    changed.setMomentumFromRotation();
    requireMatrix(changed.angularMomentum.isFinite(), function, "the angular momentum must stay finite",
                  tensor);
    *this = changed;
}

void RigidBody::setPrincipalFrame(const Vector3 &inverseMoments, const Quaternion &axes) {
    inverseInertia = inverseMoments;
    middleAxis = axisOfMiddleValue(inverseInertia);
    principalAxes = axes;
    hasPrincipalAxes = axes != Quaternion();
}

void RigidBody::setInertiaTensor(const Matrix3 &inertiaTensor) {
    setPrincipalInertia(inertiaTensor, false, "RigidBody::setInertiaTensor");
}

void RigidBody::setInverseInertiaTensor(const Matrix3 &inverseInertiaTensor) {
    setPrincipalInertia(inverseInertiaTensor, true, "RigidBody::setInverseInertiaTensor");
}

Matrix3 RigidBody::getInertiaTensor() const {
    requireVector(!hasLockedAxis(), "RigidBody::getInertiaTensor", "no axis may be locked", inverseInertia);
    return tensorInFrame(rotationMatrix(principalAxes), inertia);
}

Matrix3 RigidBody::getInverseInertiaTensor() const {
    return tensorInFrame(rotationMatrix(principalAxes), inverseInertia);
}

Matrix3 RigidBody::getInertiaTensorWorld() const {
    requireVector(!hasLockedAxis(), "RigidBody::getInertiaTensorWorld", "no axis may be locked",
                  inverseInertia);
    return tensorInFrame(getPrincipalAxesInWorld(), inertia);
}

Matrix3 RigidBody::getInverseInertiaTensorWorld() const {
    return tensorInFrame(getPrincipalAxesInWorld(), inverseInertia);
}

Matrix3 RigidBody::getPrincipalAxesInWorld() const { return rotationMatrix(orientation * principalAxes); }

/// The angular momentum of a rotation: of an immovable body, and about locked axes, none.
Vector3 RigidBody::momentumOf(const Vector3 &turning) const {
    if (!hasFiniteMass()) return Vector3();
    const Matrix3 axes = getPrincipalAxesInWorld();
    Vector3 momentum = axes.transformTranspose(turning);
    for (unsigned axis = 0; axis < 3; ++axis)
        momentum[axis] = inverseInertia[axis] > 0 ? momentum[axis] * inertia[axis] : 0;
    return axes.transform(momentum);
}

void RigidBody::setMomentumFromRotation() {
    forgetForces();
    angularMomentum = momentumOf(rotation);
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
    if (linear != linearDamping || angular != angularDamping) factorDuration = 0;
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

void RigidBody::setPosition(const Vector3 &worldPoint) {
    requireVector(worldPoint.isFinite(), "RigidBody::setPosition", "the position must be finite", worldPoint);
    transform.setAxisVector(3, worldPoint);
    forgetForces();
}

void RigidBody::setOrientation(const Quaternion &bodyToWorld) {
    const Quaternion &q = bodyToWorld;
    requireQuaternion(q.isFinite() && q != Quaternion(0, 0, 0, 0), "RigidBody::setOrientation",
                      "the quaternion must be finite and not zero", q);
    orientation = q;
    if (real_abs(q.squareMagnitude() - 1) > 4 * REAL_EPSILON) orientation.normalise();
    calculateDerivedData();
    setMomentumFromRotation();
}

void RigidBody::setVelocity(const Vector3 &metresPerSecond) {
    requireVector(metresPerSecond.isFinite(), "RigidBody::setVelocity", "the velocity must be finite",
                  metresPerSecond);
    if (!awake && metresPerSecond != Vector3()) setAwake(true);
    velocity = metresPerSecond;
    forgetForces();
}

void RigidBody::setRotation(const Vector3 &radiansPerSecond) {
    requireVector(radiansPerSecond.isFinite(), "RigidBody::setRotation", "the rotation must be finite",
                  radiansPerSecond);
    requireVector(momentumOf(radiansPerSecond).isFinite(), "RigidBody::setRotation",
                  "the angular momentum must stay finite", radiansPerSecond);
    if (!awake && radiansPerSecond != Vector3()) setAwake(true);
    rotation = radiansPerSecond;
    setMomentumFromRotation();
}

void RigidBody::addVelocity(const Vector3 &change) {
    requireVector((velocity + change).isFinite(), "RigidBody::addVelocity", "the change must be finite",
                  change);
    setVelocity(velocity + change);
}

void RigidBody::addRotation(const Vector3 &change) {
    requireVector((rotation + change).isFinite() && momentumOf(rotation + change).isFinite(),
                  "RigidBody::addRotation", "the change must be finite", change);
    setRotation(rotation + change);
}

void RigidBody::setAcceleration(const Vector3 &metresPerSecondSquared) {
    requireVector(metresPerSecondSquared.isFinite(), "RigidBody::setAcceleration",
                  "the acceleration must be finite", metresPerSecondSquared);
    if (!awake && metresPerSecondSquared != acceleration && metresPerSecondSquared != Vector3())
        setAwake(true);
    acceleration = metresPerSecondSquared;
}

void RigidBody::calculateDerivedData() { transform.setOrientationAndPos(orientation, getPosition()); }

// ---- Forces and sleep

void RigidBody::dropLoads() {
    if (isGenerated) generated = Load();
    if (hasAdded) added = Load();
    hasAdded = isGenerated = startsAfresh = inGenerator = false;
}

void RigidBody::Course::follow(const Vector3 &now) {
    const Vector3 step = now - last;
    const real square = now.squareMagnitude();
    greatestSquare = std::max(greatestSquare, square);
    if (step.squareMagnitude() > 0.25 * greatestSquare) {
        change = Vector3();
        greatestSquare = square;
    } else {
        change += step;
    }
    last = now;
}

void RigidBody::followAdded() {
    if (!wasAdded) addedForces = addedTorques = Course();
    addedForces.follow(added.force);
    addedTorques.follow(added.torque);
}

void RigidBody::wakeForLoad(const Vector3 &force, const Vector3 &torque) {
    if (!faulted && (force != Vector3() || torque != Vector3())) setAwake(true);
}

void RigidBody::setAwake(bool wake) {
    if (wake) {
        motion = 2 * sleepEpsilon;
        if (faulted) dropLoads();
        faulted = false;
    } else {
        velocity = rotation = angularMomentum = lastFrameAcceleration = Vector3();
        motion = 0;
        dropLoads();
        forgetForces();
    }
    awake = wake;
}

void RigidBody::setCanSleep(bool may) {
    canSleep = may;
    motion = 2 * sleepEpsilon;
    if (!may && !awake && !faulted) setAwake(true);
}

void RigidBody::setSleepEpsilon(real epsilon) {
    require(epsilon >= 0 && epsilon <= REAL_MAX, "RigidBody::setSleepEpsilon",
            "the limit must be finite and not negative", {epsilon});
    sleepEpsilon = epsilon;
    motion = 2 * sleepEpsilon;
}

void RigidBody::fallAsleepIfIdle(bool nothingTwists, real duration) {
    const real memory = 1 / (1 + duration);  // of the mean, about a second
    const real current = velocity.squareMagnitude() + rotation.squareMagnitude();
    motion = std::min(memory * motion + (1 - memory) * current, 10 * sleepEpsilon);
    const bool nothingActs = nothingTwists && lastFrameAcceleration == Vector3();
    if (nothingActs && motion < sleepEpsilon) setAwake(false);
}

void RigidBody::keepLastGoodState() {
    dropLoads();
    forgetForces();
    addedForces = addedTorques = Course();
    awake = false;
    faulted = true;
}

// ---- Saving and restoring

RigidBody::State RigidBody::getState() const {
    State s;
    s.position = getPosition();
    s.orientation = orientation;
    s.velocity = velocity;
    s.rotation = rotation;
    s.angularMomentum = angularMomentum;
    s.acceleration = acceleration;
    s.lastFrameAcceleration = lastFrameAcceleration;
    s.addedForce = added.force;
    s.addedTorque = added.torque;
    s.generatedForce = generated.force;
    s.generatedTorque = generated.torque;
    s.lastForce = lastGenerated.force;
    s.lastTorque = lastGenerated.torque;
    s.lastDuration = lastDuration;
    s.addedForces = addedForces;
    s.addedTorques = addedTorques;
    s.mass = mass;
    s.inverseMass = inverseMass;
    s.inertia = inertia;
    s.inverseInertia = inverseInertia;
    s.principalAxes = principalAxes;
    s.linearDamping = linearDamping;
    s.angularDamping = angularDamping;
    s.motion = motion;
    s.sleepEpsilon = sleepEpsilon;
    s.awake = awake;
    s.canSleep = canSleep;
    s.faulted = faulted;
    s.hasAdded = hasAdded;
    s.isGenerated = isGenerated;
    s.startsAfresh = startsAfresh;
    s.hasStartedAfresh = hasStartedAfresh;
    s.wasAdded = wasAdded;
    s.hasAddedAfresh = hasAddedAfresh;
    return s;
}

namespace {

bool isUnit(const Quaternion &q) { return real_abs(q.squareMagnitude() - 1) < 1e-9; }

bool isNotNegative(real value) { return value >= 0 && value <= REAL_MAX; }

bool isDamping(real value) { return value >= 0 && value <= 1; }

}  // namespace

const char *RigidBody::State::findError() const {
    if (!position.isFinite()) return "the position must be finite";
    if (!isUnit(orientation)) return "the orientation must be a unit quaternion";
    if (!velocity.isFinite()) return "the velocity must be finite";
    if (!rotation.isFinite()) return "the rotation must be finite";
    if (!angularMomentum.isFinite()) return "the angular momentum must be finite";
    if (!acceleration.isFinite()) return "the acceleration must be finite";
    if (!lastFrameAcceleration.isFinite()) return "the last frame's acceleration must be finite";
    if (!lastForce.isFinite() || !lastTorque.isFinite()) return "the last step's forces must be finite";
    if (!addedForces.isFinite() || !addedTorques.isFinite())
        return "the last step's added forces must be finite";
    if (!isNotNegative(lastDuration)) return "the last step's duration must be finite and not negative";
    if (!isNotNegative(inverseMass)) return "the inverse mass must be finite and not negative";
    if (!(inverseMass == 0 ? mass == REAL_MAX : real_abs(mass * inverseMass - 1) < 1e-9))
        return "the mass must match its inverse";
    for (unsigned axis = 0; axis < 3; ++axis) {
        const real moment = inertia[axis], inverse = inverseInertia[axis];
        if (!isNotNegative(inverse)) return "the inverse moments of inertia must be finite and not negative";
        if (!(inverse == 0 ? moment > 0 : real_abs(moment * inverse - 1) < 1e-9))
            return "the moments of inertia must be positive and match their inverses";
    }
    if (!isUnit(principalAxes)) return "the principal axes must be a unit quaternion";
    if (!isDamping(linearDamping) || !isDamping(angularDamping)) return "the damping must be between 0 and 1";
    if (!isNotNegative(motion)) return "the motion must be finite and not negative";
    if (!isNotNegative(sleepEpsilon)) return "the sleep limit must be finite and not negative";
    return nullptr;
}

void RigidBody::setState(const State &s) {
    const char *const error = s.findError();
    require(error == nullptr, "RigidBody::setState", error);

    orientation = s.orientation;
    transform.setOrientationAndPos(s.orientation, s.position);
    velocity = s.velocity;
    rotation = s.rotation;
    angularMomentum = s.angularMomentum;
    acceleration = s.acceleration;
    lastFrameAcceleration = s.lastFrameAcceleration;
    added = {s.addedForce, s.addedTorque};
    generated = {s.generatedForce, s.generatedTorque};
    lastGenerated = {s.lastForce, s.lastTorque};
    lastDuration = s.lastDuration;
    addedForces = s.addedForces;
    addedTorques = s.addedTorques;
    mass = s.mass;
    inverseMass = s.inverseMass;
    inertia = s.inertia;
    setPrincipalFrame(s.inverseInertia, s.principalAxes);
    setDamping(s.linearDamping, s.angularDamping);
    motion = s.motion;
    sleepEpsilon = s.sleepEpsilon;
    awake = s.awake;
    canSleep = s.canSleep;
    faulted = s.faulted;
    hasAdded = s.hasAdded;
    isGenerated = s.isGenerated;
    startsAfresh = s.startsAfresh;
    hasStartedAfresh = s.hasStartedAfresh;
    wasAdded = s.wasAdded;
    hasAddedAfresh = s.hasAddedAfresh;
}

RigidBody::State RigidBody::State::linearInterpolate(const State &a, const State &b, real prop) {
    const auto between = [prop](const Vector3 &from, const Vector3 &to) {
        return from * (1 - prop) + to * prop;
    };
    State result = b;
    result.position = between(a.position, b.position);
    result.velocity = between(a.velocity, b.velocity);
    result.rotation = between(a.rotation, b.rotation);
    result.orientation = Quaternion::linearInterpolate(a.orientation, b.orientation, prop);
    return result;
}

}  // namespace cyclone
