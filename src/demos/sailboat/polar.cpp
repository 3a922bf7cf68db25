#include "sailboat/polar.h"

#include <algorithm>
#include <cmath>

#include "sailboat/helmsman.h"

namespace sailboat {

namespace {

using cyclone::REAL_PI;

constexpr real STEP = 1.0 / 60, SETTLE = 40, HELD = 0.1;  // s, s, rad

/// A boat alone on calm water in a steady wind from the north, under way with the wind to starboard.
class Trial {
public:
    Trial(real wind, real windAngle) : windspeed(wind, 0, 0), boat(world, &windspeed, &water) {
        boat.launch(0, 0, -windAngle, wind / 2);
        helmsman.steerWindAngle(windAngle);
    }

    /// To where nothing changes any more, with this sheet; the point that is then
    /// reached.
    PolarPoint settle(real sheet, real windAngle) {
        boat.setSheet(sheet);
        for (real time = 0; time < SETTLE; time += STEP) {
            helmsman.steer(boat, STEP);
            boat.swingBoom(STEP);
            world.startFrame();
            world.runPhysics(STEP);
        }
        const bool holdsCourse =
            std::fabs(wrapAngle(boat.getTrueWindAngle() - windAngle)) < HELD && !boat.isCapsized();
        PolarPoint point;
        point.windAngle = windAngle;
        point.speed = holdsCourse ? std::max(boat.getSpeed(), 0.0) : 0;
        point.madeGood = point.speed > 0 ? boat.getBody().getVelocity() * windspeed.unit() : 0;
        point.sail = -boat.getSail();
        point.heel = -boat.getHeel();
        point.apparentWindAngle = boat.getApparentWindAngle();
        return point;
    }

private:
    cyclone::World world;
    Vector3 windspeed;
    cyclone::Waves water;
    Catamaran boat;
    Helmsman helmsman;
};

bool isSlower(const PolarPoint &a, const PolarPoint &b) { return a.speed < b.speed; }
bool makesLessGood(const PolarPoint &a, const PolarPoint &b) { return a.madeGood < b.madeGood; }

}  // namespace

const PolarPoint &Polar::fastest() const { return *std::max_element(points.begin(), points.end(), isSlower); }

const PolarPoint &Polar::bestUpwind() const {
    return *std::max_element(points.begin(), points.end(), makesLessGood);
}

const PolarPoint &Polar::bestDownwind() const {
    return *std::min_element(points.begin(), points.end(), makesLessGood);
}

PolarPoint measurePoint(real windspeed, real windAngle) {
    const auto sailAt = [&](real sheet) { return Trial(windspeed, windAngle).settle(sheet, windAngle); };
    // A coarse search first, since there may be no way on at all where the sail is badly wrong; then closer.
    PolarPoint best = sailAt(0);
    for (real spacing : {0.15, 0.03, 0.006}) {
        const real middle = best.sail, reach = spacing == 0.15 ? Catamaran::MAX_SHEET : 4 * spacing;
        for (real sail = std::max(middle - reach, 0.0); sail < middle + reach + spacing / 2; sail += spacing)
            if (sail <= Catamaran::MAX_SHEET) best = std::max(best, sailAt(sail), isSlower);
    }
    return best;
}

Polar measurePolar(real windspeed, unsigned intervals) {
    Polar polar;
    polar.windspeed = windspeed;
    for (unsigned n = 0; n <= intervals; ++n)
        polar.points.push_back(measurePoint(windspeed, REAL_PI * n / intervals));
    return polar;
}

}  // namespace sailboat
