#include "airrace/parts.h"

#include "picture/solids.h"

namespace airrace {

using namespace demo;
using cyclone::real_atan2;
using cyclone::real_cos;
using cyclone::real_sin;

namespace {

constexpr Colour GLASS{96, 140, 170}, DARK{52, 56, 64}, STEEL{150, 156, 164}, QUIET{206, 212, 218},
    NEXT{255, 96, 24}, SECOND{250, 210, 70}, GHOST{190, 226, 255}, SMOKE{62, 60, 62}, CHALK{240, 240, 236};
constexpr real TUBE = 0.9, NEXT_TUBE = 2, SECOND_TUBE = 1.4;  // m, thickness of a hoop
constexpr int SIDES = 20;                                     // of a hoop
constexpr real POINTER_HEIGHT = 3.4;                          // m above the aircraft

struct Livery {
    const char *name;
    Colour main, trim;
};
constexpr Livery LIVERIES[] = {{"bullet", {196, 40, 36}, {250, 240, 220}},
                               {"gnat", {250, 196, 40}, {40, 44, 60}},
                               {"swallow", {40, 84, 168}, {246, 246, 246}}};

Livery liveryOf(const Model &model) {
    for (const Livery &livery : LIVERIES)
        if (livery.name == model.name) return livery;
    return LIVERIES[0];
}

/// A wing's section across z: a diamond, pointed at the rear.
std::vector<Vector3> section(real leading, real trailing, real y, real z, real thickness) {
    const real fore = leading - 0.3 * (leading - trailing);
    return {{leading, y, z}, {fore, y + thickness, z}, {trailing, y, z}, {fore, y - thickness, z}};
}

Part makeAirframe(const std::string &name, real span, Colour main, Colour trim, Colour glass) {
    Part part{name, {}, false};
    addLoft(part,
            {ringAcrossX({-4.4, 0.1, 0}, 0.1, 0.08), ringAcrossX({-2, 0.02, 0}, 0.34, 0.28),
             ringAcrossX({0.2, 0, 0}, 0.55, 0.42), ringAcrossX({1.6, 0, 0}, 0.5, 0.42),
             ringAcrossX({2.1, 0, 0}, 0.32, 0.32), ringAcrossX({2.5, 0, 0}, 0.05, 0.05)},
            main);
    addLoft(part,
            {ringAcrossX({-1.5, 0.4, 0}, 0.05, 0.1), ringAcrossX({-0.6, 0.5, 0}, 0.28, 0.26),
             ringAcrossX({0.5, 0.45, 0}, 0.1, 0.2)},
            glass);
    addLoft(part,
            {section(0.25, -0.45, 0.1, -span / 2, 0.05), section(0.6, -0.8, -0.1, 0, 0.12),
             section(0.25, -0.45, 0.1, span / 2, 0.05)},
            {trim, main}, trim);
    addLoft(part,
            {section(-3.8, -4.3, 0.1, -1.4, 0.03), section(-3.5, -4.4, 0.1, 0, 0.05),
             section(-3.8, -4.3, 0.1, 1.4, 0.03)},
            trim);
    addLoft(part,
            {{{-4.5, 0.1, -0.05}, {-3.2, 0.1, -0.05}, {-3.2, 0.1, 0.05}, {-4.5, 0.1, 0.05}},
             {{-4.6, 1.5, -0.03}, {-4.0, 1.5, -0.03}, {-4.0, 1.5, 0.03}, {-4.6, 1.5, 0.03}}},
            trim);
    return part;
}

/// A ring in the plane x = 0 about the origin, outside of the radius.
void addHoop(Part &part, const Pose &pose, real radius, real tube, Colour colour) {
    std::vector<std::vector<Vector3>> rings;
    for (int n = 0; n <= SIDES; ++n) {
        const real angle = 2 * cyclone::REAL_PI * n / SIDES, y = real_cos(angle), z = real_sin(angle);
        const auto point = [&](real along, real out) {
            return pose.position +
                   pose.orientation.rotate(Vector3(along, (radius + out) * y, (radius + out) * z));
        };
        rings.push_back(
            {point(tube / 2, 0), point(tube / 2, tube), point(-tube / 2, tube), point(-tube / 2, 0)});
    }
    addLoft(part, rings, colour);
}

Quaternion towards(const Vector3 &direction) {
    const real across = cyclone::real_sqrt(direction.x * direction.x + direction.z * direction.z);
    return Quaternion::fromAxisAngle(Vector3::Y, real_atan2(-direction.z, direction.x)) *
           Quaternion::fromAxisAngle(Vector3::Z, real_atan2(direction.y, across));
}

}  // namespace

Part makeAircraftPart(const Model &model) {
    const Livery livery = liveryOf(model);
    return makeAirframe(model.name, model.span, livery.main, livery.trim, GLASS);
}

Part makeGhostPart(const Model &model) {
    return makeAirframe("ghost of the best lap", model.span, GHOST, GHOST, GHOST);
}

Part makeSmoke() {
    Part part{"smoke", {}, false};
    // Rings across x, turned upright: x is up here.
    std::vector<std::vector<Vector3>> rings;
    const real radii[] = {0.6, 2.2, 3, 4.4, 5, 2};
    for (int n = 0; n < 6; ++n) rings.push_back(ringAcrossX({5.0 * n, 0.4 * n, 0.9 * n}, radii[n], radii[n]));
    for (std::vector<Vector3> &ring : rings)
        for (Vector3 &corner : ring) corner = Vector3(-corner.y, corner.x, corner.z);
    addLoft(part, rings, SMOKE);
    return part;
}

std::vector<Part> makeHoops(const std::vector<Hoop> &course) {
    std::vector<Part> parts;
    for (std::size_t n = 0; n < course.size(); ++n) {
        const Hoop &hoop = course[n];
        Part part{"hoop " + std::to_string(n + 1), {}, false};
        addHoop(part, poseMarker(hoop), hoop.radius, TUBE, n == 0 ? CHALK : QUIET);
        const Vector3 foot(hoop.centre.x, 0, hoop.centre.z);
        addBar(part, foot, hoop.centre - Vector3::UP * hoop.radius, TUBE, STEEL);
        parts.push_back(part);
    }
    return parts;
}

std::vector<Part> paintStartLine(const Hoop &first) {
    std::vector<Part> paint;
    const auto add = [&](real x1, real x2, real z1, real z2, Colour colour) {
        const Vector3 &c = first.centre;
        paint.push_back({"start line",
                         {{{{c.x + x1, 0, c.z + z2},
                            {c.x + x2, 0, c.z + z2},
                            {c.x + x2, 0, c.z + z1},
                            {c.x + x1, 0, c.z + z1}},
                           colour}},
                         false});
    };
    constexpr real SQUARE = 5;
    add(-2 * SQUARE, 2 * SQUARE, -8 * SQUARE, 8 * SQUARE, DARK);
    for (int row = -2; row < 2; ++row)
        for (int column = -8; column < 8; ++column)
            if ((row + column) % 2 == 0)
                add(row * SQUARE, (row + 1) * SQUARE, column * SQUARE, (column + 1) * SQUARE, CHALK);
    return paint;
}

Part makeNextMarker(real radius) {
    Part part{"next hoop", {}, true};
    addHoop(part, Pose(), radius - 0.1, NEXT_TUBE, NEXT);
    return part;
}

Part makeSecondMarker(real radius) {
    Part part{"hoop after it", {}, true};
    addHoop(part, Pose(), radius - 0.05, SECOND_TUBE, SECOND);
    return part;
}

Pose poseMarker(const Hoop &hoop) { return {hoop.centre, towards(hoop.axis)}; }

Part makePointer() {
    Part part{"pointer", {}, true};
    const Vector3 tip(1.6, 0, 0), notch(-0.3, 0, 0);
    for (const Vector3 &barb :
         {Vector3(-0.8, 0, 0.9), Vector3(-0.8, 0, -0.9), Vector3(-0.8, 0.5, 0), Vector3(-0.8, -0.5, 0)})
        addFace(part, {tip, notch, barb}, NEXT);
    return part;
}

Pose posePointer(const Pose &aircraft, const Vector3 &place) {
    const Vector3 above = aircraft.position + Vector3::UP * POINTER_HEIGHT;
    return {above, towards(place - above)};
}

}  // namespace airrace
