// The race: waves, jumps, the log, the course, and its pilot.
#include "speedboat/race.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace speedboat;

namespace {

constexpr real G = 9.81;
const std::vector<real> CALM = {0, 0, 0}, ROUGH = {5, 1, 0.8};

/// With the pilot, until he is round or the time is over.
void drive(Race &race, real seconds = 240) {
    while (!race.isOver() && race.getTime() < seconds) {
        race.steer();
        race.step();
    }
}

/// The sum of the scene's sine waves, at a place and time.
real seaHeight(const Race &race, const Vector3 &place) {
    real height = 0;
    for (const cyclone::Waves::Train &train : race.getScene().surroundings.waves) {
        const real k = 2 * cyclone::REAL_PI / train.wavelength;
        const real along = place.x * std::cos(train.direction) + place.z * std::sin(train.direction);
        height += train.amplitude * std::sin(k * along - std::sqrt(G * k) * race.getTime() + train.phase);
    }
    return height;
}

TEST(SpeedboatRace, FitsItsProfile) {
    for (const Hull hull : {Hull::PLANING, Hull::FOILS}) {
        Race race(hull);
        const demo::Frame frame = race.getFrame();
        EXPECT_EQ(frame.poses.size(), demo::countParts(race.getScene()));
        EXPECT_TRUE(frame.cut);
        race.step();
        EXPECT_FALSE(race.getFrame().cut);
        EXPECT_EQ(race.getFrame().arrows.size(), frame.arrows.size());
        for (const demo::Setting &setting : race.getProfile().settings) {
            EXPECT_LE(setting.low, setting.value);
            EXPECT_GE(setting.high, setting.value);
        }
    }
}

TEST(SpeedboatRace, TheSameSeedGivesTheSameRunAndAnotherAnother) {
    std::set<std::uint64_t> hashes;
    for (const std::uint64_t seed : {7u, 7u, 8u}) {
        Race race(Hull::PLANING);
        race.begin(seed);
        drive(race, 10);
        hashes.insert(race.getHash());
    }
    EXPECT_EQ(hashes.size(), 2u);
}

TEST(SpeedboatRace, FortySeedsAreAllDrivenRoundWithBothHulls) {
    for (const Hull hull : {Hull::PLANING, Hull::FOILS})
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            Race race(hull);
            race.begin(seed);
            drive(race);
            EXPECT_EQ(race.getCourse().getLaps(), 1u) << race.getProfile().variant << ", seed " << seed;
            EXPECT_EQ(race.getLog().capsizes, 0u) << race.getProfile().variant << ", seed " << seed;
            EXPECT_LT(race.getCourse().getBestLap(), 100) << race.getProfile().variant << ", seed " << seed;
        }
}

TEST(SpeedboatRace, JumpsOverWavesAndLogsThemAndHowLongTheScrewWasDry) {
    Race race(Hull::PLANING);
    race.begin(3, ROUGH);
    const RigidBody &body = race.getBoat().getBody();
    const real step = race.getProfile().step;
    real timeDry = 0, airborne = 0;
    unsigned jumps = 0;
    while (!race.isOver() && race.getTime() < 240) {
        const real sinking = body.getVelocity().y;
        const bool wasAirborne = race.getBoat().isAirborne(), wasDry = race.getBoat().isScrewDry();
        race.steer();
        race.step();
        const Vector3 hub = body.getPointInWorldSpace(race.getBoat().getScrew());
        if (hub.y - Motorboat::SCREW_RADIUS >= seaHeight(race, hub)) timeDry += step;
        const bool isAirborne = race.getBoat().isAirborne();
        if (wasAirborne && wasDry && isAirborne && race.getBoat().isScrewDry()) {
            // Nothing but gravity and the air, to which it is heavy.
            ASSERT_NEAR((body.getVelocity().y - sinking) / step, -G, 0.5) << race.getTime();
            ASSERT_EQ(race.getBoat().getThrust(), Vector3());
        }
        airborne += isAirborne ? step : 0;
        if (isAirborne) continue;
        jumps += airborne >= Race::SHORTEST_JUMP;
        airborne = 0;
    }
    EXPECT_EQ(race.getCourse().getLaps(), 1u);
    EXPECT_GT(race.getLog().jumps, 3u);
    EXPECT_EQ(race.getLog().jumps, jumps);
    EXPECT_GT(race.getLog().timeDry, 0.1);
    EXPECT_NEAR(race.getLog().timeDry, timeDry, 1e-9);
}

TEST(SpeedboatRace, OnACalmSeaNothingJumpsAndTheScrewStaysWet) {
    Race race(Hull::PLANING);
    race.begin(1, CALM);
    drive(race);
    EXPECT_EQ(race.getCourse().getLaps(), 1u);
    EXPECT_EQ(race.getLog().jumps, 0u);
    EXPECT_EQ(race.getLog().timeDry, 0);
    EXPECT_GT(race.getLog().topSpeed, 12);
}

TEST(SpeedboatRace, TheLineSaysThatTheScrewIsDry) {
    Race race(Hull::PLANING);
    race.begin(1, CALM);
    EXPECT_EQ(race.getHeadUpLine().find("DRY"), std::string::npos);
    race.getBoat().getBody().setPosition(0, 3, 0);
    race.step();
    race.step();
    EXPECT_EQ(race.getHeadUpLine().find("SCREW DRY"), 0u);
}

TEST(SpeedboatRace, TheLineSaysWhichBuoyIsNextAndWhere) {
    Race race(Hull::PLANING);
    EXPECT_NE(race.getHeadUpLine().find("BUOY 1 70m 0 to port"), std::string::npos) << race.getHeadUpLine();
}

TEST(SpeedboatRace, CapsizingIsSaidAndEndsTheRunUntilItStartsOver) {
    Race race(Hull::PLANING);
    race.begin(1, CALM);
    race.setControl(Race::THROTTLE, 1);
    race.getBoat().getBody().setOrientation(Quaternion(0, 1, 0, 0));  // upside down
    race.step();
    EXPECT_EQ(race.getWreck(), "capsized at 0.0 m/s");
    const std::vector<demo::Event> events = race.takeEvents();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].text, race.getWreck());
    const Vector3 place = race.getBoat().getBody().getPosition();
    for (int n = 0; n < 4 * 120; ++n) race.step();
    EXPECT_EQ(race.getBoat().getThrottle(), 0) << "the motor has drowned";
    EXPECT_NE(race.getBoat().getBody().getPosition(), place) << "it floats";
    EXPECT_FALSE(race.isOver()) << "there is no lap";
    EXPECT_TRUE(race.takeEvents().empty()) << "said once";
    EXPECT_NE(race.getSummary().find("Capsizes: 1"), std::string::npos);

    race.startOver();
    EXPECT_EQ(race.getWreck(), "");
    race.setControl(Race::THROTTLE, 1);
    race.step();
    EXPECT_EQ(race.getBoat().getThrottle(), 1);
    EXPECT_FALSE(race.getBoat().isCapsized());
}

TEST(SpeedboatRace, AMissedBuoyIsSaidAndMustBePassedAfterAll) {
    Race race(Hull::PLANING);
    race.begin(1, CALM);
    RigidBody &body = race.getBoat().getBody();
    const real y = body.getPosition().y;
    const auto go = [&](real z) {
        body.setPosition(69.9, y, z);
        body.setVelocity(24, 0, 0);
        race.step();
    };
    go(-5);
    std::vector<demo::Event> events = race.takeEvents();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].text, "missed buoy 1: go round and leave it to port");
    go(5);
    events = race.takeEvents();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].text, "passed buoy 1");
}

TEST(SpeedboatRace, TheSummaryTellsLapSpeedJumpsAndTimeDry) {
    Race race(Hull::FOILS);
    race.begin(2, CALM);
    drive(race);
    const std::string summary = race.getSummary();
    for (const char *part :
         {"Course: 1 lap, the best in ", "m/s at most", "Jumps: 0", "Screw dry: 0.00 s", "Capsizes: 0"})
        EXPECT_NE(summary.find(part), std::string::npos) << part << "\n" << summary;
}

}  // namespace
