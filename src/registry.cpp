#include <cyclone/force.h>
#include <cyclone/jobs.h>

#include <algorithm>
#include <functional>

#include "arguments.h"
#include "compiler.h"

namespace cyclone {

using namespace detail;

void ForceRegistry::add(RigidBody *body, ForceGenerator *generator) {
    requireNonNull(body, "ForceRegistry::add", "the body must not be null");
    requireNonNull(generator, "ForceRegistry::add", "the generator must not be null");
    require(!sharing, "ForceRegistry::add",
            "a generator that acts on its body only may not add registrations");
    registrations.push_back({body, generator, generator->actsOnItsBodyOnly()});
    if (!registrations.back().actsOnItsBodyOnly) ++outreachingCount;
    schedule.reserve(registrations.capacity());
    scheduleIsCurrent = false;
}

void ForceRegistry::remove(RigidBody *body, ForceGenerator *generator) {
    require(!sharing, "ForceRegistry::remove",
            "a generator that acts on its body only may not change registrations");
    requireNonNull(body, "ForceRegistry::remove", "the body must not be null");
    requireNonNull(generator, "ForceRegistry::remove", "the generator must not be null");
    for (std::size_t n = 0; n < registrations.size(); ++n)
        if (registrations[n].body == body && registrations[n].generator == generator) return erase(n);
}

void ForceRegistry::remove(RigidBody *body) {
    require(!sharing, "ForceRegistry::remove",
            "a generator that acts on its body only may not change registrations");
    requireNonNull(body, "ForceRegistry::remove", "the body must not be null");
    for (std::size_t n = registrations.size(); n-- > 0;)
        if (registrations[n].body == body) erase(n);
}

void ForceRegistry::erase(std::size_t index) {
    if (!registrations[index].actsOnItsBodyOnly) --outreachingCount;
    if (updating) {
        registrations[index].body = nullptr;
        ++removedCount;
    } else {
        registrations.erase(registrations.begin() + static_cast<std::ptrdiff_t>(index));
        scheduleIsCurrent = false;
    }
}

void ForceRegistry::clear() {
    require(!updating, "ForceRegistry::clear", "a generator may not clear the registry");
    registrations.clear();
    outreachingCount = 0;
    scheduleIsCurrent = false;
}

/// Keeps the registrations in place while generators are called, and sweeps out the removed ones at the end.
class ForceRegistry::Update {
public:
    Update(ForceRegistry &r, real duration) : registry(r) {
        require(!registry.updating, "ForceRegistry::updateForces", "a generator may not update the forces");
        requireDuration(duration, "ForceRegistry::updateForces");
        registry.updating = true;
    }
    ~Update() {
        registry.updating = registry.sharing = false;
        if (registry.removedCount == 0) return;
        auto &all = registry.registrations;
        all.erase(
            std::remove_if(all.begin(), all.end(), [](const Registration &r) { return r.body == nullptr; }),
            all.end());
        registry.removedCount = 0;
        registry.scheduleIsCurrent = false;
    }
    Update(const Update &) = delete;
    Update &operator=(const Update &) = delete;

private:
    ForceRegistry &registry;
};

void ForceRegistry::updateForces(real duration) {
    const Update update(*this, duration);
    const std::size_t count = registrations.size();
    for (std::size_t n = 0; n < count; ++n) {
        if (n + PREFETCH_AHEAD < count) prefetchFor(registrations[n + PREFETCH_AHEAD]);
        callGenerator(n, duration);
    }
}

/// Most generators fit into two cache lines and read a body's transform, velocity and rotation.
void ForceRegistry::prefetchFor(const Registration &registration) {
    prefetch(registration.body, offsetof(RigidBody, orientation));
    prefetch(registration.generator, 128);
}

void ForceRegistry::callGenerator(std::size_t index, real duration) {
    const Registration called = registrations[index];
    if (called.body == nullptr) return;

    /// Tells the body whose forces it is being given. The generator may end its own registration, and the
    /// body with it.
    struct Marker {
        const ForceRegistry &registry;
        std::size_t index;
        RigidBody *body;
        bool wasInGenerator;
        ~Marker() {
            if (registry.registrations[index].body == body) body->marks.inGenerator = wasInGenerator;
        }
    } const marker{*this, index, called.body, called.body->marks.inGenerator};
    called.body->marks.inGenerator = true;
    called.generator->updateForce(called.body, duration);
}

/// A part of a run, on one thread; parts meet between two bodies.
class ForceRegistry::Share : public JobSystem::Job {
public:
    static constexpr std::size_t SIZE = 256;

    Share(ForceRegistry &r, std::size_t begin, std::size_t end, real h)
        : registry(r), runBegin(begin), runEnd(end), duration(h) {}

    void run(std::size_t part) override {
        const std::size_t end = boundary(part + 1);
        for (std::size_t n = boundary(part); n < end; ++n) {
            if (n + PREFETCH_AHEAD < end)
                prefetchFor(registry.registrations[registry.schedule[n + PREFETCH_AHEAD].index]);
            registry.callGenerator(registry.schedule[n].index, duration);
        }
    }

private:
    std::size_t boundary(std::size_t part) const {
        std::size_t n = std::min(runBegin + part * SIZE, runEnd);
        while (n > runBegin && n < runEnd && registry.schedule[n].body == registry.schedule[n - 1].body) ++n;
        return n;
    }

    ForceRegistry &registry;
    std::size_t runBegin, runEnd;
    real duration;
};

void ForceRegistry::updateForces(real duration, JobSystem &jobs) {
    const Update update(*this, duration);
    if (!scheduleIsCurrent) renewSchedule();
    const std::size_t count = schedule.size();
    for (std::size_t begin = 0; begin < count;) {
        const std::size_t end = endOfRun(begin);
        if (registrations[begin].actsOnItsBodyOnly) {
            Share share(*this, begin, end, duration);
            sharing = true;
            jobs.parallelFor((end - begin + Share::SIZE - 1) / Share::SIZE, share);
            sharing = false;
        } else {
            for (std::size_t n = begin; n < end; ++n) callGenerator(n, duration);
        }
        begin = end;
    }
}

std::size_t ForceRegistry::endOfRun(std::size_t begin) const {
    std::size_t end = begin + 1;
    while (end < schedule.size() &&
           registrations[end].actsOnItsBodyOnly == registrations[begin].actsOnItsBodyOnly)
        ++end;
    return end;
}

void ForceRegistry::renewSchedule() {
    schedule.clear();
    for (std::size_t n = 0; n < registrations.size(); ++n) schedule.push_back({registrations[n].body, n});
    for (std::size_t begin = 0; begin < schedule.size();) {
        const std::size_t end = endOfRun(begin);
        const auto first = schedule.begin();
        if (registrations[begin].actsOnItsBodyOnly)
            std::sort(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(end),
                      [](const Turn &a, const Turn &b) {
                          if (a.body != b.body) return std::less<const RigidBody *>()(a.body, b.body);
                          return a.index < b.index;
                      });
        begin = end;
    }
    scheduleIsCurrent = true;
}

}  // namespace cyclone
