// Wings in flight: a glider flies its polar, stalls, spins and recovers, and obeys its controls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "glider.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

constexpr real WEIGHT = Glider::MASS * 9.81, AREA = Glider::SPAN * Glider::CHORD,
               ASPECT_RATIO = Glider::SPAN / Glider::CHORD;

/// With the wings held level.
struct Glide {
    real ratio, sink;
};

Glide glideWith(real pull) {
    Glider glider;
    glider.body->setInverseInertiaTensor(diagonal(0, 0, 1.0 / 550));
    glider.steer(pull, 0, 0);
    glider.fly(400);  // until the slow swings of speed and height are over
    const Vector3 start = glider.body->getPosition();
    glider.fly(60);
    const Vector3 way = glider.body->getPosition() - start;
    return {-way.x / way.y, -way.y / 60};
}

TEST(WingFlight, GlidesAsItsPolarSays) {
    // CD = CD0 + CL²/(π·AR): the best ratio is where both parts are equal, the least sink where the second is
    // three times the first. The tailplane carries next to nothing.
    const real tailArea = Glider::TAIL_SPAN * Glider::TAIL_CHORD + Glider::FIN_SPAN * Glider::FIN_CHORD;
    const real cd0 = (Glider::LEAST_DRAG * (AREA + tailArea) + Glider::FUSELAGE_DRAG_AREA) / AREA;
    const real bestRatio = 0.5 * std::sqrt(REAL_PI * ASPECT_RATIO / cd0);
    const real slowLift = std::sqrt(3 * REAL_PI * ASPECT_RATIO * cd0);
    const real slowSpeed = std::sqrt(2 * WEIGHT / (Glider::DENSITY * AREA * slowLift));
    const real leastSink = slowSpeed * 4 * cd0 / slowLift;

    Glide best{0, 100};
    for (real pull : {-0.05, 0.0, 0.05, 0.1, 0.2, 0.3, 0.35}) {
        const Glide glide = glideWith(pull);
        best.ratio = std::max(best.ratio, glide.ratio);
        best.sink = std::min(best.sink, glide.sink);
    }
    EXPECT_NEAR(best.ratio, bestRatio, 0.02 * bestRatio);
    EXPECT_NEAR(best.sink, leastSink, 0.02 * leastSink);
    EXPECT_GT(bestRatio, 30);
}

/// The stick is slowly pulled until the inner wings stall; true if they did.
bool slowDown(Glider &glider) {
    for (real time = 0; time < 40; time += 0.1) {
        glider.steer(0.1 + time / 30, 0, 0);
        glider.fly(0.1);
        if (glider.isStalled(1) && glider.isStalled(2)) return true;
    }
    return false;
}

TEST(WingFlight, SlowFlightEndsInAStallAndTheNoseDrops) {
    Glider glider;
    ASSERT_TRUE(slowDown(glider));
    const real greatestLift = 1.35;
    const real stallSpeed = std::sqrt(2 * WEIGHT / (Glider::DENSITY * AREA * greatestLift));
    EXPECT_NEAR(glider.getSpeed(), stallSpeed, 0.15 * stallSpeed);
    const real before = glider.getPitch();
    EXPECT_GT(before, 0.1);
    glider.fly(2);  // the stick still pulled
    EXPECT_LT(glider.getPitch(), before - 0.4);
    EXPECT_NEAR(glider.getBank(), 0, 1e-3);
}

TEST(WingFlight, RecoversFromTheStallByItself) {
    Glider glider;
    ASSERT_TRUE(slowDown(glider));
    const real height = glider.body->getPosition().y;
    glider.release();
    glider.fly(3);
    for (int n = 0; n < 600; ++n) {
        glider.fly(0.1);
        ASSERT_FALSE(glider.isStalled(1) || glider.isStalled(2)) << n;
        ASSERT_GT(glider.body->getPosition().y, height - 100) << n;
        ASSERT_NEAR(glider.getBank(), 0, 0.05) << n;
    }
}

/// Stalled, with full rudder to starboard (+1) or port, and the stick held back for so long.
void spin(Glider &glider, real side, real seconds) {
    ASSERT_TRUE(slowDown(glider));
    glider.steer(1, 0, side);
    glider.fly(seconds);
}

TEST(WingFlight, SpinsAtTheStallWithFullRudder) {
    for (real side : {-1.0, 1.0}) {
        Glider glider;
        spin(glider, side, 2.5);
        EXPECT_GT(side * glider.getBank(), 0.2);  // the wing on the rudder's side drops
        glider.fly(8);
        const Vector3 start = glider.body->getPosition();
        const std::size_t inside = side > 0 ? 3 : 0;
        for (int n = 0; n < 60; ++n) {  // it turns by itself, the inner wing stalled
            glider.fly(0.1);
            const Vector3 rates = glider.getRates();
            ASSERT_GT(side * rates.x, 1.5) << n;
            ASSERT_LT(side * rates.y, -0.5) << n;
            ASSERT_TRUE(glider.isStalled(inside)) << n;
            ASSERT_FALSE(glider.isStalled(3 - inside)) << n;
        }
        const Vector3 way = glider.body->getPosition() - start;
        EXPECT_LT(way.y, -10 * std::hypot(way.x, way.z));  // straight down
        EXPECT_LT(glider.getSpeed(), 45);                  // and not faster and faster, as in a dive
    }
}

TEST(WingFlight, NeitherRudderAloneNorStallAloneSpins) {
    Glider stalled;
    ASSERT_TRUE(slowDown(stalled));
    stalled.steer(1, 0, 0);
    stalled.fly(2.5);
    EXPECT_NEAR(stalled.getRates().x, 0, 0.05);
    Glider fast;
    fast.release();
    fast.steer(0.05, 0, 1);
    for (int n = 0; n < 50; ++n) {
        fast.fly(0.1);
        EXPECT_FALSE(fast.isStalled(0) || fast.isStalled(3)) << n;
    }
}

TEST(WingFlight, OppositeRudderEndsTheSpin) {
    for (real side : {-1.0, 1.0}) {
        Glider glider;
        spin(glider, side, 10);
        ASSERT_GT(std::fabs(glider.getRates().x), 1.5);
        glider.steer(-0.2, 0, -side);
        int tenths = 0;
        while (tenths < 20 && glider.isStalledAnywhere()) glider.fly(0.1), ++tenths;
        EXPECT_LT(tenths, 20);
        glider.steer(0.2, 0, 0);  // out of the dive
        glider.fly(1);
        EXPECT_LT(glider.getRates().magnitude(), 1);
        for (int n = 0; n < 100 && glider.body->getVelocity().y < 0; ++n) {
            glider.fly(0.1);
            EXPECT_FALSE(glider.isStalledAnywhere()) << n;
        }
        EXPECT_GE(glider.body->getVelocity().y, 0);
        EXPECT_GT(glider.body->getPosition().y, 500);
    }
}

// ---- Controls

/// In steady flight.
void settle(Glider &glider) {
    glider.release();
    glider.fly(90);
    ASSERT_NEAR(glider.getRates().magnitude(), 0, 0.05);
}

TEST(WingFlight, AileronsRollAndYawAdversely) {
    for (real side : {-1.0, 1.0}) {
        Glider glider;
        settle(glider);
        glider.steer(0.05, side, 0);
        glider.fly(0.5);
        EXPECT_GT(side * glider.getRates().x, 0.4);
        EXPECT_GT(side * glider.getBank(), 0.1);
        EXPECT_LT(side * glider.getHeading(), -0.01);  // the nose goes the other way at first
        // The roll has reached its steady rate: strips damp it by their own motion.
        const real rate = glider.getRates().x;
        glider.fly(0.25);
        EXPECT_NEAR(glider.getRates().x, rate, 0.15 * std::fabs(rate));
    }
}

TEST(WingFlight, RudderTogetherWithAileronsTakesTheAdverseYawAway) {
    Glider glider;
    settle(glider);
    glider.steer(0.05, 1, 0.9);
    glider.fly(0.5);
    EXPECT_GT(glider.getBank(), 0.1);
    EXPECT_GT(glider.getHeading(), -0.01);
}

TEST(WingFlight, PulledItPitchesUpAndPushedDown) {
    for (real pull : {0.3, -0.3}) {
        Glider glider;
        settle(glider);
        const real before = glider.getPitch(), angle = glider.wings[1].getAngleOfAttack(*glider.body);
        glider.steer(0.05 + pull, 0, 0);
        glider.fly(0.5);
        EXPECT_EQ(glider.getPitch() - before > 0.05, pull > 0);
        EXPECT_EQ(glider.getPitch() - before < -0.05, pull < 0);
        EXPECT_EQ(glider.wings[1].getAngleOfAttack(*glider.body) > angle, pull > 0);
        EXPECT_NEAR(glider.getBank(), 0, 1e-6);
    }
}

TEST(WingFlight, RudderYawsAndDihedralThenRollsTheSameWay) {
    for (real side : {-1.0, 1.0}) {
        Glider glider;
        settle(glider);
        glider.steer(0.05, 0, side);
        glider.fly(1);
        EXPECT_LT(side * glider.getRates().y, -0.1);
        EXPECT_GT(side * glider.getHeading(), 0.1);
        EXPECT_GT(side * glider.getBank(), 0.01);
    }
}

TEST(WingFlight, PortAndStarboardFlyAlike) {
    Glider port, starboard;
    for (Glider *glider : {&port, &starboard}) {
        const real side = glider == &port ? -1 : 1;
        glider->steer(0.2, 0.3 * side, 0.5 * side);
        glider->fly(4);
    }
    const Vector3 a = port.body->getPosition(), b = starboard.body->getPosition();
    EXPECT_TRUE(isNear(a, Vector3(b.x, b.y, -b.z), 1e-9));
    EXPECT_GT(std::fabs(a.z), 1);
}

}  // namespace
