#include "sailboat/boat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sailboat/helmsman.h"

namespace {

using cyclone::real;
using cyclone::REAL_PI;
using cyclone::Vector3;
using cyclone::Waves;
using sailboat::Catamaran;
using sailboat::Helmsman;

constexpr real STEP = 1.0 / 60, DEGREE = REAL_PI / 180, G = 9.81;
/// Of all four half hulls together, N/m.
constexpr real HEAVE_STIFFNESS =
    1000 * G * 4 * Catamaran::HALF_HULL_VOLUME / (2 * Catamaran::HULL_HALF_DEPTH);

/// The boat at sea, the wind from the north.
struct Sea {
    cyclone::World world;
    Vector3 windspeed;
    Waves water;
    Catamaran boat;
    Helmsman helmsman;
    real time = 0;

    explicit Sea(real wind = 0) : windspeed(wind, 0, 0), boat(world, &windspeed, &water) {}

    void step(const Vector3 &force = Vector3()) {
        time += STEP;
        water.setTime(time);
        boat.swingBoom(STEP);
        world.startFrame();
        boat.getBody().addForce(force);
        world.runPhysics(STEP);
    }

    void drift(real seconds) {
        for (real end = time + seconds; time < end;) step();
    }

    void sail(real seconds) {
        for (real end = time + seconds; time < end;) {
            helmsman.sail(boat, STEP);
            step();
        }
    }

    /// Under way at this angle to the wind, until nothing changes any more.
    void settle(real windAngle) {
        boat.launch(0, 0, -windAngle, 3);
        helmsman.steerWindAngle(windAngle);
        sail(60);
    }

    real velocityMadeGood() const { return boat.getBody().getVelocity().x; }
};

Sea &settled(Sea &&sea, real windAngle) {
    sea.settle(windAngle);
    return sea;
}

real speedAt(real degrees) { return settled(Sea(6), degrees * DEGREE).boat.getSpeed(); }
real madeGoodAt(real degrees) { return settled(Sea(6), degrees * DEGREE).velocityMadeGood(); }

// ---- Afloat

TEST(Boat, FloatsAtTheWaterlineOfArchimedes) {
    Sea sea;
    cyclone::RigidBody &body = sea.boat.getBody();
    body.setPosition(body.getPosition() + Vector3(0, 0.2, 0));
    sea.drift(30);
    const real share = body.getMass() / (1000 * 4 * Catamaran::HALF_HULL_VOLUME);
    const real hullHeight = Catamaran::HULL_HALF_DEPTH * (1 - 2 * share);
    EXPECT_NEAR(body.getPointInWorldSpace({0, Catamaran::HULL_HEIGHT, 0}).y, hullHeight, 1e-9);
    for (unsigned half = 0; half < 4; ++half)
        EXPECT_NEAR(sea.boat.getBuoyancy(half).y, body.getMass() * G / 4, 1e-3);
    EXPECT_NEAR(sea.boat.getHeel(), 0, 1e-9);
    EXPECT_NEAR(sea.boat.getTrim(), 0, 1e-6);
}

TEST(Boat, LaunchesAtThatWaterline) {
    Sea sea;
    const real before = sea.boat.getBody().getPosition().y;
    sea.drift(5);
    EXPECT_NEAR(sea.boat.getBody().getPosition().y, before, 1e-12);
}

TEST(Boat, OneHullCarriesIt) {
    EXPECT_GT(1000 * 2 * Catamaran::HALF_HULL_VOLUME, Sea().boat.getBody().getMass());
}

TEST(Boat, TurnsAboutItsMastAsItsPartsWeigh) {
    // Each block's m·(x² + z²) of its centre, and a third of that of its half sizes: two hulls, beams, crew,
    // rig.
    const real hulls = 140 * (1.4 * 1.4 + (9 + 0.04) / 3), beams = 35 * (1.44 + 1.96) / 3;
    const real crew = 150 * (0.01 + (0.09 + 0.36) / 3), rig = 30 * (0.25 + (0.09 + 0.0025) / 3);
    EXPECT_NEAR(Sea().boat.getBody().getInertiaTensor().data[4], hulls + beams + crew + rig, 1e-9);
    EXPECT_NEAR(Sea().boat.getBody().getMass(), 140 + 35 + 150 + 30, 1e-9);
}

TEST(Boat, HeavesAtThePeriodOfItsWaterline) {
    Sea sea;
    cyclone::RigidBody &body = sea.boat.getBody();
    const real rest = body.getPosition().y;
    body.setPosition(body.getPosition() + Vector3(0, 0.001, 0));
    // Between crossings of the rest position lies half a period of the damped oscillation. By what it loses
    // from one crossing's speed to the next, damping is measured, and taken out of the period.
    std::vector<real> crossings, speeds;
    real above = 0.001;
    while (crossings.size() < 2 && sea.time < 10) {
        sea.step();
        const real now = body.getPosition().y - rest;
        if ((now > 0) != (above > 0)) {
            crossings.push_back(sea.time - STEP * now / (now - above));
            speeds.push_back(std::fabs(body.getVelocity().y));
        }
        above = now;
    }
    ASSERT_EQ(crossings.size(), 2u);
    const real halfPeriod = crossings[1] - crossings[0];
    const real decay = std::log(speeds[0] / speeds[1]) / halfPeriod;
    const real damped = REAL_PI / halfPeriod;
    EXPECT_NEAR(std::sqrt(damped * damped + decay * decay), std::sqrt(HEAVE_STIFFNESS / body.getMass()), 0.1);
}

TEST(Boat, RidesOverALongSwell) {
    Sea sea;
    sea.water.addTrain({0.5, 120, 0, 0});
    const real rest = sea.boat.getBody().getPosition().y;
    sea.drift(10);
    real highest = -1, lowest = 1, furthest = 0;
    while (sea.time < 30) {
        sea.step();
        const Vector3 position = sea.boat.getBody().getPosition();
        const real rise = position.y - rest;
        highest = std::max(highest, rise);
        lowest = std::min(lowest, rise);
        furthest = std::max(furthest, std::fabs(rise - sea.water.getHeight(position)));
    }
    EXPECT_NEAR(highest, 0.5, 0.05);
    EXPECT_NEAR(lowest, -0.5, 0.05);
    EXPECT_LT(furthest, 0.15);
}

// ---- Upright

/// The torque that holds a heel while both hulls are in the water. Each hull, at (y, ±z), carries half the
/// weight W ± half the stiffness k times its sinking z·sin φ; it pushes at y·sin φ ± z·cos φ from the middle.
real heelingTorque(real mass, real heel) {
    const real z = Catamaran::HULL_SPACING / 2, y = Catamaran::HULL_HEIGHT;
    return HEAVE_STIFFNESS * z * z * std::sin(heel) * std::cos(heel) + mass * G * y * std::sin(heel);
}

/// A constant torque about the world's X axis.
class Heeling : public cyclone::ForceGenerator {
public:
    explicit Heeling(real t) : torque(t, 0, 0) {}
    void updateForce(cyclone::RigidBody *body, real) override { body->addTorque(torque); }

private:
    Vector3 torque;
};

TEST(Boat, HeelsAsItsFormSays) {
    for (const real heel : {-0.15, 0.05, 0.2}) {
        Sea sea;
        Heeling heeling(heelingTorque(sea.boat.getBody().getMass(), heel));
        sea.world.getForceRegistry().add(&sea.boat.getBody(), &heeling);
        sea.drift(20);
        EXPECT_NEAR(sea.boat.getHeel(), heel, 1e-4);
    }
}

TEST(Boat, HeelsToLeewardInAGustAndRightsItself) {
    Sea sea(6);
    sea.settle(90 * DEGREE);
    const real steady = sea.boat.getHeel();
    EXPECT_LT(steady, -2 * DEGREE);  // the wind over the starboard side, port side down
    sea.windspeed = Vector3(9, 0, 0);
    sea.sail(3);
    EXPECT_LT(sea.boat.getHeel(), 1.3 * steady);
    sea.windspeed = Vector3(6, 0, 0);
    sea.sail(30);
    EXPECT_NEAR(sea.boat.getHeel(), steady, 0.2 * DEGREE);
    sea.windspeed = Vector3();
    sea.sail(60);
    EXPECT_NEAR(sea.boat.getHeel(), 0, 0.2 * DEGREE);
}

/// Whether the boat is upright in the end, if it is let go at this heel, on one hull.
bool comesUpright(real heel) {
    Sea sea;
    cyclone::RigidBody &body = sea.boat.getBody();
    body.setOrientation(cyclone::Quaternion::fromAxisAngle(Vector3::X, heel));
    const real share = body.getMass() / (1000 * 2 * Catamaran::HALF_HULL_VOLUME);
    const Vector3 lowHull = body.getDirectionInWorldSpace(Catamaran::getHullCentre(heel > 0 ? 2 : 0));
    body.setPosition(0, Catamaran::HULL_HALF_DEPTH * (1 - 2 * share) - lowHull.y, 0);
    sea.drift(30);
    return !sea.boat.isCapsized() && std::fabs(sea.boat.getHeel()) < DEGREE;
}

TEST(Boat, CapsizesWhereItsCentreOfMassPassesOverTheHull) {
    // On one hull the weight turns the boat back until it stands right above that hull.
    const real limit = std::atan2(Catamaran::HULL_SPACING / 2, -Catamaran::HULL_HEIGHT);
    for (const real side : {-1, 1}) {
        EXPECT_TRUE(comesUpright(side * (limit - 2 * DEGREE)));
        EXPECT_FALSE(comesUpright(side * (limit + 2 * DEGREE)));
    }
}

// ---- In the sea's hands

TEST(Boat, DriftsRoundWithTheWaterOfALongSwell) {
    Sea sea;
    sea.water.addTrain({0.5, 60, 0, 0});
    const real orbitSpeed = 0.5 * std::sqrt(G * 2 * REAL_PI / 60);
    sea.drift(60);
    real fastest = 0;
    for (int n = 0; n < 720; ++n) {
        sea.step();
        const Vector3 level(sea.boat.getBody().getPosition().x, 0, sea.boat.getBody().getPosition().z);
        const Vector3 lag = sea.boat.getBody().getVelocity() - sea.water.getVelocity(level);
        ASSERT_LT(lag.magnitude(), 0.2 * orbitSpeed) << sea.time;
        fastest = std::max(fastest, sea.boat.getBody().getVelocity().x);
    }
    EXPECT_NEAR(fastest, orbitSpeed, 0.1 * orbitSpeed);
}

TEST(Boat, RudderWorksInTheWaterOnly) {
    Sea sea;
    cyclone::RigidBody &body = sea.boat.getBody();
    body.setVelocity(3, 0, 0);
    sea.boat.setRudder(0.3);
    EXPECT_GT(sea.boat.getRudderForce().magnitude(), 100);
    body.setOrientation(cyclone::Quaternion::fromAxisAngle(Vector3::X, REAL_PI));  // capsized
    EXPECT_EQ(sea.boat.getRudderForce(), Vector3());
}

// ---- Under sail

TEST(Boat, SailDrivesMostWhenItBisectsTheWindAndTheStern) {
    Sea sea(8);
    for (const real wind : {-150, -90, -40, 30, 60, 100, 160}) {
        sea.boat.launch(0, 0, -wind * DEGREE);
        const auto drive = [&](real sheet) {
            sea.boat.setSheet(sheet);
            sea.boat.swingBoom(10);
            return sea.boat.getBody().getDirectionInLocalSpace(sea.boat.getSailForce()).x;
        };
        const real best = Helmsman::bestSheet(sea.boat);
        EXPECT_NEAR(best, std::fabs(wind) / 2 * DEGREE, 1e-12);
        EXPECT_GT(drive(best), drive(best + 2 * DEGREE)) << wind;
        EXPECT_GT(drive(best), drive(best - 2 * DEGREE)) << wind;
    }
}

TEST(Boat, TheWindSwingsTheBoomToLeewardUntilTheSheetIsTaut) {
    for (const real side : {-1, 1}) {
        Sea sea(6);
        sea.boat.launch(0, 0, -side * 60 * DEGREE);
        sea.boat.setSheet(20 * DEGREE);
        for (int n = 0; n < 60; ++n) sea.boat.swingBoom(STEP);
        EXPECT_NEAR(sea.boat.getSail(), -side * 20 * DEGREE, 1e-12) << "taut, to leeward";
        sea.boat.setSheet(Catamaran::MAX_SHEET);
        for (int n = 0; n < 60; ++n) sea.boat.swingBoom(STEP);
        EXPECT_NEAR(sea.boat.getSail(), -side * 60 * DEGREE, 1e-12) << "as a flag";
        sea.boat.holdBoom(side);
        for (int n = 0; n < 180; ++n) sea.boat.swingBoom(STEP);
        EXPECT_NEAR(sea.boat.getSail(), side * Catamaran::HELD_OUT, 1e-12) << "held to windward";
        sea.boat.holdBoom(0);
        sea.boat.setSheet(0);
        for (int n = 0; n < 180; ++n) sea.boat.swingBoom(STEP);
        EXPECT_NEAR(sea.boat.getSail(), 0, 1e-12) << "hauled in";
    }
}

TEST(Boat, NoSheetMakesHerSailBackwards) {
    // Off the wind she goes ahead, or lies there with a flapping sail and drifts.
    for (const real windAngle : {45, 70, 90, 120, 150, 180})
        for (const real sheet : {0, 10, 30, 60, 86}) {
            Sea sea(6);
            sea.boat.launch(0, 0, -windAngle * DEGREE);
            sea.boat.setSheet(sheet * DEGREE);
            sea.helmsman.steerWindAngle(windAngle * DEGREE);
            while (sea.time < 20) {
                sea.helmsman.steer(sea.boat, STEP);
                sea.step();
                ASSERT_GT(sea.boat.getSpeed(), -0.5) << windAngle << ", sheet " << sheet;
            }
        }
}

TEST(Boat, IsSlowAsternEvenWithTheSailBacked) {
    // In a wind of 6 m/s a sail square to it pushes with 160·(6 − v) N. The sterns alone, 40 % under water,
    // resist by 2·0.4·82.5·v²: the two agree at 2.8 m/s. She sails ahead at twice that.
    Sea sea(6);
    sea.boat.holdBoom(1);
    real fastest = 0;
    while (sea.time < 20) {
        sea.step();
        fastest = std::min(fastest, sea.boat.getSpeed());
    }
    EXPECT_LT(fastest, -0.3);
    EXPECT_GT(fastest, -2.8);
    EXPECT_GT(speedAt(90), 4.5);
}

TEST(Boat, ACapsizedBoatDoesNotSail) {
    Sea sea(10);
    cyclone::RigidBody &body = sea.boat.getBody();
    sea.boat.launch(0, 0, -90 * DEGREE);
    sea.boat.setSheet(45 * DEGREE);
    body.setOrientation(body.getOrientation() * cyclone::Quaternion::fromAxisAngle(Vector3::X, REAL_PI));
    sea.drift(20);
    EXPECT_TRUE(sea.boat.isCapsized());
    EXPECT_EQ(sea.boat.getSailForce(), Vector3());
    EXPECT_LT(Vector3(body.getVelocity().x, 0, body.getVelocity().z).magnitude(), 0.2);
}

TEST(Boat, StaysInIronsHeadToWind) {
    for (const real sheet : {0, 20, 45, 80}) {
        Sea sea(6);
        sea.boat.setSheet(sheet * DEGREE);
        while (sea.time < 5) {
            sea.step();
            ASSERT_LT(sea.boat.getSpeed(), 0);
        }
    }
    Sea sea(6);
    sea.boat.launch(0, 0, 0, 4);
    sea.drift(60);
    EXPECT_LT(sea.boat.getSpeed(), 0);
}

TEST(Boat, IsFastestOnAReach) {
    const real closeHauled = speedAt(45), beamReach = speedAt(90), broadReach = speedAt(120),
               run = speedAt(180);
    EXPECT_GT(closeHauled, 2);
    EXPECT_GT(beamReach, closeHauled);
    EXPECT_GT(beamReach, run);
    EXPECT_GT(broadReach, run);
    EXPECT_GT(run, closeHauled);
    EXPECT_LT(run, 6);  // nothing outruns the wind before it
}

TEST(Boat, IsFasterThanItDrifts) {
    Sea adrift(6);
    adrift.boat.launch(0, 0, 70 * DEGREE);
    adrift.boat.setSheet(Catamaran::MAX_SHEET);  // let go, as a flag
    adrift.drift(60);
    const real drifting = adrift.boat.getBody().getVelocity().magnitude();
    EXPECT_GT(drifting, 0.05);
    for (const real angle : {45, 90, 135, 180}) EXPECT_GT(speedAt(angle), 2 * drifting);
}

TEST(Boat, BeatsToWindwardBestBetween45And60Degrees) {
    const real best = std::max(madeGoodAt(45), madeGoodAt(55));
    EXPECT_GT(best, 1);
    EXPECT_GT(best, madeGoodAt(30));
    EXPECT_GT(best, madeGoodAt(75));
}

TEST(Boat, SailsAlikeOnBothTacks) {
    Sea port(6), starboard(6);
    port.settle(-70 * DEGREE);
    starboard.settle(70 * DEGREE);
    EXPECT_NEAR(port.boat.getSpeed(), starboard.boat.getSpeed(), 1e-9);
    EXPECT_NEAR(port.boat.getHeel(), -starboard.boat.getHeel(), 1e-9);
    EXPECT_NEAR(port.boat.getLeeway(), -starboard.boat.getLeeway(), 1e-9);
    EXPECT_LT(starboard.boat.getLeeway(), 0);  // away from the wind
}

TEST(Boat, SpeedIsWhereDriveAndResistanceAreEqual) {
    Sea sea(6);
    sea.settle(90 * DEGREE);
    const cyclone::RigidBody &body = sea.boat.getBody();
    // Whatever acts, in all it does nothing to a boat on a steady course.
    EXPECT_LT(body.getLastFrameAcceleration().magnitude(), 1e-4);
    const Vector3 bow = body.getDirectionInWorldSpace(Vector3::X);
    EXPECT_GT(sea.boat.getSailForce() * bow, 100);
}

// ---- Turning

TEST(Boat, RudderTurnsItToTheSideItIsPutTo) {
    for (const real side : {-1, 1}) {
        Sea sea;
        sea.boat.launch(0, 0, 0, 4);
        sea.boat.setRudder(side * 0.3);
        sea.drift(2);
        EXPECT_GT(side * sea.boat.getHeading(), 10 * DEGREE);
        EXPECT_GT(side * sea.boat.getTurnRate(), 0);
    }
}

TEST(Boat, RudderDoesNothingWithoutWay) {
    Sea sea;
    sea.boat.setRudder(0.5);
    EXPECT_EQ(sea.boat.getRudderForce(), Vector3());
    sea.drift(10);
    EXPECT_NEAR(sea.boat.getHeading(), 0, 1e-9);
}

TEST(Boat, RudderWorksTheOtherWayGoingAstern) {
    Sea sea;
    sea.boat.launch(0, 0, 0, -2);
    sea.boat.setRudder(0.3);
    sea.drift(2);
    EXPECT_LT(sea.boat.getHeading(), -3 * DEGREE);
}

TEST(Boat, TacksWithWayOn) {
    Sea sea(6);
    sea.settle(50 * DEGREE);
    sea.helmsman.steerWindAngle(-50 * DEGREE);
    const real began = sea.time;
    while (sea.boat.getTrueWindAngle() > 0 && sea.time < began + 20) sea.sail(STEP);
    EXPECT_LT(sea.boat.getTrueWindAngle(), 0);
    EXPECT_GT(sea.boat.getTrueWindAngle(), -5 * DEGREE);  // through the eye, not the long way round
    EXPECT_GT(sea.boat.getSpeed(), 0.5);
    sea.sail(30);
    EXPECT_NEAR(sea.boat.getTrueWindAngle(), -50 * DEGREE, 3 * DEGREE);
    EXPECT_GT(sea.boat.getSpeed(), 2);
}

TEST(Boat, MissesStaysWithoutWay) {
    Sea sea(6);
    sea.boat.launch(0, 0, -50 * DEGREE, 0);
    sea.boat.setRudder(0.4);
    sea.boat.setSheet(Catamaran::MAX_SHEET);
    sea.drift(15);
    EXPECT_GT(sea.boat.getTrueWindAngle(), 25 * DEGREE);
}

TEST(Boat, GybesTheOtherWayRound) {
    Sea sea(6);
    sea.settle(150 * DEGREE);
    sea.helmsman.steerWindAngle(-150 * DEGREE);
    real closest = REAL_PI;
    for (real end = sea.time + 30; sea.time < end;) {
        sea.sail(STEP);
        closest = std::min(closest, std::fabs(sea.boat.getTrueWindAngle()));
    }
    EXPECT_GT(closest, 90 * DEGREE);
    EXPECT_NEAR(sea.boat.getTrueWindAngle(), -150 * DEGREE, 3 * DEGREE);
    EXPECT_LT(sea.boat.getSail() * sea.boat.getApparentWindAngle(), 0);  // the boom to leeward
}

}  // namespace
