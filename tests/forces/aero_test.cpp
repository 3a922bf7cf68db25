#include <cyclone/aero.h>
#include <cyclone/world.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

constexpr real STEP = 1.0 / 120;

// The chapter's tensors, in N·s/m: a tailplane or a wing at rest, a wing with its flap up and down, a rudder
// with its trailing edge to either side.
const Matrix3 WING(-0.1, 0, 0, 1, -0.5, 0, 0, 0, -0.1);
const Matrix3 WING_MIN(-0.2, 0, 0, -0.2, -0.5, 0, 0, 0, -0.1);
const Matrix3 WING_MAX(-0.2, 0, 0, 1.4, -0.5, 0, 0, 0, -0.1);

Matrix3 rudder(real s) { return Matrix3(-0.1, 0, 0, 0, -0.1, 0, s, 0, -0.5); }

void run(World &world, int steps) {
    for (int n = 0; n < steps; ++n) {
        world.startFrame();
        world.runPhysics(STEP);
    }
}

RigidBody turned(const Vector3 &axis, real degrees, const Vector3 &velocity) {
    RigidBody body;
    body.setOrientation(Quaternion::fromAxisAngle(axis, degrees * REAL_PI / 180));
    body.setVelocity(velocity);
    return body;
}

// ---- The chapter's surfaces

TEST(Aero, WingLiftsAndDragsInLevelFlight) {
    const Aero wing(WING, Vector3(), nullptr);
    const Vector3 force = wing.getForce(turned(Vector3::Z, 0, Vector3(10, 0, 0)));
    EXPECT_TRUE(isNear(force, Vector3(-1, 10, 0), 1e-14));
}

TEST(Aero, WingLiftsLessWhenItSinksNoseUpAndMoreWhenItClimbs) {
    // At the angle of attack a the air comes at (cos a, -sin a)·v in body axes: lift cos a + sin a / 2.
    const Aero wing(WING, Vector3(), nullptr);
    for (real degrees : {-20.0, -5.0, 5.0, 20.0, 90.0}) {
        const RigidBody body = turned(Vector3::Z, degrees, Vector3(10, 0, 0));
        const real a = degrees * REAL_PI / 180;
        const Vector3 inBody = body.getDirectionInLocalSpace(wing.getForce(body));
        EXPECT_TRUE(isNear(inBody, Vector3(-std::cos(a), 10 * std::cos(a) + 5 * std::sin(a), 0), 1e-13));
    }
}

TEST(Aero, BankedWingPullsIntoTheTurn) {
    // Rolled to starboard (about the nose, +X, by the right hand: +Y goes to +Z).
    const Aero wing(WING, Vector3(), nullptr);
    const Vector3 force = wing.getForce(turned(Vector3::X, 30, Vector3(10, 0, 0)));
    EXPECT_TRUE(isNear(force, Vector3(-1, 10 * std::sqrt(0.75), 5), 1e-13));
}

TEST(Aero, WindComesFromWhereItPointsTo) {
    Vector3 wind(10, 0, 0);
    const Aero wing(WING, Vector3(), &wind);
    EXPECT_TRUE(isNear(wing.getForce(RigidBody()), Vector3(-1, 10, 0), 1e-14));  // a headwind lifts
    wind = Vector3(-10, 0, 0);
    EXPECT_EQ(wing.getForce(turned(Vector3::Z, 0, Vector3(10, 0, 0))), Vector3());  // carried along
}

TEST(Aero, ForceTurnsWithTheWorld) {
    Random random(30);
    for (int n = 0; n < 200; ++n) {
        const Quaternion turn = random.orientation();
        const Vector3 wind = random.vector(10), turnedWind = turn.rotate(wind);
        const Vector3 position = random.vector();
        const Matrix3 tensor = random.matrix();
        Aero here(tensor, position, &wind), there(tensor, position, &turnedWind);
        here.setRotationalFlow(n % 2 == 0);
        there.setRotationalFlow(n % 2 == 0);
        RigidBody body, image;
        body.setOrientation(random.orientation());
        body.setVelocity(random.vector(10));
        body.setRotation(random.vector());
        image.setOrientation(turn * body.getOrientation());
        image.setVelocity(turn.rotate(body.getVelocity()));
        image.setRotation(turn.rotate(body.getRotation()));
        image.setPosition(100, 200, 300);  // where it is does not matter
        EXPECT_TRUE(isNear(there.getForce(image), turn.rotate(here.getForce(body)), 1e-12));
    }
}

TEST(Aero, ForceActsAtItsPosition) {
    Random random(31);
    for (int n = 0; n < 50; ++n) {
        World world;
        RigidBody *body = world.createBody();
        body->setOrientation(random.orientation());
        body->setVelocity(random.vector(10));
        const Vector3 position = random.vector();
        Aero aero(random.matrix(), position, nullptr);
        const Vector3 force = aero.getForce(*body);
        const Vector3 arm = body->getOrientation().rotate(position);
        const Vector3 before = body->getVelocity();
        world.getForceRegistry().add(body, &aero);
        run(world, 1);
        EXPECT_TRUE(isNear(body->getVelocity() - before, force * STEP, 1e-13));
        EXPECT_TRUE(isNear(body->getAngularMomentum(), arm % force * STEP, 1e-13));
    }
}

// ---- Motion in closed form

TEST(Aero, BodyTakesUpTheWindExponentially) {
    const Vector3 wind(4, -3, 0);  // from there: the body is blown to -wind
    Aero aero(diagonal(-0.5, -1, -2), Vector3(), &wind);
    World world;
    RigidBody *body = world.createBody();
    body->setMass(2);
    body->setVelocity(0, 0, 6);
    world.getForceRegistry().add(body, &aero);
    run(world, 240);
    const Vector3 u(4 * std::exp(-0.5), -3 * std::exp(-1.0), 6 * std::exp(-2.0));
    EXPECT_TRUE(isNear(body->getVelocity(), u - wind, 5e-4));
}

TEST(Aero, ProjectileFollowsTheReference) {
    const Vector3 wind(-4, 0, 2);
    Aero aero(diagonal(-0.6, -0.9, -0.3), Vector3(), &wind);
    World world;
    RigidBody *body = world.createBody();
    body->setMass(3);
    body->setPosition(0, 10, 0);
    body->setVelocity(30, 40, -5);
    body->setAcceleration(Vector3::GRAVITY);
    world.getForceRegistry().add(body, &aero);

    std::ifstream file(CYCLONE_TEST_DATA "/ref_projectile_lineardrag.csv");
    std::string line;
    int rows = 0;
    while (std::getline(file, line)) {
        real t = 0, x = 0, y = 0, z = 0;
        char comma = 0;
        if (!(std::istringstream(line) >> t >> comma >> x >> comma >> y >> comma >> z)) continue;
        if (rows > 0) run(world, 12);  // to the next tenth of a second
        ASSERT_TRUE(isNear(body->getPosition(), Vector3(x, y, z), 1e-3)) << "at " << t << " s";
        ++rows;
    }
    EXPECT_EQ(rows, 101);
}

TEST(Aero, RotationalFlowDampsSpinAtTheRateOfItsArm) {
    // Two surfaces at ±a along X with drag c along Y: torque about Z is -2·c·a²·rotation, the force nil.
    const real c = 0.5, a = 1.5, inertia = 4;
    for (bool flow : {true, false}) {
        Aero left(diagonal(0, -c, 0), Vector3(a, 0, 0), nullptr),
            right(diagonal(0, -c, 0), Vector3(-a, 0, 0), nullptr);
        EXPECT_FALSE(left.getRotationalFlow());
        left.setRotationalFlow(flow);
        right.setRotationalFlow(flow);
        World world;
        RigidBody *body = world.createBody();
        body->setInertiaTensor(diagonal(1, 2, inertia));
        body->setRotation(0, 0, 3);
        world.getForceRegistry().add(body, &left);
        world.getForceRegistry().add(body, &right);
        run(world, 240);
        const real wanted = flow ? 3 * std::exp(-2 * c * a * a / inertia * 2) : 3;
        EXPECT_NEAR(body->getRotation().z, wanted, 1e-4);
        EXPECT_TRUE(isNear(body->getVelocity(), Vector3(), 1e-14));
    }
}

TEST(Aero, RotationalFlowOnARollingWing) {
    // The starboard wing tip of an aircraft that rolls to starboard goes down: more lift there, against it.
    Aero wing(WING, Vector3(0, 0, 2), nullptr);
    wing.setRotationalFlow(true);
    RigidBody body;
    body.setVelocity(10, 0, 0);
    body.setRotation(1, 0, 0);
    EXPECT_TRUE(isNear(wing.getForce(body), Vector3(-1, 10 + 0.5 * 2, 0), 1e-13));
    body.setRotation(-1, 0, 0);
    EXPECT_TRUE(isNear(wing.getForce(body), Vector3(-1, 10 - 0.5 * 2, 0), 1e-13));
    body.setRotation(0, 1, 0);  // nose to port: the starboard wing goes faster
    EXPECT_TRUE(isNear(wing.getForce(body), Vector3(-1.2, 12, 0), 1e-13));
}

TEST(Aero, KeepsWhatItWasGiven) {
    const Aero aero(WING, Vector3(1, 2, 3), nullptr);
    EXPECT_EQ(aero.getTensor(), WING);
    EXPECT_EQ(aero.getPosition(), Vector3(1, 2, 3));
    EXPECT_TRUE(aero.actsOnItsBodyOnly());
}

// ---- AeroControl

TEST(AeroControl, GoesFromMinThroughBaseToMax) {
    AeroControl wing(WING, WING_MIN, WING_MAX, Vector3(), nullptr);
    EXPECT_EQ(wing.getControl(), 0);
    EXPECT_EQ(wing.getTensor(), WING);
    wing.setControl(-1);
    EXPECT_EQ(wing.getTensor(), WING_MIN);
    wing.setControl(1);
    EXPECT_EQ(wing.getTensor(), WING_MAX);
    wing.setControl(0.5);
    EXPECT_TRUE(isNear(wing.getTensor(), Matrix3(-0.15, 0, 0, 1.2, -0.5, 0, 0, 0, -0.1), 1e-15));
    wing.setControl(-0.25);
    EXPECT_TRUE(isNear(wing.getTensor(), Matrix3(-0.125, 0, 0, 0.7, -0.5, 0, 0, 0, -0.1), 1e-15));
    wing.setControl(0);
    EXPECT_EQ(wing.getTensor(), WING);
}

TEST(AeroControl, StopsAtTheEnds) {
    AeroControl wing(WING, WING_MIN, WING_MAX, Vector3(), nullptr);
    for (real beyond : {1.001, 7.0, 1e300}) {
        wing.setControl(beyond);
        EXPECT_EQ(wing.getControl(), 1);
        EXPECT_EQ(wing.getTensor(), WING_MAX);
        wing.setControl(-beyond);
        EXPECT_EQ(wing.getControl(), -1);
        EXPECT_EQ(wing.getTensor(), WING_MIN);
    }
}

TEST(AeroControl, FlapChangesTheLift) {
    AeroControl wing(WING, WING_MIN, WING_MAX, Vector3(0.1, 0, 2), nullptr);
    const RigidBody body = turned(Vector3::Z, 0, Vector3(10, 0, 0));
    const real controls[] = {-1, -0.5, 0, 0.5, 1}, lifts[] = {-2, 4, 10, 12, 14};
    for (int n = 0; n < 5; ++n) {
        wing.setControl(controls[n]);
        EXPECT_NEAR(wing.getForce(body).y, lifts[n], 1e-13);
    }
}

TEST(AeroControl, RudderYaws) {
    // Aft of the centre of mass. Control +1 pushes the tail to starboard (+Z), the nose to port: about +Y.
    AeroControl fin(rudder(0), rudder(-0.4), rudder(0.4), Vector3(-1, 0, 0), nullptr);
    for (real control : {-1.0, 0.0, 1.0}) {
        fin.setControl(control);
        World world;
        RigidBody *body = world.createBody();
        body->setVelocity(10, 0, 0);
        world.getForceRegistry().add(body, &fin);
        run(world, 1);
        EXPECT_NEAR(body->getAngularMomentum().y, control * 4 * STEP, 1e-13);
    }
}

TEST(AeroControl, AileronsRoll) {
    AeroControl port(WING, WING_MIN, WING_MAX, Vector3(0, 0, -2), nullptr);
    AeroControl starboard(WING, WING_MIN, WING_MAX, Vector3(0, 0, 2), nullptr);
    port.setControl(1);
    starboard.setControl(-1);
    World world;
    RigidBody *body = world.createBody();
    body->setVelocity(10, 0, 0);
    world.getForceRegistry().add(body, &port);
    world.getForceRegistry().add(body, &starboard);
    run(world, 1);
    // Lift 14 on port and -2 on starboard: roll to starboard, about +X.
    EXPECT_NEAR(body->getAngularMomentum().x, 2 * (14 + 2) * STEP, 1e-13);
}

// ---- AngledAero

TEST(AngledAero, UnturnedIsAnAero) {
    Random random(32);
    const Matrix3 tensor = random.matrix();
    const RigidBody body = turned(random.vector(), 50, random.vector(10));
    AngledAero angled(tensor, Vector3(1, 2, 3), nullptr);
    EXPECT_EQ(angled.getOrientation(), Quaternion());
    EXPECT_EQ(angled.getForce(body), Aero(tensor, Vector3(1, 2, 3), nullptr).getForce(body));
}

TEST(AngledAero, TurningTheSurfaceEqualsTurningTheBody) {
    Random random(33);
    for (int n = 0; n < 200; ++n) {
        const Quaternion r = random.orientation(), s = random.orientation();
        const Matrix3 tensor = random.matrix();
        const Vector3 wind = random.vector(5);
        AngledAero angled(tensor, random.vector(), &wind);
        const real length = random.between(0.1, 10);
        angled.setOrientation(Quaternion(s.r * length, s.i * length, s.j * length, s.k * length));
        EXPECT_TRUE(turnsLike(angled.getOrientation(), s, 1e-15));
        RigidBody body, whole;
        body.setOrientation(r);
        whole.setOrientation(r * s);
        body.setVelocity(random.vector(5));
        whole.setVelocity(body.getVelocity());
        const Aero plain(tensor, Vector3(), &wind);
        EXPECT_TRUE(isNear(angled.getForce(body), plain.getForce(whole), 1e-13));
    }
}

TEST(AngledAero, TurningDoesNotMoveThePoint) {
    AngledAero angled(diagonal(-1, -1, -1), Vector3(-2, 0, 0), nullptr);
    angled.setOrientation(Quaternion::fromAxisAngle(Vector3::Y, 1));
    World world;
    RigidBody *body = world.createBody();
    body->setVelocity(0, 0, 5);
    world.getForceRegistry().add(body, &angled);
    run(world, 1);
    EXPECT_TRUE(isNear(body->getAngularMomentum(), Vector3(-2, 0, 0) % Vector3(0, 0, -5) * STEP, 1e-14));
}

TEST(AngledAero, RudderSteersToTheSideToWhichItIsTurned) {
    // A blade in the plane of X and Y that only resists sideways flow, at the stern. Turned by +15° about Y,
    // its trailing edge goes to starboard, the flow pushes the stern to port and the bow to starboard.
    for (real degrees : {15.0, 0.0, -15.0}) {
        AngledAero blade(diagonal(0, 0, -1), Vector3(-3, 0, 0), nullptr);
        blade.setOrientation(Quaternion::fromAxisAngle(Vector3::Y, degrees * REAL_PI / 180));
        const RigidBody body = turned(Vector3::Y, 0, Vector3(4, 0, 0));
        const real a = degrees * REAL_PI / 180;
        EXPECT_TRUE(
            isNear(blade.getForce(body), Vector3(std::sin(a), 0, std::cos(a)) * (-4 * std::sin(a)), 1e-14));

        World world;
        RigidBody *boat = world.createBody();
        boat->setVelocity(4, 0, 0);
        boat->setInertiaTensor(diagonal(10, 10, 10));
        blade.setRotationalFlow(true);
        world.getForceRegistry().add(boat, &blade);
        run(world, 60);
        const real bow = boat->getDirectionInWorldSpace(Vector3::X).z;  // + is starboard
        EXPECT_EQ(bow > 1e-3, degrees > 0);
        EXPECT_EQ(bow < -1e-3, degrees < 0);
    }
}

}  // namespace
