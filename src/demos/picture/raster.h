#pragma once

/// Pixels with depth: the part of the drawing that knows nothing of a world.
#include <cstddef>
#include <vector>

#include "picture/scene.h"

namespace demo {

/// What a sample shows. Only bare ground takes paint and shadows, and a shadow is cast but once.
enum class Kind : unsigned char { SKY, GROUND, SHADED_GROUND, SOLID };

/// A position in the picture, in pixels from the top left corner.
struct ScreenPoint {
    real x = 0, y = 0;
};

/// 1/z over the picture, with z the distance (m) along the line of sight: linear for every plane. 0 is
/// infinitely far.
struct InverseDepth {
    real perX = 0, perY = 0, atOrigin = 0;
    real at(real x, real y) const { return perX * x + perY * y + atOrigin; }
};

/// A picture of width × height pixels, each made of 2 × 2 samples with a depth of their own, so that edges
/// are smooth.
class Raster {
public:
    static constexpr int SAMPLES = 2;  ///< per pixel, across and down

    /// Empties it, to black sky; a negative size counts as 0.
    void reset(int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }

    /// Fills a convex polygon, either way round, wherever it is nearer than what is there. Corners may lie
    /// anywhere outside the picture; one that is not finite leaves the picture as it is. With an opacity
    /// below 1 the colour is mixed into what is there, which keeps its depth.
    void fill(const std::vector<ScreenPoint> &corners, const InverseDepth &inverseDepth, Colour colour,
              real opacity = 1);

    /// Mixes a colour into the ground within a convex polygon. As a shadow it counts once for every sample,
    /// however many polygons overlap.
    void fillOnGround(const std::vector<ScreenPoint> &corners, Colour colour, real opacity, bool asShadow);

    /// One sample, of 2·width × 2·height; its middle is at pixel position ((column + ½)/2, (row + ½)/2).
    void setSample(int column, int row, Kind kind, real inverseDepth, Colour colour) {
        samples_[index(column, row)] = {static_cast<float>(inverseDepth), colour, kind};
    }
    static real middle(int sample) { return (sample + 0.5) / SAMPLES; }

    /// The mean of a pixel's samples.
    Colour pixel(int x, int y) const;

private:
    struct Sample {
        float inverseDepth = 0;
        Colour colour;
        Kind kind = Kind::SKY;
    };

    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_ * SAMPLES) +
               static_cast<std::size_t>(column);
    }

    /// Calls visit(sample, x, y) for every sample whose middle lies within the polygon.
    template <typename Visit>
    void forEachWithin(const std::vector<ScreenPoint> &corners, Visit visit);

    int width_ = 0, height_ = 0;
    std::vector<Sample> samples_;
};

/// a where share is 0, b where it is 1.
Colour mix(Colour a, Colour b, real share);

}  // namespace demo
