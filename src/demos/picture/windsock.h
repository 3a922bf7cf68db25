#pragma once

/// A windsock on its pole.
#include "picture/scene.h"

namespace demo {

constexpr real WINDSOCK_HEIGHT = 3;  ///< m

std::vector<Part> makeWindsockParts();
/// windspeed: at the sock, m/s, towards where the wind comes from.
std::vector<Pose> poseWindsock(const Vector3 &foot, const Vector3 &windspeed);

}  // namespace demo
