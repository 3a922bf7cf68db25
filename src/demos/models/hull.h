#pragma once

/// What of an aircraft must not touch the ground.
#include <cyclone/body.h>

#include <string>
#include <vector>

namespace demo {

using cyclone::real;
using cyclone::RigidBody;
using cyclone::Vector3;

/// A point of an aircraft that must not touch the ground, in body coordinates.
struct HullPoint {
    const char *name;  ///< of the part: "a wing tip"
    Vector3 point;
};

/// The name of the first part that is in the ground, the plane y = 0; empty if none is.
std::string findBrokenPart(const RigidBody &body, const std::vector<HullPoint> &hull);

/// "crashed: a wing tip hit the ground at 9.1 m/s, bank 64°, nose 20° down". part: "a wing tip"; empty: the
/// body has faulted. velocity: just before.
std::string describeCrash(const std::string &part, const RigidBody &body, const Vector3 &velocity);

}  // namespace demo
