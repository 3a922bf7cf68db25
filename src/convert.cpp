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

AxisConvention::AxisConvention(const Vector3 &forward, const Vector3 &up, const Vector3 &right,
                               real hostUnitsPerMetre)
    : axes(forward, up, right), unitsPerMetre(hostUnitsPerMetre) {
    requireMatrix(isOrthonormal(axes), "AxisConvention::AxisConvention",
                  "the axes must be unit vectors at right angles", axes);
    require(unitsPerMetre > 0 && unitsPerMetre <= REAL_MAX && real_isfinite(1 / unitsPerMetre),
            "AxisConvention::AxisConvention", "the host's units in a metre must be positive and finite",
            {unitsPerMetre});
    handedness = axes.getDeterminant() < 0 ? -1 : 1;
}

AxisConvention AxisConvention::unreal() {
    return AxisConvention(Vector3(1, 0, 0), Vector3(0, 0, 1), Vector3(0, 1, 0), 100);
}
AxisConvention AxisConvention::unity() {
    return AxisConvention(Vector3(0, 0, 1), Vector3(0, 1, 0), Vector3(1, 0, 0));
}
AxisConvention AxisConvention::godot() {
    return AxisConvention(Vector3(0, 0, -1), Vector3(0, 1, 0), Vector3(1, 0, 0));
}

void AxisConvention::setOrigin(const Vector3 &worldPoint) {
    requireFinite(worldPoint, "AxisConvention::setOrigin", "the origin must be finite");
    origin = worldPoint;
}

// The axis of a rotation is itself a rotation vector, scaled.

Quaternion AxisConvention::getOrientationInHost(const Quaternion &orientation) const {
    const Vector3 axis = getRotationInHost(Vector3(orientation.i, orientation.j, orientation.k));
    return Quaternion(orientation.r, axis.x, axis.y, axis.z);
}

Quaternion AxisConvention::getOrientationInCyclone(const Quaternion &hostOrientation) const {
    const Vector3 axis =
        getRotationInCyclone(Vector3(hostOrientation.i, hostOrientation.j, hostOrientation.k));
    return Quaternion(hostOrientation.r, axis.x, axis.y, axis.z);
}

Matrix4 AxisConvention::getTransformInHost(const Matrix4 &transform) const {
    const Matrix3 turned = axes * transform.getRotationMatrix() * axes.transpose();
    Matrix4 result;
    for (unsigned column = 0; column < 3; ++column)
        result.setAxisVector(column, turned.getAxisVector(column));
    result.setAxisVector(3, getPointInHost(transform.getAxisVector(3)));
    return result;
}

}  // namespace cyclone
