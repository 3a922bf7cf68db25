#include "shell/layout.h"

#include <gtest/gtest.h>

using namespace demo;

using Lines = std::vector<std::string>;

TEST(DemoLayout, AShortLineStaysWhole) {
    EXPECT_EQ(broken("ALT 3  SPD 8", 12), Lines{"ALT 3  SPD 8"});
    EXPECT_EQ(broken("", 12), Lines{""});
}

TEST(DemoLayout, AnInstrumentStaysWithItsNumber) {
    EXPECT_EQ(broken("ALT 3  SPD 8  WIND 1/020", 12), (Lines{"ALT 3  SPD 8", "WIND 1/020"}));
    EXPECT_EQ(broken("ALT 3  SPD 8  WIND 1/020", 13), (Lines{"ALT 3  SPD 8", "WIND 1/020"}));
    EXPECT_EQ(broken("ALT 3  SPD 8  WIND 1/020", 11), (Lines{"ALT 3", "SPD 8", "WIND 1/020"}));
}

TEST(DemoLayout, ASentenceBreaksBetweenWordsAndALongWordWhereTheScreenEnds) {
    EXPECT_EQ(broken("touched down at 3 m/s", 12), (Lines{"touched down", "at 3 m/s"}));
    EXPECT_EQ(broken("abcdefgh", 3), (Lines{"abc", "def", "gh"}));
    EXPECT_EQ(broken("ab", 0), (Lines{"a", "b"}));
}

TEST(DemoLayout, ItCountsCharactersNotBytes) {
    EXPECT_EQ(broken("20° 30°", 7), Lines{"20° 30°"});
    EXPECT_EQ(broken("20° 30°", 6), (Lines{"20°", "30°"}));
}

TEST(DemoLayout, WhatAKeyDoesGoesOnBelowItself) {
    const auto pages = paginated({"C    camera: chase, side"}, 14, 10);
    ASSERT_EQ(pages.size(), 1u);
    EXPECT_EQ(pages[0], (Lines{"C    camera:", "     chase,", "     side"}));
}

TEST(DemoLayout, HelpThatIsTooLongGoesOnOnTheNextPage) {
    const auto pages = paginated({"a", "b", "", "c", "d"}, 20, 2);
    ASSERT_EQ(pages.size(), 2u);
    EXPECT_EQ(pages[0], (Lines{"a", "b"}));
    EXPECT_EQ(pages[1], (Lines{"c", "d"})) << "no page begins with an empty line";
    EXPECT_EQ(paginated({"a", "b"}, 20, 0).size(), 2u);
    EXPECT_EQ(paginated({}, 20, 5).size(), 1u);
}
