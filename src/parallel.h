#pragma once

/// @file
/// How work is shared out over threads.
#include <cstddef>

namespace cyclone {
namespace detail {

/// Bodies or registrations in each part: some microseconds of work.
constexpr std::size_t PARALLEL_PART = 256;

/// With fewer bodies or registrations than this the calling thread alone is faster: waking others and waiting
/// for them takes longer than it saves.
constexpr std::size_t PARALLEL_MINIMUM = 4096;

}  // namespace detail
}  // namespace cyclone
