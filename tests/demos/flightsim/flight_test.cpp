#include "flightsim/flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace demo;
using namespace flightsim;

namespace {

/// Flies until the pilot has stopped on the runway, or three minutes.
std::vector<Event> flyOut(Flight &flight) {
    while (!flight.isOver() && flight.getTime() < 180) {
        flight.steer();
        flight.step();
    }
    return flight.takeEvents();
}

bool happened(const std::vector<Event> &events, const std::string &beginning) {
    return std::any_of(events.begin(), events.end(),
                       [&](const Event &event) { return event.text.rfind(beginning, 0) == 0; });
}

/// In calm air at this height over the runway, coming down at this rate with the engine idle.
void comeDown(Flight &flight, real sinkRate) {
    flight.begin(1, {0, 0, 0});
    flight.getAircraft().launch(Vector3(10, 1, 0));
    flight.getAircraft().getBody().addVelocity(Vector3(0, -sinkRate, 0));
}

}  // namespace

TEST(DemoFlight, ThePilotTakesOffFliesACircuitAndLandsInAnyWeather) {
    struct Weather {
        std::uint64_t seed;
        std::vector<real> settings;  // wind, from, gusts
    };
    for (const Weather &weather :
         {Weather{1, {0, 0, 0}}, Weather{2, {1.5, 20, 0.3}}, Weather{3, {3, 320, 0.5}},
          Weather{4, {2, 90, 0.3}}, Weather{5, {1.5, 180, 0.2}}}) {
        Flight flight;
        flight.begin(weather.seed, weather.settings);
        real westmost = 0, portmost = 0;
        while (!flight.isOver() && flight.getTime() < 180) {
            flight.steer();
            flight.step();
            const Vector3 position = flight.getAircraft().getBody().getPosition();
            westmost = std::min(westmost, position.x);
            portmost = std::min(portmost, position.z);
        }
        const std::vector<Event> events = flight.takeEvents();
        EXPECT_TRUE(flight.isOver()) << weather.seed;
        EXPECT_TRUE(happened(events, "took off")) << weather.seed;
        EXPECT_TRUE(happened(events, "touched down")) << weather.seed;
        EXPECT_FALSE(happened(events, "crashed")) << weather.seed;
        EXPECT_LT(westmost, -50) << "it has flown round";
        EXPECT_LT(portmost, -40) << "it has flown round";
        const Vector3 end = flight.getAircraft().getBody().getPosition();
        EXPECT_LT(std::fabs(end.z), 4) << "it stands on the runway, seed " << weather.seed;
        EXPECT_NEAR(flight.getAircraft().getBody().getVelocity().magnitude(), 0, 0.2);
    }
}

/// What became of forty seeds in the wind from eight directions.
struct Season {
    int flights = 0, landings = 0, crashes = 0, daysOnTheGround = 0;
};

Season flySeason(real wind, real gusts) {
    Season season;
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
        for (int direction = 0; direction < 360; direction += 45) {
            Flight flight;
            flight.begin(seed, {wind, static_cast<real>(direction), gusts});
            const std::vector<Event> events = flyOut(flight);
            ++season.flights;
            season.landings += happened(events, "touched down") && flight.isOver() ? 1 : 0;
            season.crashes += happened(events, "crashed") ? 1 : 0;
            season.daysOnTheGround += happened(events, "stays down: wind of up to") ? 1 : 0;
        }
    return season;
}

TEST(DemoFlight, ThePilotDoesNotCrashInGustsFromAnySide) {
    const Season season = flySeason(3, 1);
    EXPECT_EQ(season.crashes, 0);
    EXPECT_GT(season.landings, 0.9 * season.flights);
}

TEST(DemoFlight, ThePilotStaysDownInAStormAndSaysWhy) {
    const Season season = flySeason(5, 2);
    EXPECT_EQ(season.crashes, 0);
    EXPECT_EQ(season.landings + season.daysOnTheGround, season.flights);
}

TEST(DemoFlight, TheSameSeedGivesTheSameFlightAndAnotherSeedAnother) {
    Flight a, b, c;
    a.begin(7, {1.5, 20, 0.3});
    b.begin(7, {1.5, 20, 0.3});
    c.begin(8, {1.5, 20, 0.3});
    for (Flight *flight : {&a, &b, &c}) flyOut(*flight);
    EXPECT_EQ(a.getTime(), b.getTime());
    EXPECT_EQ(a.getHash(), b.getHash());
    EXPECT_NE(a.getHash(), c.getHash());
    // Begun again, a used flight is as good as a new one.
    c.begin(7, {1.5, 20, 0.3});
    flyOut(c);
    EXPECT_EQ(a.getHash(), c.getHash());
}

TEST(DemoFlight, AGentleTouchDownRollsOut) {
    Flight flight;
    comeDown(flight, 0.5);
    real lastSpeed = 100;
    while (flight.getTime() < 25) {
        flight.setControl(Flight::PITCH, flight.getAircraft().isOnGround() ? -1 : 0);
        flight.step();
        lastSpeed = flight.getAircraft().getBody().getVelocity().magnitude();
    }
    const std::vector<Event> events = flight.takeEvents();
    EXPECT_TRUE(happened(events, "touched down"));
    EXPECT_FALSE(happened(events, "crashed"));
    EXPECT_LT(lastSpeed, 0.1);
    EXPECT_GT(flight.getAircraft().getBody().getPosition().x, 20);
}

TEST(DemoFlight, AHardOneIsACrashAndTheWreckLiesThereUntilItStartsOver) {
    Flight flight;
    comeDown(flight, 4);
    flight.setControl(Flight::THROTTLE, 0.2);
    while (flight.getWreck().empty() && flight.getTime() < 1) flight.step();
    EXPECT_EQ(flight.getWreck().rfind("crashed", 0), 0u);
    EXPECT_TRUE(happened(flight.takeEvents(), flight.getWreck()));
    const Vector3 place = flight.getAircraft().getBody().getPosition();
    EXPECT_GT(place.x, 10);
    const real time = flight.getTime();
    for (int n = 0; n < 60; ++n) flight.step();
    EXPECT_EQ(flight.getAircraft().getBody().getPosition(), place);
    EXPECT_NEAR(flight.getTimeSinceWreck(), 0.5, 1e-12);
    EXPECT_NEAR(flight.getTime(), time + 0.5, 1e-12);
    EXPECT_TRUE(flight.takeEvents().empty()) << "it is told once";

    flight.startOver();
    EXPECT_TRUE(flight.getWreck().empty());
    EXPECT_TRUE(flight.getFrame().cut);
    EXPECT_EQ(flight.getAircraft().getBody().getPosition(), Vector3(0, Aircraft::WHEEL_HEIGHT, 0));
    EXPECT_EQ(flight.getControl(Flight::THROTTLE), 0);
    flight.step();
    EXPECT_FALSE(flight.getFrame().cut);
}

TEST(DemoFlight, AWingTipInTheGrassIsACrashToo) {
    Flight flight;
    flight.begin(1, {0, 0, 0});
    flight.getAircraft().getBody().setOrientation(cyclone::Quaternion::fromAxisAngle(Vector3::X, 1.2));
    flight.step();
    EXPECT_TRUE(happened(flight.takeEvents(), "crashed"));
}

TEST(DemoFlight, TheWindComesFromWhereItIsSaid) {
    Flight flight;
    flight.begin(1, {3, 90, 0});  // from starboard of the runway
    EXPECT_NEAR(flight.getFrame().windspeed.x, 0, 1e-12);
    EXPECT_NEAR(flight.getFrame().windspeed.z, 3, 1e-12);
}

TEST(DemoFlight, AFrameHasWhatTheScenePromises) {
    Flight flight;
    const Frame frame = flight.getFrame();
    EXPECT_EQ(frame.poses.size(), countParts(flight.getScene()));
    EXPECT_TRUE(frame.cut);
}

TEST(DemoControls, StayInTheirRangeAndCentre) {
    Flight flight;
    flight.setControl(Flight::ROLL, -7);
    flight.setControl(Flight::THROTTLE, 7);
    EXPECT_EQ(flight.getControl(Flight::ROLL), -1);
    EXPECT_EQ(flight.getControl(Flight::THROTTLE), 1);
    EXPECT_THROW(flight.setControl(Flight::PITCH, std::nan("")), std::invalid_argument);
    flight.centreControls();
    EXPECT_EQ(flight.getControl(Flight::ROLL), 0);
    EXPECT_EQ(flight.getControl(Flight::THROTTLE), 1) << "the throttle stays";
    flight.startOver();
    EXPECT_EQ(flight.getControl(Flight::THROTTLE), 0);
}
