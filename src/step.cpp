#include "step.h"

#include <new>

#include "arguments.h"
#include "compiler.h"

namespace cyclone {
namespace detail {

// ---- Damping

namespace {

/// (1 − e^−x)/x
real meanOfDecay(real x, real decayed) {
    return x < 1e-3 ? 1 - x / 2 * (1 - x / 3 * (1 - x / 4)) : (1 - decayed) / x;
}

}  // namespace

const StepBlock::HalfStep &StepBlock::halfStepWith(real damping, HalfStep &latest) const {
    if (damping != latest.damping) {
        const real half = duration / 2;
        const real factor = real_pow(damping, half);
        const real kick = damping > 0 && damping < 1 ? half * meanOfDecay(-real_log(damping) * half, factor)
                                                     : half * factor;
        latest = {damping, factor, kick};
    }
    return latest;
}

void StepBlock::updateDamping(RigidBody &body) {
    const HalfStep &l = halfStepWith(body.linearDamping, linear),
                   &a = halfStepWith(body.angularDamping, angular);
    body.linearFactor = l.factor;
    body.angularFactor = a.factor;
    body.memory.linearKick = l.kick;
    body.memory.angularKick = a.kick;
    body.dampedDuration = duration;
}

// ---- Before the rotation

CYCLONE_INLINE StepBlock::AngularImpulse StepBlock::kickAndDrift(RigidBody &body, Entry &entry) {
    Vector3 velocity = body.velocity, acceleration, addedAcceleration, torque;
    AngularImpulse impulse;
    if (body.hasFiniteMass()) {
        const real lastLinearKick = body.memory.linearKick, lastAngularKick = body.memory.angularKick;
        if (body.dampedDuration != duration) updateDamping(body);
        torque = body.generated.torque;
        acceleration = body.acceleration + body.generated.force * body.inverseMass;
        velocity += (acceleration - body.memory.acceleration) * lastLinearKick;
        impulse.kick = (torque - body.memory.torque) * lastAngularKick;
        if (body.hasAdded) {
            torque += body.added.torque;
            addedAcceleration = body.added.force * body.inverseMass;
            velocity += addedAcceleration * duration;
            impulse.kick += body.added.torque * duration;
        }
        velocity = velocity * body.linearFactor + acceleration * body.memory.linearKick;
        impulse.halfKick = body.generated.torque * body.memory.angularKick;
    }
    new (&entry) Entry{&body,
                       body.getPosition() + velocity * duration,
                       velocity,
                       acceleration,
                       addedAcceleration,
                       torque == Vector3()};
    return impulse;
}

namespace {

/// Where each body axis, and each element of a matrix, goes when the axes are renumbered cyclically so that
/// the intermediate one becomes axis 0.
struct Renumbering {
    std::size_t axis[3], element[9];
};
constexpr Renumbering FROM_X = {{0, 1, 2}, {0, 1, 2, 3, 4, 5, 6, 7, 8}},
                      FROM_Y = {{2, 0, 1}, {8, 6, 7, 2, 0, 1, 5, 3, 4}},
                      FROM_Z = {{1, 2, 0}, {4, 5, 3, 7, 8, 6, 1, 2, 0}};
/// By a body's principalFrame: that the axes are turned makes no difference.
constexpr Renumbering RENUMBERINGS[7] = {FROM_X, FROM_Y, FROM_Z, {}, FROM_X, FROM_Y, FROM_Z};

void storeRenumbered(real (*rows)[FreeRotation::LANES], const std::size_t *row, int lane, const Vector3 &v) {
    rows[row[0]][lane] = v.x;
    rows[row[1]][lane] = v.y;
    rows[row[2]][lane] = v.z;
}

Vector3 loadRenumbered(const real (*rows)[FreeRotation::LANES], const std::size_t *row, int lane) {
    return Vector3(rows[row[0]][lane], rows[row[1]][lane], rows[row[2]][lane]);
}

}  // namespace

namespace {

constexpr real MAX_SQUARE = RigidBody::MAX_SPEED * RigidBody::MAX_SPEED;

/// Whether all numbers are finite and the speeds sane; whatever is not finite in orientation or angular
/// momentum shows in the rotation.
CYCLONE_INLINE bool isSound(const Vector3 &position, const Vector3 &velocity, const Vector3 &rotation) {
    const Vector3 zero = position * 0;  // not of what is not finite
    return velocity.squareMagnitude() <= MAX_SQUARE && rotation.squareMagnitude() <= MAX_SQUARE &&
           zero.x + zero.y + zero.z == 0;
}

}  // namespace

void StepBlock::fault(RigidBody &body) {
    body.markFaulted();
    ++faults;
}

/// Gives the body its new state, if that is sound; its old one otherwise.
CYCLONE_INLINE bool StepBlock::commit(const Entry &entry, const Quaternion &orientation,
                                      const Vector3 &rotation, const Vector3 &angularMomentum) {
    RigidBody &body = *entry.body;
    Vector3 velocity = entry.velocity;
    if (body.hasFiniteMass())
        velocity = velocity * body.linearFactor + entry.acceleration * body.memory.linearKick;
    if (!isSound(entry.position, velocity, rotation)) {
        fault(body);
        return false;
    }
    body.transform.setAxisVector(3, entry.position);
    body.orientation = orientation;
    body.velocity = velocity;
    body.rotation = rotation;
    body.angularMomentum = angularMomentum;
    body.lastFrameAcceleration = entry.acceleration + entry.addedAcceleration;
    if (body.hasFiniteMass()) {
        body.memory.acceleration = entry.acceleration;
        body.memory.torque = body.generated.torque;
    }
    body.clearAccumulators();
    if (body.canSleep) body.fallAsleepIfIdle(entry.isTorqueFree, duration);
    return true;
}

// ---- Around the rotation

CYCLONE_INLINE void StepBlock::gather(const RigidBody &body, const AngularImpulse &impulse, int lane) {
    const std::size_t *const row = RENUMBERINGS[body.principalFrame].axis;
    const Quaternion q = body.hasTurnedAxes() ? body.orientation * body.principalAxes : body.orientation;
    freeRotation.orientation[0][lane] = q.r;
    storeRenumbered(freeRotation.orientation + 1, row, lane, Vector3(q.i, q.j, q.k));
    storeRenumbered(freeRotation.inverseInertia, row, lane, body.inverseInertia);

    const Vector3 momentum = (body.angularMomentum + impulse.kick) * body.angularFactor + impulse.halfKick;
    storeRenumbered(freeRotation.momentum, row, lane, momentum);
    storeRenumbered(freeRotation.finalMomentum, row, lane, momentum * body.angularFactor + impulse.halfKick);
}

CYCLONE_INLINE void StepBlock::scatter(const Entry &entry, int lane) {
    RigidBody &body = *entry.body;
    const Renumbering &renumbering = RENUMBERINGS[body.principalFrame];
    const std::size_t *const row = renumbering.axis;
    const Vector3 v = loadRenumbered(freeRotation.orientation + 1, row, lane);
    Quaternion orientation(freeRotation.orientation[0][lane], v.x, v.y, v.z);
    if (body.hasTurnedAxes()) orientation *= body.principalAxes.conjugate();

    if (!commit(entry, orientation, loadRenumbered(freeRotation.rotation, row, lane),
                loadRenumbered(freeRotation.finalMomentum, row, lane)))
        return;
    if (body.hasTurnedAxes()) return body.calculateDerivedData();
    for (int line = 0; line < 3; ++line)
        for (int column = 0; column < 3; ++column)
            body.transform.data[4 * line + column] =
                freeRotation.matrix[renumbering.element[3 * line + column]][lane];
}

/// A body that is immovable or has a locked axis: each component of its rotation in its own axes goes on
/// alone, without gyroscopic coupling, and torques act about free axes only.
void StepBlock::rotateLocked(const Entry &entry, const AngularImpulse &impulse) {
    RigidBody &body = *entry.body;
    const bool movable = body.hasFiniteMass();
    const real factor = movable ? body.angularFactor : 1;
    const Vector3 inverseInertia = movable ? body.inverseInertia : Vector3();
    const Matrix3 axes = body.getPrincipalAxesInWorld();
    const auto gain = [&](const Vector3 &change) {
        return inverseInertia.componentProduct(axes.transformTranspose(change));
    };
    const Vector3 spin =
        (axes.transformTranspose(body.rotation) + gain(impulse.kick)) * factor + gain(impulse.halfKick);
    const Vector3 rotation = spin * factor + gain(impulse.halfKick);

    Quaternion orientation = body.orientation;
    orientation.rotateByVector(axes.transform(spin) * duration);
    orientation.normalise();
    Matrix3 newAxes;
    newAxes.setOrientation(orientation * body.principalAxes);
    const Vector3 worldRotation = newAxes.transform(rotation);
    const Vector3 momentum = movable ? body.angularMomentumFor(worldRotation, orientation) : Vector3();
    if (!momentum.isFinite()) return fault(body);
    if (commit(entry, orientation, worldRotation, momentum)) body.calculateDerivedData();
}

// ---- The step

void StepBlock::add(RigidBody &body) {
    Entry &entry = entries[count];
    const AngularImpulse impulse = kickAndDrift(body, entry);
    if (!body.isFreeRotor()) return rotateLocked(entry, impulse);
    gather(body, impulse, count);
    if (++count == SIZE) finish();
}

std::size_t StepBlock::finish() {
    if (count > 0) freeRotation.advance(count, duration);
    for (int lane = 0; lane < count; ++lane) scatter(entries[lane], lane);
    count = 0;
    return faults;
}

}  // namespace detail

bool RigidBody::integrate(real duration) {
    RigidBody *const self = this;
    return integrate(&self, 1, duration) == 0;
}

std::size_t RigidBody::integrate(RigidBody *const *bodies, std::size_t count, real duration) {
    detail::requireDuration(duration, "RigidBody::integrate");
    if (duration == 0) {
        for (std::size_t n = 0; n < count; ++n) bodies[n]->clearAccumulators();
        return 0;
    }
    detail::StepBlock block(duration);
    for (std::size_t n = 0; n < count; ++n) {
        if (n + detail::PREFETCH_AHEAD < count)
            detail::prefetch(bodies[n + detail::PREFETCH_AHEAD], offsetof(RigidBody, added));
        RigidBody &body = *bodies[n];
        if (!body.awake) continue;
        if (body.lockedMotion != 0) body.dropLockedForces();
        block.add(body);
    }
    return block.finish();
}

}  // namespace cyclone
