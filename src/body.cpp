#include <cyclone/body.h>
#include <cyclone/freerotation.h>

#include <algorithm>

namespace cyclone {

// ---- Mass and inertia
// -------------------------------------------------------------------------------------------

void RigidBody::setMass(real kilograms) {
    require(kilograms > 0 && kilograms <= REAL_MAX && real_isfinite(1 / kilograms), "RigidBody::setMass",
            "the mass must be positive and finite", {kilograms});
    mass = kilograms;
    inverseMass = 1 / kilograms;
    setMomentumFromRotation();
}

void RigidBody::setInverseMass(real inverse) {
    require(inverse >= 0 && inverse <= REAL_MAX, "RigidBody::setInverseMass",
            "the inverse mass must be finite and not negative", {inverse});
    inverseMass = inverse;
    mass = inverse > 0 ? std::min(1 / inverse, REAL_MAX) : REAL_MAX;
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
        requireMatrix(std::min({values.x, values.y, values.z}) >= -rounding, function,
                      "no principal value may be negative", tensor);
        if (axes != Quaternion())
            for (unsigned axis = 0; axis < 3; ++axis)
                if (values[axis] <= rounding) values[axis] = 0;
    } else {
        requireMatrix(std::min({values.x, values.y, values.z}) > rounding && reciprocals(values).isFinite(),
                      function, "the tensor must be positive definite", tensor);
    }

    inertia = isInverse ? reciprocals(values) : values;
    inverseInertia = isInverse ? values : reciprocals(values);
    hasLockedAxis = inverseInertia.x == 0 || inverseInertia.y == 0 || inverseInertia.z == 0;
    principalAxes = axes;
    hasPrincipalAxes = axes != Quaternion();
    middleAxis = axisOfMiddleValue(inverseInertia);
    setMomentumFromRotation();
}

void RigidBody::setInertiaTensor(const Matrix3 &inertiaTensor) {
    setPrincipalInertia(inertiaTensor, false, "RigidBody::setInertiaTensor");
}

void RigidBody::setInverseInertiaTensor(const Matrix3 &inverseInertiaTensor) {
    setPrincipalInertia(inverseInertiaTensor, true, "RigidBody::setInverseInertiaTensor");
}

Matrix3 RigidBody::getInertiaTensor() const {
    requireVector(!hasLockedAxis, "RigidBody::getInertiaTensor", "no axis may be locked", inverseInertia);
    return tensorInFrame(rotationMatrix(principalAxes), inertia);
}

Matrix3 RigidBody::getInverseInertiaTensor() const {
    return tensorInFrame(rotationMatrix(principalAxes), inverseInertia);
}

Matrix3 RigidBody::getInertiaTensorWorld() const {
    requireVector(!hasLockedAxis, "RigidBody::getInertiaTensorWorld", "no axis may be locked",
                  inverseInertia);
    return tensorInFrame(getPrincipalAxesInWorld(), inertia);
}

Matrix3 RigidBody::getInverseInertiaTensorWorld() const {
    return tensorInFrame(getPrincipalAxesInWorld(), inverseInertia);
}

Matrix3 RigidBody::getPrincipalAxesInWorld() const { return rotationMatrix(orientation * principalAxes); }

/// The momentum that belongs to the rotation: of an immovable body, and about locked axes, none.
void RigidBody::setMomentumFromRotation() {
    forgetForces();
    angularMomentum.clear();
    if (!hasFiniteMass()) return;
    const Matrix3 axes = getPrincipalAxesInWorld();
    Vector3 momentum = axes.transformTranspose(rotation);
    for (unsigned axis = 0; axis < 3; ++axis)
        momentum[axis] = inverseInertia[axis] > 0 ? momentum[axis] * inertia[axis] : 0;
    angularMomentum = axes.transform(momentum);
}

// ---- Damping
// ----------------------------------------------------------------------------------------------------

namespace {

void requireDamping(real damping, const char *function) {
    require(damping >= 0 && damping <= 1, function, "the damping must be between 0 and 1", {damping});
}

}  // namespace

void RigidBody::setDamping(real linear, real angular) {
    requireDamping(linear, "RigidBody::setDamping");
    requireDamping(angular, "RigidBody::setDamping");
    linearDamping = linear;
    angularDamping = angular;
    factorDuration = 0;
}

void RigidBody::setLinearDamping(real damping) {
    requireDamping(damping, "RigidBody::setLinearDamping");
    setDamping(damping, angularDamping);
}

void RigidBody::setAngularDamping(real damping) {
    requireDamping(damping, "RigidBody::setAngularDamping");
    setDamping(linearDamping, damping);
}

void RigidBody::renewDampingFactors(real duration) {
    linearFactor = real_pow(linearDamping, duration / 2);
    angularFactor = real_pow(angularDamping, duration / 2);
    factorDuration = duration;
}

// ---- Motion
// -----------------------------------------------------------------------------------------------------

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
    if (!awake && radiansPerSecond != Vector3()) setAwake(true);
    rotation = radiansPerSecond;
    setMomentumFromRotation();
}

void RigidBody::setAcceleration(const Vector3 &metresPerSecondSquared) {
    requireVector(metresPerSecondSquared.isFinite(), "RigidBody::setAcceleration",
                  "the acceleration must be finite", metresPerSecondSquared);
    acceleration = metresPerSecondSquared;
}

void RigidBody::calculateDerivedData() { transform.setOrientationAndPos(orientation, getPosition()); }

// ---- Forces and sleep
// -------------------------------------------------------------------------------------------

void RigidBody::dropLoads() {
    generated = added = Load();
    hasAdded = isGenerated = inGenerator = false;
}

void RigidBody::wakeForLoad(const Vector3 &force, const Vector3 &torque) {
    if (force != Vector3() || torque != Vector3()) setAwake(true);
}

void RigidBody::setAwake(bool wake) {
    if (wake) {
        motion = 2 * sleepEpsilon;
        faulted = false;
        if (!awake) forgetForces();
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

void RigidBody::fallAsleepIfIdle(const Vector3 &torque, real duration) {
    const real memory = 1 / (1 + duration);  // of the mean, about a second
    const real current = velocity.squareMagnitude() + rotation.squareMagnitude();
    motion = std::min(memory * motion + (1 - memory) * current, 10 * sleepEpsilon);
    const bool nothingActs = lastFrameAcceleration == Vector3() && torque == Vector3();
    if (nothingActs && motion < sleepEpsilon) setAwake(false);
}

void RigidBody::keepLastGoodState() {
    dropLoads();
    forgetForces();
    awake = false;
    faulted = true;
}

// ---- The step
// ---------------------------------------------------------------------------------------------------

/// Up to eight bodies on their way through one step: each is kicked by its forces and drifts along, all turn
/// side by side, then each takes over its new state.
///
/// Kicks and drift are the leapfrog scheme with damping k over half a step,
///
///     v₁ = (v + (A − A_last)·h_last/2 + A·h/2)·k,   x += v₁·h,   v = v₁·k + A·h/2 ,
///
/// and the same for angular momentum with torque, around the free rotation. A is evaluated once, at the
/// start; the term with A_last turns the last step's closing kick into one by the force at its end, which is
/// known only now.
class StepBlock {
public:
    explicit StepBlock(real h) : duration(h) {}

    /// Takes an awake body in; advances all that are in when the block is full.
    void add(RigidBody &body);
    /// Advances those that are in. Returns how many bodies could not be advanced, of all that were ever in.
    std::size_t finish();

private:
    static constexpr int SIZE = FreeRotation::LANES;

    /// What is known of a body after its kick and drift.
    struct Entry {
        RigidBody *body;
        Vector3 acceleration, torque;
        Vector3 angularKick;  ///< what the first half of the step adds to the angular momentum
        Vector3 position, velocity;
    };

    void kickAndDrift(Entry &entry) const;
    void turnLocked(const Entry &entry);
    void gather(const Entry &entry, int lane);
    void scatter(const Entry &entry, int lane);
    bool takeOver(const Entry &entry, const Quaternion &orientation, const Vector3 &rotation,
                  const Vector3 &angularMomentum);

    const real duration;
    FreeRotation turning;
    Entry entries[SIZE];
    int count = 0;
    std::size_t faults = 0;
};

void StepBlock::add(RigidBody &body) {
    if (body.factorDuration != duration) body.renewDampingFactors(duration);
    Entry &entry = entries[count];
    entry.body = &body;
    kickAndDrift(entry);
    if (!body.turnsFreely()) return turnLocked(entry);
    gather(entry, count);
    if (++count == SIZE) finish();
}

std::size_t StepBlock::finish() {
    if (count > 0) turning.advance(count, duration);
    for (int lane = 0; lane < count; ++lane) scatter(entries[lane], lane);
    count = 0;
    return faults;
}

void StepBlock::kickAndDrift(Entry &entry) const {
    const RigidBody &body = *entry.body;
    entry.velocity = body.velocity;
    entry.acceleration = entry.torque = entry.angularKick = Vector3();
    if (body.hasFiniteMass()) {
        Vector3 force = body.generated.force;
        entry.torque = body.generated.torque;
        if (body.hasAdded) {
            force += body.added.force;
            entry.torque += body.added.torque;
        }
        entry.acceleration = body.acceleration + force * body.inverseMass;
        const real mend = body.isGenerated ? body.lastDuration / 2 : 0;
        const Vector3 forceChange = body.generated.force - body.lastGenerated.force;
        const Vector3 torqueChange = body.generated.torque - body.lastGenerated.torque;
        entry.velocity =
            (body.velocity + forceChange * (mend * body.inverseMass) + entry.acceleration * (duration / 2)) *
            body.linearFactor;
        entry.angularKick = torqueChange * mend + entry.torque * (duration / 2);
    }
    entry.position = body.getPosition() + entry.velocity * duration;
}

namespace {

/// Where each body axis goes when the axes are renumbered cyclically so that `middle` becomes axis 0.
constexpr int RENUMBERED[3][3] = {{0, 1, 2}, {2, 0, 1}, {1, 2, 0}};

void storeRenumbered(real (*rows)[FreeRotation::LANES], const int *row, int lane, const Vector3 &v) {
    rows[row[0]][lane] = v.x;
    rows[row[1]][lane] = v.y;
    rows[row[2]][lane] = v.z;
}

Vector3 loadRenumbered(const real (*rows)[FreeRotation::LANES], const int *row, int lane) {
    return Vector3(rows[row[0]][lane], rows[row[1]][lane], rows[row[2]][lane]);
}

}  // namespace

void StepBlock::gather(const Entry &entry, int lane) {
    const RigidBody &body = *entry.body;
    const int *row = RENUMBERED[body.middleAxis];
    const Quaternion q = body.hasPrincipalAxes ? body.orientation * body.principalAxes : body.orientation;
    turning.orientation[0][lane] = q.r;
    storeRenumbered(turning.orientation + 1, row, lane, Vector3(q.i, q.j, q.k));
    storeRenumbered(turning.inverseInertia, row, lane, body.inverseInertia);

    const Vector3 momentum = (body.angularMomentum + entry.angularKick) * body.angularFactor;
    storeRenumbered(turning.momentum, row, lane, momentum);
    storeRenumbered(turning.finalMomentum, row, lane,
                    momentum * body.angularFactor + entry.torque * (duration / 2));
}

void StepBlock::scatter(const Entry &entry, int lane) {
    RigidBody &body = *entry.body;
    const int *row = RENUMBERED[body.middleAxis];
    const Vector3 v = loadRenumbered(turning.orientation + 1, row, lane);
    Quaternion orientation(turning.orientation[0][lane], v.x, v.y, v.z);
    if (body.hasPrincipalAxes) orientation *= body.principalAxes.conjugate();

    if (!takeOver(entry, orientation, loadRenumbered(turning.rotation, row, lane),
                  loadRenumbered(turning.finalMomentum, row, lane)))
        return;
    if (body.hasPrincipalAxes) return body.calculateDerivedData();
    for (int column = 0; column < 3; ++column)
        for (int line = 0; line < 3; ++line)
            body.transform.data[4 * line + column] = turning.matrix[3 * row[line] + row[column]][lane];
}

/// A body that is immovable or has a locked axis: each component of its rotation in its own axes goes on
/// alone, without gyroscopic coupling, and torques act about free axes only.
void StepBlock::turnLocked(const Entry &entry) {
    RigidBody &body = *entry.body;
    const bool movable = body.hasFiniteMass();
    const real factor = movable ? body.angularFactor : 1;
    const Vector3 inverseInertia = movable ? body.inverseInertia : Vector3();
    const Matrix3 axes = body.getPrincipalAxesInWorld();
    const auto gain = [&](const Vector3 &impulse) {
        return inverseInertia.componentProduct(axes.transformTranspose(impulse));
    };
    const Vector3 spin = (axes.transformTranspose(body.rotation) + gain(entry.angularKick)) * factor;
    const Vector3 rotation = spin * factor + gain(entry.torque * (duration / 2));

    Quaternion orientation = body.orientation;
    orientation.rotateByVector(axes.transform(spin) * duration);
    orientation.normalise();
    const Matrix3 newAxes = rotationMatrix(orientation * body.principalAxes);
    if (!takeOver(entry, orientation, newAxes.transform(rotation), Vector3())) return;
    body.calculateDerivedData();
    const real lastDuration = body.lastDuration;
    body.setMomentumFromRotation();
    body.lastDuration = lastDuration;
}

/// Gives the body its new state, if that is finite; its old one otherwise.
bool StepBlock::takeOver(const Entry &entry, const Quaternion &orientation, const Vector3 &rotation,
                         const Vector3 &angularMomentum) {
    RigidBody &body = *entry.body;
    const real linearFactor = body.hasFiniteMass() ? body.linearFactor : 1;
    const Vector3 velocity = entry.velocity * linearFactor + entry.acceleration * (duration / 2);
    const Vector3 sum = entry.position + velocity + rotation + angularMomentum;
    if (!real_isfinite(sum.x + sum.y + sum.z + orientation.r + orientation.i + orientation.j +
                       orientation.k)) {
        body.keepLastGoodState();
        ++faults;
        return false;
    }
    body.transform.setAxisVector(3, entry.position);
    body.orientation = orientation;
    body.velocity = velocity;
    body.rotation = rotation;
    body.angularMomentum = angularMomentum;
    body.lastFrameAcceleration = entry.acceleration;

    body.lastDuration = body.isGenerated ? duration : 0;
    if (body.isGenerated) body.lastGenerated = body.generated;
    body.clearAccumulators();
    if (body.canSleep) body.fallAsleepIfIdle(entry.torque, duration);
    return true;
}

bool RigidBody::integrate(real duration) {
    RigidBody *const self = this;
    return integrate(&self, 1, duration) == 0;
}

std::size_t RigidBody::integrate(RigidBody *const *bodies, std::size_t count, real duration) {
    require(duration >= 0 && duration <= REAL_MAX, "RigidBody::integrate",
            "the duration must be finite and not negative", {duration});
    StepBlock block(duration);
    for (std::size_t n = 0; n < count; ++n)
        if (bodies[n]->awake) block.add(*bodies[n]);
    return block.finish();
}

}  // namespace cyclone
