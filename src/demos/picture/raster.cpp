#include "picture/raster.h"

#include <algorithm>
#include <cmath>

namespace demo {

void Raster::reset(int width, int height) {
    width_ = std::max(width, 0);
    height_ = std::max(height, 0);
    const auto count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    samples_.assign(count * SAMPLES * SAMPLES, Sample());
}

namespace {

/// The first sample whose middle is at or beyond a pixel coordinate, at most `end`.
int firstSample(real position, int end) {
    return static_cast<int>(
        std::clamp(std::ceil(position * Raster::SAMPLES - 0.5), 0.0, static_cast<real>(end)));
}

/// Where the edge from a to b crosses the height y. Neighbours that share the edge get the same bits,
/// whichever way round they have it, so that there is neither a gap nor an overlap between them.
real crossing(ScreenPoint a, ScreenPoint b, real y) {
    if (a.y > b.y) std::swap(a, b);
    return a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
}

bool isFinite(const ScreenPoint &spot) { return std::isfinite(spot.x) && std::isfinite(spot.y); }

}  // namespace

template <typename Visit>
void Raster::forEachWithin(const std::vector<ScreenPoint> &corners, Visit visit) {
    if (corners.size() < 3 || !std::all_of(corners.begin(), corners.end(), isFinite)) return;
    const auto higher = [](const ScreenPoint &a, const ScreenPoint &b) { return a.y < b.y; };
    const auto [top, bottom] = std::minmax_element(corners.begin(), corners.end(), higher);
    const int endRow = firstSample(bottom->y, height_ * SAMPLES);
    for (int row = firstSample(top->y, height_ * SAMPLES); row < endRow; ++row) {
        const real y = middle(row);
        real left = cyclone::REAL_MAX, right = -cyclone::REAL_MAX;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const ScreenPoint &a = corners[i], &b = corners[i + 1 == corners.size() ? 0 : i + 1];
            if ((a.y <= y) == (b.y <= y)) continue;
            const real x = crossing(a, b, y);
            left = std::min(left, x);
            right = std::max(right, x);
        }
        const int endColumn = firstSample(right, width_ * SAMPLES);
        for (int column = firstSample(left, width_ * SAMPLES); column < endColumn; ++column)
            visit(samples_[index(column, row)], middle(column), y);
    }
}

void Raster::fill(const std::vector<ScreenPoint> &corners, const InverseDepth &inverseDepth, Colour colour,
                  real opacity) {
    forEachWithin(corners, [&](Sample &sample, real x, real y) {
        const auto near = static_cast<float>(inverseDepth.at(x, y));
        if (!(near > sample.inverseDepth)) return;
        if (opacity < 1)
            sample.colour = mix(sample.colour, colour, opacity);
        else
            sample = {near, colour, Kind::SOLID};
    });
}

void Raster::fillOnGround(const std::vector<ScreenPoint> &corners, Colour colour, real opacity,
                          bool asShadow) {
    forEachWithin(corners, [&](Sample &sample, real, real) {
        if (sample.kind != Kind::GROUND) return;
        sample.colour = mix(sample.colour, colour, opacity);
        if (asShadow) sample.kind = Kind::SHADED_GROUND;
    });
}

Colour Raster::pixel(int x, int y) const {
    int red = 0, green = 0, blue = 0;
    for (int row = y * SAMPLES; row < (y + 1) * SAMPLES; ++row) {
        for (int column = x * SAMPLES; column < (x + 1) * SAMPLES; ++column) {
            const Colour colour = samples_[index(column, row)].colour;
            red += colour.red;
            green += colour.green;
            blue += colour.blue;
        }
    }
    constexpr int COUNT = SAMPLES * SAMPLES;
    const auto mean = [](int sum) { return static_cast<unsigned char>((sum + COUNT / 2) / COUNT); };
    return {mean(red), mean(green), mean(blue)};
}

Colour mix(Colour a, Colour b, real share) {
    const real s = std::clamp(share, 0.0, 1.0);
    const auto between = [s](unsigned char from, unsigned char to) {
        return static_cast<unsigned char>(from + (to - from) * s + 0.5);
    };
    return {between(a.red, b.red), between(a.green, b.green), between(a.blue, b.blue)};
}

}  // namespace demo
