#include <cyclone/snapshot.h>

#include <cstring>
#include <limits>

#include "arguments.h"
#include "compiler.h"
#include "loadstates.h"
#include "state.h"

namespace cyclone {

using namespace detail;

using State = RigidBody::State;

namespace {

constexpr std::uint64_t MAGIC = 0x656e6f6c637943;  // "Cyclone"
constexpr std::uint64_t VERSION = 4;               // of the order and meaning of the words

// ---- Words of 64 bits, and their bytes

CYCLONE_INLINE std::uint64_t loadNativeWord(const std::uint8_t *bytes) {
    std::uint64_t word;
    std::memcpy(&word, bytes, sizeof word);
    return word;
}

CYCLONE_INLINE void storeNativeWord(std::uint8_t *bytes, std::uint64_t word) {
    std::memcpy(bytes, &word, sizeof word);
}

/// The word with its bytes from the lowest to the highest, in whatever order this machine keeps them; and
/// back again.
CYCLONE_INLINE std::uint64_t littleEndian(std::uint64_t word) {
    const auto byte = [word](int n) { return static_cast<std::uint8_t>(word >> (8 * n)); };
    const std::uint8_t bytes[8] = {byte(0), byte(1), byte(2), byte(3), byte(4), byte(5), byte(6), byte(7)};
    return loadNativeWord(bytes);
}

CYCLONE_INLINE void storeWord(std::uint8_t *bytes, std::uint64_t word) {
    storeNativeWord(bytes, littleEndian(word));
}

CYCLONE_INLINE std::uint64_t loadWord(const std::uint8_t *bytes) {
    return littleEndian(loadNativeWord(bytes));
}

constexpr std::uint64_t swapHalves(std::uint64_t word) { return word >> 32 | word << 32; }

/// A running hash of words in eight lanes, which do not wait for each other. Each step is one-to-one in its
/// word, so a change of a single word never goes unnoticed. (The multiplier is 2⁶⁴ divided by the golden
/// ratio; Knuth 1973.)
class Hash {
public:
    static constexpr std::size_t LANES = 8, ROW = 8 * LANES;  ///< bytes: a word for each lane

    /// Words go to the lanes in turn.
    CYCLONE_INLINE void add(std::size_t lane, std::uint64_t word) { lanes[lane] = mixed(lanes[lane] ^ word); }
    /// Adds whole rows.
    CYCLONE_INLINE void add(const std::uint8_t *bytes, std::size_t size) {
        for (std::size_t n = 0; n < size; n += ROW)
            for (std::size_t lane = 0; lane < LANES; ++lane) add(lane, loadWord(bytes + n + 8 * lane));
    }
    std::uint64_t get() const {
        std::uint64_t result = MAGIC;
        for (const std::uint64_t lane : lanes) result = mixed(result ^ lane);
        return result;
    }

private:
    CYCLONE_INLINE static std::uint64_t mixed(std::uint64_t word) {
        word = swapHalves(word * 0x9e3779b97f4a7c15);
        computeNow(word);
        return word;
    }

    std::uint64_t lanes[LANES] = {1, 2, 3, 4, 5, 6, 7, 8};
};

// ---- A state as words

/// A record is 54 numbers of a state, its flags, and zero. Of a mass or moment of inertia and its inverse the
/// one follows from the other: it holds the one that was set, and a flag says which.
constexpr std::size_t FLAGS = 54 * 8, PADDING = 55 * 8, RECORD = 56 * 8;
constexpr unsigned FLAG_COUNT = 10;

/// Adds words to a hash one after the other and, if it is to keep them, stores them; collects flags.
template <bool KEEPS>
struct RecordWriter {
    Hash &hash;
    std::uint8_t *bytes;  ///< for a record, if it keeps them
    std::size_t count = 0;
    std::uint64_t flags = 0;

    CYCLONE_INLINE void writeWord(std::uint64_t word) {
        if (KEEPS) storeWord(bytes + 8 * count, word);
        hash.add(count++ % Hash::LANES, word);
    }
    CYCLONE_INLINE void operator()(const real &number) {
        const real value = KEEPS ? number : number + 0.0;  // which makes −0.0 to 0.0, and changes no other
        std::uint64_t word;
        std::memcpy(&word, &value, sizeof word);
        writeWord(word);
    }
    CYCLONE_INLINE void operator()(const bool &flag) { flags = 2 * flags + (flag ? 1 : 0); }
    CYCLONE_INLINE void operator()(const std::uint8_t &threeFlags) { flags = 8 * flags + threeFlags; }
    CYCLONE_INLINE void operator()(const real &value, const real &inverse, real) {
        const bool inverseFollows = inverse == 1 / value;
        (*this)(inverseFollows);
        (*this)(inverseFollows ? value : inverse);
    }
};

/// Reads numbers and flags back.
struct RecordReader {
    const std::uint8_t *next;
    std::uint64_t flags;
    unsigned flagsLeft = FLAG_COUNT;

    CYCLONE_INLINE void operator()(real &number) {
        const std::uint64_t word = loadWord(next);
        std::memcpy(&number, &word, sizeof number);
        next += 8;
    }
    CYCLONE_INLINE void operator()(bool &flag) { flag = (flags >> --flagsLeft & 1) != 0; }
    CYCLONE_INLINE void operator()(std::uint8_t &threeFlags) {
        flagsLeft -= 3;
        threeFlags = static_cast<std::uint8_t>(flags >> flagsLeft & 7);
    }
    CYCLONE_INLINE void operator()(real &value, real &inverse, real valueWithoutInverse) {
        bool inverseFollows;
        real number;
        (*this)(inverseFollows);
        (*this)(number);
        const real reciprocal = 1 / number;
        value = inverseFollows ? number : number == 0 ? valueWithoutInverse : reciprocal;
        inverse = inverseFollows ? reciprocal : number;
    }
};

/// Writes the record of each body.
template <bool KEEPS>
CYCLONE_INLINE void writeRecords(RigidBody *const *bodies, std::size_t count, RecordWriter<KEEPS> next) {
    RigidBody unified;
    for (std::size_t n = 0; n < count; ++n) {
        const RigidBody *body = bodies[n];
        if (StateMembers::mayHoldNaNs(*body)) {
            unified = *body;
            StateMembers::unifyNaNs(unified);
            body = &unified;
        }
        RecordWriter<KEEPS> write = next;
        EachNumber<RecordWriter<KEEPS>> writeNumbers{write};
        const Vector3 position = body->getPosition();
        writeNumbers(position);
        StateMembers::visitIndependent(*body, writeNumbers);
        StateMembers::visitReciprocals(*body, write);
        write.writeWord(write.flags);
        write.writeWord(0);
        if (KEEPS) next.bytes += RECORD;
    }
}

/// Body is a RigidBody or a State.
template <class Body>
CYCLONE_INLINE void loadRecord(const std::uint8_t *bytes, Body &body) {
    RecordReader read{bytes, loadWord(bytes + FLAGS)};
    EachNumber<RecordReader> readNumbers{read};
    Vector3 position;
    readNumbers(position);
    StateMembers::setPosition(body, position);
    StateMembers::visitIndependent(body, readNumbers);
    StateMembers::visitReciprocals(body, read);
}

const char *findRecordError(const std::uint8_t *bytes) {
    if (loadWord(bytes + FLAGS) >> FLAG_COUNT != 0 || loadWord(bytes + PADDING) != 0)
        return "the snapshot's unused bits must be zero";
    State state;
    loadRecord(bytes, state);
    return state.findError();
}

// ---- Snapshots

constexpr std::size_t HEADER = Hash::ROW, CHECKSUM = 8;

std::size_t snapshotSize(std::size_t count) { return HEADER + count * RECORD + CHECKSUM; }

void storeHeader(std::uint8_t *bytes, std::size_t count) {
    std::memset(bytes, 0, HEADER);
    storeWord(bytes, MAGIC);
    storeWord(bytes + 8, VERSION);
    storeWord(bytes + 16, count);
}

}  // namespace

void writeSnapshot(RigidBody *const *bodies, std::size_t count, Snapshot &snapshot) {
    snapshot.resize(snapshotSize(count));
    std::uint8_t *bytes = snapshot.data();
    Hash checksum;
    storeHeader(bytes, count);
    checksum.add(bytes, HEADER);
    writeRecords(bodies, count, RecordWriter<true>{checksum, bytes + HEADER});
    snapshot.writtenChecksum = checksum.get();
    snapshot.structure.reset();
    storeWord(bytes + snapshot.size() - CHECKSUM, snapshot.writtenChecksum);
}

const char *findSnapshotError(const Snapshot &snapshot, std::size_t count) {
    const std::uint8_t *const bytes = snapshot.data();
    if (snapshot.size() < snapshotSize(0) || loadWord(bytes) != MAGIC) return "this must be a snapshot";
    if (loadWord(bytes + 8) != VERSION) return "the snapshot must be of this version";
    if (loadWord(bytes + 16) != count) return "the snapshot must be of as many bodies";
    if (snapshot.size() != snapshotSize(count)) return "the snapshot must be complete";

    Hash checksum;
    checksum.add(bytes, snapshot.size() - CHECKSUM);
    if (loadWord(bytes + snapshot.size() - CHECKSUM) != checksum.get())
        return "the snapshot must be undamaged";
    if (snapshot.writtenChecksum != 0 && snapshot.writtenChecksum == checksum.get()) return nullptr;

    for (std::size_t n = 0; n < count; ++n)
        if (const char *const error = findRecordError(bytes + HEADER + n * RECORD)) return error;
    return nullptr;
}

void readSnapshot(const Snapshot &snapshot, RigidBody *const *bodies, std::size_t count) {
    const char *const error = findSnapshotError(snapshot, count);
    require(error == nullptr, "readSnapshot", error);
    loadStates(snapshot, bodies, count);
}

void detail::loadStates(const Snapshot &snapshot, RigidBody *const *bodies, std::size_t count) {
    const std::uint8_t *bytes = snapshot.data() + HEADER;
    for (std::size_t n = 0; n < count; ++n, bytes += RECORD) {
        loadRecord(bytes, *bodies[n]);
        StateMembers::updateDerived(*bodies[n]);
    }
}

std::uint64_t hashStates(RigidBody *const *bodies, std::size_t count) {
    Hash hash;
    std::uint8_t header[HEADER];
    storeHeader(header, count);
    hash.add(header, HEADER);
    writeRecords(bodies, count, RecordWriter<false>{hash, nullptr});
    return hash.get();
}

}  // namespace cyclone
