#include <cyclone/core.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

constexpr real TINY = std::numeric_limits<real>::denorm_min();
const Matrix3 IDENTITY = diagonal(1, 1, 1);

// ---- Vector3

TEST(Vector3, ConstantsFormARightHandedFrame) {
    EXPECT_EQ(Vector3::X % Vector3::Y, Vector3::Z);
    EXPECT_EQ(Vector3::Y % Vector3::Z, Vector3::X);
    EXPECT_EQ(Vector3::Z % Vector3::X, Vector3::Y);
    EXPECT_EQ(Vector3::UP, Vector3::Y);
    EXPECT_EQ(Vector3::RIGHT, Vector3::X);
    EXPECT_EQ(Vector3::GRAVITY, Vector3(0, -9.81, 0));
    EXPECT_EQ(Vector3(), Vector3(0, 0, 0));
}

TEST(Vector3, ComponentsByIndex) {
    Vector3 v(1, 2, 3);
    const Vector3 &fixed = v;
    EXPECT_EQ(fixed[0], 1);
    EXPECT_EQ(fixed[1], 2);
    EXPECT_EQ(fixed[2], 3);
    for (unsigned n = 0; n < 3; ++n) v[n] *= -2;
    EXPECT_EQ(v, Vector3(-2, -4, -6));
}

TEST(Vector3, ProductsObeyTheirLaws) {
    Random random(1);
    for (int n = 0; n < 1000; ++n) {
        const Vector3 a = random.vector(), b = random.vector(), c = random.vector();
        EXPECT_NEAR((a % b) * a, 0, 1e-15);
        EXPECT_NEAR((a % b) * b, 0, 1e-15);
        EXPECT_EQ(a % b, -(b % a));
        // Lagrange's and Jacobi's identities.
        EXPECT_NEAR((a % b).squareMagnitude() + (a * b) * (a * b), a.squareMagnitude() * b.squareMagnitude(),
                    1e-14);
        EXPECT_TRUE(isNear(a % (b % c) + b % (c % a), -(c % (a % b)), 1e-14));
        EXPECT_NEAR((a + b).squareMagnitude() - (a - b).squareMagnitude(), 4 * (a * b), 1e-14);
        EXPECT_EQ(a.scalarProduct(b), a * b);
        EXPECT_EQ(a.vectorProduct(b), a % b);
        EXPECT_NEAR(a.componentProduct(b) * Vector3(1, 1, 1), a * b, 1e-15);
        EXPECT_NEAR(a.magnitude() * a.magnitude(), a * a, 1e-15);
    }
}

TEST(Vector3, InPlaceOperationsEqualTheCopyingOnes) {
    Random random(2);
    const Vector3 a = random.vector(), b = random.vector();
    Vector3 v = a;
    v += b;
    EXPECT_EQ(v, a + b);
    v = a;
    v -= b;
    EXPECT_EQ(v, a - b);
    v = a;
    v *= 3;
    EXPECT_EQ(v, a * 3);
    EXPECT_EQ(v, 3 * a);
    v = a;
    v.addScaledVector(b, 0.7);
    EXPECT_EQ(v, a + b * 0.7);
    v = a;
    v %= b;
    EXPECT_EQ(v, a % b);
    v = a;
    v.componentProductUpdate(b);
    EXPECT_EQ(v, a.componentProduct(b));
    v = a;
    v.invert();
    EXPECT_EQ(v + a, Vector3());
    v.clear();
    EXPECT_EQ(v, Vector3());
    EXPECT_TRUE(a != b && a == a);
    v = a;
    const Vector3 &itself = v;
    v += itself;
    v %= itself;
    EXPECT_EQ(v, Vector3());
}

TEST(Vector3, EqualityLooksAtEveryComponent) {
    const Vector3 v(1, 2, 3);
    EXPECT_NE(v, Vector3(0, 2, 3));
    EXPECT_NE(v, Vector3(1, 0, 3));
    EXPECT_NE(v, Vector3(1, 2, 0));
}

TEST(Vector3, NormaliseKeepsDirectionAtEverySize) {
    for (real size : {TINY, 1e-310, 1e-200, 1e-141, 1e-140, 1.0, 1e150, 1e155, 1e300, REAL_MAX}) {
        for (const Vector3 &direction : {Vector3(1, 0, 0), Vector3(0, -1, 0), Vector3(1, 1, -1)}) {
            Vector3 v = direction * size;
            v.normalise();
            const real length = 1 / real_sqrt(direction.squareMagnitude());
            EXPECT_TRUE(isNear(v, direction * length, 1e-15)) << "size " << size;
            EXPECT_EQ((direction * size).unit(), v);
        }
    }
    EXPECT_TRUE(isNear(Vector3(3e-200, 0, 4e-200).unit(), Vector3(0.6, 0, 0.8), 1e-15));
    EXPECT_TRUE(isNear(Vector3(3e200, 0, 4e200).unit(), Vector3(0.6, 0, 0.8), 1e-15));
    EXPECT_TRUE(isNear(Vector3(1e300, 1e-300, 0).unit(), Vector3(1, 0, 0), 1e-15));
}

TEST(Vector3, NormaliseLeavesWhatHasNoDirection) {
    Vector3 v;
    v.normalise();
    EXPECT_EQ(v, Vector3());
    v = Vector3(1, PLUS_INFINITY, 2);
    v.normalise();
    EXPECT_EQ(v, Vector3(1, PLUS_INFINITY, 2));
    v = Vector3(1, 2, QUIET_NAN);
    v.normalise();
    EXPECT_EQ(v.x, 1);
    EXPECT_EQ(v.y, 2);
    EXPECT_NE(v.z, v.z);
}

TEST(Vector3, TrimShortensOnlyWhatIsLonger) {
    Vector3 v(3, 0, 4);
    v.trim(5);
    EXPECT_EQ(v, Vector3(3, 0, 4));
    v.trim(2.5);
    EXPECT_TRUE(isNear(v, Vector3(1.5, 0, 2), 1e-15));
    v.trim(0);
    EXPECT_EQ(v, Vector3());
    v = Vector3(0, 1e300, 0);
    v.trim(10);
    EXPECT_TRUE(isNear(v, Vector3(0, 10, 0), 1e-14));
}

TEST(Vector3, TrimWorksAtEverySize) {
    for (real size : {1e-300, 1e-180, 1e180, 1e300}) {
        Vector3 v(0, 8 * size, 0);
        v.trim(2 * size);
        EXPECT_NEAR(v.y / size, 2, 1e-14) << size;
        v.trim(3 * size);
        EXPECT_NEAR(v.y / size, 2, 1e-14) << size;
    }
}

TEST(Vector3, IsFiniteLooksAtEveryComponent) {
    EXPECT_TRUE(Vector3(REAL_MAX, -REAL_MAX, 0).isFinite());
    for (real bad : {QUIET_NAN, PLUS_INFINITY, -PLUS_INFINITY})
        for (unsigned n = 0; n < 3; ++n) {
            Vector3 v;
            v[n] = bad;
            EXPECT_FALSE(v.isFinite());
        }
}

// ---- Matrix3

TEST(Matrix3, RowsAndColumns) {
    const Matrix3 m(1, 2, 3, 4, 5, 6, 7, 8, 9);
    EXPECT_EQ(m.getRowVector(1), Vector3(4, 5, 6));
    EXPECT_EQ(m.getAxisVector(1), Vector3(2, 5, 8));
    EXPECT_EQ(m, Matrix3(Vector3(1, 4, 7), Vector3(2, 5, 8), Vector3(3, 6, 9)));
    EXPECT_EQ(m * Vector3::X, m.getAxisVector(0));
    EXPECT_EQ(m * Vector3::Z, m.getAxisVector(2));
    EXPECT_EQ(m.data[5], 6);
    EXPECT_EQ(Matrix3() * Vector3(1, 2, 3), Vector3());
    for (int n = 0; n < 9; ++n) {
        Matrix3 other = m;
        other.data[n] = 0;
        EXPECT_NE(m, other);
        other.data[n] = QUIET_NAN;
        EXPECT_FALSE(other.isFinite());
    }
    EXPECT_TRUE(m.isFinite());
}

TEST(Matrix3, ProductsComposeAndTransposesReverse) {
    Random random(3);
    for (int n = 0; n < 300; ++n) {
        const Matrix3 a = random.matrix(), b = random.matrix(), c = random.matrix();
        const Vector3 v = random.vector(), w = random.vector();
        EXPECT_TRUE(isNear(a * b * v, a * (b * v), 1e-14));
        EXPECT_TRUE(isNear((a * b) * c, a * (b * c), 1e-14));
        EXPECT_TRUE(isNear((a * b).transpose(), b.transpose() * a.transpose(), 1e-15));
        EXPECT_EQ(a.transform(v), a * v);
        EXPECT_TRUE(isNear(a.transformTranspose(v), a.transpose() * v, 1e-15));
        EXPECT_NEAR((a * v) * w, v * a.transformTranspose(w), 1e-14);
        EXPECT_EQ(a.transpose().transpose(), a);
        EXPECT_TRUE(isNear((a + b) * v, a * v + b * v, 1e-14));
        EXPECT_TRUE(isNear((a * 2.5) * v, (a * v) * 2.5, 1e-14));
        EXPECT_NEAR((a * b).getDeterminant(), a.getDeterminant() * b.getDeterminant(), 1e-14);
    }
}

TEST(Matrix3, InPlaceOperationsEqualTheCopyingOnes) {
    Random random(4);
    const Matrix3 a = random.matrix(), b = random.matrix();
    Matrix3 m = a;
    m *= b;
    EXPECT_EQ(m, a * b);
    m = a;
    m *= 3;
    EXPECT_EQ(m, a * 3);
    m = a;
    m += b;
    EXPECT_EQ(m, a + b);
    m.setTranspose(a);
    EXPECT_EQ(m, a.transpose());
    m.setTranspose(m);
    EXPECT_EQ(m, a);
    m *= m;
    EXPECT_EQ(m, a * a);
}

TEST(Matrix3, InverseTimesItselfIsTheIdentity) {
    Random random(5);
    for (int n = 0; n < 1000; ++n) {
        const Matrix3 m = random.matrix();
        const real determinant = m.getDeterminant();
        if (real_abs(determinant) < 0.01) continue;
        const Matrix3 inverse = m.inverse();
        EXPECT_TRUE(isNear(m * inverse, IDENTITY, 1e-12));
        EXPECT_TRUE(isNear(inverse * m, IDENTITY, 1e-12));
        EXPECT_NEAR(inverse.getDeterminant() * determinant, 1, 1e-12);

        Matrix3 target, itself = m, inverted = m;
        EXPECT_TRUE(target.setInverse(m));
        EXPECT_TRUE(itself.setInverse(itself));
        EXPECT_TRUE(inverted.invert());
        EXPECT_EQ(target, inverse);
        EXPECT_EQ(itself, inverse);
        EXPECT_EQ(inverted, inverse);
    }
}

TEST(Matrix3, InverseOfTinyAndHugeMatrices) {
    Random random(6);
    const Matrix3 turn = rotationMatrix(random.orientation());
    for (real scale : {1e-140, 1e-110, 1e-100, 1e-20, 1.0, 1e20, 1e100, 1e110, 1e140}) {
        const Matrix3 m = turn * diagonal(scale, 2 * scale, scale / 3);
        Matrix3 inverse;
        ASSERT_TRUE(inverse.setInverse(m)) << "scale " << scale;
        EXPECT_TRUE(isNear(inverse * m, IDENTITY, 1e-13)) << "scale " << scale;
    }
    const Matrix3 mixed = diagonal(1e-12, 1, 1e12);
    EXPECT_TRUE(isNear(mixed.inverse() * mixed, IDENTITY, 1e-15));
}

/// Refused in every form, and nothing changed.
void expectSingular(const Matrix3 &m) {
    const Matrix3 before(1, 2, 3, 4, 5, 6, 7, 8, 10);
    Matrix3 target = before;
    EXPECT_FALSE(target.setInverse(m));
    EXPECT_EQ(target, before);
    Matrix3 itself = m;
    EXPECT_FALSE(itself.invert());
    EXPECT_EQ(itself, m);
    EXPECT_THROW(m.inverse(), std::invalid_argument);
}

TEST(Matrix3, SingularMatricesHaveNoInverse) {
    expectSingular(Matrix3());
    expectSingular(diagonal(1, 0, 1));
    expectSingular(diagonal(REAL_MAX, REAL_MAX, 0));
    expectSingular(Matrix3(1, 2, 3, 4, 5, 6, 7, 8, 9));
    expectSingular(Matrix3(0.1, 0.2, 0.3, 0.3, 0.6, 0.9, 0.7, 0.1, 0.2));
    Random random(7);
    for (int n = 0; n < 1000; ++n) {
        const Vector3 a = random.vector(), b = random.vector(), c = random.vector(), d = random.vector();
        const Matrix3 rankOne(a * b.x, a * b.y, a * b.z);
        expectSingular(rankOne);
        expectSingular(rankOne + Matrix3(c * d.x, c * d.y, c * d.z));
        expectSingular((rankOne + Matrix3(c * d.x, c * d.y, c * d.z)) * 1e-30);
        Matrix3 skew;
        skew.setSkewSymmetric(a);
        expectSingular(skew);
    }
    Matrix3 target = IDENTITY;
    EXPECT_FALSE(target.setInverse(diagonal(1, QUIET_NAN, 1)));
    EXPECT_FALSE(target.setInverse(diagonal(1, PLUS_INFINITY, 1)));
    EXPECT_EQ(target, IDENTITY);
}

TEST(Matrix3, NearlySingularMatricesAreInverted) {
    Random random(8);
    for (int n = 0; n < 100; ++n) {
        const Matrix3 left = rotationMatrix(random.orientation()),
                      right = rotationMatrix(random.orientation());
        const Matrix3 m = left * diagonal(1, 1, 1e-9) * right;
        Matrix3 inverse;
        ASSERT_TRUE(inverse.setInverse(m));
        EXPECT_TRUE(isNear(m * inverse, IDENTITY, 1e-5));  // rounding times the condition number, 1e9
    }
}

TEST(Matrix3, RefusedInverseQuotesTheMatrix) {
    try {
        Matrix3(1, 2, 3, 4, 5, 6, 7, 8, 9).inverse();
        FAIL();
    } catch (const std::invalid_argument &error) {
        EXPECT_STREQ(error.what(),
                     "Matrix3::inverse: the matrix must not be singular, not (1, 2, 3, 4, 5, 6, 7, 8, 9)");
    }
}

TEST(Matrix3, SkewSymmetricMatrixIsTheVectorProduct) {
    Random random(9);
    for (int n = 0; n < 100; ++n) {
        const Vector3 v = random.vector(), w = random.vector();
        Matrix3 skew;
        skew.setSkewSymmetric(v);
        EXPECT_TRUE(isNear(skew * w, v % w, 1e-15));
        EXPECT_EQ(skew.transpose(), skew * -1);
    }
}

TEST(Matrix3, LinearInterpolationIsLinear) {
    Random random(10);
    const Matrix3 a = random.matrix(), b = random.matrix();
    const Vector3 v = random.vector();
    EXPECT_EQ(Matrix3::linearInterpolate(a, b, 0), a);
    EXPECT_EQ(Matrix3::linearInterpolate(a, b, 1), b);
    for (real prop : {0.25, 0.5, 0.9, 1.5})
        EXPECT_TRUE(
            isNear(Matrix3::linearInterpolate(a, b, prop) * v, a * v + (b * v - a * v) * prop, 1e-15));
}

TEST(Matrix3, InertiaOfAPointCloudIsTwiceItsRotationEnergy) {
    Random random(11);
    real ix = 0, iy = 0, iz = 0, ixy = 0, ixz = 0, iyz = 0;
    Vector3 points[20];
    for (Vector3 &p : points) {
        p = random.vector();
        ix += p.y * p.y + p.z * p.z;
        iy += p.x * p.x + p.z * p.z;
        iz += p.x * p.x + p.y * p.y;
        ixy += p.x * p.y;
        ixz += p.x * p.z;
        iyz += p.y * p.z;
    }
    Matrix3 tensor;
    tensor.setInertiaTensorCoeffs(ix, iy, iz, ixy, ixz, iyz);
    for (int n = 0; n < 10; ++n) {
        const Vector3 rotation = random.vector();
        real energy = 0;
        for (const Vector3 &p : points) energy += (rotation % p).squareMagnitude();
        EXPECT_NEAR(rotation * (tensor * rotation), energy, 1e-13);
    }
    tensor.setInertiaTensorCoeffs(1, 2, 3);
    EXPECT_EQ(tensor, diagonal(1, 2, 3));
}

TEST(Matrix3, BlockInertiaIsThatOfEightSmallerBlocks) {
    const Vector3 half(0.5, 1.25, 2);
    const real mass = 7;
    Matrix3 whole, octant;
    whole.setBlockInertiaTensor(half, mass);
    octant.setBlockInertiaTensor(half * 0.5, mass / 8);
    // The parallel axis theorem; the octants' products of inertia cancel.
    const Vector3 d = half * 0.5;
    const Matrix3 shift =
        diagonal(d.y * d.y + d.z * d.z, d.x * d.x + d.z * d.z, d.x * d.x + d.y * d.y) * (mass / 8);
    EXPECT_TRUE(isNear(whole, (octant + shift) * 8, 1e-14));
    EXPECT_GT(whole.data[0], 0);
}

// ---- Matrix4

TEST(Matrix4, TransformAndItsInverseUndoEachOther) {
    Random random(12);
    EXPECT_EQ(Matrix4() * Vector3(1, 2, 3), Vector3(1, 2, 3));
    for (int n = 0; n < 300; ++n) {
        const Quaternion q = random.orientation();
        const Vector3 position = random.vector(10), v = random.vector();
        const Matrix4 m = rigidTransform(q, position);
        EXPECT_TRUE(isNear(m * v, q.rotate(v) + position, 1e-13));
        EXPECT_EQ(m.transform(v), m * v);
        EXPECT_TRUE(isNear(m.transformDirection(v), q.rotate(v), 4e-15));
        EXPECT_TRUE(isNear(m.transformInverse(m.transform(v)), v, 1e-13));
        EXPECT_TRUE(isNear(m.transformInverseDirection(m.transformDirection(v)), v, 4e-15));
        EXPECT_EQ(m.getRotationMatrix(), rotationMatrix(q));
        EXPECT_EQ(m.getAxisVector(3), position);
        EXPECT_EQ(m.getAxisVector(1), m.transformDirection(Vector3::Y));
        EXPECT_NEAR(m.getDeterminant(), 1, 1e-13);
        EXPECT_TRUE(isNear(m.inverse() * v, m.transformInverse(v), 1e-13));
    }
}

TEST(Matrix4, ProductsComposeAndInversesUndoAnyAffineMap) {
    Random random(13);
    for (int n = 0; n < 300; ++n) {
        Matrix4 a, b;
        for (real &entry : a.data) entry = random.between(-2, 2);
        for (real &entry : b.data) entry = random.between(-2, 2);
        const Vector3 v = random.vector();
        EXPECT_TRUE(isNear(a * b * v, a * (b * v), 1e-13));
        EXPECT_NEAR((a * b).getDeterminant(), a.getDeterminant() * b.getDeterminant(), 1e-11);
        Matrix4 m = a;
        m *= b;
        EXPECT_EQ(m, a * b);
        m = a;
        m *= m;
        EXPECT_EQ(m, a * a);

        if (real_abs(a.getDeterminant()) < 0.1) continue;
        Matrix4 target = b, itself = a, inverted = a;
        ASSERT_TRUE(target.setInverse(a));
        EXPECT_TRUE(isNear(target * a, Matrix4(), 1e-11));
        EXPECT_TRUE(isNear(a * target, Matrix4(), 1e-11));
        EXPECT_TRUE(itself.setInverse(itself));
        EXPECT_TRUE(inverted.invert());
        EXPECT_EQ(itself, target);
        EXPECT_EQ(inverted, target);
        EXPECT_EQ(a.inverse(), target);
    }
}

TEST(Matrix4, SingularMatricesHaveNoInverse) {
    const Matrix4 flat(1, 2, 3, 10, 2, 4, 6, 20, 0, 1, 5, 30);
    Matrix4 target = rigidTransform(Quaternion(), Vector3(1, 2, 3));
    const Matrix4 before = target;
    EXPECT_FALSE(target.setInverse(flat));
    EXPECT_EQ(target, before);
    Matrix4 itself = flat;
    EXPECT_FALSE(itself.invert());
    EXPECT_EQ(itself, flat);
    EXPECT_THROW(flat.inverse(), std::invalid_argument);
}

TEST(Matrix4, OpenGlTakesColumns) {
    const Matrix4 m(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12);
    const float wanted[16] = {1, 5, 9, 0, 2, 6, 10, 0, 3, 7, 11, 0, 4, 8, 12, 1};
    float single[16];
    real twice[16];
    m.fillGLArray(single);
    m.fillGLArray(twice);
    for (int n = 0; n < 16; ++n) {
        EXPECT_EQ(single[n], wanted[n]);
        EXPECT_EQ(twice[n], static_cast<real>(wanted[n]));
    }
    for (int n = 0; n < 12; ++n) {
        Matrix4 other = m;
        other.data[n] = 0;
        EXPECT_NE(m, other);
    }
}

}  // namespace

TEST(Matrix3, WhoseInverseOverflowsHasNone) {
    expectSingular(diagonal(1e-310, 1e-310, 1e-310));
    EXPECT_TRUE(isNear(diagonal(1e-307, 1e-307, 1e-307).inverse() * 1e-307, IDENTITY, 1e-15));
}
