#include "picture/stage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "flightsim/flight.h"
#include "sailboat/sailing.h"

using namespace demo;
using sailboat::Sailing;
using namespace flightsim;

namespace {

/// The middle of what is red on the picture, in pixels; or nothing if there is no red.
std::optional<ScreenPoint> findRed(const Image &image) {
    ScreenPoint sum;
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
    return ScreenPoint{sum.x / count, sum.y / count};
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
            Stage stage(flight.getScene());
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
        Stage stage(sailing.getScene());
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

namespace {

/// A red square across Z, one metre wide, in space.
Scene makeFlatScene(bool leavesTrail) {
    Scene scene;
    scene.surroundings.terrain = Terrain::SPACE;
    scene.cameras.viewpoints = {Viewpoint::PLANE};
    const std::vector<Vector3> corners{{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
    scene.bodies = {{{{"square", {{corners, {220, 10, 10}}}, false}}, leavesTrail, false}};
    return scene;
}

Frame frameAt(const std::vector<Vector3> &places) {
    Frame frame;
    for (const Vector3 &place : places) frame.poses.push_back({place, Quaternion()});
    return frame;
}

}  // namespace

TEST(DemoStage, ThePlaneIsSeenFlatWithXToTheRightAndYUp) {
    const Scene scene = makeFlatScene(false);
    Stage stage(scene);
    Canvas canvas;
    stage.draw(canvas, 100, 50, frameAt({{7, -30, 0}}), 0);  // below where a ground would be
    real x[3], y[3];
    ASSERT_TRUE(canvas.view().project({7, -30, 0}, x[0], y[0]));
    ASSERT_TRUE(canvas.view().project({8, -30, 0}, x[1], y[1]));
    ASSERT_TRUE(canvas.view().project({8, -30, -1}, x[2], y[2]));
    EXPECT_NEAR(x[0], 50, 1e-6);
    EXPECT_GT(x[1], x[0] + 5);
    EXPECT_NEAR(y[1], y[0], 1e-6);
    EXPECT_NEAR(x[2], x[1], 0.2) << "depth hardly shows";
    EXPECT_TRUE(findRed(canvas.image()));
}

TEST(DemoStage, ATrailShowsWhereABodyCameFromUntilACut) {
    const Scene with = makeFlatScene(true), without = makeFlatScene(false);
    const auto drawn = [](const Scene &scene, bool cut) {
        Stage stage(scene);
        Canvas canvas;
        for (int n = 0; n <= 20; ++n) {
            Frame frame = frameAt({{0.1 * n, 0, 0}});
            frame.cut = cut && n == 20;
            stage.draw(canvas, 100, 50, frame, 0.1);
        }
        return canvas.image();
    };
    const auto differing = [](const Image &a, const Image &b) {
        int count = 0;
        for (std::size_t n = 0; n < a.pixels.size(); ++n) count += a.pixels[n] != b.pixels[n];
        return count;
    };
    EXPECT_GT(differing(drawn(with, false), drawn(without, false)), 10);
    EXPECT_EQ(differing(drawn(with, true), drawn(without, true)), 0);
}

TEST(DemoStage, ATrailGrowsWithoutDrawingToo) {
    const Scene scene = makeFlatScene(true);
    Stage drawn(scene), followed(scene);
    Canvas onDrawn, onFollowed;
    for (int n = 0; n <= 20; ++n) {
        drawn.draw(onDrawn, 100, 50, frameAt({{0.1 * n, 0, 0}}), 0.1);
        if (n < 20) followed.follow(frameAt({{0.1 * n, 0, 0}}));
    }
    followed.draw(onFollowed, 100, 50, frameAt({{2, 0, 0}}), 0.1);
    EXPECT_EQ(onFollowed.image().pixels, onDrawn.image().pixels);
}

/// The sun stands behind the plane: lit by it, what faces the viewer would be dim.
TEST(DemoStage, ThePlaneIsSeenInItsOwnColours) {
    Scene scene = makeFlatScene(false);
    scene.cameras.viewpoints = {Viewpoint::PLANE, Viewpoint::SPECTATOR};
    Stage stage(scene);
    Canvas canvas;
    const Colour red{220, 10, 10};
    const auto showsRed = [&] {
        stage.draw(canvas, 100, 50, frameAt({{0, 0, 0}}), 0);
        const std::vector<Colour> &pixels = canvas.image().pixels;
        return std::count(pixels.begin(), pixels.end(), red) > 0;
    };
    EXPECT_TRUE(showsRed());
    stage.nextViewpoint();
    EXPECT_FALSE(showsRed());
}

TEST(DemoStage, TheNextViewpointIsTheScenesNextAndThenTheFirst) {
    Scene scene = makeFlatScene(false);
    scene.cameras.viewpoints = {Viewpoint::PLANE, Viewpoint::CHASE};
    Stage stage(scene);
    EXPECT_EQ(stage.viewpoint, Viewpoint::PLANE);
    stage.nextViewpoint();
    EXPECT_EQ(stage.viewpoint, Viewpoint::CHASE);
    stage.nextViewpoint();
    EXPECT_EQ(stage.viewpoint, Viewpoint::PLANE);
}

TEST(DemoStage, ASpectatorWhoFollowsIsNotLeftBelow) {
    Flight flight;
    Scene scene = flight.getScene();
    scene.cameras.spectatorFollows = true;
    flight.getAircraft().launch(Vector3(100, 200, 0));
    Stage stage(scene);
    stage.viewpoint = Viewpoint::SPECTATOR;
    Canvas canvas;
    stage.draw(canvas, 60, 30, flight.getFrame(), 0);
    const Image image = canvas.image();
    const Colour bottom = image.pixels[static_cast<std::size_t>(59 * image.width)];
    EXPECT_GT(bottom.green, bottom.blue) << "there is land below it, not only sky";
}
