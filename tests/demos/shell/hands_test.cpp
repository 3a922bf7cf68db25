#include "shell/hands.h"

#include <gtest/gtest.h>

#include "flightsim/flight.h"

using namespace demo;
using namespace flightsim;

TEST(DemoHands, AStrokeMovesItsControlOnly) {
    Flight flight;
    Hands hands(flight);
    hands.stroke('s');
    hands.stroke('s');
    hands.stroke('w');
    hands.stroke('+');
    EXPECT_NEAR(flight.getControl(Flight::PITCH), 0.1, 1e-12);
    EXPECT_NEAR(flight.getControl(Flight::THROTTLE), 0.1, 1e-12);
    EXPECT_EQ(flight.getControl(Flight::ROLL), 0);
    hands.stroke('x');
    EXPECT_EQ(flight.getControl(Flight::PITCH), 0);
    EXPECT_NE(flight.getControl(Flight::THROTTLE), 0);
}

TEST(DemoHands, KnowTheKeysOfTheControlsAndTheCentringKey) {
    Flight flight;
    const Hands hands(flight);
    for (const Key key : {U'w', U's', U'a', U'd', U'q', U'e', U'+', U'-', U'x'})
        EXPECT_TRUE(hands.knows(key));
    EXPECT_FALSE(hands.knows('k'));
    EXPECT_FALSE(hands.knows(keys::UP));
}

TEST(DemoHands, SticksStayUnlessTheyAreToSpringBack) {
    Flight flight;
    Hands hands(flight);
    for (int n = 0; n < 5; ++n) hands.stroke('d');
    hands.stroke('+');
    hands.advance(10);
    EXPECT_NEAR(flight.getControl(Flight::ROLL), 0.5, 1e-12);

    hands.springBack = true;
    hands.stroke('d');
    hands.advance(0.3);
    EXPECT_NEAR(flight.getControl(Flight::ROLL), 0.6, 1e-12) << "the key may be held: its repeats come later";
    for (int n = 0; n < 30; ++n) hands.advance(0.01);
    const real onTheWay = flight.getControl(Flight::ROLL);
    EXPECT_GT(onTheWay, 0);
    EXPECT_LT(onTheWay, 0.6);
    for (int n = 0; n < 100; ++n) hands.advance(0.01);
    EXPECT_EQ(flight.getControl(Flight::ROLL), 0);
    EXPECT_NEAR(flight.getControl(Flight::THROTTLE), 0.1, 1e-12) << "a lever stays";
}
