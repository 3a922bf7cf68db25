// The glider and its pilot: its polar, its stall, its brakes, and what the thermals give.
#include "flightsim/soaring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace demo;
using namespace flightsim;

namespace {

constexpr real STEP = 1.0 / 60, G = 9.81, WEIGHT = Glider::MASS * G, AREA = Glider::SPAN * Glider::CHORD,
               ASPECT_RATIO = Glider::SPAN / Glider::CHORD;
constexpr real CALM = 0, FROM = 20;

/// The drag coefficient without lift: of the wing, the tail and the fuselage.
real dragWithoutLift() {
    const real tail = Glider::TAIL_SPAN * Glider::TAIL_CHORD + Glider::FIN_SPAN * Glider::FIN_CHORD;
    return (Glider::SECTION_DRAG * (AREA + tail) + Glider::FUSELAGE_DRAG_AREA) / AREA;
}

/// m/s: how fast it sinks at this speed and bank, by its polar. A turn needs the lift weight/cos(bank).
real sinkRate(real speed, real bank) {
    const real pressure = 0.5 * Glider::DENSITY * speed * speed, load = 1 / std::cos(bank);
    const real lift = load * WEIGHT / (pressure * AREA);
    const real drag = dragWithoutLift() + lift * lift / (cyclone::REAL_PI * ASPECT_RATIO);
    return speed * drag / lift * load;
}

/// Still air but for what a test adds.
struct Sky {
    cyclone::World world;
    Weather air;
    Glider glider{world, &air};

    void fly(real seconds) {
        for (int n = 0; n < std::lround(seconds / STEP); ++n) {
            world.startFrame();
            world.runPhysics(STEP);
        }
    }
    void pull(real stick) {
        GliderControls controls = glider.getControls();
        controls.pull = stick;
        glider.setControls(controls);
    }
    /// Nothing but the pitch is free: the wings stay level.
    void levelWings() {
        glider.getBody().setInverseInertiaTensor(cyclone::Matrix3(0, 0, 0, 0, 0, 0, 0, 0, 1.0 / 650));
    }
};

struct Glide {
    real ratio, sink, speed;
};

/// With level wings and the stick held there.
Glide glideWith(real stick, real brakes) {
    Sky sky;
    sky.levelWings();
    sky.glider.launch(Vector3(0, 5000, 0));
    GliderControls controls;
    controls.pull = stick;
    controls.brakes = brakes;
    sky.glider.setControls(controls);
    sky.fly(400);  // until the slow swings of speed and height are small
    const Vector3 start = sky.glider.getBody().getPosition();
    real speed = 0;
    for (int n = 0; n < 240; ++n) {
        sky.fly(0.5);
        speed += sky.glider.getAirspeed() / 240;
    }
    const Vector3 way = sky.glider.getBody().getPosition() - start;
    return {-way.x / way.y, -way.y / 120, speed};
}

/// Flies until the pilot has stopped, or twenty minutes.
std::vector<Event> flyOut(Soaring &soaring) {
    std::vector<Event> events;
    while (!soaring.isOver() && soaring.getTime() < 1200) {
        soaring.steer();
        soaring.step();
        for (const Event &event : soaring.takeEvents()) events.push_back(event);
    }
    return events;
}

bool happened(const std::vector<Event> &events, const std::string &beginning) {
    return std::any_of(events.begin(), events.end(),
                       [&](const Event &event) { return event.text.rfind(beginning, 0) == 0; });
}

bool standsOnRunway(const Soaring &soaring) {
    const Vector3 end = soaring.getGlider().getBody().getPosition();
    return std::fabs(end.x) < 500 && std::fabs(end.z) < 15;
}

}  // namespace

TEST(DemoGlider, GlidesAsItsPolarSays) {
    const real cd0 = dragWithoutLift(), best = 0.5 * std::sqrt(cyclone::REAL_PI * ASPECT_RATIO / cd0);
    const real bestLift = std::sqrt(cyclone::REAL_PI * ASPECT_RATIO * cd0);
    const real bestSpeed = std::sqrt(2 * WEIGHT / (Glider::DENSITY * AREA * bestLift));
    EXPECT_NEAR(best, 39, 0.5) << "as its header says";
    EXPECT_NEAR(Glider::BEST_GLIDE_SPEED, bestSpeed, 0.1);
    real ratio = 0;
    for (const real stick : {0.0, 0.1, 0.2, 0.3}) {
        const Glide glide = glideWith(stick, 0);
        EXPECT_NEAR(glide.sink, sinkRate(glide.speed, 0), 0.03) << stick;
        ratio = std::max(ratio, glide.ratio);
    }
    EXPECT_NEAR(ratio, best, 0.03 * best);
}

TEST(DemoGlider, TheBrakesSteepenTheGlide) {
    const Glide clean = glideWith(0, 0), braked = glideWith(0, 1);
    // What the brakes add to drag over weight is what they add to the slope of the path.
    const real drag = 0.5 * Glider::DENSITY * braked.speed * braked.speed * Glider::BRAKE_DRAG_AREA;
    EXPECT_NEAR(braked.sink / braked.speed, sinkRate(braked.speed, 0) / braked.speed + drag / WEIGHT, 0.01);
    EXPECT_LT(braked.ratio, 0.4 * clean.ratio);
}

TEST(DemoGlider, StallsWhenHeldTooSlowAndRecoversWhenReleased) {
    Sky sky;
    sky.glider.launch(Vector3(0, 2000, 0));
    bool stalled = false;
    for (real time = 0; time < 60 && !stalled; time += 0.1) {
        sky.pull(std::min(0.2 + time / 20, 1.0));
        sky.fly(0.1);
        stalled = sky.glider.isStalled();
    }
    ASSERT_TRUE(stalled);
    EXPECT_LT(sky.glider.getAirspeed(), 20);
    sky.pull(0);
    sky.fly(8);
    EXPECT_FALSE(sky.glider.isStalled());
    EXPECT_GT(sky.glider.getAirspeed(), 20);
}

TEST(DemoSoaring, ThePilotGainsHeightInThermalsAndLandsOnTheRunwayInFortySeeds) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Soaring soaring;
        soaring.begin(seed);
        const std::vector<Event> events = flyOut(soaring);
        EXPECT_TRUE(soaring.isOver()) << seed;
        EXPECT_FALSE(happened(events, "crashed")) << seed;
        EXPECT_TRUE(happened(events, "touched down")) << seed;
        EXPECT_GT(soaring.getHeightGained(), 150) << seed;
        EXPECT_TRUE(standsOnRunway(soaring)) << seed;
    }
}

TEST(DemoSoaring, LandsInTheWindFromEverySide) {
    for (int from = 0; from < 360; from += 45) {
        Soaring soaring;
        soaring.begin(3, {4, static_cast<real>(from), 0.5, 0});
        const std::vector<Event> events = flyOut(soaring);
        EXPECT_TRUE(soaring.isOver()) << from;
        EXPECT_FALSE(happened(events, "crashed")) << from;
        EXPECT_TRUE(standsOnRunway(soaring)) << from;
    }
}

/// As the air rises where it flies, less what its polar says it sinks by in such a turn.
TEST(DemoSoaring, CirclingClimbsByTheAirsRiseLessTheSinkOfTheTurn) {
    Soaring soaring;
    soaring.begin(1, {CALM, FROM, 0, 3.5});
    real rise = 0, sink = 0, climb = 0;
    int steps = 0;
    bool hasCircled = false;
    while (soaring.getTime() < 400) {
        soaring.steer();
        const bool circles = happened(soaring.takeEvents(), "circles in lift");
        hasCircled = hasCircled || circles;
        const Glider &glider = soaring.getGlider();
        const real before = glider.getEnergyHeight();
        soaring.step();
        if (!hasCircled || soaring.getTime() < 60) continue;
        rise += soaring.getWeather().getVelocity(glider.getBody().getPosition()).y;
        sink += sinkRate(glider.getAirspeed(), bankOf(glider.getBody()));
        climb += (glider.getEnergyHeight() - before) / STEP;
        ++steps;
    }
    ASSERT_TRUE(hasCircled);
    rise /= steps;
    sink /= steps;
    climb /= steps;
    EXPECT_GT(climb, 0.5);
    EXPECT_NEAR(climb, rise - sink, 0.15 * rise);
}

TEST(DemoSoaring, WithoutLiftItGlidesDownAndLands) {
    Soaring soaring;
    soaring.begin(1, {CALM, FROM, 0, 0});
    const std::vector<Event> events = flyOut(soaring);
    EXPECT_TRUE(soaring.isOver());
    EXPECT_TRUE(happened(events, "touched down"));
    EXPECT_EQ(soaring.getHeightGained(), 0);
    // It cannot stay up longer than at its least sink, and a little more for speed that becomes height.
    const real leastSink = sinkRate(Glider::BEST_GLIDE_SPEED / std::pow(3, 0.25), 0);
    EXPECT_LT(soaring.getTime(), (Soaring::RELEASE_HEIGHT + 30) / leastSink + 60);
}

TEST(DemoSoaring, TheLineSaysWhereTheNearestCloudIsAndTheField) {
    Soaring soaring;
    soaring.begin(1);
    const Vector3 cloud = soaring.getWeather().getClouds()[3];
    soaring.getGlider().launch(cloud + Vector3(60, -500, 0));
    EXPECT_NE(soaring.getHeadUpLine().find("  CLOUD 60m 180"), std::string::npos) << soaring.getHeadUpLine();
    soaring.begin(1, {CALM, FROM, 0, 0});
    soaring.getGlider().launch(Vector3(0, 300, -250));
    const std::string line = soaring.getHeadUpLine();
    EXPECT_NE(line.find("  FIELD 250m 90S  "), std::string::npos) << line;
    EXPECT_EQ(line.find("CLOUD"), std::string::npos) << "there is none on such an evening";
}

TEST(DemoSoaring, TheSameSeedGivesTheSameFlightAndAnotherSeedAnother) {
    Soaring a, b, c;
    a.begin(7);
    b.begin(7);
    c.begin(8);
    for (Soaring *soaring : {&a, &b, &c})
        for (int n = 0; n < 2000; ++n) {
            soaring->steer();
            soaring->step();
        }
    EXPECT_EQ(a.getHash(), b.getHash());
    EXPECT_NE(a.getHash(), c.getHash());
}

TEST(DemoSoaring, ADiveIntoTheGroundIsACrash) {
    Soaring soaring;
    soaring.begin(1, {CALM, FROM, 0, 0});
    soaring.getGlider().launch(Vector3(0, 30, 0));
    soaring.getGlider().getBody().addVelocity(Vector3(0, -10, 0));
    while (soaring.getTime() < 10 && !happened(soaring.takeEvents(), "crashed")) {
        soaring.setControl(Soaring::PULL, -1);
        soaring.step();
    }
    EXPECT_LT(soaring.getTime(), 10);
}
