#pragma once

/// @file
/// The step: how bodies are advanced. Games call RigidBody::integrate or World::runPhysics, which use it.
#include <cyclone/body.h>
#include <cyclone/freerotation.h>

#include <cstddef>

namespace cyclone {

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
///
/// What the caller adds has no such term, since it must count F·h at once and for good. While it acts on from
/// step to step, the body drifts ahead of its velocity v by (F − F₀)/m·h/2, where F₀ is the force with which
/// it began: so moves a leapfrog, stable and of second order too. A force that jumps begins anew.
///
/// Without A_last or F₀, v and x would both take the force from the start of the step, and a spring would
/// grow. That is nothing in one step, after a setter say; in a row of them the body drifts ahead by all of
/// A·h/2, as in symplectic Euler.
class CYCLONE_API StepBlock {
public:
    explicit StepBlock(real h) : duration(h) {}

    /// Takes an awake body in; advances all that are in when the block is full.
    void add(RigidBody &body);
    /// Advances those that are in. Returns how many bodies could not be advanced, of all that were ever in.
    std::size_t finish();

private:
    static constexpr int SIZE = FreeRotation::LANES;

    /// A body after its kick and drift.
    struct Entry {
        RigidBody *body;
        Vector3 position, velocity;
        Vector3 acceleration;
        Vector3 lead;  ///< how much faster than its velocity it drifts, if it leads
        bool leads;
        bool nothingTwists;  ///< no torque; asked only of bodies that may fall asleep
    };
    /// What turns it.
    struct Twist {
        Vector3 kick, closingKick;  ///< added to the angular momentum before and after the free rotation
    };

    /// The damping of half a step, which most bodies share.
    struct Factor {
        real damping = 1, factor = 1;
    };

    void renewFactors(RigidBody &body);
    real factorOf(real damping, Factor &last) const;
    Twist kickAndDrift(Entry &entry) const;
    void takeLead(Entry &entry, Twist &twist, Vector3 &torque, bool isRowOfFreshStarts) const;
    void turnLocked(const Entry &entry, const Twist &twist);
    void gather(const RigidBody &body, const Twist &twist, int lane);
    void scatter(const Entry &entry, int lane);
    bool takeOver(const Entry &entry, const Quaternion &orientation, const Vector3 &rotation,
                  const Vector3 &angularMomentum);

    const real duration;
    FreeRotation turning;
    Entry entries[SIZE];
    Factor linear, angular;  ///< of the body before
    int count = 0;
    std::size_t faults = 0;
};

}  // namespace cyclone
