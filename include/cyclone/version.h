#pragma once

/// @file
/// The version. Semantic (semver.org): while it is 0.x, a new minor version may break what was there.

#define CYCLONE_VERSION_MAJOR 0
#define CYCLONE_VERSION_MINOR 1
#define CYCLONE_VERSION_PATCH 0

/// One number for comparisons: 102 is version 0.1.2.
#define CYCLONE_VERSION (CYCLONE_VERSION_MAJOR * 10000 + CYCLONE_VERSION_MINOR * 100 + CYCLONE_VERSION_PATCH)
