#pragma once

/// How well a touch-down went, and how a flight ended otherwise.
#include "models/attitude.h"

#include <string>
#include <vector>

namespace flightsim {

using namespace demo;
using cyclone::Vector3;

/// Along the X axis. Whoever lands along +X aims at x = aim, along −X at x = oppositeAim.
struct Runway {
    real aim = 0, oppositeAim = 0;
};

/// At the moment when the wheels touch.
struct Landing {
    real sinkRate = 0;   ///< m/s, downwards
    real beyondAim = 0;  ///< m; negative: short of it
    real offLine = 0;    ///< m, from the runway's middle line to either side
    real bank = 0;       ///< rad, to either side
    real drift = 0;      ///< rad, between where the nose points and where it goes, to either side
};

/// velocity: the body's just before the touch, when the wheels had not changed it.
Landing measureLanding(const RigidBody &body, const Vector3 &velocity, const Runway &runway);

enum class Mark { POOR, FAIR, GOOD, EXCELLENT };
std::string getName(Mark mark);

/// The mark is that of the worst part. `worst` is the most of each that is still fair; three fifths of it are
/// good, three tenths excellent.
Mark judge(const Landing &landing, const Landing &worst);

/// "0.3 m/s, 5 m beyond the aim, bank 1°: fair, far from the aim": the part that cost the most is named with
/// the lower marks.
std::string describe(const Landing &landing, const Landing &worst);

/// All landings of a run.
class LandingLog {
public:
    LandingLog() = default;
    explicit LandingLog(const Landing &w) : worst(w) {}

    void add(const Landing &landing);
    unsigned getCount() const { return count; }
    /// "Landings: 2, the best at 0.3 m/s, …".
    std::string getSummary() const;

private:
    Landing worst, best;
    unsigned count = 0;
};

/// A point of an aircraft that must not touch the ground, in body coordinates.
struct HullPoint {
    const char *name;  ///< of the part: "a wing tip"
    Vector3 point;
};

/// The name of the first part that is in the ground; empty if none is.
std::string findBrokenPart(const RigidBody &body, const std::vector<HullPoint> &hull);

/// "crashed: a wing tip hit the ground at 9.1 m/s, bank 64°, nose 20° down". part: "a wing tip"; empty: the
/// body has faulted. velocity: just before.
std::string describeCrash(const std::string &part, const RigidBody &body, const Vector3 &velocity);

}  // namespace flightsim
