#pragma once

/// @file
/// Numbers found by the address of an object.
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cyclone {
namespace detail {

/// An open-addressing hash table with linear probing. It allocates in reserve() only: what has been reserved
/// can be set, erased and set again without failing.
class AddressMap {
public:
    static constexpr std::uint64_t NONE = ~std::uint64_t(0);

    /// Makes room for `count` addresses. If memory runs out, nothing has changed.
    void reserve(std::size_t count);
    /// The number of this address; NONE without one.
    std::uint64_t find(const void *address) const;
    /// Has memory ready for what follows with this address.
    void prefetch(const void *address) const;
    /// Gives the address its number, or another one.
    void set(const void *address, std::uint64_t number);
    void erase(const void *address);
    void clear();
    /// Takes over what the other holds, without allocating if reserve(other.capacity()) has been called.
    void assign(const AddressMap &other);
    std::size_t size() const { return used; }
    /// How many addresses there is room for.
    std::size_t capacity() const { return 2 * slots.size() / 3; }

private:
    struct Slot {
        const void *address = nullptr;
        std::uint64_t number = NONE;
    };

    std::size_t homeOf(const void *address) const;
    std::size_t slotOf(const void *address) const;

    std::vector<Slot> slots;  ///< a power of two of them, at most two thirds in use
    std::size_t used = 0;
    int shift = 64;
};

}  // namespace detail
}  // namespace cyclone
