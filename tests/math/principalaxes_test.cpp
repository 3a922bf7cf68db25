#include "../../src/principalaxes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

/// The frame must be a rotation that turns diag(values) into m, to rounding.
void expectPrincipal(const Matrix3 &m, real tolerance) {
    Vector3 values;
    Quaternion axes;
    detail::findPrincipalAxes(m, values, axes);
    EXPECT_NEAR(std::sqrt(axes.squareMagnitude()), 1, 1e-15);
    const Matrix3 turn = rotationMatrix(axes);
    const real size = std::max({real_abs(m.data[0]), real_abs(m.data[4]), real_abs(m.data[8]),
                                real_abs(m.data[1]), real_abs(m.data[2]), real_abs(m.data[5])});
    EXPECT_TRUE(
        isNear(turn * diagonal(values.x, values.y, values.z) * turn.transpose(), m, tolerance * size));
}

Matrix3 symmetric(real xx, real yy, real zz, real xy, real xz, real yz) {
    return Matrix3(xx, xy, xz, xy, yy, yz, xz, yz, zz);
}

TEST(PrincipalAxes, OfRandomSymmetricMatrices) {
    Random random(24);
    for (int n = 0; n < 2000; ++n) {
        const Vector3 d = random.vector(), o = random.vector();
        expectPrincipal(symmetric(d.x, d.y, d.z, o.x, o.y, o.z), 4e-15);
        expectPrincipal(symmetric(d.x, d.y, d.z, o.x, o.y, o.z) * 1e-100, 4e-15);
        expectPrincipal(symmetric(d.x, d.y, d.z, o.x, o.y, o.z) * 1e100, 4e-15);
        expectPrincipal(symmetric(d.x, d.y, d.z, o.x * 1e-8, o.y * 1e-12, o.z * 1e-15), 4e-15);
        expectPrincipal(symmetric(0, 0, 0, o.x, o.y, o.z), 4e-15);
    }
}

TEST(PrincipalAxes, ValuesAreThoseThatTheMatrixWasMadeFrom) {
    Random random(25);
    for (int n = 0; n < 500; ++n) {
        real wanted[3] = {random.between(0.5, 1), random.between(1.5, 3), random.between(4, 8)};
        const Matrix3 turn = rotationMatrix(random.orientation());
        const Matrix3 product = turn * diagonal(wanted[0], wanted[1], wanted[2]) * turn.transpose();
        Vector3 values;
        Quaternion axes;
        detail::findPrincipalAxes((product + product.transpose()) * 0.5, values, axes);
        real got[3] = {values.x, values.y, values.z};
        std::sort(got, got + 3);
        EXPECT_TRUE(allNear(got, wanted, 3, 3e-14));
    }
}

TEST(PrincipalAxes, OfADiagonalMatrixAreTheIdentityAndExact) {
    for (const Vector3 &wanted : {Vector3(1, 2, 3), Vector3(0.1, 0.1, 0.1), Vector3(1e-300, 1, 1e300),
                                  Vector3(3, -2, 0), Vector3(), Vector3(0.3, 0.1, 0.3)}) {
        Vector3 values;
        Quaternion axes(0, 1, 0, 0);
        detail::findPrincipalAxes(diagonal(wanted.x, wanted.y, wanted.z), values, axes);
        EXPECT_EQ(values, wanted);
        EXPECT_EQ(axes, Quaternion());
    }
}

TEST(PrincipalAxes, WithRepeatedValuesAndExtremeRatios) {
    Random random(26);
    for (int n = 0; n < 300; ++n) {
        const Matrix3 turn = rotationMatrix(random.orientation());
        for (const Vector3 &v : {Vector3(1, 1, 2), Vector3(2, 1, 1), Vector3(1, 1, 1), Vector3(0, 0, 1),
                                 Vector3(1e-12, 1, 1), Vector3(1e-15, 1e-8, 1), Vector3(1, 1 + 1e-14, 2)}) {
            const Matrix3 product = turn * diagonal(v.x, v.y, v.z) * turn.transpose();
            expectPrincipal((product + product.transpose()) * 0.5, 4e-15);
        }
    }
    expectPrincipal(symmetric(1, 1, 1, 1, 1, 1), 4e-15);
    expectPrincipal(symmetric(1, 1, 1, 1e-16, 0, 0), 4e-15);
}

TEST(PrincipalAxes, OfATurnedBlockLieAlongItsEdges) {
    Matrix3 block;
    block.setBlockInertiaTensor(Vector3(1, 2, 3), 12);  // 52, 40, 20
    const Matrix3 turn = rotationMatrix(Quaternion::fromAxisAngle(Vector3::Z, REAL_PI / 6));
    Vector3 values;
    Quaternion axes;
    detail::findPrincipalAxes(turn * block * turn.transpose(), values, axes);
    EXPECT_TRUE(isNear(values, Vector3(52, 40, 20), 1e-13));
    EXPECT_TRUE(turnsLike(axes, Quaternion::fromAxisAngle(Vector3::Z, REAL_PI / 6), 1e-15));
}

}  // namespace
