#include "base/text.h"

#include <gtest/gtest.h>

#include <locale>

using namespace demo;

namespace {

constexpr real DEGREE = cyclone::REAL_PI / 180;

struct CommaForPoint : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
};

}  // namespace

TEST(DemoText, RoundsAndKeepsNoSignOnAZero) {
    EXPECT_EQ(fixed(2.345, 1), "2.3");
    EXPECT_EQ(fixed(-2.36, 1), "-2.4");
    EXPECT_EQ(fixed(-0.04, 1), "0.0");
    EXPECT_EQ(fixed(-0.4, 0), "0");
    EXPECT_EQ(fixed(-10, 0), "-10");
    EXPECT_EQ(signedFixed(0.25, 2), "+0.25");
    EXPECT_EQ(signedFixed(-0.25, 2), "-0.25");
    EXPECT_EQ(signedFixed(-0.001, 2), "+0.00");
}

TEST(DemoText, CompassDirectionsGoFrom0To359) {
    EXPECT_EQ(compassText(0), "000");
    EXPECT_EQ(compassText(7 * DEGREE), "007");
    EXPECT_EQ(compassText(-1 * DEGREE), "359");
    EXPECT_EQ(compassText(359.7 * DEGREE), "000");
    EXPECT_EQ(compassText(-0.3 * DEGREE), "000");
    EXPECT_NEAR(compassDegrees(-90 * DEGREE), 270, 1e-12);
    EXPECT_NEAR(compassDegrees(450 * DEGREE), 90, 1e-12);
}

TEST(DemoText, IsTheSameInEveryLocale) {
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaForPoint));
    EXPECT_EQ(fixed(1.5, 1), "1.5");
    std::locale::global(before);
}

TEST(DemoText, ShortestComesBackToTheLastBitWithoutExponentsForUsualNumbers) {
    for (const real value : {20.0, 1.0 / 3, 0.1 + 0.2, -123456.0, 5e-324, 1e300, 0.0, 100.25})
        EXPECT_EQ(readNumber(shortest(value)), value) << shortest(value);
    EXPECT_EQ(shortest(20), "20");
    EXPECT_EQ(shortest(-123456), "-123456");
    EXPECT_EQ(shortest(0.3), "0.3");
}

TEST(DemoText, ReadsWholeFiniteDecimalNumbersOnly) {
    EXPECT_EQ(readNumber("-2.5"), -2.5);
    EXPECT_EQ(readNumber("1e-3"), 0.001);
    for (const char *text : {"", " 1", "1 ", "1x", "0x10", "inf", "nan", "1e999", "."})
        EXPECT_FALSE(readNumber(text)) << text;
}

TEST(DemoText, AnglesHaveASideUnlessTheyShowAsNought) {
    EXPECT_EQ(sided(-12.4 * DEGREE), "12P");
    EXPECT_EQ(sided(100 * DEGREE), "100S");
    EXPECT_EQ(sided(-0.4 * DEGREE), "0");
}

TEST(DemoText, CountsOneAndMany) {
    EXPECT_EQ(counted(1, "tack"), "1 tack");
    EXPECT_EQ(counted(0, "tack"), "0 tacks");
    EXPECT_EQ(counted(12, "jump"), "12 jumps");
}
