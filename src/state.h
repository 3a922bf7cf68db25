#pragma once

/// @file
/// What the state of a body consists of.
#include <cyclone/body.h>

#include <type_traits>

namespace cyclone {
namespace detail {

/// The one list of a state's members. RigidBody and RigidBody::State name them alike, save for the position,
/// which a body keeps in its transform.
struct StateMembers {
    /// Calls visit(body.member, &RigidBody::State::member) for each, in an order that snapshots rely on.
    template <class Body, class Visit>
    static void visit(Body &body, Visit &&visit) {
        using State = RigidBody::State;
        visit(body.orientation, &State::orientation);
        visit(body.velocity, &State::velocity);
        visit(body.rotation, &State::rotation);
        visit(body.angularMomentum, &State::angularMomentum);
        visit(body.acceleration, &State::acceleration);
        visit(body.lastFrameAcceleration, &State::lastFrameAcceleration);
        visit(body.added, &State::added);
        visit(body.generated, &State::generated);
        visit(body.memory, &State::memory);
        visit(body.mass, &State::mass);
        visit(body.inverseMass, &State::inverseMass);
        visit(body.inertia, &State::inertia);
        visit(body.inverseInertia, &State::inverseInertia);
        visit(body.principalAxes, &State::principalAxes);
        visit(body.linearDamping, &State::linearDamping);
        visit(body.angularDamping, &State::angularDamping);
        visit(body.motion, &State::motion);
        visit(body.sleepEpsilon, &State::sleepEpsilon);
        visit(body.awake, &State::awake);
        visit(body.canSleep, &State::canSleep);
        visit(body.faulted, &State::faulted);
    }

    /// Calls visit(number) for each number of a state and visit(flag) for each flag.
    template <class State, class Visit>
    static void visitNumbers(State &state, Visit &&visit) {
        const auto visitVector = [&visit](auto &v) { visit(v.x), visit(v.y), visit(v.z); };
        const auto visitMember = [&](auto &member) {
            using Member = std::decay_t<decltype(member)>;
            if constexpr (std::is_same_v<Member, Vector3>) {
                visitVector(member);
            } else if constexpr (std::is_same_v<Member, Quaternion>) {
                visit(member.r), visit(member.i), visit(member.j), visit(member.k);
            } else if constexpr (std::is_same_v<Member, Wrench>) {
                visitVector(member.force), visitVector(member.torque);
            } else if constexpr (std::is_same_v<Member, RigidBody::Memory>) {
                visitVector(member.acceleration), visitVector(member.torque);
                visit(member.linearKick), visit(member.angularKick);
            } else {
                visit(member);
            }
        };
        visitVector(state.position);
        StateMembers::visit(state, [&](auto &member, auto) { visitMember(member); });
    }
};

}  // namespace detail
}  // namespace cyclone
