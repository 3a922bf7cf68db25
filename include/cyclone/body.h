#pragma once

/// @file
/// The rigid body: its state, how forces are added to it, and the step that advances it.
#include <cyclone/core.h>

#include <cstddef>
#include <cstdint>

namespace cyclone {

namespace detail {
class StepBlock;
struct StateMembers;
}  // namespace detail

struct Resistance;

/// A force that acts at the centre of mass (N) and a torque (N·m), in world coordinates.
struct Wrench {
    Vector3 force, torque;
};

/// A rigid body. A plain value that can be copied, the forces that have been added to it included; its origin
/// is its centre of mass.
///
/// By default it has 1 kg and unit inertia, and is at the origin, at rest, awake and undamped. Velocity and
/// rotation (angular velocity, rad/s) are in world coordinates, SI units throughout. Derived data, such as
/// the transform, is current after every setter and every step.
///
/// A body of inverse mass 0 is immovable: no force, torque, acceleration or damping changes its motion. It
/// still goes on with the velocity and rotation that it is given, so it can serve as a moving platform.
class CYCLONE_API RigidBody {
public:
    /// @name Mass and inertia
    /// @{

    /// kg; positive and finite. An immovable body has mass REAL_MAX.
    void setMass(real kilograms);
    real getMass() const { return mass; }
    /// 1/kg; finite and not negative. 0 makes the body immovable.
    void setInverseMass(real inverse);
    real getInverseMass() const { return inverseMass; }
    bool hasFiniteMass() const { return inverseMass > 0; }

    /// About the centre of mass, in body axes, kg·m²: symmetric, its principal moments positive, between
    /// 1e-100 and 1e100 and none more than 1e12 times another. The rotation is kept.
    void setInertiaTensor(const Matrix3 &inertiaTensor);
    /// Its inverse: symmetric, no principal value negative, and the moments within the same bounds. About
    /// an axis whose value is 0, a locked axis, torques do nothing.
    void setInverseInertiaTensor(const Matrix3 &inverseInertiaTensor);
    /// Refuses when an axis is locked, since the tensor is then infinite.
    Matrix3 getInertiaTensor() const;
    Matrix3 getInverseInertiaTensor() const;
    Matrix3 getInertiaTensorWorld() const;
    Matrix3 getInverseInertiaTensorWorld() const;
    /// @}

    /// @name Damping
    /// The fraction of the velocity, or rotation, that is left after one second: v *= damping^duration. 0 to
    /// 1; 1, the default, is none.
    /// @{
    void setDamping(real linear, real angular);
    void setLinearDamping(real damping);
    void setAngularDamping(real damping);
    real getLinearDamping() const { return linearDamping; }
    real getAngularDamping() const { return angularDamping; }
    /// @}

    /// @name Motion
    /// Whatever is set must be finite.
    /// @{

    /// Locks directions of motion, those of the world's axes: a body locked along z stays in its plane to the
    /// last bit. Velocity and acceleration along a locked direction become 0; from then on no force, impulse,
    /// acceleration or setter moves the body along it, save for setState. None is locked by default. To lock
    /// rotations as well, see setInverseInertiaTensor.
    void setLockedMotion(bool x, bool y, bool z);
    /// axis: 0, 1 or 2 for x, y or z.
    bool isMotionLocked(unsigned axis) const { return (lockedMotion >> axis & 1) != 0; }

    void setPosition(const Vector3 &worldPoint);
    void setPosition(real x, real y, real z) { setPosition(Vector3(x, y, z)); }
    Vector3 getPosition() const { return transform.getAxisVector(3); }

    /// Body to world. Any length but zero; it is made a unit quaternion. The rotation is kept.
    void setOrientation(const Quaternion &bodyToWorld);
    void setOrientation(real r, real i, real j, real k) { setOrientation(Quaternion(r, i, j, k)); }
    Quaternion getOrientation() const { return orientation; }

    /// m/s. Anything but zero wakes the body.
    void setVelocity(const Vector3 &metresPerSecond);
    void setVelocity(real x, real y, real z) { setVelocity(Vector3(x, y, z)); }
    Vector3 getVelocity() const { return velocity; }
    /// rad/s. Anything but zero wakes the body.
    void setRotation(const Vector3 &radiansPerSecond);
    void setRotation(real x, real y, real z) { setRotation(Vector3(x, y, z)); }
    Vector3 getRotation() const { return rotation; }
    /// At once, whatever the step.
    void addVelocity(const Vector3 &change);
    void addRotation(const Vector3 &change);
    /// At once, whatever the step: impulses (N·s) in world coordinates, at the centre of mass or at a point.
    /// They do nothing to immovable bodies, nor about locked axes.
    void addImpulse(const Vector3 &impulse);
    void addImpulseAtPoint(const Vector3 &impulse, const Vector3 &worldPoint);
    /// How fast the body moves at a point that it carries with it (m/s): velocity + rotation × (worldPoint −
    /// position).
    Vector3 getVelocityAtPoint(const Vector3 &worldPoint) const {
        return velocity + rotation % (worldPoint - getPosition());
    }
    /// About the centre of mass, world coordinates, kg·m²/s; of an immovable body zero.
    Vector3 getAngularMomentum() const { return angularMomentum; }

    /// A constant acceleration (m/s²) that acts whatever the mass, such as gravity. None by default; a new
    /// one wakes the body.
    void setAcceleration(const Vector3 &metresPerSecondSquared);
    void setAcceleration(real x, real y, real z) { setAcceleration(Vector3(x, y, z)); }
    Vector3 getAcceleration() const { return acceleration; }
    /// The acceleration of the body during its last step, by forces and the constant acceleration.
    Vector3 getLastFrameAcceleration() const { return lastFrameAcceleration; }
    /// @}

    /// @name Between body and world
    /// @{
    const Matrix4 &getTransform() const { return transform; }
    /// For drawing: sixteen floats, column by column.
    void getGLTransform(float matrix[16]) const { transform.fillGLArray(matrix); }
    Vector3 getPointInLocalSpace(const Vector3 &point) const { return transform.transformInverse(point); }
    Vector3 getPointInWorldSpace(const Vector3 &point) const { return transform.transform(point); }
    Vector3 getDirectionInLocalSpace(const Vector3 &direction) const {
        return transform.transformInverseDirection(direction);
    }
    Vector3 getDirectionInWorldSpace(const Vector3 &direction) const {
        return transform.transformDirection(direction);
    }
    /// Updates what follows from position and orientation. Setters and steps have done so already.
    void calculateDerivedData();
    /// @}

    /// @name Forces
    /// What is added acts for the next step only, and in full at its beginning: the velocity changes by
    /// force·duration/mass. Forces are not checked, see integrate(). Any but zero wakes the body.
    /// @{

    /// At the centre of mass, world coordinates, N.
    void addForce(const Vector3 &force) { addWrench(force, Vector3()); }
    void addForceAtPoint(const Vector3 &force, const Vector3 &worldPoint) {
        addWrench(force, (worldPoint - getPosition()) % force);
    }
    /// The force in world coordinates, the point in body coordinates.
    void addForceAtBodyPoint(const Vector3 &force, const Vector3 &bodyPoint) {
        addWrench(force, transform.transformDirection(bodyPoint) % force);
    }
    /// World coordinates, N·m.
    void addTorque(const Vector3 &torque) { addWrench(Vector3(), torque); }
    /// Both at once.
    void addWrench(const Wrench &wrench) { addWrench(wrench.force, wrench.torque); }
    /// For a generator, beside the force that it adds: the most by which its force answers to velocity
    /// (N·s/m) and its torque to rotation (N·m·s). Where all of it together is too strong for an explicit
    /// step, the registry makes the step implicit, see ForceGenerator::addResistance.
    void addResistance(real linear, real angular) {
        resistance += linear * inverseMass;
        if (angular != 0) resistance += angular * largestInverseMoment();
        hasGenerated = true;
    }
    /// Takes back what has been added since the last step.
    void clearAccumulators() {
        if (hasAdded || hasGenerated) clearForces();
    }
    /// @}

    /// @name Sleep
    /// A sleeping body is not advanced. It wakes when a force, a torque or a motion is given to it,
    /// generators' forces included: to sleep under gravity, a body has it by setAcceleration. Forces do not
    /// wake a faulted body.
    /// @{

    /// Sends the body to sleep, at rest, or wakes it.
    void setAwake(bool wake = true);
    bool getAwake() const { return awake; }
    /// Whether the body may fall asleep by itself; off by default. It does so when it has hardly moved for
    /// about a second and nothing acts on it: no force, torque or acceleration.
    void setCanSleep(bool may = true);
    bool getCanSleep() const { return canSleep; }
    /// Hardly moved: the recency-weighted mean of |velocity|² + |rotation|² (SI) is below this; 0.01 by
    /// default.
    void setSleepEpsilon(real epsilon);
    real getSleepEpsilon() const { return sleepEpsilon; }
    /// @}

    /// Advances the body by `duration` seconds, finite and not negative, and clears the accumulators. 0 does
    /// only that.
    ///
    /// Free rotation is of fourth order, translation and torque are the leapfrog scheme of Störmer and
    /// Verlet: of second order in the forces of generators (called through a ForceRegistry), with one
    /// evaluation a step, and exact for constant ones. The velocity at the end of a step contains half a kick
    /// by the force at its start; the next step, which knows the force at its own start, corrects that half
    /// kick. To this end a body remembers the acceleration and torque of its last step. Setters shift the
    /// motion and leave that memory alone; only sleep, waking, a fault and setState() replace it. So a
    /// generator's force that begins or ends is felt half a step early. What the caller adds is not
    /// remembered: it is a plain kick.
    ///
    /// Returns false if the step would not be finite, or would move the body faster than MAX_SPEED: the body
    /// then keeps its last good state, drops the forces, and sleeps.
    bool integrate(real duration);

    /// Advances many bodies, none null and none twice, to the same bits as one after the other but in about
    /// half the time. Returns the number of them whose integrate() returned false.
    static std::size_t integrate(RigidBody *const *bodies, std::size_t count, real duration);

    /// m/s and rad/s. A step that would end faster is a fault: something has blown up.
    static constexpr real MAX_SPEED = 1e12;

    /// Whether the last step failed and the body has not been woken since.
    bool hasFaulted() const { return faulted; }

    /// @name Saving and restoring
    /// @{

    /// What the step remembers of the one before.
    struct Memory {
        Vector3 acceleration;  ///< by generators and the constant acceleration, m/s²
        Vector3 torque;        ///< by generators, N·m
        /// How long acceleration and torque acted in that step's second half, less what damping took (s).
        /// 0: there is nothing to remember.
        real linearKick = 0, angularKick = 0;
    };

    /// Everything that the next step depends on, and nothing else. Same state and same forces: the same bits.
    struct CYCLONE_API State {
        Vector3 position;
        Quaternion orientation;
        Vector3 velocity, rotation, angularMomentum;
        Vector3 acceleration, lastFrameAcceleration;
        Wrench added;      ///< by the caller since the last step
        Wrench generated;  ///< by generators since the last step
        Memory memory;
        real mass = 1, inverseMass = 1;
        Vector3 inertia = Vector3(1, 1, 1), inverseInertia = Vector3(1, 1, 1);  ///< principal
        Quaternion principalAxes;                                               ///< to body axes
        real linearDamping = 1, angularDamping = 1;
        real motion = 0, sleepEpsilon = 0.01;
        bool awake = true, canSleep = false, faulted = false;
        std::uint8_t lockedMotion = 0;  ///< 1, 2 and 4 for the directions x, y and z

        /// Why no body can be in this state; null if one can.
        const char *findError() const;

        /// For drawing between two steps: position, velocity and rotation linearly, the orientation the short
        /// way round, between a (prop 0) and b (prop 1); everything else as in b.
        static State linearInterpolate(const State &a, const State &b, real prop);
    };

    State getState() const;
    /// Takes a state over, bit by bit. Refuses one that no body can be in.
    void setState(const State &state);
    /// @}

private:
    friend class ForceRegistry;
    friend class World;
    friend class detail::StepBlock;
    friend struct detail::StateMembers;

    /// What is known of the principal axes.
    struct PrincipalFrame {
        std::uint8_t intermediateAxis : 2;  ///< that of the middle moment; of equal ones, 1
        bool isTurned : 1;                  ///< the principal axes are not the body's
        bool hasLockedAxis : 1;             ///< a moment is infinite

        constexpr PrincipalFrame() : intermediateAxis(1), isTurned(false), hasLockedAxis(false) {}
    };

    /// What is true of this object only, and not of a copy of it.
    struct Marks {
        bool inGenerator = false;  ///< a ForceRegistry is calling one of this body's generators

        Marks() = default;
        Marks(const Marks &) {}
        Marks &operator=(const Marks &) { return *this; }
    };

    void addWrench(const Vector3 &force, const Vector3 &torque) {
        Wrench &sum = marks.inGenerator ? generated : added;
        sum.force += force;
        sum.torque += torque;
        (marks.inGenerator ? hasGenerated : hasAdded) = true;
        if (!awake) wakeForForce(force, torque);
    }
    /// What is wanted along free directions, and along locked ones what is kept.
    Vector3 possible(const Vector3 &wanted, const Vector3 &kept = Vector3()) const {
        return lockedMotion == 0
                   ? wanted
                   : Vector3(isMotionLocked(0) ? kept.x : wanted.x, isMotionLocked(1) ? kept.y : wanted.y,
                             isMotionLocked(2) ? kept.z : wanted.z);
    }
    void dropLockedForces();
    real largestInverseMoment() const {
        const Vector3 &i = inverseInertia;
        const real larger = i.x > i.y ? i.x : i.y;
        return larger > i.z ? larger : i.z;
    }
    void clearForces() {
        generated = Wrench();
        resistance = 0;
        if (hasAdded) added = Wrench();
        hasAdded = hasGenerated = false;
    }
    /// Makes the coming step's kick implicit where it resists too strongly for an explicit one.
    void resist(const Resistance &sum, real duration);
    /// Whether that may be so.
    bool mayBeStiff(real duration) const {
        const real acting = actingTime(duration);
        return resistance * (acting > duration ? acting : duration) > EXPLICIT_LIMIT;
    }
    /// How long generators act in this step, the last one's second half included.
    real actingTime(real duration) const { return 0.5 * (memory.linearKick + memory.angularKick + duration); }
    /// The resistance·duration up to which steps are wholly explicit; from twice that on they are implicit.
    static constexpr real EXPLICIT_LIMIT = 0.5;
    /// By value, lest callers, which seldom come here, keep their vectors in memory.
    void wakeForForce(Vector3 force, Vector3 torque);

    void forgetForces() { memory.linearKick = memory.angularKick = dampedDuration = 0; }
    void makeMovable(const char *function);
    void setPrincipalInertia(const Matrix3 &tensor, bool isInverse, const char *function);
    void setPrincipalFrame(const Vector3 &inverseMoments, const Quaternion &axes);
    void updatePrincipalFrame();
    Vector3 angularMomentumFor(const Vector3 &turning, const Quaternion &bodyToWorld) const;
    Matrix3 getPrincipalAxesInWorld() const;

    void fallAsleepIfIdle(real duration);
    void markFaulted();

    // What generators write fills a cache line, what most of them read two more; then comes what only steps
    // write, what they only read, and what they rarely need: the less memory a frame touches and changes, the
    // faster a large world is.
    alignas(64) bool awake = true;
    bool canSleep = false;
    bool faulted = false;
    bool hasAdded = false;      ///< `added` is not zero
    bool hasGenerated = false;  ///< `generated` is not zero
    std::uint8_t lockedMotion = 0;
    PrincipalFrame principalFrame;
    Marks marks;
    real resistance = 0;  ///< what generators have told, at most, 1/s
    Wrench generated;     ///< what generators have added since the last step

    Matrix4 transform;
    Vector3 velocity;
    real inverseMass = 1;

    Vector3 rotation;
    Vector3 inverseInertia = Vector3(1, 1, 1);  ///< principal
    Quaternion orientation;
    Vector3 angularMomentum;
    Vector3 lastFrameAcceleration;
    Memory memory;

    Vector3 acceleration;
    real linearDamping = 1, angularDamping = 1;
    real linearFactor = 1, angularFactor = 1;  ///< damping over half a step of dampedDuration
    real dampedDuration = 0;                   ///< 0: the factors are to be computed

    Wrench added;  ///< what the caller has added since the last step
    real mass = 1;
    Vector3 inertia = Vector3(1, 1, 1);  ///< principal; infinite about a locked axis
    Quaternion principalAxes;            ///< from principal axes to body axes
    real motion = 0, sleepEpsilon = 0.01;
};

}  // namespace cyclone
