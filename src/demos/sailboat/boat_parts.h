#pragma once

/// What the catamaran looks like.
#include "picture/scene.h"
#include "sailboat/boat.h"

#include <vector>

namespace sailboat {

using namespace demo;

/// Hulls with beams, trampoline, crew and mast; sail; rudder. In this order.
std::vector<Part> makeBoatParts();

/// Where those parts are.
std::vector<Pose> getBoatPoses(const Catamaran &boat);

}  // namespace sailboat
