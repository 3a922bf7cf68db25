// Laps that are recorded, replayed, written and read.
#include "airrace/lap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace airrace;
using cyclone::Quaternion;
using cyclone::Vector3;

namespace {

const std::vector<std::string> NAMES = {"bullet", "gnat", "swallow"};
constexpr real STEP = 1.0 / 60;

/// Straight on at 60 m/s, rolling at 1 rad/s.
Pose poseAt(real time) { return {Vector3(60 * time, 50, 0), Quaternion::fromAxisAngle(Vector3::X, time)}; }

/// A lap of that flight, from startTime on.
Lap record(real startTime, real lapTime) {
    LapRecorder recorder;
    for (int n = 1;; ++n) {
        const real time = n * STEP;
        if (time - STEP <= startTime && startTime < time) recorder.start(startTime);
        if (time >= startTime + lapTime)
            return recorder.finish(lapTime, poseAt(time - STEP), poseAt(time), time, STEP);
        if (time > startTime) recorder.add(poseAt(time - STEP), poseAt(time), time, STEP);
    }
}

void expectNear(const Pose &pose, const Pose &expected, real tolerance) {
    EXPECT_NEAR((pose.position - expected.position).magnitude(), 0, tolerance);
    const Quaternion &a = pose.orientation, &b = expected.orientation;
    EXPECT_NEAR(std::abs(a.r * b.r + a.i * b.i + a.j * b.j + a.k * b.k), 1, tolerance);
}

std::string errorOf(const std::string &text) {
    try {
        BestLaps::read(text, NAMES);
    } catch (const std::runtime_error &mistake) {
        return mistake.what();
    }
    return "";
}

}  // namespace

TEST(DemoLap, ReplaysWhatWasFlown) {
    for (const real startTime : {0.0131, 0.5, 1.017})
        for (const real lapTime : {0.004, 0.1, 3.0, 7.3456}) {
            const Lap lap = record(startTime, lapTime);
            ASSERT_EQ(lap.poses.size(), lap.countPoses());
            for (real share = 0; share <= 1; share += 0.013)
                expectNear(lap.getPose(share * lapTime), poseAt(startTime + share * lapTime), 1e-6);
            expectNear(lap.getPose(lapTime + 5), poseAt(startTime + lapTime), 1e-6);
        }
}

TEST(DemoBestLaps, GoRoundThroughTheirText) {
    BestLaps best;
    best.set("gnat", record(0.5, 12.345678901234567));
    best.set("bullet", record(0.2, 3));
    const std::string text = best.getText();
    const BestLaps again = BestLaps::read(text, NAMES);
    EXPECT_TRUE(again.getText() == text) << "to the last digit";
    ASSERT_TRUE(again.find("gnat"));
    EXPECT_EQ(again.find("gnat")->time, 12.345678901234567) << "to the last bit";
    expectNear(again.find("gnat")->getPose(6), best.find("gnat")->getPose(6), 0.02);
    EXPECT_FALSE(again.find("swallow"));
}

TEST(DemoBestLaps, NoTextHasNoLaps) {
    EXPECT_FALSE(BestLaps::read("", NAMES).find("gnat"));
    EXPECT_FALSE(BestLaps::read("# nothing yet\r\n\r\n", NAMES).find("gnat"));
}

TEST(DemoBestLaps, BadTextIsRefusedWithTheLineAndTheReason) {
    const std::string pose = "at 0 50 0 1 0 0 0\n", lap = "aircraft gnat\nlap 0.05\n";
    ASSERT_EQ(errorOf(lap + pose + pose), "");
    EXPECT_EQ(errorOf("hello\n"), "line 1: expected 'aircraft'");
    EXPECT_EQ(errorOf("lap 3\n"), "line 1: expected 'aircraft'");
    EXPECT_EQ(errorOf("aircraft zeppelin\n"), "line 1: there is no such aircraft");
    EXPECT_EQ(errorOf("aircraft gnat\nlap fast\n"), "line 2: 'fast' is not a number");
    EXPECT_EQ(errorOf("aircraft gnat\nlap -1\n"), "line 2: '-1' is not a lap's time");
    EXPECT_EQ(errorOf("aircraft gnat\nlap 1e300\n"), "line 2: '1e300' is not a lap's time");
    EXPECT_EQ(errorOf("aircraft gnat\nlap nan\n"), "line 2: 'nan' is not a number");
    EXPECT_EQ(errorOf("aircraft gnat\n"), "line 1: the lap of the gnat has no time");
    EXPECT_EQ(errorOf("aircraft gnat\naircraft bullet\n"), "line 2: the lap of the gnat has no time");
    EXPECT_EQ(errorOf(lap + pose), "line 3: the lap of the gnat has 1 places, and its time asks for 2");
    EXPECT_EQ(errorOf(lap + "at 0 50 0 1 0 0\n"), "line 3: expected 'at' and seven numbers");
    EXPECT_EQ(errorOf(lap + "at 0 50 0 1 1 0 0\n"), "line 3: the last four numbers are not an orientation");
    EXPECT_EQ(errorOf(lap + pose + pose + "wind 3\n"), "line 5: 'wind' is none of aircraft, lap, at");
    EXPECT_EQ(errorOf(lap + pose + pose + lap), "line 5: the gnat is there twice");
}
