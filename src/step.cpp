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
    const real lastLinearKick = body.memory.linearKick, lastAngularKick = body.memory.angularKick;
    if (body.dampedDuration != duration) updateDamping(body);

    const Vector3 acceleration = body.acceleration + body.generated.force * body.inverseMass;
    Vector3 velocity = body.velocity + (acceleration - body.memory.acceleration) * lastLinearKick;
    Vector3 kick = (body.generated.torque - body.memory.torque) * lastAngularKick;
    if (body.hasAdded) {
        velocity += body.added.force * body.inverseMass * duration;
        kick += body.added.torque * duration;
    }
    velocity = velocity * body.linearFactor + acceleration * body.memory.linearKick;
    new (&entry) Entry{&body, body.getPosition() + velocity * duration, velocity, acceleration};
    return {kick, body.generated.torque * body.memory.angularKick};
}

namespace {

/// Where each axis goes when they are renumbered cyclically so that the intermediate one becomes axis 0.
using Renumbering = std::size_t[3];
constexpr Renumbering RENUMBERINGS[3] = {{0, 1, 2}, {2, 0, 1}, {1, 2, 0}};

void storeRenumbered(FreeRotation::Lanes *axes, const Renumbering &to, int lane, const Vector3 &v) {
    axes[to[0]][lane] = v.x;
    axes[to[1]][lane] = v.y;
    axes[to[2]][lane] = v.z;
}

Vector3 loadRenumbered(const FreeRotation::Lanes *axes, const Renumbering &from, int lane) {
    return Vector3(axes[from[0]][lane], axes[from[1]][lane], axes[from[2]][lane]);
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
    body.lastFrameAcceleration = entry.acceleration;
    if (body.hasFiniteMass()) {
        if (body.hasAdded) body.lastFrameAcceleration += body.added.force * body.inverseMass;
        body.memory.acceleration = entry.acceleration;
        body.memory.torque = body.generated.torque;
    }
    if (body.canSleep) body.fallAsleepIfIdle(duration);
    body.clearAccumulators();
    return true;
}

// ---- Around the rotation

CYCLONE_INLINE void StepBlock::gather(const RigidBody &body, const AngularImpulse &impulse, int lane) {
    const Renumbering &axis = RENUMBERINGS[body.principalFrame.intermediateAxis];
    const Quaternion &q = body.orientation, &p = body.principalAxes;
    freeRotation.orientation[0][lane] = q.r;
    storeRenumbered(freeRotation.orientation + 1, axis, lane, Vector3(q.i, q.j, q.k));
    freeRotation.isTurned[lane] = body.principalFrame.isTurned;
    if (body.principalFrame.isTurned) {
        freeRotation.areAnyTurned = true;
        freeRotation.principalAxes[0][lane] = p.r;
        storeRenumbered(freeRotation.principalAxes + 1, axis, lane, Vector3(p.i, p.j, p.k));
    }
    storeRenumbered(freeRotation.inverseInertia, axis, lane, body.inverseInertia);

    const Vector3 momentum = (body.angularMomentum + impulse.kick) * body.angularFactor + impulse.halfKick;
    storeRenumbered(freeRotation.momentum, axis, lane, momentum);
    storeRenumbered(freeRotation.finalMomentum, axis, lane, momentum * body.angularFactor + impulse.halfKick);
}

CYCLONE_INLINE void StepBlock::scatter(const Entry &entry, int lane) {
    RigidBody &body = *entry.body;
    const Renumbering &axis = RENUMBERINGS[body.principalFrame.intermediateAxis];
    const Vector3 v = loadRenumbered(freeRotation.orientation + 1, axis, lane);
    const Quaternion orientation(freeRotation.orientation[0][lane], v.x, v.y, v.z);
    if (!commit(entry, orientation, loadRenumbered(freeRotation.rotation, axis, lane),
                loadRenumbered(freeRotation.finalMomentum, axis, lane)))
        return;
    for (std::size_t row = 0; row < 3; ++row) {
        const Vector3 r = loadRenumbered(freeRotation.matrix[axis[row]], axis, lane);
        real *const target = body.transform.data + 4 * row;
        target[0] = r.x, target[1] = r.y, target[2] = r.z;
    }
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

CYCLONE_INLINE void StepBlock::add(RigidBody &body) {
    Entry &entry = entries[count];
    if (!body.hasFiniteMass()) {
        new (&entry) Entry{&body, body.getPosition() + body.velocity * duration, body.velocity, Vector3()};
        return rotateLocked(entry, AngularImpulse());
    }
    const AngularImpulse impulse = kickAndDrift(body, entry);
    if (body.principalFrame.hasLockedAxis) return rotateLocked(entry, impulse);
    gather(body, impulse, count);
    if (++count == SIZE) finish();
}

std::size_t StepBlock::finish() {
    if (count > 0) freeRotation.advance(count, duration);
    for (int lane = 0; lane < count; ++lane) scatter(entries[lane], lane);
    count = 0;
    freeRotation.areAnyTurned = false;
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
