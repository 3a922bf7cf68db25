#include "picture/canvas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "picture.h"

using namespace demo;
using namespace demo_test;

namespace {

constexpr real NOT_A_NUMBER = std::numeric_limits<real>::quiet_NaN();

// ---- Solids

TEST(DemoCanvas, ASquareCoversExactlyItsPixels) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, alongX());
    canvas.draw(square(10, 5, RED), Pose());  // from a quarter to three quarters of the picture
    EXPECT_EQ(drawnPixels(canvas), 30 * 30);
    for (int edge : {15, 44}) EXPECT_NE(pixel(canvas, edge, edge), BLACK);
    for (int edge : {14, 45}) EXPECT_EQ(pixel(canvas, edge, 30), BLACK);
}

TEST(DemoCanvas, ThePoseMovesAndTurns) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, alongX());
    // A tile that faces up, turned to face −X and put ahead.
    const Pose pose{Vector3(10, 5, -5), Quaternion::fromAxisAngle(Vector3(0, 0, 1), cyclone::REAL_PI / 2)};
    canvas.draw(tile(2, RED), pose);
    EXPECT_NE(pixelAt(canvas, {10, 5, -5}), BLACK);
    EXPECT_NE(pixelAt(canvas, {10, 6.9, -6.9}), BLACK);
    EXPECT_EQ(drawnPixels(canvas), 12 * 12);
}

TEST(DemoCanvas, TheNearerHidesTheFartherInEitherOrder) {
    for (bool nearFirst : {true, false}) {
        Canvas canvas;
        canvas.begin(COLUMNS, ROWS, alongX());
        if (nearFirst) canvas.draw(square(5, 2, RED), Pose());
        canvas.draw(square(8, 6, BLUE), Pose());
        if (!nearFirst) canvas.draw(square(5, 2, RED), Pose());
        EXPECT_TRUE(isReddish(pixel(canvas, 30, 30)));
        EXPECT_TRUE(isBluish(pixel(canvas, 30, 12)));
    }
}

TEST(DemoCanvas, FacesThatCrossHideEachOtherInPart) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, alongX());
    canvas.draw(square(10, 5, RED), Pose());
    // Slanted: its left side is nearer than the square, its right side farther.
    const Part slanted{"slanted", {{{{6, -3, -3}, {14, -3, 3}, {14, 3, 3}, {6, 3, -3}}, BLUE}}, false};
    canvas.draw(slanted, Pose());
    EXPECT_TRUE(isBluish(pixelAt(canvas, {9, 0, -0.75})));
    EXPECT_TRUE(isReddish(pixelAt(canvas, {11, 0, 0.75})));
}

TEST(DemoCanvas, NeighbouringFacesLeaveNoGap) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, alongX());
    const Vector3 middle(10, 0.37, -0.71), a(10, -5, -5), b(10, -5, 5), c(10, 5, 5), d(10, 5, -5);
    Part fan{"fan", {}, false};
    for (const auto &corners :
         {std::vector<Vector3>{a, b, middle}, {b, c, middle}, {c, d, middle}, {d, a, middle}})
        fan.faces.push_back({corners, RED});
    canvas.draw(fan, Pose());
    EXPECT_EQ(drawnPixels(canvas), 30 * 30);
    const Image image = canvas.image();
    const Colour inside = pixel(image, 30, 30);
    for (int y = 15; y < 45; ++y)
        for (int x = 15; x < 45; ++x) EXPECT_EQ(pixel(image, x, y), inside) << x << ", " << y;
}

TEST(DemoCanvas, FacesSeenFromBehindAreDrawnOnlyIfTwoSided) {
    Part part = square(10, 5, RED);
    std::swap(part.faces[0].corners[1], part.faces[0].corners[3]);
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, alongX());
    canvas.draw(part, Pose());
    EXPECT_EQ(drawnPixels(canvas), 0);
    part.twoSided = true;
    canvas.draw(part, Pose());
    EXPECT_EQ(drawnPixels(canvas), 30 * 30);
}

TEST(DemoCanvas, WhatIsBehindTheCameraStaysOutOfThePicture) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, alongX());
    Part behind = square(-10, 5, RED);
    behind.twoSided = true;
    canvas.draw(behind, Pose());
    canvas.drawLine({-5, -1, 0}, {-1, 1, 0}, RED);
    canvas.draw(Arrow{"", {-5, 0, 0}, {3, 0, 1}, RED});
    EXPECT_EQ(drawnPixels(canvas), 0);
}

TEST(DemoCanvas, AFloorThroughTheCameraEndsAtItsHorizon) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, alongX());
    canvas.draw(tile(1e4, RED), {Vector3(0, -1, 0), Quaternion()});
    const Image image = canvas.image();
    for (int x = 0; x < COLUMNS; ++x) {
        for (int y = 0; y < 30; ++y) EXPECT_EQ(pixel(image, x, y), BLACK);
        for (int y = 31; y < 60; ++y) EXPECT_TRUE(isReddish(pixel(image, x, y)));
    }
}

TEST(DemoCanvas, FacesAreBrighterTowardsTheSun) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, {Vector3(0, 20, 0), Vector3()});
    const auto shade = [&](real tilt) {  // about the axis that turns the tile away from the sun
        canvas.begin(COLUMNS, ROWS, {Vector3(0, 20, 0), Vector3()});
        const Vector3 axis = Canvas::sun() % Vector3::UP;
        canvas.draw(tile(5, {200, 200, 200}), {Vector3(), Quaternion::fromAxisAngle(axis, tilt)});
        return brightness(pixel(canvas, 30, 30));
    };
    const real towards = -std::acos(Canvas::sun().y);
    EXPECT_GT(shade(towards), shade(0));
    EXPECT_GT(shade(0), shade(0.5));
    EXPECT_GT(shade(0.5), shade(1.2));
    EXPECT_GT(shade(1.2), 150) << "never black";
}

// ---- Lines and arrows

TEST(DemoCanvas, LinesAreHiddenByWhatIsNearer) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, alongX());
    canvas.draw(square(10, 2.5, RED), Pose());
    canvas.drawLine({12, 0.1, -11}, {12, 0.1, 11}, BLUE, 3);
    EXPECT_TRUE(isReddish(pixel(canvas, 30, 29)));
    EXPECT_TRUE(isBluish(pixel(canvas, 5, 29)));
    canvas.drawLine({10, 0.1, -11}, {10, 0.1, 11}, BLUE, 3);
    EXPECT_TRUE(isBluish(pixel(canvas, 30, 29))) << "a line on a face is seen";
}

TEST(DemoCanvas, AnArrowReachesFromTailToTipAndIsWidestAtItsHead) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, alongX());
    canvas.draw(Arrow{"wind", {10, 0, -8}, {0, 0, 16}, RED});  // columns 6 to 54
    const auto widthAt = [&](int x) {
        int count = 0;
        for (int y = 0; y < 60; ++y) count += pixel(canvas, x, y) != BLACK;
        return count;
    };
    EXPECT_EQ(widthAt(4), 0);
    EXPECT_GE(widthAt(7), 1);
    EXPECT_GE(widthAt(48), widthAt(20) + 2);
    EXPECT_GE(widthAt(52), 1);
    EXPECT_EQ(widthAt(55), 0);
}

// ---- Shadows and marks

/// The ground from above with a tile's shadow on it; the tile itself is not drawn.
Canvas shadowOf(const std::vector<real> &heights) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, {Vector3(2, 30, 3), Vector3(2, 0, 3)});
    canvas.draw(Surroundings(), 0);
    for (real height : heights) canvas.drawShadow(tile(1.5, RED), {Vector3(2, height, 3), Quaternion()});
    return canvas;
}

TEST(DemoCanvas, TheShadowFallsAwayFromTheSun) {
    const Vector3 tileAt(2, 6, 3);
    const Vector3 shadowAt = tileAt - Canvas::sun() * (tileAt.y / Canvas::sun().y);
    const Canvas bare = shadowOf({}), shaded = shadowOf({tileAt.y});
    EXPECT_LT(brightness(pixelAt(shaded, shadowAt)), 0.7 * brightness(pixelAt(bare, shadowAt)));
    EXPECT_EQ(pixelAt(shaded, {2, 0, 3}), pixelAt(bare, {2, 0, 3})) << "right below, the sun shines";
    int darker = 0;
    const Image before = bare.image(), after = shaded.image();
    for (std::size_t i = 0; i < before.pixels.size(); ++i) darker += before.pixels[i] != after.pixels[i];
    const real side = 3 * bare.view().scale() / 30;  // 3 m seen from 30 m above, in pixels
    EXPECT_NEAR(darker, side * side, 4 * side);
}

TEST(DemoCanvas, OverlappingShadowsAreNoDarkerThanOne) {
    EXPECT_EQ(largestDifference(shadowOf({0.01}).image(), shadowOf({0.01, 0.01}).image()), 0);
    EXPECT_GT(largestDifference(shadowOf({}).image(), shadowOf({0.01}).image()), 20);
}

TEST(DemoCanvas, WhatIsBelowTheGroundCastsNoShadow) {
    EXPECT_EQ(largestDifference(shadowOf({}).image(), shadowOf({-2}).image()), 0);
}

TEST(DemoCanvas, ShadowsDontFallOnSolidsWhateverTheOrder) {
    const auto picture = [](bool shadowFirst) {
        Canvas canvas;
        canvas.begin(COLUMNS, ROWS, {Vector3(0, 30, 0), Vector3()});
        canvas.draw(Surroundings(), 0);
        if (shadowFirst) canvas.drawShadow(tile(2, RED), {Vector3(0, 0.5, 0), Quaternion()});
        canvas.draw(tile(2, RED), {Vector3(0, 0.5, 0), Quaternion()});
        if (!shadowFirst) canvas.drawShadow(tile(2, RED), {Vector3(0, 0.5, 0), Quaternion()});
        return canvas.image();
    };
    EXPECT_LE(largestDifference(picture(true), picture(false)), 80) << "but for mixed pixels at edges";
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, {Vector3(0, 30, 0), Vector3()});
    canvas.draw(Surroundings(), 0);
    canvas.draw(tile(2, RED), {Vector3(0, 0.5, 0), Quaternion()});
    const Colour before = pixel(canvas, 30, 30);
    canvas.drawShadow(tile(2, RED), {Vector3(0, 0.5, 0), Quaternion()});
    EXPECT_EQ(pixel(canvas, 30, 30), before);
}

TEST(DemoCanvas, MarksColourTheGroundAndTakeShadows) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, {Vector3(0, 30, 0), Vector3()});
    canvas.draw(Surroundings(), 0);
    canvas.drawOnGround(tile(5, {120, 120, 120}), {Vector3(0, 7, 0), Quaternion()});
    EXPECT_EQ(pixel(canvas, 30, 30), (Colour{120, 120, 120})) << "flat, whatever its height";
    canvas.drawShadow(tile(2, RED), {Vector3(0, 0.01, 0), Quaternion()});
    EXPECT_LT(brightness(pixel(canvas, 30, 30)), 250);
}

// ---- Cells and text

TEST(DemoCanvas, CellsAreThePixelsTwoByTwo) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, {Vector3(0, 3, 0), Vector3(10, 3, 0)});
    canvas.draw(Surroundings(), 0);
    const Image image = canvas.image();
    const CellGrid &cells = canvas.cells();
    ASSERT_EQ(cells.columns, COLUMNS);
    ASSERT_EQ(cells.rows, ROWS);
    ASSERT_EQ(image.width, COLUMNS);
    ASSERT_EQ(image.height, 2 * ROWS);
    for (int row = 0; row < ROWS; ++row)
        for (int column = 0; column < COLUMNS; ++column) {
            const Cell &cell = cells.at(column, row);
            const Colour upper = pixel(image, column, 2 * row), lower = pixel(image, column, 2 * row + 1);
            EXPECT_EQ(cell.background, lower);
            EXPECT_EQ(cell.glyph == U' ' ? cell.background : cell.foreground, upper);
            EXPECT_TRUE(cell.glyph == HALF_BLOCK || upper == lower);
        }
}

std::u32string rowOf(const CellGrid &cells, int row, int from, int count) {
    std::u32string text;
    for (int column = from; column < from + count; ++column) text += cells.at(column, row).glyph;
    return text;
}

TEST(DemoCanvas, TextStandsWhereItIsPrinted) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, alongX());
    canvas.draw(Surroundings(), 0);
    const Colour behind = canvas.cells().at(2, ROWS - 1).background;
    canvas.print(1, 0, "speed", RED);
    canvas.print(0, -1, "1 °C");
    canvas.print(-3, 4, "right edge");
    canvas.print(-2, -30, "x");
    const CellGrid &cells = canvas.cells();
    EXPECT_EQ(rowOf(cells, 0, 1, 5), U"speed");
    EXPECT_EQ(cells.at(1, 0).foreground, RED);
    EXPECT_EQ(rowOf(cells, ROWS - 1, 0, 4), U"1 °C");
    EXPECT_LT(brightness(cells.at(2, ROWS - 1).background), 0.6 * brightness(behind));
    EXPECT_EQ(rowOf(cells, 4, COLUMNS - 3, 3), U"rig");
    EXPECT_NE(cells.at(0, 5).glyph, U'h') << "cut off, not continued";
    EXPECT_EQ(cells.at(COLUMNS - 2, 0).glyph, U'x');
}

TEST(DemoCanvas, AnArrowsNameStandsBesideItsTailAwayFromItsTip) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, alongX());
    canvas.label(Arrow{"east", {10, 0, -7.9}, {0, 0, 16}, RED});    // from within column 6
    canvas.label(Arrow{"west", {10, 4.9, 8.1}, {0, 0, -16}, RED});  // from column 54, higher up
    canvas.label(Arrow{"behind", {-10, 0, -8}, {0, 0, 16}, RED});
    canvas.label(Arrow{"nowhere", {10, NOT_A_NUMBER, -8}, {0, 0, 16}, RED});
    canvas.label(Arrow{"outside", {10, 0, -11}, {0, 0, 16}, RED});
    const CellGrid &cells = canvas.cells();
    EXPECT_EQ(rowOf(cells, 15, 0, 7), U"  east ");
    EXPECT_EQ(rowOf(cells, 7, 53, 7), U"  west ");
    int letters = 0;
    for (const Cell &cell : cells.cells) letters += cell.glyph >= U'a' && cell.glyph <= U'z';
    EXPECT_EQ(letters, 8) << "and no others";
}

TEST(DemoCanvas, TextOutsideThePictureIsCutOff) {
    Canvas canvas;
    canvas.begin(10, 3, alongX());
    canvas.print(0, 3, "below");
    canvas.print(0, -4, "above");
    canvas.print(10, 1, "right");
    canvas.print(-12, 1, "abcd");
    const CellGrid &cells = canvas.cells();
    EXPECT_EQ(rowOf(cells, 1, 0, 2), U"cd");
    for (int row : {0, 2})
        for (int column = 0; column < 10; ++column) EXPECT_EQ(cells.at(column, row).glyph, U' ');
}

TEST(DemoCanvas, ABoxStandsInTheMiddle) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, alongX());
    canvas.draw(Surroundings(), 0);
    canvas.printBox({"Keys", "C  camera"});
    const CellGrid &cells = canvas.cells();
    EXPECT_EQ(rowOf(cells, 13, 23, 13), std::u32string(13, U' '));
    EXPECT_EQ(rowOf(cells, 14, 23, 13), U"  Keys       ");
    EXPECT_EQ(rowOf(cells, 15, 23, 13), U"  C  camera  ");
}

TEST(DemoCanvas, ANewFrameForgetsTheOldOne) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, alongX());
    canvas.draw(square(10, 5, RED), Pose());
    canvas.print(0, 0, "old");
    canvas.begin(COLUMNS, ROWS, alongX());
    EXPECT_EQ(drawnPixels(canvas), 0);
    EXPECT_EQ(canvas.cells().at(0, 0).glyph, U' ');
}

TEST(DemoCanvas, OneSeesThroughAGhost) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, alongX());
    canvas.draw(square(10, 10, BLUE), Pose());
    canvas.draw(square(5, 2, RED), Pose(), 0.5);
    canvas.draw(square(8, 1, RED), Pose());  // behind the ghost, which doesn't hide it
    const Colour mixed = pixelAt(canvas, {5, 1.5, 1.5}), solid = pixelAt(canvas, {8, 0, 0});
    EXPECT_GT(mixed.red, 50);
    EXPECT_GT(mixed.blue, 50);
    EXPECT_TRUE(isReddish(solid));
}

// ---- Degenerate input

TEST(DemoCanvas, PicturesOfAnySize) {
    for (int columns : {-1, 0, 1, 300})
        for (int rows : {-1, 0, 1, 5}) {
            Canvas canvas;
            canvas.begin(columns, rows, {Vector3(0, 3, 0), Vector3(10, 0, 0)});
            canvas.draw(Surroundings{Terrain::SEA, {{0.2, 5, 0, 0}}}, 1);
            canvas.draw(square(10, 5, RED), Pose());
            canvas.drawShadow(square(10, 5, RED), Pose());
            canvas.draw(Arrow{"", {5, 0, 0}, {0, 1, 0}, RED});
            canvas.print(0, 0, "text");
            canvas.printBox({"a box that is wider than the picture"});
            EXPECT_EQ(canvas.cells().columns, std::max(columns, 0));
            EXPECT_EQ(canvas.cells().rows, std::max(rows, 0));
        }
}

TEST(DemoCanvas, DegenerateShapesDrawNothing) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, alongX());
    Part odd{"odd", {{{}, RED}, {{{5, 0, 0}}, RED}, {{{5, 0, 0}, {5, 1, 0}}, RED}}, true};
    odd.faces.push_back({{{5, 0, 0}, {5, 1, 1}, {5, 2, 2}, {5, 3, 3}}, RED});  // no area
    odd.faces.push_back({{{1, 0, 0}, {5, 0, 0}, {5, 2, 0}}, RED});             // edge-on
    for (const Pose &pose : {Pose(), Pose{Vector3(NOT_A_NUMBER, 0, 0), Quaternion()},
                             Pose{Vector3(), Quaternion(HUGE_VAL, 0, 0, 0)}}) {
        canvas.draw(odd, pose);
        canvas.drawShadow(odd, pose);
        canvas.drawOnGround(odd, pose);
    }
    canvas.draw(square(NOT_A_NUMBER, 1, RED), Pose());
    canvas.draw(square(HUGE_VAL, 1, RED), Pose());
    canvas.drawLine({5, 0, 0}, {5, 0, 0}, RED);
    canvas.drawLine({5, NOT_A_NUMBER, 0}, {5, 1, 0}, RED);
    canvas.draw(Arrow{"", {5, 0, 0}, Vector3(), RED});
    canvas.draw(Arrow{"", {5, 0, 0}, {NOT_A_NUMBER, 0, 0}, RED});
    EXPECT_EQ(drawnPixels(canvas), 0);
}

}  // namespace
