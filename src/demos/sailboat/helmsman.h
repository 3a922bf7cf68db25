#pragma once

/// Who sails the boat when nobody else does.
#include "sailboat/boat.h"

namespace sailboat {

/// Holds a course with the rudder and trims the sail to the apparent wind, no faster than hands can. A new
/// course is reached by the shorter way round: from close hauled to close hauled through the wind's eye (a
/// tack), from run to run the other way (a gybe).
///
/// A boat that loses her way head to wind is in irons. He then holds the sail out to the side that is to be
/// leeward, so that she gathers sternway, steers her stern round, and falls off until she sails again.
class Helmsman {
public:
    /// Steers for this compass heading.
    void steerHeading(real heading);
    /// Steers for this angle to the true wind: positive with the wind over the starboard side.
    void steerWindAngle(real angle);

    /// The sheet with which the sail drives best: the boom then bisects the angle between the stern and where
    /// the wind goes.
    static real bestSheet(const Catamaran &boat);

    /// Works the boat's rudder, sheet and boom for a step of `duration` seconds.
    void sail(Catamaran &boat, real duration);
    /// Works the rudder only.
    void steer(Catamaran &boat, real duration) const;

    /// For how long the boat has been in irons, or not yet sailing again, s; 0: she sails.
    real getTimeInIrons() const { return timeInIrons; }

private:
    real wantedWindAngle(const Catamaran &boat) const;
    void watchForIrons(const Catamaran &boat, real duration);

    real course = 0;
    bool relativeToWind = false;
    real timeInIrons = 0;
    bool backsSail = false;
    real fallOffSide = 1;  ///< in irons: 1 to bring the wind over the starboard side, else −1
};

}  // namespace sailboat
