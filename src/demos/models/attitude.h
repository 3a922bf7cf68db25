#pragma once

/// How a vehicle lies and where things are, in a pilot's words. Its body axes are +X forward, +Y up, +Z
/// starboard.
#include <cyclone/body.h>

#include <string>

namespace demo {

using cyclone::real;
using cyclone::RigidBody;

/// rad, −π … π: clockwise from +X as seen from above.
real headingOf(const RigidBody &body);
/// rad, positive with the nose up.
real pitchOf(const RigidBody &body);
/// rad, −π … π: positive to starboard.
real bankOf(const RigidBody &body);

/// "83m 63S": a place is 83 m away along the ground, 63° off the nose to starboard.
std::string whereabouts(const RigidBody &body, const cyclone::Vector3 &place);

}  // namespace demo
