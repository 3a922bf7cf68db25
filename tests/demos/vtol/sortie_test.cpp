// From pad to pad: the stabiliser, the pilot, landings and crashes.
#include "vtol/sortie.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace vtol;

namespace {

constexpr real DEGREE = cyclone::REAL_PI / 180;
const std::vector<real> CALM = {0, 0, 0};

std::vector<Event> flyOut(Sortie &sortie) {
    std::vector<Event> events;
    while (!sortie.isOver() && sortie.getWreck().empty() && sortie.getTime() < 300) {
        sortie.steer();
        sortie.step();
        for (const Event &event : sortie.takeEvents()) events.push_back(event);
    }
    return events;
}

real timeOf(const std::vector<Event> &events, const std::string &beginning) {
    const auto found = std::find_if(events.begin(), events.end(),
                                    [&](const Event &event) { return event.text.rfind(beginning, 0) == 0; });
    return found == events.end() ? NAN : found->time;
}

void holdFor(Sortie &sortie, real seconds) {
    for (const real end = sortie.getTime() + seconds; sortie.getTime() < end;) sortie.step();
}

/// In the air over the home pad, hovering in calm air.
void hover(Sortie &sortie, bool stabilised) {
    sortie.begin(1, CALM);
    sortie.setControl(Sortie::THROTTLE, Jet::WEIGHT / Jet::MAX_THRUST);
    sortie.setControl(Sortie::STABILISER, stabilised);
    JetControls controls;
    controls.throttle = Jet::WEIGHT / Jet::MAX_THRUST;
    controls.nozzles = cyclone::REAL_PI / 2;
    sortie.getJet().launch(Vector3(0, 60, 0), 0, controls);
}

/// Whether she came down whole, on the far pad, with a mark of at least fair.
void expectGoodEnd(const Sortie &sortie, const std::string &run) {
    EXPECT_EQ(sortie.getWreck(), "") << run;
    ASSERT_EQ(sortie.getLandings().size(), 1u) << run;
    const Landing &landing = sortie.getLandings().front();
    EXPECT_EQ(landing.pad, 1u) << run;
    EXPECT_GE(judge(landing).getMark(), Mark::FAIR) << run << ": " << describe(landing);
    EXPECT_TRUE(sortie.isOver()) << run;
}

}  // namespace

TEST(DemoVtol, ThePilotGoesUpOverToTheWingsAndDownOnThePad) {
    Sortie sortie;
    std::vector<std::string> told;
    real hovered = 0, flown = 0;
    while (!sortie.isOver() && sortie.getTime() < 300) {
        sortie.steer();
        sortie.step();
        const Jet &jet = sortie.getJet();
        const bool isSlow = jet.getAirspeed()<8, isHigh = jet.getHeight()> 1;
        // In the hover the engine carries nearly all, on her wings they do.
        if (isSlow && isHigh && jet.getNozzles() > 80 * DEGREE && sortie.getWingborne() < 0.1)
            hovered += sortie.getProfile().step;
        if (jet.getNozzles() < 5 * DEGREE && sortie.getWingborne() > 0.7) flown += sortie.getProfile().step;
    }
    EXPECT_GT(hovered, 15);
    EXPECT_GT(flown, 30);
    expectGoodEnd(sortie, "seed 1");
}

TEST(DemoVtol, TellsEachLegInItsOrder) {
    Sortie sortie;
    const std::vector<Event> events = flyOut(sortie);
    real last = 0;
    for (const char *event : {"hovers, and turns", "swivels the nozzles aft", "the wings carry her",
                              "turns towards the pad", "swivels the nozzles down", "the engine carries her",
                              "hovers to the pad", "descends", "touched down"}) {
        const real time = timeOf(events, event);
        EXPECT_GT(time, last) << event;
        last = time;
    }
}

TEST(DemoVtol, ThePilotFinishesWithEachOfFortySeeds) {
    Sortie sortie;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        sortie.begin(seed);
        flyOut(sortie);
        expectGoodEnd(sortie, "seed " + std::to_string(seed));
    }
}

TEST(DemoVtol, ThePilotLandsInTheStrongestWindFromAnySideAndInACalm) {
    Sortie sortie;
    for (int side = 0; side < 8; ++side) {
        sortie.begin(7, {8, 45.0 * side, 0.8});
        flyOut(sortie);
        expectGoodEnd(sortie, "wind from " + std::to_string(45 * side));
    }
    sortie.begin(1, CALM);
    flyOut(sortie);
    expectGoodEnd(sortie, "calm");
}

TEST(DemoVtol, ThePilotTakesOverWhereverSheIs) {
    Sortie sortie;
    const auto takeOverAt = [&](const Vector3 &place, real speed, real throttle, real nozzles) {
        sortie.begin(3);
        sortie.setControl(Sortie::THROTTLE, throttle);
        sortie.setControl(Sortie::NOZZLES, nozzles / DEGREE);
        JetControls controls;
        controls.throttle = throttle;
        controls.nozzles = nozzles;
        sortie.getJet().launch(place, speed, controls);
        holdFor(sortie, 1);
        flyOut(sortie);
        expectGoodEnd(sortie, "from " + std::to_string(speed) + " m/s");
    };
    takeOverAt(Vector3(300, 60, 200), 50, 0.2, 0);
    takeOverAt(Vector3(-200, 40, -100), 2, 0.78, cyclone::REAL_PI / 2);
    takeOverAt(Vector3(500, 90, 0), 25, 0.6, 1);
    takeOverAt(PADS[1].centre + Vector3(120, 30, -90), 0, 0.78, cyclone::REAL_PI / 2);
}

TEST(DemoVtol, TheStabiliserLevelsHerAndStopsHerDrift) {
    Sortie sortie;
    for (const bool stabilised : {true, false}) {
        hover(sortie, stabilised);
        RigidBody &body = sortie.getJet().getBody();
        body.setOrientation(cyclone::Quaternion::fromAxisAngle(Vector3::X, 8 * DEGREE));
        holdFor(sortie, 2.5);
        EXPECT_EQ(std::fabs(bankOf(body)) < 3 * DEGREE, stabilised);
        if (stabilised) {
            holdFor(sortie, 15);
            EXPECT_NEAR(body.getVelocity().magnitude(), 0, 0.1);
            EXPECT_NEAR(bankOf(body), 0, 0.1 * DEGREE);
        }
    }
}

TEST(DemoVtol, TheStabiliserHoldsTheBankThatTheStickAsksFor) {
    Sortie sortie;
    sortie.begin(1, CALM);
    sortie.setControl(Sortie::NOZZLES, 0);
    sortie.setControl(Sortie::THROTTLE, 0.2);
    sortie.setControl(Sortie::ROLL, 0.5);
    JetControls controls;
    controls.throttle = 0.2;
    sortie.getJet().launch(Vector3(0, 300, 0), 50, controls);
    holdFor(sortie, 4);
    const RigidBody &body = sortie.getJet().getBody();
    EXPECT_NEAR(bankOf(body), 0.5 * Stabiliser::MOST_BANK, 2 * DEGREE);
    const real before = headingOf(body), bank = bankOf(body);
    holdFor(sortie, 4);
    // A clean turn: g·tan(bank)/speed.
    const real rate = 9.81 * std::tan((bank + bankOf(body)) / 2) / sortie.getJet().getAirspeed();
    EXPECT_NEAR((headingOf(body) - before) / 4, rate, 0.15 * rate);
}

TEST(DemoVtol, TheStabiliserSaysWhenItGoesInAndOut) {
    Sortie sortie;
    sortie.begin(1, CALM);
    sortie.takeEvents();
    sortie.setControl(Sortie::STABILISER, 0);
    sortie.step();
    sortie.setControl(Sortie::STABILISER, 1);
    sortie.step();
    const std::vector<Event> events = sortie.takeEvents();
    ASSERT_EQ(events.size(), 2u);
    EXPECT_EQ(events[0].text, "stabiliser out: the sticks move puffers and flaps");
    EXPECT_EQ(events[1].text, "stabiliser in: sticks ask for attitudes, she leans against drift");
}

TEST(DemoVtol, FallsWhenTheEngineStopsInTheHover) {
    Sortie sortie;
    hover(sortie, true);
    sortie.setControl(Sortie::THROTTLE, 0);
    for (int n = 0; n < 1200 && sortie.getWreck().empty(); ++n) sortie.step();
    EXPECT_EQ(sortie.getWreck().rfind("crashed: ", 0), 0u) << sortie.getWreck();
    EXPECT_NE(sortie.getSummary().find("Crashes: 1"), std::string::npos);
    sortie.startOver();
    EXPECT_EQ(sortie.getWreck(), "");
    EXPECT_EQ(sortie.getJet().getBody().getVelocity(), Vector3());
}

TEST(DemoVtol, LandingsAreMarkedByTheirWorstPart) {
    RigidBody body;
    body.setPosition(PADS[1].centre + Vector3(3, 1.2, 4));
    const Landing landing = measureLanding(body, Vector3(0.3, -0.5, 0.4));
    EXPECT_EQ(landing.pad, 1u);
    EXPECT_NEAR(landing.offCentre, 5, 1e-9);
    EXPECT_NEAR(landing.drift, 0.5, 1e-12);
    EXPECT_EQ(landing.sinkRate, 0.5);
    EXPECT_EQ(landing.tilt, 0);
    EXPECT_TRUE(landing.isOnPad());
    EXPECT_EQ(judge(landing).getMark(), Mark::FAIR) << "5 of 6 m";
    EXPECT_EQ(
        describe(landing),
        "0.5 m/s, 5.0 m from the middle of the far pad, drifting at 0.5 m/s: fair, far from the middle");
    body.setPosition(Vector3(0, 1.2, 13));
    body.setOrientation(cyclone::Quaternion::fromAxisAngle(Vector3::Z, 5 * DEGREE));
    const Landing beside = measureLanding(body, Vector3(0, -1, 0));
    EXPECT_EQ(beside.pad, 0u);
    EXPECT_FALSE(beside.isOnPad());
    EXPECT_NEAR(beside.tilt, 5 * DEGREE, 1e-12);
    EXPECT_EQ(judge(beside).getText(), "poor, beside the pad");
}
