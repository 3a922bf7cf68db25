// The jet: what carries it, what turns it, and how fast its actuators are.
#include "vtol/jet.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vtol;

namespace {

constexpr real STEP = 1.0 / 60, DEGREE = cyclone::REAL_PI / 180;

struct StillAir : cyclone::WindField {
    cyclone::Vector3 getVelocity(const cyclone::Vector3 &) const override { return cyclone::Vector3(); }
};

struct Sky {
    cyclone::World world;
    StillAir air;
    Jet jet{world, &air};

    void fly(real seconds) {
        for (int n = 0; n < std::lround(seconds / STEP); ++n) {
            jet.advance(STEP);
            world.startFrame();
            world.runPhysics(STEP);
        }
    }
    /// In the air, nozzles and throttle as given.
    void hover(real throttle, real nozzles = cyclone::REAL_PI / 2) {
        JetControls controls;
        controls.throttle = throttle;
        controls.nozzles = nozzles;
        jet.launch(cyclone::Vector3(0, 500, 0), 0, controls);
    }
    void push(real pitch, real roll, real pedal) {
        JetControls controls = jet.getControls();
        controls.pitch = pitch;
        controls.roll = roll;
        controls.pedal = pedal;
        jet.setControls(controls);
    }
};

constexpr real HOVER_THROTTLE = Jet::WEIGHT / Jet::MAX_THRUST;

}  // namespace

TEST(DemoJet, HoversWhereThrustIsWeight) {
    Sky sky;
    sky.hover(HOVER_THROTTLE);
    sky.fly(5);
    EXPECT_NEAR(sky.jet.getBody().getVelocity().magnitude(), 0, 1e-6);
    EXPECT_NEAR(sky.jet.getBody().getPosition().y, 500, 1e-6);
    sky.hover(HOVER_THROTTLE * 1.1);
    sky.fly(0.5);  // slow: the air hardly resists yet
    EXPECT_NEAR(sky.jet.getBody().getVelocity().y, 0.1 * 9.81 * 0.5, 0.01);
}

TEST(DemoJet, ThePushTurnsWithTheNozzlesAndTurnsNothingElse) {
    for (const real angle : {0.0, 0.7, cyclone::REAL_PI / 2, Jet::MOST_NOZZLES}) {
        Sky sky;
        sky.hover(0.5, angle);
        cyclone::Vector3 push;
        cyclone::Vector3 torque;
        for (const cyclone::Thruster &nozzle : sky.jet.getNozzleJets()) {
            push += nozzle.getForce(sky.jet.getBody());
            torque += nozzle.getPosition() % nozzle.getForce(sky.jet.getBody());
        }
        const cyclone::Vector3 expected =
            cyclone::Vector3(std::cos(angle), std::sin(angle), 0) * (0.5 * Jet::MAX_THRUST);
        EXPECT_NEAR((push - expected).magnitude(), 0, 1e-9) << angle;
        EXPECT_NEAR(torque.magnitude(), 0, 1e-9) << angle;
    }
}

TEST(DemoJet, NozzlesAndEngineTakeTheirTime) {
    Sky sky;
    sky.hover(0);
    JetControls controls;
    controls.throttle = 1;
    controls.nozzles = 0;
    sky.jet.setControls(controls);
    sky.fly(1);
    EXPECT_NEAR(sky.jet.getNozzles(), cyclone::REAL_PI / 2 - Jet::NOZZLE_RATE, 1e-9);
    EXPECT_NEAR(sky.jet.getThrust() / Jet::MAX_THRUST, 1 - std::exp(-1 / Jet::ENGINE_LAG), 0.01);
    sky.fly(2);
    EXPECT_NEAR(sky.jet.getNozzles(), 0, 1e-12);
    controls.nozzles = 10;  // far too much
    sky.jet.setControls(controls);
    sky.fly(10);
    EXPECT_NEAR(sky.jet.getNozzles(), Jet::MOST_NOZZLES, 1e-12);
}

TEST(DemoJet, PuffersTurnItInTheHover) {
    const auto spin = [](real pitch, real roll, real pedal) {
        Sky sky;
        sky.hover(HOVER_THROTTLE);
        sky.push(pitch, roll, pedal);
        sky.fly(0.1);
        return sky.jet.getBody().getRotation() * 10;  // rad/s², the air's damping is small in so little time
    };
    const real puff = Jet::PUFF * HOVER_THROTTLE;
    const cyclone::Vector3 up = spin(1, 0, 0), down = spin(-1, 0, 0), starboard = spin(0, 1, 0),
                           round = spin(0, 0, 1);
    const cyclone::Vector3 moments = Jet::MOMENTS_OF_INERTIA;
    EXPECT_NEAR(up.z, puff * Jet::NOSE_ARM / moments.z, 0.02);
    EXPECT_NEAR(down.z, -puff * Jet::TAIL_ARM / moments.z, 0.02);
    EXPECT_NEAR(starboard.x, puff * Jet::TIP_ARM / moments.x, 0.05);
    EXPECT_NEAR(round.y, -puff * Jet::TAIL_ARM / moments.y, 0.02) << "the nose goes to starboard";
}

TEST(DemoJet, WithoutTheEngineThePuffersDoNothing) {
    Sky sky;
    sky.hover(0);
    sky.push(1, 1, 1);
    for (const cyclone::Thruster &puffer : sky.jet.getPuffers())
        EXPECT_EQ(puffer.getForce(sky.jet.getBody()), cyclone::Vector3());
}

TEST(DemoJet, TheWingCarriesItAtItsLevelSpeed) {
    Sky sky;
    JetControls controls;
    sky.jet.launch(cyclone::Vector3(0, 500, 0), Jet::LEVEL_SPEED, controls);
    // The section's lift is that of its angle's sine, so a little less than the line.
    EXPECT_NEAR(sky.jet.getAirForce().y / Jet::WEIGHT, 1, 0.02);
    EXPECT_FALSE(sky.jet.isStalled());
    sky.jet.launch(cyclone::Vector3(0, 500, 0), Jet::LEVEL_SPEED / 2, controls);
    EXPECT_NEAR(sky.jet.getAirForce().y / Jet::WEIGHT, 0.25, 0.005) << "lift goes with the square";
}

TEST(DemoJet, WheelsCarryItOnTheGround) {
    Sky sky;
    sky.jet.park(cyclone::Vector3(3, 0, 4));
    sky.fly(5);
    const RigidBody &body = sky.jet.getBody();
    EXPECT_TRUE(sky.jet.isOnGround());
    EXPECT_EQ(sky.jet.getBrokenPart(), "");
    EXPECT_NEAR(body.getVelocity().magnitude(), 0, 1e-3);
    EXPECT_NEAR(bankOf(body), 0, 1e-6);
    EXPECT_LT(std::fabs(pitchOf(body)), 4 * DEGREE);
    EXPECT_NEAR(body.getPosition().x, 3, 0.2);
    EXPECT_NEAR(body.getPosition().z, 4, 0.2);
}
