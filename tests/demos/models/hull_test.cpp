#include "models/hull.h"

#include <gtest/gtest.h>

using namespace demo;

TEST(DemoHull, ACrashNamesThePartThatHit) {
    RigidBody body;
    body.setPosition(0, 0.5, 0);
    const std::vector<HullPoint> hull = {{"the nose", Vector3(1, 0, 0)}, {"a wing tip", Vector3(0, 0, 2)}};
    EXPECT_EQ(findBrokenPart(body, hull), "");
    body.setOrientation(
        cyclone::Quaternion::fromAxisAngle(Vector3::X, cyclone::REAL_PI / 6));  // starboard wing down
    EXPECT_EQ(findBrokenPart(body, hull), "a wing tip");
    EXPECT_EQ(describeCrash("a wing tip", body, Vector3(3, -4, 0)),
              "crashed: a wing tip hit the ground at 5 m/s, bank 30°, nose 0° up");
    EXPECT_EQ(describeCrash("", body, Vector3()), "crashed: broke up in the air");
}
