#include <cyclone/compiler.h>
#include <cyclone/step.h>

namespace cyclone {

/// What the caller has added, and how much faster than its velocity the body drifts and turns.
void StepBlock::takeLead(Entry &entry, Twist &twist, Vector3 &torque, bool isRowOfFreshStarts) const {
    RigidBody &body = *entry.body;
    Vector3 leadingForce, leadingTorque;
    if (isRowOfFreshStarts) {
        leadingForce = body.generated.force;
        leadingTorque = body.generated.torque;
    }
    if (body.hasAdded) {
        body.followAdded();
        entry.acceleration += body.added.force * body.inverseMass;
        torque += body.added.torque;
        const bool isRow = body.hasAddedAfresh && !body.wasAdded;
        leadingForce += isRow ? body.added.force : body.addedForces.change;
        leadingTorque += isRow ? body.added.torque : body.addedTorques.change;
    }
    entry.leads = true;
    entry.lead = leadingForce * (duration / 2 * body.inverseMass);
    entry.velocity += entry.lead;
    twist.kick += leadingTorque * (duration / 2);
    twist.closingKick -= leadingTorque * (duration / 2);
}

CYCLONE_INLINE StepBlock::Twist StepBlock::kickAndDrift(Entry &entry) const {
    RigidBody &body = *entry.body;
    const real half = duration / 2;
    Vector3 torque;
    Twist twist;
    entry.velocity = body.velocity;
    entry.acceleration = Vector3();
    entry.leads = false;
    if (body.hasFiniteMass()) {
        const real mend = body.isGenerated ? body.lastDuration / 2 : 0;
        const Vector3 forceChange = body.generated.force - body.lastGenerated.force;
        const Vector3 torqueChange = body.generated.torque - body.lastGenerated.torque;
        entry.acceleration = body.acceleration + body.generated.force * body.inverseMass;
        entry.velocity += forceChange * (mend * body.inverseMass);
        torque = body.generated.torque;
        twist.kick = torqueChange * mend;
        const bool isRowOfFreshStarts = body.isGenerated && body.hasStartedAfresh && mend == 0;
        if (body.hasAdded || isRowOfFreshStarts) takeLead(entry, twist, torque, isRowOfFreshStarts);
        entry.velocity = (entry.velocity + entry.acceleration * half) * body.linearFactor;
    }
    twist.kick += torque * half;
    twist.closingKick += torque * half;
    entry.nothingTwists = body.canSleep && torque == Vector3();
    entry.position = body.getPosition() + entry.velocity * duration;
    return twist;
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

/// Gives the body its new state, if that is finite; its old one otherwise.
CYCLONE_INLINE bool StepBlock::takeOver(const Entry &entry, const Quaternion &orientation,
                                        const Vector3 &rotation, const Vector3 &angularMomentum) {
    RigidBody &body = *entry.body;
    const real linearFactor = body.hasFiniteMass() ? body.linearFactor : 1;
    Vector3 velocity = entry.velocity * linearFactor + entry.acceleration * (duration / 2);
    if (entry.leads) velocity -= entry.lead;
    // Whatever is not finite in orientation or momentum shows in the rotation.
    const Vector3 sum = entry.position + velocity + rotation;
    if (!real_isfinite(sum.x + sum.y + sum.z)) {
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

    const bool hadNothingToRemember = body.lastDuration == 0;
    const bool isToRemember = body.isGenerated && !body.startsAfresh && body.hasFiniteMass();
    body.lastDuration = isToRemember ? duration : 0;
    if (isToRemember) body.lastGenerated = body.generated;
    body.hasAddedAfresh = body.hasAdded && !body.wasAdded;
    body.wasAdded = body.hasAdded;
    body.hasStartedAfresh = body.isGenerated && hadNothingToRemember;
    body.clearAccumulators();
    if (body.canSleep) body.fallAsleepIfIdle(entry.nothingTwists, duration);
    return true;
}

CYCLONE_INLINE void StepBlock::gather(const RigidBody &body, const Twist &twist, int lane) {
    const int *row = RENUMBERED[body.middleAxis];
    const Quaternion q = body.hasPrincipalAxes ? body.orientation * body.principalAxes : body.orientation;
    turning.orientation[0][lane] = q.r;
    storeRenumbered(turning.orientation + 1, row, lane, Vector3(q.i, q.j, q.k));
    storeRenumbered(turning.inverseInertia, row, lane, body.inverseInertia);

    const Vector3 momentum = (body.angularMomentum + twist.kick) * body.angularFactor;
    storeRenumbered(turning.momentum, row, lane, momentum);
    storeRenumbered(turning.finalMomentum, row, lane, momentum * body.angularFactor + twist.closingKick);
}

CYCLONE_INLINE void StepBlock::scatter(const Entry &entry, int lane) {
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
void StepBlock::turnLocked(const Entry &entry, const Twist &twist) {
    RigidBody &body = *entry.body;
    const bool movable = body.hasFiniteMass();
    const real factor = movable ? body.angularFactor : 1;
    const Vector3 inverseInertia = movable ? body.inverseInertia : Vector3();
    const Matrix3 axes = body.getPrincipalAxesInWorld();
    const auto gain = [&](const Vector3 &impulse) {
        return inverseInertia.componentProduct(axes.transformTranspose(impulse));
    };
    const Vector3 spin = (axes.transformTranspose(body.rotation) + gain(twist.kick)) * factor;
    const Vector3 rotation = spin * factor + gain(twist.closingKick);

    Quaternion orientation = body.orientation;
    orientation.rotateByVector(axes.transform(spin) * duration);
    orientation.normalise();
    Matrix3 newAxes;
    newAxes.setOrientation(orientation * body.principalAxes);
    if (!takeOver(entry, orientation, newAxes.transform(rotation), Vector3())) return;
    body.calculateDerivedData();
    body.angularMomentum = body.momentumOf(body.rotation);
}

void StepBlock::renewFactors(RigidBody &body) {
    body.linearFactor = factorOf(body.linearDamping, linear);
    body.angularFactor = factorOf(body.angularDamping, angular);
    body.factorDuration = duration;
}

real StepBlock::factorOf(real damping, Factor &last) const {
    if (damping != last.damping) last = {damping, real_pow(damping, duration / 2)};
    return last.factor;
}

void StepBlock::add(RigidBody &body) {
    if (body.factorDuration != duration) renewFactors(body);
    Entry &entry = entries[count];
    entry.body = &body;
    const Twist twist = kickAndDrift(entry);
    if (!body.turnsFreely()) return turnLocked(entry, twist);
    gather(body, twist, count);
    if (++count == SIZE) finish();
}

std::size_t StepBlock::finish() {
    if (count > 0) turning.advance(count, duration);
    for (int lane = 0; lane < count; ++lane) scatter(entries[lane], lane);
    count = 0;
    return faults;
}

bool RigidBody::integrate(real duration) {
    RigidBody *const self = this;
    return integrate(&self, 1, duration) == 0;
}

std::size_t RigidBody::integrate(RigidBody *const *bodies, std::size_t count, real duration) {
    require(duration >= 0 && duration <= REAL_MAX, "RigidBody::integrate",
            "the duration must be finite and not negative", {duration});
    if (duration == 0) {
        for (std::size_t n = 0; n < count; ++n) bodies[n]->clearAccumulators();
        return 0;
    }
    StepBlock block(duration);
    for (std::size_t n = 0; n < count; ++n) {
        if (n + FETCH_AHEAD < count) fetch(bodies[n + FETCH_AHEAD], offsetof(RigidBody, added));
        if (bodies[n]->awake) block.add(*bodies[n]);
    }
    return block.finish();
}

}  // namespace cyclone
