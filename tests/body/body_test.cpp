#include <cyclone/body.h>

#include "reference.h"

using namespace cyclone;
using cyclone_test::diagonal;
using cyclone_test::isNear;
using cyclone_test::rotationMatrix;
using cyclone_test::turnsLike;
using reference::difference;
using reference::turnAbout;

namespace {

const Matrix3 OBLIQUE(0.9, 0.2, -0.1, 0.2, 0.6, 0.15, -0.1, 0.15, 1.1);
const Matrix3 UNIT(1, 0, 0, 0, 1, 0, 0, 0, 1);

RigidBody movingBody() {
    RigidBody body;
    body.setMass(3);
    body.setInertiaTensor(OBLIQUE);
    body.setPosition(1, -2, 3);
    body.setOrientation(0.5, -0.1, 0.7, 0.5);
    body.setVelocity(-1, 0.5, 2);
    body.setRotation(0.3, -0.8, 0.4);
    return body;
}

/// What follows from the state by definition: transform, tensors in world axes, angular momentum.
void expectCurrent(const RigidBody &body) {
    const Quaternion q = body.getOrientation();
    EXPECT_NEAR(q.squareMagnitude(), 1, 1e-15);
    for (unsigned n = 0; n < 3; ++n) {
        Vector3 axis;
        axis[n] = 1;
        const Quaternion turned = q * Quaternion(0, axis.x, axis.y, axis.z) * q.conjugate();
        EXPECT_TRUE(
            isNear(body.getTransform().getAxisVector(n), Vector3(turned.i, turned.j, turned.k), 1e-15));
    }
    EXPECT_EQ(body.getTransform().getAxisVector(3), body.getPosition());
    const Matrix3 r = body.getTransform().getRotationMatrix();
    const Matrix3 inverse = body.getInverseInertiaTensorWorld(), tensor = body.getInertiaTensorWorld();
    EXPECT_TRUE(isNear(inverse, r * body.getInverseInertiaTensor() * r.transpose(), 1e-13));
    EXPECT_TRUE(isNear(tensor, r * body.getInertiaTensor() * r.transpose(), 1e-13));
    EXPECT_TRUE(isNear(tensor * inverse, UNIT, 1e-13));
    EXPECT_TRUE(isNear(body.getAngularMomentum(), tensor * body.getRotation(), 1e-13));
}

}  // namespace

// ---- State

TEST(RigidBody, IsValidByDefault) {
    RigidBody body;
    EXPECT_EQ(body.getMass(), 1);
    EXPECT_EQ(body.getInverseMass(), 1);
    EXPECT_TRUE(body.hasFiniteMass());
    EXPECT_EQ(body.getInertiaTensor(), UNIT);
    EXPECT_EQ(body.getInverseInertiaTensor(), UNIT);
    EXPECT_EQ(body.getPosition(), Vector3());
    EXPECT_EQ(body.getOrientation(), Quaternion());
    EXPECT_EQ(body.getVelocity(), Vector3());
    EXPECT_EQ(body.getRotation(), Vector3());
    EXPECT_EQ(body.getAngularMomentum(), Vector3());
    EXPECT_EQ(body.getAcceleration(), Vector3());
    EXPECT_EQ(body.getLastFrameAcceleration(), Vector3());
    EXPECT_EQ(body.getLinearDamping(), 1);
    EXPECT_EQ(body.getAngularDamping(), 1);
    EXPECT_TRUE(body.getAwake());
    EXPECT_FALSE(body.getCanSleep());
    EXPECT_FALSE(body.hasFaulted());
    EXPECT_EQ(body.getTransform(), Matrix4());
    expectCurrent(body);
    EXPECT_TRUE(body.integrate(1.0 / 60));
    EXPECT_EQ(body.getPosition(), Vector3());
}

TEST(RigidBody, GivesBackWhatIsSet) {
    RigidBody body;
    body.setMass(0.3);
    EXPECT_EQ(body.getMass(), 0.3);
    body.setInverseMass(0.125);
    EXPECT_EQ(body.getInverseMass(), 0.125);
    EXPECT_EQ(body.getMass(), 8);
    body.setDamping(0.5, 0.25);
    EXPECT_EQ(body.getLinearDamping(), 0.5);
    EXPECT_EQ(body.getAngularDamping(), 0.25);
    body.setLinearDamping(0.75);
    body.setAngularDamping(0);
    EXPECT_EQ(body.getLinearDamping(), 0.75);
    EXPECT_EQ(body.getAngularDamping(), 0);
    body.setPosition(1, 2, 3);
    EXPECT_EQ(body.getPosition(), Vector3(1, 2, 3));
    body.setVelocity(4, 5, 6);
    EXPECT_EQ(body.getVelocity(), Vector3(4, 5, 6));
    body.setRotation(7, 8, 9);
    EXPECT_EQ(body.getRotation(), Vector3(7, 8, 9));
    body.setAcceleration(10, 11, 12);
    EXPECT_EQ(body.getAcceleration(), Vector3(10, 11, 12));
    body.setOrientation(0.5, -0.5, 0.5, 0.5);
    EXPECT_EQ(body.getOrientation(), Quaternion(0.5, -0.5, 0.5, 0.5));
    body.setSleepEpsilon(0.3);
    EXPECT_EQ(body.getSleepEpsilon(), 0.3);
    body.setCanSleep();
    EXPECT_TRUE(body.getCanSleep());
    body.setInertiaTensor(diagonal(2, 0.3, 1.7));
    EXPECT_EQ(body.getInertiaTensor(), diagonal(2, 0.3, 1.7));
    EXPECT_EQ(body.getInverseInertiaTensor(), diagonal(1.0 / 2, 1 / 0.3, 1 / 1.7));
    body.setInverseInertiaTensor(diagonal(2, 0.3, 1.7));
    EXPECT_EQ(body.getInverseInertiaTensor(), diagonal(2, 0.3, 1.7));
    EXPECT_EQ(body.getInertiaTensor(), diagonal(1.0 / 2, 1 / 0.3, 1 / 1.7));
    body.setInertiaTensor(OBLIQUE);
    EXPECT_TRUE(isNear(body.getInertiaTensor(), OBLIQUE, 1e-15));
    EXPECT_TRUE(isNear(body.getInverseInertiaTensor(), OBLIQUE.inverse(), 1e-14));
    body.setInverseInertiaTensor(OBLIQUE);
    EXPECT_TRUE(isNear(body.getInverseInertiaTensor(), OBLIQUE, 1e-15));
}

TEST(RigidBody, MassIsGivenBackExactly) {
    reference::Random random;
    RigidBody body;
    for (int n = 0; n < 1000; ++n) {
        const real mass = random.logBetween(1e-300, 1e300);
        body.setMass(mass);
        ASSERT_EQ(body.getMass(), mass);
        ASSERT_EQ(body.getInverseMass(), 1 / mass);
        body.setInverseMass(mass);
        ASSERT_EQ(body.getInverseMass(), mass);
    }
    body.setInverseMass(0);
    EXPECT_FALSE(body.hasFiniteMass());
    EXPECT_EQ(body.getMass(), REAL_MAX);
    body.setMass(2);
    EXPECT_TRUE(body.hasFiniteMass());
}

TEST(RigidBody, DerivedDataIsCurrentAfterEverySetterAndStep) {
    RigidBody body = movingBody();
    expectCurrent(body);
    body.setPosition(7, 8, 9);
    expectCurrent(body);
    body.setOrientation(-0.2, 0.9, 0.1, -0.4);
    expectCurrent(body);
    body.setRotation(5, -4, 3);
    expectCurrent(body);
    body.addRotation(Vector3(1, 1, 1));
    expectCurrent(body);
    body.setMass(11);
    expectCurrent(body);
    body.setInverseMass(0.2);
    expectCurrent(body);
    body.setInertiaTensor(diagonal(1, 2, 3));
    expectCurrent(body);
    body.setInverseInertiaTensor(OBLIQUE);
    expectCurrent(body);
    for (const Matrix3 &tensor : {OBLIQUE, diagonal(1, 2, 3), diagonal(3, 1, 2), diagonal(2, 3, 1), UNIT})
        for (const real h : {0.01, 2.0}) {
            body.setInertiaTensor(tensor);
            body.setRotation(5, -4, 3);
            body.addTorque(Vector3(3, 1, 2));
            EXPECT_TRUE(body.integrate(h));
            expectCurrent(body);
        }
    body.setAwake(false);
    expectCurrent(body);
    body.calculateDerivedData();
    expectCurrent(body);
}

TEST(RigidBody, OrientationIsMadeAUnitQuaternion) {
    const Quaternion unit(0.5, -0.5, 0.5, 0.5);
    for (const real length : {1e-300, 1e-160, 1e-8, 1 + 1e-9, 3.0, 1e160, 1e300}) {
        RigidBody body;
        body.setOrientation(unit.r * length, unit.i * length, unit.j * length, unit.k * length);
        EXPECT_TRUE(turnsLike(body.getOrientation(), unit, 1e-15)) << length;
        expectCurrent(body);
    }
}

TEST(RigidBody, SettersLeaveTheOtherMotionAlone) {
    RigidBody body = movingBody();
    const Vector3 velocity = body.getVelocity(), rotation = body.getRotation();
    body.setMass(20);
    body.setInertiaTensor(diagonal(1, 5, 2));
    body.setOrientation(0.1, 0.2, 0.3, 0.4);
    body.setPosition(0, 0, 0);
    EXPECT_EQ(body.getVelocity(), velocity);
    EXPECT_EQ(body.getRotation(), rotation);
}

TEST(RigidBody, TinyInverseInertiaIsValid) {
    RigidBody body;
    body.setInverseInertiaTensor(diagonal(1e-310, 1, 1));  // its reciprocal is beyond the numbers
    body.setRotation(0, 1, 0);
    EXPECT_TRUE(body.getAngularMomentum().isFinite());
    EXPECT_TRUE(body.integrate(0.1));
    EXPECT_TRUE(turnsLike(body.getOrientation(), turnAbout(Vector3::Y, 0.1), 1e-12));
}

// ---- Body and world

TEST(RigidBody, ConvertsPointsAndDirections) {
    RigidBody body;
    body.setPosition(10, 20, 30);
    body.setOrientation(turnAbout(Vector3::Y, REAL_PI / 2));  // forward, +X, now points to −Z
    EXPECT_TRUE(isNear(body.getDirectionInWorldSpace(Vector3::X), Vector3(0, 0, -1), 1e-15));
    EXPECT_TRUE(isNear(body.getPointInWorldSpace(Vector3(1, 2, 0)), Vector3(10, 22, 29), 1e-14));
    EXPECT_TRUE(isNear(body.getDirectionInLocalSpace(Vector3(0, 0, -1)), Vector3::X, 1e-15));
    EXPECT_TRUE(isNear(body.getPointInLocalSpace(Vector3(10, 22, 29)), Vector3(1, 2, 0), 1e-14));
    body = movingBody();
    const Vector3 v(0.3, -4, 5);
    EXPECT_TRUE(isNear(body.getPointInLocalSpace(body.getPointInWorldSpace(v)), v, 1e-14));
    EXPECT_TRUE(isNear(body.getDirectionInWorldSpace(body.getDirectionInLocalSpace(v)), v, 1e-14));
}

TEST(RigidBody, GivesItsTransformForDrawing) {
    RigidBody body;
    body.setPosition(10, 20, 30);
    body.setOrientation(turnAbout(Vector3::Y, REAL_PI / 2));
    const float expected[16] = {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 10, 20, 30, 1};
    float matrix[16];
    body.getGLTransform(matrix);
    for (int n = 0; n < 16; ++n) EXPECT_NEAR(matrix[n], expected[n], 1e-7) << n;
}

TEST(RigidBody, ForcesAtPointsTurnIt) {
    const Vector3 force(3, -1, 2), arm(0.2, 0.7, -0.4);
    const real h = 0.25;
    RigidBody central = movingBody(), atPoint = central, atBodyPoint = central, asTorque = central;
    central.addForce(force);
    atPoint.addForceAtPoint(force, atPoint.getPointInWorldSpace(arm));
    atBodyPoint.addForceAtBodyPoint(force, arm);
    asTorque.addForce(force);
    asTorque.addTorque(asTorque.getDirectionInWorldSpace(arm) % force);
    const Vector3 twist = (central.getDirectionInWorldSpace(arm) % force) * h;
    for (RigidBody *body : {&central, &atPoint, &atBodyPoint, &asTorque}) {
        const Vector3 momentum = body->getAngularMomentum();
        EXPECT_TRUE(body->integrate(h));
        EXPECT_TRUE(isNear(body->getVelocity(), Vector3(-1, 0.5, 2) + force * (h / 3), 1e-15));
        const Vector3 gain = body == &central ? Vector3() : twist;
        EXPECT_TRUE(isNear(body->getAngularMomentum() - momentum, gain, 1e-14));
    }
}

TEST(RigidBody, ClearAccumulatorsTakesForcesBack) {
    RigidBody body = movingBody(), untouched = body;
    body.addForceAtBodyPoint(Vector3(3, 4, 5), Vector3(1, 0, 0));
    body.clearAccumulators();
    body.integrate(0.1);
    untouched.integrate(0.1);
    EXPECT_EQ(body.getVelocity(), untouched.getVelocity());
    EXPECT_EQ(body.getAngularMomentum(), untouched.getAngularMomentum());
}

TEST(RigidBody, TellsWhatAcceleratedItLast) {
    RigidBody body = movingBody();
    body.setAcceleration(Vector3::GRAVITY);
    body.addForce(Vector3(6, 0, 3));
    body.integrate(0.1);
    EXPECT_TRUE(isNear(body.getLastFrameAcceleration(), Vector3(2, -9.81, 1), 1e-14));
    body.integrate(0.1);
    EXPECT_EQ(body.getLastFrameAcceleration(), Vector3::GRAVITY);
}

TEST(RigidBody, CopiesGoTheirOwnWay) {
    RigidBody body = movingBody();
    body.addForce(Vector3(1, 2, 3));
    RigidBody copy = body;
    for (RigidBody *each : {&body, &copy})
        for (int n = 0; n < 10; ++n) each->integrate(0.1);
    EXPECT_EQ(copy.getTransform(), body.getTransform());
    EXPECT_EQ(copy.getVelocity(), body.getVelocity());
    EXPECT_EQ(copy.getRotation(), body.getRotation());
    const Vector3 position = body.getPosition();
    copy.setPosition(0, 0, 0);
    copy.integrate(1);
    EXPECT_EQ(body.getPosition(), position);
}

// ---- Bodies that do not move freely

TEST(ImmovableBody, StaysPut) {
    RigidBody body = movingBody();
    body.setInverseMass(0);
    body.setVelocity(0, 0, 0);
    body.setRotation(0, 0, 0);
    body.setAcceleration(Vector3::GRAVITY);
    const Matrix4 transform = body.getTransform();
    for (int n = 0; n < 100; ++n) {
        body.addForceAtBodyPoint(Vector3(1e6, 2e6, 3e6), Vector3(1, 2, 3));
        body.addTorque(Vector3(1e6, 0, 0));
        EXPECT_TRUE(body.integrate(0.1));
    }
    EXPECT_EQ(body.getTransform(), transform);
    EXPECT_EQ(body.getVelocity(), Vector3());
    EXPECT_EQ(body.getRotation(), Vector3());
    EXPECT_EQ(body.getAngularMomentum(), Vector3());
}

TEST(ImmovableBody, KeepsTheMotionThatIsSet) {
    RigidBody platform;
    platform.setInverseMass(0);
    platform.setDamping(0.1, 0.1);
    platform.setAcceleration(Vector3::GRAVITY);
    platform.setVelocity(1, 0, -2);
    platform.setRotation(0, 0.5, 0);
    for (int n = 0; n < 100; ++n) {
        platform.addForce(Vector3(5, 5, 5));
        platform.addTorque(Vector3(5, 5, 5));
        platform.integrate(0.1);
    }
    EXPECT_EQ(platform.getVelocity(), Vector3(1, 0, -2));
    EXPECT_TRUE(isNear(platform.getRotation(), Vector3(0, 0.5, 0), 1e-14));
    EXPECT_TRUE(isNear(platform.getPosition(), Vector3(10, 0, -20), 1e-12));
    EXPECT_TRUE(turnsLike(platform.getOrientation(), turnAbout(Vector3::Y, 5), 1e-12));
}

TEST(LockedAxis, NothingTurnsAboutIt) {
    // A wheel upright: only free about z in its own axes, which are turned about z by 1 rad.
    RigidBody body;
    body.setInverseInertiaTensor(diagonal(0, 0, 0.5));
    body.setOrientation(turnAbout(Vector3::Z, 1));
    const real h = 0.01;
    for (int n = 1; n <= 300; ++n) {
        body.addTorque(Vector3(7, -5, 3));
        ASSERT_TRUE(body.integrate(h));
        const real t = n * h;
        ASSERT_TRUE(isNear(body.getRotation(), Vector3(0, 0, 1.5 * t), 1e-12));
        ASSERT_TRUE(turnsLike(body.getOrientation(), turnAbout(Vector3::Z, 1 + 0.75 * t * (t + h)), 1e-12));
        ASSERT_TRUE(isNear(body.getAngularMomentum(), Vector3(0, 0, 3 * t), 1e-12));
    }
}

TEST(LockedAxis, AllLockedNeverTurns) {
    RigidBody body;
    body.setInverseInertiaTensor(Matrix3());
    body.setOrientation(0.5, 0.5, 0.5, 0.5);
    body.addForceAtBodyPoint(Vector3(1, 2, 3), Vector3(3, 2, 1));
    EXPECT_TRUE(body.integrate(1));
    EXPECT_EQ(body.getOrientation(), Quaternion(0.5, 0.5, 0.5, 0.5));
    EXPECT_EQ(body.getRotation(), Vector3());
    EXPECT_TRUE(isNear(body.getVelocity(), Vector3(1, 2, 3), 1e-15));
}

TEST(LockedAxis, PlanarMotionIsThatOfAFreeBody) {
    // Forces in the plane turn a free body about z alone, as they do one whose other axes are locked; the
    // locked axes may be oblique in body axes.
    const Quaternion tilt = turnAbout(Vector3(1, 2, 3).unit(), 0.8);
    const Matrix3 r = rotationMatrix(tilt);
    RigidBody free, locked;
    free.setInertiaTensor(diagonal(1, 1.5, 2));
    locked.setInverseInertiaTensor(r * diagonal(0, 0, 0.5) * r.transpose());
    locked.setOrientation(tilt.conjugate());
    for (RigidBody *body : {&free, &locked}) {
        body->setAngularDamping(0.6);
        body->setRotation(0, 0, 0.4);
        for (int n = 0; n < 200; ++n) {
            body->addForceAtPoint(Vector3(1, 2, 0), body->getPosition() + Vector3(0.5, 0.1 * n, 0));
            ASSERT_TRUE(body->integrate(0.01));
        }
    }
    EXPECT_TRUE(isNear(locked.getRotation(), free.getRotation(), 1e-12));
    EXPECT_TRUE(turnsLike(locked.getOrientation() * tilt, free.getOrientation(), 1e-12));
    EXPECT_TRUE(isNear(locked.getAngularMomentum(), free.getAngularMomentum(), 1e-12));
}

TEST(ObliqueTensor, IsTheSameBodyInTurnedAxes) {
    const Quaternion tilt = turnAbout(Vector3(3, -1, 2).unit(), 1.1);
    const Matrix3 r = rotationMatrix(tilt);
    const Matrix3 moments = diagonal(0.5, 1.4, 0.9);
    const Vector3 corner(0.3, 0.1, -0.2);
    RigidBody principal = movingBody(), oblique = principal;
    principal.setInertiaTensor(moments);
    oblique.setInertiaTensor(r * moments * r.transpose());
    oblique.setOrientation(principal.getOrientation() * tilt.conjugate());
    // Short steps: the order of the principal axes is free, and changes the result by the method's own error.
    const real h = 1.0 / 480;
    for (int n = 0; n < 2000; ++n) {
        const Vector3 force(std::sin(0.02 * n), 0.3, -std::cos(0.03 * n));
        principal.addForceAtBodyPoint(force, corner);
        oblique.addForceAtBodyPoint(force, tilt.rotate(corner));
        ASSERT_TRUE(principal.integrate(h));
        ASSERT_TRUE(oblique.integrate(h));
    }
    EXPECT_LT(difference(oblique.getPosition(), principal.getPosition()), 1e-10);
    EXPECT_LT(difference(oblique.getRotation(), principal.getRotation()), 1e-10);
    EXPECT_LT(difference(oblique.getAngularMomentum(), principal.getAngularMomentum()), 1e-10);
    EXPECT_LT(difference(oblique.getOrientation() * tilt, principal.getOrientation()), 1e-10);
}
