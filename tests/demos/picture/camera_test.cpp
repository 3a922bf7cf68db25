#include "picture/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace demo;

namespace {

constexpr real NOT_A_NUMBER = std::numeric_limits<real>::quiet_NaN();

TEST(DemoCamera, KnownPointsLandWhereTheyShould) {
    const View view({Vector3(), Vector3(1, 0, 0), cyclone::REAL_PI / 2}, 200, 100);
    real x = 0, y = 0;
    ASSERT_TRUE(view.project({10, 0, 0}, x, y));
    EXPECT_NEAR(x, 100, 1e-9);
    EXPECT_NEAR(y, 50, 1e-9);
    ASSERT_TRUE(view.project({10, 10, 0}, x, y)) << "upwards";
    EXPECT_NEAR(x, 100, 1e-9);
    EXPECT_NEAR(y, 0, 1e-9);
    ASSERT_TRUE(view.project({10, 0, 10}, x, y)) << "to starboard, which is right";
    EXPECT_NEAR(x, 150, 1e-9);
    EXPECT_NEAR(y, 50, 1e-9);
    EXPECT_FALSE(view.project({-1, 0, 0}, x, y));
    EXPECT_FALSE(view.project({0, 1, 0}, x, y));
}

TEST(DemoCamera, RaysAreTheInverseOfProjection) {
    const View view({Vector3(3, 4, 5), Vector3(-6, 1, 9), 0.7}, 120, 80);
    for (real px : {0.5, 60.0, 117.25})
        for (real py : {0.5, 31.0, 79.0}) {
            real x = 0, y = 0;
            ASSERT_TRUE(view.project(view.eye() + view.ray(px, py) * 13, x, y));
            EXPECT_NEAR(x, px, 1e-9);
            EXPECT_NEAR(y, py, 1e-9);
        }
}

TEST(DemoCamera, DirectionsThatLeaveUpOpen) {
    real x = 0, y = 0;
    ASSERT_TRUE(View({Vector3(0, 10, 0), Vector3(), 1}, 100, 100).project({1, 0, 0}, x, y));
    EXPECT_NEAR(x, 50, 1e-9);
    EXPECT_LT(y, 50) << "+X is upwards when looking down";
    ASSERT_TRUE(View({Vector3(2, 2, 2), Vector3(2, 2, 2), 1}, 100, 100).project({9, 2, 2}, x, y));
    EXPECT_NEAR(x, 50, 1e-9) << "without a target it looks along +X";
}

TEST(DemoCamera, RefusesNonsense) {
    EXPECT_THROW(View({Vector3(NOT_A_NUMBER, 0, 0), Vector3(), 1}, 9, 9), std::invalid_argument);
    EXPECT_THROW(View({Vector3(), Vector3(0, HUGE_VAL, 0), 1}, 9, 9), std::invalid_argument);
    for (real bad : {0.0, -1.0, 3.15, NOT_A_NUMBER})
        EXPECT_THROW(View({Vector3(), Vector3(1, 0, 0), bad}, 9, 9), std::invalid_argument) << bad;
}

}  // namespace
