#include "vtol/parts.h"

#include "base/angle.h"
#include "picture/solids.h"
#include "vtol/pad.h"

namespace vtol {

namespace {

constexpr Colour GREY{150, 160, 172}, BELLY{196, 202, 206}, GLASS{60, 84, 110}, DARK{52, 56, 64},
    RED{206, 52, 44}, WHITE{238, 238, 234}, TARMAC{88, 92, 98}, YELLOW{244, 200, 60}, FLAME{255, 214, 150};
constexpr real SEEN_THRUST = 0.4 * Jet::MAX_THRUST;  // N, from which on one sees the exhaust
constexpr real HALF_SPAN = Jet::SPAN / 2;
const Vector3 AILERON_HINGE(-0.72, 0.16, 2.7), TAIL_HINGE(-3.8, 0.5, 0), RUDDER_HINGE(-4.3, 1.1, 0);
const Vector3 NOZZLES[] = {Vector3(0.9, -0.15, 0.62), Vector3(0.9, -0.15, -0.62), Vector3(-0.9, -0.15, 0.6),
                           Vector3(-0.9, -0.15, -0.6)};

/// A wing's section across z: a diamond, pointed at the rear.
std::vector<Vector3> section(real leading, real trailing, real y, real z, real thickness) {
    const real fore = leading - 0.3 * (leading - trailing);
    return {{leading, y, z}, {fore, y + thickness, z}, {trailing, y, z}, {fore, y - thickness, z}};
}

void addFuselage(Part &part) {
    addLoft(part,
            {ringAcrossX({-4.4, 0.15, 0}, 0.1, 0.08), ringAcrossX({-2.4, 0.05, 0}, 0.4, 0.34),
             ringAcrossX({-0.8, 0, 0}, 0.6, 0.52), ringAcrossX({0.9, 0, 0}, 0.62, 0.56),
             ringAcrossX({2.2, -0.05, 0}, 0.45, 0.38), ringAcrossX({3.5, -0.15, 0}, 0.05, 0.05)},
            {GREY, GREY, BELLY, BELLY, BELLY, BELLY, GREY, GREY}, DARK);
    addLoft(part,
            {ringAcrossX({0.4, 0.45, 0}, 0.08, 0.14), ringAcrossX({1.3, 0.5, 0}, 0.3, 0.26),
             ringAcrossX({2.4, 0.2, 0}, 0.08, 0.14)},
            GLASS);
    for (const real side : {-1.0, 1.0})  // air intakes
        addLoft(part,
                {ringAcrossX({-0.2, 0.1, 0.5 * side}, 0.3, 0.16),
                 ringAcrossX({1.15, 0.1, 0.58 * side}, 0.42, 0.2)},
                {GREY}, DARK);
}

void addWings(Part &part) {
    addLoft(part,
            {section(-0.2, -0.75, 0.1, -HALF_SPAN, 0.03), section(0.75, -0.85, 0.3, 0, 0.1),
             section(-0.2, -0.75, 0.1, HALF_SPAN, 0.03)},
            GREY);
    for (const real side : {-1.0, 1.0})
        addBar(part, {-0.35, 0.1, HALF_SPAN * side}, {-0.8, 0.1, HALF_SPAN * side}, 0.09, RED);
    addLoft(part,
            {{{-4.35, 0.3, -0.05}, {-3.1, 0.3, -0.05}, {-3.1, 0.3, 0.05}, {-4.35, 0.3, 0.05}},
             {{-4.4, 1.9, -0.03}, {-3.95, 1.9, -0.03}, {-3.95, 1.9, 0.03}, {-4.4, 1.9, 0.03}}},
            GREY);
}

void addUndercarriage(Part &part) {
    const real bottom = -Jet::WHEEL_HEIGHT;
    for (const Vector3 &wheel :
         {Vector3(2, bottom, 0), Vector3(-0.9, bottom, 1.2), Vector3(-0.9, bottom, -1.2)}) {
        addBar(part, {wheel.x, -0.2, 0.5 * wheel.z}, wheel + Vector3(0, 0.2, 0), 0.08, DARK);
        addWheel(part, wheel, 0.22, 0.2, DARK);
    }
}

Part makeAirframe() {
    Part part{"airframe", {}, false};
    addFuselage(part);
    addWings(part);
    addUndercarriage(part);
    return part;
}

/// It blows along its own −X, as when it drives the jet ahead.
Part makeNozzle() {
    Part part{"nozzle", {}, false};
    addLoft(part, {ringAcrossX({-0.55, 0, 0}, 0.17, 0.15), ringAcrossX({0.2, 0, 0}, 0.24, 0.2)}, {DARK}, RED);
    return part;
}

/// What one sees of the exhaust, behind the nozzle.
Part makeFlame() {
    Part part{"exhaust", {}, false};
    addLoft(part, {ringAcrossX({-1.9, 0, 0}, 0.02, 0.02), ringAcrossX({-0.57, 0, 0}, 0.14, 0.12)}, {FLAME},
            FLAME);
    return part;
}

/// Hinged at its origin's z axis.
Part makeFlap(const std::string &name, real ahead, real chord, real halfSpan, Colour colour) {
    Part part{name, {}, true};
    addFace(part,
            {{ahead, 0.01, -halfSpan},
             {ahead - chord, 0.01, -halfSpan},
             {ahead - chord, 0.01, halfSpan},
             {ahead, 0.01, halfSpan}},
            colour);
    return part;
}

Part makeRudder() {
    Part part{"rudder", {}, true};
    addFace(part, {{0, -0.7, 0}, {0, 0.75, 0}, {-0.35, 0.75, 0}, {-0.4, -0.7, 0}}, RED);
    return part;
}

Part paintDisc(const Pad &pad, real radius, Colour colour) {
    Part part{pad.name, {}, false};
    std::vector<Vector3> rim;
    constexpr int CORNERS = 24;
    for (int n = 0; n < CORNERS; ++n) {
        const real angle = -2 * cyclone::REAL_PI * n / CORNERS;
        rim.push_back(pad.centre + towardsBearing(angle) * radius);
    }
    addFace(part, rim, colour);
    return part;
}

}  // namespace

std::vector<Part> makeJetParts() {
    std::vector<Part> parts = {makeAirframe()};
    for (std::size_t n = 0; n < std::size(NOZZLES); ++n) {
        parts.push_back(makeNozzle());
        parts.push_back(makeFlame());
    }
    parts.push_back(makeFlap("port aileron", 0, 0.3, 1.0, RED));
    parts.push_back(makeFlap("starboard aileron", 0, 0.3, 1.0, RED));
    parts.push_back(makeFlap("tailplane", 0.3, 0.9, 1.5, GREY));
    parts.push_back(makeRudder());
    return parts;
}

std::vector<Pose> poseJet(const Jet &jet) {
    const RigidBody &body = jet.getBody();
    const JetControls &controls = jet.getControls();
    const Vector3 portHinge(AILERON_HINGE.x, AILERON_HINGE.y, -AILERON_HINGE.z);
    const real aileron = 2 * Jet::AILERON_THROW * controls.roll;  // so that one sees it
    std::vector<Pose> poses = {poseOn(body, Vector3(), Vector3::X, 0)};
    for (const Vector3 &nozzle : NOZZLES) {
        const Pose pose = poseOn(body, nozzle, Vector3::Z, jet.getNozzles());
        poses.push_back(pose);
        poses.push_back(jet.getThrust() > SEEN_THRUST ? pose : NOWHERE);
    }
    poses.push_back(poseOn(body, portHinge, Vector3::Z, aileron));
    poses.push_back(poseOn(body, AILERON_HINGE, Vector3::Z, -aileron));
    poses.push_back(poseOn(body, TAIL_HINGE, Vector3::Z, -Jet::ELEVATOR_THROW * controls.pitch));
    poses.push_back(poseOn(body, RUDDER_HINGE, Vector3::Y, Jet::RUDDER_THROW * controls.pedal));
    return poses;
}

std::vector<Part> paintPads() {
    std::vector<Part> paint;
    for (const Pad &pad : PADS) {
        const Vector3 &c = pad.centre;
        paint.push_back(paintDisc(pad, PAD_RADIUS, TARMAC));
        paint.push_back(paintDisc(pad, PAD_RADIUS - 0.8, YELLOW));
        paint.push_back(paintDisc(pad, PAD_RADIUS - 1.4, TARMAC));
        for (const real z : {-3.0, 3.0})
            paint.push_back(paintRectangle("H", c.x - 4.5, c.x + 4.5, c.z + z - 0.7, c.z + z + 0.7, WHITE));
        paint.push_back(paintRectangle("H", c.x - 0.7, c.x + 0.7, c.z - 3, c.z + 3, WHITE));
    }
    return paint;
}

}  // namespace vtol
