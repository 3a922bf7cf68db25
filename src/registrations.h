#pragma once

/// @file
/// Which generator acts on which body: the table behind ForceRegistry.
#include <cyclone/force.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "addressmap.h"

namespace cyclone {
namespace detail {

/// What is known of a registration besides its body and generator.
struct RegistrationDetails {
    const RigidBody *otherBody;  ///< null: none
    std::uint64_t born;          ///< when the generator was, see SnapshotHistory
    bool actsOnItsBodyOnly;      ///< as the generator said when it was added
    bool isOwned;                ///< the generator belongs to the registry
};

/// Registrations in the order of adding. Those that end leave gaps, so that the others keep their indices;
/// closeGaps() moves them together. Three sets of rings, linked by index in that same order, find all
/// registrations of a body, of a generator, and of those that refer to a body as their other one: ending them
/// takes time in proportion to their number, whatever the size of the table.
class Registrations {
public:
    /// Read in every frame, so kept apart from the rest.
    struct Call {
        RigidBody *body;  ///< null: a gap
        ForceGenerator *generator;
    };
    enum Role { BODY, GENERATOR, OTHER_BODY };

    static constexpr std::size_t NONE = ~std::size_t(0);

    /// Makes room for so many more. If memory runs out, nothing has changed.
    void reserveMore(std::size_t count);
    void append(const Call &call, const RegistrationDetails &its);
    void erase(std::size_t index);
    void clear();
    /// Makes as much room as the other has, and takes over what it holds.
    void reserve(const Registrations &other);
    void assign(const Registrations &other);

    /// Gaps included.
    std::size_t getEnd() const { return calls.size(); }
    std::size_t size() const { return calls.size() - gapCount; }
    const Call &operator[](std::size_t index) const { return calls[index]; }
    const RegistrationDetails &getDetails(std::size_t index) const { return details[index]; }
    bool isGap(std::size_t index) const { return calls[index].body == nullptr; }
    /// How many may act on other bodies than the one they are called for.
    std::size_t getCrossBodyCount() const { return crossBodyCount; }

    /// The oldest registration in which the object has this role; NONE without one.
    std::size_t first(Role role, const void *object) const {
        return static_cast<std::size_t>(rings[role].heads.find(object));
    }
    /// Has memory ready for finding the body's registrations, and for adding some.
    void prefetchHead(const RigidBody *body) const { rings[BODY].heads.prefetch(body); }
    /// The next younger one of the same object; NONE after the youngest.
    std::size_t next(Role role, std::size_t index) const {
        const std::size_t following = rings[role].links[index].next;
        return following > index ? following : NONE;
    }
    /// Whether its body has no other registration from `begin` up to this one.
    bool isFirstOfBodySince(std::size_t begin, std::size_t index) const {
        const std::size_t previous = rings[BODY].links[index].previous;
        return previous >= index || previous < begin;
    }

    bool areGapsMany() const { return gapCount > 64 + size() / 2; }
    void closeGaps();

private:
    /// Circular: the oldest follows on the youngest.
    struct Link {
        std::uint32_t next, previous;
    };
    struct Ring {
        std::vector<Link> links;
        AddressMap heads;
    };

    const void *keyOf(Role role, std::size_t index) const;
    void link(Role role, std::size_t index);
    void unlink(Role role, std::size_t index);
    void move(std::size_t from, std::size_t to);

    static constexpr Role ROLES[] = {BODY, GENERATOR, OTHER_BODY};

    std::vector<Call> calls;
    std::vector<RegistrationDetails> details;
    std::array<Ring, 3> rings;
    std::size_t gapCount = 0, crossBodyCount = 0;
};

}  // namespace detail
}  // namespace cyclone
