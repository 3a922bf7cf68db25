#include "models/hull.h"

#include <cmath>

#include "base/text.h"
#include "models/attitude.h"

namespace demo {

std::string findBrokenPart(const RigidBody &body, const std::vector<HullPoint> &hull) {
    for (const HullPoint &part : hull)
        if (body.getPointInWorldSpace(part.point).y < 0) return part.name;
    return "";
}

std::string describeCrash(const std::string &part, const RigidBody &body, const Vector3 &velocity) {
    constexpr real DEGREE = cyclone::REAL_PI / 180;
    if (part.empty()) return "crashed: broke up in the air";
    const real pitch = pitchOf(body) / DEGREE;
    return "crashed: " + part + " hit the ground at " + fixed(velocity.magnitude(), 0) + " m/s, bank " +
           fixed(std::fabs(bankOf(body)) / DEGREE, 0) + "°, nose " + fixed(std::fabs(pitch), 0) + "° " +
           (pitch < 0 ? "down" : "up");
}

}  // namespace demo
