#include "sailboat/helmsman.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

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
        boat.swingBoom(STEP);
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
            sea.boat.swingBoom(STEP);
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

/// A boat at these angles to the wind (degrees), one after the other, a second each, her boom to leeward,
/// so far (m) to leeward of the mark; what the skipper tells of it.
std::vector<std::string> reportsOn(const std::vector<real> &windAngles, real fromMark = 500,
                                   bool capsized = false) {
    Becalmed sea(6, 0);
    sailboat::Skipper skipper({{"near", 0, 0}});
    for (const real angle : windAngles) {
        sea.boat.launch(fromMark, 0, -angle * DEGREE, 3);
        sea.boat.setSheet(60 * DEGREE);
        sea.boat.swingBoom(10);
        if (capsized)
            sea.boat.getBody().setOrientation(
                sea.boat.getBody().getOrientation() *
                cyclone::Quaternion::fromAxisAngle(Vector3::X, cyclone::REAL_PI));
        skipper.watch(sea.boat, sea.windspeed, 1);
    }
    return skipper.takeReports();
}

TEST(Skipper, TellsOfEachTackGybeAndFailedTackOnce) {
    using Reports = std::vector<std::string>;
    EXPECT_EQ(reportsOn({50, 20, 3, -4, -20, -50, -60}), Reports{"tacked"});
    // Through the wind's eye and back, twice, before she falls off on the tack she came from.
    EXPECT_EQ(reportsOn({50, 10, -15, 12, -10, 20, 45, 60}), Reports{"missed the tack"});
    EXPECT_EQ(reportsOn({50, 10, -15, 12, -10, -20, -45, -60}), Reports{"tacked"});
    EXPECT_EQ(reportsOn({120, 150, 175, -170, -120}), Reports{"gybed"});
    EXPECT_EQ(reportsOn({60, 30, 5, 30, 60}), Reports{});
}

TEST(Skipper, RoundsNoMarkUpsideDown) {
    EXPECT_EQ(reportsOn({90}, 0, true), std::vector<std::string>{});
    EXPECT_EQ(reportsOn({90}, 0, false), std::vector<std::string>{"rounded the near mark"});
}

}  // namespace
