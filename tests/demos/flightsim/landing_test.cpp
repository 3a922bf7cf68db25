#include "flightsim/landing.h"

#include <gtest/gtest.h>

using namespace flightsim;

namespace {

constexpr real DEGREE = cyclone::REAL_PI / 180;
const Landing WORST{2, 40, 4, 10 * DEGREE, 10 * DEGREE};

/// Level, at this place.
RigidBody aircraftAt(const Vector3 &position) {
    RigidBody body;
    body.setPosition(position);
    return body;
}

}  // namespace

TEST(DemoLanding, IsMeasuredInTheDirectionOfTheLanding) {
    const Runway runway{10, 90};
    const Landing along = measureLanding(aircraftAt(Vector3(25, 0.3, -2)), Vector3(8, -0.5, 0), runway);
    EXPECT_EQ(along.sinkRate, 0.5);
    EXPECT_EQ(along.beyondAim, 15);
    EXPECT_EQ(along.offLine, 2);
    EXPECT_EQ(along.bank, 0);
    EXPECT_EQ(along.drift, 0);
    const Landing back = measureLanding(aircraftAt(Vector3(85, 0.3, 3)), Vector3(-8, -1, 0), runway);
    EXPECT_EQ(back.beyondAim, 5);
    EXPECT_EQ(back.offLine, 3);

    RigidBody banked = aircraftAt(Vector3(10, 0.3, 0));
    banked.setOrientation(cyclone::Quaternion::fromAxisAngle(Vector3::X, 5 * DEGREE));
    const Landing drifting = measureLanding(banked, Vector3(8, 0, 8), runway);
    EXPECT_NEAR(drifting.bank, 5 * DEGREE, 1e-12);
    EXPECT_NEAR(drifting.drift, 45 * DEGREE, 1e-12);
}

TEST(DemoLanding, GetsTheMarkOfItsWorstPart) {
    EXPECT_EQ(judge(Landing{0.5, 10, 1, 0, 0}, WORST).getMark(), Mark::EXCELLENT);
    EXPECT_EQ(judge(Landing{0.5, 20, 1, 0, 0}, WORST).getMark(), Mark::GOOD);
    EXPECT_EQ(judge(Landing{0.5, -30, 1, 0, 0}, WORST).getMark(), Mark::FAIR);
    EXPECT_EQ(judge(Landing{2.1, 0, 0, 0, 0}, WORST).getMark(), Mark::POOR);
    EXPECT_EQ(describe(Landing{0.5, -30, 1, 2 * DEGREE, 0}, WORST),
              "0.5 m/s, 30 m short of the aim, bank 2°: fair, far from the aim");
    EXPECT_EQ(describe(Landing{1.9, 3, 0, 0, 0}, WORST), "1.9 m/s, 3 m beyond the aim, bank 0°: fair, hard");
    EXPECT_EQ(describe(Landing{0.2, 3, 0, 0, 0}, WORST), "0.2 m/s, 3 m beyond the aim, bank 0°: excellent");
}

TEST(DemoLanding, TheLogTellsTheBest) {
    LandingLog log;
    EXPECT_EQ(log.getSummary(), "Landings: 0");
    const auto add = [&](const Landing &landing) {
        log.add(describe(landing, WORST), judge(landing, WORST));
    };
    add(Landing{1.9, 3, 0, 0, 0});
    EXPECT_EQ(log.getSummary(), "Landings: 1, at 1.9 m/s, 3 m beyond the aim, bank 0°: fair, hard");
    add(Landing{0.2, 3, 0, 0, 0});
    add(Landing{1.0, 3, 0, 0, 0});
    EXPECT_EQ(log.getCount(), 3u);
    EXPECT_EQ(log.getSummary(), "Landings: 3, the best at 0.2 m/s, 3 m beyond the aim, bank 0°: excellent");
}
