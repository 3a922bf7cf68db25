#pragma once

/// How fast the catamaran is at every angle to the wind.
#include "sailboat/boat.h"

#include <vector>

namespace sailboat {

/// The boat on a steady course, with the sail where it makes her fastest.
struct PolarPoint {
    real windAngle = 0;  ///< of the course steered, off the true wind, rad: 0 … π
    real speed = 0;      ///< m/s ahead; 0 where she can't hold the course
    real madeGood = 0;   ///< m/s against the wind, leeway included
    real sail = 0, heel = 0, apparentWindAngle = 0;  ///< rad, all to leeward or windward as positive numbers
};

/// At one wind speed, in order of the wind angle.
struct Polar {
    real windspeed = 0;  ///< m/s
    std::vector<PolarPoint> points;

    const PolarPoint &fastest() const;
    const PolarPoint &bestUpwind() const;
    const PolarPoint &bestDownwind() const;
};

/// Sails the boat until its speed is steady, with the sail at many angles: the best for one course.
PolarPoint measurePoint(real windspeed, real windAngle);

/// From head to wind to dead before it in `intervals` equal steps.
Polar measurePolar(real windspeed, unsigned intervals);

}  // namespace sailboat
