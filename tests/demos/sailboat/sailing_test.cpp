#include "sailboat/sailing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace {

using cyclone::real;
using cyclone::Vector3;
using sailboat::Sailing;

constexpr real DEGREE = cyclone::REAL_PI / 180;
const std::vector<real> CALM = {6, 0, 0}, FRESH = {6, 0.8, 0.3};

void run(Sailing &sailing, real seconds, bool withPilot = true) {
    for (const real end = sailing.getTime() + seconds; sailing.getTime() < end;) {
        if (withPilot) sailing.steer();
        sailing.step();
    }
}

std::uint64_t hashAfter(std::uint64_t seed, real seconds) {
    Sailing sailing;
    sailing.begin(seed, FRESH);
    run(sailing, seconds);
    return sailing.getHash();
}

std::multiset<std::string> eventsOf(Sailing &sailing) {
    std::multiset<std::string> texts;
    for (const demo::Event &event : sailing.takeEvents()) texts.insert(event.text);
    return texts;
}

TEST(Sailing, FitsItsProfile) {
    Sailing sailing;
    const demo::Profile &profile = sailing.getProfile();
    const demo::Frame frame = sailing.getFrame();
    EXPECT_EQ(frame.poses.size(), demo::countParts(sailing.getScene()));
    EXPECT_TRUE(frame.cut);
    EXPECT_TRUE(sailing.getFrame().cut);  // the same moment, told twice
    sailing.step();
    EXPECT_FALSE(sailing.getFrame().cut);
    for (const demo::Setting &setting : profile.settings) {
        EXPECT_LE(setting.low, setting.value);
        EXPECT_GE(setting.high, setting.value);
    }
}

TEST(Sailing, PartsAreConvexAndFlat) {
    const Sailing sailing;
    std::vector<demo::Part> parts;
    for (const demo::Body &body : sailing.getScene().bodies)
        parts.insert(parts.end(), body.parts.begin(), body.parts.end());
    for (const demo::Part &part : parts)
        for (const demo::Face &face : part.faces) {
            const std::size_t count = face.corners.size();
            ASSERT_GE(count, 3u) << part.name;
            Vector3 area;
            for (std::size_t n = 0; n < count; ++n)
                area +=
                    (face.corners[n] - face.corners[0]) % (face.corners[(n + 1) % count] - face.corners[0]);
            ASSERT_GT(area.magnitude(), 1e-6) << part.name;
            const Vector3 normal = area.unit();
            for (std::size_t n = 0; n < count; ++n) {
                const Vector3 a = face.corners[n], b = face.corners[(n + 1) % count],
                              c = face.corners[(n + 2) % count];
                EXPECT_GT(((b - a) % (c - b)) * normal, -1e-9) << part.name;
                EXPECT_NEAR((a - face.corners[0]) * normal, 0, 1e-9) << part.name;
            }
        }
}

TEST(Sailing, TheSameSeedGivesTheSameRunAndAnotherAnother) {
    const std::uint64_t hash = hashAfter(7, 20);
    EXPECT_EQ(hashAfter(7, 20), hash);
    EXPECT_NE(hashAfter(8, 20), hash);
    // Begun again, a used one is as good as new.
    Sailing used;
    used.begin(8, {10, 2, 1});
    run(used, 20);
    used.begin(7, FRESH);
    run(used, 20);
    EXPECT_EQ(used.getHash(), hash);
}

TEST(Sailing, ARunCanBePlayedAgainFromItsControls) {
    Sailing piloted;
    piloted.begin(3, FRESH);
    Sailing played;
    played.begin(3, FRESH);
    while (piloted.getTime() < 30) {
        piloted.steer();
        for (std::size_t n = 0; n < 3; ++n) played.setControl(n, piloted.getControl(n));
        piloted.step();
        played.step();
    }
    EXPECT_EQ(piloted.getHash(), played.getHash());
}

TEST(Sailing, TheSkipperSailsRoundTheMarks) {
    for (const std::vector<real> &weather : {CALM, FRESH, {8, 1, 0.5}}) {
        Sailing sailing;
        sailing.begin(1, weather);
        while (!sailing.isOver() && sailing.getTime() < 240) run(sailing, 1);
        EXPECT_TRUE(sailing.isOver());
        const std::multiset<std::string> events = eventsOf(sailing);
        for (const char *mark : {"windward", "wing", "leeward"})
            EXPECT_EQ(events.count(std::string("rounded the ") + mark + " mark"), 1u);
        EXPECT_GE(events.count("tacked"), 1u);  // the windward mark lies too close to the wind to be laid
        EXPECT_EQ(events.count("gybed"), 1u);
        EXPECT_EQ(events.count("capsized"), 0u);
    }
}

TEST(Sailing, ACapsizedBoatIsRightedWhereSheLies) {
    Sailing sailing;
    sailing.begin(1, {15, 0, 0});
    sailing.setControl(Sailing::RUDDER, -35);  // bears away, with the sail hauled in hard
    sailing.setControl(Sailing::SHEET, 0);
    real mostHeel = 0;
    std::multiset<std::string> events;
    while (events.count("capsized") == 0 && sailing.getTime() < 60) {
        sailing.step();
        mostHeel = std::max(mostHeel, std::fabs(sailing.getBoat().getHeel()));
        events.merge(eventsOf(sailing));
    }
    ASSERT_EQ(events.count("capsized"), 1u);
    EXPECT_GT(mostHeel, 90 * DEGREE);
    sailing.getFrame();
    Vector3 before;
    while (events.count("righted") == 0 && sailing.getTime() < 80) {
        before = sailing.getBoat().getBody().getPosition();
        sailing.step();
        events.merge(eventsOf(sailing));
    }
    EXPECT_EQ(events.count("righted"), 1u);
    EXPECT_TRUE(sailing.getFrame().cut);
    EXPECT_NEAR(sailing.getBoat().getHeel(), 0, 1e-9);
    const Vector3 after = sailing.getBoat().getBody().getPosition();
    EXPECT_NEAR(Vector3(after.x - before.x, 0, after.z - before.z).magnitude(), 0, 0.2);
}

TEST(Sailing, StartsOverWithTheWeatherGoingOn) {
    Sailing sailing;
    sailing.begin(2, FRESH);
    const Vector3 start = sailing.getFrame().poses[0].position;
    run(sailing, 15);
    const real time = sailing.getTime();
    const Vector3 wind = sailing.getFrame().windspeed;
    sailing.startOver();
    const demo::Frame frame = sailing.getFrame();
    EXPECT_EQ(sailing.getTime(), time);
    EXPECT_EQ(frame.windspeed, wind);
    EXPECT_TRUE(frame.cut);
    EXPECT_EQ(frame.poses[0].position.x, start.x);
    EXPECT_EQ(frame.poses[0].position.z, start.z);
    EXPECT_EQ(sailing.getControl(0), 0);
    EXPECT_EQ(sailing.getControl(1), sailing.getProfile().controls[1].neutral);
}

TEST(Sailing, DrawsTheSeaThatTheBoatFloatsOn) {
    Sailing sailing;
    sailing.begin(2, {6, 0, 1});
    run(sailing, 10);
    const auto &waves = sailing.getScene().surroundings.waves;
    ASSERT_FALSE(waves.empty());
    // The marks float on the waves that the scene tells of.
    const demo::Frame frame = sailing.getFrame();
    for (std::size_t n = 3; n < frame.poses.size(); ++n) {
        const Vector3 mark = frame.poses[n].position;
        real height = 0;
        for (const cyclone::Waves::Train &wave : waves) {
            const real k = 2 * cyclone::REAL_PI / wave.wavelength;
            const real along = mark.x * std::cos(wave.direction) + mark.z * std::sin(wave.direction);
            height += wave.amplitude * std::sin(k * along - std::sqrt(9.81 * k) * frame.time + wave.phase);
        }
        EXPECT_NEAR(mark.y, height, 1e-9);
    }
    sailing.begin(2, CALM);
    EXPECT_TRUE(sailing.getScene().surroundings.waves.empty());
}

TEST(Sailing, TellsThePointOfSail) {
    EXPECT_STREQ(sailboat::pointOfSail(5 * DEGREE), "head to wind");
    EXPECT_STREQ(sailboat::pointOfSail(-35 * DEGREE), "close hauled");
    EXPECT_STREQ(sailboat::pointOfSail(60 * DEGREE), "close reach");
    EXPECT_STREQ(sailboat::pointOfSail(90 * DEGREE), "beam reach");
    EXPECT_STREQ(sailboat::pointOfSail(-135 * DEGREE), "broad reach");
    EXPECT_STREQ(sailboat::pointOfSail(180 * DEGREE), "running");
}

TEST(Sailing, TellsTheTrimFromTheWindsAngleOnTheSail) {
    // At 60° off the bow the wind wants the boom at 30°.
    for (const real side : {-1, 1}) {
        const auto hint = [&](real boom) {
            return sailboat::trimHint(side * 60 * DEGREE, -side * boom * DEGREE);
        };
        EXPECT_STREQ(hint(0), "ease");
        EXPECT_STREQ(hint(20), "ease");
        EXPECT_STREQ(hint(28), "well trimmed");
        EXPECT_STREQ(hint(32), "well trimmed");
        EXPECT_STREQ(hint(40), "sheet in");
        EXPECT_STREQ(hint(60), "sheet in");
        EXPECT_STREQ(sailboat::trimHint(side * 10 * DEGREE, 0), "fall off");
    }
}

TEST(Sailing, FollowingTheHintsMakesHerGo) {
    for (const real sheet : {0, 86}) {
        Sailing sailing;
        sailing.begin(1, CALM);
        sailing.setControl(Sailing::SHEET, sheet);
        for (int n = 0; n < 40; ++n) {
            run(sailing, 0.5, false);
            const std::string line = sailing.getHeadUpLine();
            const real change = line.find(" ease") != std::string::npos       ? 4
                                : line.find(" sheet in") != std::string::npos ? -4
                                                                              : 0;
            sailing.setControl(Sailing::SHEET, sailing.getControl(Sailing::SHEET) + change);
        }
        EXPECT_NE(sailing.getHeadUpLine().find("well trimmed"), std::string::npos);
        EXPECT_GT(sailing.getBoat().getSpeed(), 3);
    }
}

TEST(Sailing, SaysWhenSheIsInIronsAndTheAdviceGetsHerOut) {
    Sailing sailing;
    sailing.begin(1, CALM);
    sailing.setControl(Sailing::RUDDER, 35);  // luffs up, and stops head to wind
    while (!sailing.getBoat().isInIrons() && sailing.getTime() < 30) run(sailing, 0.1, false);
    ASSERT_TRUE(sailing.getBoat().isInIrons());
    const std::string line = sailing.getHeadUpLine();
    ASSERT_NE(line.find("in irons: boom to "), std::string::npos) << line;
    const real side = line.find("boom to port") != std::string::npos ? -1 : 1;
    EXPECT_NE(line.find(side < 0 ? "rudder to starboard" : "rudder to port"), std::string::npos) << line;
    sailing.setControl(Sailing::BOOM, side);
    sailing.setControl(Sailing::RUDDER, -side * 35);
    const real start = sailing.getTime();
    const auto isOff = [&] { return std::fabs(sailing.getBoat().getTrueWindAngle()) > 50 * DEGREE; };
    while (!isOff() && sailing.getTime() < start + 20) run(sailing, 0.1, false);
    EXPECT_TRUE(isOff());
    sailing.centreControls();
    run(sailing, 10, false);
    EXPECT_GT(sailing.getBoat().getSpeed(), 1);
    EXPECT_EQ(eventsOf(sailing).count("in irons"), 1u);
}

TEST(Sailing, PointsToTheNextMarkAndTimesTheLap) {
    Sailing sailing;
    sailing.begin(1, CALM);
    // From the origin, heading −1.2 rad, the windward mark lies at (85 m north, 5 m east): √(85² + 5²) = 85.1
    // m at 3.4° + 68.8° = 72.1° off the bow.
    EXPECT_NE(sailing.getHeadUpLine().find("  MARK 85m 72S"), std::string::npos) << sailing.getHeadUpLine();
    EXPECT_NE(sailing.getSummary().find("the windward mark is next"), std::string::npos);
    EXPECT_EQ(sailing.getFrame().poses.back().position, sailing.getFrame().poses[3].position);
    while (!sailing.isOver()) run(sailing, 0.5);
    EXPECT_EQ(sailing.getFrame().poses.back().position, demo::NOWHERE.position);
    EXPECT_EQ(sailing.getHeadUpLine().find("MARK"), std::string::npos);
    const std::string summary = sailing.getSummary();
    ASSERT_NE(summary.find("Course: 1 lap, the best in "), std::string::npos) << summary;
    run(sailing, 10);
    EXPECT_EQ(sailing.getSummary().substr(sailing.getSummary().find("Course")),
              summary.substr(summary.find("Course")));  // the clock has stopped
    sailing.startOver();
    EXPECT_NE(sailing.getHeadUpLine().find("LAP 0 "), std::string::npos);
}

TEST(Sailing, TheSummaryHasTheTablesMostHeel) {
    Sailing sailing;
    sailing.begin(1, {15, 0, 0});
    sailing.setControl(Sailing::RUDDER, -35);
    sailing.setControl(Sailing::SHEET, 0);
    real most = 0;
    while (sailing.getTime() < 40) {
        sailing.step();
        most = std::max(most, std::fabs(sailing.getBoat().getHeel()));
    }
    ASSERT_GT(most, 100 * DEGREE);
    const std::string told = "Heel: " + std::to_string(std::lround(most / DEGREE)) + "° at most";
    EXPECT_NE(sailing.getSummary().find(told), std::string::npos) << told << " in " << sailing.getSummary();
}

TEST(Sailing, TheMostImportantFitsEightyColumns) {
    Sailing sailing;
    sailing.begin(5, {12, 2, 1});
    for (int second = 0; second < 120; ++second) {
        run(sailing, 1);
        const std::string line = sailing.getHeadUpLine();
        if (sailing.getBoat().isCapsized()) continue;
        EXPECT_LE(line.find("  RUD"), 80u) << line;
        EXPECT_LE(line.size(), 120u) << line;
    }
}

TEST(Sailing, ShowsWhatABoatAtRestWouldShow) {
    Sailing sailing;
    sailing.begin(0, {0, 0, 0});
    run(sailing, 300, false);  // no wind, no pilot: she comes to rest
    const std::string line = sailing.getHeadUpLine();
    EXPECT_NE(line.find("RUD 0  LAP 300  HEEL 0"), std::string::npos) << line;
    EXPECT_NE(line.find("SPD 0.0"), std::string::npos) << line;
}

}  // namespace
