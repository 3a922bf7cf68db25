#include <cyclone/force.h>
#include <cyclone/jobs.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "arguments.h"
#include "compiler.h"
#include "growing.h"
#include "parallel.h"
#include "registrations.h"
#include "snapshothistory.h"

namespace cyclone {

using namespace detail;

ForceRegistry::ForceRegistry() : registrations(std::make_unique<Registrations>()) {}

ForceRegistry::~ForceRegistry() {
    history.reset();
    clear();
}

std::size_t ForceRegistry::size() const { return registrations->size(); }

bool ForceRegistry::hasCrossBodyGenerators() const { return registrations->getCrossBodyCount() > 0; }

// ---- Adding and removing

void ForceRegistry::requireNotParallel(const char *function) const {
    require(phase != Phase::PARALLEL, function,
            "a generator that acts on its body only may not change registrations");
}

void ForceRegistry::add(RigidBody *body, ForceGenerator *generator) {
    requireNonNull(body, "ForceRegistry::add", "the body must not be null");
    requireNonNull(generator, "ForceRegistry::add", "the generator must not be null");
    requireNotParallel("ForceRegistry::add");
    registrations->reserveMore(1);
    RegistrationDetails its = describe(body, generator);
    const std::size_t known = registrations->first(Registrations::GENERATOR, generator);
    if (known != Registrations::NONE) {
        its.isOwned = registrations->getDetails(known).isOwned;
        its.born = registrations->getDetails(known).born;
    } else if (phase == Phase::SERIAL) {
        its.isOwned = revive(generator, its.born);
    }
    append(body, generator, its);
}

/// Takes the generator over, to end with its last registration. The second body may be null.
void ForceRegistry::own(std::unique_ptr<ForceGenerator> generator, RigidBody *body, RigidBody *second) {
    reserveGrowing(endedGenerators, endedGenerators.size() + ownedCount + 1);
    registrations->reserveMore(2);
    RegistrationDetails its = describe(body, generator.get());
    its.isOwned = true;
    its.born = history->now();
    RegistrationDetails mirrored = its;
    if (second != nullptr) mirrored.otherBody = generator->getOtherBody(second);

    ForceGenerator *const owned = generator.release();
    ++ownedCount;
    append(body, owned, its);
    if (second != nullptr) append(second, owned, mirrored);
}

RegistrationDetails ForceRegistry::describe(const RigidBody *body, const ForceGenerator *generator) {
    return {generator->getOtherBody(body), 0, generator->actsOnItsBodyOnly(), false};
}

void ForceRegistry::append(RigidBody *body, ForceGenerator *generator, const RegistrationDetails &its) {
    registrations->append({body, generator}, its);
    revision = ++changes;
}

bool ForceRegistry::isOwned(const ForceGenerator *generator) const {
    const std::size_t index = registrations->first(Registrations::GENERATOR, generator);
    return index != Registrations::NONE && registrations->getDetails(index).isOwned;
}

void ForceRegistry::remove(RigidBody *body, ForceGenerator *generator) {
    requireNotParallel("ForceRegistry::remove");
    requireNonNull(body, "ForceRegistry::remove", "the body must not be null");
    requireNonNull(generator, "ForceRegistry::remove", "the generator must not be null");
    std::size_t n = registrations->first(Registrations::BODY, body);
    while (n != Registrations::NONE && (*registrations)[n].generator != generator)
        n = registrations->next(Registrations::BODY, n);
    if (n != Registrations::NONE) end(n);
}

void ForceRegistry::remove(RigidBody *body) {
    requireNotParallel("ForceRegistry::remove");
    requireNonNull(body, "ForceRegistry::remove", "the body must not be null");
    for (Registrations::Role role : {Registrations::BODY, Registrations::OTHER_BODY})
        for (std::size_t n; (n = registrations->first(role, body)) != Registrations::NONE;) end(n);
}

void ForceRegistry::remove(ForceGenerator *generator) {
    requireNotParallel("ForceRegistry::remove");
    requireNonNull(generator, "ForceRegistry::remove", "the generator must not be null");
    for (std::size_t n;
         (n = registrations->first(Registrations::GENERATOR, generator)) != Registrations::NONE;)
        end(n);
}

void ForceRegistry::clear() {
    require(phase == Phase::IDLE, "ForceRegistry::clear", "a generator may not clear the registry");
    phase = Phase::SERIAL;  // everything stays in place meanwhile
    for (std::size_t n = 0; n < registrations->getEnd(); ++n)
        if (!registrations->isGap(n)) end(n);
    registrations->clear();
    phase = Phase::IDLE;
    deleteEndedGenerators();
}

void ForceRegistry::end(std::size_t index) {
    ForceGenerator *const generator = (*registrations)[index].generator;
    const RegistrationDetails its = registrations->getDetails(index);
    registrations->erase(index);
    revision = ++changes;
    if (phase == Phase::IDLE && registrations->areGapsMany()) registrations->closeGaps();
    if (its.isOwned && registrations->first(Registrations::GENERATOR, generator) == Registrations::NONE)
        endGenerator(generator, its.born);
}

// ---- The end of generators

bool ForceRegistry::mayComeBack(std::uint64_t born, std::uint64_t died) const {
    return history != nullptr && history->needs(born, died);
}

/// At once, unless it may be running now, or come back.
void ForceRegistry::endGenerator(ForceGenerator *generator, std::uint64_t born) {
    std::unique_ptr<ForceGenerator> its(generator);
    const std::uint64_t died = history != nullptr ? history->now() : 0;
    --ownedCount;
    if (phase != Phase::IDLE || mayComeBack(born, died))
        endedGenerators.push_back({std::move(its), born, died});
}

/// Whether the generator was the registry's own and has ended, in this very update; now it lives on.
bool ForceRegistry::revive(ForceGenerator *generator, std::uint64_t &born) {
    for (EndedGenerator &ended : endedGenerators) {
        if (ended.generator.get() != generator) continue;
        born = ended.born;
        static_cast<void>(ended.generator.release());
        ++ownedCount;
        std::swap(ended, endedGenerators.back());
        endedGenerators.pop_back();
        return true;
    }
    return false;
}

/// Generators may have destructors that end others.
void ForceRegistry::deleteEndedGenerators() {
    for (std::size_t n = 0; n < endedGenerators.size();) {
        if (mayComeBack(endedGenerators[n].born, endedGenerators[n].died)) {
            ++n;
            continue;
        }
        const std::unique_ptr<ForceGenerator> last = std::move(endedGenerators[n].generator);
        std::swap(endedGenerators[n], endedGenerators.back());
        endedGenerators.pop_back();
    }
}

// ---- Calling them

/// Keeps the registrations in place while generators are called.
class ForceRegistry::Update {
public:
    Update(ForceRegistry &r, real duration) : registry(r) {
        require(registry.phase == Phase::IDLE, "ForceRegistry::updateForces",
                "a generator may not update the forces");
        requireDuration(duration, "ForceRegistry::updateForces");
        registry.phase = Phase::SERIAL;
        registry.anyMayBeStiff = false;
    }
    ~Update() {
        registry.phase = Phase::IDLE;
        if (registry.registrations->areGapsMany()) registry.registrations->closeGaps();
        registry.deleteEndedGenerators();
    }
    Update(const Update &) = delete;
    Update &operator=(const Update &) = delete;

private:
    ForceRegistry &registry;
};

namespace {

bool isShortlyAfter(const RigidBody *first, const RigidBody *second) {
    const std::uintptr_t distance =
        reinterpret_cast<std::uintptr_t>(second) - reinterpret_cast<std::uintptr_t>(first);
    return distance > 0 && distance <= 2 * sizeof(RigidBody);
}

}  // namespace

/// Most generators fit into three cache lines and read a body's transform, velocity and rotation. Of bodies
/// that follow each other in memory the first line is enough: processors then go on by themselves, and being
/// asked for more stops them. Inline, for the compiler leaves out calls of a function that does nothing but
/// prefetch.
CYCLONE_INLINE void ForceRegistry::prefetchFor(std::size_t index) const {
    const Registrations::Call &call = (*registrations)[index];
    const RigidBody *const before = (*registrations)[index - 1].body;
    if (call.body == nullptr) return;
    if (isShortlyAfter(before, call.body)) {
        prefetch(call.body, 1);
        prefetch(call.generator, 1);
    } else {
        prefetch(call.body, offsetof(RigidBody, rotation));
        prefetch(call.generator, 192);
    }
}

void ForceRegistry::updateForces(real duration) {
    const Update update(*this, duration);
    callInOrder(0, registrations->getEnd(), duration);
    if (anyMayBeStiff) resist(0, registrations->getEnd(), duration);
}

void ForceRegistry::callInOrder(std::size_t begin, std::size_t end, real duration) {
    for (std::size_t n = begin; n < end; ++n) {
        if (n + PREFETCH_AHEAD < end) prefetchFor(n + PREFETCH_AHEAD);
        callGenerator(n, duration);
    }
}

void ForceRegistry::callGenerator(std::size_t index, real duration) {
    const Registrations::Call called = (*registrations)[index];
    if (called.body == nullptr) return;

    /// Tells the body whose forces it is being given. The generator may end its own registration, and the
    /// body with it.
    struct Marker {
        ForceRegistry &registry;
        std::size_t index;
        RigidBody *body;
        real duration;
        bool wasInGenerator;
        ~Marker() {
            if ((*registry.registrations)[index].body != body) return;
            body->marks.inGenerator = wasInGenerator;
            if (body->mayBeStiff(duration)) registry.anyMayBeStiff.store(true, std::memory_order_relaxed);
        }
    } const marker{*this, index, called.body, duration, called.body->marks.inGenerator};
    called.body->marks.inGenerator = true;
    called.generator->updateForce(called.body, duration);
}

/// Makes the step implicit of those bodies whose first registration is one of these and whose generators
/// resist too strongly together.
void ForceRegistry::resist(std::size_t begin, std::size_t end, real duration) {
    for (std::size_t n = begin; n < end; ++n) {
        RigidBody *const body = (*registrations)[n].body;
        if (body == nullptr || !registrations->isFirstOfBodySince(0, n) || !body->awake ||
            !body->mayBeStiff(duration))
            continue;
        Resistance sum;
        for (std::size_t its = n; its != Registrations::NONE;
             its = registrations->next(Registrations::BODY, its))
            (*registrations)[its].generator->addResistance(*body, sum);
        body->resist(sum, duration);
    }
}

/// A part of a run of generators that act on their body only, on one thread. It takes the bodies whose first
/// registration in the run is in this part, each with all its registrations in the run.
class ForceRegistry::ParallelJob : public JobSystem::Job {
public:
    ParallelJob(ForceRegistry &r, std::size_t begin, std::size_t end, real h)
        : registry(r), runBegin(begin), runEnd(end), duration(h) {}

    std::size_t getPartCount() const { return (runEnd - runBegin + PARALLEL_PART - 1) / PARALLEL_PART; }

    void run(std::size_t part) override {
        const Registrations &table = *registry.registrations;
        const std::size_t begin = runBegin + part * PARALLEL_PART,
                          end = std::min(begin + PARALLEL_PART, runEnd);
        for (std::size_t n = begin; n < end; ++n) {
            if (n + PREFETCH_AHEAD < end) registry.prefetchFor(n + PREFETCH_AHEAD);
            if (table.isGap(n) || !table.isFirstOfBodySince(runBegin, n)) continue;
            for (std::size_t its = n; its < runEnd; its = table.next(Registrations::BODY, its))
                registry.callGenerator(its, duration);
        }
    }

private:
    ForceRegistry &registry;
    const std::size_t runBegin, runEnd;
    const real duration;
};

/// A part of resist(), on one thread.
class ForceRegistry::ResistJob : public JobSystem::Job {
public:
    ResistJob(ForceRegistry &r, real h) : registry(r), end(r.registrations->getEnd()), duration(h) {}

    std::size_t getPartCount() const { return (end + PARALLEL_PART - 1) / PARALLEL_PART; }

    void run(std::size_t part) override {
        const std::size_t begin = part * PARALLEL_PART;
        registry.resist(begin, std::min(begin + PARALLEL_PART, end), duration);
    }

private:
    ForceRegistry &registry;
    const std::size_t end;
    const real duration;
};

void ForceRegistry::updateForces(real duration, JobSystem &jobs) {
    const Update update(*this, duration);
    const std::size_t end = registrations->getEnd();
    for (std::size_t begin = 0, runEnd; begin < end; begin = runEnd) {
        runEnd = endOfRun(begin, end);
        if (!registrations->getDetails(begin).actsOnItsBodyOnly) {
            callInOrder(begin, runEnd, duration);
            continue;
        }
        phase = Phase::PARALLEL;
        ParallelJob job(*this, begin, runEnd, duration);
        if (runEnd - begin <= PARALLEL_PART)
            callInOrder(begin, runEnd, duration);
        else
            jobs.parallelFor(job.getPartCount(), job);
        phase = Phase::SERIAL;
    }
    if (!anyMayBeStiff) return;
    if (end <= PARALLEL_PART) return resist(0, end, duration);
    phase = Phase::PARALLEL;
    ResistJob job(*this, duration);
    jobs.parallelFor(job.getPartCount(), job);
}

/// The end of the run of registrations that begins here: all of them act on their body only, or none does.
std::size_t ForceRegistry::endOfRun(std::size_t begin, std::size_t end) const {
    const bool kind = registrations->getDetails(begin).actsOnItsBodyOnly;
    if (kind && registrations->getCrossBodyCount() == 0) return end;
    std::size_t n = begin + 1;
    while (n < end && (registrations->isGap(n) || registrations->getDetails(n).actsOnItsBodyOnly == kind))
        ++n;
    return n;
}

}  // namespace cyclone
