#include "shell/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "flightsim/flight.h"

using namespace demo;
using namespace flightsim;

namespace {

const std::vector<real> breeze = {1.5, 20, 0.3};

void run(Session &session, int steps) {
    for (int n = 0; n < steps; ++n) session.step();
}

}  // namespace

TEST(DemoSession, WhatWasRecordedPlaysBackToTheSameBits) {
    Flight flown;
    Session play(flown, 3, breeze);
    run(play, 700);  // the pilot takes off
    play.takeControls();
    flown.setControl(Flight::PITCH, -0.7);  // and is flown into the ground
    run(play, 400);
    EXPECT_FALSE(flown.getWreck().empty());
    flown.setControl(Flight::THROTTLE, 0.8);
    run(play, 100);
    play.restart();
    flown.setControl(Flight::THROTTLE, 0.5);
    run(play, 300);

    Flight replayed;
    const Script inputs = readScript(writeScript(play.getInputs(), flown.getProfile()), flown.getProfile());
    Session replay(replayed, *inputs.seed, breeze, inputs);
    int steps = 0;
    for (; !replay.isOver(); ++steps) replay.step();
    EXPECT_EQ(steps, 1500);
    EXPECT_EQ(replayed.getHash(), flown.getHash());
    EXPECT_EQ(replay.getReport(), play.getReport());
}

TEST(DemoSession, APilotWhoIsWreckedTriesAgainAfterAWhile) {
    Flight flown;
    Session session(flown, 3, breeze);
    run(session, 700);
    flown.getAircraft().getBody().addVelocity(Vector3(0, -20, 0));
    run(session, 120);
    const Vector3 wreck = flown.getAircraft().getBody().getPosition();
    ASSERT_FALSE(flown.getWreck().empty());
    run(session, 240);
    EXPECT_EQ(flown.getAircraft().getBody().getPosition(), wreck);
    while (!flown.getWreck().empty() && flown.getTime() < 20) session.step();
    EXPECT_TRUE(session.getFrame().cut) << "nothing is drawn between the wreck and the start";
    EXPECT_EQ(flown.getAircraft().getBody().getPosition(), Vector3(0, Aircraft::WHEEL_HEIGHT, 0));
    EXPECT_EQ(session.getDriver(), Driver::PILOT);
    const std::string inputs = writeScript(session.getInputs(), flown.getProfile());
    EXPECT_NE(inputs.find("restart"), std::string::npos) << inputs;
}

TEST(DemoSession, SticksAreCentredWhenOneTakesOverFromThePilotButTheThrottleStays) {
    Flight flight;
    Session session(flight, 3, {0, 0, 0});
    run(session, 120);
    ASSERT_NE(flight.getControl(Flight::PITCH), 0) << "he keeps the wheels on the runway";
    ASSERT_EQ(flight.getControl(Flight::THROTTLE), 1);
    session.takeControls();
    EXPECT_EQ(flight.getControl(Flight::PITCH), 0);
    EXPECT_EQ(flight.getControl(Flight::THROTTLE), 1);
    flight.setControl(Flight::PITCH, 0.3);
    session.takeControls();
    EXPECT_EQ(flight.getControl(Flight::PITCH), 0.3) << "one has them already";
}

TEST(DemoSession, WhoeverTakesOverDuringTheTakeOffLeavesTheGroundUnbroken) {
    for (const int steps : {60, 240, 360}) {
        Flight flight;
        Session session(flight, 3, {0, 0, 0});
        run(session, steps);
        session.takeControls();
        run(session, 600);
        EXPECT_TRUE(flight.getWreck().empty()) << flight.getWreck() << " after " << steps;
        EXPECT_GT(flight.getAircraft().getBody().getPosition().y, 3) << steps;
    }
}

TEST(DemoSession, AScriptSetsItsControlsAtItsTimes) {
    Flight flight;
    const Script script = readScript("0 throttle 0.4\n0.5 rudder 0.2\n1 end\n", flight.getProfile());
    Session session(flight, 1, breeze, script);
    EXPECT_EQ(session.getDriver(), Driver::SCRIPT);
    run(session, 60);
    EXPECT_EQ(flight.getControl(Flight::THROTTLE), 0.4);
    EXPECT_EQ(flight.getControl(Flight::RUDDER), 0);
    session.step();
    EXPECT_EQ(flight.getControl(Flight::RUDDER), 0.2);
    EXPECT_FALSE(session.isOver());
    run(session, 59);
    EXPECT_TRUE(session.isOver());
}

TEST(DemoSession, ARestartInAScriptIsACutToo) {
    Flight flight;
    const Script script = readScript("0 throttle 1\n0.5 restart\n1 end\n", flight.getProfile());
    Session session(flight, 1, breeze, script);
    run(session, 60);
    EXPECT_FALSE(session.getFrame().cut);
    session.step();
    EXPECT_TRUE(session.getFrame().cut) << "nothing is drawn between the runway's middle and its start";
    session.step();
    EXPECT_FALSE(session.getFrame().cut);
}

TEST(DemoSession, TheCsvFileHasALineForEveryStepAndAColumnForEveryQuantity) {
    Flight flight;
    Session session(flight, 1, breeze);
    std::ostringstream csv;
    session.writeCsvTo(csv);
    run(session, 10);
    std::istringstream lines(csv.str());
    std::string line;
    int count = 0;
    while (std::getline(lines, line)) {
        EXPECT_EQ(std::count(line.begin(), line.end(), ','),
                  static_cast<long>(flight.getProfile().quantities.size()));
        ++count;
    }
    EXPECT_EQ(count, 1 + 11);
    EXPECT_EQ(csv.str().rfind("time [s],x [m],height [m]", 0), 0u);
}

TEST(DemoSession, ThePageHasThirtyFramesASecondAndTheEvents) {
    Flight flight;
    Session session(flight, 1, breeze);
    session.keepFrames();
    run(session, 600);
    std::ostringstream page;
    session.writePageTo(page);
    EXPECT_NE(page.str().find("\"frames\":151,"), std::string::npos);
    EXPECT_NE(page.str().find("took off"), std::string::npos);
}
