#include <cyclone/aero.h>
#include <cyclone/wind.h>
#include <gtest/gtest.h>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

/// Air that turns about the Y axis like a solid body: velocity = rotation × point.
class Whirl : public WindField {
public:
    explicit Whirl(real rate) : rotation(0, rate, 0) {}
    Vector3 getVelocity(const Vector3 &worldPoint) const override { return rotation % worldPoint; }

private:
    Vector3 rotation;
};

TEST(WindField, BlowsOnEachSurfaceAsItGoesWhereTheSurfaceIs) {
    RigidBody body;
    body.setOrientation(Quaternion::fromAxisAngle(Vector3::Y, REAL_PI / 2));  // X to −Z, Z to X
    body.setPosition(3, 1, 0);
    body.setVelocity(0, 0, 2);
    const Whirl whirl(2);
    const Vector3 windspeed(-1, 0, 0);
    Aero surface(diagonal(-1, -1, -1), Vector3(0, 0, 2), &windspeed);
    surface.setWind(&whirl);
    // At (5, 1, 0) the whirl goes at (0, 0, −10), and the windspeed's air at (1, 0, 0).
    EXPECT_TRUE(isNear(surface.getForce(body), Vector3(1, 0, -12), 1e-14));
    surface.setWind(nullptr);
    EXPECT_TRUE(isNear(surface.getForce(body), Vector3(1, 0, -2), 1e-14));
}

}  // namespace
