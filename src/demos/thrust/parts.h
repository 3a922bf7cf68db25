#pragma once

/// What ship, pod and rock look like.
#include "picture/scene.h"
#include "thrust/level.h"
#include "thrust/ship.h"

namespace thrust {

using namespace demo;

/// Hull, port fin, starboard fin and flame; pod; rod; a pointer to where to go. The rod lies along +X, from
/// the pod to its end.
std::vector<Body> makeBodies();

/// Where those parts are.
std::vector<Pose> getPoses(const Ship &ship);

/// Stars; the rock, and its surface as a bright edge.
std::vector<Part> makeRock(const Level &level);

}  // namespace thrust
