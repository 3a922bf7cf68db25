#include "principalaxes.h"

#include <algorithm>

namespace cyclone {
namespace detail {

bool isSymmetric(const Matrix3 &m) {
    const real size = std::max({real_abs(m.data[0]), real_abs(m.data[4]), real_abs(m.data[8])});
    const real tolerance = 1e-9 * size;
    return real_abs(m.data[1] - m.data[3]) <= tolerance && real_abs(m.data[2] - m.data[6]) <= tolerance &&
           real_abs(m.data[5] - m.data[7]) <= tolerance;
}

bool areBearable(const Vector3 &moments) {
    real least = REAL_MAX, greatest = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const real moment = moments[axis];
        if (moment > REAL_MAX) continue;
        if (!(moment >= 1e-100 && moment <= 1e100)) return false;
        least = std::min(least, moment);
        greatest = std::max(greatest, moment);
    }
    return greatest <= 1e12 * least;
}

namespace {

/// The rotation about `axis` (0, 1, 2) that clears the entry between the two other axes, its angle within
/// ±45°.
Quaternion jacobiRotation(const Matrix3 &m, unsigned axis) {
    const unsigned p = (axis + 1) % 3, q = (axis + 2) % 3;
    const real offDiagonal = p < q ? m.data[3 * p + q] : m.data[3 * q + p];
    const real theta = (m.data[4 * q] - m.data[4 * p]) / (2 * offDiagonal);
    const real tangent = (theta < 0 ? -1.0 : 1.0) / (real_abs(theta) + real_sqrt(theta * theta + 1));
    const real cosine = 1 / real_sqrt(tangent * tangent + 1);
    const real halfCosine = real_sqrt((1 + cosine) / 2);
    Vector3 halfSine;
    halfSine[axis] = -tangent * cosine / (2 * halfCosine);
    return Quaternion(halfCosine, halfSine.x, halfSine.y, halfSine.z);
}

}  // namespace

void findPrincipalAxes(const Matrix3 &m, Vector3 &values, Quaternion &axes) {
    axes = Quaternion();
    Matrix3 turned = m;
    for (int rotation = 0; rotation < 40; ++rotation) {
        const real offDiagonals[3] = {real_abs(turned.data[5]), real_abs(turned.data[2]),
                                      real_abs(turned.data[1])};
        const auto *const largest = std::max_element(offDiagonals, offDiagonals + 3);
        const real size =
            std::max({real_abs(turned.data[0]), real_abs(turned.data[4]), real_abs(turned.data[8])});
        if (!(*largest > REAL_EPSILON / 4 * size)) break;

        axes *= jacobiRotation(turned, static_cast<unsigned>(largest - offDiagonals));
        axes.normalise();
        Matrix3 basis;
        basis.setOrientation(axes);
        turned = basis.transpose() * m * basis;
    }
    values = Vector3(turned.data[0], turned.data[4], turned.data[8]);
}

Matrix3 tensorFromPrincipalAxes(const Quaternion &axes, const Vector3 &values) {
    Matrix3 basis;
    basis.setOrientation(axes);
    const Vector3 x = basis.getRowVector(0), y = basis.getRowVector(1), z = basis.getRowVector(2);
    const Vector3 vx = values.componentProduct(x), vy = values.componentProduct(y);
    const real xy = vx * y, xz = vx * z, yz = vy * z;
    return Matrix3(vx * x, xy, xz, xy, vy * y, yz, xz, yz, values.componentProduct(z) * z);
}

}  // namespace detail
}  // namespace cyclone
