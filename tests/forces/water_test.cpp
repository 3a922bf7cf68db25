#include <cyclone/water.h>
#include <gtest/gtest.h>

#include <cmath>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

// ---- Height

TEST(Waves, WithoutTrainsAreStillWater) {
    const Waves still(3);
    EXPECT_EQ(still.getHeight(Vector3(1, 2, 3)), 3);
    EXPECT_EQ(Waves().getHeight(Vector3(5, 6, 7)), 0);
}

TEST(Waves, RunAtTheSpeedOfDeepWater) {
    // A crest of a wave 20 m long travels at sqrt(g·λ/2π).
    Waves sea(1);
    Waves::Train train;
    train.amplitude = 0.5;
    train.wavelength = 20;
    train.direction = REAL_PI / 3;
    train.phase = REAL_PI / 2;  // a crest at the origin
    sea.addTrain(train);
    const Vector3 direction(std::cos(REAL_PI / 3), 0, std::sin(REAL_PI / 3));
    const real speed = std::sqrt(9.81 * 20 / (2 * REAL_PI));
    for (real t : {0.0, 1.0, 2.5, 100.0}) {
        sea.setTime(t);
        EXPECT_EQ(sea.getTime(), t);
        const Vector3 crest = direction * (speed * t);
        EXPECT_NEAR(sea.getHeight(crest), 1.5, 1e-9);
        EXPECT_NEAR(sea.getHeight(crest + direction * 10), 0.5, 1e-9);
        EXPECT_NEAR(sea.getHeight(crest + direction * 5), 1, 1e-9);
        EXPECT_NEAR(sea.getHeight(crest + Vector3::UP * 50), 1.5, 1e-9);              // height is no matter
        EXPECT_NEAR(sea.getHeight(crest + direction % Vector3::UP * 17), 1.5, 1e-9);  // crests are straight
        EXPECT_NEAR(sea.getHeight(crest + direction * (5.0 / 3)), 1.5 - 0.5 * (1 - std::sqrt(0.75)), 1e-9);
    }
}

TEST(Waves, AddUp) {
    Waves one(2), other(2), both(2);
    const Waves::Train a{0.5, 10, 0.3, 1}, b{0.2, 3, 2, -1};
    one.setTime(7);
    both.setTime(7);
    one.addTrain(a);
    other.addTrain(b);
    both.addTrain(a);
    both.addTrain(b);  // trains that are added later run on the same clock
    other.setTime(7);
    for (real x : {0.0, 1.7, -20.0}) {
        const Vector3 point(x, 0, 2 * x + 1);
        EXPECT_NEAR(both.getHeight(point), one.getHeight(point) + other.getHeight(point) - 2, 1e-12);
    }
}

TEST(Waves, OnTheMoonAreSlower) {
    Waves moon(0, 1.62);
    moon.addTrain({1, 20, 0, REAL_PI / 2});
    moon.setTime(3);
    EXPECT_NEAR(moon.getHeight(Vector3(3 * std::sqrt(1.62 * 20 / (2 * REAL_PI)), 0, 0)), 1, 1e-9);
}

// ---- Motion

/// A swell, a chop across it and a ripple, at some moment.
Waves makeSea() {
    Waves sea(1.5);
    sea.addTrain({0.6, 30, 0.4, 1});
    sea.addTrain({0.2, 7, 2, -1});
    sea.addTrain({0.05, 1.5, -1, 0.3});
    sea.setTime(12.3);
    return sea;
}

TEST(Waves, MoveWithTheirSurface) {
    // At the mean level the water rises as the surface does: to first order the particles there stay in it.
    Waves sea = makeSea();
    const Vector3 point(3, 1.5, -2);
    const real dt = 1e-4, now = sea.getTime();
    const Vector3 velocity = sea.getVelocity(point);
    sea.setTime(now - dt);
    const real before = sea.getHeight(point);
    sea.setTime(now + dt);
    EXPECT_NEAR(velocity.y, (sea.getHeight(point) - before) / (2 * dt), 1e-6);
}

TEST(Waves, AccelerateAsTheirVelocityChanges) {
    Waves sea = makeSea();
    const Vector3 point(3, 0.7, -2);
    const real dt = 1e-4, now = sea.getTime();
    const Vector3 acceleration = sea.getAcceleration(point);
    sea.setTime(now - dt);
    const Vector3 before = sea.getVelocity(point);
    sea.setTime(now + dt);
    EXPECT_TRUE(isNear(acceleration, (sea.getVelocity(point) - before) * (1 / (2 * dt)), 1e-6));
}

TEST(Waves, NeitherGainWaterNorWhirl) {
    // The flow of an ideal fluid: no divergence and no curl.
    const Waves sea = makeSea();
    const real d = 1e-4;
    for (const Vector3 &point : {Vector3(1, 1.2, 2), Vector3(-30, 0, 8), Vector3(4, -3, -7)}) {
        const auto slope = [&](const Vector3 &axis) {
            return (sea.getVelocity(point + axis * d) - sea.getVelocity(point - axis * d)) * (1 / (2 * d));
        };
        const Vector3 x = slope(Vector3::X), y = slope(Vector3::Y), z = slope(Vector3::Z);
        EXPECT_NEAR(x.x + y.y + z.z, 0, 1e-6);
        EXPECT_TRUE(isNear(Vector3(y.z - z.y, z.x - x.z, x.y - y.x), Vector3(), 1e-6));
        EXPECT_GT(y.magnitude(), 1e-3);
    }
}

TEST(Waves, MoveTheWaterOnCirclesThatDecayWithDepth) {
    // At a fixed depth the displacement, the time integral of the velocity, is a circle of radius a·e^{kz}
    // that closes after a period.
    const real amplitude = 0.3, wavelength = 25, k = 2 * REAL_PI / wavelength;
    const real period = 2 * REAL_PI / std::sqrt(9.81 * k);
    Waves sea(2);
    sea.addTrain({amplitude, wavelength, 0, 0});
    for (const real depth : {0.0, 1.0, 5.0, 12.5}) {
        const int steps = 400;
        Vector3 displacement(0, 0, 0), low, high;
        for (int n = 0; n < steps; ++n) {
            sea.setTime((n + 0.5) * period / steps);
            displacement += sea.getVelocity(Vector3(7, 2 - depth, 1)) * (period / steps);
            low = Vector3(std::fmin(low.x, displacement.x), std::fmin(low.y, displacement.y), 0);
            high = Vector3(std::fmax(high.x, displacement.x), std::fmax(high.y, displacement.y), 0);
        }
        const real diameter = 2 * amplitude * std::exp(-k * depth);
        EXPECT_TRUE(isNear(displacement, Vector3(), 1e-9));
        EXPECT_NEAR(high.x - low.x, diameter, 1e-4 * diameter);
        EXPECT_NEAR(high.y - low.y, diameter, 1e-4 * diameter);
    }
}

TEST(Waves, DriftParticlesAsStokesFound) {
    // A particle that is followed creeps along with the waves at a²·ω·k·e^{2kz} (Stokes 1847).
    const real amplitude = 0.2, wavelength = 30, k = 2 * REAL_PI / wavelength, omega = std::sqrt(9.81 * k);
    const real depth = 2, period = 2 * REAL_PI / omega;
    Waves sea;
    sea.addTrain({amplitude, wavelength, 0, 0});
    Vector3 particle(0, -depth, 0);
    const int periods = 20, steps = 400 * periods;
    const real dt = periods * period / steps;
    for (int n = 0; n < steps; ++n) {  // the midpoint rule
        sea.setTime(n * dt);
        const Vector3 half = particle + sea.getVelocity(particle) * (0.5 * dt);
        sea.setTime((n + 0.5) * dt);
        particle += sea.getVelocity(half) * dt;
    }
    const real drift = amplitude * amplitude * omega * k * std::exp(-2 * k * depth);
    EXPECT_NEAR(particle.x / (periods * period), drift, 0.05 * drift);
    EXPECT_NEAR(particle.y, -depth, 0.02);
}

TEST(Waves, AreAboveTheMeanLevelAsAtIt) {
    const Waves sea = makeSea();
    const Vector3 level(3, 1.5, -2), above(3, 40, -2);
    EXPECT_EQ(sea.getVelocity(above), sea.getVelocity(level));
    EXPECT_EQ(sea.getAcceleration(above), sea.getAcceleration(level));
}

TEST(Waves, LeaveTheDepthsStill) {
    const Waves sea = makeSea();
    EXPECT_TRUE(isNear(sea.getVelocity(Vector3(3, -1000, -2)), Vector3(), 1e-15));
    EXPECT_TRUE(isNear(sea.getAcceleration(Vector3(3, -1000, -2)), Vector3(), 1e-15));
}

TEST(Waves, AreBoundedHoweverFarAway) {
    const Waves sea = makeSea();
    for (const real far : {1e9, -1e20, 1e200}) {
        const Water::Motion motion = sea.getMotion(Vector3(far, -far, far));
        EXPECT_LE(std::fabs(motion.height - 1.5), 0.851);
        EXPECT_LT(motion.velocity.magnitude(), 2);
        EXPECT_LT(motion.acceleration.magnitude(), 6);
    }
}

TEST(Waves, TellAllAtOnceWhatTheyTellOneByOne) {
    Waves sea = makeSea();
    for (int n = 0; n < 6; ++n) sea.addTrain({0.1 + 0.01 * n, 4.0 + n, 0.5 * n, 1.0 * n});
    const Vector3 point(3, 0.4, -2);
    const Water::Motion motion = sea.getMotion(point);
    EXPECT_EQ(motion.height, sea.getHeight(point));
    EXPECT_EQ(motion.velocity, sea.getVelocity(point));
    EXPECT_EQ(motion.acceleration, sea.getAcceleration(point));
}

/// Heights are all that it tells.
class Slope : public Water {
public:
    real getHeight(const Vector3 &point) const override { return 0.5 * point.x - 0.25 * point.z; }
};

TEST(Water, LiesStillUnlessItSaysOtherwise) {
    const Slope slope;
    EXPECT_EQ(slope.getVelocity(Vector3(1, 2, 3)), Vector3());
    EXPECT_EQ(slope.getAcceleration(Vector3(1, 2, 3)), Vector3());
    const Water::Motion motion = slope.getMotion(Vector3(4, 0, 4));
    EXPECT_EQ(motion.height, 1);
    EXPECT_EQ(motion.velocity, Vector3());
    EXPECT_EQ(motion.acceleration, Vector3());
}

TEST(Water, NormalIsAcrossTheSurface) {
    EXPECT_TRUE(isNear(Slope().getNormal(Vector3(4, 9, 4)), Vector3(-0.5, 1, 0.25).unit(), 1e-9));

    // The waves' own formula against that of heights.
    class Heights : public Water {
    public:
        Waves sea = makeSea();
        real getHeight(const Vector3 &point) const override { return sea.getHeight(point); }
    } heights;
    for (const Vector3 &point : {Vector3(1, 2, 3), Vector3(-8, 0, 5), Vector3(100, 1, 0)}) {
        EXPECT_TRUE(isNear(heights.sea.getNormal(point), heights.getNormal(point), 1e-4));
        EXPECT_NEAR(heights.sea.getNormal(point).magnitude(), 1, 1e-15);
    }
}

}  // namespace
