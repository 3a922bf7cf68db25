// The motorboat: how it floats, planes, porpoises, turns, and flies on foils.
#include "speedboat/motorboat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/attitude.h"
#include "models/sea.h"

using namespace speedboat;
using demo::bankOf;
using demo::headingOf;
using demo::pitchOf;

namespace {

constexpr real STEP = 1.0 / 120, DEGREE = cyclone::REAL_PI / 180, WEIGHT = Motorboat::MASS * 9.81;

/// A boat on a sea without wind.
struct Bay {
    cyclone::World world;
    cyclone::Waves sea;
    Motorboat boat;
    real time = 0;

    explicit Bay(Hull hull = Hull::PLANING, real waves = 0, real wavesGo = 0)
        : boat(world, nullptr, &sea, hull) {
        for (const cyclone::Waves::Train &train : demo::makeSea(waves, wavesGo)) sea.addTrain(train);
    }
    void step() {
        world.startFrame();
        world.runPhysics(STEP);
        sea.setTime(time += STEP);
    }
    void run(real seconds) {
        for (const real end = time + seconds; time < end;) step();
    }
    /// Steers north.
    void keepCourse(real seconds) {
        for (const real end = time + seconds; time < end;) {
            boat.setSteering(-headingOf(body()) + 0.35 * body().getRotation().y);
            step();
        }
    }
    const RigidBody &body() const { return boat.getBody(); }
    real trim() const { return pitchOf(body()) / DEGREE; }
    real turnRate() const { return -body().getRotation().y / DEGREE; }  // °/s, to starboard
    real lift(const std::vector<cyclone::Wing> &wings) const {
        real sum = 0;
        for (const cyclone::Wing &wing : wings) sum += wing.getForce(body()).y;
        return sum;
    }
    real buoyancy() const {
        real sum = 0;
        for (const cyclone::Buoyancy &part : boat.getFloats()) sum += part.getForce(body()).y;
        return sum;
    }
    bool isHullDry() const { return boat.getWettedLength() == 0 && buoyancy() == 0; }
};

/// Half the range of the trim in the time to come, degrees.
real swingOfTrim(Bay &bay, real seconds) {
    real least = bay.trim(), most = least;
    for (const real end = bay.time + seconds; bay.time < end;) {
        bay.step();
        least = std::min(least, bay.trim());
        most = std::max(most, bay.trim());
    }
    return (most - least) / 2;
}

// ---- The planing hull

TEST(Motorboat, FloatsAtRestByItsBuoyancyAlone) {
    Bay bay;
    bay.run(60);
    EXPECT_NEAR(bay.buoyancy(), WEIGHT, 0.001 * WEIGHT);
    EXPECT_LT(std::fabs(bay.lift(bay.boat.getBottom())), 0.001 * WEIGHT);
    EXPECT_LT(bay.body().getVelocity().magnitude(), 0.01);
    EXPECT_NEAR(bankOf(bay.body()), 0, 1e-6);
}

TEST(Motorboat, PlanesOverAHump) {
    // More throttle step by step; the settled states make curves over the speed.
    struct State {
        real speed, trim, draught, wetted, buoyancy;
    };
    std::vector<State> states;
    Bay bay;
    bay.run(20);
    for (real throttle = 0; throttle <= 1.001; throttle += 0.05) {
        bay.boat.setThrottle(throttle);
        bay.run(throttle < 0.5 ? 12 : 5);
        states.push_back({bay.boat.getSpeed(), bay.trim(), bay.boat.getDraught(), bay.boat.getWettedLength(),
                          bay.buoyancy()});
    }
    for (std::size_t n = 1; n < states.size(); ++n) EXPECT_GT(states[n].speed, states[n - 1].speed);
    const State &rest = states.front(), &fast = states.back();
    const State &hump = *std::max_element(states.begin(), states.end(),
                                          [](const State &a, const State &b) { return a.trim < b.trim; });
    EXPECT_GT(hump.trim, rest.trim + 2);
    EXPECT_GT(hump.trim, fast.trim + 2);
    EXPECT_GT(hump.speed, 4);
    EXPECT_LT(hump.speed, 10);
    EXPECT_LT(fast.draught, rest.draught - 0.1);
    EXPECT_LT(fast.wetted, 0.6 * rest.wetted);
    EXPECT_LT(fast.buoyancy, 0.1 * WEIGHT);
    EXPECT_GT(bay.lift(bay.boat.getBottom()), 0.85 * WEIGHT) << "its bottom carries it";
}

TEST(Motorboat, SettlesWhereTheScrewsThrustMeetsTheDrag) {
    for (const real throttle : {0.4, 0.7, 1.0}) {
        Bay bay;
        bay.boat.setThrottle(throttle);
        bay.run(60);
        const real speed = bay.boat.getSpeed(), thrust = bay.boat.getThrust().magnitude();
        // The screw's advance is the speed along its shaft, which points up with the trim.
        const real along = bay.body().getVelocity() * bay.body().getDirectionInWorldSpace(Vector3::X);
        EXPECT_NEAR(thrust, throttle * Motorboat::MAX_THRUST * (1 - along / Motorboat::PITCH_SPEED), 1);
        bay.run(10);
        EXPECT_NEAR(bay.boat.getSpeed(), speed, 0.01 * speed);
        // Planing boats of this size need between an eighth and a third of their weight (Savitsky 1964).
        if (throttle < 1) continue;
        EXPECT_GT(thrust, WEIGHT / 8);
        EXPECT_LT(thrust, WEIGHT / 3);
    }
}

TEST(Motorboat, PorpoisesWithTheMotorTiltedOutAndRunsSteadilyOtherwise) {
    for (const real tilt : {-0.1, 0.0, 0.1, 0.2, 0.3}) {
        Bay bay;
        bay.boat.setTilt(tilt);
        for (int n = 1; n <= 12; ++n) {  // gently
            bay.boat.setThrottle(n / 12.0);
            bay.run(1);
        }
        bay.run(20);
        const real swing = swingOfTrim(bay, 8);
        if (tilt > 0.15)
            EXPECT_GT(swing, 2) << tilt;
        else
            EXPECT_LT(swing, 0.1) << tilt;
        EXPECT_FALSE(bay.boat.isCapsized());
    }
}

TEST(Motorboat, TiltRaisesTheBow) {
    real last = -90;
    for (const real tilt : {-0.1, 0.0, 0.1}) {
        Bay bay;
        bay.boat.setTilt(tilt);
        bay.boat.setThrottle(1);
        bay.run(40);
        EXPECT_GT(bay.trim(), last + 0.2) << tilt;
        last = bay.trim();
    }
}

// ---- Steering

TEST(Motorboat, TurnsTheWayTheMotorIsTurnedAndLeansInwards) {
    for (const Hull hull : {Hull::PLANING, Hull::FOILS}) {
        Bay starboard(hull), port(hull);
        for (Bay *bay : {&starboard, &port}) {
            bay->boat.setThrottle(1);
            bay->run(25);
            bay->boat.setSteering(bay == &starboard ? 0.4 : -0.4);
            bay->run(4);
        }
        EXPECT_GT(starboard.turnRate(), 8);
        EXPECT_GT(bankOf(starboard.body()), 1 * DEGREE);
        EXPECT_NEAR(port.turnRate(), -starboard.turnRate(), 1e-3) << "the mirror image";
        EXPECT_NEAR(bankOf(port.body()), -bankOf(starboard.body()), 1e-3);
    }
}

TEST(Motorboat, ThrustTurnedBySteeringPushesTheSternAside) {
    Bay bay;
    bay.boat.setThrottle(1);
    bay.boat.setSteering(0.3);
    bay.boat.setTilt(0.2);
    const Vector3 thrust = bay.boat.getThrust();
    EXPECT_NEAR(std::atan2(-thrust.z, thrust.x), 0.3, 1e-12);
    EXPECT_NEAR(thrust.y, -Motorboat::MAX_THRUST * std::sin(0.2), 1e-9);
    EXPECT_LT((bay.boat.getScrew() % thrust).y, 0) << "clockwise from above";
}

TEST(Motorboat, WithoutThrustNothingSteers) {
    Bay bay;
    bay.boat.setThrottle(1);
    bay.run(25);
    bay.boat.setThrottle(0);
    bay.boat.setSteering(Motorboat::MAX_STEERING);
    bay.run(2);
    EXPECT_GT(bay.boat.getSpeed(), 3);
    EXPECT_NEAR(headingOf(bay.body()), 0, 1e-6);
}

TEST(Motorboat, InTheAirThereIsNeitherThrustNorSteering) {
    Bay bay;
    bay.boat.setThrottle(1);
    bay.boat.setSteering(Motorboat::MAX_STEERING);
    RigidBody &body = bay.boat.getBody();
    body.setPosition(0, 3, 0);
    body.setVelocity(12, 0, 0);
    EXPECT_TRUE(bay.boat.isScrewDry());
    EXPECT_TRUE(bay.boat.isAirborne());
    EXPECT_EQ(bay.boat.getThrust(), Vector3());
    bay.run(0.5);  // falls by 1.2 m
    EXPECT_TRUE(bay.boat.isScrewDry());
    EXPECT_NEAR(bay.turnRate(), 0, 1e-9);
    EXPECT_NEAR(body.getVelocity().y, -9.81 * 0.5, 0.1);
    EXPECT_LE(body.getVelocity().x, 12);

    // The screw half in the water pushes half as much.
    body.setVelocity(0, 0, 0);
    body.setOrientation(Quaternion());
    body.setPosition(0, -bay.boat.getScrew().y, 0);
    EXPECT_FALSE(bay.boat.isScrewDry());
    EXPECT_NEAR(bay.boat.getThrust().magnitude(), Motorboat::MAX_THRUST / 2, 1e-9);
}

// ---- Foils

/// What lifting-line theory gives for a foil at its angle of attack, as far as it is under water, N upwards.
real foilLift(const Bay &bay, const cyclone::Wing &foil, const Motorboat::FoilPlan &plan) {
    const Vector3 point = bay.body().getPointInWorldSpace(foil.getPosition());
    const real wet = std::clamp(-point.y / Motorboat::FOIL_DEPTH, 0.0, 1.0);
    const real aspectRatio = plan.span / plan.chord, area = plan.span * plan.chord;
    const real slope = 2 * cyclone::REAL_PI * aspectRatio / (aspectRatio + 2), camber = 0.05;
    const real speed = bay.boat.getSpeed();
    const real lift = 500 * speed * speed * area * wet * slope * (foil.getAngleOfAttack(bay.body()) + camber);
    return lift * std::cos(Motorboat::FOIL_DIHEDRAL);
}

TEST(Hydrofoil, LiftsItsHullOutAboveASpeedAndSettlesHigherTheFasterItIs) {
    Bay bay(Hull::FOILS);
    real lastDraught = 10, takeOff = 0;
    for (const real throttle : {0.1, 0.2, 0.3, 0.5, 0.7, 1.0}) {
        bay.boat.setThrottle(throttle);
        bay.run(30);
        const real draught = bay.boat.getDraught();
        bay.run(5);
        EXPECT_NEAR(bay.boat.getDraught(), draught, 0.02) << throttle;
        EXPECT_LT(bay.boat.getDraught(), lastDraught - 0.01) << throttle;
        lastDraught = bay.boat.getDraught();
        if (!bay.isHullDry()) {
            EXPECT_EQ(takeOff, 0) << "never again in the water";
            EXPECT_LT(bay.boat.getSpeed(), 8);
            continue;
        }
        if (takeOff == 0) takeOff = bay.boat.getSpeed();
        real lift = bay.boat.getThrust().y;
        for (std::size_t n = 0; n < 4; ++n)
            lift +=
                foilLift(bay, bay.boat.getFoils()[n], n < 2 ? Motorboat::FRONT_FOILS : Motorboat::AFT_FOILS);
        EXPECT_NEAR(lift, WEIGHT, 0.03 * WEIGHT) << throttle;
        EXPECT_NEAR(bay.lift(bay.boat.getFoils()), WEIGHT, 0.03 * WEIGHT) << throttle;
    }
    EXPECT_GT(takeOff, 5);
    EXPECT_LT(takeOff, 12);
    EXPECT_GT(bay.boat.getSpeed(), 14);
    EXPECT_LT(swingOfTrim(bay, 5), 0.05);
}

TEST(Hydrofoil, NeverFliesAwayOverWavesAtFullThrottle) {
    // The highest that level foils can carry the keel, plus the height of the waves, plus what a leap off a
    // crest adds.
    const real cruising = Motorboat::KEEL - Motorboat::FOIL_Y;
    for (const real waves : {0.3, 0.6})
        for (const real direction : {0.0, cyclone::REAL_PI / 2, cyclone::REAL_PI}) {
            Bay bay(Hull::FOILS, waves, direction);
            bay.boat.setThrottle(1);
            bay.keepCourse(15);
            real highest = -10, steepest = 0;
            for (int n = 0; n < 30 * 120; ++n) {
                bay.keepCourse(STEP / 2);
                highest =
                    std::max(highest, bay.body().getPointInWorldSpace(Vector3(0, Motorboat::KEEL, 0)).y);
                steepest = std::max(steepest, std::fabs(bay.trim()));
            }
            EXPECT_LT(highest, cruising + waves) << waves << ' ' << direction;
            EXPECT_LT(steepest, 15);
            EXPECT_FALSE(bay.boat.isCapsized());
            EXPECT_GT(bay.boat.getSpeed(), 8) << waves << ' ' << direction;
        }
}

TEST(Motorboat, LeavesTheWorldAsItWas) {
    cyclone::World world;
    const cyclone::Waves calm;
    { const Motorboat boat(world, nullptr, &calm, Hull::FOILS); }
    EXPECT_TRUE(world.getBodies().empty());
    EXPECT_EQ(world.getForceRegistry().size(), 0u);
}

}  // namespace
