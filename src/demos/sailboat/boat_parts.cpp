#include "sailboat/boat_parts.h"

#include "picture/solids.h"

namespace sailboat {

namespace {

constexpr Colour HULL{236, 239, 242}, KEEL{196, 60, 48}, DECK{120, 170, 205}, BEAM{150, 158, 166},
    TRAMPOLINE{58, 66, 76}, JACKET{226, 120, 40}, SKIN{225, 178, 140}, CLOTH{250, 247, 236},
    PANEL{38, 98, 158}, FOIL{214, 186, 90};

const Vector3 MAST_FOOT(0.5, -0.05, 0), RUDDER_STOCK(-2.3, -0.15, 0);

/// A hull's cross section: deck, side, bottom.
std::vector<Vector3> makeSection(real x, real z, real halfWidth, real deck, real keel) {
    const real chine = Catamaran::HULL_HEIGHT;
    return {{x, deck, z - 0.8 * halfWidth},
            {x, deck, z + 0.8 * halfWidth},
            {x, chine, z + halfWidth},
            {x, keel, z},
            {x, chine, z - halfWidth}};
}

void addHull(Part &part, real z) {
    const real deck = Catamaran::HULL_HEIGHT + Catamaran::HULL_HALF_DEPTH;
    const real keel = Catamaran::HULL_HEIGHT - Catamaran::HULL_HALF_DEPTH;
    addLoft(part,
            {makeSection(-3, z, 0.17, deck - 0.1, keel + 0.25), makeSection(-1.2, z, 0.22, deck, keel),
             makeSection(0.8, z, 0.22, deck, keel), makeSection(2.2, z, 0.14, deck, keel + 0.05),
             makeSection(3.1, z, 0.02, deck + 0.02, keel + 0.35)},
            {DECK, HULL, KEEL, KEEL, HULL}, HULL);
}

void addCrewMember(Part &part, real x, real z) {
    addBox(part, {x - 0.15, -0.14, z - 0.22}, {x + 0.15, 0.4, z + 0.22}, JACKET);
    addBox(part, {x - 0.1, 0.42, z - 0.1}, {x + 0.1, 0.66, z + 0.1}, SKIN);
}

Part makeHulls() {
    Part part;
    part.name = "boat";
    const real half = Catamaran::HULL_SPACING / 2;
    addHull(part, -half);
    addHull(part, half);
    for (const real x : {-1.4, 0.5}) addBox(part, {x - 0.07, -0.2, -half}, {x + 0.07, -0.06, half}, BEAM);
    addBox(part, {-1.33, -0.14, -half + 0.2}, {0.43, -0.12, half - 0.2}, TRAMPOLINE);
    addBox(part, {-2.36, -0.2, -half}, {-2.24, -0.1, half}, BEAM);
    addCrewMember(part, -0.5, -0.35);
    addCrewMember(part, -0.5, 0.35);
    addBox(part, {0.44, -0.06, -0.05}, {0.56, 7.9, 0.05}, BEAM);
    return part;
}

/// How far behind the mast the cloth ends, at a height above the foot; the leech is round.
real leech(real share) { return 2.6 * (1 - share) + 1.1 * share * (1 - share) + 0.12; }

Part makeSail() {
    Part part;
    part.name = "sail";
    part.twoSided = true;
    const real foot = 0.75, head = 7.8;
    const int panels = 8;
    for (int n = 0; n < panels; ++n) {
        const real low = static_cast<real>(n) / panels, high = static_cast<real>(n + 1) / panels;
        const real yLow = foot + (head - foot) * low, yHigh = foot + (head - foot) * high;
        part.faces.push_back(
            {{{-0.06, yLow, 0}, {-0.06, yHigh, 0}, {-leech(high), yHigh, 0}, {-leech(low), yLow, 0}},
             n == 5 ? PANEL : CLOTH});
    }
    addBox(part, {-2.7, foot - 0.14, -0.04}, {-0.06, foot - 0.04, 0.04}, BEAM);  // the boom
    return part;
}

Part makeRudder() {
    Part part;
    part.name = "rudder";
    addBox(part, {-0.05, -0.5, -0.03}, {0.05, 0.2, 0.03}, BEAM);
    addBox(part, {-0.45, -1.5, -0.025}, {0.1, -0.45, 0.025}, FOIL);
    return part;
}

Pose hinge(const Catamaran &boat, const Vector3 &point, real angle) {
    const cyclone::RigidBody &body = boat.getBody();
    return {body.getPointInWorldSpace(point),
            body.getOrientation() * Quaternion::fromAxisAngle(Vector3::UP, angle)};
}

}  // namespace

std::vector<Part> makeBoatParts() { return {makeHulls(), makeSail(), makeRudder()}; }

std::vector<Pose> getBoatPoses(const Catamaran &boat) {
    const cyclone::RigidBody &body = boat.getBody();
    return {{body.getPosition(), body.getOrientation()},
            hinge(boat, MAST_FOOT, boat.getSail()),
            hinge(boat, RUDDER_STOCK, boat.getRudder())};
}

}  // namespace sailboat
