#pragma once

/// @file
/// What a snapshot remembers of its world besides the bodies' states.
#include <memory>

#include "members.h"
#include "registrations.h"
#include "snapshothistory.h"

namespace cyclone {
namespace detail {

/// Which bodies and registrations a world had: plain copies of its own tables, so that taking one and
/// returning to one is a matter of copying memory.
struct WorldStructure {
    explicit WorldStructure(const std::shared_ptr<SnapshotHistory> &h) : history(h) {}
    ~WorldStructure() {
        if (time != 0) history->drop(time);
    }
    WorldStructure(const WorldStructure &) = delete;
    WorldStructure &operator=(const WorldStructure &) = delete;

    /// Makes room for a world's tables, and copies them.
    void reserve(const Members::List &itsMembers, const Registrations &itsRegistrations) {
        members.reserve(itsMembers);
        registrations.reserve(itsRegistrations);
    }
    void take(const Members::List &itsMembers, const Registrations &itsRegistrations) {
        if (time != 0) history->drop(time);
        time = history->save();
        members.assign(itsMembers);
        registrations.assign(itsRegistrations);
    }

    const std::shared_ptr<SnapshotHistory> history;  ///< tells which world it is
    std::uint64_t time = 0;                          ///< in the history; 0: not saved yet
    std::uint64_t memberRevision = 0, registryRevision = 0;
    Members::List members;
    Registrations registrations;
};

}  // namespace detail
}  // namespace cyclone
