#pragma once

/// What the aircraft and its airfield look like.
#include "flightsim/aircraft.h"
#include "picture/scene.h"

namespace flightsim {

/// The airframe, and what moves on it; and where those are. The propeller has turned by propellerAngle (rad).
std::vector<Part> makeAircraftParts();
std::vector<Pose> poseAircraft(const Aircraft &aircraft, real propellerAngle);

/// Where the windsock stands, its foot.
extern const Vector3 WINDSOCK_PLACE;

/// A runway along +X, its middle line at z = 0.
std::vector<Part> paintRunway();

}  // namespace flightsim
