/// Snapshots of any bytes, and valid ones that are damaged and whose checksum is made to fit again: each is
/// refused, and changes nothing, or its states are possible ones that a world can go on from.
#include <cyclone/world.h>

#include <stdexcept>

#include "input.h"

using namespace cyclone;
using namespace cyclone_fuzz;

namespace {

constexpr std::size_t BODIES = 3, HEADER = 64, WORD = 8;

void fill(World &world) {
    for (std::size_t n = 0; n < BODIES; ++n) {
        RigidBody *const body = world.createBody();
        const real x = static_cast<real>(n + 1);
        body->setMass(x);
        body->setInertiaTensor(Matrix3(2, 0.1, 0, 0.1, 3, 0, 0, 0, 1 + x));
        body->setPosition(x, 2, 3);
        body->setVelocity(1, x, 0);
        body->setRotation(0, 1, x);
        body->setDamping(0.9, 1 / x);
    }
    world.getBodies()[1]->setCanSleep();
    world.getBodies()[2]->setInverseMass(0);
    world.runPhysics(0.01);
}

std::uint64_t load(const Snapshot &snapshot, std::size_t at) {
    std::uint64_t word = 0;
    for (std::size_t n = 0; n < WORD; ++n) word |= std::uint64_t(snapshot.data()[at + n]) << (8 * n);
    return word;
}

std::uint64_t mixed(std::uint64_t word) {
    word *= 0x9e3779b97f4a7c15;
    return word >> 32 | word << 32;
}

/// As src/snapshot.cpp computes it: a damaged snapshot with a wrong one says nothing about the rest.
std::uint64_t checksum(const Snapshot &snapshot) {
    std::uint64_t lanes[] = {1, 2, 3, 4, 5, 6, 7, 8};
    for (std::size_t n = 0; WORD * (n + 1) < snapshot.size(); ++n)
        lanes[n % 8] = mixed(lanes[n % 8] ^ load(snapshot, WORD * n));
    std::uint64_t result = load(snapshot, 0);
    for (const std::uint64_t lane : lanes) result = mixed(result ^ lane);
    return result;
}

void store(Snapshot &snapshot, std::size_t at, std::uint64_t word) {
    for (std::size_t n = 0; n < WORD; ++n)
        snapshot.data()[at + n] = static_cast<std::uint8_t>(word >> (8 * n));
}

/// Bytes alone, as from a file: nothing says that they were written as they are.
Snapshot damaged(const World &world, Input &input) {
    Snapshot snapshot;
    world.saveState(snapshot);
    const std::size_t last = snapshot.size() - WORD;
    expect(load(snapshot, last) == checksum(snapshot), "this target knows the checksum");
    while (!input.isAtEnd()) {
        const std::size_t words = (last - HEADER) / WORD;
        const std::size_t at = HEADER + WORD * ((input.byte() + 256u * input.byte()) % words);
        const std::uint8_t kind = input.byte();
        if (kind < 128) {  // one bit
            snapshot.data()[at + kind / 8 % WORD] ^= static_cast<std::uint8_t>(1 << kind % 8);
            continue;
        }
        const real value = input.number();
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        store(snapshot, at, bits);
    }
    store(snapshot, last, checksum(snapshot));
    return Snapshot(snapshot.begin(), snapshot.end());
}

void checkStates(const World &world) {
    for (const RigidBody *body : world.getBodies())
        if (const char *error = body->getState().findError()) expect(false, error);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count) {
    Input input(bytes, count);
    World world;
    fill(world);
    Snapshot snapshot;
    if (input.flag()) {
        snapshot = damaged(world, input);
    } else {
        snapshot.resize(count > 0 ? count - 1 : 0);
        for (std::size_t n = 0; n < snapshot.size(); ++n) snapshot.data()[n] = input.byte();
    }
    const std::uint64_t before = world.hash();
    try {
        world.restoreState(snapshot);
    } catch (const std::invalid_argument &) {
        expect(world.hash() == before, "a refused snapshot changes nothing");
        return 0;
    }
    checkStates(world);
    Snapshot again;
    world.saveState(again);
    World other;
    fill(other);
    Snapshot bytesAlone;
    bytesAlone.resize(again.size());
    std::memcpy(bytesAlone.data(), again.data(), again.size());
    other.restoreState(bytesAlone);
    expect(other.hash() == world.hash(), "what is saved is what was restored");
    for (int n = 0; n < 3; ++n) {
        world.runPhysics(1.0 / 60);
        other.runPhysics(1.0 / 60);
        checkStates(world);
    }
    expect(other.hash() == world.hash(), "the same states go on to the same bits");
    return 0;
}
