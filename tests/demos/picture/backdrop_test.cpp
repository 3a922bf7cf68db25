#include "picture/backdrop.h"

#include <gtest/gtest.h>

#include <cmath>

#include "picture.h"

using namespace demo;
using namespace demo_test;

namespace {

Image seaAt(real time, const std::vector<cyclone::Waves::Train> &waves) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, {Vector3(0, 6, 0), Vector3(20, 0, 5)});
    canvas.draw(Surroundings{Terrain::SEA, waves}, time);
    return canvas.image();
}

TEST(DemoBackdrop, TheHorizonIsWhereTheCamerasPitchPutsIt) {
    for (Terrain terrain : {Terrain::LAND, Terrain::SEA})
        for (real pitch : {0.0, 0.2, -0.3}) {
            Canvas canvas;
            const Camera camera{Vector3(0, 2, 0), Vector3(std::cos(pitch), 2 + std::sin(pitch), 0), 1};
            canvas.begin(COLUMNS, ROWS, camera);
            canvas.draw(Surroundings{terrain, {}}, 0);
            const Image image = canvas.image();
            // The strongest step from light to dark.
            int strongest = 0, row = 0;
            for (int y = 1; y < 60; ++y) {
                const int step = brightness(pixel(image, 30, y - 1)) - brightness(pixel(image, 30, y));
                if (step > strongest) {
                    strongest = step;
                    row = y;
                }
            }
            EXPECT_NEAR(row, 30 + 30 / std::tan(0.5) * std::tan(pitch), 1) << pitch;
            EXPECT_GT(strongest, 40);
        }
}

TEST(DemoBackdrop, LookingUpThereIsOnlySkyAndLookingDownOnlyGround) {
    const auto mean = [](const Camera &camera) {
        Canvas canvas;
        canvas.begin(COLUMNS, ROWS, camera);
        canvas.draw(Surroundings(), 0);
        long green = 0, blue = 0;
        for (const Colour &colour : canvas.image().pixels) {
            green += colour.green;
            blue += colour.blue;
        }
        return blue - green;
    };
    EXPECT_GT(mean({Vector3(0, 5, 0), Vector3(0, 50, 0)}), 0);
    EXPECT_LT(mean({Vector3(0, 5, 0), Vector3()}), 0);
}

TEST(DemoBackdrop, GridLinesLieTenMetresApart) {
    Canvas canvas;
    canvas.begin(4 * COLUMNS, 4 * ROWS, {Vector3(15, 30, 15), Vector3(15, 0, 15)});
    canvas.draw(Surroundings(), 0);
    const auto sumAlong = [&](real x) {
        int sum = 0;
        for (real z = 11; z < 19; z += 0.5) sum += brightness(pixelAt(canvas, {x, 0, z}));
        return sum;
    };
    for (real line : {10.0, 20.0}) {
        EXPECT_GT(sumAlong(line), sumAlong(line - 0.4) + 300);
        EXPECT_GT(sumAlong(line), sumAlong(line + 0.4) + 300);
    }
    EXPECT_NEAR(sumAlong(15), sumAlong(14.6), 100) << "none between them";
}

TEST(DemoBackdrop, EveryPixelShowsTheMeanOfWhatItCovers) {
    // The predictor: the same view in pixels of an eighth of the size, averaged.
    constexpr int FINER = 8;
    Canvas canvas, fine;
    const Camera camera{Vector3(3, 4, 7), Vector3(20, 2, 12), 0.8};
    canvas.begin(COLUMNS, ROWS, camera);
    canvas.draw(Surroundings(), 0);
    fine.begin(FINER * COLUMNS, FINER * ROWS, camera);
    fine.draw(Surroundings(), 0);
    const Image coarse = canvas.image(), detail = fine.image();
    real sumOfSquares = 0;
    for (int y = 0; y < coarse.height; ++y)
        for (int x = 0; x < coarse.width; ++x) {
            real mean = 0;
            for (int i = 0; i < FINER * FINER; ++i)
                mean += detail
                            .pixels[static_cast<std::size_t>((FINER * y + i / FINER) * detail.width +
                                                             FINER * x + i % FINER)]
                            .green;
            const real difference =
                coarse.pixels[static_cast<std::size_t>(y * coarse.width + x)].green - mean / (FINER * FINER);
            EXPECT_NEAR(difference, 0, 12) << x << ", " << y;
            sumOfSquares += difference * difference;
        }
    EXPECT_LT(std::sqrt(sumOfSquares / (coarse.width * coarse.height)), 2.5);
}

TEST(DemoBackdrop, TheGroundHidesWhatIsBelowIt) {
    for (Terrain terrain : {Terrain::LAND, Terrain::SEA}) {
        Canvas canvas;
        canvas.begin(COLUMNS, ROWS, {Vector3(0, 10, 0), Vector3(10, 0, 0)});
        canvas.draw(Surroundings{terrain, {}}, 0);
        canvas.draw(tile(0.5, RED), {Vector3(10, 0.3, -2), Quaternion()});
        canvas.draw(tile(0.5, RED), {Vector3(10, -0.3, 2), Quaternion()});
        EXPECT_TRUE(isReddish(pixelAt(canvas, {10, 0.3, -2})));
        EXPECT_FALSE(isReddish(pixelAt(canvas, {10, -0.3, 2})));
    }
}

TEST(DemoBackdrop, WavesTravelAsInDeepWater) {
    // The period of 10 m waves is √(2π·10 m/g) (Lamb, Hydrodynamics, art. 229).
    const std::vector<cyclone::Waves::Train> waves{{0.4, 10, 0.5, 0}};
    const real period = std::sqrt(2 * cyclone::REAL_PI * 10 / 9.81);
    EXPECT_GT(largestDifference(seaAt(0, waves), seaAt(0, {})), 20);
    EXPECT_GT(largestDifference(seaAt(0, waves), seaAt(period / 2, waves)), 20);
    EXPECT_LE(largestDifference(seaAt(0, waves), seaAt(period, waves)), 1);
}

TEST(DemoBackdrop, WavesStandWhereTheirEquationSays) {
    // At t = 0 with phase π/2, crests of this train lie at x = 0, 20, … and troughs at x = 10, 30, …
    const Surroundings sea{Terrain::SEA, {{1, 20, 0, cyclone::REAL_PI / 2}}};
    const auto showsAt = [&](real x, real height) {
        Canvas canvas;
        canvas.begin(COLUMNS, ROWS, {Vector3(x - 12, 7, -5), Vector3(x, 0, 3)});
        canvas.draw(sea, 0);
        canvas.draw(tile(0.4, RED), {Vector3(x, height, 3), Quaternion()});
        return isReddish(pixelAt(canvas, {x, height, 3}));
    };
    EXPECT_TRUE(showsAt(20, 1.15));
    EXPECT_FALSE(showsAt(20, 0.85));
    EXPECT_TRUE(showsAt(10, -0.85));
    EXPECT_FALSE(showsAt(10, -1.15));
}

TEST(DemoBackdrop, SpaceIsDarkAllOver) {
    Canvas canvas;
    canvas.begin(COLUMNS, ROWS, {Vector3(0, 2, 0), Vector3(10, 0, 0)});
    canvas.draw(Surroundings{Terrain::SPACE, {}}, 0);
    const Image image = canvas.image();
    EXPECT_LT(brightness(pixel(image, 0, 0)), 100);
    for (const Colour colour : image.pixels) EXPECT_EQ(colour, image.pixels.front());
}

TEST(DemoBackdrop, AnEyeBelowTheSurfaceSeesAsFromJustAboveIt) {
    for (Terrain terrain : {Terrain::LAND, Terrain::SEA}) {
        const auto seenFrom = [terrain](real height) {
            Canvas canvas;
            canvas.begin(COLUMNS, ROWS, {Vector3(0, height, 0), Vector3(10, height, 0)});
            canvas.draw(Surroundings{terrain, {}}, 0);
            return canvas.image();
        };
        EXPECT_EQ(largestDifference(seenFrom(-3), seenFrom(0.05)), 0);
        EXPECT_GT(largestDifference(seenFrom(-3), seenFrom(1)), 0);
    }
}

}  // namespace
