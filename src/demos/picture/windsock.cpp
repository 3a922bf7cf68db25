#include "picture/windsock.h"

#include "picture/solids.h"

namespace demo {

namespace {

constexpr Colour WHITE{236, 236, 232}, ORANGE{240, 130, 30};

Part makePole() {
    Part part{"pole", {}, false};
    addBar(part, {0, -WINDSOCK_HEIGHT, 0}, {0, 0.2, 0}, 0.08, WHITE);
    return part;
}

/// It points along its own +X, away from the pole.
Part makeWindsock() {
    Part part{"windsock", {}, true};
    const Colour bands[] = {ORANGE, WHITE, ORANGE, WHITE};
    real x = 0;
    for (const Colour band : bands) {
        const real radius = 0.3 - 0.06 * x;
        addLoft(part,
                {ringAcrossX({x, 0, 0}, radius, radius, 6),
                 ringAcrossX({x + 0.5, 0, 0}, radius - 0.03, radius - 0.03, 6)},
                band);
        x += 0.5;
    }
    return part;
}

/// Blown out by the wind, and hanging where there is none.
Quaternion windsockOrientation(const Vector3 &windspeed) {
    const Vector3 downwind = -windspeed;
    const real speed = windspeed.magnitude();
    const real droop = cyclone::real_atan2(1.5, speed * speed);
    const Quaternion turn =
        Quaternion::fromAxisAngle(Vector3::Y, cyclone::real_atan2(-downwind.z, speed > 0 ? downwind.x : 1));
    return turn * Quaternion::fromAxisAngle(Vector3::Z, -droop);
}

}  // namespace

std::vector<Part> makeWindsockParts() { return {makePole(), makeWindsock()}; }

std::vector<Pose> poseWindsock(const Vector3 &foot, const Vector3 &windspeed) {
    const Vector3 top = foot + Vector3::UP * WINDSOCK_HEIGHT;
    return {{top, Quaternion()}, {top, windsockOrientation(windspeed)}};
}

}  // namespace demo
