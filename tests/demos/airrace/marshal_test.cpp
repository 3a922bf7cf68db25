// Hoops cannot be cheated, and the clock is exact to the crossing.
#include "airrace/marshal.h"

#include <gtest/gtest.h>

#include "base/random.h"

using namespace airrace;

namespace {

constexpr real RADIUS = 10, CLEARANCE = 2, STEP = 1.0 / 60;

Hoop hoopAt(real x, const Vector3 &axis = Vector3::X) { return {Vector3(x, 0, 0), axis, RADIUS}; }

/// Three hoops along +X, 100 m apart.
const std::vector<Hoop> &threeInARow() {
    static const std::vector<Hoop> course = {hoopAt(0), hoopAt(100), hoopAt(200)};
    return course;
}

struct Race {
    Marshal marshal{threeInARow(), CLEARANCE};
    real time = 0;
    std::vector<real> laps;
    std::vector<std::string> reports;

    void step(const Vector3 &from, const Vector3 &to, real duration = STEP) {
        time += duration;
        if (const std::optional<real> lap = marshal.watch(from, to, time, duration)) laps.push_back(*lap);
        for (const std::string &report : marshal.takeReports()) reports.push_back(report);
    }

    /// Straight on at constant speed, in steps, for so many seconds.
    void fly(const Vector3 &start, const Vector3 &velocity, real seconds, real duration = STEP) {
        const int steps = static_cast<int>(seconds / duration);
        for (int n = 0; n < steps; ++n)
            step(start + velocity * (n * duration), start + velocity * ((n + 1) * duration), duration);
    }
};

}  // namespace

TEST(DemoMarshal, CountsHoopsFlownThroughInOrder) {
    Race race;
    race.fly(Vector3(-50, 1, 2), Vector3(60, 0, 0), 5);
    EXPECT_EQ(race.marshal.getPassed(), 3u);
    EXPECT_EQ(race.marshal.getNext(), 0u) << "round again";
    EXPECT_EQ(race.marshal.getMissed(), 0u);
    EXPECT_TRUE(race.reports.empty());
}

TEST(DemoMarshal, TheLapIsExactToTheCrossingAtAnySpeedAndStep) {
    for (const real speed : {11.3, 61.7, 333.0, 1000.0})
        for (const real duration : {1.0 / 30, 1.0 / 60, 1.0 / 120}) {
            Race race;
            // Twice along the row: from where it begins, the first hoop is 47.3 m and 62.9 m away.
            race.fly(Vector3(-47.3, 0, 0), Vector3(speed, 0, 0), 300 / speed, duration);
            const real secondRun = race.time;
            race.fly(Vector3(-62.9, 3, -1), Vector3(speed, 0, 0), 100 / speed, duration);
            ASSERT_EQ(race.laps.size(), 1u) << speed;
            EXPECT_NEAR(race.laps[0], secondRun + 62.9 / speed - 47.3 / speed, 1e-9) << speed;
            EXPECT_NEAR(*race.marshal.getLapStart(), secondRun + 62.9 / speed, 1e-9) << speed;
        }
}

TEST(DemoMarshal, NothingTunnelsThroughAtAThousandMetresPerSecond) {
    for (int n = 0; n < 17; ++n) {  // wherever the steps of 16.7 m fall
        Race through, beside;
        through.fly(Vector3(-60.0 - n, 0, 0), Vector3(1000, 0, 0), 0.35);
        EXPECT_EQ(through.marshal.getPassed(), 3u) << n;
        beside.fly(Vector3(-60.0 - n, 0, RADIUS + 1), Vector3(1000, 0, 0), 0.35);
        EXPECT_EQ(beside.marshal.getPassed(), 0u) << n;
        EXPECT_EQ(beside.marshal.getMissed(), 1u) << "the first; the others were not next";
    }
}

TEST(DemoMarshal, OneStepMayPassSeveralHoopsInOrderOnly) {
    Race forwards;
    forwards.step(Vector3(-50, 0, 0), Vector3(250, 0, 0), 3);
    EXPECT_EQ(forwards.marshal.getPassed(), 3u);
    EXPECT_NEAR(*forwards.marshal.getLapStart(), 0.5, 1e-12);

    const std::vector<Hoop> inReverse = {hoopAt(200), hoopAt(100), hoopAt(0)};
    Marshal marshal(inReverse, CLEARANCE);
    marshal.watch(Vector3(-50, 0, 0), Vector3(250, 0, 0), 3, 3);
    EXPECT_EQ(marshal.getPassed(), 1u) << "the second hoop was passed before the first";
    EXPECT_EQ(marshal.getNext(), 1u);
}

TEST(DemoMarshal, TheWholeAircraftMustFitThrough) {
    const real limit = RADIUS - CLEARANCE;
    for (const Vector3 &across : {Vector3(0, 1, 0), Vector3(0, 0, -1), Vector3(0, 0.6, 0.8)}) {
        Race inside, grazing, outside;
        inside.fly(Vector3(-50, 0, 0) + across * (limit - 1e-6), Vector3(60, 0, 0), 1.5);
        EXPECT_EQ(inside.marshal.getPassed(), 1u);
        grazing.fly(Vector3(-50, 0, 0) + across * (limit + 1e-6), Vector3(60, 0, 0), 1.5);
        EXPECT_EQ(grazing.marshal.getPassed(), 0u);
        ASSERT_EQ(grazing.reports.size(), 1u);
        EXPECT_EQ(grazing.reports[0], "clipped hoop 1: fly it again");
        outside.fly(Vector3(-50, 0, 0) + across * (RADIUS + 7), Vector3(60, 0, 0), 1.5);
        ASSERT_EQ(outside.reports.size(), 1u);
        EXPECT_EQ(outside.reports[0], "missed hoop 1 by 7 m: fly it again");
    }
}

TEST(DemoMarshal, TheOffsetIsWhereThePlaneIsCrossedNotWhereTheStepEnds) {
    const Crossing crossing = cross(hoopAt(0), Vector3(-10, 20, 0), Vector3(10, 0, 0));
    EXPECT_EQ(crossing.way, Crossing::Way::FORWARDS);
    EXPECT_DOUBLE_EQ(crossing.share, 0.5);
    EXPECT_DOUBLE_EQ(crossing.offset, 10);
}

TEST(DemoMarshal, TheWrongWayDoesNotCountAndIsSaid) {
    Race race;
    race.fly(Vector3(50, 0, 0), Vector3(-60, 0, 0), 1.5);
    EXPECT_EQ(race.marshal.getPassed(), 0u);
    EXPECT_FALSE(race.marshal.getLapStart());
    ASSERT_EQ(race.reports.size(), 1u);
    EXPECT_EQ(race.reports[0], "wrong way through hoop 1");
}

TEST(DemoMarshal, ASkippedHoopHasToBeFlownFirst) {
    Race race;
    race.fly(Vector3(-50, 0, 0), Vector3(60, 0, 0), 1.5);  // the first
    race.fly(Vector3(150, 0, 0), Vector3(60, 0, 0), 1.5);  // the third
    EXPECT_EQ(race.marshal.getPassed(), 1u);
    ASSERT_EQ(race.reports.size(), 1u);
    EXPECT_EQ(race.reports[0], "hoop 3 does not count: fly hoop 2 first");
    race.fly(Vector3(-50, 0, 0), Vector3(60, 0, 0), 1.5);  // the start again
    EXPECT_TRUE(race.laps.empty()) << "no lap without all hoops";
    EXPECT_EQ(race.marshal.getNext(), 1u);
}

TEST(DemoMarshal, AMissedHoopMayBeFlownAgain) {
    Race race;
    race.fly(Vector3(-50, 15, 0), Vector3(60, 0, 0), 1.5);
    EXPECT_EQ(race.marshal.getMissed(), 1u);
    race.fly(Vector3(-50, 0, 0), Vector3(60, 0, 0), 1.5);
    EXPECT_EQ(race.marshal.getPassed(), 1u);
}

TEST(DemoMarshal, AWayInPiecesCrossesOnceWhereverItIsCut) {
    demo::Random random(3);
    const auto point = [&] {
        const real x = random.between(-20, 20), y = random.between(-9, 9);
        return Vector3(x, y, random.between(-9, 9));
    };
    const Hoop hoop = hoopAt(0);
    for (int n = 0; n < 2000; ++n) {
        const Vector3 from = point(), to = point();
        const Crossing whole = cross(hoop, from, to);
        // Cut at the plane itself every other time.
        const real share =
            n % 2 == 0 && whole.way != Crossing::Way::NONE ? whole.share : random.between(0, 1);
        const Vector3 middle = from + (to - from) * share;
        const Crossing first = cross(hoop, from, middle), second = cross(hoop, middle, to);
        const int pieces = (first.way != Crossing::Way::NONE) + (second.way != Crossing::Way::NONE);
        ASSERT_EQ(pieces, whole.way != Crossing::Way::NONE) << n;
        if (pieces == 0) continue;
        const Crossing &piece = first.way != Crossing::Way::NONE ? first : second;
        EXPECT_EQ(piece.way, whole.way);
        EXPECT_NEAR(piece.offset, whole.offset, 1e-9);
    }
}

TEST(DemoMarshal, StartingOverStopsTheClock) {
    Race race;
    race.fly(Vector3(-50, 0, 0), Vector3(60, 0, 0), 3);
    ASSERT_TRUE(race.marshal.getLapStart());
    race.marshal.startOver();
    EXPECT_FALSE(race.marshal.getLapStart());
    EXPECT_EQ(race.marshal.getNext(), 0u);
}

TEST(DemoHoops, HoopsStandClearOfTheGroundAndFaceWhereOneFlies) {
    const std::vector<Hoop> &course = getCourse();
    for (std::size_t n = 0; n < course.size(); ++n) {
        const Hoop &hoop = course[n], &next = course[(n + 1) % course.size()];
        EXPECT_GT(hoop.centre.y, hoop.radius + 10) << n;
        EXPECT_NEAR(hoop.axis.magnitude(), 1, 1e-12) << n;
        EXPECT_EQ(hoop.axis.y, 0) << n;
        const Vector3 way = (next.centre - hoop.centre).unit();
        EXPECT_GT(way * hoop.axis, 0.6) << n << ": out of one hoop";
        EXPECT_GT(way * next.axis, 0.6) << n << ": into the next";
    }
    const Crossing first = cross(course[0], getStart(), getStart() + Vector3(1000, 0, 0));
    EXPECT_EQ(first.way, Crossing::Way::FORWARDS);
    EXPECT_EQ(first.offset, 0) << "the race begins straight before the first hoop";
}
