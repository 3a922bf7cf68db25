#include <cyclone/snapshot.h>

#include <cstring>
#include <limits>

#include "arguments.h"
#include "state.h"

namespace cyclone {

using namespace detail;

namespace {

using State = RigidBody::State;

constexpr std::uint64_t VERSION = 2;               // of the order and meaning of a state's words
constexpr std::uint64_t MAGIC = 0x656e6f6c637943;  // "Cyclone"
constexpr std::size_t STATE_WORDS = 55, HEADER_WORDS = 3, CHECKSUM_WORDS = 1;

/// A state as words of 64 bits: its flags, then its numbers.
struct Words {
    std::uint64_t words[STATE_WORDS];
};

/// Every NaN, such as a poisoned force that was added just now, counts as the same one: which of them comes
/// out of an operation depends on the processor.
std::uint64_t bitsOf(real value) {
    if (value != value) value = std::numeric_limits<real>::quiet_NaN();
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

real realOf(std::uint64_t bits) {
    real value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

/// Of mass and inverse mass the one is the reciprocal of the other, so one of them is enough; and so it is
/// with moments of inertia.
class Reciprocals {
public:
    /// Whether it is the inverse that follows from the other one.
    bool inverseMassFollows, inverseInertiaFollows;

    explicit Reciprocals(const State &s)
        : inverseMassFollows(s.inverseMass == 1 / s.mass),
          inverseInertiaFollows(s.inverseInertia == reciprocal(s.inertia)) {}
    Reciprocals(bool mass, bool inertia) : inverseMassFollows(mass), inverseInertiaFollows(inertia) {}

    bool follows(const State &s, const real *number) const {
        const real *const mass = inverseMassFollows ? &s.inverseMass : &s.mass;
        const Vector3 &inertia = inverseInertiaFollows ? s.inverseInertia : s.inertia;
        return number == mass || number == &inertia.x || number == &inertia.y || number == &inertia.z;
    }
    void complete(State &s) const {
        if (inverseMassFollows)
            s.inverseMass = 1 / s.mass;
        else
            s.mass = s.inverseMass > 0 ? 1 / s.inverseMass : REAL_MAX;
        if (inverseInertiaFollows)
            s.inverseInertia = reciprocal(s.inertia);
        else
            s.inertia = reciprocal(s.inverseInertia);
    }

private:
    static Vector3 reciprocal(const Vector3 &v) { return Vector3(1 / v.x, 1 / v.y, 1 / v.z); }
};

Words toWords(const State &state) {
    const Reciprocals reciprocals(state);
    Words result;
    std::uint64_t *next = result.words + 1;
    std::uint64_t flags =
        (reciprocals.inverseMassFollows ? 1u : 0u) + (reciprocals.inverseInertiaFollows ? 2u : 0u);
    StateMembers::visitNumbers(state, [&](const auto &value) {
        if constexpr (std::is_same_v<decltype(value), const bool &>)
            flags = 2 * flags + (value ? 1 : 0);
        else if (!reciprocals.follows(state, &value))
            *next++ = bitsOf(value);
    });
    result.words[0] = flags;
    return result;
}

State fromWords(const Words &words) {
    constexpr int FLAGS = 3;
    const std::uint64_t *next = words.words + 1;
    const std::uint64_t flags = words.words[0];
    const Reciprocals reciprocals((flags >> FLAGS & 1) != 0, (flags >> (FLAGS + 1) & 1) != 0);
    int flag = FLAGS;
    State state;
    StateMembers::visitNumbers(state, [&](auto &value) {
        if constexpr (std::is_same_v<decltype(value), bool &>)
            value = (flags >> --flag & 1) != 0;
        else if (!reciprocals.follows(state, &value))
            value = realOf(*next++);
    });
    reciprocals.complete(state);
    return state;
}

/// A running hash of words: xor, multiply, and fold the high half down (the multiplier is 2⁶⁴ divided by the
/// golden ratio; Knuth 1973).
class Hash {
public:
    void add(std::uint64_t word) {
        value = (value ^ word) * 0x9e3779b97f4a7c15;
        value ^= value >> 32;
    }
    std::uint64_t get() const { return value; }

private:
    std::uint64_t value = MAGIC;
};

void storeWord(std::uint8_t *bytes, std::uint64_t word) {
    for (int n = 0; n < 8; ++n) bytes[n] = static_cast<std::uint8_t>(word >> (8 * n));
}

std::uint64_t loadWord(const std::uint8_t *bytes) {
    std::uint64_t word = 0;
    for (int n = 0; n < 8; ++n) word |= static_cast<std::uint64_t>(bytes[n]) << (8 * n);
    return word;
}

std::size_t snapshotSize(std::size_t count) {
    return 8 * (HEADER_WORDS + count * STATE_WORDS + CHECKSUM_WORDS);
}

State loadState(const Snapshot &snapshot, std::size_t index) {
    Words words;
    const std::uint8_t *bytes = snapshot.data() + 8 * (HEADER_WORDS + index * STATE_WORDS);
    for (std::uint64_t &word : words.words) {
        word = loadWord(bytes);
        bytes += 8;
    }
    return fromWords(words);
}

}  // namespace

void writeSnapshot(RigidBody *const *bodies, std::size_t count, Snapshot &snapshot) {
    snapshot.resize(snapshotSize(count));
    std::uint8_t *bytes = snapshot.data();
    Hash checksum;
    const auto put = [&](std::uint64_t word) {
        storeWord(bytes, word);
        bytes += 8;
        checksum.add(word);
    };
    put(MAGIC);
    put(VERSION);
    put(count);
    for (std::size_t n = 0; n < count; ++n)
        for (std::uint64_t word : toWords(bodies[n]->getState()).words) put(word);
    storeWord(bytes, checksum.get());
}

const char *findSnapshotError(const Snapshot &snapshot, std::size_t count) {
    const std::uint8_t *bytes = snapshot.data();
    if (snapshot.size() < snapshotSize(0) || loadWord(bytes) != MAGIC) return "this must be a snapshot";
    if (loadWord(bytes + 8) != VERSION) return "the snapshot must be of this version";
    if (loadWord(bytes + 16) != count) return "the snapshot must be of as many bodies";
    if (snapshot.size() != snapshotSize(count)) return "the snapshot must be complete";
    Hash checksum;
    const std::uint8_t *const end = bytes + snapshot.size() - 8;
    for (; bytes != end; bytes += 8) checksum.add(loadWord(bytes));
    if (loadWord(end) != checksum.get()) return "the snapshot must be undamaged";
    for (std::size_t n = 0; n < count; ++n)
        if (const char *error = loadState(snapshot, n).findError()) return error;
    return nullptr;
}

void readSnapshot(const Snapshot &snapshot, RigidBody *const *bodies, std::size_t count,
                  const char *function) {
    const char *const error = findSnapshotError(snapshot, count);
    require(error == nullptr, function, error);
    for (std::size_t n = 0; n < count; ++n) bodies[n]->setState(loadState(snapshot, n));
}

std::uint64_t hashStates(RigidBody *const *bodies, std::size_t count) {
    Hash hash;
    hash.add(count);
    for (std::size_t n = 0; n < count; ++n)
        for (std::uint64_t word : toWords(bodies[n]->getState()).words)
            hash.add(word == bitsOf(-0.0) ? bitsOf(0.0) : word);
    return hash.get();
}

}  // namespace cyclone
