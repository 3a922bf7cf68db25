// Buoys and the clock.
#include "speedboat/course.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace speedboat;

namespace {

constexpr real PI = cyclone::REAL_PI;
using Event = Course::Event;

/// A first buoy, to be left to port going north, and a second one far off.
Course makeCourse() { return Course({{100, 0, 0, true}, {0, 500, PI, false}}); }

std::optional<Event> go(Course &course, const Vector3 &from, const Vector3 &to) {
    return course.advance(from, to, 1, 0.01);
}

TEST(SpeedboatCourse, ABuoyIsPassedOnItsOwnSideAndTheRightWayOnly) {
    Course course = makeCourse();
    EXPECT_EQ(go(course, Vector3(99, 0, 60), Vector3(101, 0, 60)), std::nullopt) << "beyond the gate";
    EXPECT_EQ(go(course, Vector3(101, 0, 3), Vector3(99, 0, 3)), std::nullopt) << "the wrong way";
    EXPECT_EQ(go(course, Vector3(97, 0, 3), Vector3(99, 0, 3)), std::nullopt) << "not yet there";
    EXPECT_EQ(go(course, Vector3(99, 0, -3), Vector3(101, 0, -3)), Event::MISSED);
    EXPECT_EQ(go(course, Vector3(99, 0, -3), Vector3(101, 0, -3)), std::nullopt) << "told once";
    EXPECT_EQ(course.getNext(), 0u);
    EXPECT_EQ(go(course, Vector3(99, 0, 3), Vector3(101, 0, 3)), Event::PASSED);
    EXPECT_EQ(course.getNext(), 1u);
}

TEST(SpeedboatCourse, GoingAslantTheCrossingCountsNotTheEnds) {
    // From (98, −1) to (104, 5) the way crosses x = 100 at z = 1; the other way round the buoy at z = −1.
    Course near = makeCourse(), beyond = makeCourse();
    EXPECT_EQ(go(near, Vector3(98, 0, -1), Vector3(104, 0, 5)), Event::PASSED);
    EXPECT_EQ(go(beyond, Vector3(98, 0, 1), Vector3(104, 0, -5)), Event::MISSED);
}

TEST(SpeedboatCourse, NobodyIsTooFastForAGate) {
    Course course = makeCourse();
    EXPECT_EQ(go(course, Vector3(0, 0, 10), Vector3(1000, 0, 10)), Event::PASSED);
}

TEST(SpeedboatCourse, AGateLiesAcrossTheWayOnTheSideWhereBoatsPass) {
    // Going east, (0, 1) in x and z, port is north: +X. Left to port, the gate lies to the south.
    const Buoy toPort{0, 0, PI / 2, true}, toStarboard{0, 0, PI / 2, false};
    EXPECT_NEAR((toPort.getGateDirection() - Vector3(-1, 0, 0)).magnitude(), 0, 1e-12);
    EXPECT_NEAR((toStarboard.getGateDirection() - Vector3(1, 0, 0)).magnitude(), 0, 1e-12);
}

TEST(SpeedboatCourse, LapsEndWithinTheStepWhereTheLastGateIsCrossed) {
    Course course({{100, 0, 0, true}});
    course.startOver(3);
    // The step of 0.2 s that ends at 10 s crosses the gate after a quarter of the way, at 9.85 s.
    EXPECT_EQ(course.advance(Vector3(99, 0, 3), Vector3(103, 0, 3), 10, 0.2), Event::LAP);
    EXPECT_NEAR(course.getLastLap(), 6.85, 1e-12);
    EXPECT_EQ(course.advance(Vector3(99, 0, 3), Vector3(101, 0, 3), 15, 0.2), Event::LAP);
    EXPECT_NEAR(course.getLastLap(), 15 - 0.1 - 9.85, 1e-12);
    EXPECT_NEAR(course.getBestLap(), 5.05, 1e-12);
    EXPECT_EQ(course.advance(Vector3(99, 0, 3), Vector3(101, 0, 3), 35, 0.2), Event::LAP);
    EXPECT_NEAR(course.getBestLap(), 5.05, 1e-12);
    EXPECT_EQ(course.getLaps(), 3u);
}

TEST(SpeedboatCourse, StartingOverKeepsWhatWasDone) {
    Course course = makeCourse();
    go(course, Vector3(99, 0, 3), Vector3(101, 0, 3));
    go(course, Vector3(1, 0, 505), Vector3(-1, 0, 505));
    go(course, Vector3(99, 0, 3), Vector3(101, 0, 3));
    course.startOver(20);
    EXPECT_EQ(course.getNext(), 0u);
    EXPECT_EQ(course.getLaps(), 1u);
    EXPECT_EQ(course.getLapStart(), 20);
}

TEST(SpeedboatCourse, NeedsABuoy) { EXPECT_THROW(Course({}), std::invalid_argument); }

}  // namespace
