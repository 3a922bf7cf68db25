#pragma once

/// Random inputs for tests, the same on every machine, and comparisons of what comes out.
#include <cyclone/core.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace cyclone_test {

using cyclone::Matrix3;
using cyclone::Matrix4;
using cyclone::Quaternion;
using cyclone::real;
using cyclone::Vector3;

inline constexpr real QUIET_NAN = std::numeric_limits<real>::quiet_NaN();
inline constexpr real PLUS_INFINITY = std::numeric_limits<real>::infinity();

class Random {
public:
    explicit Random(std::uint64_t seed) : bits(seed) {}

    real between(real low, real high) {
        return low + (high - low) * (static_cast<real>(bits() >> 11) * 0x1p-53);
    }
    Vector3 vector(real size = 1) {
        const real x = between(-size, size), y = between(-size, size), z = between(-size, size);
        return Vector3(x, y, z);
    }
    Quaternion orientation() {
        const Vector3 v = vector();
        Quaternion q(between(-1, 1), v.x, v.y, v.z);
        q.normalise();
        return q;
    }
    Matrix3 matrix() {
        const Vector3 x = vector(), y = vector(), z = vector();
        return Matrix3(x, y, z);
    }

private:
    std::mt19937_64 bits;
};

inline Matrix3 rotationMatrix(const Quaternion &q) {
    Matrix3 matrix;
    matrix.setOrientation(q);
    return matrix;
}

inline Matrix3 diagonal(real a, real b, real c) {
    Matrix3 matrix;
    matrix.setDiagonal(a, b, c);
    return matrix;
}

inline Matrix4 rigidTransform(const Quaternion &q, const Vector3 &position) {
    Matrix4 matrix;
    matrix.setOrientationAndPos(q, position);
    return matrix;
}

/// Whether no two numbers at the same place differ by more than the tolerance; NaN is near nothing.
inline testing::AssertionResult allNear(const real *got, const real *want, int count, real tolerance) {
    for (int n = 0; n < count; ++n)
        if (!(cyclone::real_abs(got[n] - want[n]) <= tolerance))
            return testing::AssertionFailure() << "number " << n << " is " << testing::PrintToString(got[n])
                                               << ", wanted " << testing::PrintToString(want[n]);
    return testing::AssertionSuccess();
}

inline testing::AssertionResult isNear(const Vector3 &got, const Vector3 &want, real tolerance) {
    const real a[3] = {got.x, got.y, got.z}, b[3] = {want.x, want.y, want.z};
    return allNear(a, b, 3, tolerance);
}

inline testing::AssertionResult isNear(const Matrix3 &got, const Matrix3 &want, real tolerance) {
    return allNear(got.data, want.data, 9, tolerance);
}

inline testing::AssertionResult isNear(const Matrix4 &got, const Matrix4 &want, real tolerance) {
    return allNear(got.data, want.data, 12, tolerance);
}

/// Whether two unit quaternions turn alike; q and −q do.
inline testing::AssertionResult turnsLike(const Quaternion &got, const Quaternion &want, real tolerance) {
    const real sign = got.r * want.r + got.i * want.i + got.j * want.j + got.k * want.k < 0 ? -1 : 1;
    const real a[4] = {got.r, got.i, got.j, got.k};
    const real b[4] = {sign * want.r, sign * want.i, sign * want.j, sign * want.k};
    return allNear(a, b, 4, tolerance);
}

}  // namespace cyclone_test
