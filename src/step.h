#pragma once

/// @file
/// One step of rigid bodies. Games call RigidBody::integrate or World::runPhysics, which use it.
#include <cyclone/body.h>

#include <cstddef>

#include "freerotation.h"

namespace cyclone {
namespace detail {

/// Up to sixteen bodies on their way through one step of length h. Each is kicked and drifts along, all turn
/// side by side, then each takes its new state:
///
///     kick     v += (A − A_last)·e_last     the last step's closing kick, now that its force is known
///              v += F/m·h                   what the caller has added
///              v  = v·k + A·e               half the damping, and the opening half kick
///     drift    x += v·h
///     kick     v  = v·k + A·e               provisional: A belongs to the start of the step
///
/// A is the acceleration by generators and the constant one; k = d^(h/2) is the damping of half a step, and
/// e = h/2, or with damping (k − 1)/ln d, the exact integral. For the positions this is the scheme of Störmer
/// and Verlet. Angular momentum goes the same way, with torque in place of A, around the free rotation.
class StepBlock {
public:
    explicit StepBlock(real h) : duration(h), linear{1, 1, h / 2}, angular{1, 1, h / 2} {}

    /// Takes an awake body in; advances all that are in when the block is full.
    void add(RigidBody &body);
    /// Advances those that are in. Returns how many bodies faulted, of all that were ever in.
    std::size_t finish();

private:
    static constexpr int SIZE = FreeRotation::LANES;

    /// A body after its kick and drift.
    struct Entry {
        RigidBody *body;
        Vector3 position, velocity;
        Vector3 acceleration;  ///< A
    };
    /// What changes the angular momentum: at once, and after each half of the damping.
    struct AngularImpulse {
        Vector3 kick, halfKick;
    };
    /// d, k and e.
    struct HalfStep {
        real damping, factor, kick;
    };

    void updateDamping(RigidBody &body);
    const HalfStep &halfStepWith(real damping, HalfStep &latest) const;
    AngularImpulse kickAndDrift(RigidBody &body, Entry &entry);
    void rotateLocked(const Entry &entry, const AngularImpulse &impulse);
    void gather(const RigidBody &body, const AngularImpulse &impulse, int lane);
    void scatter(const Entry &entry, int lane);
    bool commit(const Entry &entry, const Quaternion &orientation, const Vector3 &rotation,
                const Vector3 &angularMomentum);
    void fault(RigidBody &body);

    const real duration;
    FreeRotation freeRotation;
    union {
        Entry entries[SIZE];  ///< for speed nothing is set at first
    };
    HalfStep linear, angular;  ///< of the body before: most bodies share their damping
    int count = 0;
    std::size_t faults = 0;
};

}  // namespace detail
}  // namespace cyclone
