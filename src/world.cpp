#include <cyclone/world.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <utility>

#include "arguments.h"

namespace cyclone {

using namespace detail;

// ---- Bodies

/// Slabs of bodies, of growing size; a body's place is used again after its end.
class World::Bodies {
public:
    RigidBody *create() {
        if (freePlaces.empty()) addSlab();
        RigidBody *body = freePlaces.back();
        freePlaces.pop_back();
        *body = RigidBody();
        return body;
    }
    bool owns(const RigidBody *body) const {
        return std::any_of(slabs.begin(), slabs.end(), [body](const Slab &slab) {
            const std::less<const RigidBody *> before;
            return !before(body, slab.bodies.get()) && before(body, slab.bodies.get() + slab.size);
        });
    }
    void destroy(RigidBody *body) { freePlaces.push_back(body); }

private:
    struct Slab {
        std::unique_ptr<RigidBody[]> bodies;
        std::size_t size;
    };

    /// As large as all before it together. Its places are taken from the first to the last.
    void addSlab() {
        const std::size_t size = std::max<std::size_t>(64, placeCount);
        freePlaces.reserve(placeCount + size);
        slabs.push_back({std::make_unique<RigidBody[]>(size), size});
        placeCount += size;
        for (std::size_t n = size; n-- > 0;) freePlaces.push_back(&slabs.back().bodies[n]);
    }

    std::vector<Slab> slabs;
    std::size_t placeCount = 0;
    std::vector<RigidBody *> freePlaces;
};

World::World() : ownedBodies(std::make_unique<Bodies>()) {}
World::~World() = default;

void World::requireUnshared(const char *function) const {
    require(!registry.isShared(), function,
            "a generator that acts on its body only may not change the bodies");
}

void World::requireIdle(const char *function) const {
    require(!registry.isUpdating(), function, "a generator may not call this");
}

void World::addBody(RigidBody *body) {
    requireNonNull(body, "World::addBody", "the body must not be null");
    requireUnshared("World::addBody");
    require(members.count(body) == 0, "World::addBody", "the body must not be in the world already");
    bodies.push_back(body);
    faultedBodies.reserve(bodies.capacity());
    members.insert(body);
}

RigidBody *World::createBody() {
    requireUnshared("World::createBody");
    RigidBody *body = ownedBodies->create();
    addBody(body);
    return body;
}

bool World::removeBody(RigidBody *body) {
    requireNonNull(body, "World::removeBody", "the body must not be null");
    require(!ownedBodies->owns(body), "World::removeBody",
            "a body that the world created is ended by destroyBody");
    if (members.count(body) == 0) return false;
    takeOut(body);
    return true;
}

void World::destroyBody(RigidBody *body) {
    requireNonNull(body, "World::destroyBody", "the body must not be null");
    require(members.count(body) == 1 && ownedBodies->owns(body), "World::destroyBody",
            "the body must have been created by this world");
    takeOut(body);
    ownedBodies->destroy(body);
}

void World::takeOut(RigidBody *body) {
    registry.remove(body);
    body->marks.inGenerator = false;
    members.erase(body);
    bodies.erase(std::find(bodies.begin(), bodies.end(), body));
    faultedBodies.erase(std::remove(faultedBodies.begin(), faultedBodies.end(), body), faultedBodies.end());
}

// ---- A frame

void World::startFrame() {
    requireIdle("World::startFrame");
    for (RigidBody *body : bodies) body->clearAccumulators();
}

/// While generators that may act on any body are called, whatever is added is theirs.
class World::ForcesOnAll {
public:
    explicit ForcesOnAll(World &w) : world(w), needed(w.registry.hasOutreachingGenerators()) { mark(true); }
    ~ForcesOnAll() { mark(false); }
    ForcesOnAll(const ForcesOnAll &) = delete;
    ForcesOnAll &operator=(const ForcesOnAll &) = delete;

private:
    void mark(bool inGenerator) {
        if (!needed) return;
        for (RigidBody *body : world.bodies) body->marks.inGenerator = inGenerator;
    }

    World &world;
    const bool needed;
};

void World::runPhysics(real duration) {
    requireIdle("World::runPhysics");
    requireDuration(duration, "World::runPhysics");
    updateForces(duration);
    integrate(duration);
}

void World::updateForces(real duration) {
    const ForcesOnAll forces(*this);
    if (jobs != nullptr)
        registry.updateForces(duration, *jobs);
    else
        registry.updateForces(duration);
}

/// Advances a part of the bodies, on one thread.
class World::Advance : public JobSystem::Job {
public:
    static constexpr std::size_t SIZE = 256;

    Advance(const RigidBodies &all, real h) : bodies(all), duration(h) {}

    void run(std::size_t part) override {
        const std::size_t begin = part * SIZE;
        const std::size_t count = std::min(SIZE, bodies.size() - begin);
        if (RigidBody::integrate(bodies.data() + begin, count, duration) > 0) anyFault = true;
    }
    bool hasAnyFault() const { return anyFault; }

private:
    const RigidBodies &bodies;
    real duration;
    std::atomic<bool> anyFault{false};
};

void World::integrate(real duration) {
    requireIdle("World::integrate");
    requireDuration(duration, "World::integrate");
    Advance advance(bodies, duration);
    const std::size_t parts = (bodies.size() + Advance::SIZE - 1) / Advance::SIZE;
    if (jobs != nullptr)
        jobs->parallelFor(parts, advance);
    else
        for (std::size_t part = 0; part < parts; ++part) advance.run(part);
    listFaultedBodies(advance.hasAnyFault());
}

void World::listFaultedBodies(bool anyNew) {
    const auto isSound = [](const RigidBody *body) { return !body->hasFaulted(); };
    if (anyNew) faultedBodies = bodies;
    faultedBodies.erase(std::remove_if(faultedBodies.begin(), faultedBodies.end(), isSound),
                        faultedBodies.end());
}

// ---- Saving and restoring

void World::saveState(Snapshot &snapshot) const { writeSnapshot(bodies.data(), bodies.size(), snapshot); }

void World::restoreState(const Snapshot &snapshot) {
    requireIdle("World::restoreState");
    readSnapshot(snapshot, bodies.data(), bodies.size(), "World::restoreState");
    listFaultedBodies(true);
}

std::uint64_t World::hash() const { return hashStates(bodies.data(), bodies.size()); }

// ---- Threads

void World::setWorkers(std::size_t threadCount) {
    requireIdle("World::setWorkers");
    require(threadCount <= Workers::MAX_THREADS, "World::setWorkers", "there can be at most 256 threads",
            {static_cast<real>(threadCount)});
    std::unique_ptr<Workers> crew;
    if (threadCount > 1) crew = std::make_unique<Workers>(threadCount);
    workers = std::move(crew);
    jobs = workers.get();
}

void World::setJobSystem(JobSystem *hostJobs) {
    requireIdle("World::setJobSystem");
    workers.reset();
    jobs = hostJobs;
}

}  // namespace cyclone
