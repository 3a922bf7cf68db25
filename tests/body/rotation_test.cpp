// Quaternions: the part of core.h that turns.
#include <cyclone/core.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

real norm(const Quaternion &q) { return real_sqrt(q.squareMagnitude()); }

/// The angle of the rotation that leads from a to b, 0 … π.
real angleBetween(const Quaternion &a, const Quaternion &b) {
    const Quaternion between = a.conjugate() * b;
    return 2 * real_atan2(Vector3(between.i, between.j, between.k).magnitude(), real_abs(between.r));
}

TEST(Quaternion, TurnsByTheRightHand) {
    const real quarter = REAL_PI / 2;
    EXPECT_TRUE(isNear(Quaternion::fromAxisAngle(Vector3::X, quarter).rotate(Vector3::Y), Vector3::Z, 1e-15));
    EXPECT_TRUE(isNear(Quaternion::fromAxisAngle(Vector3::Y, quarter).rotate(Vector3::Z), Vector3::X, 1e-15));
    EXPECT_TRUE(isNear(Quaternion::fromAxisAngle(Vector3::Z, quarter).rotate(Vector3::X), Vector3::Y, 1e-15));
    EXPECT_EQ(Quaternion().rotate(Vector3(1, 2, 3)), Vector3(1, 2, 3));
}

TEST(Quaternion, AxisMayHaveAnyLength) {
    const Quaternion wanted = Quaternion::fromAxisAngle(Vector3(0.6, 0, 0.8), 1.25);
    for (real size : {1e-300, 1e-3, 7.0, 1e300})
        EXPECT_TRUE(turnsLike(Quaternion::fromAxisAngle(Vector3(0.6, 0, 0.8) * size, 1.25), wanted, 1e-15));
    EXPECT_EQ(Quaternion::fromAxisAngle(Vector3(), 1.25), Quaternion());
    EXPECT_NEAR(norm(wanted), 1, 1e-15);
    EXPECT_NEAR(angleBetween(Quaternion(), wanted), 1.25, 1e-15);
}

TEST(Quaternion, ProductsComposeRotations) {
    Random random(20);
    for (int n = 0; n < 300; ++n) {
        const Quaternion a = random.orientation(), b = random.orientation();
        const Vector3 v = random.vector(), w = random.vector();
        EXPECT_TRUE(isNear((a * b).rotate(v), a.rotate(b.rotate(v)), 1e-14));
        EXPECT_TRUE(isNear(rotationMatrix(a * b), rotationMatrix(a) * rotationMatrix(b), 1e-14));
        EXPECT_TRUE(isNear(rotationMatrix(a) * v, a.rotate(v), 1e-14));
        EXPECT_TRUE(isNear(a.conjugate().rotate(a.rotate(v)), v, 1e-14));
        EXPECT_TRUE(isNear(rotationMatrix(a).transpose(), rotationMatrix(a.conjugate()), 1e-15));
        EXPECT_TRUE(turnsLike(a * a.conjugate(), Quaternion(), 1e-15));
        EXPECT_NEAR(rotationMatrix(a).getDeterminant(), 1, 1e-14);
        EXPECT_NEAR(a.rotate(v) * a.rotate(w), v * w, 1e-14);
        EXPECT_TRUE(isNear(a.rotate(v) % a.rotate(w), a.rotate(v % w), 1e-14));
        const Quaternion opposite(-a.r, -a.i, -a.j, -a.k);
        EXPECT_TRUE(isNear(opposite.rotate(v), a.rotate(v), 1e-15));
        Quaternion q = a;
        q *= b;
        EXPECT_EQ(q, a * b);
        q = a;
        q *= q;
        EXPECT_EQ(q, a * a);
    }
}

TEST(Quaternion, NormaliseKeepsDirectionAtEverySize) {
    for (real size : {5e-324, 1e-300, 1e-150, 1.0, 1e150, 1e300}) {
        Quaternion q(size, -size, size, -size);
        q.normalise();
        EXPECT_TRUE(turnsLike(q, Quaternion(0.5, -0.5, 0.5, -0.5), 1e-15)) << size;
    }
    Quaternion zero(0, 0, 0, 0);
    zero.normalise();
    EXPECT_EQ(zero, Quaternion());
}

TEST(Quaternion, EqualityAndFinitenessLookAtEveryComponent) {
    const Quaternion q(1, 2, 3, 4);
    EXPECT_NE(q, Quaternion(0, 2, 3, 4));
    EXPECT_NE(q, Quaternion(1, 0, 3, 4));
    EXPECT_NE(q, Quaternion(1, 2, 0, 4));
    EXPECT_NE(q, Quaternion(1, 2, 3, 0));
    EXPECT_TRUE(q.isFinite());
    EXPECT_FALSE(Quaternion(QUIET_NAN, 0, 0, 0).isFinite());
    EXPECT_FALSE(Quaternion(1, PLUS_INFINITY, 0, 0).isFinite());
    EXPECT_FALSE(Quaternion(1, 0, -PLUS_INFINITY, 0).isFinite());
    EXPECT_FALSE(Quaternion(1, 0, 0, QUIET_NAN).isFinite());
}

TEST(Quaternion, RotateByVectorIsATrueRotationInTheWorld) {
    Random random(21);
    for (int n = 0; n < 200; ++n) {
        const Quaternion start = random.orientation();
        const Vector3 turn = random.vector(3), v = random.vector();

        // The axis stays put; everything else turns by the vector's length, however it is cut up.
        Quaternion whole = start, parts = start;
        whole.rotateByVector(turn);
        for (int part = 0; part < 10; ++part) parts.rotateByVector(turn * 0.1);
        EXPECT_TRUE(turnsLike(whole, parts, 1e-14));
        EXPECT_NEAR(norm(whole), 1, 1e-14);
        EXPECT_NEAR(whole.rotate(v) * turn, start.rotate(v) * turn, 1e-14);

        whole.rotateByVector(-turn);
        EXPECT_TRUE(turnsLike(whole, start, 1e-14));
        whole.rotateByVector(Vector3());
        EXPECT_TRUE(turnsLike(whole, start, 1e-14));
    }
    Quaternion quarter;
    quarter.rotateByVector(Vector3(0, REAL_PI / 2, 0));
    EXPECT_TRUE(isNear(quarter.rotate(Vector3::Z), Vector3::X, 1e-15));
}

TEST(Quaternion, AddScaledVectorIsTheFirstOrderOfRotateByVector) {
    Random random(22);
    const Quaternion start = random.orientation();
    const Vector3 turn = random.vector();
    real lastError = 0;
    for (real scale : {0.02, 0.01}) {
        Quaternion exact = start, linear = start;
        exact.rotateByVector(turn * scale);
        linear.addScaledVector(turn, scale);
        const real error =
            norm(Quaternion(linear.r - exact.r, linear.i - exact.i, linear.j - exact.j, linear.k - exact.k));
        EXPECT_LT(error, scale * scale);
        if (lastError > 0) {
            EXPECT_NEAR(lastError / error, 4, 0.1);  // the error is of second order
        }
        lastError = error;
    }
}

TEST(Quaternion, InterpolationsGoFromTheOneToTheOther) {
    Random random(23);
    for (int n = 0; n < 300; ++n) {
        const Quaternion a = random.orientation(), b = random.orientation();
        const Quaternion opposite(-b.r, -b.i, -b.j, -b.k);
        const real whole = angleBetween(a, b);
        EXPECT_TRUE(turnsLike(Quaternion::linearInterpolate(a, b, 0), a, 1e-14));
        EXPECT_TRUE(turnsLike(Quaternion::linearInterpolate(a, b, 1), b, 1e-14));
        EXPECT_TRUE(turnsLike(Quaternion::sphericalInterpolate(a, b, 0), a, 1e-14));
        EXPECT_TRUE(turnsLike(Quaternion::sphericalInterpolate(a, b, 1), b, 1e-14));
        for (real prop : {0.1, 0.5, 0.8}) {
            const Quaternion s = Quaternion::sphericalInterpolate(a, b, prop);
            const Quaternion l = Quaternion::linearInterpolate(a, b, prop);
            EXPECT_NEAR(norm(s), 1, 1e-15);
            EXPECT_NEAR(norm(l), 1, 1e-15);
            // On the short way, at constant speed; along the chord on the same way.
            EXPECT_NEAR(angleBetween(a, s), prop * whole, 1e-13);
            EXPECT_NEAR(angleBetween(s, b), (1 - prop) * whole, 1e-13);
            EXPECT_NEAR(angleBetween(a, l) + angleBetween(l, b), whole, 1e-13);
            EXPECT_TRUE(turnsLike(Quaternion::sphericalInterpolate(a, opposite, prop), s, 1e-14));
            EXPECT_TRUE(turnsLike(Quaternion::linearInterpolate(a, opposite, prop), l, 1e-14));
        }
        EXPECT_TRUE(turnsLike(Quaternion::linearInterpolate(a, b, 0.5),
                              Quaternion::sphericalInterpolate(a, b, 0.5), 1e-13));
    }
}

TEST(Quaternion, InterpolationsAcrossHalfATurnTakeTheGivenWay) {
    const real half = std::sqrt(0.5);
    for (real way : {1, -1}) {
        const Quaternion s = Quaternion::sphericalInterpolate(Quaternion(), Quaternion(0, 0, way, 0), 0.5);
        EXPECT_NEAR(s.r, half, 1e-15);
        EXPECT_NEAR(s.j, way * half, 1e-15);
        const Quaternion l = Quaternion::linearInterpolate(Quaternion(), Quaternion(0, 0, way, 0), 0.5);
        EXPECT_NEAR(l.j, way * half, 1e-15);
    }
}

TEST(Quaternion, InterpolationsAcrossTinyAndGreatAngles) {
    for (real angle : {0.0, 1e-12, 1e-7, 2e-6, 3e-6, 1e-3, 3.14, REAL_PI}) {
        const Quaternion b = Quaternion::fromAxisAngle(Vector3(1, 2, 2), angle);
        const Quaternion quarter = Quaternion::sphericalInterpolate(Quaternion(), b, 0.25);
        EXPECT_TRUE(turnsLike(quarter, Quaternion::fromAxisAngle(Vector3(1, 2, 2), angle / 4), 1e-15));
        EXPECT_NEAR(norm(Quaternion::linearInterpolate(Quaternion(), b, 0.25)), 1, 1e-15);
    }
}

}  // namespace
