#include "picture/stage.h"

#include <algorithm>
#include <cmath>

namespace demo {

namespace {

constexpr Colour WIND{26, 36, 84}, WIND_IN_SPACE{150, 175, 230};
constexpr real WIND_SCALE = 0.06;     // of the wind's arrow, m for each m/s and m of distance
constexpr real LOWEST_EYE = 0.4;      // m
constexpr real SWING_TIME = 0.5;      // s, of the chase camera
constexpr real FIELD_OF_VIEW = 0.85;  // rad
constexpr real FLATNESS = 40;         // how much farther off the flat view is taken from
constexpr real GHOST_OPACITY = 0.4;
constexpr Colour TRAIL{232, 120, 80};
constexpr real TRAIL_PIECE = 0.02;  // of the cameras' distance
constexpr std::size_t TRAIL_PIECES = 600;

Vector3 horizontal(const Vector3 &v) { return Vector3(v.x, 0, v.z).unit(); }

}  // namespace

Stage::Stage(const Scene &s) : viewpoint(s.cameras.viewpoints.front()), scene(s), trails(s.bodies.size()) {}

void Stage::nextViewpoint() {
    const std::vector<Viewpoint> &all = scene.cameras.viewpoints;
    const auto at = std::find(all.begin(), all.end(), viewpoint);
    viewpoint = at == all.end() || at + 1 == all.end() ? all.front() : *(at + 1);
}

std::string Stage::getName(Viewpoint viewpoint) {
    switch (viewpoint) {
        case Viewpoint::SPECTATOR:
            return "spectator";
        case Viewpoint::CHASE:
            return "chase";
        case Viewpoint::SIDE:
            return "side";
        case Viewpoint::PLANE:
            return "plane";
    }
    return "";
}

Camera Stage::aim(const Frame &frame, real elapsed) {
    const CameraSettings &cameras = scene.cameras;
    const Pose &body = frame.poses.front();
    const Vector3 ahead = horizontal(body.orientation.rotate(Vector3::X));
    const real share = frame.cut || behind == Vector3() ? 1 : 1 - std::exp(-elapsed / SWING_TIME);
    behind = horizontal(mix(behind, ahead, share));
    if (behind == Vector3()) behind = Vector3::X;

    Camera camera;
    camera.target = body.position + Vector3::UP * cameras.height;
    camera.fieldOfView = FIELD_OF_VIEW;
    const real distance = cameras.distance / zoom;
    switch (viewpoint) {
        case Viewpoint::CHASE:
            camera.eye = camera.target - behind * distance + Vector3::UP * (0.3 * distance);
            break;
        case Viewpoint::SIDE: {
            // From port, where the sun is at the start, and a little from behind.
            const Vector3 port = Vector3::UP % behind;
            camera.eye = camera.target + (port * 0.8 - behind * 0.5 + Vector3::UP * 0.3) * distance;
            break;
        }
        case Viewpoint::SPECTATOR: {
            camera.eye = cameras.spectator;
            if (cameras.spectatorFollows) {
                camera.eye += Vector3(body.position.x, 0, body.position.z);
                camera.eye.y = std::max(camera.eye.y, body.position.y);
            }
            // A spectator who is far off looks through glasses that make up for part of the distance.
            const real away = std::max((camera.target - camera.eye).magnitude() / cameras.distance, 1.0);
            camera.fieldOfView = std::clamp(FIELD_OF_VIEW / zoom / std::pow(away, 0.8), 0.02, 1.6);
            break;
        }
        case Viewpoint::PLANE:
            camera.eye = camera.target + Vector3::Z * (FLATNESS * distance);
            camera.fieldOfView = 2 * std::atan(std::tan(FIELD_OF_VIEW / 2) / FLATNESS);
            return camera;
    }
    if (scene.surroundings.terrain != Terrain::SPACE) camera.eye.y = std::max(camera.eye.y, LOWEST_EYE);
    return camera;
}

void Stage::draw(Canvas &canvas, int columns, int rows, const Frame &frame, real elapsed) {
    canvas.begin(columns, rows, aim(frame, elapsed));
    canvas.isFlat = viewpoint == Viewpoint::PLANE;
    canvas.draw(scene.surroundings, frame.time);
    for (const Part &paint : scene.paint) canvas.drawOnGround(paint, Pose());
    for (const Part &fixture : scene.fixtures) canvas.drawShadow(fixture, Pose());
    for (const Part &fixture : scene.fixtures) canvas.draw(fixture, Pose());
    drawBodies(canvas, frame);
    follow(frame);
    if (viewpoint == Viewpoint::PLANE) drawTrails(canvas);
    if (showForces)
        for (const Arrow &arrow : frame.arrows) canvas.draw(arrow);

    const Vector3 middle = frame.poses.front().position + Vector3::UP * scene.cameras.windHeight;
    const Vector3 wind = -frame.windspeed * (WIND_SCALE * scene.cameras.distance);
    const bool isDark = scene.surroundings.terrain == Terrain::SPACE;
    const Arrow arrow{"wind", middle - wind * 0.5, wind, isDark ? WIND_IN_SPACE : WIND};
    canvas.draw(arrow);
    if (wind != Vector3()) canvas.label(arrow);
}

/// Shadows first, and last what one sees through.
void Stage::drawBodies(Canvas &canvas, const Frame &frame) const {
    const auto forEachPart = [&](bool ofGhosts, auto visit) {
        std::size_t index = 0;
        for (const Body &body : scene.bodies)
            for (const Part &part : body.parts) {
                const Pose &pose = frame.poses[index++];
                if (body.isGhost == ofGhosts) visit(part, pose);
            }
    };
    forEachPart(false, [&](const Part &part, const Pose &pose) { canvas.drawShadow(part, pose); });
    forEachPart(false, [&](const Part &part, const Pose &pose) { canvas.draw(part, pose); });
    forEachPart(true, [&](const Part &part, const Pose &pose) { canvas.draw(part, pose, GHOST_OPACITY); });
}

void Stage::follow(const Frame &frame) {
    std::size_t index = 0;
    for (std::size_t n = 0; n < scene.bodies.size(); index += scene.bodies[n++].parts.size()) {
        std::deque<Vector3> &trail = trails[n];
        if (frame.cut) trail.clear();
        if (!scene.bodies[n].leavesTrail) continue;
        const Vector3 place = frame.poses[index].position;
        if (trail.empty() || (place - trail.back()).magnitude() > TRAIL_PIECE * scene.cameras.distance)
            trail.push_back(place);
        if (trail.size() > TRAIL_PIECES) trail.pop_front();
    }
}

void Stage::drawTrails(Canvas &canvas) const {
    for (const std::deque<Vector3> &trail : trails)
        for (std::size_t n = 1; n < trail.size(); ++n) canvas.drawLine(trail[n - 1], trail[n], TRAIL);
}

}  // namespace demo
