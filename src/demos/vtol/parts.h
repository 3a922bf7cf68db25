#pragma once

/// What the jet and its pads look like.
#include "picture/scene.h"
#include "vtol/jet.h"

namespace vtol {

/// The airframe, and what moves on it: four nozzles and their exhaust, ailerons, tailplane, rudder; and where
/// those are.
std::vector<Part> makeJetParts();
std::vector<Pose> poseJet(const Jet &jet);

/// A disc with an H for each pad.
std::vector<Part> paintPads();

}  // namespace vtol
