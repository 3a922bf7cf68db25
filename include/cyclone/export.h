#pragma once

/// @file
/// Symbol visibility of the shared library.
///
/// Built from source, or as a static library, there is nothing to define: CYCLONE_API is then empty. A shared
/// library defines CYCLONE_SHARED for itself and for everyone who uses it, and CYCLONE_EXPORTS for itself
/// alone; the package for CMake and pkg-config sees to it.

#if !defined(CYCLONE_SHARED)
#define CYCLONE_API
#elif !defined(_WIN32)
#define CYCLONE_API __attribute__((visibility("default")))
#elif defined(CYCLONE_EXPORTS)
#define CYCLONE_API __declspec(dllexport)
#else
#define CYCLONE_API __declspec(dllimport)
#endif
