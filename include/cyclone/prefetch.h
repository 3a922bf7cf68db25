#pragma once

/// @file
/// A hint to the processor: while one object is being worked on, a later one is on its way from memory.
#include <cstddef>

namespace cyclone {

/// How many objects ahead of the one being worked on.
constexpr std::size_t FETCH_AHEAD = 12;

/// Asks for some bytes. Changes nothing but time; a null pointer is fine.
inline void fetch(const void *start, std::size_t bytes) {
#ifdef __GNUC__
    constexpr std::size_t CACHE_LINE = 64;
    for (std::size_t n = 0; n < bytes; n += CACHE_LINE)
        __builtin_prefetch(static_cast<const char *>(start) + n, 1);
#else
    static_cast<void>(start);
    static_cast<void>(bytes);
#endif
}

}  // namespace cyclone
