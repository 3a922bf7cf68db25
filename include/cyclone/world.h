#pragma once

/// @file
/// The world: bodies, the forces that act on them, and the frame that advances them all.
#include <cyclone/force.h>
#include <cyclone/jobs.h>
#include <cyclone/snapshot.h>

#include <memory>
#include <unordered_set>
#include <vector>

namespace cyclone {

/// A simulation. Each frame of a game:
///
///     world.startFrame();
///     // add what forces this frame has of its own
///     world.runPhysics(duration);
///     // draw: every transform is current
///
/// Bodies that are added belong to the caller and must live until they are removed or the world ends; so do
/// generators in the registry. Bodies that are created belong to the world. Two worlds on two threads never
/// meet.
class CYCLONE_API World {
public:
    typedef std::vector<RigidBody *> RigidBodies;

    World();
    ~World();
    World(const World &) = delete;
    World &operator=(const World &) = delete;

    /// @name Bodies
    /// @{

    /// Adds a body of the caller's; once only, and to one world at a time.
    void addBody(RigidBody *body);
    /// Takes a body that was added, and its registrations, out of the world; the body stays alive. Returns
    /// false if it was not in the world. Takes time in proportion to the number of bodies and registrations,
    /// as destroyBody does.
    bool removeBody(RigidBody *body);

    /// A new body that the world owns, close to its others in memory, which is what makes large worlds fast.
    /// Its address stays.
    RigidBody *createBody();
    /// Ends a body that this world created, and its registrations.
    void destroyBody(RigidBody *body);

    /// In the order of adding and creating, which is the order of everything that happens.
    const RigidBodies &getBodies() const { return bodies; }
    /// The bodies whose step failed (see RigidBody::integrate) and that have not been woken since, as of the
    /// last integrate().
    const RigidBodies &getFaultedBodies() const { return faultedBodies; }
    /// @}

    ForceRegistry &getForceRegistry() { return registry; }
    const ForceRegistry &getForceRegistry() const { return registry; }

    /// @name A frame
    /// No allocation happens in these; durations are finite and not negative, in seconds. Generators may not
    /// call them.
    /// @{

    /// Drops forces that have been added since the last step. Transforms are current.
    void startFrame();
    /// Applies the registry, then advances every body.
    void runPhysics(real duration);
    /// Advances every body, without the registry.
    void integrate(real duration);
    /// @}

    /// @name Saving and restoring
    /// The states of all bodies, in their order. Settings of generators (controls, throttles, winds) and the
    /// registrations are not among them: they are the game's inputs, to be set again by the game, before the
    /// states are restored: a change of registrations lets a body's step start afresh. Run on with the same
    /// inputs, a restored world gives the same bits as one that was never stopped.
    /// @{

    /// Reuses the snapshot's memory.
    void saveState(Snapshot &snapshot) const;
    /// Refuses a snapshot that findSnapshotError() finds fault with, and changes nothing then.
    void restoreState(const Snapshot &snapshot);
    /// A number that depends on every bit of the bodies' states, to notice when two machines fall out of
    /// step.
    std::uint64_t hash() const;
    /// @}

    /// @name Threads
    /// The frame's work can be shared out. The result does not depend on it, not by one bit.
    /// @{

    /// Lets `threadCount` threads work on each frame, the calling one among them, at most 256; 0 or 1: only
    /// that. Worth it from a few thousand bodies on.
    void setWorkers(std::size_t threadCount);
    /// Uses the host's own job system, which must outlive the world; null: none.
    void setJobSystem(JobSystem *hostJobs);
    /// @}

private:
    class Bodies;  ///< storage of the bodies that the world owns
    class ForcesOnAll;
    class Advance;

    void requireUnshared(const char *function) const;
    void requireIdle(const char *function) const;
    void takeOut(RigidBody *body);
    void updateForces(real duration);
    void listFaultedBodies(bool anyNew);

    RigidBodies bodies;
    std::unordered_set<const RigidBody *> members;
    std::unique_ptr<Bodies> ownedBodies;
    RigidBodies faultedBodies;
    ForceRegistry registry;
    std::unique_ptr<Workers> workers;
    JobSystem *jobs = nullptr;
};

}  // namespace cyclone
