#include "state.h"

#include <algorithm>

#include "arguments.h"
#include "principalaxes.h"

namespace cyclone {

using namespace detail;

using State = RigidBody::State;

// ---- Saving and restoring

State RigidBody::getState() const {
    State state;
    state.position = getPosition();
    StateMembers::visit(*this, [&state](const auto &member, auto same) { state.*same = member; });
    return state;
}

namespace {

bool isZero(const Wrench &wrench) { return wrench.force == Vector3() && wrench.torque == Vector3(); }

}  // namespace

void RigidBody::setState(const State &state) {
    const char *const error = state.findError();
    require(error == nullptr, "RigidBody::setState", error);
    transform.setAxisVector(3, state.position);
    StateMembers::visit(*this, [&state](auto &member, auto same) { member = state.*same; });
    StateMembers::updateDerived(*this);
}

void StateMembers::updateDerived(RigidBody &body) {
    body.calculateDerivedData();
    body.updatePrincipalFrame();
    body.hasAdded = !isZero(body.added);
    body.hasGenerated = !isZero(body.generated);
    body.dampedDuration = 0;
}

void StateMembers::unifyNaNs(RigidBody &body) {
    const auto unify = [](real &number) {
        if (number != number) number = std::numeric_limits<real>::quiet_NaN();
    };
    for (Wrench *const wrench : {&body.added, &body.generated})
        EachNumber<const decltype(unify)>{unify}(*wrench);
}

// ---- What is possible

namespace {

bool isNotNegative(real value) { return value >= 0 && value <= REAL_MAX; }

bool isDamping(real value) { return value >= 0 && value <= 1; }

bool isUnit(const Quaternion &q, real tolerance) { return real_abs(q.squareMagnitude() - 1) <= tolerance; }

/// One of the two was set, and the other computed from it. `infinite` is what has no inverse.
bool areReciprocal(real value, real inverse, real infinite) {
    if (inverse == 0) return value == infinite;
    return isNotNegative(inverse) && isNotNegative(value) && (inverse == 1 / value || value == 1 / inverse);
}

real largestComponent(const Vector3 &v) { return std::max({real_abs(v.x), real_abs(v.y), real_abs(v.z)}); }

/// A power of two that makes the vector small enough to be turned without overflow.
real scaleFor(const Vector3 &v) { return largestComponent(v) > 0x1p1000 ? 0x1p-30 : 1; }

/// Whether angular momentum and rotation belong together, about the axes that are free.
bool momentumFits(const State &s) {
    if (s.inverseMass == 0) return s.angularMomentum == Vector3();
    const Quaternion toPrincipal = (s.orientation * s.principalAxes).conjugate();
    const real scale = std::min(scaleFor(s.angularMomentum), scaleFor(s.rotation));
    const Vector3 scaledMomentum = s.angularMomentum * scale, scaledSpin = s.rotation * scale;
    const Vector3 momentum = toPrincipal.rotate(scaledMomentum), spin = toPrincipal.rotate(scaledSpin);
    // What turning loses of a vector is in proportion to its length; subnormal numbers lose more.
    const real tolerance =
        largestComponent(s.inverseInertia) * (1e-9 * largestComponent(scaledMomentum) + DBL_MIN) +
        1e-9 * largestComponent(scaledSpin) + DBL_MIN;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const real inverse = s.inverseInertia[axis];
        if (inverse > 0 && !(real_abs(momentum[axis] * inverse - spin[axis]) <= tolerance)) return false;
    }
    return true;
}

/// Whether nothing moves it along locked directions.
bool locksHold(const State &s) {
    for (unsigned axis = 0; axis < 3; ++axis)
        if ((s.lockedMotion >> axis & 1) != 0 &&
            (s.velocity[axis] != 0 || s.acceleration[axis] != 0 || s.memory.acceleration[axis] != 0))
            return false;
    return s.lockedMotion < 8;
}

bool isAtRest(const State &s) {
    return s.velocity == Vector3() && s.rotation == Vector3() && s.angularMomentum == Vector3() &&
           s.lastFrameAcceleration == Vector3() && isZero(s.added) && isZero(s.generated);
}

}  // namespace

const char *State::findError() const {
    if (!position.isFinite()) return "the position must be finite";
    if (!isUnit(orientation, 32 * REAL_EPSILON)) return "the orientation must be a unit quaternion";
    if (!velocity.isFinite()) return "the velocity must be finite";
    if (!rotation.isFinite()) return "the rotation must be finite";
    if (!angularMomentum.isFinite()) return "the angular momentum must be finite";
    if (!acceleration.isFinite()) return "the acceleration must be finite";
    if (lastFrameAcceleration != lastFrameAcceleration)  // a sum of two finite ones may be infinite
        return "the last frame's acceleration must be a number";
    if (!memory.acceleration.isFinite() || !memory.torque.isFinite())
        return "the remembered acceleration and torque must be finite";
    if (!isNotNegative(memory.linearKick) || !isNotNegative(memory.angularKick))
        return "the remembered kicks must be finite and not negative";
    if (!areReciprocal(mass, inverseMass, REAL_MAX)) return "the mass must match its inverse";
    for (unsigned axis = 0; axis < 3; ++axis)
        if (!areReciprocal(inertia[axis], inverseInertia[axis], 1 / real(0)))
            return "the moments of inertia must be positive and match their inverses";
    if (!areBearable(inertia)) return "the moments of inertia must not be extreme";
    if (!isUnit(principalAxes, 8 * REAL_EPSILON)) return "the principal axes must be a unit quaternion";
    if (!momentumFits(*this)) return "the angular momentum must match the rotation";
    if (!locksHold(*this)) return "nothing may move along locked directions";
    if (!isDamping(linearDamping) || !isDamping(angularDamping)) return "the damping must be between 0 and 1";
    if (!isNotNegative(motion)) return "the motion must be finite and not negative";
    if (!isNotNegative(sleepEpsilon)) return "the sleep limit must be finite and not negative";
    if (awake && faulted) return "a body that is awake has not faulted";
    if (!awake && !faulted && !isAtRest(*this)) return "a sleeping body must be at rest";
    return nullptr;
}

State State::linearInterpolate(const State &a, const State &b, real prop) {
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
