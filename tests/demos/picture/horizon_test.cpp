#include "picture/horizon.h"

#include <gtest/gtest.h>

using namespace demo;

namespace {

constexpr int WIDTH = 21, HEIGHT = 14;

/// Sky is bluer than earth.
bool isSky(const Image &image, int x, int y) {
    const Colour pixel = image.pixels[static_cast<std::size_t>(y * image.width + x)];
    return pixel.blue > pixel.red + 40;
}

int countSky(const Image &image) {
    int count = 0;
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x) count += isSky(image, x, y);
    return count;
}

}  // namespace

TEST(DemoHorizon, LevelFlightHasSkyAboveAndEarthBelow) {
    const Image image = paintHorizon(WIDTH, HEIGHT, Attitude());
    ASSERT_EQ(image.pixels.size(), static_cast<std::size_t>(WIDTH * HEIGHT));
    for (int x = 0; x < WIDTH; ++x) {
        EXPECT_TRUE(isSky(image, x, 0)) << x;
        EXPECT_FALSE(isSky(image, x, HEIGHT - 1)) << x;
    }
}

TEST(DemoHorizon, ABankToStarboardRaisesTheEarthOnTheRight) {
    const Image image = paintHorizon(WIDTH, HEIGHT, {0, 0.7});
    EXPECT_TRUE(isSky(image, 0, HEIGHT / 2));
    EXPECT_FALSE(isSky(image, WIDTH - 1, HEIGHT / 2));
    const Image other = paintHorizon(WIDTH, HEIGHT, {0, -0.7});
    EXPECT_FALSE(isSky(other, 0, HEIGHT / 2));
    EXPECT_TRUE(isSky(other, WIDTH - 1, HEIGHT / 2));
}

TEST(DemoHorizon, TheNoseUpShowsMoreSkyAndUpsideDownTheEarthIsAbove) {
    const int level = countSky(paintHorizon(WIDTH, HEIGHT, Attitude()));
    EXPECT_GT(countSky(paintHorizon(WIDTH, HEIGHT, {0.3, 0})), level + WIDTH);
    EXPECT_LT(countSky(paintHorizon(WIDTH, HEIGHT, {-0.3, 0})), level - WIDTH);
    const Image inverted = paintHorizon(WIDTH, HEIGHT, {0, cyclone::REAL_PI});
    EXPECT_FALSE(isSky(inverted, WIDTH / 2, 0));
    EXPECT_TRUE(isSky(inverted, WIDTH / 2, HEIGHT - 1));
}
