#include "flightsim/aircraft_parts.h"

#include "picture/solids.h"

namespace flightsim {

namespace {

constexpr Colour RED{214, 62, 44}, CREAM{246, 240, 222}, DARK{52, 56, 64}, BLUE{44, 92, 150},
    WOOD{168, 120, 72}, GLASS{120, 170, 200}, TARMAC{92, 94, 98}, WHITE{236, 236, 232};
constexpr real DEGREE = cyclone::REAL_PI / 180;

const Vector3 FLAP_HINGE(0.12, 0.352, 0.38), RUDDER_HINGE(-0.9, 0.3, 0), PROPELLER_HUB(0.48, 0.1, 0);

/// A wing's section across z, from leading to trailing edge.
std::vector<Vector3> section(real leading, real trailing, real y, real z) {
    const real chord = leading - trailing;
    return {{leading, y, z},
            {leading - 0.25 * chord, y + 0.09 * chord, z},
            {trailing, y + 0.004, z},
            {trailing, y - 0.004, z},
            {leading - 0.3 * chord, y - 0.03 * chord, z}};
}

Part makeBody() {
    Part part{"airframe", {}, false};
    // Fuselage: spinner to tail.
    addLoft(part,
            {ringAcrossX({-0.95, 0.12, 0}, 0.03, 0.015), ringAcrossX({-0.45, 0.1, 0}, 0.07, 0.05),
             ringAcrossX({-0.1, 0.08, 0}, 0.15, 0.1), ringAcrossX({0.2, 0.08, 0}, 0.16, 0.105),
             ringAcrossX({0.38, 0.09, 0}, 0.11, 0.09), ringAcrossX({0.46, 0.1, 0}, 0.05, 0.05)},
            CREAM);
    addBox(part, {-0.02, 0.18, -0.075}, {0.22, 0.33, 0.075}, GLASS);
    // Wings and their struts.
    addLoft(
        part,
        {section(0.34, 0.12, 0.352, -0.75), section(0.44, 0.12, 0.35, 0), section(0.34, 0.12, 0.352, 0.75)},
        RED);
    for (const real side : {-1.0, 1.0})
        addBar(part, {0.22, 0, 0.09 * side}, {0.25, 0.36, 0.42 * side}, 0.018, DARK);
    // Fin, and the tailplane on top of it.
    addLoft(part,
            {{{-0.9, 0.13, -0.012}, {-0.6, 0.13, -0.012}, {-0.6, 0.13, 0.012}, {-0.9, 0.13, 0.012}},
             {{-0.9, 0.5, -0.008}, {-0.78, 0.5, -0.008}, {-0.78, 0.5, 0.008}, {-0.9, 0.5, 0.008}}},
            BLUE);
    addLoft(
        part,
        {section(-0.58, -0.78, 0.4, -0.36), section(-0.5, -0.78, 0.4, 0), section(-0.58, -0.78, 0.4, 0.36)},
        BLUE);
    // Undercarriage.
    const real bottom = -Aircraft::WHEEL_HEIGHT;
    addBar(part, {0.33, 0, 0}, {0.35, bottom + 0.05, 0}, 0.016, DARK);
    for (const real side : {-1.0, 1.0})
        addBar(part, {-0.1, 0, 0}, {-0.12, bottom + 0.05, 0.28 * side}, 0.018, DARK);
    for (const Vector3 &wheel :
         {Vector3(0.35, bottom, 0), Vector3(-0.12, bottom, -0.3), Vector3(-0.12, bottom, 0.3)})
        addWheel(part, wheel, 0.05, 0.03, DARK);
    return part;
}

Part makeFlap(const std::string &name) {
    Part part{name, {}, false};
    addLoft(part,
            {{{0, 0.006, -0.3}, {-0.1, 0, -0.3}, {0, -0.006, -0.3}},
             {{0, 0.006, 0.3}, {-0.1, 0, 0.3}, {0, -0.006, 0.3}}},
            CREAM);
    return part;
}

Part makeRudder() {
    Part part{"rudder", {}, false};
    addLoft(part,
            {{{-0.12, -0.2, 0}, {0, -0.2, -0.01}, {0, -0.2, 0.01}},
             {{-0.1, 0.2, 0}, {0, 0.2, -0.008}, {0, 0.2, 0.008}}},
            RED);
    return part;
}

Part makePropeller() {
    Part part{"propeller", {}, true};
    for (const real side : {-1.0, 1.0})
        addFace(part,
                {{0.01, 0, -0.012},
                 {-0.01, 0, 0.012},
                 {-0.006, 0.19 * side, 0.016},
                 {0.006, 0.19 * side, -0.016}},
                WOOD);
    addLoft(part, {ringAcrossX({-0.01, 0, 0}, 0.035, 0.035), ringAcrossX({0.05, 0, 0}, 0.008, 0.008)}, RED);
    return part;
}

}  // namespace

const Vector3 WINDSOCK_PLACE(30, 0, -9);

std::vector<Part> makeAircraftParts() {
    return {makeBody(), makeFlap("port flap"), makeFlap("starboard flap"), makeRudder(), makePropeller()};
}

std::vector<Pose> poseAircraft(const Aircraft &aircraft, real propellerAngle) {
    const RigidBody &body = aircraft.getBody();
    const FlightControls &sticks = aircraft.getControls();
    const Vector3 portHinge(FLAP_HINGE.x, FLAP_HINGE.y, -FLAP_HINGE.z);
    const real both = 20 * DEGREE * sticks.pitch, opposite = 20 * DEGREE * sticks.roll;
    return {poseOn(body, Vector3(), Vector3::X, 0), poseOn(body, portHinge, Vector3::Z, both + opposite),
            poseOn(body, FLAP_HINGE, Vector3::Z, both - opposite),
            poseOn(body, RUDDER_HINGE, Vector3::Y, 25 * DEGREE * sticks.rudder),
            poseOn(body, PROPELLER_HUB, Vector3::X, propellerAngle)};
}

std::vector<Part> paintRunway() {
    std::vector<Part> paint = {paintRectangle("runway", -12, 112, -4, 4, TARMAC)};
    for (int n = 0; n < 12; ++n)
        paint.push_back(paintRectangle("stripe", -2 + 9.0 * n, 2 + 9.0 * n, -0.12, 0.12, WHITE));
    for (const real z : {-3.2, -2.2, -1.2, 1.2, 2.2, 3.2})
        paint.push_back(paintRectangle("threshold", -10.5, -6.5, z - 0.3, z + 0.3, WHITE));
    return paint;
}

}  // namespace flightsim
