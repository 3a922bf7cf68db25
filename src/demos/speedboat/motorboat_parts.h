#pragma once

/// What the motorboat looks like.
#include "picture/scene.h"
#include "speedboat/motorboat.h"

#include <vector>

namespace speedboat {

using namespace demo;

/// The boat with its crew, and its foils if it has any; the motor, whose screw is there in the boat. In this
/// order.
std::vector<Part> makeBoatParts(Hull hull, const Vector3 &screw);

/// Where those parts are.
std::vector<Pose> getBoatPoses(const Motorboat &boat);

/// The sheets of water that a planing hull throws aside, and the jet behind the screw.
std::vector<Part> makeSpray(Hull hull);
/// They come out of the sea with speed, and sink into it where there is nothing to throw.
std::vector<Pose> getSprayPoses(const Motorboat &boat, const cyclone::Water &water, Hull hull);

}  // namespace speedboat
