#pragma once

/// @file
/// What compilers offer for speed. Nothing here changes a result by one bit.
#include <cstddef>
#include <cstdint>

/// Inline even where the compiler thinks it too long. A build may define it to be something else.
#ifdef CYCLONE_INLINE
#elif defined(__GNUC__)
#define CYCLONE_INLINE [[gnu::always_inline]] inline
#else
#define CYCLONE_INLINE inline
#endif

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define CYCLONE_SANITIZED 1
#elif defined(__has_feature)
#define CYCLONE_SANITIZED \
    (__has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer))
#else
#define CYCLONE_SANITIZED 0
#endif

/// Compiles a function for several processors; the loader picks the widest version that this one has. None of
/// them reorders operations, and -ffp-contract=off keeps the one for AVX-512 from fusing them. Sanitizers run
/// before the loader has chosen, and do without; a build may define it to be nothing.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__has_attribute) && !defined(__AVX2__) && \
    !CYCLONE_SANITIZED && !defined(CYCLONE_TARGET_CLONES)
#if __has_attribute(target_clones)
#define CYCLONE_TARGET_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#endif
#endif
#ifndef CYCLONE_TARGET_CLONES
#define CYCLONE_TARGET_CLONES
#endif

namespace cyclone {
namespace detail {

/// How many objects ahead of the one being worked on to fetch from memory.
constexpr std::size_t PREFETCH_AHEAD = 12;

/// Asks the processor to have these bytes ready soon.
CYCLONE_INLINE void prefetch(const void *start, std::size_t size) {
#ifdef __GNUC__
    constexpr std::size_t CACHE_LINE = 64;
    for (std::size_t n = 0; n < size; n += CACHE_LINE)
        __builtin_prefetch(static_cast<const char *>(start) + n, 1);
#else
    static_cast<void>(start);
    static_cast<void>(size);
#endif
}

/// Has the value computed at this place. Gcc would put off a long row of such values, and keep in memory what
/// they are to be computed from.
CYCLONE_INLINE void computeNow(std::uint64_t &value) {
#if defined(__GNUC__) && !defined(__clang__)
    asm("" : "+r"(value));
#else
    static_cast<void>(value);
#endif
}

}  // namespace detail
}  // namespace cyclone
