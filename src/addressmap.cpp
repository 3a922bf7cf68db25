#include "addressmap.h"

#include "compiler.h"

namespace cyclone {
namespace detail {

void AddressMap::reserve(std::size_t count) {
    if (3 * count <= 2 * slots.size()) return;
    AddressMap larger;
    std::size_t size = 16;
    larger.shift = 60;
    for (; 3 * count > 2 * size; size *= 2) --larger.shift;
    larger.slots.resize(size);
    larger.assign(*this);
    *this = std::move(larger);
}

void AddressMap::assign(const AddressMap &other) {
    if (slots.size() == other.slots.size()) {
        slots = other.slots;
        used = other.used;
        return;
    }
    clear();
    for (const Slot &slot : other.slots)
        if (slot.address != nullptr) set(slot.address, slot.number);
}

/// Fibonacci hashing (Knuth 1973): the multiplier is 2⁶⁴ divided by the golden ratio. Objects in a row are at
/// equal distances, many multiples of which can be close together: the higher bits shift these.
std::size_t AddressMap::homeOf(const void *address) const {
    std::uint64_t bits = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(address)) >> 3;
    bits ^= bits >> 8;
    return static_cast<std::size_t>(bits * 0x9e3779b97f4a7c15 >> shift);
}

/// Where the address is, or the empty slot where it would be.
std::size_t AddressMap::slotOf(const void *address) const {
    std::size_t n = homeOf(address);
    while (slots[n].address != nullptr && slots[n].address != address) n = (n + 1) & (slots.size() - 1);
    return n;
}

void AddressMap::prefetch(const void *address) const {
    if (used > 0) detail::prefetch(&slots[homeOf(address)], 1);
}

std::uint64_t AddressMap::find(const void *address) const {
    return used == 0 ? NONE : slots[slotOf(address)].number;
}

void AddressMap::set(const void *address, std::uint64_t number) {
    Slot &slot = slots[slotOf(address)];
    if (slot.address == nullptr) ++used;
    slot = {address, number};
}

/// Later slots move up into the gap, unless that is before their home (Knuth 1973, algorithm R).
void AddressMap::erase(const void *address) {
    if (used == 0) return;
    std::size_t gap = slotOf(address);
    if (slots[gap].address == nullptr) return;
    const std::size_t mask = slots.size() - 1;
    for (std::size_t n = (gap + 1) & mask; slots[n].address != nullptr; n = (n + 1) & mask) {
        const std::size_t wayFromHome = (n - homeOf(slots[n].address)) & mask;
        if (wayFromHome < ((n - gap) & mask)) continue;
        slots[gap] = slots[n];
        gap = n;
    }
    slots[gap] = Slot();
    --used;
}

void AddressMap::clear() {
    slots.assign(slots.size(), Slot());
    used = 0;
}

}  // namespace detail
}  // namespace cyclone
