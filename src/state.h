#pragma once

/// @file
/// What the state of a body consists of.
#include <cyclone/body.h>

#include <limits>
#include <type_traits>

#include "compiler.h"

namespace cyclone {
namespace detail {

/// Visits a member of a state number by number.
template <class Visit>
struct EachNumber {
    Visit &visit;

    template <class Member>
    CYCLONE_INLINE void operator()(Member &m) {
        using Type = std::remove_const_t<Member>;
        if constexpr (std::is_same_v<Type, Vector3>) {
            visit(m.x), visit(m.y), visit(m.z);
        } else if constexpr (std::is_same_v<Type, Quaternion>) {
            visit(m.r), visit(m.i), visit(m.j), visit(m.k);
        } else if constexpr (std::is_same_v<Type, Wrench>) {
            (*this)(m.force), (*this)(m.torque);
        } else if constexpr (std::is_same_v<Type, RigidBody::Memory>) {
            (*this)(m.acceleration), (*this)(m.torque);
            visit(m.linearKick), visit(m.angularKick);
        } else {
            visit(m);
        }
    }
    template <class Member, class Same>
    CYCLONE_INLINE void operator()(Member &m, Same) {
        (*this)(m);
    }
};

/// The one list of a state's members. RigidBody and RigidBody::State name them alike, save for the position,
/// which a body keeps in its transform.
struct StateMembers {
    using State = RigidBody::State;

    /// Calls visit(body.member, &State::member) for each.
    template <class Body, class Visit>
    static void visit(Body &body, Visit &&visit) {
        visitIndependent(body, visit);
        visit(body.mass, &State::mass);
        visit(body.inverseMass, &State::inverseMass);
        visit(body.inertia, &State::inertia);
        visit(body.inverseInertia, &State::inverseInertia);
    }
    /// Calls visit(number) for each number and visit(flag) for each flag and for the locked directions.
    template <class Visit>
    static void visitNumbers(State &state, Visit &&visit) {
        EachNumber<Visit> each{visit};
        each(state.position);
        StateMembers::visit(state, each);
    }

    /// All but position, mass and inertia; in an order that snapshots rely on.
    template <class Body, class Visit>
    CYCLONE_INLINE static void visitIndependent(Body &body, Visit &&visit) {
        visit(body.orientation, &State::orientation);
        visit(body.velocity, &State::velocity);
        visit(body.rotation, &State::rotation);
        visit(body.angularMomentum, &State::angularMomentum);
        visit(body.acceleration, &State::acceleration);
        visit(body.lastFrameAcceleration, &State::lastFrameAcceleration);
        visit(body.added, &State::added);
        visit(body.generated, &State::generated);
        visit(body.memory, &State::memory);
        visit(body.principalAxes, &State::principalAxes);
        visit(body.linearDamping, &State::linearDamping);
        visit(body.angularDamping, &State::angularDamping);
        visit(body.motion, &State::motion);
        visit(body.sleepEpsilon, &State::sleepEpsilon);
        visit(body.awake, &State::awake);
        visit(body.canSleep, &State::canSleep);
        visit(body.faulted, &State::faulted);
        visit(body.lockedMotion, &State::lockedMotion);
    }
    /// Mass and moments of inertia: calls visit(value, inverse, value whose inverse is 0).
    template <class Body, class Visit>
    CYCLONE_INLINE static void visitReciprocals(Body &body, Visit &&visit) {
        visit(body.mass, body.inverseMass, REAL_MAX);
        visit(body.inertia.x, body.inverseInertia.x, REAL_INFINITY);
        visit(body.inertia.y, body.inverseInertia.y, REAL_INFINITY);
        visit(body.inertia.z, body.inverseInertia.z, REAL_INFINITY);
    }

    /// Of all numbers only forces can be NaN, poisoned ones that were added since the last step.
    static bool mayHoldNaNs(const RigidBody &body) { return body.hasAdded || body.hasGenerated; }
    /// Which NaN comes out of an operation depends on the processor: makes all of them the same.
    static void unifyNaNs(RigidBody &body);

    static void setPosition(RigidBody &body, const Vector3 &p) { body.transform.setAxisVector(3, p); }
    static void setPosition(State &state, const Vector3 &p) { state.position = p; }

    /// Updates what a body derives from its state.
    static void updateDerived(RigidBody &body);

private:
    static constexpr real REAL_INFINITY = std::numeric_limits<real>::infinity();
};

}  // namespace detail
}  // namespace cyclone
