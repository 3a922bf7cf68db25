#include "speedboat/motorboat.h"

#include "base/angle.h"

#include <algorithm>
#include <array>

namespace speedboat {

namespace {

using cyclone::Buoyancy;
using cyclone::Matrix3;
using cyclone::PointForce;
using cyclone::Wing;

// ---- The hull

/// A piece of the hull from keel to chine, on both sides.
struct Section {
    real x, length;        // of its middle; m
    real rise, incidence;  // of the keel towards the bow: m, rad
    real fullness;         // its share of the beam
};

constexpr std::array<Section, 6> SECTIONS = {{
    {-0.94, 0.6, 0, 0, 1},
    {-0.34, 0.6, 0, 0, 1},
    {0.31, 0.7, 0, 0, 1},
    {1.06, 0.8, 0, 0, 1},
    {1.96, 1.0, 0.02, 0.03, 0.9},
    {3.06, 1.2, 0.14, 0.14, 0.6},
}};
constexpr real SIDE = 0.5;      // m from the keel to where a half section's forces act
constexpr real DEADRISE = 0.3;  // rad
constexpr Matrix3 INERTIA(280, 0, 0, 0, 1300, 0, 0, 0, 1200);  // kg·m²

/// Near the keel a V has little volume; the floats begin above it.
constexpr real FLOAT_RISE = 0.26, FLOAT_HALF_DEPTH = 0.3, FLOAT_FULLNESS = 0.8;
/// Of half a section that is wholly under water.
constexpr Vector3 HULL_LINEAR(10, 500, 100), HULL_QUADRATIC(3, 50, 100);

/// A half section's bottom works in full at this depth of the keel, m.
constexpr real BOTTOM_DEPTH = 0.1;
/// For the lift of planing surfaces some two beams long with that deadrise (Savitsky 1964).
constexpr real BOTTOM_ASPECT_RATIO = 0.25;
constexpr real WATER_DENSITY = 1000;  // kg/m³
constexpr real FRICTION = 0.01;

constexpr real SKEG_X = -0.7, SKEG_SPAN = 0.2, SKEG_CHORD = 0.7;  // m

/// In air, by axis: ahead, up and down, sideways.
constexpr Matrix3 TOPSIDES(-8, 0, 0, 0, -20, 0, 0, 0, -30);
constexpr Vector3 TOPSIDES_CENTRE(-0.2, 0.2, 0);

// ---- Motor and foils

const Vector3 SCREW(-1.75, -0.5, 0), FOIL_SCREW(-1.75, -1.4, 0);

constexpr real FOIL_CAMBER = 0.05;  // rad, as lift without incidence
constexpr real FOIL_DRAG = 0.02;
constexpr real STRUT_X = 0.2, STRUT_SPAN = 0.9, STRUT_CHORD = 0.08;  // m

RigidBody makeBody() {
    RigidBody body;
    body.setMass(Motorboat::MASS);
    body.setInertiaTensor(INERTIA);
    body.setAcceleration(Vector3::GRAVITY);
    return body;
}

/// Rises outwards by `dihedral` on that side (−1 port, 1 starboard).
Quaternion tilted(real side, real dihedral, real incidence) {
    return Quaternion::fromAxisAngle(Vector3::X, -side * dihedral) *
           Quaternion::fromAxisAngle(Vector3::Z, incidence);
}

cyclone::WingSection makeProfile(real camber, real drag) {
    cyclone::WingSection profile;
    profile.zeroLiftAngle = -camber;
    profile.leastDrag = drag;
    return profile;
}

Buoyancy makeFloat(const Section &section, real side) {
    const real depth = 2 * FLOAT_HALF_DEPTH, halfBeam = section.fullness * Motorboat::BEAM / 2;
    const Vector3 centre(section.x, Motorboat::KEEL + section.rise + FLOAT_RISE + FLOAT_HALF_DEPTH,
                         side * SIDE * section.fullness);
    return Buoyancy(centre, FLOAT_HALF_DEPTH, section.length * halfBeam * depth * FLOAT_FULLNESS, 0,
                    WATER_DENSITY);
}

Wing makeBottom(const Section &section, real side) {
    const Vector3 quarterChord(section.x + section.length / 4, Motorboat::KEEL + section.rise,
                               side * SIDE * section.fullness);
    Wing plate(section.fullness * Motorboat::BEAM / 2, section.length, quarterChord, nullptr);
    plate.setSection(makeProfile(0, FRICTION));
    plate.setAspectRatio(BOTTOM_ASPECT_RATIO);
    plate.setOrientation(tilted(side, DEADRISE, section.incidence));
    return plate;
}

Wing makeFoil(const Motorboat::FoilPlan &plan, real side) {
    Wing foil(plan.span, plan.chord, Vector3(plan.x, Motorboat::FOIL_Y, side * Motorboat::FOIL_SIDE),
              nullptr);
    foil.setSection(makeProfile(FOIL_CAMBER, FOIL_DRAG));
    foil.setOrientation(tilted(side, Motorboat::FOIL_DIHEDRAL, plan.incidence));
    return foil;
}

}  // namespace

Motorboat::Motorboat(cyclone::World &w, const Vector3 *windspeed, const cyclone::Water *sea, Hull hull)
    : world(w),
      water(sea),
      body(makeBody()),
      motor(Vector3::X, hull == Hull::FOILS ? FOIL_SCREW : SCREW, MAX_THRUST,
            hull == Hull::FOILS ? FOIL_PITCH_SPEED : PITCH_SPEED, nullptr),
      topsides(TOPSIDES, TOPSIDES_CENTRE, windspeed) {
    addHull();
    if (hull == Hull::FOILS) addFoils();
    motor.setWater(water, SCREW_RADIUS);
    topsides.setRotationalFlow(true);
    registerForces();
    launch(0, 0, 0);
}

Motorboat::~Motorboat() { world.removeBody(&body); }

void Motorboat::addHull() {
    floats.reserve(2 * SECTIONS.size());  // the drags keep pointers to them
    for (const Section &section : SECTIONS)
        for (const real side : {-1.0, 1.0}) {
            floats.push_back(makeFloat(section, side));
            floats.back().setWater(water);
            drags.emplace_back(&floats.back(), floats.back().getPosition(), HULL_LINEAR, HULL_QUADRATIC);
            bottom.push_back(makeBottom(section, side));
            bottom.back().setWater(water, BOTTOM_DEPTH, WATER_DENSITY / 2);
        }
    addFin(Vector3(SKEG_X, KEEL - SKEG_SPAN / 2, 0), SKEG_SPAN, SKEG_CHORD);
}

void Motorboat::addFoils() {
    for (const FoilPlan &plan : {FRONT_FOILS, AFT_FOILS})
        for (const real side : {-1.0, 1.0}) {
            foils.push_back(makeFoil(plan, side));
            foils.back().setWater(water, FOIL_DEPTH, WATER_DENSITY);
        }
    addFin(Vector3(STRUT_X, FOIL_Y, 0), STRUT_SPAN, STRUT_CHORD);
}

/// Below the keel, upright.
void Motorboat::addFin(const Vector3 &position, real span, real chord) {
    fins.emplace_back(span, chord, position, nullptr);
    fins.back().setSection(makeProfile(0, FOIL_DRAG));
    fins.back().setOrientation(Quaternion::fromAxisAngle(Vector3::X, cyclone::REAL_PI / 2));
    fins.back().setWater(water, span, WATER_DENSITY);
}

void Motorboat::registerForces() {
    world.addBody(&body);
    cyclone::ForceRegistry &forces = world.getForceRegistry();
    for (Buoyancy &part : floats) forces.add(&body, &part);
    for (cyclone::HullDrag &drag : drags) forces.add(&body, &drag);
    for (std::vector<Wing> *wings : {&bottom, &foils, &fins})
        for (Wing &wing : *wings) forces.add(&body, &wing);
    forces.add(&body, &motor);
    forces.add(&body, &topsides);
}

void Motorboat::launch(real x, real z, real heading) {
    const real area = (BOW - STERN) * BEAM * FLOAT_FULLNESS;
    const real draught = FLOAT_RISE + MASS / (WATER_DENSITY * area);
    body.setAwake(false);  // at rest, and nothing remembered of the voyage before
    body.setAwake();
    body.setPosition(x, water->getHeight(Vector3(x, 0, z)) - KEEL - draught, z);
    body.setOrientation(Quaternion::fromAxisAngle(Vector3::UP, -heading));
    setThrottle(0);
    setSteering(0);
    setTilt(0);
}

void Motorboat::setSteering(real angle) {
    steering = cyclone::real_clamp(angle, -MAX_STEERING, MAX_STEERING);
    aimMotor();
}

void Motorboat::setTilt(real angle) {
    tilt = cyclone::real_clamp(angle, LEAST_TILT, MOST_TILT);
    aimMotor();
}

/// To turn to starboard it pushes the stern to port.
void Motorboat::aimMotor() {
    const Quaternion turned =
        Quaternion::fromAxisAngle(Vector3::UP, steering) * Quaternion::fromAxisAngle(Vector3::Z, -tilt);
    motor.setDirection(turned.rotate(Vector3::X));
}

real Motorboat::getSpeed() const {
    const Vector3 velocity = body.getVelocity();
    return demo::horizontalLength(velocity);
}

real Motorboat::getDraught() const {
    const Vector3 keel = body.getPointInWorldSpace(Vector3(0, KEEL, 0));
    return water->getHeight(keel) - keel.y;
}

/// Of the point where it acts; negative above the water.
real Motorboat::getDepth(const PointForce &part) const {
    const Vector3 point = body.getPointInWorldSpace(part.getPosition());
    return water->getHeight(point) - point.y;
}

real Motorboat::getWettedLength() const {
    real length = 0;
    for (std::size_t n = 0; n < bottom.size(); ++n)
        length += cyclone::real_clamp(getDepth(bottom[n]) / BOTTOM_DEPTH, 0, 1) * SECTIONS[n / 2].length / 2;
    return length;
}

bool Motorboat::isScrewDry() const { return getDepth(motor) <= -SCREW_RADIUS; }

bool Motorboat::isAirborne() const {
    const auto isDry = [this](const Wing &wing) { return getDepth(wing) <= 0; };
    return std::all_of(bottom.begin(), bottom.end(), isDry) &&
           std::all_of(foils.begin(), foils.end(), isDry) &&
           std::all_of(floats.begin(), floats.end(),
                       [this](const Buoyancy &part) { return part.getSubmersion(body) == 0; });
}

bool Motorboat::isCapsized() const { return body.getDirectionInWorldSpace(Vector3::Y).y < 0; }

}  // namespace speedboat
