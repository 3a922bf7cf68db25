#pragma once

/// @file
/// Which snapshots of a world are still kept: while one can bring an object back, the object must not end.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "growing.h"
#include "mutex.h"

namespace cyclone {
namespace detail {

/// Time is counted in snapshots. An object that lived from `born` to `died` is in the snapshots that were
/// saved after the one and up to the other. Snapshots may be dropped on any thread, and outlive the world.
class SnapshotHistory {
public:
    /// The number of snapshots so far.
    std::uint64_t now() const { return count; }

    /// Makes room for another snapshot. If memory runs out, nothing has changed.
    void reserveOneMore() {
        const Lock lock(mutex);
        reserveGrowing(kept, kept.size() + 1);
    }
    /// Another snapshot: its time, to be given back to drop().
    std::uint64_t save() {
        const Lock lock(mutex);
        kept.push_back(++count);
        return count;
    }
    void drop(std::uint64_t time) {
        const Lock lock(mutex);
        kept.erase(std::lower_bound(kept.begin(), kept.end(), time));
    }
    /// Whether a snapshot is kept in which such an object lived.
    bool needs(std::uint64_t born, std::uint64_t died) const {
        const Lock lock(mutex);
        const auto next = std::upper_bound(kept.begin(), kept.end(), born);
        return next != kept.end() && *next <= died;
    }

private:
    mutable Mutex mutex;
    std::vector<std::uint64_t> kept;  ///< ascending
    std::uint64_t count = 0;          ///< changed by the world's own thread only
};

}  // namespace detail
}  // namespace cyclone
