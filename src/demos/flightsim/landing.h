#pragma once

/// How well a touch-down on the runway went.
#include "models/verdict.h"

#include <cyclone/body.h>

namespace flightsim {

using namespace demo;
using cyclone::RigidBody;
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

/// `worst` is the most of each that is still fair.
Verdict judge(const Landing &landing, const Landing &worst);

/// "0.3 m/s, 5 m beyond the aim, bank 1°: fair, far from the aim".
std::string describe(const Landing &landing, const Landing &worst);

}  // namespace flightsim
