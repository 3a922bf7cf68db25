#include "base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace demo;

TEST(DemoRandom, IsSplitMix64) {
    // The first numbers of the authors' reference implementation for the seed 1234567.
    Random random(1234567);
    EXPECT_EQ(random.next(), 6457827717110365317u);
    EXPECT_EQ(random.next(), 3203168211198807973u);
    EXPECT_EQ(random.next(), 9817491932198370423u);
}

TEST(DemoRandom, FillsItsRangeEvenly) {
    Random random(5);
    real sum = 0, squares = 0;
    const int count = 100000;
    for (int n = 0; n < count; ++n) {
        const real x = random.between(-1, 3);
        ASSERT_GE(x, -1);
        ASSERT_LT(x, 3);
        sum += x;
        squares += (x - 1) * (x - 1);
    }
    EXPECT_NEAR(sum / count, 1, 0.02);
    EXPECT_NEAR(squares / count, 16.0 / 12, 0.02);
}

TEST(DemoWind, HasTheMeanTheStrengthAndTheMemoryThatAreAskedFor) {
    const Vector3 mean(3, 0, -1);
    const real step = 1.0 / 60, memory = 0.5;
    Wind wind(mean, 0.8, memory, step, 11);
    EXPECT_EQ(wind.getWindspeed(), mean);
    Vector3 sum, squares;
    real lagged = 0;
    std::vector<real> history;
    const int count = 600000;
    for (int n = 0; n < count; ++n) {
        wind.advance();
        const Vector3 gust = wind.getWindspeed() - mean;
        sum += gust;
        squares += gust.componentProduct(gust);
        history.push_back(gust.x);
        // Two averages in a row: the correlation after a time t is (1 + t/memory)·exp(−t/memory).
        if (n >= 30) lagged += gust.x * history[static_cast<std::size_t>(n) - 30];
    }
    EXPECT_NEAR(std::sqrt(squares.x / count), 0.8, 0.03);
    EXPECT_NEAR(std::sqrt(squares.y / count), 0.4, 0.015);
    EXPECT_NEAR(std::sqrt(squares.z / count), 0.8, 0.03);
    EXPECT_NEAR(sum.magnitude() / count, 0, 0.03);
    EXPECT_NEAR(lagged / squares.x, 2 * std::exp(-1.0), 0.04);
}

TEST(DemoWind, WithoutGustsIsSteady) {
    Wind wind(Vector3(2, 0, 0), 0, 1, 0.01, 3);
    for (int n = 0; n < 100; ++n) wind.advance();
    EXPECT_EQ(wind.getWindspeed(), Vector3(2, 0, 0));
}
