#pragma once

/// The glider's pilot: looks for thermals under the clouds, circles in them, and comes home.
#include "flightsim/glider.h"

#include <string>
#include <vector>

namespace flightsim {

/// The runway lies along X at z = 0. The pilot knows what a pilot sees: position, attitude, airspeed,
/// variometer, windsock, and the clouds; not where the air rises.
class Soarer {
public:
    enum class Leg { SEARCH, CIRCLE, RETURN, DOWNWIND, BASE, FINAL, FLARE, ROLL_OUT, STOPPED };

    Soarer() = default;
    /// clouds: their places; the height does not matter. He lands into the wind, which comes from windFrom.
    Soarer(const std::vector<Vector3> &clouds, const Vector3 &windFrom);

    /// The controls for the next step of `duration` s. vario: what the variometer shows, m/s.
    GliderControls fly(const Glider &glider, real vario, real duration);

    Leg getLeg() const { return leg; }
    static std::string getName(Leg leg);
    /// m: gained in thermals so far.
    real getHeightGained() const { return gained; }

private:
    void chooseLeg(const Glider &glider, real duration);
    bool leavesThermal(real height, real duration);
    void chooseCloud(const Vector3 &position);
    Vector3 toRunway(const Vector3 &v) const { return Vector3(v.x * direction, v.y, v.z * direction); }

    void holdSpeed(const Glider &glider, real speed, real duration);
    void bankTo(const Glider &glider, real bank);
    void steerTowards(const Glider &glider, const Vector3 &target);
    void follow(const Glider &glider, real course, real offTrack);
    void circle(const Glider &glider, real duration);
    void brakeDownTo(const Glider &glider, real height);
    void land(const Glider &glider, real duration);

    Leg leg = Leg::SEARCH;
    GliderControls controls;
    std::vector<Vector3> clouds;  ///< not yet tried
    Vector3 cloud;                ///< the one he flies to
    Vector3 centre;               ///< of his circles
    bool hasCloud = false;
    real direction = 1;                ///< of the landing along X
    real vario = 0, averageClimb = 0;  ///< m/s: now, and over about a circle
    real time = 0, circled = 0, heightAtEntry = 0, gained = 0;
    real pitchTrim = 0;
};

}  // namespace flightsim
