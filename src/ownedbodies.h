#pragma once

/// @file
/// Storage of the bodies that a world owns.
#include <cyclone/world.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "compiler.h"

namespace cyclone {

/// Slabs of bodies, of growing size. A body's place is used again after its end, the oldest first: a pointer
/// that a game has forgotten to drop points to a body that is gone for as long as possible.
class World::Bodies {
public:
    RigidBody *create() {
        if (freeCount == 0) addSlab();
        RigidBody *const body = freePlaces[nextFree];
        nextFree = (nextFree + 1) % freePlaces.size();
        --freeCount;
        *body = RigidBody();
        if (freeCount > 0) detail::prefetch(freePlaces[nextFree], sizeof(RigidBody));
        return body;
    }
    void destroy(RigidBody *body) {
        freePlaces[(nextFree + freeCount) % freePlaces.size()] = body;
        ++freeCount;
    }
    bool owns(const RigidBody *body) const {
        return std::any_of(slabs.begin(), slabs.end(), [body](const Slab &slab) {
            const std::less<const RigidBody *> before;
            return !before(body, slab.bodies.get()) && before(body, slab.bodies.get() + slab.size);
        });
    }
    /// Those that have been created and not destroyed.
    std::size_t getCount() const { return freePlaces.size() - freeCount; }

private:
    struct Slab {
        std::unique_ptr<RigidBody[]> bodies;
        std::size_t size;
    };

    /// As large as all before it together, when no place is free. Its places are taken from the first to the
    /// last.
    void addSlab() {
        const std::size_t size = std::max<std::size_t>(64, freePlaces.size());
        slabs.reserve(slabs.size() + 1);
        std::vector<RigidBody *> places(freePlaces.size() + size);
        slabs.push_back({std::make_unique<RigidBody[]>(size), size});
        for (std::size_t n = 0; n < size; ++n) places[n] = &slabs.back().bodies[n];
        freePlaces = std::move(places);
        nextFree = 0;
        freeCount = size;
    }

    std::vector<Slab> slabs;
    std::vector<RigidBody *> freePlaces;  ///< a ring with room for every place
    std::size_t nextFree = 0, freeCount = 0;
};

}  // namespace cyclone
