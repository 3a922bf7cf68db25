// Foreign types, axes and units. The frames are tested by what must not depend on them: turning, and
// crossing.
#include <cyclone/body.h>
#include <cyclone/convert.h>
#include <gtest/gtest.h>

#include <array>
#include <type_traits>

#include "random.h"

namespace {

using namespace cyclone;
using namespace cyclone_test;

// ---- Types such as hosts have

namespace foreign {

/// glm, Godot, raylib, DirectXMath …
struct Small {
    float x, y, z;
};
struct SmallQuaternion {
    float x, y, z, w;
};
/// The real part first, in memory and in the constructor.
struct RealFirst {
    double w = 1, x = 0, y = 0, z = 0;
    RealFirst() = default;
    RealFirst(double a, double b, double c, double d) : w(a), x(b), y(c), z(d) {}
};

/// Unreal: capitals, a constructor, and no default values.
struct Capital {
    double X, Y, Z;
    Capital() {}
    Capital(double a, double b, double c) : X(a), Y(b), Z(c) {}
};
struct CapitalQuaternion {
    double X, Y, Z, W;
};

/// Eigen, Bullet: functions for names, and an index.
class Indexed {
public:
    Indexed(float a, float b, float c) : data{a, b, c, 0} {}
    float x() const { return data[0]; }
    float operator[](int index) const { return data[index]; }
    float &operator[](int index) { return data[index]; }

private:
    float data[4];
};

}  // namespace foreign

TEST(Convert, VectorsOfEverySpelling) {
    const Vector3 v(1.5, -2.25, 1024);  // no rounding in floats
    const auto small = toHost<foreign::Small>(v);
    EXPECT_TRUE(small.x == 1.5f && small.y == -2.25f && small.z == 1024);
    EXPECT_EQ(vectorFrom(small), v);
    const auto capital = toHost<foreign::Capital>(v);
    EXPECT_TRUE(capital.X == 1.5 && capital.Y == -2.25 && capital.Z == 1024);
    EXPECT_EQ(vectorFrom(capital), v);
    const auto indexed = toHost<foreign::Indexed>(v);
    EXPECT_TRUE(indexed[0] == 1.5f && indexed[1] == -2.25f && indexed[2] == 1024);
    EXPECT_EQ(vectorFrom(indexed), v);
    const auto array = toHost<std::array<float, 3>>(v);
    EXPECT_EQ(vectorFrom(array), v);
    const float plain[3] = {1.5f, -2.25f, 1024};
    EXPECT_EQ(vectorFrom(plain), v);
    EXPECT_EQ(toHost<Vector3>(v), v);
    static_assert(std::is_same_v<cyclone::detail::HostNumber<foreign::Capital>, double>,
                  "doubles stay doubles");
    EXPECT_EQ(vectorFrom(toHost<foreign::Capital>(Vector3(0.1, 1e300, 1.0 / 3))),
              Vector3(0.1, 1e300, 1.0 / 3));
}

TEST(Convert, QuaternionsWhereverTheirRealPartIs) {
    const Quaternion q(0.5, -0.25, 0.125, 2);
    const auto small = toHost<foreign::SmallQuaternion>(q);
    EXPECT_TRUE(small.w == 0.5f && small.x == -0.25f && small.y == 0.125f && small.z == 2);
    EXPECT_EQ(quaternionFrom(small), q);
    const auto realFirst = toHost<foreign::RealFirst>(q);
    EXPECT_TRUE(realFirst.w == 0.5 && realFirst.x == -0.25 && realFirst.y == 0.125 && realFirst.z == 2);
    EXPECT_EQ(quaternionFrom(realFirst), q);
    const auto capital = toHost<foreign::CapitalQuaternion>(q);
    EXPECT_TRUE(capital.W == 0.5 && capital.X == -0.25 && capital.Y == 0.125 && capital.Z == 2);
    EXPECT_EQ(quaternionFrom(capital), q);
}

TEST(Convert, MatricesInAndOut) {
    Random random(3);
    const Matrix4 transform = rigidTransform(random.orientation(), random.vector(100));
    real precise[16];
    transform.fillGLArray(precise);
    EXPECT_EQ(matrixFromGLArray(precise), transform);
    float rough[16];
    transform.fillGLArray(rough);
    EXPECT_TRUE(isNear(matrixFromGLArray(rough), transform, 1e-5));
}

TEST(Convert, TheSameArrayServesRowsAndColumns) {
    Random random(4);
    const Matrix4 transform = rigidTransform(random.orientation(), random.vector(5));
    const Vector3 point = random.vector();
    real array[16];
    transform.fillGLArray(array);
    // As Direct3D does it: (x y z 1) times a matrix that is stored row by row.
    const real row[4] = {point.x, point.y, point.z, 1};
    real product[4] = {};
    for (int column = 0; column < 4; ++column)
        for (int n = 0; n < 4; ++n) product[column] += row[n] * array[4 * n + column];
    EXPECT_TRUE(isNear(Vector3(product[0], product[1], product[2]), transform * point, 1e-14));
    EXPECT_EQ(product[3], 1);
}

// ---- Frames

TEST(AxisConvention, AxesOfEngines) {
    const Vector3 forward(1, 0, 0), up(0, 1, 0), right(0, 0, 1);
    EXPECT_EQ(AxisConvention::unreal().getPointInHost(forward), Vector3(100, 0, 0));
    EXPECT_EQ(AxisConvention::unreal().getPointInHost(right), Vector3(0, 100, 0));
    EXPECT_EQ(AxisConvention::unreal().getPointInHost(up), Vector3(0, 0, 100));
    EXPECT_EQ(AxisConvention::unity().getPointInHost(right), Vector3(1, 0, 0));
    EXPECT_EQ(AxisConvention::unity().getPointInHost(up), Vector3(0, 1, 0));
    EXPECT_EQ(AxisConvention::unity().getPointInHost(forward), Vector3(0, 0, 1));
    EXPECT_EQ(AxisConvention::godot().getPointInHost(right), Vector3(1, 0, 0));
    EXPECT_EQ(AxisConvention::godot().getPointInHost(up), Vector3(0, 1, 0));
    EXPECT_EQ(AxisConvention::godot().getPointInHost(forward), Vector3(0, 0, -1));
    EXPECT_EQ(AxisConvention().getPointInHost(Vector3(1, 2, 3)), Vector3(1, 2, 3));
}

/// By half a right angle, the nose swings to starboard: what every engine calls yaw to the right.
TEST(AxisConvention, ANoseTurnedRightPointsRightInEveryHost) {
    const Quaternion yaw = Quaternion::fromAxisAngle(Vector3::Y, -REAL_PI / 4);
    const real half = real_sqrt(0.5);
    const Quaternion unreal = AxisConvention::unreal().getOrientationInHost(yaw);
    EXPECT_TRUE(isNear(unreal.rotate(Vector3(1, 0, 0)), Vector3(half, half, 0), 1e-15));
    EXPECT_GT(unreal.k, 0);  // FRotator: yaw is positive to the right, about +Z
    const Quaternion unity = AxisConvention::unity().getOrientationInHost(yaw);
    EXPECT_TRUE(isNear(unity.rotate(Vector3(0, 0, 1)), Vector3(half, 0, half), 1e-15));
    EXPECT_GT(unity.j, 0);  // Euler angles: clockwise from above about +Y
    const Quaternion godot = AxisConvention::godot().getOrientationInHost(yaw);
    EXPECT_TRUE(isNear(godot.rotate(Vector3(0, 0, -1)), Vector3(half, 0, -half), 1e-15));
    EXPECT_LT(godot.j, 0);  // right-handed about +Y
}

class AnyFrame : public testing::TestWithParam<int> {
protected:
    static AxisConvention frame() {
        AxisConvention result;
        if (GetParam() == 1) result = AxisConvention::unreal();
        if (GetParam() == 2) result = AxisConvention::unity();
        if (GetParam() == 3) result = AxisConvention::godot();
        if (GetParam() == 4) {  // oblique and mirrored
            const Quaternion q = Quaternion::fromAxisAngle(Vector3(1, -2, 0.5), 0.8);
            result = AxisConvention(q.rotate(Vector3::X), q.rotate(-Vector3::Y), q.rotate(Vector3::Z), 39.37);
        }
        result.setOrigin(Vector3(300, -20, 7));
        return result;
    }
    Random random{11};
};

TEST_P(AnyFrame, ThereAndBack) {
    const AxisConvention host = frame();
    const Vector3 v = random.vector(10);
    const Quaternion q = random.orientation();
    EXPECT_TRUE(isNear(host.getPointInCyclone(host.getPointInHost(v)), v, 1e-12));
    EXPECT_TRUE(isNear(host.getVectorInCyclone(host.getVectorInHost(v)), v, 1e-13));
    EXPECT_TRUE(isNear(host.getDirectionInCyclone(host.getDirectionInHost(v)), v, 1e-14));
    EXPECT_TRUE(isNear(host.getRotationInCyclone(host.getRotationInHost(v)), v, 1e-14));
    EXPECT_TRUE(turnsLike(host.getOrientationInCyclone(host.getOrientationInHost(q)), q, 1e-15));
    EXPECT_TRUE(isNear(host.getPointInHost(host.getOrigin()), Vector3(), 0));
}

TEST_P(AnyFrame, TurnThenConvertIsConvertThenTurn) {
    const AxisConvention host = frame();
    for (int n = 0; n < 20; ++n) {
        const Vector3 v = random.vector(10);
        const Quaternion q = random.orientation(), p = random.orientation();
        EXPECT_TRUE(isNear(host.getVectorInHost(q.rotate(v)),
                           host.getOrientationInHost(q).rotate(host.getVectorInHost(v)), 1e-11));
        EXPECT_TRUE(turnsLike(host.getOrientationInHost(q * p),
                              host.getOrientationInHost(q) * host.getOrientationInHost(p), 1e-14));
    }
}

TEST_P(AnyFrame, TurningVelocityIsTheSameCrossProduct) {
    const AxisConvention host = frame();
    const Vector3 rotation = random.vector(3), arm = random.vector(10);
    EXPECT_TRUE(isNear(host.getVectorInHost(rotation % arm),
                       host.getRotationInHost(rotation) % host.getVectorInHost(arm), 1e-11));
}

TEST_P(AnyFrame, TransformIsOrientationAndPoint) {
    const AxisConvention host = frame();
    const Quaternion q = random.orientation();
    const Vector3 at = random.vector(50), inBody = random.vector(2);
    const Matrix4 transform = rigidTransform(q, at);
    EXPECT_TRUE(isNear(host.getTransformInHost(transform),
                       rigidTransform(host.getOrientationInHost(q), host.getPointInHost(at)), 1e-11));
    EXPECT_TRUE(isNear(host.getTransformInHost(transform) * host.getVectorInHost(inBody),
                       host.getPointInHost(transform * inBody), 1e-10));
}

/// A body thrown in Cyclone, seen in the host, moves as by the host's own numbers.
TEST_P(AnyFrame, ABodySeenInTheHost) {
    const AxisConvention host = frame();
    RigidBody body;
    body.setPosition(1, 2, 3);
    body.setVelocity(4, -5, 6);
    body.setRotation(0, 0, 2);
    const Vector3 before = host.getPointInHost(body.getPosition());
    const Vector3 nose =
        host.getTransformInHost(body.getTransform()).transformDirection(host.getDirectionInHost(Vector3::X));
    body.integrate(0.25);
    EXPECT_TRUE(isNear(host.getPointInHost(body.getPosition()),
                       before + host.getVectorInHost(Vector3(4, -5, 6)) * 0.25, 1e-10));
    Quaternion turn;
    turn.rotateByVector(host.getRotationInHost(Vector3(0, 0, 2)) * 0.25);
    EXPECT_TRUE(isNear(
        host.getTransformInHost(body.getTransform()).transformDirection(host.getDirectionInHost(Vector3::X)),
        turn.rotate(nose), 1e-9));
}

INSTANTIATE_TEST_SUITE_P(Frames, AnyFrame, testing::Range(0, 5));

TEST(AxisConvention, AnOriginKeepsFloatsPrecise) {
    AxisConvention frame = AxisConvention::unreal();
    frame.setOrigin(Vector3(1e6, 0, -2e6));
    const auto near = toHost<foreign::Small>(frame.getPointInHost(Vector3(1e6 + 0.125, 3, -2e6)));
    EXPECT_TRUE(near.x == 12.5f && near.y == 0 && near.z == 300);
}

TEST(AxisConvention, WhatIsRefused) {
    const Vector3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    EXPECT_THROW(AxisConvention(x, y, y), std::invalid_argument);
    EXPECT_THROW(AxisConvention(x, y, z * 2), std::invalid_argument);
    EXPECT_THROW(AxisConvention(x, y, Vector3(0, 1e-3, 1)), std::invalid_argument);
    EXPECT_THROW(AxisConvention(x, y, Vector3(0, 1.1e-6, 1)), std::invalid_argument);
    EXPECT_NO_THROW(AxisConvention(x, y, Vector3(0, 1e-6, 1)));
    EXPECT_THROW(AxisConvention(x, y, Vector3(QUIET_NAN, 0, 1)), std::invalid_argument);
    EXPECT_THROW(AxisConvention(x, y, z, 0), std::invalid_argument);
    EXPECT_THROW(AxisConvention(x, y, z, -1), std::invalid_argument);
    EXPECT_THROW(AxisConvention(x, y, z, QUIET_NAN), std::invalid_argument);
    EXPECT_THROW(AxisConvention(x, y, z, PLUS_INFINITY), std::invalid_argument);
    EXPECT_THROW(AxisConvention(x, y, z, 1e-310), std::invalid_argument) << "a metre in a unit is none";
    EXPECT_NO_THROW(AxisConvention(x, y, z, REAL_MAX));
    EXPECT_NO_THROW(AxisConvention(x, y, -z, 100));
    AxisConvention frame;
    EXPECT_THROW(frame.setOrigin(Vector3(0, PLUS_INFINITY, 0)), std::invalid_argument);
    EXPECT_EQ(frame.getOrigin(), Vector3());
}

}  // namespace
