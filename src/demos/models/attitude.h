#pragma once

/// How a vehicle lies, in a pilot's words. Its body axes are +X forward, +Y up, +Z starboard.
#include <cyclone/body.h>

namespace demo {

using cyclone::real;
using cyclone::RigidBody;

/// rad, −π … π: clockwise from +X as seen from above.
real headingOf(const RigidBody &body);
/// rad, positive with the nose up.
real pitchOf(const RigidBody &body);
/// rad, −π … π: positive to starboard.
real bankOf(const RigidBody &body);

}  // namespace demo
