#pragma once

/// @file
/// The bodies of a world.
#include <cyclone/body.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "addressmap.h"
#include "mutex.h"

namespace cyclone {
namespace detail {

/// Bodies in the order of adding. Those that leave make gaps, and it takes many of them, or somebody who
/// wants to see the list, to close them: so a body leaves in a time that hardly depends on the number of
/// bodies.
class Members {
public:
    /// What a snapshot keeps, too.
    struct List {
        std::vector<RigidBody *> bodies;     ///< null: a gap
        std::vector<std::uint64_t> numbers;  ///< of each body and gap, ascending
        std::vector<std::uint64_t> born;     ///< see SnapshotHistory
        AddressMap numberOf;                 ///< of each body
        std::uint64_t nextNumber = 0;

        /// Makes as much room as another list has, and takes over what it holds. If memory runs out, nothing
        /// has changed.
        void reserve(const List &other);
        void assign(const List &other);
    };

    /// Makes room for one more. If memory runs out, nothing has changed.
    void reserveOneMore();
    void append(RigidBody *body, std::uint64_t born);
    /// Returns when the body was born.
    std::uint64_t erase(const RigidBody *body);
    void clear();
    void reserve(const List &other) { list.reserve(other); }
    void assign(const List &other) {
        list.assign(other);
        gapCount = 0;
    }

    bool contains(const RigidBody *body) const { return list.numberOf.find(body) != AddressMap::NONE; }
    std::uint64_t getNumber(const RigidBody *body) const { return list.numberOf.find(body); }
    std::size_t size() const { return list.numberOf.size(); }

    const std::vector<RigidBody *> &getBodiesAndGaps() const { return list.bodies; }
    /// Without gaps; may be called by several threads at once.
    const List &getList() const {
        if (gapCount.load(std::memory_order_acquire) > 0) closeGaps();
        return list;
    }

private:
    void closeGaps() const;

    mutable List list;
    mutable Mutex closing;
    mutable std::atomic<std::size_t> gapCount{0};
};

}  // namespace detail
}  // namespace cyclone
