#include "picture/backdrop.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace demo {

namespace {

constexpr Colour HORIZON{205, 222, 232}, ZENITH{58, 116, 186}, SUNLIGHT{255, 246, 214};
constexpr Colour GRASS{108, 148, 76}, DARK_GRASS{74, 114, 56}, GROUND_LINE{176, 190, 128},
    GROUND_HAZE{150, 176, 160};
constexpr Colour DEEP_WATER{14, 62, 96}, LIT_WATER{40, 128, 150}, SEA_LINE{130, 180, 190},
    SEA_HAZE{120, 165, 188};
constexpr Colour SPACE{12, 14, 24};
constexpr real LOWEST_EYE = 0.05;  // m above the surface

Colour skyColour(const Vector3 &direction, const Vector3 &sun) {
    const Vector3 unit = direction.unit();
    const Colour gradient = mix(HORIZON, ZENITH, 1 - std::exp(-3.2 * std::max(unit.y, 0.0)));
    const real glow = std::pow(std::max(unit * sun, 0.0), 24);
    return mix(gradient, SUNLIGHT, 0.55 * glow);
}

/// What one pixel covers of the surface: a parallelogram around `at`.
struct Footprint {
    Vector3 at, across, down;  ///< m; across and down: one pixel further
    real distance = 0;         ///< along the line of sight
};

/// How much of the interval [u − f/2, u + f/2] is covered by lines of the given width around the multiples of
/// `period`.
real lineCoverage(real u, real f, real period, real width) {
    const auto integral = [&](real x) {
        const real cycles = std::floor(x / period);
        return cycles * width + std::min(x - cycles * period, width);
    };
    const real from = u - f / 2 + width / 2;
    return (integral(from + f) - integral(from)) / f;
}

/// The mean over [u − f/2, u + f/2] of a wave that is +1 and −1 for half a period each.
real squareWave(real u, real f, real period) { return 2 * lineCoverage(u, f, period, period / 2) - 1; }

/// The pixel's extent along x and z: the sides of the box that the pattern is averaged over.
struct Extent {
    real x, z;
    explicit Extent(const Footprint &pixel)
        : x(std::max(std::abs(pixel.across.x) + std::abs(pixel.down.x), 1e-9)),
          z(std::max(std::abs(pixel.across.z) + std::abs(pixel.down.z), 1e-9)) {}
};

/// The share of grid lines in a pixel.
real gridCoverage(const Footprint &pixel, const Extent &extent, real period, real width) {
    const real x = lineCoverage(pixel.at.x, extent.x, period, width);
    const real z = lineCoverage(pixel.at.z, extent.z, period, width);
    return x + z - x * z;
}

/// A number in [−1, 1] for every square of the given size, smoothly gone where a pixel covers more than a
/// square.
real speckle(const Footprint &pixel, const Extent &extent, real size) {
    const real fade = 1 - std::max(extent.x, extent.z) / size;
    if (fade <= 0) return 0;
    const auto cell = [&](real u) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(u / size)));
    };
    std::uint64_t hash = cell(pixel.at.x) * 0x9E3779B97F4A7C15u ^ cell(pixel.at.z) * 0xC2B2AE3D27D4EB4Fu;
    hash = (hash ^ hash >> 29) * 0xBF58476D1CE4E5B9u;
    return fade * (static_cast<real>(hash >> 40) / (1 << 23) - 1);
}

Colour groundColour(const Footprint &pixel) {
    const Extent extent(pixel);
    const real checks = squareWave(pixel.at.x, extent.x, 20) * squareWave(pixel.at.z, extent.z, 20);
    const real tufts = speckle(pixel, extent, 0.5) + 0.7 * speckle(pixel, extent, 2.5);
    Colour colour = mix(GRASS, DARK_GRASS, 0.5 + 0.25 * checks + 0.25 * tufts);
    colour = mix(colour, GROUND_LINE, 0.6 * gridCoverage(pixel, extent, 10, 0.15));
    colour = mix(colour, GROUND_LINE, 0.8 * gridCoverage(pixel, extent, 100, 0.8));
    return mix(colour, GROUND_HAZE, 0.8 * (1 - std::exp(-pixel.distance / 500)));
}

/// A train of waves at one moment: height = amplitude · sin(kx·x + kz·z + phase).
struct Wave {
    real amplitude, kx, kz, phase;
};

std::vector<Wave> wavesAt(const std::vector<cyclone::Waves::Train> &trains, real time) {
    std::vector<Wave> waves;
    for (const cyclone::Waves::Train &train : trains) {
        const real k = 2 * cyclone::REAL_PI / train.wavelength;
        waves.push_back({train.amplitude, k * std::cos(train.direction), k * std::sin(train.direction),
                         train.phase - frequencyOf(train) * time});
    }
    return waves;
}

struct Water {
    real height = 0, slopeX = 0, slopeZ = 0;
};

/// The water at a point as a pixel sees it: waves too short for its footprint are averaged away.
Water waterAt(const std::vector<Wave> &waves, real x, real z, const Footprint &pixel) {
    Water water;
    for (const Wave &wave : waves) {
        const real across = wave.kx * pixel.across.x + wave.kz * pixel.across.z;
        const real down = wave.kx * pixel.down.x + wave.kz * pixel.down.z;
        const real blur = (across * across + down * down) / 6;  // a box filter's second moment is 1/12
        if (blur > 6) continue;
        const real amplitude = wave.amplitude * std::exp(-blur);
        const real angle = wave.kx * x + wave.kz * z + wave.phase;
        const real slope = amplitude * std::cos(angle);
        water.height += amplitude * std::sin(angle);
        water.slopeX += wave.kx * slope;
        water.slopeZ += wave.kz * slope;
    }
    return water;
}

Colour seaColour(const Footprint &pixel, const Water &water, const Vector3 &ray, const Vector3 &sun) {
    const Extent extent(pixel);
    const Vector3 normal = Vector3(-water.slopeX, 1, -water.slopeZ).unit();
    const Vector3 toEye = ray.unit() * -1;
    const real facing = std::max(normal * toEye, 0.0);
    const real mirrored = 0.03 + 0.6 * std::pow(1 - facing, 4);  // after Schlick, for a rough surface
    const Vector3 reflected = normal * (2 * (normal * toEye)) - toEye;
    const real glint = std::pow(std::max(reflected * sun, 0.0), 60);
    const real ripples = speckle(pixel, extent, 0.7) + speckle(pixel, extent, 3);
    const real lit = 0.35 + 1.6 * (normal * sun - sun.y) + 0.5 * water.height + 0.13 * ripples;

    Colour colour = mix(DEEP_WATER, LIT_WATER, lit);
    colour = mix(colour, SEA_LINE, 0.4 * gridCoverage(pixel, extent, 10, 0.18));
    colour = mix(colour, SEA_LINE, 0.4 * gridCoverage(pixel, extent, 100, 0.5));
    colour = mix(colour, mix(HORIZON, ZENITH, 0.4), mirrored);
    colour = mix(colour, SUNLIGHT, 0.7 * glint);
    return mix(colour, SEA_HAZE, 0.75 * (1 - std::exp(-pixel.distance / 400)));
}

void paintSpace(Raster &raster) {
    for (int row = 0; row < raster.height() * Raster::SAMPLES; ++row)
        for (int column = 0; column < raster.width() * Raster::SAMPLES; ++column)
            raster.setSample(column, row, Kind::SKY, 0, SPACE);
}

/// Paints pixel after pixel: the sky above the horizon, the surface below it.
class Painter {
public:
    Painter(Raster &raster, const View &view, const Surroundings &surroundings, real time, const Vector3 &sun)
        : raster_(raster),
          view_(view),
          sea_(surroundings.terrain == Terrain::SEA),
          waves_(sea_ ? wavesAt(surroundings.waves, time) : std::vector<Wave>()),
          sun_(sun),
          eye_(view.eye()),
          rayAcross_(view.ray(1, 0) - view.ray(0, 0)),
          rayDown_(view.ray(0, 1) - view.ray(0, 0)) {
        eye_.y = std::max(eye_.y, LOWEST_EYE);
    }

    void paint(int x, int y) {
        const Vector3 ray = view_.ray(x + 0.5, y + 0.5);
        // Where the horizon runs through the pixel, each side takes the colour next to it.
        const real reach = 0.5 * (std::abs(rayAcross_.y) + std::abs(rayDown_.y));
        const bool seesSky = ray.y + reach >= 0, seesSurface = ray.y - reach < 0;
        const Colour sky = seesSky ? skyColour(ray, sun_) : Colour();
        const Surface surface = seesSurface ? surfaceAt(ray) : Surface();
        for (int row = y * Raster::SAMPLES; row < (y + 1) * Raster::SAMPLES; ++row) {
            for (int column = x * Raster::SAMPLES; column < (x + 1) * Raster::SAMPLES; ++column) {
                const real down = view_.ray(Raster::middle(column), Raster::middle(row)).y;
                if (down >= 0)
                    raster_.setSample(column, row, Kind::SKY, 0, sky);
                else
                    raster_.setSample(column, row, Kind::GROUND, down / (surface.height - eye_.y),
                                      surface.colour);
            }
        }
    }

private:
    struct Surface {
        real height = 0;
        Colour colour;
    };

    Footprint footprintAt(const Vector3 &ray, real distance) const {
        const auto alongSurface = [&](const Vector3 &change) {
            return (change - ray * (change.y / ray.y)) * distance;
        };
        return {eye_ + ray * distance, alongSurface(rayAcross_), alongSurface(rayDown_), distance};
    }

    Surface surfaceAt(Vector3 ray) const {
        ray.y = std::min(ray.y, -1e-4);
        Footprint pixel = footprintAt(ray, -eye_.y / ray.y);
        if (!sea_) return {0, groundColour(pixel)};

        // Newton's method for the distance at which the ray meets the waves.
        Water water;
        for (int step = 0; step < 3 && !waves_.empty(); ++step) {
            water = waterAt(waves_, pixel.at.x, pixel.at.z, pixel);
            const real above = pixel.at.y - water.height;
            const real sinking = ray.y - water.slopeX * ray.x - water.slopeZ * ray.z;
            pixel.distance -= above / std::min(sinking, 0.5 * ray.y);
            pixel.at = eye_ + ray * pixel.distance;
        }
        const real height = std::min(pixel.at.y, eye_.y - LOWEST_EYE / 2);
        return {height, seaColour(pixel, water, ray, sun_)};
    }

    Raster &raster_;
    const View &view_;
    bool sea_;
    std::vector<Wave> waves_;
    Vector3 sun_, eye_, rayAcross_, rayDown_;
};

}  // namespace

void paintBackdrop(Raster &raster, const View &view, const Surroundings &surroundings, real time,
                   const Vector3 &sun) {
    if (surroundings.terrain == Terrain::SPACE) return paintSpace(raster);
    Painter painter(raster, view, surroundings, time, sun);
    for (int y = 0; y < raster.height(); ++y)
        for (int x = 0; x < raster.width(); ++x) painter.paint(x, y);
}

}  // namespace demo
