#pragma once

/// What the glider, its airfield and the clouds look like.
#include "flightsim/glider.h"
#include "picture/scene.h"

namespace flightsim {

std::vector<Part> makeGliderParts();
std::vector<Pose> poseGlider(const Glider &glider);

/// A long runway of grass along +X, its middle line at z = 0.
std::vector<Part> paintAirfield();

/// A cumulus at each place: the middle of its base.
std::vector<Part> makeClouds(const std::vector<Vector3> &places);

}  // namespace flightsim
