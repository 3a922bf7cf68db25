#include "shell/stage.h"

#include <algorithm>
#include <cmath>

namespace demo {

namespace {

constexpr Colour WIND{26, 36, 84};
constexpr real WIND_SCALE = 0.06;     // of the wind's arrow, m for each m/s and m of distance
constexpr real LOWEST_EYE = 0.4;      // m
constexpr real SWING_TIME = 0.5;      // s, of the chase camera
constexpr real FIELD_OF_VIEW = 0.85;  // rad

Vector3 mixed(const Vector3 &a, const Vector3 &b, real share) { return a + (b - a) * share; }

Vector3 horizontal(const Vector3 &v) { return Vector3(v.x, 0, v.z).unit(); }

}  // namespace

Frame interpolated(const Frame &a, const Frame &b, real share) {
    if (b.cut || a.poses.size() != b.poses.size() || a.arrows.size() != b.arrows.size()) return b;
    Frame frame = b;
    frame.time = a.time + (b.time - a.time) * share;
    frame.windspeed = mixed(a.windspeed, b.windspeed, share);
    for (std::size_t n = 0; n < b.poses.size(); ++n) {
        frame.poses[n].position = mixed(a.poses[n].position, b.poses[n].position, share);
        frame.poses[n].orientation =
            Quaternion::linearInterpolate(a.poses[n].orientation, b.poses[n].orientation, share);
    }
    for (std::size_t n = 0; n < b.arrows.size(); ++n) {
        frame.arrows[n].tail = mixed(a.arrows[n].tail, b.arrows[n].tail, share);
        frame.arrows[n].vector = mixed(a.arrows[n].vector, b.arrows[n].vector, share);
    }
    return frame;
}

std::string Stage::getName(Viewpoint viewpoint) {
    switch (viewpoint) {
        case Viewpoint::SPECTATOR:
            return "spectator";
        case Viewpoint::CHASE:
            return "chase";
        case Viewpoint::SIDE:
            return "side";
    }
    return "";
}

Camera Stage::aim(const Frame &frame, real elapsed) {
    const Pose &body = frame.poses.front();
    const Vector3 ahead = horizontal(body.orientation.rotate(Vector3::X));
    const real share = frame.cut || behind == Vector3() ? 1 : 1 - std::exp(-elapsed / SWING_TIME);
    behind = horizontal(mixed(behind, ahead, share));
    if (behind == Vector3()) behind = Vector3::X;

    Camera camera;
    camera.target = body.position + Vector3::UP * profile.outlook.height;
    camera.fieldOfView = FIELD_OF_VIEW;
    const real distance = profile.outlook.distance / zoom;
    if (viewpoint == Viewpoint::CHASE) {
        camera.eye = camera.target - behind * distance + Vector3::UP * (0.3 * distance);
    } else if (viewpoint == Viewpoint::SIDE) {
        // From port, where the sun is at the start, and a little from behind.
        const Vector3 port = Vector3::UP % behind;
        camera.eye = camera.target + (port * 0.8 - behind * 0.5 + Vector3::UP * 0.3) * distance;
    } else {
        camera.eye = profile.outlook.spectator;
        if (profile.outlook.spectatorFollows) camera.eye += Vector3(body.position.x, 0, body.position.z);
        // A spectator who is far off looks through glasses that make up for part of the distance.
        const real away = std::max((camera.target - camera.eye).magnitude() / profile.outlook.distance, 1.0);
        camera.fieldOfView = std::clamp(FIELD_OF_VIEW / zoom / std::pow(away, 0.8), 0.02, 1.6);
    }
    camera.eye.y = std::max(camera.eye.y, LOWEST_EYE);
    return camera;
}

void Stage::draw(Canvas &canvas, int columns, int rows, const Frame &frame, real elapsed) {
    canvas.begin(columns, rows, aim(frame, elapsed));
    canvas.draw(profile.surroundings, frame.time);
    for (const Part &paint : profile.paint) canvas.drawOnGround(paint, Pose());
    for (std::size_t n = 0; n < profile.parts.size(); ++n)
        canvas.drawShadow(profile.parts[n], frame.poses[n]);
    for (std::size_t n = 0; n < profile.parts.size(); ++n) canvas.draw(profile.parts[n], frame.poses[n]);
    if (showForces)
        for (const Arrow &arrow : frame.arrows) canvas.draw(arrow);

    const Vector3 middle = frame.poses.front().position + Vector3::UP * profile.outlook.windHeight;
    const Vector3 wind = -frame.windspeed * (WIND_SCALE * profile.outlook.distance);
    canvas.draw(Arrow{"wind", middle - wind * 0.5, wind, WIND});
}

}  // namespace demo
