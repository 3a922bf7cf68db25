#pragma once

/// @file
/// Checks of the kinds of arguments that many functions take, see check.h.
#include <cyclone/core.h>

namespace cyclone {
namespace detail {

inline void requireVector(bool kept, const char *function, const char *rule, const Vector3 &value) {
    require(kept, function, rule, {value.x, value.y, value.z});
}

inline void requireMatrix(bool kept, const char *function, const char *rule, const Matrix3 &value) {
    const real *d = value.data;
    require(kept, function, rule, {d[0], d[1], d[2], d[3], d[4], d[5], d[6], d[7], d[8]});
}

inline void requireFinite(real value, const char *function, const char *rule) {
    require(real_isfinite(value), function, rule, {value});
}

inline void requireFinite(const Vector3 &value, const char *function, const char *rule) {
    requireVector(value.isFinite(), function, rule, value);
}

inline void requireFinite(const Matrix3 &value, const char *function, const char *rule) {
    requireMatrix(value.isFinite(), function, rule, value);
}

/// Positive and finite.
inline void requirePositive(real value, const char *function, const char *rule) {
    require(value > 0 && value <= REAL_MAX, function, rule, {value});
}

/// Finite and not negative.
inline void requireNotNegative(real value, const char *function, const char *rule) {
    require(value >= 0 && value <= REAL_MAX, function, rule, {value});
}

inline void requireDuration(real duration, const char *function) {
    requireNotNegative(duration, function, "the duration must be finite and not negative");
}

/// A direction: finite, and of any length but zero.
inline void requireDirection(const Vector3 &value, const char *function, const char *rule) {
    requireVector(value.isFinite() && value != Vector3(), function, rule, value);
}

/// A rotation: finite, and of any length but zero.
inline void requireRotation(const Quaternion &q, const char *function, const char *rule) {
    require(q.isFinite() && q != Quaternion(0, 0, 0, 0), function, rule, {q.r, q.i, q.j, q.k});
}

}  // namespace detail
}  // namespace cyclone
