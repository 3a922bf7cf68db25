// The race: the pilot's laps, the ghost, crashes, and the file of best laps.
#include "airrace/race.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "base/files.h"
#include "base/random.h"
#include "shell/loop.h"

using namespace airrace;

namespace {

void flyUntil(Race &race, std::size_t laps) {
    while (race.getLaps().size() < laps && race.getWreck().empty() && race.getTime() < 200) {
        race.steer();
        race.step();
    }
}

void holdFor(Race &race, real bank, real climb, real throttle, real seconds) {
    race.setControl(Race::BANK, bank);
    race.setControl(Race::CLIMB, climb);
    race.setControl(Race::THROTTLE, throttle);
    for (const real end = race.getTime() + seconds; race.getTime() < end && race.getWreck().empty();)
        race.step();
}

bool wasTold(const std::vector<Event> &events, const std::string &part) {
    return std::any_of(events.begin(), events.end(),
                       [&](const Event &event) { return event.text.find(part) != std::string::npos; });
}

class DemoAirRaceWith : public testing::TestWithParam<std::string> {};

std::string nameOf(const testing::TestParamInfo<std::string> &test) { return test.param; }

}  // namespace

TEST_P(DemoAirRaceWith, ThePilotFliesCleanLapsWithEverySeed) {
    Race race(GetParam());
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        race.begin(seed);
        flyUntil(race, 2);
        EXPECT_EQ(race.getLaps().size(), 2u) << seed;
        EXPECT_EQ(race.getMarshal().getMissed(), 0u) << seed;
        EXPECT_EQ(race.getWreck(), "") << seed;
        for (const real lap : race.getLaps()) EXPECT_LT(lap, 60) << seed;
    }
}

TEST_P(DemoAirRaceWith, ThePilotFindsHisWayFromAnywhere) {
    Race race(GetParam());
    demo::Random random(11);
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        race.begin(seed);
        RigidBody &body = race.getAircraft().getBody();
        const real x = random.between(-400, 400), y = random.between(50, 120), z = random.between(-400, 400),
                   turn = random.between(-3, 3), bank = random.between(-1, 1);
        body.setPosition(x, y, z);
        body.setOrientation(Quaternion::fromAxisAngle(Vector3::Y, turn) *
                            Quaternion::fromAxisAngle(Vector3::X, bank));
        body.setVelocity(body.getTransform().getAxisVector(0) * 65);
        flyUntil(race, 1);
        EXPECT_EQ(race.getLaps().size(), 1u) << seed;
    }
}

TEST_P(DemoAirRaceWith, TheGhostFliesTheBestLapAgain) {
    Race race(GetParam());
    race.begin(4);
    std::vector<Vector3> flown;  // in the first lap, step by step
    real lapStart = 0;
    while (race.getLaps().empty()) {
        race.steer();
        race.step();
        EXPECT_FALSE(race.getGhost() && race.getLaps().empty());
        if (race.getMarshal().getLapStart() && race.getLaps().empty()) {
            lapStart = *race.getMarshal().getLapStart();
            flown.push_back(race.getAircraft().getBody().getPosition());
        }
    }
    ASSERT_EQ(race.getBestLap()->time, race.getLaps()[0]);
    // The ghost's clock runs from the crossing, so its places are those of the first lap between two steps.
    const real step = race.getProfile().step, first = *race.getMarshal().getLapStart();
    const real offset = std::ceil(lapStart / step) * step - lapStart;  // of flown[0] after the start
    for (int n = 0; n < 2400; ++n) {
        race.steer();
        race.step();
        const real at = (race.getTime() - first - offset) / step;
        const auto index = static_cast<std::size_t>(at);
        const Vector3 expected = mix(flown[index], flown[index + 1], at - static_cast<real>(index));
        ASSERT_TRUE(race.getGhost());
        EXPECT_NEAR((race.getGhost()->position - expected).magnitude(), 0, 0.06) << n;
    }
    flyUntil(race, 2);
    EXPECT_EQ(race.getBestLap()->time, std::min(race.getLaps()[0], race.getLaps()[1]));
}

TEST_P(DemoAirRaceWith, TheSameSeedGivesTheSameBits) {
    Race one(GetParam()), other(GetParam());
    other.begin(9);
    flyUntil(other, 1);  // what was flown before doesn't matter
    for (Race *race : {&one, &other}) {
        race->begin(2);
        flyUntil(*race, 1);
    }
    EXPECT_EQ(one.getHash(), other.getHash());
    EXPECT_EQ(one.getLaps(), other.getLaps());
    EXPECT_EQ(one.getSummary(), other.getSummary());
    one.begin(3);
    flyUntil(one, 1);
    EXPECT_NE(one.getLaps(), other.getLaps());
}

INSTANTIATE_TEST_SUITE_P(Aircraft, DemoAirRaceWith, testing::ValuesIn(Aircraft::NAMES), nameOf);

TEST(DemoAirRace, StraightOnInStillAirTheClockIsThatOfTheFlight) {
    Race race("bullet");
    race.begin(1, {0, 0, 0});
    // 250 m to the first hoop; what is flown there is integrated here by the trapezoidal rule.
    real way = 0, speed = race.getAircraft().getBody().getVelocity().x;
    while (!race.getMarshal().getLapStart()) {
        race.step();
        const real now = race.getAircraft().getBody().getVelocity().x;
        way += (speed + now) / 2 * race.getProfile().step;
        speed = now;
    }
    EXPECT_NEAR(*race.getMarshal().getLapStart(), race.getTime() - (way - 250) / speed, 1e-4);
}

TEST(DemoAirRace, ACrashIsSaidWithItsReasonAndTheWreckStays) {
    Race race("gnat");
    holdFor(race, 0, -30, 1, 10);
    EXPECT_EQ(race.getWreck().rfind("crashed: flew into the ground at ", 0), 0u) << race.getWreck();
    EXPECT_TRUE(wasTold(race.takeEvents(), race.getWreck()));
    const Vector3 wreck = race.getAircraft().getBody().getPosition();
    race.setControl(Race::CLIMB, 30);
    for (int n = 0; n < 180; ++n) race.step();
    EXPECT_EQ(race.getAircraft().getBody().getPosition(), wreck) << "it lies where it fell";
    EXPECT_NE(race.getSummary().find("Crashes: 1"), std::string::npos);
    race.startOver();
    EXPECT_EQ(race.getWreck(), "");
    flyUntil(race, 1);
    EXPECT_EQ(race.getLaps().size(), 1u);
}

TEST(DemoAirRace, AStallIsSaidAndSoIsTheFallThatFollows) {
    Race race("swallow");
    race.begin(1, {0, 0, 0});
    holdFor(race, 80, 10, 0, 60);
    ASSERT_FALSE(race.getWreck().empty());
    const std::vector<Event> events = race.takeEvents();
    EXPECT_TRUE(wasTold(events, "stalled: less bank"));
    EXPECT_TRUE(wasTold(events, "crashed: stalled, and fell to the ground"));
}

TEST(DemoAirRace, TheNextHoopIsMarkedAndPointedAt) {
    Race race("gnat");
    race.begin(1, {0, 0, 0});
    const std::string line = race.getHeadUpLine();
    EXPECT_EQ(line.rfind("HOOP 1/11 250m 0 +0  LAP -  BEST -  BANK +0", 0), 0u) << line;
    const Frame before = race.getFrame();
    EXPECT_EQ(before.poses[2].position, getCourse()[0].centre);
    while (race.getMarshal().getPassed() == 0) race.step();
    const Frame after = race.getFrame();
    EXPECT_EQ(after.poses[2].position, getCourse()[1].centre);
    EXPECT_EQ(after.poses[3].position, getCourse()[2].centre);
    const Vector3 pointed = after.poses[1].orientation.rotate(Vector3::X);
    EXPECT_NEAR(pointed * (getCourse()[1].centre - after.poses[1].position).unit(), 1, 1e-9);
    EXPECT_EQ(after.poses.size(), countParts(race.getScene()));
}

TEST(DemoAirRace, TheHeadUpLineFitsEightyColumnsUpToTheSpeed) {
    Race race("bullet");
    flyUntil(race, 1);
    for (int n = 0; n < 1200; ++n) {
        race.steer();
        race.step();
        EXPECT_LE(race.getHeadUpLine().find("  SPD"), 72u) << race.getHeadUpLine();
    }
}

// ---- The file of best laps

namespace {

class DemoAirRaceFile : public testing::Test {
protected:
    std::string path = testing::TempDir() + "cyclone_airrace_" +
                       testing::UnitTest::GetInstance()->current_test_info()->name() + ".txt";
    void SetUp() override { std::remove(path.c_str()); }
    void TearDown() override { std::remove(path.c_str()); }

    struct Outcome {
        int status;
        std::string out, err;
    };
    Outcome run(std::vector<const char *> arguments, const std::string &aircraft = "gnat") {
        Race race(aircraft);
        arguments.insert(arguments.begin(), "airrace");
        arguments.insert(arguments.end(), {"--best", path.c_str()});
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int status = runDemonstration(race, static_cast<int>(arguments.size()), arguments.data());
        return {status, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
    }
};

}  // namespace

TEST_F(DemoAirRaceFile, KeepsTheBestLapOfEachAircraftAndIsWrittenOnlyForABetterOne) {
    EXPECT_EQ(run({"--seconds", "20"}).status, 0);
    EXPECT_FALSE(std::ifstream(path)) << "no lap, no file";
    EXPECT_EQ(run({"--seconds", "70", "--seed", "1"}).status, 0);
    const std::string first = readFile(path);
    EXPECT_EQ(run({"--seconds", "70"}, "bullet").status, 0);
    const BestLaps both = BestLaps::read(readFile(path), Aircraft::NAMES);
    ASSERT_TRUE(both.find("gnat") && both.find("bullet"));
    EXPECT_EQ(both.find("gnat")->time, BestLaps::read(first, Aircraft::NAMES).find("gnat")->time);

    // The same flight again is no better.
    std::ofstream(path, std::ios::binary) << first << "# mine\n";
    EXPECT_EQ(run({"--seconds", "70", "--seed", "1"}).status, 0);
    EXPECT_EQ(readFile(path), first + "# mine\n");
    EXPECT_FALSE(std::ifstream(path + ".new"));
}

TEST_F(DemoAirRaceFile, TheGhostIsThereFromTheFirstLapOn) {
    ASSERT_EQ(run({"--seconds", "70"}).status, 0);
    Race race("gnat");
    race.getProfile().archive.read(readFile(path));
    race.begin(1);
    EXPECT_FALSE(race.getGhost()) << "it waits for the start";
    while (!race.getMarshal().getLapStart()) race.step();
    ASSERT_TRUE(race.getGhost());
    EXPECT_NEAR((race.getGhost()->position - race.getAircraft().getBody().getPosition()).magnitude(), 0, 30)
        << "both fit through the hoop";
    EXPECT_FALSE(race.getProfile().archive.write()) << "nothing better yet";
}

TEST_F(DemoAirRaceFile, ABadFileIsRefusedBeforeTheRunAndStays) {
    std::ofstream(path) << "aircraft gnat\nlap soon\n";
    const Outcome outcome = run({"--seconds", "1"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "airrace: '" + path + "', line 2: 'soon' is not a number\n");
    EXPECT_EQ(readFile(path), "aircraft gnat\nlap soon\n");
    EXPECT_FALSE(std::ifstream(path + ".new"));
}

TEST_F(DemoAirRaceFile, IsNoneOfTheOtherFiles) {
    const std::string spelled = testing::TempDir() + "./" + path.substr(testing::TempDir().size());
    for (const char *option : {"--csv", "--html", "--record", "--still"}) {
        const Outcome outcome = run({"--seconds", "1", option, spelled.c_str()});
        EXPECT_EQ(outcome.status, 2) << option;
        EXPECT_NE(outcome.err.find("one file"), std::string::npos) << outcome.err;
        EXPECT_FALSE(std::ifstream(path)) << option;
    }
}
