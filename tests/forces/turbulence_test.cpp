#include <cyclone/wind.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

using Series = std::vector<real>;

constexpr real METRES_PER_FOOT = 0.3048;
constexpr real HEIGHT = 100, SPEED = 30, WIND = 12;

/// The parameters of MIL-F-8785C at HEIGHT and WIND, written down anew: m and m/s.
struct Specification {
    real feet = HEIGHT / METRES_PER_FOOT;
    real lengthUp = HEIGHT;
    real lengthAlong = HEIGHT / std::pow(0.177 + 0.000823 * feet, 1.2);
    real deviationUp = 0.1 * WIND;
    real deviationAlong = deviationUp / std::pow(0.177 + 0.000823 * feet, 0.4);
};

/// How the gusts along, across and up go on over many equal steps, each in units of its standard deviation.
struct Gusts {
    Series along, across, up;

    /// Steps of the given way, in lengths of `along`.
    Gusts(std::size_t steps, real way, std::uint64_t seed) {
        const Specification specified;
        Turbulence turbulence(WIND, seed);
        const real duration = way * specified.lengthAlong / SPEED;
        for (std::size_t n = 0; n < steps; ++n) {
            turbulence.advance(Vector3(SPEED, 0, 0), HEIGHT, duration);
            const Vector3 gust = turbulence.getVelocity(Vector3());
            along.push_back(gust.x / specified.deviationAlong);
            across.push_back(gust.z / specified.deviationAlong);
            up.push_back(gust.y / specified.deviationUp);
        }
    }
};

/// The mean of a·b that lie `lag` steps apart.
real correlation(const Series &series, std::size_t lag) {
    real sum = 0;
    for (std::size_t n = lag; n < series.size(); ++n) sum += series[n] * series[n - lag];
    return sum / static_cast<real>(series.size() - lag);
}

// Over the way s in lengths the specified gusts forget by e^(−s) along and by (1 − s/2)·e^(−s) across: the
// Fourier transforms of the spectra. Their integrals, 1 and 1/2, are the integral lengths.
real alongCorrelation(real s) { return std::exp(-s); }
real acrossCorrelation(real s) { return (1 - s / 2) * std::exp(-s); }

// ---- Variance and lengths

TEST(Turbulence, HasTheSpecifiedVarianceAtEveryStep) {
    // Of T lengths the variance's relative standard deviation is √(2·∫ρ²/T) when they are sampled densely
    // (∫ρ² over both sides is 1 along, 5/8 across) and √(2/n) of n samples that are far apart.
    for (real way : {0.01, 0.1, 1.0, 20.0}) {
        const std::size_t steps = 400000;
        const Gusts gusts(steps, way, 7);
        const real independent = static_cast<real>(steps) * std::min(way, 1.0) / 2;
        const real tolerance = 4.5 * std::sqrt(2 / independent);
        EXPECT_NEAR(correlation(gusts.along, 0), 1, tolerance) << way;
        EXPECT_NEAR(correlation(gusts.across, 0), 1, tolerance) << way;
        EXPECT_NEAR(correlation(gusts.up, 0), 1, tolerance) << way;
    }
}

TEST(Turbulence, ForgetsOverTheSpecifiedLengths) {
    const std::size_t steps = 1000000;
    const real way = 0.1, tolerance = 4.5 * std::sqrt(2 / (static_cast<real>(steps) * way));
    const Gusts gusts(steps, way, 8);
    const real wayUp = way * Specification().lengthAlong / Specification().lengthUp;
    for (std::size_t lag : {1u, 3u, 10u, 20u, 30u}) {
        const real lags = static_cast<real>(lag);
        EXPECT_NEAR(correlation(gusts.along, lag), alongCorrelation(lags * way), tolerance) << lag;
        EXPECT_NEAR(correlation(gusts.across, lag), acrossCorrelation(lags * way), tolerance) << lag;
        EXPECT_NEAR(correlation(gusts.up, lag), acrossCorrelation(lags * wayUp), tolerance) << lag;
    }
}

/// The way over which a series is correlated, in its steps: the integral of the correlation out to `lags`.
real integralLength(const Series &series, std::size_t lags) {
    real sum = correlation(series, 0) / 2;
    for (std::size_t lag = 1; lag <= lags; ++lag) sum += correlation(series, lag);
    return sum;
}

TEST(Turbulence, HasTheSpecifiedIntegralLengths) {
    // Out to M lengths, from T of them, the integral's standard deviation is about √(2·M/T) lengths.
    const std::size_t steps = 1000000, lags = 60;
    const real way = 0.1, tolerance = 4.5 * std::sqrt(2 * 6 / (static_cast<real>(steps) * way));
    const Gusts gusts(steps, way, 9);
    EXPECT_NEAR(integralLength(gusts.along, lags) * way, 1, tolerance);
    EXPECT_NEAR(integralLength(gusts.across, lags) * way, 0.5, tolerance);
    EXPECT_NEAR(integralLength(gusts.up, 3 * lags) * way,
                0.5 * Specification().lengthUp / Specification().lengthAlong, tolerance);
}

TEST(Turbulence, IsAsStrongAtTheStartAsEver) {
    const int seeds = 20000;
    const Specification specified;
    const real duration = specified.lengthAlong / SPEED;
    real starts[3] = {}, products[3] = {};
    for (int seed = 0; seed < seeds; ++seed) {
        Turbulence turbulence(WIND, static_cast<std::uint64_t>(seed));
        turbulence.advance(Vector3(SPEED, 0, 0), HEIGHT, 0);
        const Vector3 start = turbulence.getVelocity(Vector3());
        turbulence.advance(Vector3(SPEED, 0, 0), HEIGHT, duration);
        const Vector3 later = turbulence.getVelocity(Vector3());
        for (unsigned n = 0; n < 3; ++n) {
            const real deviation = n == 1 ? specified.deviationUp : specified.deviationAlong;
            starts[n] += start[n] * start[n] / (deviation * deviation * seeds);
            products[n] += start[n] * later[n] / (deviation * deviation * seeds);
        }
    }
    const real tolerance = 4.5 * std::sqrt(2.0 / seeds);
    for (real start : starts) EXPECT_NEAR(start, 1, tolerance);
    EXPECT_NEAR(products[0], alongCorrelation(1), tolerance);
    EXPECT_NEAR(products[1], acrossCorrelation(specified.lengthAlong / specified.lengthUp), tolerance);
    EXPECT_NEAR(products[2], acrossCorrelation(1), tolerance);
}

// ---- Spectrum

/// In place, a power of two long: Cooley and Tukey.
void fourierTransform(std::vector<std::complex<real>> &values) {
    const std::size_t count = values.size();
    for (std::size_t n = 1, reversed = 0; n < count; ++n) {
        std::size_t bit = count / 2;
        for (; reversed & bit; bit /= 2) reversed ^= bit;
        reversed ^= bit;
        if (n < reversed) std::swap(values[n], values[reversed]);
    }
    for (std::size_t half = 1; half < count; half *= 2) {
        const std::complex<real> turn = std::polar(1.0, -REAL_PI / static_cast<real>(half));
        for (std::size_t begin = 0; begin < count; begin += 2 * half) {
            std::complex<real> factor = 1;
            for (std::size_t n = begin; n < begin + half; ++n, factor *= turn) {
                const std::complex<real> odd = values[n + half] * factor;
                values[n + half] = values[n] - odd;
                values[n] += odd;
            }
        }
    }
}

constexpr std::size_t SEGMENT = 4096;

/// One-sided spectrum over the wave numbers 2π·k/(SEGMENT·way), after Welch: the mean periodogram of segments
/// under Hann's window.
Series spectrum(const Series &series, real way) {
    Series power(SEGMENT / 2);
    const std::size_t segments = series.size() / SEGMENT;
    std::vector<std::complex<real>> values(SEGMENT);
    for (std::size_t segment = 0; segment < segments; ++segment) {
        for (std::size_t n = 0; n < SEGMENT; ++n) {
            const real phase = 2 * REAL_PI * static_cast<real>(n) / SEGMENT;
            values[n] = series[segment * SEGMENT + n] * 0.5 * (1 - std::cos(phase));
        }
        fourierTransform(values);
        for (std::size_t k = 0; k < power.size(); ++k) power[k] += std::norm(values[k]);
    }
    // Hann's window keeps 3/8 of the power.
    for (real &p : power) p *= way / (REAL_PI * 0.375 * SEGMENT * static_cast<real>(segments));
    return power;
}

/// The spectra of MIL-F-8785C, of variance 1, at wave number k per length.
real specifiedAlong(real k) { return 2 / REAL_PI / (1 + k * k); }
real specifiedAcross(real k) { return (1 + 3 * k * k) / (1 + k * k) / (1 + k * k) / REAL_PI; }

/// What samples at steps of `way` show of a spectrum: frequencies above half of the samples' are folded in.
real sampled(real (*specified)(real), real k, real way) {
    const real fold = 2 * REAL_PI / way;
    real sum = specified(k);
    for (int n = 1; n < 300; ++n) sum += specified(n * fold - k) + specified(n * fold + k);
    return sum;
}

/// In every band of wave numbers, each a half wider than the last, from 0.1 (or the window's width) to 10.
void expectSpectrum(const Series &series, real way, real (*specified)(real)) {
    const Series got = spectrum(series, way);
    const real bin = 2 * REAL_PI / (SEGMENT * way);
    const real segments = static_cast<real>(series.size() / SEGMENT);
    for (std::size_t low = 6; static_cast<real>(low) * bin < 10 && low * 3 / 2 < SEGMENT / 2;
         low = low * 3 / 2) {
        real mean = 0, wanted = 0;
        for (std::size_t k = low; k < low * 3 / 2; ++k) {
            mean += got[k];
            wanted += sampled(specified, static_cast<real>(k) * bin, way);
        }
        // Each bin has the relative standard deviation 1/√segments; half of the bins are independent.
        const real independent = segments * static_cast<real>(low * 3 / 2 - low) / 2;
        EXPECT_NEAR(mean / wanted, 1, 0.005 + 4.5 / std::sqrt(independent))
            << "at " << static_cast<real>(low) * bin << " per length, steps of " << way;
    }
}

TEST(Turbulence, HasTheSpecifiedSpectraOverTwoDecades) {
    for (real way : {0.02, 0.2}) {  // low bands at 0.46 and 0.046 per length, high ones at 10
        const Gusts gusts(150 * SEGMENT, way, 10);
        expectSpectrum(gusts.along, way, specifiedAlong);
        expectSpectrum(gusts.across, way, specifiedAcross);
        const real upPerAlong = Specification().lengthAlong / Specification().lengthUp;
        expectSpectrum(gusts.up, way * upPerAlong, specifiedAcross);
    }
}

// ---- One gust after the other

TEST(Turbulence, BlowsAlongTheFlightAcrossItAndUp) {
    const Vector3 aslant(3, 40, -4);
    Turbulence level(WIND, 5), turned(WIND, 5);
    for (int n = 0; n < 20; ++n) {
        level.advance(Vector3(aslant.magnitude(), 0, 0), HEIGHT, 0.1);
        turned.advance(aslant, HEIGHT, 0.1);
    }
    const Vector3 gust = level.getVelocity(Vector3()), other = turned.getVelocity(Vector3(7, 8, 9));
    const Vector3 along(0.6, 0, -0.8), across(0.8, 0, 0.6);
    EXPECT_TRUE(isNear(other, along * gust.x + across * gust.z + Vector3(0, gust.y, 0), 1e-12));

    // Straight up, the last horizontal direction stays.
    Turbulence upwards = level;
    level.advance(Vector3(50, 0, 0), HEIGHT, 0.1);
    upwards.advance(Vector3(0, 50, 0), HEIGHT, 0.1);
    EXPECT_EQ(upwards.getVelocity(Vector3()), level.getVelocity(Vector3()));
}

TEST(Turbulence, StandsStillWithoutWay) {
    Turbulence turbulence(WIND, 5);
    EXPECT_EQ(turbulence.getVelocity(Vector3()), Vector3());
    turbulence.advance(Vector3(SPEED, 0, 0), HEIGHT, 0.1);
    const Vector3 gust = turbulence.getVelocity(Vector3());
    EXPECT_NE(gust, Vector3());
    turbulence.advance(Vector3(SPEED, 0, 0), HEIGHT, 0);
    turbulence.advance(Vector3(), HEIGHT, 10);
    EXPECT_TRUE(isNear(turbulence.getVelocity(Vector3()), gust, 1e-14));
}

TEST(Turbulence, GrowsWithTheWindAndEndsWithIt) {
    Turbulence weak(WIND, 5), strong(2 * WIND, 5);
    weak.advance(Vector3(SPEED, 0, 0), HEIGHT, 0.1);
    strong.advance(Vector3(SPEED, 0, 0), HEIGHT, 0.1);
    EXPECT_TRUE(isNear(strong.getVelocity(Vector3()), weak.getVelocity(Vector3()) * 2, 1e-14));
    strong.setWindAt6Metres(0);
    strong.advance(Vector3(SPEED, 0, 0), HEIGHT, 0.1);
    EXPECT_EQ(strong.getVelocity(Vector3()), Vector3());
}

TEST(Turbulence, TakesHeightsIntoTheRangeOfTheSpecification) {
    const auto gustAt = [](real height) {
        Turbulence turbulence(WIND, 5);
        turbulence.advance(Vector3(SPEED, 0, 0), height, 0.1);
        return turbulence.getVelocity(Vector3());
    };
    EXPECT_EQ(gustAt(-5), gustAt(10 * METRES_PER_FOOT));
    EXPECT_EQ(gustAt(9000), gustAt(1000 * METRES_PER_FOOT));
    EXPECT_NE(gustAt(11 * METRES_PER_FOOT), gustAt(10 * METRES_PER_FOOT));
}

TEST(Turbulence, ACopyGoesOnAlikeAndAnotherSeedDoesNot) {
    Turbulence one(WIND, 5), other(WIND, 6);
    one.advance(Vector3(SPEED, 0, 0), HEIGHT, 0.1);
    Turbulence copy = one;
    for (Turbulence *each : {&one, &copy, &other}) each->advance(Vector3(SPEED, 0, 0), HEIGHT, 0.1);
    EXPECT_EQ(one.getVelocity(Vector3()), copy.getVelocity(Vector3()));
    EXPECT_NE(one.getVelocity(Vector3()), other.getVelocity(Vector3()));
}

TEST(Turbulence, StaysFiniteOverAnyWay) {
    Turbulence turbulence(WIND, 5);
    for (real speed : {1e-300, 1e-9, 1e9, 1e300}) {
        turbulence.advance(Vector3(speed, 0, speed), HEIGHT, speed);
        EXPECT_LT(turbulence.getVelocity(Vector3()).magnitude(), 20) << speed;
    }
}

TEST(Turbulence, RefusesWhatIsNotAFlight) {
    EXPECT_THROW(Turbulence(-1), std::invalid_argument);
    Turbulence turbulence(WIND);
    EXPECT_THROW(turbulence.setWindAt6Metres(QUIET_NAN), std::invalid_argument);
    EXPECT_EQ(turbulence.getWindAt6Metres(), WIND);
    EXPECT_THROW(turbulence.advance(Vector3(QUIET_NAN, 0, 0), HEIGHT, 1), std::invalid_argument);
    EXPECT_THROW(turbulence.advance(Vector3(), PLUS_INFINITY, 1), std::invalid_argument);
    EXPECT_THROW(turbulence.advance(Vector3(), HEIGHT, -1), std::invalid_argument);
    EXPECT_EQ(turbulence.getVelocity(Vector3()), Vector3());
}

}  // namespace
