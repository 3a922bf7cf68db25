#pragma once

/// @file
/// How work is shared out over threads.
#include <cstddef>

namespace cyclone {
namespace detail {

/// Bodies or registrations in each part: some microseconds of work.
constexpr std::size_t PARALLEL_PART = 256;

/// With fewer bodies or registrations than this the calling thread alone is faster than Workers: waking
/// others and waiting for them takes longer than it saves. A host's own job system is used from two parts on.
constexpr std::size_t LEAST_FOR_WORKERS = 4096, LEAST_FOR_HOST = PARALLEL_PART + 1;

/// Clearing takes a tenth of a frame: so many bodies make a loop worth sharing out.
constexpr std::size_t LEAST_TO_CLEAR = 8 * PARALLEL_PART;

}  // namespace detail
}  // namespace cyclone
