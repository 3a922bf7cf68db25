#pragma once

/// Who sails the boat when nobody else does.
#include "sailboat/boat.h"

namespace sailboat {

/// Holds a course with the rudder and trims the sail to the apparent wind, no faster than hands can. A new
/// course is reached by the shorter way round: from close hauled to close hauled through the wind's eye (a
/// tack), from run to run the other way (a gybe).
class Helmsman {
public:
    /// Steers for this compass heading.
    void steerHeading(real heading);
    /// Steers for this angle to the true wind: positive with the wind over the starboard side.
    void steerWindAngle(real angle);

    /// The sail as it drives best: the boom bisects the angle between the stern and where the wind goes.
    /// With the wind astern it may be out on either side, and stays where it is.
    static real bestSail(const Catamaran &boat);

    /// Works the boat's rudder and sail for a step of `duration` seconds.
    void sail(Catamaran &boat, real duration) const;
    /// Works the rudder only.
    void steer(Catamaran &boat, real duration) const;

private:
    real course = 0;
    bool relativeToWind = false;
};

}  // namespace sailboat
