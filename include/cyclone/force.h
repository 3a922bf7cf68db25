#pragma once

/// @file
/// What acts on bodies frame after frame: force generators, the registry that says which acts on which body,
/// and the simple forces.
#include <cyclone/body.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace cyclone {

/// How a force and its torque about the centre of mass answer to the motion of the body: their derivatives
/// by its velocity and by its rotation, SI, world coordinates. What resists is negative, as in an aerodynamic
/// tensor.
struct CYCLONE_API Resistance {
    Matrix3 forceByVelocity, forceByRotation, torqueByVelocity, torqueByRotation;

    /// Adds that of a force with ∂force/∂flow = `tensor` (N·s/m) that acts at `arm` from the centre of mass
    /// (m). The flow is the velocity of the centre or, with rotational flow, of the point itself.
    void add(const Matrix3 &tensor, const Vector3 &arm, bool rotationalFlow);
};

/// Something that adds a force, a torque or both to a body in every frame. Derive from it for forces of your
/// own.
class CYCLONE_API ForceGenerator {
public:
    virtual ~ForceGenerator() = default;

    /// Adds this generator's force to the body, for a step of `duration` seconds. What it adds should change
    /// smoothly from step to step, for the step takes it for second-order accuracy: a throttle that is opened
    /// between two frames gives F·h/2 more at first, and as much less when it is closed. Kicks and one-frame
    /// forces belong to RigidBody::addForce or addVelocity, outside of generators.
    ///
    /// What it adds to other bodies of the same World is treated the same way; elsewhere that counts plainly,
    /// like a caller's force.
    virtual void updateForce(RigidBody *body, real duration) = 0;

    /// Whether updateForce changes nothing but the forces on the body that it is given, and so may be called
    /// for different bodies at once by World's workers. It may read whatever no generator changes.
    virtual bool actsOnItsBodyOnly() const { return false; }

    /// The body that ties this generator to another than the one it acts on, such as the far end of a spring;
    /// null: none. It is asked when the generator is registered for `body`. The registration ends when the
    /// other body leaves the World.
    virtual const RigidBody *getOtherBody(const RigidBody * /*body*/) const { return nullptr; }

    /// Adds how what updateForce adds answers to the motion of the body as it moves now. A generator that
    /// tells so may resist motion with any strength, alone or with others, at any step. One that does
    /// not is bound to z < 1, with z the sum of c·(1/mass + lever²/moment)·duration over the body's
    /// generators; beside a spring, to z < 1 − (ω·duration/2)².
    ///
    /// Called after all generators of a body, and only if what they told RigidBody::addResistance may be too
    /// strong for an explicit step; it must not throw. To tell more than is true is safe: the motion ends the
    /// same, only later.
    virtual void addResistance(const RigidBody &body, Resistance &sum) const;

protected:
    ForceGenerator() = default;
    ForceGenerator(const ForceGenerator &) = default;
    ForceGenerator &operator=(const ForceGenerator &) = default;
};

/// A generator whose force acts at one point of the body: a surface, a hull, an engine. A game that draws or
/// sounds forces asks all of them alike.
class CYCLONE_API PointForce : public ForceGenerator {
public:
    /// On this body as it lies and moves now, N, world coordinates.
    virtual Vector3 getForce(const RigidBody &body) const = 0;
    /// The point of this body where it acts, body coordinates, m.
    virtual Vector3 getPointOn(const RigidBody &) const { return position; }
    /// The same as it was constructed; only a spring between two bodies acts at different points of them.
    Vector3 getPosition() const { return position; }

    void updateForce(RigidBody *body, real duration) override;
    bool actsOnItsBodyOnly() const override { return true; }

protected:
    /// At the centre of mass.
    PointForce() = default;
    /// At this point, body coordinates, m, finite.
    explicit PointForce(const Vector3 &position);
    /// For derived classes: `function` is whose argument it is.
    PointForce(const char *function, const Vector3 &position);

    Vector3 position;
};

class JobSystem;
namespace detail {
class Registrations;
struct RegistrationDetails;
class SnapshotHistory;
}  // namespace detail

/// Which generator acts on which body. It owns neither, save for the generators that a World creates in it: a
/// body or generator must be taken out, or the registry cleared, before its life ends. (A World does so with
/// the bodies that leave it.) A body that is registered but in no world piles up forces until its
/// integrate() or clearAccumulators() is called.
///
/// Adding and removing takes time in proportion to the registrations of the body or generator, whatever the
/// number of others.
class CYCLONE_API ForceRegistry {
public:
    ForceRegistry();
    ~ForceRegistry();
    ForceRegistry(const ForceRegistry &) = delete;
    ForceRegistry &operator=(const ForceRegistry &) = delete;

    /// Lets the generator act on the body from now on. Added twice, it acts twice.
    void add(RigidBody *body, ForceGenerator *generator);
    /// Ends the oldest such registration; without one, nothing happens. Bodies and generators stay alive, but
    /// a generator that a World has created ends with its last registration.
    void remove(RigidBody *body, ForceGenerator *generator);
    /// Ends all registrations of the body, and those whose generator has it as the other body.
    void remove(RigidBody *body);
    /// Ends all registrations of the generator.
    void remove(ForceGenerator *generator);
    /// Ends all registrations. Touches neither bodies nor the caller's generators.
    void clear();

    /// Calls every generator, in the order of adding. A generator may add and remove registrations meanwhile:
    /// what it removes is not called any more, what it adds is called from the next time on. It may not call
    /// updateForces or clear. If it throws, the others are not called, and what has been added to bodies so
    /// far stays there (World::runPhysics takes it back).
    void updateForces(real duration);
    /// The same, with generators that act on their body only shared out over the job system's threads; those
    /// may not change registrations. Each body's forces are added in the same order as ever, so the bits are
    /// the same.
    void updateForces(real duration, JobSystem &jobs);

    std::size_t size() const;

private:
    friend class World;

    enum class Phase { IDLE, SERIAL, PARALLEL };
    class Update;
    class ParallelJob;
    class ResistJob;
    /// A generator of the registry's own after its last registration.
    struct EndedGenerator {
        std::unique_ptr<ForceGenerator> generator;
        std::uint64_t born, died;
    };

    void prefetchFor(std::size_t index) const;
    void callGenerator(std::size_t index, real duration);
    void callInOrder(std::size_t begin, std::size_t end, real duration);
    void resist(std::size_t begin, std::size_t end, real duration);
    std::size_t endOfRun(std::size_t begin, std::size_t end) const;

    bool hasCrossBodyGenerators() const;
    void requireNotParallel(const char *function) const;
    void own(std::unique_ptr<ForceGenerator> generator, RigidBody *body, RigidBody *second);
    bool isOwned(const ForceGenerator *generator) const;
    static detail::RegistrationDetails describe(const RigidBody *body, const ForceGenerator *generator);
    void append(RigidBody *body, ForceGenerator *generator, const detail::RegistrationDetails &its);
    void end(std::size_t index);
    void endGenerator(ForceGenerator *generator, std::uint64_t born);
    bool revive(ForceGenerator *generator, std::uint64_t &born);
    void deleteEndedGenerators();
    void restore(const detail::Registrations &then);
    bool mayComeBack(std::uint64_t born, std::uint64_t died) const;

    std::unique_ptr<detail::Registrations> registrations;
    std::uint64_t changes = 0;   ///< so far
    std::uint64_t revision = 0;  ///< another number after each change
    Phase phase = Phase::IDLE;
    std::atomic<bool> anyMayBeStiff{false};  ///< of the bodies whose generators have been called
    std::size_t ownedCount = 0;
    std::vector<EndedGenerator> endedGenerators;       ///< room for all that are owned
    std::shared_ptr<detail::SnapshotHistory> history;  ///< null: nothing comes back
};

/// Gravity as a force: mass·acceleration. For most games RigidBody::setAcceleration does the same for less.
/// Nothing acts on immovable bodies.
class CYCLONE_API Gravity : public PointForce {
public:
    /// m/s², world coordinates.
    explicit Gravity(const Vector3 &acceleration = Vector3::GRAVITY);
    Vector3 getForce(const RigidBody &body) const override;

private:
    Vector3 acceleration;
};

class WindField;

/// Drag at the centre of mass, against the velocity v through the air: −v/|v|·(k1·|v| + k2·|v|²). It may be
/// of any strength, see ForceGenerator::addResistance.
class CYCLONE_API Drag : public PointForce {
public:
    /// k1 in N·s/m, k2 in N·s²/m²; finite and not negative.
    Drag(real k1, real k2);

    /// The wind, see wind.h, read at the centre of mass: v is the body's velocity − the field's. It must live
    /// as long as the drag acts; null is still air.
    void setWind(const WindField *field) { windField = field; }

    Vector3 getForce(const RigidBody &body) const override;
    void updateForce(RigidBody *body, real duration) override;
    void addResistance(const RigidBody &body, Resistance &sum) const override;

private:
    Vector3 getFlow(const RigidBody &body) const;

    real k1, k2;
    const WindField *windField = nullptr;
};

/// What pulls a point of the body towards a far end, along the line d from there: −T·d/|d| with the tension
///
///     T = k·(|d| − L) + c·d|d|/dt
///
/// Stretched it pulls, compressed it pushes; at zero length there is no force. The step must be shorter than
/// 2/ω, see getLongestStep(); the damping may be of any strength, see ForceGenerator::addResistance.
class CYCLONE_API ElasticForce : public PointForce {
public:
    /// k, N/m; finite and not negative.
    void setSpringConstant(real newtonsPerMetre);
    real getSpringConstant() const { return springConstant; }
    /// L, m; finite and not negative.
    void setRestLength(real metres);
    real getRestLength() const { return restLength; }
    /// c, N·s/m, for the motion of the two ends along the line; finite and not negative. 0 by default.
    void setDamping(real newtonSecondsPerMetre);
    real getDamping() const { return damping; }

    /// As it is stretched between the body and the far end now: |d|, m, and T, N.
    real getLength(const RigidBody &body) const { return getLine(body).separation.magnitude(); }
    real getTension(const RigidBody &body) const { return tensionOf(getLine(body)); }
    /// The longest step that this force bears on the body by itself, s: 2/ω with ω² = k·(w + w'), where w and
    /// w' say how much both ends answer to an impulse along the line, 1/kg; infinite where nothing swings.
    /// Where a body has several, their ω² add up at most; of a long chain it is 4·k/m.
    real getLongestStep(const RigidBody &body) const;
    Vector3 getForce(const RigidBody &body) const override;

    void updateForce(RigidBody *body, real duration) override;
    void addResistance(const RigidBody &body, Resistance &sum) const override;

protected:
    /// From the far end to the body's, m, and how fast that changes, m/s; world coordinates.
    struct Line {
        Vector3 separation, velocity;
    };

    /// For derived classes: `function` is whose arguments they are.
    ElasticForce(const char *function, const Vector3 &connectionPoint, real springConstant, real restLength);
    virtual Line getLine(const RigidBody &body) const = 0;
    virtual real tensionOf(const Line &line) const;
    /// How much the far end's velocity answers to an impulse along this unit vector, 1/kg; 0: not at all.
    virtual real getFarInverseMass(const RigidBody & /*body*/, const Vector3 & /*direction*/) const {
        return 0;
    }

private:
    real getPairDamping(const RigidBody &body, const Vector3 &direction) const;

    real springConstant, restLength;
    real damping = 0;
};

/// From a point of the body to a point of another. It acts on the body that it is registered for. For the
/// other, register its mirror image, or tell the constructor both bodies and register it for both;
/// World::createSpring does so.
class CYCLONE_API Spring : public ElasticForce {
public:
    /// Points in body coordinates, `other` not null and alive as long as the spring acts, springConstant k in
    /// N/m and restLength L in m, finite and not negative.
    Spring(const Vector3 &connectionPoint, const RigidBody *other, const Vector3 &otherConnectionPoint,
           real springConstant, real restLength);
    /// Between two different bodies, to be registered for one of them or both.
    Spring(const RigidBody *body, const Vector3 &connectionPoint, const RigidBody *other,
           const Vector3 &otherConnectionPoint, real springConstant, real restLength);

    const RigidBody *getOtherBody(const RigidBody *body) const override;
    Vector3 getPointOn(const RigidBody &body) const override;

protected:
    /// For derived classes: `function` is whose arguments they are, and a null body one that is not told.
    Spring(const char *function, const RigidBody *body, const Vector3 &connectionPoint,
           const RigidBody *other, const Vector3 &otherConnectionPoint, real springConstant, real restLength);
    Line getLine(const RigidBody &body) const override;
    real getFarInverseMass(const RigidBody &body, const Vector3 &direction) const override;

private:
    Vector3 getFarPoint(const RigidBody &body) const;
    bool isOther(const RigidBody &body) const { return &body == other && firstBody != nullptr; }

    const RigidBody *firstBody;  ///< null: whichever it is registered for
    const RigidBody *other;
    Vector3 otherConnectionPoint;
};

/// A spring that only pulls: slack, it does nothing.
class CYCLONE_API Bungee : public Spring {
public:
    /// As Spring.
    Bungee(const Vector3 &connectionPoint, const RigidBody *other, const Vector3 &otherConnectionPoint,
           real springConstant, real restLength);
    Bungee(const RigidBody *body, const Vector3 &connectionPoint, const RigidBody *other,
           const Vector3 &otherConnectionPoint, real springConstant, real restLength);
    void addResistance(const RigidBody &body, Resistance &sum) const override;

protected:
    real tensionOf(const Line &line) const override;
};

/// From a point of the body to a fixed point of the world.
class CYCLONE_API AnchoredSpring : public ElasticForce {
public:
    /// connectionPoint in body coordinates, anchor in world coordinates; constants as for Spring.
    AnchoredSpring(const Vector3 &connectionPoint, const Vector3 &anchor, real springConstant,
                   real restLength);
    /// For the damping, the anchor counts as at rest wherever it is moved.
    void setAnchor(const Vector3 &worldPoint);
    Vector3 getAnchor() const { return anchor; }

protected:
    Line getLine(const RigidBody &body) const override;

private:
    Vector3 anchor;
};

}  // namespace cyclone
