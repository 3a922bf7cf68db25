#include <cyclone/convert.h>

#include "arguments.h"

namespace cyclone {

using namespace detail;

namespace {

/// Whether the columns are unit vectors at right angles, to within the rounding of floats.
bool isOrthonormal(const Matrix3 &m) {
    const Matrix3 products = m.transpose() * m;
    for (unsigned n = 0; n < 9; ++n)
        if (!(real_abs(products.data[n] - (n % 4 == 0 ? 1 : 0)) <= 1e-6)) return false;
    return true;
}

}  // namespace

Frame::Frame(const Vector3 &forward, const Vector3 &up, const Vector3 &right, real hostUnitsPerMetre)
    : axes(forward, up, right), unitsPerMetre(hostUnitsPerMetre) {
    requireMatrix(isOrthonormal(axes), "Frame::Frame", "the axes must be unit vectors at right angles", axes);
    require(unitsPerMetre > 0 && unitsPerMetre <= REAL_MAX && real_isfinite(1 / unitsPerMetre),
            "Frame::Frame", "the host's units in a metre must be positive and finite", {unitsPerMetre});
    handedness = axes.getDeterminant() < 0 ? -1 : 1;
}

Frame Frame::unreal() { return Frame(Vector3(1, 0, 0), Vector3(0, 0, 1), Vector3(0, 1, 0), 100); }
Frame Frame::unity() { return Frame(Vector3(0, 0, 1), Vector3(0, 1, 0), Vector3(1, 0, 0)); }
Frame Frame::godot() { return Frame(Vector3(0, 0, -1), Vector3(0, 1, 0), Vector3(1, 0, 0)); }

void Frame::setOrigin(const Vector3 &worldPoint) {
    requireFinite(worldPoint, "Frame::setOrigin", "the origin must be finite");
    origin = worldPoint;
}

// The axis of a rotation is itself a rotation vector, scaled.

Quaternion Frame::getOrientationInHost(const Quaternion &orientation) const {
    const Vector3 axis = getRotationInHost(Vector3(orientation.i, orientation.j, orientation.k));
    return Quaternion(orientation.r, axis.x, axis.y, axis.z);
}

Quaternion Frame::getOrientationInCyclone(const Quaternion &hostOrientation) const {
    const Vector3 axis =
        getRotationInCyclone(Vector3(hostOrientation.i, hostOrientation.j, hostOrientation.k));
    return Quaternion(hostOrientation.r, axis.x, axis.y, axis.z);
}

Matrix4 Frame::getTransformInHost(const Matrix4 &transform) const {
    const Matrix3 turned = axes * transform.getRotationMatrix() * axes.transpose();
    Matrix4 result;
    for (unsigned column = 0; column < 3; ++column)
        result.setAxisVector(column, turned.getAxisVector(column));
    result.setAxisVector(3, getPointInHost(transform.getAxisVector(3)));
    return result;
}

}  // namespace cyclone
