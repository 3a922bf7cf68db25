#include <cyclone/world.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "arguments.h"
#include "loadstates.h"
#include "ownedbodies.h"
#include "worldstructure.h"

namespace cyclone {

using namespace detail;

namespace {

/// The last eight bytes, as they are.
std::uint64_t checksumOf(const Snapshot &snapshot) {
    std::uint64_t checksum = 0;
    if (snapshot.size() >= sizeof checksum)
        std::memcpy(&checksum, snapshot.data() + snapshot.size() - sizeof checksum, sizeof checksum);
    return checksum;
}

}  // namespace

// ---- Saving

bool World::isCurrent(const WorldStructure &structure) const {
    return structure.history == history && structure.memberRevision == memberRevision &&
           structure.registryRevision == registry.revision;
}

/// A structure with room for all that there is: the snapshot's own unless others have a part in it. If memory
/// runs out, nothing has changed.
std::shared_ptr<WorldStructure> World::prepareStructure(const Snapshot &snapshot) const {
    std::shared_ptr<WorldStructure> structure = snapshot.structure;
    if (structure == nullptr || structure->history != history || structure.use_count() > 2)
        structure = std::make_shared<WorldStructure>(history);
    structure->reserve(members->getList(), *registry.registrations);
    history->reserveOneMore();
    return structure;
}

void World::saveState(Snapshot &snapshot) const {
    const Members::List &list = members->getList();
    const bool isNew = snapshot.structure == nullptr || !isCurrent(*snapshot.structure);
    std::shared_ptr<WorldStructure> structure = isNew ? prepareStructure(snapshot) : snapshot.structure;
    writeSnapshot(list.bodies.data(), list.bodies.size(), snapshot);
    if (isNew) {
        structure->take(list, *registry.registrations);
        structure->memberRevision = memberRevision;
        structure->registryRevision = registry.revision;
    }
    snapshot.structure = std::move(structure);
}

// ---- Restoring

/// Null for bytes from elsewhere.
const WorldStructure *World::findStructure(const Snapshot &snapshot) const {
    const WorldStructure *const structure = snapshot.structure.get();
    const bool isOfThis = structure != nullptr && structure->history == history &&
                          snapshot.writtenChecksum == checksumOf(snapshot);
    return isOfThis ? structure : nullptr;
}

void World::restoreState(const Snapshot &snapshot) {
    requireIdle("World::restoreState");
    const WorldStructure *const then = findStructure(snapshot);
    const bool changes = then != nullptr && !isCurrent(*then);
    if (changes) requireCallersPart(*then);
    const std::size_t count = changes ? then->members.bodies.size() : members->size();
    const char *const error = findSnapshotError(snapshot, count);
    require(error == nullptr, "World::restoreState", error);

    if (changes) restoreStructure(*then);
    loadStates(snapshot, getBodies().data(), count);
    listFaultedBodies(true);
    freeEndedBodies();
    registry.deleteEndedGenerators();
}

/// What the caller has taken out may be gone.
void World::requireCallersPart(const WorldStructure &then) const {
    for (RigidBody *body : then.members.bodies)
        require(members->contains(body) || ownedBodies->owns(body), "World::restoreState",
                "the caller's bodies that were in the world must be in it");
    const Registrations &now = *registry.registrations;
    for (std::size_t n = 0; n < then.registrations.getEnd(); ++n)
        require(
            then.registrations.isGap(n) || then.registrations.getDetails(n).isOwned ||
                now.first(Registrations::GENERATOR, then.registrations[n].generator) != Registrations::NONE,
            "World::restoreState", "the caller's generators that were registered must be registered");
}

void World::restoreStructure(const WorldStructure &then) {
    members->reserve(then.members);
    registry.registrations->reserve(then.registrations);

    const auto livedThen = [&then](const RigidBody *body) {
        return then.members.numberOf.find(body) != AddressMap::NONE;
    };
    const Members::List &now = members->getList();
    for (std::size_t n = 0; n < now.bodies.size(); ++n)
        if (!livedThen(now.bodies[n]) && ownedBodies->owns(now.bodies[n]))
            endedBodies.push_back({now.bodies[n], now.born[n], history->now()});
    registry.restore(then.registrations);
    registry.revision = then.registryRevision;
    members->assign(then.members);
    memberRevision = then.memberRevision;
    endedBodies.erase(std::remove_if(endedBodies.begin(), endedBodies.end(),
                                     [&](const EndedBody &ended) { return livedThen(ended.body); }),
                      endedBodies.end());
}

/// Generators of its own end, or come back to life.
void ForceRegistry::restore(const Registrations &then) {
    const auto livedThen = [&then](const ForceGenerator *generator) {
        return then.first(Registrations::GENERATOR, generator) != Registrations::NONE;
    };
    for (std::size_t n = 0; n < registrations->getEnd(); ++n) {
        if (registrations->isGap(n) || !registrations->getDetails(n).isOwned) continue;
        ForceGenerator *const generator = (*registrations)[n].generator;
        if (livedThen(generator) || registrations->first(Registrations::GENERATOR, generator) != n) continue;
        endedGenerators.push_back(
            {std::unique_ptr<ForceGenerator>(generator), registrations->getDetails(n).born, history->now()});
        --ownedCount;
    }
    registrations->assign(then);
    for (EndedGenerator &ended : endedGenerators) {
        if (!livedThen(ended.generator.get())) continue;
        static_cast<void>(ended.generator.release());
        ++ownedCount;
    }
    endedGenerators.erase(
        std::remove_if(endedGenerators.begin(), endedGenerators.end(),
                       [](const EndedGenerator &ended) { return ended.generator == nullptr; }),
        endedGenerators.end());
}

std::uint64_t World::hash() const {
    const RigidBodies &bodies = getBodies();
    const std::uint64_t value =
        (hashStates(bodies.data(), bodies.size()) ^ registry.size()) * 0x9e3779b97f4a7c15;
    return value ^ value >> 32;
}

}  // namespace cyclone
