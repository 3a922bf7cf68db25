/// Wings in water, and wings whose resistance is too strong for the step.
#include <cyclone/wing.h>
#include <cyclone/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

constexpr real H = 1.0 / 60, SPAN = 4, CHORD = 1.5;

/// Flat, at height 2, and flowing.
class River : public Water {
public:
    real getHeight(const Vector3 &) const override { return 2; }
    Vector3 getVelocity(const Vector3 &) const override { return Vector3(-3, 0, 1); }
};

/// In any motion, with its flap at any angle.
Wing randomWing(Random &random) {
    Wing wing(SPAN, CHORD, random.vector(3), nullptr);
    WingSection section;
    section.zeroLiftAngle = random.between(-0.1, 0.1);
    wing.setSection(section);
    wing.setFlap(random.between(0, 1), 0.6);
    wing.setControl(random.between(-1, 1));
    wing.setOrientation(random.orientation());
    return wing;
}

RigidBody randomBody(Random &random) {
    RigidBody body;
    body.setOrientation(random.orientation());
    body.setVelocity(random.vector(20));
    body.setRotation(random.vector(2));
    return body;
}

// ---- Water

TEST(WingInWater, FeelsTheFlowPastTheWaterAsFarAsItIsIn) {
    const River river;
    Wing foil(2, 0.3, Vector3(0, -1, 0), nullptr), still(2, 0.3, Vector3(0, -1, 0), nullptr);
    foil.setWater(&river, 0.5);
    still.setDensity(1000);
    EXPECT_EQ(foil.getDensity(), 1000);
    RigidBody body, inStillWater;
    body.setVelocity(8, -0.5, 0);
    inStillWater.setVelocity(11, -0.5, -1);
    const Vector3 force = still.getForce(inStillWater), torque = still.getTorque(inStillWater);
    EXPECT_GT(force.y, 1000);
    // The foil is at height −1 below the body.
    const real heights[] = {-50, 2.5, 2.75, 2.9, 3, 50}, parts[] = {1, 1, 0.5, 0.2, 0, 0};
    for (int n = 0; n < 6; ++n) {
        body.setPosition(0, heights[n], 0);
        EXPECT_TRUE(isNear(foil.getForce(body), force * parts[n], 1e-9 * force.magnitude())) << heights[n];
        EXPECT_TRUE(isNear(foil.getTorque(body), torque * parts[n], 1e-9 * force.magnitude())) << heights[n];
        EXPECT_NEAR(foil.getAngleOfAttack(body), std::atan2(0.5, 11), 1e-14);
    }
}

TEST(WingInWater, ComesOutOfItAgain) {
    const River river;
    Wing foil(2, 0.3, Vector3(), nullptr), dry(2, 0.3, Vector3(), nullptr);
    foil.setWater(&river, 0.5, 1025);
    EXPECT_EQ(foil.getDensity(), 1025);
    foil.setWater(nullptr, 0.5, 1.225);
    RigidBody body;
    body.setVelocity(8, -0.5, 0);
    EXPECT_EQ(foil.getForce(body), dry.getForce(body));
    for (real bad : {0.0, -1.0, QUIET_NAN, PLUS_INFINITY}) {
        EXPECT_THROW(foil.setWater(&river, bad), std::invalid_argument);
        EXPECT_THROW(foil.setWater(&river, 1, bad), std::invalid_argument);
    }
    EXPECT_EQ(foil.getForce(body), dry.getForce(body));
}

TEST(WingInWater, HydrofoilFliesAtTheHeightWhereItCarriesTheBoat) {
    // At 10 m/s and 3° the foil can carry twice the weight; it rises until half of it is in the water.
    const real lift = 0.5 * 1000 * 100 * 2 * 0.3 * 2 * REAL_PI * (20.0 / 3) / (20.0 / 3 + 2) * 0.05236;
    const River river;
    Vector3 current(-3, 0, 1);  // along with the river
    World world;
    RigidBody *boat = world.createBody();
    boat->setMass(lift / 2 / 9.81);
    boat->setInverseInertiaTensor(Matrix3());
    boat->setAcceleration(Vector3::GRAVITY);
    Wing foil(2, 0.3, Vector3(), nullptr);
    foil.setWater(&river, 0.5);
    foil.setOrientation(Quaternion::fromAxisAngle(Vector3::Z, 0.05236));
    world.getForceRegistry().add(boat, &foil);
    boat->setPosition(0, 1.5, 0);
    for (int n = 0; n < 1200; ++n) {
        boat->setVelocity(10 + current.x, boat->getVelocity().y, current.z);  // a motor holds the speed
        world.startFrame();
        world.runPhysics(H);
    }
    EXPECT_NEAR(boat->getPosition().y, 2 - 0.25, 0.01);
    EXPECT_NEAR(boat->getVelocity().y, 0, 0.01);
}

// ---- Resistance

/// By central differences: how the force answers to that change of the velocity, per m/s.
Vector3 differentiate(const Wing &wing, const RigidBody &body, const Vector3 &direction) {
    constexpr real STEP = 1e-5;
    RigidBody faster = body, slower = body;
    faster.setVelocity(body.getVelocity() + direction * STEP);
    slower.setVelocity(body.getVelocity() - direction * STEP);
    return (wing.getForce(faster) - wing.getForce(slower)) * (0.5 / STEP);
}

TEST(WingResistance, IsNoLessThanWhatTheForceChangesBy) {
    Random random(70);
    for (int n = 0; n < 20000; ++n) {
        const Wing wing = randomWing(random);
        const RigidBody body = randomBody(random);
        Resistance sum;
        wing.addResistance(body, sum);
        // Along the flow across the span, across it, and along the span.
        const Vector3 arm = body.getDirectionInWorldSpace(wing.getPosition());
        const Vector3 span = body.getDirectionInWorldSpace(wing.getOrientation().rotate(Vector3::Z));
        const Vector3 flow = body.getVelocity() + body.getRotation() % arm;
        const Vector3 along = (flow - span * (flow * span)).unit();
        for (const Vector3 &direction : {along, span % along, span}) {
            const Vector3 told = sum.forceByVelocity * direction;
            EXPECT_GE(-(told * direction), differentiate(wing, body, direction).magnitude() * 0.9999 - 1e-6);
            EXPECT_TRUE(isNear(told, direction * (told * direction), 1e-9));
        }
        // The force's own part by its arm, and the couple's, about the span.
        Matrix3 cross;
        cross.setSkewSymmetric(arm);
        const Matrix3 couple =
            sum.torqueByRotation + cross * sum.forceByVelocity * cross;  // less −(cross·tensor·cross)
        EXPECT_LT(span * (couple * span), 0);
        EXPECT_TRUE(isNear(couple * along, Vector3(), 1e-9 * (couple * span).magnitude()));
    }
}

/// Where a strongly cambered one stalls, its lift falls off from higher than another's.
TEST(WingResistance, CountsTheStallOfACamberedWing) {
    WingSection section;
    section.zeroLiftAngle = -0.2;
    section.stallAngle = 0.25;
    Wing wing(6, 1, Vector3(), nullptr);
    wing.setSection(section);
    for (real angle = -0.6; angle < 0.6; angle += 0.001) {
        RigidBody body;
        body.setVelocity(Vector3(real_cos(angle), -real_sin(angle), 0) * 20);
        Resistance sum;
        wing.addResistance(body, sum);
        const Vector3 across(real_sin(angle), real_cos(angle), 0);
        EXPECT_GE(-(sum.forceByVelocity * across * across),
                  differentiate(wing, body, across).magnitude() * 0.9999)
            << angle;
    }
}

const real AREAS[] = {1e-3, 0.1, 1, 10, 100, 1e4, 1e6};

TEST(WingResistance, MotionNeverGrowsHoweverLargeTheWing) {
    Random random(71);
    for (const real area : AREAS)
        for (int n = 0; n < 50; ++n) {
            Wing wing(area, 1, Vector3(), nullptr);
            wing.setAspectRatio(6);
            wing.setOrientation(random.orientation());
            RigidBody body = randomBody(random);
            body.setRotation(0, 0, 0);
            body.setInverseInertiaTensor(Matrix3());
            ForceRegistry registry;
            registry.add(&body, &wing);
            real speed = body.getVelocity().magnitude();
            for (int frame = 0; frame < 120; ++frame) {
                registry.updateForces(H);
                ASSERT_TRUE(body.integrate(H));
                ASSERT_LE(body.getVelocity().magnitude(), speed * (1 + 1e-9)) << area << ' ' << frame;
                speed = body.getVelocity().magnitude();
            }
        }
}

TEST(WingResistance, FallsBroadsideAtTheTerminalVelocity) {
    for (const real area : AREAS) {
        Wing wing(area, 1, Vector3(), nullptr);
        wing.setAspectRatio(6);
        RigidBody body;
        body.setInverseInertiaTensor(Matrix3());
        body.setAcceleration(Vector3::GRAVITY);
        ForceRegistry registry;
        registry.add(&body, &wing);
        for (int frame = 0; frame < 6000; ++frame) {
            registry.updateForces(H);
            ASSERT_TRUE(body.integrate(H));
        }
        const real drag = 1.11 + 0.018 * 6 + 0.01, speed = std::sqrt(2 * 9.81 / (1.225 * area * drag));
        EXPECT_NEAR(body.getVelocity().y, -speed, 1e-3 * speed) << area;
    }
}

real kineticEnergy(const RigidBody &body) {
    return 0.5 * body.getMass() * body.getVelocity().squareMagnitude() +
           0.5 * body.getRotation() * body.getAngularMomentum();
}

TEST(WingResistance, StillAirGivesNoEnergyToATumblingWing) {
    // But for the error of the step, which is small where it resolves how the lift turns the motion. That of
    // 1 kg on 1 m² and more it does not; what it gains there in a second is bounded.
    Random random(72);
    for (const real area : AREAS)
        for (int n = 0; n < 50; ++n) {
            Wing wing(area, 1, random.vector(2), nullptr);
            wing.setAspectRatio(6);
            wing.setOrientation(random.orientation());
            RigidBody body = randomBody(random);
            ForceRegistry registry;
            registry.add(&body, &wing);
            const real start = kineticEnergy(body);
            for (int frame = 0; frame < (area < 1 ? 600 : 60); ++frame) {
                registry.updateForces(H);
                ASSERT_TRUE(body.integrate(H)) << area;
                ASSERT_LT(kineticEnergy(body), start * (area < 1 ? 1.02 : 1.5)) << area << ' ' << frame;
            }
            EXPECT_LT(kineticEnergy(body), start * (area < 1 ? 1 : 1.5));
        }
}

}  // namespace
