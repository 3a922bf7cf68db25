#include "members.h"

#include <algorithm>

#include "growing.h"

namespace cyclone {
namespace detail {

void Members::reserveOneMore() {
    const std::size_t count = list.bodies.size() + 1;
    reserveGrowing(list.bodies, count);
    reserveGrowing(list.numbers, count);
    reserveGrowing(list.born, count);
    list.numberOf.reserve(list.numberOf.size() + 1);
}

void Members::List::reserve(const List &other) {
    bodies.reserve(other.bodies.capacity());
    numbers.reserve(other.numbers.capacity());
    born.reserve(other.born.capacity());
    numberOf.reserve(other.numberOf.capacity());
}

void Members::List::assign(const List &other) {
    bodies = other.bodies;
    numbers = other.numbers;
    born = other.born;
    numberOf.assign(other.numberOf);
    nextNumber = other.nextNumber;
}

void Members::append(RigidBody *body, std::uint64_t born) {
    list.bodies.push_back(body);
    list.numbers.push_back(list.nextNumber);
    list.born.push_back(born);
    list.numberOf.set(body, list.nextNumber++);
}

std::uint64_t Members::erase(const RigidBody *body) {
    const auto number = std::lower_bound(list.numbers.begin(), list.numbers.end(), list.numberOf.find(body));
    const std::size_t index = static_cast<std::size_t>(number - list.numbers.begin());
    const std::uint64_t born = list.born[index];
    list.bodies[index] = nullptr;
    list.numberOf.erase(body);
    if (++gapCount > 16 + list.bodies.size() / 32) closeGaps();
    return born;
}

void Members::clear() {
    list.bodies.clear();
    list.numbers.clear();
    list.born.clear();
    list.numberOf.clear();
    gapCount = 0;
}

void Members::closeGaps() const {
    const Lock lock(closing);
    if (gapCount == 0) return;
    std::size_t end = 0;
    for (std::size_t n = 0; n < list.bodies.size(); ++n) {
        if (list.bodies[n] == nullptr) continue;
        list.bodies[end] = list.bodies[n];
        list.numbers[end] = list.numbers[n];
        list.born[end++] = list.born[n];
    }
    list.bodies.resize(end);
    list.numbers.resize(end);
    list.born.resize(end);
    gapCount.store(0, std::memory_order_release);
}

}  // namespace detail
}  // namespace cyclone
