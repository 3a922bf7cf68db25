#pragma once

/// Small pictures and what the tests of the drawing ask about them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "picture/canvas.h"

namespace demo_test {

using namespace demo;

inline constexpr int COLUMNS = 60, ROWS = 30;  // 60 × 60 pixels
inline constexpr Colour BLACK{0, 0, 0}, RED{220, 20, 10}, BLUE{20, 30, 230};

/// From the origin along +X, 90° high: at distance d the picture reaches from −d to d in y and z.
inline Camera alongX() { return {Vector3(), Vector3(1, 0, 0), cyclone::REAL_PI / 2}; }

/// A square across the line of sight, `halfSize` m, seen from its front by a camera that looks along +X.
inline Part square(real x, real halfSize, Colour colour) {
    const real h = halfSize;
    return {"square", {{{{x, -h, -h}, {x, -h, h}, {x, h, h}, {x, h, -h}}, colour}}, false};
}

/// A square that lies flat, its front upwards.
inline Part tile(real halfSize, Colour colour) {
    const real h = halfSize;
    return {"tile", {{{{-h, 0, -h}, {-h, 0, h}, {h, 0, h}, {h, 0, -h}}, colour}}, false};
}

inline Colour pixel(const Image &image, int x, int y) {
    return image.pixels.at(static_cast<std::size_t>(y * image.width + x));
}
inline Colour pixel(const Canvas &canvas, int x, int y) { return pixel(canvas.image(), x, y); }

inline Colour pixelAt(const Canvas &canvas, const Vector3 &point) {
    real x = 0, y = 0;
    EXPECT_TRUE(canvas.view().project(point, x, y));
    return pixel(canvas, static_cast<int>(x), static_cast<int>(y));
}

inline int brightness(Colour colour) { return colour.red + colour.green + colour.blue; }
inline bool isReddish(Colour colour) { return colour.red > 2 * colour.blue && colour.red > 50; }
inline bool isBluish(Colour colour) { return colour.blue > 2 * colour.red && colour.blue > 50; }

/// Pixels that are not black.
inline int drawnPixels(const Canvas &canvas) {
    int count = 0;
    for (const Colour &colour : canvas.image().pixels) count += colour != BLACK;
    return count;
}

inline int largestDifference(const Image &a, const Image &b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Colour p = a.pixels[i], q = b.pixels[i];
        for (int d : {p.red - q.red, p.green - q.green, p.blue - q.blue})
            largest = std::max(largest, std::abs(d));
    }
    return largest;
}

}  // namespace demo_test
