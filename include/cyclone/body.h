#pragma once

/// @file
/// The rigid body: its state, how forces are added to it, and the step that advances it.
#include <cyclone/core.h>

#include <cstddef>
#include <cstdint>

namespace cyclone {

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

    /// About the centre of mass, in body axes, kg·m²: symmetric, its principal moments positive. The rotation
    /// is kept.
    void setInertiaTensor(const Matrix3 &inertiaTensor);
    /// Its inverse: symmetric, no principal value negative. About an axis whose value is 0, a locked axis,
    /// torques do nothing.
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
    /// Whatever is set must be finite. Setting starts the step's memory of forces afresh, see integrate().
    /// @{
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
    /// Impulses: at once, whatever the step.
    void addVelocity(const Vector3 &change);
    void addRotation(const Vector3 &change);
    /// About the centre of mass, world coordinates, kg·m²/s; of an immovable body zero.
    Vector3 getAngularMomentum() const { return angularMomentum; }

    /// A constant acceleration (m/s²) that acts whatever the mass, such as gravity. None by default; a new
    /// one wakes the body.
    void setAcceleration(const Vector3 &metresPerSecondSquared);
    void setAcceleration(real x, real y, real z) { setAcceleration(Vector3(x, y, z)); }
    Vector3 getAcceleration() const { return acceleration; }
    /// What accelerated the body during its last step: forces and the constant acceleration, at the step's
    /// start.
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
    /// Renews what follows from position and orientation. Setters and steps have done so already.
    void calculateDerivedData();
    /// @}

    /// @name Forces
    /// They act for one step: the velocity of an undamped body changes by exactly force·duration/mass. They
    /// are not checked, see integrate(). Any force or torque but zero wakes the body.
    /// @{

    /// At the centre of mass, world coordinates, N.
    void addForce(const Vector3 &force) { addLoad(force, Vector3()); }
    void addForceAtPoint(const Vector3 &force, const Vector3 &worldPoint) {
        addLoad(force, (worldPoint - getPosition()) % force);
    }
    /// The force in world coordinates, the point in body coordinates.
    void addForceAtBodyPoint(const Vector3 &force, const Vector3 &bodyPoint) {
        addLoad(force, transform.transformDirection(bodyPoint) % force);
    }
    /// World coordinates, N·m.
    void addTorque(const Vector3 &torque) { addLoad(Vector3(), torque); }
    /// Takes back what has been added since the last step.
    void clearAccumulators() {
        if (hasAdded || isGenerated || startsAfresh) dropLoads();
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
    /// Constant forces are exact and free rotation is of fourth order. Forces that change smoothly are of
    /// second order with this one evaluation, because each step mends the last one's end: velocity gains (A −
    /// A_last)·h_last/2, where A is what force generators caused through a ForceRegistry. What the caller
    /// adds counts F·h, no more and no less; acting on smoothly, it moves the body with second order too (see
    /// step.h). Setters start these memories afresh.
    ///
    /// Returns false if the step would not be finite (a force of NaN or of absurd size): the body then keeps
    /// its last good state, drops the forces, and sleeps.
    bool integrate(real duration);

    /// Advances many bodies, none null and none twice, to the same bits as one after the other but in about
    /// half the time. Returns the number of them whose integrate() returned false.
    static std::size_t integrate(RigidBody *const *bodies, std::size_t count, real duration);

    /// Whether the last step failed and the body has not been woken since.
    bool hasFaulted() const { return faulted; }

    /// @name Saving and restoring
    /// @{

    /// What a force, or torque, has done while it acted from step to step.
    struct Course {
        Vector3 last;             ///< in the last step
        Vector3 change;           ///< from the first step to the last
        real greatestSquare = 0;  ///< of its magnitude

        /// Goes on with the force of a step; begins anew where it jumps by more than half of the greatest so
        /// far.
        void follow(const Vector3 &now);
        bool isFinite() const { return last.isFinite() && change.isFinite() && greatestSquare >= 0; }
    };

    /// Everything that the next step depends on, and nothing else. Same state and same forces: the same bits.
    struct CYCLONE_API State {
        Vector3 position;
        Quaternion orientation;
        Vector3 velocity, rotation, angularMomentum;
        Vector3 acceleration, lastFrameAcceleration;
        Vector3 addedForce, addedTorque;          ///< by the caller since the last step
        Vector3 generatedForce, generatedTorque;  ///< by generators since the last step
        Vector3 lastForce, lastTorque;            ///< by generators in the last step, which took
        real lastDuration = 0;                    ///< so long; 0: nothing to remember
        Course addedForces, addedTorques;         ///< by the caller, from step to step
        real mass = 1, inverseMass = 1;
        Vector3 inertia = Vector3(1, 1, 1), inverseInertia = Vector3(1, 1, 1);  ///< principal
        Quaternion principalAxes;  ///< from principal axes to body axes
        real linearDamping = 1, angularDamping = 1;
        real motion = 0, sleepEpsilon = 0.01;
        bool awake = true, canSleep = false, faulted = false, hasAdded = false, isGenerated = false,
             startsAfresh = false, hasStartedAfresh = false, wasAdded = false, hasAddedAfresh = false;

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
    friend class StepBlock;
    friend class World;

    /// A force at the centre of mass and a torque, world coordinates.
    struct Load {
        Vector3 force, torque;
    };

    void addLoad(const Vector3 &force, const Vector3 &torque) {
        Load &load = inGenerator ? generated : added;
        load.force += force;
        load.torque += torque;
        (inGenerator ? isGenerated : hasAdded) = true;
        if (!awake) wakeForLoad(force, torque);
    }
    void dropLoads();
    void wakeForLoad(const Vector3 &force, const Vector3 &torque);

    /// Nothing to remember; nor after this step, when some generators have been called for it already.
    void forgetForces() {
        lastDuration = 0;
        wasAdded = false;
        if (isGenerated) startsAfresh = true;
    }
    void setPrincipalInertia(const Matrix3 &tensor, bool isInverse, const char *function);
    void setPrincipalFrame(const Vector3 &inverseMoments, const Quaternion &axes);
    Vector3 momentumOf(const Vector3 &turning) const;
    void setMomentumFromRotation();
    bool hasLockedAxis() const {
        return inverseInertia.x == 0 || inverseInertia.y == 0 || inverseInertia.z == 0;
    }
    bool turnsFreely() const { return inverseMass > 0 && !hasLockedAxis(); }
    Matrix3 getPrincipalAxesInWorld() const;

    void followAdded();
    void fallAsleepIfIdle(bool nothingTwists, real duration);
    void keepLastGoodState();

    // What generators read and write comes first, then what only the step does, then what it rarely needs:
    // the less memory a frame touches, the faster a large world is.
    bool awake = true;
    bool canSleep = false;
    bool faulted = false;
    bool inGenerator = false;       ///< a ForceRegistry is calling one of this body's generators
    bool isGenerated = false;       ///< a ForceRegistry has called one since the last step
    bool hasAdded = false;          ///< `added` is not zero
    bool wasAdded = false;          ///< nor was it in the last step: `addedForces` goes on
    bool startsAfresh = false;      ///< this step's forces are not to be remembered
    bool hasStartedAfresh = false;  ///< the last step had generators, and nothing to remember
    bool hasAddedAfresh = false;    ///< the last step had added forces, and none before to go on from
    bool hasPrincipalAxes = false;  ///< `principalAxes` is not the identity
    std::uint8_t middleAxis = 1;    ///< the principal axis of the middle inertia; of equal ones, 1
    Matrix4 transform;
    Vector3 velocity;
    Vector3 rotation;
    Load generated;  ///< what generators have added since the last step

    Quaternion orientation;
    Vector3 angularMomentum;
    Load lastGenerated;     ///< the generators' share in the last step
    real lastDuration = 0;  ///< of the step that lastGenerated belongs to; 0: nothing to remember
    Vector3 lastFrameAcceleration;
    Vector3 acceleration;
    real inverseMass = 1;
    Vector3 inverseInertia = Vector3(1, 1, 1);  ///< principal
    real linearFactor = 1, angularFactor = 1;   ///< damping over half a step of factorDuration
    real factorDuration = 0;

    Load added;  ///< what the caller has added since the last step
    Course addedForces, addedTorques;
    real mass = 1;
    Vector3 inertia = Vector3(1, 1, 1);  ///< principal; infinite about a locked axis
    Quaternion principalAxes;            ///< from principal axes to body axes
    real linearDamping = 1, angularDamping = 1;
    real motion = 0, sleepEpsilon = 0.01;
};

}  // namespace cyclone
