#pragma once

/// @file
/// The core mathematics: vectors, quaternions, and 3×3 and 3×4 matrices. No physics in it.
///
/// Axes are right-handed. A vector is a column on the right of a matrix; matrices are stored row by row.
/// These are plain values: they hold whatever numbers they are given, and only operations that would
/// otherwise have no answer (the inverse of a singular matrix) refuse.
#include <cyclone/check.h>
#include <cyclone/precision.h>

#include <cassert>

namespace cyclone {

/// A vector in three dimensions. Zero by default.
class Vector3 {
public:
    real x = 0, y = 0, z = 0;

    constexpr Vector3() = default;
    constexpr Vector3(real a, real b, real c) : x(a), y(b), z(c) {}

    static const Vector3 GRAVITY;  ///< (0, −9.81, 0) m/s²
    static const Vector3 UP;       ///< (0, 1, 0)
    static const Vector3 RIGHT;    ///< (1, 0, 0)
    static const Vector3 X, Y, Z;  ///< the unit vectors of the axes

    /// Component 0, 1 or 2.
    real operator[](unsigned index) const {
        assert(index < 3);
        return index == 0 ? x : index == 1 ? y : z;
    }
    real &operator[](unsigned index) {
        assert(index < 3);
        return index == 0 ? x : index == 1 ? y : z;
    }

    constexpr Vector3 operator+(const Vector3 &v) const { return Vector3(x + v.x, y + v.y, z + v.z); }
    constexpr Vector3 operator-(const Vector3 &v) const { return Vector3(x - v.x, y - v.y, z - v.z); }
    constexpr Vector3 operator*(real scale) const { return Vector3(x * scale, y * scale, z * scale); }
    friend constexpr Vector3 operator*(real scale, const Vector3 &v) { return v * scale; }
    constexpr Vector3 operator-() const { return Vector3(-x, -y, -z); }

    void operator+=(const Vector3 &v) { *this = *this + v; }
    void operator-=(const Vector3 &v) { *this = *this - v; }
    void operator*=(real scale) { *this = *this * scale; }
    void addScaledVector(const Vector3 &v, real scale) { *this += v * scale; }

    constexpr real scalarProduct(const Vector3 &v) const { return x * v.x + y * v.y + z * v.z; }
    constexpr real operator*(const Vector3 &v) const { return scalarProduct(v); }

    constexpr Vector3 vectorProduct(const Vector3 &v) const {
        return Vector3(y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x);
    }
    constexpr Vector3 operator%(const Vector3 &v) const { return vectorProduct(v); }
    void operator%=(const Vector3 &v) { *this = vectorProduct(v); }

    /// Multiplies component by component.
    constexpr Vector3 componentProduct(const Vector3 &v) const { return Vector3(x * v.x, y * v.y, z * v.z); }
    void componentProductUpdate(const Vector3 &v) { *this = componentProduct(v); }

    constexpr real squareMagnitude() const { return x * x + y * y + z * z; }
    real magnitude() const { return real_sqrt(squareMagnitude()); }

    /// Makes the length 1, whatever it was; a zero vector, or one that is not finite, stays as it is.
    CYCLONE_API void normalise();
    Vector3 unit() const {
        Vector3 result = *this;
        result.normalise();
        return result;
    }

    /// Shortens the vector to `size`, not negative, where it is longer.
    CYCLONE_API void trim(real size);
    void invert() { *this = -*this; }
    void clear() { *this = Vector3(); }

    constexpr bool operator==(const Vector3 &v) const { return x == v.x && y == v.y && z == v.z; }
    constexpr bool operator!=(const Vector3 &v) const { return !(*this == v); }

    bool isFinite() const { return real_isfinite(x) && real_isfinite(y) && real_isfinite(z); }
};

inline constexpr Vector3 Vector3::GRAVITY(0, -9.81, 0);
inline constexpr Vector3 Vector3::UP(0, 1, 0);
inline constexpr Vector3 Vector3::RIGHT(1, 0, 0);
inline constexpr Vector3 Vector3::X(1, 0, 0);
inline constexpr Vector3 Vector3::Y(0, 1, 0);
inline constexpr Vector3 Vector3::Z(0, 0, 1);

/// An orientation or a rotation: cos(angle/2) + axis·sin(angle/2). As an orientation it is of unit length and
/// turns body coordinates into world coordinates; q and −q are the same one. The identity by default.
class CYCLONE_API Quaternion {
public:
    real r = 1, i = 0, j = 0, k = 0;

    constexpr Quaternion() = default;
    constexpr Quaternion(real a, real b, real c, real d) : r(a), i(b), j(c), k(d) {}

    /// The rotation by `angle` rad about `axis`, right-handed. The axis need not be of unit length; about a
    /// zero axis nothing turns.
    static Quaternion fromAxisAngle(const Vector3 &axis, real angle);

    constexpr real squareMagnitude() const { return r * r + i * i + j * j + k * k; }
    /// Makes the length 1; a zero quaternion becomes the identity.
    void normalise();

    /// Hamilton's product: a·b turns by b first, then by a.
    constexpr Quaternion operator*(const Quaternion &b) const {
        return Quaternion(r * b.r - i * b.i - j * b.j - k * b.k,   //
                          r * b.i + i * b.r + j * b.k - k * b.j,   //
                          r * b.j + j * b.r + k * b.i - i * b.k,   //
                          r * b.k + k * b.r + i * b.j - j * b.i);  //
    }
    void operator*=(const Quaternion &b) { *this = *this * b; }

    /// The rotation backwards, for a unit quaternion.
    constexpr Quaternion conjugate() const { return Quaternion(r, -i, -j, -k); }

    /// The vector turned by this unit quaternion: from body to world, for an orientation.
    constexpr Vector3 rotate(const Vector3 &v) const {
        const Vector3 axis(i, j, k);
        const Vector3 t = 2 * (axis % v);
        return v + r * t + axis % t;
    }

    /// Adds ½·(0, v·scale)·q: the first-order change by the rotation v·scale (world, rad). Not of unit length
    /// afterwards.
    void addScaledVector(const Vector3 &v, real scale);
    /// Turns by |rotation| rad about `rotation`, an axis in world coordinates; exact for every angle.
    void rotateByVector(const Vector3 &rotation) {
        *this = fromAxisAngle(rotation, rotation.magnitude()) * *this;
    }

    /// Between a (prop 0) and b (prop 1), the short way round: along the chord, then normalised. Quick, and
    /// for the angle between two frames as good as the next one.
    static Quaternion linearInterpolate(const Quaternion &a, const Quaternion &b, real prop);
    /// Between a (prop 0) and b (prop 1), the short way round, at constant angular speed (Shoemake 1985).
    static Quaternion sphericalInterpolate(const Quaternion &a, const Quaternion &b, real prop);

    constexpr bool operator==(const Quaternion &q) const {
        return r == q.r && i == q.i && j == q.j && k == q.k;
    }
    constexpr bool operator!=(const Quaternion &q) const { return !(*this == q); }

    bool isFinite() const {
        return real_isfinite(r) && real_isfinite(i) && real_isfinite(j) && real_isfinite(k);
    }
};

/// A 3×3 matrix: a rotation, an inertia tensor, an aerodynamic tensor. All zeros by default.
class CYCLONE_API Matrix3 {
public:
    real data[9] = {};  ///< row by row

    constexpr Matrix3() = default;
    /// From its nine numbers, row by row.
    constexpr Matrix3(real c0, real c1, real c2, real c3, real c4, real c5, real c6, real c7, real c8)
        : data{c0, c1, c2, c3, c4, c5, c6, c7, c8} {}
    /// From its three columns.
    constexpr Matrix3(const Vector3 &first, const Vector3 &second, const Vector3 &third)
        : data{first.x, second.x, third.x, first.y, second.y, third.y, first.z, second.z, third.z} {}

    constexpr Vector3 getRowVector(unsigned row) const {
        assert(row < 3);
        return Vector3(data[3 * row], data[3 * row + 1], data[3 * row + 2]);
    }
    /// A column: where the matrix takes the unit vector of that axis.
    constexpr Vector3 getAxisVector(unsigned column) const {
        assert(column < 3);
        return Vector3(data[column], data[column + 3], data[column + 6]);
    }

    constexpr Vector3 transform(const Vector3 &v) const {
        return Vector3(data[0] * v.x + data[1] * v.y + data[2] * v.z,
                       data[3] * v.x + data[4] * v.y + data[5] * v.z,
                       data[6] * v.x + data[7] * v.y + data[8] * v.z);
    }
    constexpr Vector3 operator*(const Vector3 &v) const { return transform(v); }
    /// The transpose times v: for a rotation, the way back.
    constexpr Vector3 transformTranspose(const Vector3 &v) const {
        return Vector3(data[0] * v.x + data[3] * v.y + data[6] * v.z,
                       data[1] * v.x + data[4] * v.y + data[7] * v.z,
                       data[2] * v.x + data[5] * v.y + data[8] * v.z);
    }

    constexpr Matrix3 operator*(const Matrix3 &m) const {
        return Matrix3(transform(m.getAxisVector(0)), transform(m.getAxisVector(1)),
                       transform(m.getAxisVector(2)));
    }
    void operator*=(const Matrix3 &m) { *this = *this * m; }
    Matrix3 operator*(real scale) const;
    void operator*=(real scale) { *this = *this * scale; }
    Matrix3 operator+(const Matrix3 &m) const;
    void operator+=(const Matrix3 &m) { *this = *this + m; }

    constexpr real getDeterminant() const { return getRowVector(0) * (getRowVector(1) % getRowVector(2)); }
    /// Becomes the inverse of m, which may be this matrix itself. Returns false, and changes nothing, when m
    /// is singular: when its determinant does not stand out from the rounding of the products it is summed
    /// from.
    bool setInverse(const Matrix3 &m);
    bool invert() { return setInverse(*this); }
    /// The inverse; refuses a singular matrix.
    Matrix3 inverse() const;

    void setTranspose(const Matrix3 &m) { *this = m.transpose(); }
    constexpr Matrix3 transpose() const { return Matrix3(getRowVector(0), getRowVector(1), getRowVector(2)); }

    /// The rotation matrix of a unit quaternion.
    void setOrientation(const Quaternion &q);
    void setDiagonal(real a, real b, real c) { *this = Matrix3(a, 0, 0, 0, b, 0, 0, 0, c); }
    /// Times w, this matrix is then v × w.
    void setSkewSymmetric(const Vector3 &v) { *this = Matrix3(0, -v.z, v.y, v.z, 0, -v.x, -v.y, v.x, 0); }
    /// From moments (∫(y²+z²)dm …) and products of inertia (∫xy dm …), kg·m²; the products enter with a
    /// minus.
    void setInertiaTensorCoeffs(real ix, real iy, real iz, real ixy = 0, real ixz = 0, real iyz = 0) {
        *this = Matrix3(ix, -ixy, -ixz, -ixy, iy, -iyz, -ixz, -iyz, iz);
    }
    /// The inertia tensor of a solid block about its centre, from half its edges (m): Ix = m(hy² + hz²)/3.
    /// Half sizes and mass (kg) positive and finite.
    void setBlockInertiaTensor(const Vector3 &halfSizes, real mass);

    /// Entry by entry between a (prop 0) and b (prop 1).
    static Matrix3 linearInterpolate(const Matrix3 &a, const Matrix3 &b, real prop) {
        return a * (1 - prop) + b * prop;
    }

    bool operator==(const Matrix3 &m) const;
    bool operator!=(const Matrix3 &m) const { return !(*this == m); }

    bool isFinite() const;
};

/// An affine transform, 3×4: its last column moves, its fourth row (0 0 0 1) is implied. The identity by
/// default. As a body's transform it takes body coordinates to world coordinates, and its 3×3 part is a
/// rotation.
class CYCLONE_API Matrix4 {
public:
    real data[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};  ///< row by row

    constexpr Matrix4() = default;
    /// From its twelve numbers, row by row.
    constexpr Matrix4(real c0, real c1, real c2, real c3, real c4, real c5, real c6, real c7, real c8,
                      real c9, real c10, real c11)
        : data{c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11} {}

    /// Column 0, 1 or 2: where the transform takes the direction of that axis; column 3: where it takes the
    /// origin.
    constexpr Vector3 getAxisVector(unsigned column) const {
        assert(column < 4);
        return Vector3(data[column], data[column + 4], data[column + 8]);
    }
    void setAxisVector(unsigned column, const Vector3 &v) {
        assert(column < 4);
        data[column] = v.x;
        data[column + 4] = v.y;
        data[column + 8] = v.z;
    }

    /// A direction: turned, not moved.
    constexpr Vector3 transformDirection(const Vector3 &v) const {
        return Vector3(data[0] * v.x + data[1] * v.y + data[2] * v.z,
                       data[4] * v.x + data[5] * v.y + data[6] * v.z,
                       data[8] * v.x + data[9] * v.y + data[10] * v.z);
    }
    /// A direction, backwards. Only for a transform whose 3×3 part is a rotation.
    constexpr Vector3 transformInverseDirection(const Vector3 &v) const {
        return Vector3(data[0] * v.x + data[4] * v.y + data[8] * v.z,
                       data[1] * v.x + data[5] * v.y + data[9] * v.z,
                       data[2] * v.x + data[6] * v.y + data[10] * v.z);
    }
    /// A point: turned and moved.
    constexpr Vector3 transform(const Vector3 &point) const {
        return transformDirection(point) + getAxisVector(3);
    }
    constexpr Vector3 operator*(const Vector3 &point) const { return transform(point); }
    /// A point, backwards. Only for a transform whose 3×3 part is a rotation.
    constexpr Vector3 transformInverse(const Vector3 &point) const {
        return transformInverseDirection(point - getAxisVector(3));
    }

    Matrix4 operator*(const Matrix4 &m) const;
    void operator*=(const Matrix4 &m) { *this = *this * m; }

    constexpr real getDeterminant() const { return getAxisVector(0) * (getAxisVector(1) % getAxisVector(2)); }
    /// Becomes the inverse of m, which may be this matrix itself. Returns false, and changes nothing, when m
    /// is singular.
    bool setInverse(const Matrix4 &m);
    bool invert() { return setInverse(*this); }
    /// The inverse; refuses a singular matrix.
    Matrix4 inverse() const;

    /// The transform that turns by the unit quaternion q, then moves to `position`.
    void setOrientationAndPos(const Quaternion &q, const Vector3 &position);
    /// The 3×3 part.
    constexpr Matrix3 getRotationMatrix() const {
        return Matrix3(getAxisVector(0), getAxisVector(1), getAxisVector(2));
    }

    /// Sixteen floats, column by column, with the implied row: what OpenGL, and Vulkan and Direct3D shaders
    /// that multiply columns, take.
    void fillGLArray(float array[16]) const;
    /// The same in double precision.
    void fillGLArray(real array[16]) const;

    bool operator==(const Matrix4 &m) const;
    bool operator!=(const Matrix4 &m) const { return !(*this == m); }
};

}  // namespace cyclone
