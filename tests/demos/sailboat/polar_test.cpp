#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <sstream>
#include <stdexcept>

#include "sailboat/polar.h"
#include "sailboat/polar_chart.h"

namespace {

using cyclone::real;
using sailboat::measurePoint;
using sailboat::Polar;
using sailboat::PolarPoint;

constexpr real DEGREE = cyclone::REAL_PI / 180;

PolarPoint makePoint(real degrees, real speed) {
    PolarPoint point;
    point.windAngle = degrees * DEGREE;
    point.speed = speed;
    point.madeGood = speed * std::cos(point.windAngle);
    return point;
}

TEST(Polar, FindsTheTrimThatTheTheorySays) {
    // For a flat sail drive is greatest at half the apparent wind's angle. Easing a little more costs next to
    // nothing there, and the boat heels less.
    for (const real angle : {50, 90, 135}) {
        const PolarPoint point = measurePoint(5, angle * DEGREE);
        EXPECT_GT(point.sail, point.apparentWindAngle / 2 - 0.5 * DEGREE) << angle;
        EXPECT_LT(point.sail, point.apparentWindAngle / 2 + 3 * DEGREE) << angle;
    }
}

TEST(Polar, NoSailGetsTheBoatAheadInTheWindsEye) {
    EXPECT_EQ(measurePoint(6, 0).speed, 0);
    EXPECT_EQ(measurePoint(6, 8 * DEGREE).speed, 0);
}

TEST(Polar, RunsAtTheSpeedWhereSailAndHullAgree) {
    // Dead before the wind W at speed v the sail, square to it, pulls 160·(W − v). The hulls, with the share
    // 355/880 of them under water, resist by 4·355/880·(4 + 2·v)·v, the rudder by 1·v. The boom stops 4°
    // short of square and the bows dip a little: 1 %.
    const real under = 4 * 355.0 / 880;
    const real a = 2 * under, b = 4 * under + 1 + 160, c = -160 * 6.0;
    const real speed = (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
    EXPECT_NEAR(measurePoint(6, cyclone::REAL_PI).speed, speed, 0.01 * speed);
}

TEST(Polar, IsMeasuredFromHeadToWindToDeadBeforeIt) {
    const Polar polar = sailboat::measurePolar(6, 3);
    ASSERT_EQ(polar.points.size(), 4u);
    for (unsigned n = 0; n < 4; ++n) EXPECT_NEAR(polar.points[n].windAngle, n * 60 * DEGREE, 1e-12);
    EXPECT_EQ(&polar.fastest(), &polar.points[2]);
    EXPECT_EQ(&polar.bestUpwind(), &polar.points[1]);
    EXPECT_EQ(&polar.bestDownwind(), &polar.points[3]);
}

TEST(Polar, IsDrawnToScale) {
    // 4 m/s on a beam reach and 2 m/s running lie on the axes of the chart, one twice as far out as the
    // other.
    Polar polar;
    polar.windspeed = 5;
    polar.points = {makePoint(0, 0), makePoint(90, 4), makePoint(180, 2)};
    std::ostringstream out;
    sailboat::drawPolars(out, {polar});
    const std::string svg = out.str(), curve = svg.substr(svg.find("class=\"curve\""));
    real x0 = 0, y0 = 0, x1 = 0, y1 = 0, x2 = 0, y2 = 0;
    ASSERT_EQ(std::sscanf(curve.c_str() + curve.find(" d=\"M"), " d=\"M%lf %lfL%lf %lfL%lf %lf", &x0, &y0,
                          &x1, &y1, &x2, &y2),
              6);
    EXPECT_GT(x1, x0);
    EXPECT_NEAR(y1, y0, 0.1);
    EXPECT_NEAR(x2, x0, 0.1);
    EXPECT_NEAR(x1 - x0, 2 * (y2 - y0), 0.3);
    EXPECT_EQ(svg.rfind("<svg ", 0), 0u);
    EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
}

TEST(Polar, NothingToDrawIsSaid) {
    std::ostringstream out;
    EXPECT_THROW(sailboat::drawPolars(out, {}), std::invalid_argument);
    Polar still;
    still.points = {makePoint(0, 0)};
    EXPECT_THROW(sailboat::drawPolars(out, {still}), std::invalid_argument);
    EXPECT_EQ(out.str(), "");
}

}  // namespace
