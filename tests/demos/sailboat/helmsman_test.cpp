#include "sailboat/helmsman.h"

#include <gtest/gtest.h>

#include <string>

#include "sailboat/sailing.h"

namespace {

using cyclone::real;
using cyclone::Vector3;
using sailboat::Catamaran;
using sailboat::Helmsman;
using sailboat::Sailing;

constexpr real STEP = 1.0 / 60, DEGREE = cyclone::REAL_PI / 180;

/// A boat at rest on a calm sea, the wind from the north.
struct Becalmed {
    cyclone::World world;
    Vector3 windspeed;
    cyclone::Waves water;
    Catamaran boat;
    Helmsman helmsman;

    Becalmed(real wind, real heading) : windspeed(wind, 0, 0), boat(world, &windspeed, &water) {
        boat.launch(0, 0, heading);
    }
    void step() {
        helmsman.sail(boat, STEP);
        world.startFrame();
        world.runPhysics(STEP);
    }
};

TEST(Helmsman, GetsOutOfIronsWithin20SecondsInAnyWindFrom2MetresPerSecondOn) {
    for (const real wind : {2, 3, 4, 6, 8, 10})
        for (const real side : {-1, 1})
            for (const real heading : {-15, 0, 15}) {
                Becalmed sea(wind, heading * DEGREE);
                sea.helmsman.steerWindAngle(side * 50 * DEGREE);
                const auto sails = [&] {
                    return side * sea.boat.getTrueWindAngle() > 35 * DEGREE && sea.boat.getSpeed() > 0.5;
                };
                real time = 0;
                for (; time < 60 && !sails(); time += STEP) sea.step();
                EXPECT_LT(time, 20) << "wind " << wind << ", side " << side << ", heading " << heading;
                for (; time < 60; time += STEP) sea.step();
                EXPECT_EQ(sea.helmsman.getTimeInIrons(), 0) << "she sails on";
                EXPECT_NEAR(side * sea.boat.getTrueWindAngle(), 50 * DEGREE, 3 * DEGREE);
            }
}

TEST(Helmsman, LeavesABoatThatSailsAlone) {
    Becalmed sea(6, -60 * DEGREE);
    sea.helmsman.steerWindAngle(60 * DEGREE);
    for (int n = 0; n < 1800; ++n) {
        sea.step();
        ASSERT_EQ(sea.helmsman.getTimeInIrons(), 0);
    }
}

TEST(Skipper, SaysWhenThereIsTooLittleWindToGetOutOfIrons) {
    for (const real wind : {0.3, 3.0}) {
        Becalmed sea(wind, 0);
        sailboat::Skipper skipper({{"windward", 100, 0}});
        bool said = false;
        for (int n = 0; n < 60 * 60; ++n) {
            skipper.sail(sea.boat, STEP);
            sea.world.startFrame();
            sea.world.runPhysics(STEP);
            skipper.watch(sea.boat, sea.windspeed, STEP);
            for (const std::string &report : skipper.takeReports())
                said = said || report == "in irons: too little wind";
        }
        EXPECT_EQ(said, wind < 1) << wind;
    }
}

TEST(Skipper, NoTackFailsForLongerThan20Seconds) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Sailing sailing;
        sailing.begin(seed, {6, 0.8, 0.3});
        real slowSince = 0;
        while (sailing.getTime() < 300) {
            if (sailing.isOver()) sailing.startOver();
            sailing.steer();
            sailing.step();
            if (sailing.getBoat().getSpeed() > 1) slowSince = sailing.getTime();
            ASSERT_LT(sailing.getTime() - slowSince, 20) << "seed " << seed;
        }
    }
}

}  // namespace
