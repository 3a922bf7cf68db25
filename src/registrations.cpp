#include "registrations.h"

#include "arguments.h"
#include "growing.h"

namespace cyclone {
namespace detail {

static_assert(Registrations::NONE == static_cast<std::size_t>(AddressMap::NONE), "one becomes the other");

void Registrations::reserveMore(std::size_t count) {
    const std::size_t end = calls.size() + count;
    require(end <= 0xffffffff, "ForceRegistry::add", "there can be at most 2^32 - 1 registrations");
    reserveGrowing(calls, end);
    reserveGrowing(details, end);
    for (Ring &ring : rings) {
        reserveGrowing(ring.links, end);
        ring.heads.reserve(ring.heads.size() + count);
    }
}

void Registrations::reserve(const Registrations &other) {
    calls.reserve(other.calls.capacity());
    details.reserve(other.details.capacity());
    for (Role role : ROLES) {
        rings[role].links.reserve(other.rings[role].links.capacity());
        rings[role].heads.reserve(other.rings[role].heads.capacity());
    }
}

void Registrations::assign(const Registrations &other) {
    calls = other.calls;
    details = other.details;
    for (Role role : ROLES) {
        rings[role].links = other.rings[role].links;
        rings[role].heads.assign(other.rings[role].heads);
    }
    gapCount = other.gapCount;
    crossBodyCount = other.crossBodyCount;
}

void Registrations::append(const Call &call, const RegistrationDetails &its) {
    calls.push_back(call);
    details.push_back(its);
    if (!its.actsOnItsBodyOnly) ++crossBodyCount;
    for (Role role : ROLES) {
        rings[role].links.push_back(Link());
        link(role, calls.size() - 1);
    }
}

void Registrations::erase(std::size_t index) {
    for (Role role : ROLES) unlink(role, index);
    if (!details[index].actsOnItsBodyOnly) --crossBodyCount;
    calls[index].body = nullptr;
    ++gapCount;
}

void Registrations::clear() {
    calls.clear();
    details.clear();
    for (Ring &ring : rings) {
        ring.links.clear();
        ring.heads.clear();
    }
    gapCount = crossBodyCount = 0;
}

const void *Registrations::keyOf(Role role, std::size_t index) const {
    switch (role) {
        case BODY:
            return calls[index].body;
        case GENERATOR:
            return calls[index].generator;
        default:
            return details[index].otherBody;
    }
}

/// At the end of its ring: it is the youngest of all.
void Registrations::link(Role role, std::size_t index) {
    const void *const key = keyOf(role, index);
    if (key == nullptr) return;
    Ring &ring = rings[role];
    const std::uint32_t self = static_cast<std::uint32_t>(index);
    const std::size_t head = first(role, key);
    if (head == NONE) {
        ring.heads.set(key, self);
        ring.links[self] = {self, self};
    } else {
        const std::uint32_t tail = ring.links[head].previous;
        ring.links[self] = {static_cast<std::uint32_t>(head), tail};
        ring.links[tail].next = ring.links[head].previous = self;
    }
}

void Registrations::unlink(Role role, std::size_t index) {
    const void *const key = keyOf(role, index);
    if (key == nullptr) return;
    Ring &ring = rings[role];
    const Link its = ring.links[index];
    if (its.next == index) return ring.heads.erase(key);
    ring.links[its.next].previous = its.previous;
    ring.links[its.previous].next = its.next;
    if (its.previous > index) ring.heads.set(key, its.next);
}

/// To a lower index, past gaps only.
void Registrations::move(std::size_t from, std::size_t to) {
    const std::uint32_t target = static_cast<std::uint32_t>(to);
    for (Role role : ROLES) {
        const void *const key = keyOf(role, from);
        if (key == nullptr) continue;
        Ring &ring = rings[role];
        Link its = ring.links[from];
        if (its.previous >= from) ring.heads.set(key, target);
        if (its.next == from) {
            its = {target, target};
        } else {
            ring.links[its.previous].next = target;
            ring.links[its.next].previous = target;
        }
        ring.links[to] = its;
    }
    calls[to] = calls[from];
    details[to] = details[from];
}

void Registrations::closeGaps() {
    std::size_t end = 0;
    for (std::size_t n = 0; n < calls.size(); ++n) {
        if (isGap(n)) continue;
        if (n != end) move(n, end);
        ++end;
    }
    calls.resize(end);
    details.resize(end);
    for (Ring &ring : rings) ring.links.resize(end);
    gapCount = 0;
}

}  // namespace detail
}  // namespace cyclone
