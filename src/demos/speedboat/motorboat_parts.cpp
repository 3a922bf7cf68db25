#include "speedboat/motorboat_parts.h"

#include "models/attitude.h"
#include "picture/solids.h"

namespace speedboat {

namespace {

constexpr Colour BOTTOM{198, 52, 44}, SIDE{240, 242, 244}, DECK{205, 172, 120}, FLOOR{120, 96, 70},
    GLASS{96, 140, 170}, SEAT{70, 78, 92}, JACKET{236, 150, 36}, SKIN{225, 178, 140}, COWL{40, 46, 58},
    LEG{96, 104, 116}, BRASS{214, 176, 84}, FOIL{168, 178, 190}, WATER{236, 246, 250};

constexpr real CHINE = -0.19, SHEER = 0.24;  // y, m
constexpr real SPRAY_HEIGHT = 0.6;           // m: so far it sinks
const Vector3 PIVOT(-1.38, 0.15, 0);         // of the motor, on the transom

/// Deck, side and bottom of the hull.
std::vector<Vector3> makeRing(real x, real halfBeam, real keel, real chine, real sheer) {
    return {{x, sheer, -0.97 * halfBeam},
            {x, sheer, 0.97 * halfBeam},
            {x, chine, halfBeam},
            {x, keel, 0},
            {x, chine, -halfBeam}};
}

void addHull(Part &part) {
    const real half = Motorboat::BEAM / 2, keel = Motorboat::KEEL;
    addLoft(part,
            {makeRing(Motorboat::STERN, half, keel, CHINE, SHEER), makeRing(1.4, half, keel, CHINE, SHEER),
             makeRing(2.4, 0.8 * half, keel + 0.05, CHINE + 0.06, SHEER + 0.04),
             makeRing(3.2, 0.42 * half, keel + 0.2, CHINE + 0.16, SHEER + 0.1),
             makeRing(Motorboat::BOW, 0.03, keel + 0.45, CHINE + 0.3, SHEER + 0.14)},
            {DECK, SIDE, BOTTOM, BOTTOM, SIDE}, SIDE);
}

void addCrew(Part &part, real x, real z) {
    addBox(part, {x - 0.5, SHEER, z - 0.26}, {x - 0.34, SHEER + 0.5, z + 0.26}, SEAT);
    addBox(part, {x - 0.3, SHEER, z - 0.2}, {x, SHEER + 0.5, z + 0.2}, JACKET);
    addBox(part, {x - 0.26, SHEER + 0.52, z - 0.1}, {x - 0.06, SHEER + 0.76, z + 0.1}, SKIN);
}

void addCockpit(Part &part) {
    addBox(part, {-0.9, SHEER, -0.62}, {0.9, SHEER + 0.02, 0.62}, FLOOR);
    addBox(part, {0.9, SHEER, -0.66}, {1.1, SHEER + 0.36, 0.66}, GLASS);
    addCrew(part, 0.5, -0.33);
    addCrew(part, 0.5, 0.33);
}

/// From its inner end to its outer one, and what holds them to the hull.
void addFoil(Part &part, const Motorboat::FoilPlan &plan, real side) {
    using M = Motorboat;
    const Vector3 middle(plan.x, M::FOIL_Y, side * M::FOIL_SIDE);
    const Vector3 half =
        Vector3(0, cyclone::real_sin(M::FOIL_DIHEDRAL), side * cyclone::real_cos(M::FOIL_DIHEDRAL)) *
        (plan.span / 2);
    const Vector3 nose(0.25 * plan.chord, 0, 0), tail(-0.75 * plan.chord, -0.01, 0), up(0, 0.02, 0);
    const auto ring = [&](const Vector3 &at) -> std::vector<Vector3> {
        return {at + nose, at + up, at + tail, at - up};
    };
    const Vector3 port = middle - half * side, starboard = middle + half * side;
    addLoft(part, {ring(side > 0 ? port : starboard), ring(side > 0 ? starboard : port)}, FOIL);
    addBar(part, middle + half, Vector3(plan.x, CHINE, side * 0.8), 0.06, FOIL);
    addBar(part, middle - half, Vector3(plan.x, M::KEEL, side * 0.1), 0.06, FOIL);
}

Part makeHullPart(Hull hull) {
    Part part;
    part.name = "boat";
    addHull(part);
    addCockpit(part);
    if (hull != Hull::FOILS) return part;
    for (const Motorboat::FoilPlan &plan : {Motorboat::FRONT_FOILS, Motorboat::AFT_FOILS})
        for (const real side : {-1.0, 1.0}) addFoil(part, plan, side);
    return part;
}

/// About its pivot; the screw is where the boat has it.
Part makeMotor(const Vector3 &screw) {
    Part part;
    part.name = "motor";
    const Vector3 hub = screw - PIVOT;
    addBox(part, {-0.5, 0.1, -0.22}, {0.06, 0.62, 0.22}, COWL);
    addBox(part, {-0.34, hub.y + 0.1, -0.05}, {-0.14, 0.12, 0.05}, LEG);
    addBox(part, {hub.x, hub.y - 0.05, -0.05}, {hub.x + 0.35, hub.y + 0.1, 0.05}, LEG);
    for (const real angle : {0.0, 1.0, 2.0}) {
        const real turn = angle * cyclone::REAL_PI * 2 / 3;
        addBar(
            part, hub,
            hub + Vector3(-0.02, cyclone::real_cos(turn), cyclone::real_sin(turn)) * Motorboat::SCREW_RADIUS,
            0.07, BRASS);
    }
    return part;
}

}  // namespace

std::vector<Part> makeBoatParts(Hull hull, const Vector3 &screw) {
    return {makeHullPart(hull), makeMotor(screw)};
}

std::vector<Pose> getBoatPoses(const Motorboat &boat) {
    const RigidBody &body = boat.getBody();
    const Quaternion turned = Quaternion::fromAxisAngle(Vector3::UP, boat.getSteering()) *
                              Quaternion::fromAxisAngle(Vector3::Z, -boat.getTilt());
    return {{body.getPosition(), body.getOrientation()},
            {body.getPointInWorldSpace(PIVOT), body.getOrientation() * turned}};
}

std::vector<Part> makeSpray(Hull hull) {
    Part jet{"jet", {}, true};
    for (const real side : {-1.0, 1.0})
        addFace(jet, {{0, -0.2, 0}, {-1.2, 0.35, 0.25 * side}, {-3, -0.2, 0.5 * side}}, WATER);
    if (hull == Hull::FOILS) return {jet};
    Part sheets{"sheets", {}, true};
    for (const real side : {-1.0, 1.0}) {
        addFace(sheets, {{0.9, -0.2, 0.5 * side}, {-0.4, 0.28, 1.5 * side}, {-1.2, -0.2, 0.9 * side}}, WATER);
        addFace(sheets, {{-1.2, -0.2, 0.9 * side}, {-0.4, 0.28, 1.5 * side}, {-2.6, -0.2, 1.9 * side}},
                WATER);
    }
    return {jet, sheets};
}

std::vector<Pose> getSprayPoses(const Motorboat &boat, const cyclone::Water &water, Hull hull) {
    const RigidBody &body = boat.getBody();
    const Quaternion level = Quaternion::fromAxisAngle(Vector3::UP, -headingOf(body));
    const auto place = [&](const Vector3 &bodyPoint, real strength) {
        Vector3 point = body.getPointInWorldSpace(bodyPoint);
        point.y = water.getHeight(point) - SPRAY_HEIGHT * (1 - cyclone::real_clamp(strength, 0, 1));
        return Pose{point, level};
    };
    const real thrust = boat.getThrust().magnitude() / Motorboat::MAX_THRUST;
    const Pose jet = place(boat.getScrew(), 4 * thrust);
    if (hull == Hull::FOILS) return {jet};
    const real front = Motorboat::STERN + boat.getWettedLength();
    const real speed = boat.getWettedLength() > 0 ? boat.getSpeed() : 0;
    return {jet, place(Vector3(front, 0, 0), (speed - 3) / 7)};
}

}  // namespace speedboat
