#include "shell/stage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "flightsim/flight.h"
#include "sailboat/sailing.h"

using namespace demo;

namespace {

/// The middle of what is red on the picture, in pixels; or nothing if there is no red.
std::optional<Spot> findRed(const Image &image) {
    Spot sum;
    int count = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Colour colour = image.pixels[static_cast<std::size_t>(y * image.width + x)];
            if (colour.red < 2 * colour.green || colour.red < 100) continue;
            sum.x += x;
            sum.y += y;
            ++count;
        }
    if (count == 0) return std::nullopt;
    return Spot{sum.x / count, sum.y / count};
}

}  // namespace

TEST(DemoStage, HalfWayBetweenTwoFramesIsHalfWay) {
    Frame a, b;
    a.time = 1;
    b.time = 2;
    a.poses = {{Vector3(0, 0, 0), Quaternion()}};
    b.poses = {{Vector3(2, 4, 6), Quaternion::fromAxisAngle(Vector3::Y, 1)}};
    a.windspeed = Vector3(1, 0, 0);
    b.windspeed = Vector3(3, 0, 0);
    const Frame half = interpolated(a, b, 0.5);
    EXPECT_EQ(half.time, 1.5);
    EXPECT_EQ(half.poses[0].position, Vector3(1, 2, 3));
    EXPECT_NEAR(half.poses[0].orientation.j, std::sin(0.25), 1e-12);
    EXPECT_EQ(half.windspeed, Vector3(2, 0, 0));
    EXPECT_EQ(interpolated(a, b, 1).poses[0].position, b.poses[0].position);
    b.cut = true;
    EXPECT_EQ(interpolated(a, b, 0.5).poses[0].position, b.poses[0].position);
}

TEST(DemoStage, EveryCameraSeesTheVehicleInTheMiddleWhereverItIs) {
    Flight flight;
    for (const Vector3 &place : {Vector3(0, 1, 0), Vector3(80, 15, -40), Vector3(-60, 40, 20)}) {
        flight.getAircraft().launch(place);
        for (const Viewpoint viewpoint : {Viewpoint::SPECTATOR, Viewpoint::CHASE, Viewpoint::SIDE}) {
            Stage stage(flight.getProfile());
            stage.viewpoint = viewpoint;
            stage.zoom = 2;
            Canvas canvas;
            stage.draw(canvas, 200, 50, flight.getFrame(), 0);
            const auto red = findRed(canvas.image());
            ASSERT_TRUE(red) << Stage::getName(viewpoint) << ' ' << place.x;
            EXPECT_NEAR(red->x, 100, 25) << Stage::getName(viewpoint);
            EXPECT_NEAR(red->y, 50, 25) << Stage::getName(viewpoint);
        }
    }
}

TEST(DemoStage, TheBoatFillsThePictureFromHullToMasthead) {
    Sailing sailing;
    const Vector3 place = sailing.getFrame().poses[0].position;
    for (const Viewpoint viewpoint : {Viewpoint::SPECTATOR, Viewpoint::CHASE, Viewpoint::SIDE}) {
        Stage stage(sailing.getProfile());
        stage.viewpoint = viewpoint;
        Canvas canvas;
        stage.draw(canvas, 200, 50, sailing.getFrame(), 0);
        real x = 0, keel = 0, masthead = 0;
        ASSERT_TRUE(canvas.view().project(place - Vector3::UP, x, keel));
        ASSERT_TRUE(canvas.view().project(place + Vector3::UP * 7.9, x, masthead));
        EXPECT_GT(masthead, 5) << Stage::getName(viewpoint);
        EXPECT_LT(keel, 95) << Stage::getName(viewpoint);
        EXPECT_GT(keel - masthead, 50) << Stage::getName(viewpoint);
    }
}
