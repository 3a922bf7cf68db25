#include <cyclone/snapshot.h>

#include <cstring>
#include <iterator>
#include <limits>

namespace cyclone {

namespace {

using State = RigidBody::State;

// What a state consists of, in the order of its bytes. A new member belongs here, and makes a new version.
constexpr std::uint64_t VERSION = 1;
constexpr Vector3 State::*VECTORS[] = {
    &State::position,        &State::velocity,      &State::rotation,
    &State::angularMomentum, &State::acceleration,  &State::lastFrameAcceleration,
    &State::addedForce,      &State::addedTorque,   &State::generatedForce,
    &State::generatedTorque, &State::lastForce,     &State::lastTorque,
    &State::inertia,         &State::inverseInertia};
constexpr RigidBody::Course State::*COURSES[] = {&State::addedForces, &State::addedTorques};
constexpr Quaternion State::*QUATERNIONS[] = {&State::orientation, &State::principalAxes};
constexpr real State::*REALS[] = {&State::lastDuration,  &State::mass,           &State::inverseMass,
                                  &State::linearDamping, &State::angularDamping, &State::motion,
                                  &State::sleepEpsilon};
constexpr bool State::*FLAGS[] = {
    &State::awake,         &State::canSleep,     &State::faulted,          &State::hasAdded,
    &State::isGenerated,   &State::startsAfresh, &State::hasStartedAfresh, &State::wasAdded,
    &State::hasAddedAfresh};

constexpr std::size_t STATE_WORDS =
    3 * std::size(VECTORS) + 7 * std::size(COURSES) + 4 * std::size(QUATERNIONS) + std::size(REALS) + 1;
constexpr std::size_t HEADER_WORDS = 3, CHECKSUM_WORDS = 1;
constexpr std::uint64_t MARK = 0x656e6f6c637943;  // "Cyclone"

/// A state as words of 64 bits.
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

Words toWords(const State &state) {
    Words result;
    std::uint64_t *next = result.words;
    for (auto member : VECTORS)
        for (real value : {(state.*member).x, (state.*member).y, (state.*member).z}) *next++ = bitsOf(value);
    for (auto member : COURSES) {
        const RigidBody::Course &c = state.*member;
        for (real value :
             {c.last.x, c.last.y, c.last.z, c.change.x, c.change.y, c.change.z, c.greatestSquare})
            *next++ = bitsOf(value);
    }
    for (auto member : QUATERNIONS) {
        const Quaternion &q = state.*member;
        for (real value : {q.r, q.i, q.j, q.k}) *next++ = bitsOf(value);
    }
    for (auto member : REALS) *next++ = bitsOf(state.*member);
    *next = 0;
    for (auto member : FLAGS) *next = *next * 2 + (state.*member ? 1 : 0);
    return result;
}

State fromWords(const Words &words) {
    State state;
    const std::uint64_t *next = words.words;
    for (auto member : VECTORS)
        for (real *value : {&(state.*member).x, &(state.*member).y, &(state.*member).z})
            *value = realOf(*next++);
    for (auto member : COURSES) {
        RigidBody::Course &c = state.*member;
        for (real *value :
             {&c.last.x, &c.last.y, &c.last.z, &c.change.x, &c.change.y, &c.change.z, &c.greatestSquare})
            *value = realOf(*next++);
    }
    for (auto member : QUATERNIONS) {
        Quaternion &q = state.*member;
        for (real *value : {&q.r, &q.i, &q.j, &q.k}) *value = realOf(*next++);
    }
    for (auto member : REALS) state.*member = realOf(*next++);
    std::uint64_t flags = *next;
    for (std::size_t n = std::size(FLAGS); n-- > 0; flags /= 2) state.*FLAGS[n] = flags % 2 != 0;
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
    std::uint64_t value = MARK;
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
    put(MARK);
    put(VERSION);
    put(count);
    for (std::size_t n = 0; n < count; ++n)
        for (std::uint64_t word : toWords(bodies[n]->getState()).words) put(word);
    storeWord(bytes, checksum.get());
}

const char *findSnapshotError(const Snapshot &snapshot, std::size_t count) {
    const std::uint8_t *bytes = snapshot.data();
    if (snapshot.size() < snapshotSize(0) || loadWord(bytes) != MARK) return "this must be a snapshot";
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
        for (std::uint64_t word : toWords(bodies[n]->getState()).words) hash.add(word);
    return hash.get();
}

}  // namespace cyclone
