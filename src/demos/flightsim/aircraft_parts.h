#pragma once

/// What the aircraft and its airfield look like.
#include "flightsim/aircraft.h"
#include "picture/scene.h"

namespace demo {

/// The aircraft: its body first, then what moves on it. After it the windsock.
std::vector<Part> makeFlightParts();

/// A pose for each of those. The propeller has turned by propellerAngle (rad).
std::vector<Pose> poseFlightParts(const Aircraft &aircraft, real propellerAngle, const Vector3 &windspeed);

/// A runway along +X, its middle line at z = 0.
std::vector<Part> paintRunway();

}  // namespace demo
