#include <cyclone/world.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <utility>

#include "arguments.h"
#include "compiler.h"
#include "growing.h"
#include "members.h"
#include "ownedbodies.h"
#include "parallel.h"
#include "registrations.h"
#include "snapshothistory.h"

namespace cyclone {

using namespace detail;

World::World()
    : history(std::make_shared<SnapshotHistory>()),
      members(std::make_unique<Members>()),
      ownedBodies(std::make_unique<Bodies>()) {
    registry.history = history;
}

World::~World() = default;

void World::requireNotParallel(const char *function) const {
    require(registry.phase != ForceRegistry::Phase::PARALLEL, function,
            "a generator that acts on its body only may not change the bodies");
}

void World::requireIdle(const char *function) const {
    require(registry.phase == ForceRegistry::Phase::IDLE, function, "a generator may not call this");
}

// ---- Bodies

const World::RigidBodies &World::getBodies() const { return members->getList().bodies; }

void World::addBody(RigidBody *body) {
    requireNonNull(body, "World::addBody", "the body must not be null");
    requireNotParallel("World::addBody");
    require(!members->contains(body), "World::addBody", "the body must not be in the world already");
    members->reserveOneMore();
    faultedBodies.reserve(members->getBodiesAndGaps().capacity());
    append(body);
}

RigidBody *World::createBody() {
    requireNotParallel("World::createBody");
    members->reserveOneMore();
    faultedBodies.reserve(members->getBodiesAndGaps().capacity());
    reserveGrowing(endedBodies, ownedBodies->getCount() + 1);
    RigidBody *const body = ownedBodies->create();
    registry.registrations->prefetchHead(body);  // it will be given forces
    append(body);
    return body;
}

bool World::removeBody(RigidBody *body) {
    requireNonNull(body, "World::removeBody", "the body must not be null");
    require(!ownedBodies->owns(body), "World::removeBody",
            "a body that the world created is ended by destroyBody");
    if (!members->contains(body)) return false;
    detach(body);
    return true;
}

void World::destroyBody(RigidBody *body) {
    requireNonNull(body, "World::destroyBody", "the body must not be null");
    registry.registrations->prefetchHead(body);
    require(members->contains(body) && ownedBodies->owns(body), "World::destroyBody",
            "the body must have been created by this world");
    endBody(body, detach(body));
}

void World::clear() {
    requireIdle("World::clear");
    registry.clear();
    faultedBodies.clear();
    const Members::List &list = members->getList();
    for (std::size_t n = 0; n < list.bodies.size(); ++n)
        if (ownedBodies->owns(list.bodies[n])) endBody(list.bodies[n], list.born[n]);
    members->clear();
    memberRevision = ++memberChanges;
}

/// There must be room for it.
void World::append(RigidBody *body) {
    members->append(body, history->now());
    memberRevision = ++memberChanges;
}

/// Returns when the body was born. Generators that end with it may look at the bodies, or end others.
std::uint64_t World::detach(RigidBody *body) {
    registry.remove(body);
    body->marks.inGenerator = false;
    const auto isBefore = [this](const RigidBody *a, const RigidBody *b) {
        return members->getNumber(a) < members->getNumber(b);
    };
    const auto listed = std::lower_bound(faultedBodies.begin(), faultedBodies.end(), body, isBefore);
    if (listed != faultedBodies.end() && *listed == body) faultedBodies.erase(listed);
    memberRevision = ++memberChanges;
    return members->erase(body);
}

/// For good, unless a snapshot may bring it back.
void World::endBody(RigidBody *body, std::uint64_t born) {
    if (history->needs(born, history->now()))
        endedBodies.push_back({body, born, history->now()});
    else
        ownedBodies->destroy(body);
}

void World::freeEndedBodies() {
    const auto end = std::remove_if(endedBodies.begin(), endedBodies.end(), [this](const EndedBody &ended) {
        if (history->needs(ended.born, ended.died)) return false;
        ownedBodies->destroy(ended.body);
        return true;
    });
    endedBodies.erase(end, endedBodies.end());
}

// ---- Forces

void World::ownForce(std::unique_ptr<ForceGenerator> force, RigidBody *body, RigidBody *other,
                     const char *function) {
    requireNonNull(body, function, "the body must not be null");
    requireNotParallel(function);
    require(members->contains(body) && (other == nullptr || members->contains(other)), function,
            "the body must be in the world");
    registry.own(std::move(force), body, other);
}

void World::destroyForce(ForceGenerator &force) {
    require(registry.isOwned(&force), "World::destroyForce",
            "the generator must have been created by this world");
    registry.remove(&force);
}

// ---- A frame

/// Runs a job over all bodies, in parts, on as many threads as are worth it.
void World::runParts(JobSystem::Job &job, std::size_t least) {
    const std::size_t count = members->getBodiesAndGaps().size();
    const std::size_t parts = (count + PARALLEL_PART - 1) / PARALLEL_PART;
    if (jobs != nullptr && count >= least)
        jobs->parallelFor(parts, job);
    else
        for (std::size_t part = 0; part < parts; ++part) job.run(part);
}

class World::ClearJob : public JobSystem::Job {
public:
    explicit ClearJob(const RigidBodies &all) : bodies(all) {}

    void run(std::size_t part) override {
        const std::size_t end = std::min((part + 1) * PARALLEL_PART, bodies.size());
        constexpr std::size_t AHEAD = 2 * PREFETCH_AHEAD;  // there is little to do meanwhile
        for (std::size_t n = part * PARALLEL_PART; n < end; ++n) {
            if (n + AHEAD < bodies.size()) prefetch(bodies[n + AHEAD], 1);
            if (bodies[n] != nullptr) bodies[n]->clearAccumulators();
        }
    }

private:
    const RigidBodies &bodies;  ///< and gaps
};

void World::startFrame() {
    requireIdle("World::startFrame");
    ClearJob job(members->getBodiesAndGaps());
    runParts(job, std::max(leastForJobs, LEAST_TO_CLEAR));
}

/// While generators that may act on any body are called, whatever is added is theirs. If one throws, it is
/// taken back.
class World::ForcesOnAll {
public:
    explicit ForcesOnAll(World &w) : world(w), needed(w.registry.hasCrossBodyGenerators()) { mark(true); }
    ~ForcesOnAll() {
        mark(false);
        if (!complete) takeBack();
    }
    ForcesOnAll(const ForcesOnAll &) = delete;
    ForcesOnAll &operator=(const ForcesOnAll &) = delete;

    void setComplete() { complete = true; }

private:
    void mark(bool inGenerator) {
        if (!needed) return;
        for (RigidBody *body : world.members->getBodiesAndGaps())
            if (body != nullptr) body->marks.inGenerator = inGenerator;
    }
    void takeBack() {
        for (RigidBody *body : world.members->getBodiesAndGaps()) {
            if (body == nullptr) continue;
            body->generated = Wrench();
            body->hasGenerated = false;
            body->resistance = 0;
        }
    }

    World &world;
    const bool needed;
    bool complete = false;
};

void World::runPhysics(real duration) {
    requireIdle("World::runPhysics");
    requireDuration(duration, "World::runPhysics");
    updateForces(duration);
    integrate(duration);
}

void World::updateForces(real duration) {
    ForcesOnAll forces(*this);
    if (jobs != nullptr && registry.size() >= leastForJobs)
        registry.updateForces(duration, *jobs);
    else
        registry.updateForces(duration);
    forces.setComplete();
}

/// Advances a part of the bodies, on one thread.
class World::IntegrateJob : public JobSystem::Job {
public:
    IntegrateJob(const RigidBodies &all, real h) : bodies(all), duration(h) {}

    bool hasAnyFault() const { return anyFault; }

    void run(std::size_t part) override {
        const std::size_t end = std::min((part + 1) * PARALLEL_PART, bodies.size());
        for (std::size_t begin = part * PARALLEL_PART, runEnd; begin < end; begin = runEnd + 1) {
            runEnd = begin;
            while (runEnd < end && bodies[runEnd] != nullptr) ++runEnd;  // up to a gap
            if (RigidBody::integrate(bodies.data() + begin, runEnd - begin, duration) > 0) anyFault = true;
        }
    }

private:
    const RigidBodies &bodies;  ///< and gaps
    const real duration;
    std::atomic<bool> anyFault{false};
};

void World::integrate(real duration) {
    requireIdle("World::integrate");
    requireDuration(duration, "World::integrate");
    IntegrateJob job(members->getBodiesAndGaps(), duration);

    /// Also when a job has thrown.
    struct AtEnd {
        World &world;
        const IntegrateJob &job;
        ~AtEnd() {
            world.listFaultedBodies(job.hasAnyFault());
            world.freeEndedBodies();
        }
    } const atEnd{*this, job};
    runParts(job, leastForJobs);
}

void World::listFaultedBodies(bool anyNew) {
    const auto isSound = [](const RigidBody *body) { return body == nullptr || !body->hasFaulted(); };
    if (anyNew) faultedBodies = members->getBodiesAndGaps();
    faultedBodies.erase(std::remove_if(faultedBodies.begin(), faultedBodies.end(), isSound),
                        faultedBodies.end());
}

// ---- Threads

void World::setWorkers(std::size_t threadCount) {
    requireIdle("World::setWorkers");
    require(threadCount <= Workers::MAX_THREADS, "World::setWorkers", "there can be at most 256 threads",
            {static_cast<real>(threadCount)});
    std::unique_ptr<Workers> crew;
    if (threadCount > 1) crew = std::make_unique<Workers>(threadCount);
    workers = std::move(crew);
    jobs = workers.get();
    leastForJobs = LEAST_FOR_WORKERS;
}

void World::setJobSystem(JobSystem *hostJobs) {
    requireIdle("World::setJobSystem");
    workers.reset();
    jobs = hostJobs;
    leastForJobs = LEAST_FOR_HOST;
}

}  // namespace cyclone
