// The constants can be used before main, by static objects of any translation unit; the umbrellas hold all.
#include <cyclone/core.h>
#include <gtest/gtest.h>

namespace {

using cyclone::Vector3;

// Constants of the compiler's, so that no order of initialisation can spoil them.
static_assert(Vector3::GRAVITY == Vector3(0, -9.81, 0), "gravity points down");
static_assert(Vector3::X % Vector3::Y == Vector3::Z, "axes are right-handed");

/// A static object whose constructor runs before main.
struct Early {
    Vector3 sum = Vector3::GRAVITY + Vector3::UP + Vector3::RIGHT + Vector3::X + Vector3::Y + Vector3::Z;
} const early;

const Vector3 &reference = Vector3::GRAVITY;

TEST(Headers, ConstantsAreReadyBeforeMain) {
    EXPECT_EQ(early.sum.x, 2);
    EXPECT_DOUBLE_EQ(early.sum.y, -7.81);
    EXPECT_EQ(early.sum.z, 1);
    EXPECT_EQ(&reference, &Vector3::GRAVITY);
}

}  // namespace

// What is missing in an umbrella does not compile below. (That each header compiles alone is checked by the
// target cyclone_headers.)
#include <cyclone/cyclone.h>

namespace {

TEST(Headers, UmbrellaHoldsEverything) {
    cyclone::World world;
    cyclone::RigidBody *body = world.createBody();
    const cyclone::Matrix3 tensor;
    cyclone::Gravity gravity;
    cyclone::Drag drag(0, 0);
    cyclone::Spring spring(Vector3(), body, Vector3(), 1, 1);
    cyclone::Bungee bungee(Vector3(), body, Vector3(), 1, 1);
    cyclone::AnchoredSpring anchored(Vector3(), Vector3(), 1, 1);
    cyclone::Aero aero(tensor, Vector3(), nullptr);
    cyclone::AeroControl control(tensor, tensor, tensor, Vector3(), nullptr);
    cyclone::AngledAero angled(tensor, Vector3(), nullptr);
    cyclone::Wing wing(1, 1, Vector3(), nullptr);
    cyclone::Buoyancy buoyancy(Vector3(), 1, 1, -5);
    cyclone::HullDrag hullDrag(&buoyancy, Vector3(), Vector3(), Vector3());
    cyclone::Thruster thruster(Vector3::X, Vector3(), 1);
    cyclone::Propeller propeller(Vector3::X, Vector3(), 1, 1, nullptr);
    const cyclone::WindGradient gradient(Vector3(), 1);
    const cyclone::Thermal thermal(Vector3(), 0, 1, 1);
    const cyclone::Turbulence turbulence(0);
    cyclone::WindSum air;
    air.add(&gradient);
    air.add(&thermal);
    air.add(&turbulence);
    drag.setWind(&air);
    aero.setWind(&air);
    propeller.setWind(&air);
    cyclone::ForceGenerator *all[] = {&gravity, &drag, &spring,   &bungee,   &anchored, &aero,     &control,
                                      &angled,  &wing, &buoyancy, &hullDrag, &thruster, &propeller};
    for (cyclone::ForceGenerator *force : all) world.getForceRegistry().add(body, force);
    world.startFrame();
    world.runPhysics(0.1);
    EXPECT_NEAR(body->getVelocity().y, -0.981, 1e-14);  // of all, only gravity acts on a body at rest here
}

}  // namespace
