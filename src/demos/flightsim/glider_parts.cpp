#include "flightsim/glider_parts.h"

#include "picture/solids.h"

namespace flightsim {

namespace {

constexpr Colour WHITE{244, 244, 240}, RED{206, 48, 40}, GLASS{120, 160, 190}, GREY{150, 154, 160},
    CLOUD{250, 250, 252}, MOWN{132, 172, 96}, CHALK{236, 236, 232};
constexpr real HALF_SPAN = Glider::SPAN / 2, TIP_Y = 0.68;
const Vector3 AILERON_HINGE(-0.22, 0.56, 0.375 * Glider::SPAN), ELEVATOR_HINGE(-4.42, 1.2, 0),
    RUDDER_HINGE(-4.55, 0.6, 0), BRAKES(-0.05, 0.42, 0);

/// A wing's section across z: a thin diamond, pointed at the rear.
std::vector<Vector3> section(real leading, real trailing, real y, real z, real thickness) {
    const real fore = leading - 0.3 * (leading - trailing);
    return {{leading, y, z}, {fore, y + thickness, z}, {trailing, y, z}, {fore, y - 0.5 * thickness, z}};
}

Part makeAirframe() {
    Part part{"airframe", {}, false};
    addLoft(part,
            {ringAcrossX({-4.75, 0.2, 0}, 0.09, 0.06), ringAcrossX({-2, 0.1, 0}, 0.16, 0.14),
             ringAcrossX({-0.6, 0.05, 0}, 0.32, 0.27), ringAcrossX({0.5, 0, 0}, 0.44, 0.31),
             ringAcrossX({1.5, -0.05, 0}, 0.36, 0.27), ringAcrossX({2.2, -0.15, 0}, 0.1, 0.1)},
            WHITE);
    addLoft(part,
            {ringAcrossX({0.25, 0.34, 0}, 0.1, 0.2), ringAcrossX({0.8, 0.36, 0}, 0.2, 0.24),
             ringAcrossX({1.7, 0.15, 0}, 0.08, 0.12)},
            GLASS);
    addLoft(part,
            {section(0.18, -0.14, TIP_Y, -HALF_SPAN, 0.03), section(0.3, -0.3, 0.5, -0.55 * HALF_SPAN, 0.05),
             section(0.34, -0.46, 0.32, 0, 0.07), section(0.3, -0.3, 0.5, 0.55 * HALF_SPAN, 0.05),
             section(0.18, -0.14, TIP_Y, HALF_SPAN, 0.03)},
            WHITE);
    addLoft(part,
            {{{-4.7, 0.1, -0.03}, {-4.0, 0.1, -0.03}, {-4.0, 0.1, 0.03}, {-4.7, 0.1, 0.03}},
             {{-4.75, 1.25, -0.02}, {-4.35, 1.25, -0.02}, {-4.35, 1.25, 0.02}, {-4.75, 1.25, 0.02}}},
            RED);
    addLoft(part,
            {section(-4.05, -4.4, 1.2, -1.3, 0.02), section(-3.95, -4.45, 1.2, 0, 0.03),
             section(-4.05, -4.4, 1.2, 1.3, 0.02)},
            WHITE);
    addBar(part, {0.12, -0.2, 0}, {0.12, -Glider::WHEEL_HEIGHT, 0}, 0.14, GREY);
    return part;
}

/// Hinged at its origin's z axis, towards −X.
Part makeFlap(const std::string &name, real chord, real halfSpan) {
    Part part{name, {}, true};
    addFace(part,
            {{0, 0.01, -halfSpan}, {-chord, 0.01, -halfSpan}, {-chord, 0.01, halfSpan}, {0, 0.01, halfSpan}},
            RED);
    return part;
}

Part makeRudder() {
    Part part{"rudder", {}, true};
    addFace(part, {{0, -0.45, 0}, {0, 0.6, 0}, {-0.3, 0.6, 0}, {-0.4, -0.45, 0}}, RED);
    return part;
}

Part makeBrakes() {
    Part part{"airbrakes", {}, true};
    for (const real side : {-1.0, 1.0})
        addFace(part,
                {{0, -0.25, 2.2 * side}, {0, 0, 2.2 * side}, {0, 0.08, 3.4 * side}, {0, -0.17, 3.4 * side}},
                GREY);
    return part;
}

/// A heap: rings across x that swell and shrink, flat below.
Part makeCloud(const Vector3 &base) {
    Part part{"cloud", {}, false};
    const real radii[] = {20, 130, 180, 150, 60}, heights[] = {15, 80, 130, 100, 30};
    std::vector<std::vector<Vector3>> rings;
    for (int n = 0; n < 5; ++n) {
        const real x = base.x + 100 * (n - 2);
        std::vector<Vector3> ring = ringAcrossX({x, base.y, base.z}, heights[n], radii[n], 10);
        for (Vector3 &corner : ring)
            if (corner.y < base.y) corner.y = base.y;
        rings.push_back(ring);
    }
    addLoft(part, rings, CLOUD);
    return part;
}

}  // namespace

std::vector<Part> makeGliderParts() {
    return {makeAirframe(),
            makeFlap("port aileron", 0.14, 1.8),
            makeFlap("starboard aileron", 0.14, 1.8),
            makeFlap("elevator", 0.2, 1.25),
            makeRudder(),
            makeBrakes()};
}

std::vector<Pose> poseGlider(const Glider &glider) {
    const RigidBody &body = glider.getBody();
    const GliderControls &controls = glider.getControls();
    const Vector3 portHinge(AILERON_HINGE.x, AILERON_HINGE.y, -AILERON_HINGE.z);
    const real aileron = Glider::AILERON_THROW * controls.roll;
    return {poseOn(body, Vector3(), Vector3::X, 0),
            poseOn(body, portHinge, Vector3::Z, aileron),
            poseOn(body, AILERON_HINGE, Vector3::Z, -aileron),
            poseOn(body, ELEVATOR_HINGE, Vector3::Z, -Glider::ELEVATOR_THROW * controls.pull),
            poseOn(body, RUDDER_HINGE, Vector3::Y, Glider::RUDDER_THROW * controls.pedal),
            poseOn(body, BRAKES + Vector3(0, 0.27 * controls.brakes, 0), Vector3::X, 0)};
}

std::vector<Part> paintAirfield() {
    std::vector<Part> paint = {paintRectangle("runway", -500, 500, -15, 15, MOWN)};
    for (const real x : {-1.0, 1.0})
        for (const real z : {-15.0, -5.0, 5.0})
            paint.push_back(paintRectangle("threshold", 480 * x - 15, 480 * x + 15, z, z + 10 - 4, CHALK));
    for (int n = -9; n <= 9; ++n)
        paint.push_back(paintRectangle("stripe", 50.0 * n - 6, 50.0 * n + 6, -0.4, 0.4, CHALK));
    return paint;
}

std::vector<Part> makeClouds(const std::vector<Vector3> &places) {
    std::vector<Part> clouds;
    for (const Vector3 &place : places) clouds.push_back(makeCloud(place));
    return clouds;
}

}  // namespace flightsim
