#pragma once

/// @file
/// Saved states as bytes that mean the same on every machine.
#include <cyclone/body.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace cyclone {

namespace detail {
struct WorldStructure;
}

/// The states of some bodies, to keep, to write to a file or to send over a network: bytes, in which numbers
/// are little-endian, reals their IEEE bits: a mark and version, the number of bodies, the states, and a
/// checksum over all of it.
///
/// One that a World has saved also remembers which bodies, generators and registrations the world had, so
/// that the same world can return to it after some have come and gone. That memory goes along when a Snapshot
/// is copied, but is not in its bytes.
class CYCLONE_API Snapshot : public std::vector<std::uint8_t> {
public:
    using std::vector<std::uint8_t>::vector;
    Snapshot() = default;

private:
    friend class World;
    friend CYCLONE_API void writeSnapshot(RigidBody *const *bodies, std::size_t count, Snapshot &snapshot);
    friend CYCLONE_API const char *findSnapshotError(const Snapshot &snapshot, std::size_t count);

    /// The checksum of the bytes as writeSnapshot() left them, whose states need no check; 0: there are none.
    std::uint64_t writtenChecksum = 0;
    std::shared_ptr<detail::WorldStructure> structure;  ///< of the world when it wrote them
};

/// Replaces the snapshot's content; allocates only where it has been smaller.
CYCLONE_API void writeSnapshot(RigidBody *const *bodies, std::size_t count, Snapshot &snapshot);

/// Why readSnapshot would refuse: not a snapshot, another version, damaged, another number of bodies, or a
/// state that no body can be in. Null when it would not. Bytes that are still as writeSnapshot() left them
/// are checked for damage only, which is several times faster; put those from elsewhere into a Snapshot of
/// their own.
CYCLONE_API const char *findSnapshotError(const Snapshot &snapshot, std::size_t count);

/// Sets every body to its saved state. Refuses a snapshot with an error, in the name of `function`, and
/// changes nothing then.
CYCLONE_API void readSnapshot(const Snapshot &snapshot, RigidBody *const *bodies, std::size_t count,
                              const char *function = "readSnapshot");

/// A number that depends on every bit of the states, save for the sign of zeros, which no motion depends on:
/// two machines whose numbers agree are in step.
CYCLONE_API std::uint64_t hashStates(RigidBody *const *bodies, std::size_t count);

}  // namespace cyclone
