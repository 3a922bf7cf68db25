#pragma once

/// What the race looks like.
#include "airrace/aircraft.h"
#include "airrace/hoop.h"
#include "picture/scene.h"

namespace airrace {

using demo::Part;
using demo::Pose;

/// One part for the whole of it: span and colours are the aircraft's own.
Part makeAircraftPart(const Model &model);
Part makeGhostPart(const Model &model);
/// Over a wreck.
Part makeSmoke();

/// All hoops on their masts, and the start line below the first; in world coordinates.
std::vector<Part> makeHoops(const std::vector<Hoop> &course);
std::vector<Part> paintStartLine(const Hoop &first);

/// What is put over the hoop that is next, and over the one after it.
Part makeNextMarker(real radius);
Part makeSecondMarker(real radius);
Pose poseMarker(const Hoop &hoop);

/// An arrow above the aircraft towards a place.
Part makePointer();
Pose posePointer(const Pose &aircraft, const Vector3 &place);

}  // namespace airrace
