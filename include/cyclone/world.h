#pragma once

/// @file
/// The world: bodies, the forces that act on them, and the frame that advances them all.
#include <cyclone/force.h>
#include <cyclone/jobs.h>
#include <cyclone/snapshot.h>

#include <memory>
#include <utility>
#include <vector>

namespace cyclone {

namespace detail {
class Members;
}

/// A simulation. Each frame of a game:
///
///     world.startFrame();
///     // add what forces this frame has of its own
///     world.runPhysics(duration);
///     // draw: every transform is current
///
/// Bodies and generators that are created belong to the world. Those that are added belong to the caller and
/// must live until they are removed or the world ends. Two worlds on two threads never meet.
class CYCLONE_API World {
public:
    typedef std::vector<RigidBody *> RigidBodies;

    World();
    ~World();
    World(const World &) = delete;
    World &operator=(const World &) = delete;

    /// @name Bodies
    /// Their coming and going takes a microsecond or so, with little regard to how many others there are. If
    /// memory runs out, nothing has changed.
    /// @{

    /// Adds a body of the caller's; once only, and to one world at a time: two worlds would both advance it.
    void addBody(RigidBody *body);
    /// Takes a body that was added out of the world, and ends its registrations and those whose generator has
    /// it as the other body. The body stays alive. Returns false if it was not in the world.
    bool removeBody(RigidBody *body);

    /// A new body that the world owns, close to its others in memory, which is what makes large worlds fast.
    /// Its address stays. Places of destroyed bodies are used again, the oldest first.
    RigidBody *createBody();
    /// Ends a body that this world created, its registrations, and those whose generator has it as the other
    /// body: a spring does not pull towards a body that is gone.
    void destroyBody(RigidBody *body);
    /// Ends what the world owns and all registrations, and takes out all bodies.
    void clear();

    /// In the order of adding and creating, which is the order of everything that happens. After a body has
    /// left, the first call takes time in proportion to their number.
    const RigidBodies &getBodies() const;
    /// The bodies whose step failed (see RigidBody::integrate) and that have not been woken since, as of the
    /// last integrate().
    const RigidBodies &getFaultedBodies() const { return faultedBodies; }
    /// @}

    /// @name Forces
    /// Generators that the world owns. Each ends with the last of its registrations, so with its body, with
    /// the world, or by destroyForce(). One that is called just then ends when all have been called.
    /// @{

    /// A new generator, made from the arguments and registered for a body of this world:
    ///
    ///     Aero &wing = world.createForce<Aero>(body, tensor, position, &wind);
    template <class Force, class... Arguments>
    Force &createForce(RigidBody *body, Arguments &&...arguments) {
        auto force = std::make_unique<Force>(std::forward<Arguments>(arguments)...);
        Force &created = *force;
        ownForce(std::move(force), body, nullptr, "World::createForce");
        return created;
    }
    /// A new spring, or with createSpring<Bungee> a bungee, between two bodies of this world, that acts on
    /// both. Points in body coordinates, springConstant in N/m, restLength in m. It ends with either body.
    template <class Kind = Spring>
    Kind &createSpring(RigidBody *body, const Vector3 &connectionPoint, RigidBody *other,
                       const Vector3 &otherConnectionPoint, real springConstant, real restLength) {
        auto spring = std::make_unique<Kind>(body, connectionPoint, other, otherConnectionPoint,
                                             springConstant, restLength);
        Kind &created = *spring;
        ownForce(std::move(spring), body, other, "World::createSpring");
        return created;
    }
    /// Ends a generator that this world created, and its registrations.
    void destroyForce(ForceGenerator &force);

    /// For generators of the caller's, and to let one act on several bodies.
    ForceRegistry &getForceRegistry() { return registry; }
    const ForceRegistry &getForceRegistry() const { return registry; }
    /// @}

    /// @name A frame
    /// No allocation happens in these; durations are finite and not negative, in seconds. Generators may not
    /// call them.
    /// @{

    /// Drops forces that have been added since the last step. Transforms are current.
    void startFrame();
    /// Applies the registry, then advances every body. If a generator throws, no body has moved, no
    /// generator's force of this frame is left, and what the caller has added stays until startFrame() or a
    /// step.
    void runPhysics(real duration);
    /// Advances every body, without the registry. If the job system throws, some have been advanced.
    void integrate(real duration);
    /// @}

    /// @name Saving and restoring
    /// The states of all bodies, in their order, and which bodies, generators and registrations there are.
    /// Settings of generators (controls, throttles, winds) are not saved: they are the game's inputs, which
    /// the game sets again. Run on with the same inputs, a restored world gives the same bits as one that was
    /// never stopped.
    ///
    /// While a snapshot is kept, what the world owned then does not end for good: destroyed, it lies dormant,
    /// at the same address, until the last such snapshot is dropped or saved anew.
    /// @{

    /// Reuses the snapshot's memory.
    void saveState(Snapshot &snapshot) const;
    /// Returns to a snapshot of this world: bodies and generators of its own that have been created since
    /// end, those that have ended come back, and registrations are as they were, in their order. Refuses,
    /// and changes nothing, when a body or generator of the caller's that took part is no longer in the
    /// world: it may be gone. Of the caller's, those that have come since are taken out.
    ///
    /// The bytes of a snapshot alone, such as from another machine, set the states of just as many bodies,
    /// and leave the rest as it is. Refuses what findSnapshotError() finds fault with.
    void restoreState(const Snapshot &snapshot);
    /// A number that depends on every bit of the bodies' states and on how many bodies and registrations
    /// there are, to notice when two machines fall out of step.
    std::uint64_t hash() const;
    /// @}

    /// @name Threads
    /// The frame's work can be shared out. The result does not depend on it, not by one bit.
    /// @{

    /// Lets `threadCount` threads work on each frame, the calling one among them, at most 256; 0 or 1: only
    /// that. Worlds of fewer than some thousand bodies stay on the calling thread all the same, which is
    /// faster.
    void setWorkers(std::size_t threadCount);
    /// Uses the host's own job system, in parts of some hundred bodies, however few there are; only what
    /// makes a single part stays on the calling thread. It must outlive the world; null: none.
    void setJobSystem(JobSystem *hostJobs);
    /// @}

private:
    class Bodies;  ///< storage of the bodies that the world owns
    class ForcesOnAll;
    class ClearJob;
    class IntegrateJob;
    /// A body of the world's own that may come back.
    struct EndedBody {
        RigidBody *body;
        std::uint64_t born, died;
    };

    void requireNotParallel(const char *function) const;
    void requireIdle(const char *function) const;
    void append(RigidBody *body);
    std::uint64_t detach(RigidBody *body);
    void endBody(RigidBody *body, std::uint64_t born);
    void freeEndedBodies();
    void ownForce(std::unique_ptr<ForceGenerator> force, RigidBody *body, RigidBody *other,
                  const char *function);

    void runParts(JobSystem::Job &job, std::size_t least);
    void updateForces(real duration);
    void listFaultedBodies(bool anyNew);

    std::shared_ptr<detail::WorldStructure> prepareStructure(const Snapshot &snapshot) const;
    bool isCurrent(const detail::WorldStructure &structure) const;
    const detail::WorldStructure *findStructure(const Snapshot &snapshot) const;
    void requireCallersPart(const detail::WorldStructure &then) const;
    void restoreStructure(const detail::WorldStructure &then);

    std::shared_ptr<detail::SnapshotHistory> history;
    std::unique_ptr<detail::Members> members;
    std::uint64_t memberChanges = 0;   ///< so far
    std::uint64_t memberRevision = 0;  ///< another number after each change
    std::unique_ptr<Bodies> ownedBodies;
    std::vector<EndedBody> endedBodies;  ///< room for all that are owned
    RigidBodies faultedBodies;
    ForceRegistry registry;
    std::unique_ptr<Workers> workers;
    JobSystem *jobs = nullptr;
    std::size_t leastForJobs = 0;  ///< bodies or registrations that are worth sharing out
};

}  // namespace cyclone
