#include "thrust/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.h"

namespace {

using cyclone::real;
using cyclone::Vector3;
using thrust::Corner;
using thrust::Wall;

const Wall UPRIGHT{{0, -1, 0}, {0, 1, 0}};

std::vector<Corner> moved(const std::vector<Vector3> &outline, const Vector3 &way) {
    std::vector<Corner> corners;
    for (const Vector3 &corner : outline) corners.push_back({corner, corner + way});
    return corners;
}

std::vector<Vector3> square(const Vector3 &middle, real half) {
    return {middle + Vector3(-half, -half, 0), middle + Vector3(half, -half, 0),
            middle + Vector3(half, half, 0), middle + Vector3(-half, half, 0)};
}

bool touches(const std::vector<Corner> &outline, const Wall &wall) {
    return thrust::findTouch(outline, {wall}).has_value();
}

TEST(ThrustSweep, NothingTunnelsHoweverFast) {
    for (const real way : {1.0, 10.0, 1e3, 1e6})
        EXPECT_TRUE(touches(moved(square({-0.5, 0, 0}, 0.1), {way, 0, 0}), UPRIGHT)) << way;
}

TEST(ThrustSweep, WhatPassesByDoesNotTouch) {
    EXPECT_FALSE(touches(moved(square({-5, 1.101, 0}, 0.1), {10, 0, 0}), UPRIGHT));
    EXPECT_TRUE(touches(moved(square({-5, 1.099, 0}, 0.1), {10, 0, 0}), UPRIGHT));
    EXPECT_FALSE(touches(moved(square({-5, 0, 0}, 0.1), {4.899, 0, 0}), UPRIGHT)) << "stops before";
    EXPECT_TRUE(touches(moved(square({-5, 0, 0}, 0.1), {4.901, 0, 0}), UPRIGHT));
    EXPECT_FALSE(touches(moved(square({-5, 0, 0}, 0.1), {0, 0, 0}), UPRIGHT)) << "stands still";
}

TEST(ThrustSweep, AWallsEndIsFeltBetweenCorners) {
    const Wall spike{{0, -5, 0}, {0, 0, 0}};
    EXPECT_TRUE(touches(moved(square({0, 1.5, 0}, 1), {0, -0.6, 0}), spike));
    EXPECT_FALSE(touches(moved(square({0, 1.5, 0}, 1), {0, -0.4, 0}), spike));
}

TEST(ThrustSweep, ARodThatTurnsSweepsWhatLiesBetweenItsEnds) {
    const Wall bar{{1, 1, 0}, {1.2, 1.2, 0}};
    const auto turned = [](const Vector3 &end) {
        return std::vector<Corner>{{{0, 0, 0}, {0, 0, 0}}, {{4, 0, 0}, end}};
    };
    EXPECT_TRUE(touches(turned({0, 4, 0}), bar)) << "from X to Y";
    EXPECT_FALSE(touches(turned({4, 3, 0}), bar)) << "not so far";
}

TEST(ThrustSweep, TellsWhichWall) {
    const Wall far{{9, -1, 0}, {9, 1, 0}};
    const auto touched = thrust::findTouch(moved(square({-0.5, 0, 0}, 0.1), {2, 0, 0}), {far, UPRIGHT});
    ASSERT_TRUE(touched.has_value());
    EXPECT_EQ(touched->from, UPRIGHT.from);
}

// ---- Against the same, looked at moment by moment

real distance(const Vector3 &point, const Vector3 &a, const Vector3 &b) {
    const Vector3 along = b - a;
    const real share =
        cyclone::real_clamp((point - a) * along / std::max(along.squareMagnitude(), 1e-300), 0, 1);
    return (point - a - along * share).magnitude();
}

real distance(const Vector3 &a, const Vector3 &b, const Vector3 &c, const Vector3 &d) {
    const auto side = [](const Vector3 &p, const Vector3 &q, const Vector3 &r) {
        return ((q - p) % (r - p)).z > 0;
    };
    if (side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b)) return 0;
    return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

/// How near the outline comes to the wall, at 1000 moments.
real nearest(const std::vector<Corner> &outline, const Wall &wall) {
    real least = 1e9;
    for (int n = 0; n <= 1000; ++n) {
        const auto at = [&](const Corner &c) { return c.before + (c.after - c.before) * (n / 1000.0); };
        for (std::size_t i = 0; i < outline.size(); ++i)
            least = std::min(
                least, distance(at(outline[i]), at(outline[(i + 1) % outline.size()]), wall.from, wall.to));
    }
    return least;
}

TEST(ThrustSweep, AgreesWithManyMomentsOfTheSameStep) {
    demo::Random random(5);
    const auto point = [&](real size) {
        return Vector3(random.between(-size, size), random.between(-size, size), 0);
    };
    int touching = 0, apart = 0;
    for (int n = 0; n < 1000; ++n) {
        std::vector<Corner> outline;
        const Vector3 before = point(3), after = point(3);
        for (int corner = 0; corner < 3; ++corner) outline.push_back({before + point(1), after + point(1)});
        const Vector3 from = point(3);
        const Wall wall{from, from + point(1)};
        bool startsInTouch = false;
        for (std::size_t i = 0; i < 3; ++i)
            startsInTouch = startsInTouch ||
                            distance(outline[i].before, outline[(i + 1) % 3].before, wall.from, wall.to) == 0;
        if (startsInTouch) continue;
        const real least = nearest(outline, wall);
        const bool touched = touches(outline, wall);
        // Between two moments it moves up to 0.01.
        EXPECT_TRUE(touched || least > 0) << n;
        EXPECT_FALSE(touched && least > 0.02) << n;
        ++(touched ? touching : apart);
    }
    EXPECT_GT(touching, 50);
    EXPECT_GT(apart, 50);
}

}  // namespace
