#pragma once

/// @file
/// Reading a snapshot that has been checked.
#include <cyclone/snapshot.h>

#include <cstddef>

namespace cyclone {
namespace detail {

/// Sets every body to its saved state. findSnapshotError() must find none.
void loadStates(const Snapshot &snapshot, RigidBody *const *bodies, std::size_t count);

}  // namespace detail
}  // namespace cyclone
