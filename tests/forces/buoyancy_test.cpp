#include <cyclone/aero.h>
#include <cyclone/buoyancy.h>
#include <cyclone/world.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "frames.h"
#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

RigidBody at(const Vector3 &position) {
    RigidBody body;
    body.setPosition(position);
    return body;
}

// ---- The force

TEST(Buoyancy, GrowsWithDepthFromNothingToTheWeightOfTheWater) {
    const Buoyancy hull(Vector3(), 0.5, 2, 10);
    const real full = 1000 * 2 * 9.81;
    const real heights[] = {100, 10.5, 10.25, 10, 9.75, 9.5, -100}, parts[] = {0, 0, 0.25, 0.5, 0.75, 1, 1};
    for (int n = 0; n < 7; ++n) {
        const RigidBody body = at(Vector3(3, heights[n], -4));
        EXPECT_NEAR(hull.getSubmersion(body), parts[n], 1e-14);
        EXPECT_TRUE(isNear(hull.getForce(body), Vector3(0, full * parts[n], 0), 1e-9));
    }
}

TEST(Buoyancy, DependsOnTheLiquidAndOnGravity) {
    const RigidBody deep = at(Vector3(0, -9, 0));
    EXPECT_NEAR(Buoyancy(Vector3(), 1, 0.5, 0, 13600, 1.62).getForce(deep).y, 13600 * 0.5 * 1.62, 1e-9);
    EXPECT_TRUE(Buoyancy(Vector3(), 1, 1, 0).actsOnItsBodyOnly());
}

TEST(Buoyancy, ActsUpwardsAtItsCentreHoweverTheBodyIsTurned) {
    World world;
    RigidBody *body = world.createBody();
    body->setPosition(0, -10, 0);
    body->setOrientation(Quaternion::fromAxisAngle(Vector3::Z, REAL_PI / 2));  // body X is up
    Buoyancy hull(Vector3(0, 2, 0), 1, 0.001, 0);                              // at (-2, 0, 0) in the world
    world.getForceRegistry().add(body, &hull);
    run(world, 1);
    EXPECT_TRUE(isNear(body->getVelocity(), Vector3(0, 9.81 * STEP, 0), 1e-14));
    EXPECT_TRUE(isNear(body->getAngularMomentum(), Vector3(0, 0, -2 * 9.81 * STEP), 1e-14));

    // The depth is that of the centre, not of the body.
    Buoyancy mast(Vector3(20, 0, 0), 1, 1, 0);
    EXPECT_EQ(mast.getSubmersion(*body), 0);
}

// ---- Floating

/// 400 kg and 0.8 m³ in water at the height 2: half of it is under water at rest.
struct Bob {
    Buoyancy hull{Vector3(), 0.5, 0.8, 2};
    World world;
    RigidBody *body = world.createBody();

    Bob(real height, real damping) {
        body->setMass(400);
        body->setPosition(0, height, 0);
        body->setAcceleration(Vector3::GRAVITY);
        body->setLinearDamping(damping);
        world.getForceRegistry().add(body, &hull);
    }
};

TEST(Floating, BodyBobsLikeTheReference) {
    Bob undamped(2.3, 1), damped(2.3, 0.9);
    std::ifstream file(CYCLONE_TEST_DATA "/ref_buoyancy_bob.csv");
    std::string line;
    int rows = 0;
    while (std::getline(file, line) && rows < 101) {
        real t = 0, free = 0, freeSpeed = 0, slowed = 0, slowedSpeed = 0;
        char comma = 0;
        if (!(std::istringstream(line) >> t >> comma >> free >> comma >> freeSpeed >> comma >> slowed >>
              comma >> slowedSpeed))
            continue;
        if (rows > 0) {
            run(undamped.world, 12);
            run(damped.world, 12);
        }
        ASSERT_NEAR(undamped.body->getPosition().y, free, 2e-3) << "at " << t << " s";
        ASSERT_NEAR(undamped.body->getVelocity().y, freeSpeed, 8e-3) << "at " << t << " s";
        ASSERT_NEAR(damped.body->getPosition().y, slowed, 2e-3) << "at " << t << " s";
        ++rows;
    }
    EXPECT_EQ(rows, 101);
}

TEST(Floating, BodyComesToRestAtItsWaterline) {
    Bob bob(3.5, 0.3);  // dropped from above the water
    run(bob.world, 3600);
    EXPECT_NEAR(bob.body->getPosition().y, 2, 1e-6);
    EXPECT_NEAR(bob.hull.getSubmersion(*bob.body), 0.5, 1e-6);
    EXPECT_NEAR(bob.body->getVelocity().y, 0, 1e-6);
    EXPECT_TRUE(bob.body->getAwake());
}

TEST(Floating, HeavyBodySinksAndLightOneLeapsOut) {
    Bob heavy(2, 1), light(-5, 1);
    heavy.body->setMass(801);
    run(heavy.world, 1200);
    EXPECT_LT(heavy.body->getPosition().y, 1);
    EXPECT_LT(heavy.body->getVelocity().y, 0);
    real highest = -5;
    for (int n = 0; n < 600; ++n) {
        run(light.world, 1);
        highest = std::fmax(highest, light.body->getPosition().y);
    }
    // Energy: wholly under water it gains 9.81 J/kg for each of 6.5 m, then as much on the way through the
    // surface as gravity takes there.
    EXPECT_NEAR(highest, 2.5 + 6.5, 0.05);
}

// ---- The catamaran

/// Two hulls, each with a buoyancy point fore and aft; 400 kg of 0.8 m³. At rest half of each point's volume
/// is under water, and each is a spring of k = ρVg/2D with V = 0.2 m³ and D = 0.5 m.
///
/// Heeled by φ, the points at ±b abeam and at the height −c below the centre of mass, where the sum of forces
/// is W = m·g, give the righting moment  4·k·b²·sin φ·cos φ − W·c·sin φ  for as long as none leaves the water
/// or goes under: GM = 4·k·b²/W − c, for small φ, where −c is how far the centre of mass lies above the
/// centre of buoyancy.
struct Catamaran {
    static constexpr real VOLUME = 0.2, DEPTH = 0.5, MASS = 400, BEAM = 1.0, LENGTH = 2.0;

    World world;
    RigidBody *boat = world.createBody();
    std::vector<Buoyancy> hulls;

    /// The centre of mass lies `height` above the four points.
    Catamaran(real height, real heel, real damping = 1, const Vector3 &axis = Vector3::X) {
        boat->setMass(MASS);
        boat->setInertiaTensor(diagonal(300, 900, 800));
        boat->setAcceleration(Vector3::GRAVITY);
        boat->setDamping(damping, damping);
        boat->setPosition(0, height, 0);
        boat->setOrientation(Quaternion::fromAxisAngle(axis, heel));
        for (real x : {-LENGTH, LENGTH})
            for (real z : {-BEAM, BEAM}) hulls.emplace_back(Vector3(x, -height, z), DEPTH, VOLUME, 0);
        for (Buoyancy &hull : hulls) world.getForceRegistry().add(boat, &hull);
    }
    static real stiffness() { return 1000 * VOLUME * 9.81 / (2 * DEPTH); }
    static real metacentricHeight(real height, real arm) {
        return 4 * stiffness() * arm * arm / (MASS * 9.81) - height;
    }
    /// + is to starboard, + is the bow up.
    real heel() const { return std::asin(-boat->getDirectionInWorldSpace(Vector3::Z).y); }
    real uprightness() const { return boat->getDirectionInWorldSpace(Vector3::Y).y; }
};

TEST(Catamaran, RollsWithThePeriodOfItsMetacentricHeight) {
    const real height = 0.5, gm = Catamaran::metacentricHeight(height, Catamaran::BEAM);
    EXPECT_NEAR(gm, 2 - 0.5, 1e-12);
    Catamaran boat(height, 0.02);
    // T = 2π·sqrt(I/(m·g·GM)); started at its greatest heel.
    const real omega = std::sqrt(Catamaran::MASS * 9.81 * gm / 300);
    real lastHeel = -boat.heel();
    int crossings = 0;
    real lastCrossing = 0, firstCrossing = 0;
    for (int n = 1; n <= 1200; ++n) {
        run(boat.world, 1);
        const real heel = -boat.heel();
        if ((heel > 0) != (lastHeel > 0)) {
            lastCrossing = (n - heel / (heel - lastHeel)) * STEP;
            if (crossings++ == 0) firstCrossing = lastCrossing;
        }
        lastHeel = heel;
    }
    ASSERT_GT(crossings, 5);
    EXPECT_NEAR((lastCrossing - firstCrossing) / (crossings - 1), REAL_PI / omega, 0.005 * REAL_PI / omega);
    EXPECT_NEAR(firstCrossing, REAL_PI / 2 / omega, 0.01 / omega);
}

TEST(Catamaran, HeeledRightsItself) {
    for (real heel : {0.2, -0.3, 0.6}) {
        Catamaran boat(0.5, heel, 0.3);
        run(boat.world, 3600);
        EXPECT_NEAR(boat.heel(), 0, 1e-4) << heel;
        EXPECT_NEAR(boat.uprightness(), 1, 1e-6) << heel;
        EXPECT_NEAR(boat.boat->getPosition().y, 0.5, 1e-4);
    }
    Catamaran pitched(0.5, 0.15, 0.3, Vector3::Z);
    run(pitched.world, 3600);
    EXPECT_NEAR(pitched.uprightness(), 1, 1e-6);
}

TEST(Catamaran, CapsizesWhenItsCentreOfMassLiesAboveTheMetacentre) {
    // GM = 2 − height: the boat stands at 1.9 m and falls at 2.1 m.
    Catamaran low(1.9, 0.01, 0.5), high(2.1, 0.01, 0.5);
    EXPECT_GT(Catamaran::metacentricHeight(1.9, Catamaran::BEAM), 0);
    EXPECT_LT(Catamaran::metacentricHeight(2.1, Catamaran::BEAM), 0);
    run(low.world, 4800);
    run(high.world, 4800);
    EXPECT_NEAR(low.uprightness(), 1, 1e-4);
    EXPECT_LT(high.uprightness(), 0);
    // It comes to rest upside down, its hulls above its centre of mass: stable.
    EXPECT_LT(high.uprightness(), -0.9);
}

TEST(Catamaran, CapsizedStaysCapsizedAsHullsOverheadAreStable) {
    Catamaran boat(0.5, REAL_PI - 0.2, 0.3);
    run(boat.world, 3600);
    EXPECT_NEAR(boat.uprightness(), -1, 1e-4);
}

TEST(Catamaran, IsSteeredByAnAngledSurface) {
    // Pushed along by its bow, a blade at the stern turned to starboard turns it to starboard.
    for (real degrees : {10.0, -10.0}) {
        Catamaran boat(0.5, 0, 0.9);
        boat.boat->setVelocity(5, 0, 0);
        AngledAero blade(diagonal(0, 0, -200), Vector3(-2, -0.5, 0), nullptr);
        blade.setOrientation(Quaternion::fromAxisAngle(Vector3::Y, degrees * REAL_PI / 180));
        blade.setRotationalFlow(true);
        boat.world.getForceRegistry().add(boat.boat, &blade);
        run(boat.world, 120);
        const real bow = boat.boat->getDirectionInWorldSpace(Vector3::X).z;
        EXPECT_GT(bow * degrees, 0);
        EXPECT_GT(std::fabs(bow), 0.05);
        EXPECT_GT(boat.uprightness(), 0.9);
    }
}

// ---- In waves

TEST(Buoyancy, FollowsTheSurfaceOfWaves) {
    Waves sea;
    sea.addTrain({1, 40, 0, 0});
    Buoyancy hull(Vector3(), 1, 1, -50);
    EXPECT_EQ(hull.getSubmersion(RigidBody()), 0);
    hull.setWater(&sea);
    EXPECT_NEAR(hull.getSubmersion(at(Vector3(10, 0, 0))), 1, 1e-11);
    EXPECT_NEAR(hull.getSubmersion(at(Vector3(30, 0, 0))), 0, 1e-11);
    EXPECT_NEAR(hull.getSubmersion(at(Vector3(0, 0, 0))), 0.5, 1e-11);
    EXPECT_NEAR(hull.getSubmersion(at(Vector3(10, 1.5, 0))), 0.25, 1e-11);
    // The height of the water counts where the hull's centre is, not the body's.
    Buoyancy bow(Vector3(10, 0, 0), 1, 1, 0);
    bow.setWater(&sea);
    EXPECT_NEAR(bow.getSubmersion(RigidBody()), 1, 1e-11);
    hull.setWater(nullptr);
    EXPECT_EQ(hull.getSubmersion(RigidBody()), 0);
}

}  // namespace
