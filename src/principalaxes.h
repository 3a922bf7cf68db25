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

/// R·diag(values)·Rᵀ, symmetric to the last bit.
Matrix3 tensorFromPrincipalAxes(const Quaternion &axes, const Vector3 &values);

}  // namespace detail
}  // namespace cyclone
