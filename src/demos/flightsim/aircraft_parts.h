#pragma once

/// What the aircraft and its airfield look like.
#include "flightsim/aircraft.h"
#include "picture/scene.h"

namespace flightsim {

/// The airframe, and what moves on it; and where those are. The propeller has turned by propellerAngle (rad).
std::vector<Part> makeAircraftParts();
std::vector<Pose> poseAircraft(const Aircraft &aircraft, real propellerAngle);

/// A windsock on its pole.
std::vector<Part> makeWindsockParts();
std::vector<Pose> poseWindsock(const Vector3 &windspeed);

/// A runway along +X, its middle line at z = 0.
std::vector<Part> paintRunway();

}  // namespace flightsim
