#include <cyclone/core.h>

#include <algorithm>

#include "arguments.h"

namespace cyclone {

namespace {

/// Whether a sum of squares has neither overflowed nor lost its smallest digits.
bool squareIsSafe(real square) { return square > 1e-280 && square < REAL_MAX; }

}  // namespace

void Vector3::normalise() {
    if (!squareIsSafe(squareMagnitude())) {
        const real largest = std::max({real_abs(x), real_abs(y), real_abs(z)});
        if (!isFinite() || largest == 0) return;
        *this = Vector3(x / largest, y / largest, z / largest);
    }
    const real length = magnitude();
    *this = Vector3(x / length, y / length, z / length);
}

void Vector3::trim(real size) {
    const Vector3 direction = unit();
    if (*this * direction > size) *this = direction * size;
}

Quaternion Quaternion::fromAxisAngle(const Vector3 &axis, real angle) {
    const Vector3 direction = axis.unit();
    if (direction == Vector3()) return Quaternion();
    const Vector3 v = direction * real_sin(angle / 2);
    return Quaternion(real_cos(angle / 2), v.x, v.y, v.z);
}

void Quaternion::normalise() {
    if (!squareIsSafe(squareMagnitude())) {
        const real largest = std::max({real_abs(r), real_abs(i), real_abs(j), real_abs(k)});
        if (largest == 0) *this = Quaternion();
        if (!isFinite() || largest == 0) return;
        *this = Quaternion(r / largest, i / largest, j / largest, k / largest);
    }
    const real length = real_sqrt(squareMagnitude());
    *this = Quaternion(r / length, i / length, j / length, k / length);
}

void Quaternion::addScaledVector(const Vector3 &v, real scale) {
    const Vector3 half = v * (scale / 2);
    const Quaternion change = Quaternion(0, half.x, half.y, half.z) * *this;
    *this = Quaternion(r + change.r, i + change.i, j + change.j, k + change.k);
}

namespace {

real cosineBetween(const Quaternion &a, const Quaternion &b) {
    return a.r * b.r + a.i * b.i + a.j * b.j + a.k * b.k;
}

Quaternion weightedSum(const Quaternion &a, real weightA, const Quaternion &b, real weightB) {
    Quaternion sum(a.r * weightA + b.r * weightB, a.i * weightA + b.i * weightB,
                   a.j * weightA + b.j * weightB, a.k * weightA + b.k * weightB);
    sum.normalise();
    return sum;
}

}  // namespace

Quaternion Quaternion::linearInterpolate(const Quaternion &a, const Quaternion &b, real prop) {
    const real sign = cosineBetween(a, b) < 0 ? -1.0 : 1.0;
    return weightedSum(a, 1 - prop, b, sign * prop);
}

Quaternion Quaternion::sphericalInterpolate(const Quaternion &a, const Quaternion &b, real prop) {
    const Quaternion between = a.conjugate() * b;
    const real sign = between.r < 0 ? -1.0 : 1.0;
    const real sine = Vector3(between.i, between.j, between.k).magnitude();
    const real angle = real_atan2(sine, sign * between.r);
    if (sine < 1e-6) return linearInterpolate(a, b, prop);
    return weightedSum(a, real_sin((1 - prop) * angle), b, sign * real_sin(prop * angle));
}

Matrix3 Matrix3::operator*(real scale) const {
    Matrix3 result = *this;
    for (real &entry : result.data) entry *= scale;
    return result;
}

Matrix3 Matrix3::operator+(const Matrix3 &m) const {
    Matrix3 result = *this;
    for (int n = 0; n < 9; ++n) result.data[n] += m.data[n];
    return result;
}

bool Matrix3::setInverse(const Matrix3 &m) {
    real largest = 0;
    for (real entry : m.data) largest = std::max(largest, real_abs(entry));
    if (!m.isFinite() || largest == 0) return false;

    // Scaled to entries of at most 1, no product below overflows, and what underflows would not count.
    const auto scaledRow = [&m, largest](unsigned n) {
        const Vector3 row = m.getRowVector(n);
        return Vector3(row.x / largest, row.y / largest, row.z / largest);
    };
    const Vector3 a = scaledRow(0), b = scaledRow(1), c = scaledRow(2);
    const real determinant = a * (b % c);
    const real products = real_abs(a.x) * (real_abs(b.y * c.z) + real_abs(b.z * c.y)) +
                          real_abs(a.y) * (real_abs(b.z * c.x) + real_abs(b.x * c.z)) +
                          real_abs(a.z) * (real_abs(b.x * c.y) + real_abs(b.y * c.x));
    if (!(real_abs(determinant) > 8 * REAL_EPSILON * products)) return false;

    const real scale = 1 / determinant / largest;
    const Matrix3 result(b % c * scale, c % a * scale, a % b * scale);
    if (!result.isFinite()) return false;
    *this = result;
    return true;
}

Matrix3 Matrix3::inverse() const {
    Matrix3 result;
    const bool regular = result.setInverse(*this);
    detail::requireMatrix(regular, "Matrix3::inverse", "the matrix must not be singular", *this);
    return result;
}

void Matrix3::setOrientation(const Quaternion &q) {
    const real ii = 2 * q.i * q.i, jj = 2 * q.j * q.j, kk = 2 * q.k * q.k;
    const real ij = 2 * q.i * q.j, ik = 2 * q.i * q.k, jk = 2 * q.j * q.k;
    const real ri = 2 * q.r * q.i, rj = 2 * q.r * q.j, rk = 2 * q.r * q.k;
    *this = Matrix3(1 - (jj + kk), ij - rk, ik + rj,   //
                    ij + rk, 1 - (ii + kk), jk - ri,   //
                    ik - rj, jk + ri, 1 - (ii + jj));  //
}

void Matrix3::setBlockInertiaTensor(const Vector3 &halfSizes, real mass) {
    detail::requireVector(halfSizes.isFinite() && halfSizes.x > 0 && halfSizes.y > 0 && halfSizes.z > 0,
                          "Matrix3::setBlockInertiaTensor", "the half sizes must be positive and finite",
                          halfSizes);
    detail::requirePositive(mass, "Matrix3::setBlockInertiaTensor", "the mass must be positive and finite");
    const Vector3 squares = halfSizes.componentProduct(halfSizes);
    const real third = mass / 3;
    setDiagonal(third * (squares.y + squares.z), third * (squares.x + squares.z),
                third * (squares.x + squares.y));
}

bool Matrix3::operator==(const Matrix3 &m) const { return std::equal(data, data + 9, m.data); }

bool Matrix3::isFinite() const {
    return std::all_of(data, data + 9, [](real entry) { return real_isfinite(entry); });
}

Matrix4 Matrix4::operator*(const Matrix4 &m) const {
    Matrix4 result;
    for (unsigned column = 0; column < 3; ++column)
        result.setAxisVector(column, transformDirection(m.getAxisVector(column)));
    result.setAxisVector(3, transform(m.getAxisVector(3)));
    return result;
}

bool Matrix4::setInverse(const Matrix4 &m) {
    Matrix3 rotation;
    if (!rotation.setInverse(m.getRotationMatrix())) return false;
    const Vector3 position = -rotation.transform(m.getAxisVector(3));
    for (unsigned column = 0; column < 3; ++column) setAxisVector(column, rotation.getAxisVector(column));
    setAxisVector(3, position);
    return true;
}

Matrix4 Matrix4::inverse() const {
    Matrix4 result;
    const bool regular = result.setInverse(*this);
    detail::require(regular, "Matrix4::inverse", "the matrix must not be singular",
                    {data[0], data[1], data[2], data[3], data[4], data[5], data[6], data[7], data[8], data[9],
                     data[10], data[11]});
    return result;
}

void Matrix4::setOrientationAndPos(const Quaternion &q, const Vector3 &position) {
    Matrix3 rotation;
    rotation.setOrientation(q);
    for (unsigned column = 0; column < 3; ++column) setAxisVector(column, rotation.getAxisVector(column));
    setAxisVector(3, position);
}

void Matrix4::fillGLArray(real array[16]) const {
    for (unsigned column = 0; column < 4; ++column) {
        for (unsigned row = 0; row < 3; ++row) array[4 * column + row] = data[4 * row + column];
        array[4 * column + 3] = column == 3 ? 1 : 0;
    }
}

void Matrix4::fillGLArray(float array[16]) const {
    real precise[16];
    fillGLArray(precise);
    std::transform(precise, precise + 16, array, [](real entry) { return static_cast<float>(entry); });
}

bool Matrix4::operator==(const Matrix4 &m) const { return std::equal(data, data + 12, m.data); }

}  // namespace cyclone
