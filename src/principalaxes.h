#pragma once

/// @file
/// Inertia tensors and their principal axes.
#include <cyclone/core.h>

namespace cyclone {
namespace detail {

/// To within a rounding of 1e-9.
bool isSymmetric(const Matrix3 &m);

/// Principal values and axes of a symmetric matrix: m = R·diag(values)·Rᵀ, where R is the rotation matrix of
/// `axes` (Jacobi 1846). Of a diagonal matrix the axes are the identity and the values exact.
CYCLONE_API void findPrincipalAxes(const Matrix3 &m, Vector3 &values, Quaternion &axes);

/// Half the sum of a matrix and its transpose, which does not overflow.
inline Matrix3 symmetricPart(const Matrix3 &m) { return m * 0.5 + m.transpose() * 0.5; }

/// Whether a body can have these principal moments, kg·m², infinite about locked axes: 1e-100 to 1e100, which
/// leaves room for the products of a step, and none 1e12 times another, beyond which the rounding of the
/// angular momentum would show in the rotation.
bool areBearable(const Vector3 &moments);

/// R·diag(values)·Rᵀ, symmetric to the last bit.
Matrix3 tensorFromPrincipalAxes(const Quaternion &axes, const Vector3 &values);

}  // namespace detail
}  // namespace cyclone
