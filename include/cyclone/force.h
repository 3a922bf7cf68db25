#pragma once

/// @file
/// What acts on bodies frame after frame: force generators, the registry that says which acts on which body,
/// and the simple forces.
#include <cyclone/body.h>

#include <cstddef>
#include <vector>

namespace cyclone {

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

protected:
    ForceGenerator() = default;
    ForceGenerator(const ForceGenerator &) = default;
    ForceGenerator &operator=(const ForceGenerator &) = default;
};

class JobSystem;

/// Which generator acts on which body. It owns neither: a body or generator must be taken out, or the
/// registry cleared, before its life ends. (A World takes care of the bodies that are removed from it.)
class CYCLONE_API ForceRegistry {
public:
    /// Lets the generator act on the body from now on. Added twice, it acts twice.
    void add(RigidBody *body, ForceGenerator *generator);
    /// Ends the oldest such registration; without one, nothing happens. Generators and bodies stay alive.
    void remove(RigidBody *body, ForceGenerator *generator);
    /// Ends all registrations of the body.
    void remove(RigidBody *body);
    /// Ends all registrations. Touches neither bodies nor generators.
    void clear();

    /// Calls every generator, in the order of adding. A generator may add and remove registrations meanwhile:
    /// what it removes is not called any more, what it adds is called from the next time on. It may not call
    /// updateForces or clear.
    void updateForces(real duration);
    /// The same, with generators that act on their body only shared out over the job system's threads; those
    /// may not change registrations. Each body's forces are added in the same order as ever, so the bits are
    /// the same.
    void updateForces(real duration, JobSystem &jobs);

    std::size_t size() const { return registrations.size() - removedCount; }
    /// Whether some generator may act on other bodies than the one it is called for.
    bool hasOutreachingGenerators() const { return outreachingCount > 0; }
    /// Whether generators are being called now.
    bool isUpdating() const { return updating; }
    /// Whether several threads call them: neither registrations nor a world's bodies may change then.
    bool isShared() const { return sharing; }

private:
    struct Registration {
        RigidBody *body;  ///< null: removed during updateForces
        ForceGenerator *generator;
        bool actsOnItsBodyOnly;  ///< as the generator said when it was added
    };
    /// The registrations in the order in which threads take them: runs of such that act on their body only,
    /// sorted by body within a run.
    struct Turn {
        RigidBody *body;
        std::size_t index;
    };
    class Update;
    class Share;

    static void prefetchFor(const Registration &registration);
    void callGenerator(std::size_t index, real duration);
    void erase(std::size_t index);
    void renewSchedule();
    std::size_t endOfRun(std::size_t begin) const;

    std::vector<Registration> registrations;
    std::vector<Turn> schedule;
    bool scheduleIsCurrent = true;
    bool updating = false, sharing = false;
    std::size_t removedCount = 0;  ///< nulls among the registrations
    std::size_t outreachingCount = 0;
};

/// Gravity as a force: mass·acceleration. For most games RigidBody::setAcceleration does the same for less.
/// Nothing acts on immovable bodies.
class CYCLONE_API Gravity : public ForceGenerator {
public:
    /// m/s², world coordinates.
    explicit Gravity(const Vector3 &acceleration = Vector3::GRAVITY);
    void updateForce(RigidBody *body, real duration) override;
    bool actsOnItsBodyOnly() const override { return true; }

private:
    Vector3 acceleration;
};

/// Drag at the centre of mass, against the velocity v: −v/|v|·(k1·|v| + k2·|v|²). A step is stable while
/// (k1 + k2·|v|)/mass·duration < 1.
class CYCLONE_API Drag : public ForceGenerator {
public:
    /// k1 in N·s/m, k2 in N·s²/m²; finite and not negative.
    Drag(real k1, real k2);
    void updateForce(RigidBody *body, real duration) override;
    bool actsOnItsBodyOnly() const override { return true; }

private:
    real k1, k2;
};

/// A spring from a point of the body to a point of another: along the line d between them −k(|d| − L)·d/|d|,
/// pulling when stretched, pushing when compressed; at zero length no force. It acts on the body that it is
/// registered for; register its mirror image for the other.
class CYCLONE_API Spring : public ForceGenerator {
public:
    /// Points in body coordinates, `other` not null and alive as long as the spring acts, springConstant k in
    /// N/m and restLength L in m, finite and not negative.
    Spring(const Vector3 &connectionPoint, const RigidBody *other, const Vector3 &otherConnectionPoint,
           real springConstant, real restLength);
    void updateForce(RigidBody *body, real duration) override;
    bool actsOnItsBodyOnly() const override { return true; }

protected:
    /// For derived classes: `function` is whose arguments they are.
    Spring(const char *function, const Vector3 &connectionPoint, const RigidBody *other,
           const Vector3 &otherConnectionPoint, real springConstant, real restLength);
    /// From the other body's point to this body's, world coordinates.
    Vector3 getSpan(const RigidBody &body) const;

    Vector3 connectionPoint;
    const RigidBody *other;
    Vector3 otherConnectionPoint;
    real springConstant, restLength;
};

/// A spring that only pulls: slack, it does nothing.
class CYCLONE_API Bungee : public Spring {
public:
    /// As Spring.
    Bungee(const Vector3 &connectionPoint, const RigidBody *other, const Vector3 &otherConnectionPoint,
           real springConstant, real restLength);
    void updateForce(RigidBody *body, real duration) override;
};

/// A spring from a point of the body to a fixed point of the world.
class CYCLONE_API AnchoredSpring : public ForceGenerator {
public:
    /// connectionPoint in body coordinates, anchor in world coordinates; constants as for Spring.
    AnchoredSpring(const Vector3 &connectionPoint, const Vector3 &anchor, real springConstant,
                   real restLength);
    void setAnchor(const Vector3 &worldPoint);
    Vector3 getAnchor() const { return anchor; }
    void updateForce(RigidBody *body, real duration) override;
    bool actsOnItsBodyOnly() const override { return true; }

private:
    Vector3 connectionPoint, anchor;
    real springConstant, restLength;
};

}  // namespace cyclone
