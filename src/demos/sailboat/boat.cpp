#include "sailboat/boat.h"

#include <algorithm>
#include <cmath>

namespace sailboat {

namespace {

using cyclone::AngledAero;
using cyclone::Buoyancy;
using cyclone::Matrix3;
using cyclone::RigidBody;

/// A part of the boat, as a solid block.
struct Block {
    real mass;                  // kg
    Vector3 centre, halfSizes;  // m, body coordinates
};

/// Where the boat's mass is.
constexpr std::array<Block, 5> BLOCKS = {{
    {70, {0, -0.55, -1.4}, {3, 0.4, 0.2}},     // port hull
    {70, {0, -0.55, 1.4}, {3, 0.4, 0.2}},      // starboard hull
    {35, {0, -0.2, 0}, {1.2, 0.05, 1.4}},      // crossbeams and trampoline
    {150, {-0.1, -0.24, 0}, {0.3, 0.4, 0.6}},  // crew
    {30, {0.5, 4, 0}, {0.3, 4, 0.05}},         // mast and sail
}};

constexpr bool isBalanced() {
    Vector3 moment;
    for (const Block &block : BLOCKS) moment = moment + block.centre * block.mass;
    return moment * moment < 1e-18;
}
static_assert(isBalanced(), "A body's origin is its centre of mass.");

/// Wholly under water, a half hull: the quadratic part along the hull is what limits speed.
constexpr Vector3 HULL_LINEAR(4, 1200, 500), HULL_QUADRATIC(2, 150, 150);
/// A hull is deepest amidships: the water's resistance acts that much nearer to it than buoyancy.
constexpr real RESISTANCE_INWARDS = 0.6;

/// ½·ρ·c·A of a stern, wholly under water: c = 1.1, a plate's, and A = 0.15 m².
constexpr Vector3 TRANSOM(0.5 * 1000 * 1.1 * 0.15, 0, 0);

/// The sail's own axes: +X from the boom's end to the mast, +Y up the mast, +Z through the cloth. The same
/// for the rudder.
constexpr Matrix3 SAIL(-3.5, 0, 0, 0, -2, 0, 0, 0, -160), RUDDER(-1, 0, 0, 0, -1, 0, 0, 0, -250);
constexpr Vector3 SAIL_CENTRE(-0.6, 2.6, 0), RUDDER_CENTRE(-2.6, -1, 0);
constexpr real RUDDER_DEPTH = 0.25;  // m, of the centre of a rudder that is wholly under water

constexpr real HAND_RATE = 1;              // rad/s, of a boom that is hauled or held
constexpr real BOOM_LENGTH = 2.6;          // m
constexpr real ASTERN = 0.3;               // the wind is astern if it is within this of it, rad
constexpr real CALM = 0.1;                 // m/s: no wind swings the boom
constexpr real NO_GO = 0.5, NO_WAY = 0.5;  // rad off the wind, m/s: in irons below both

RigidBody makeBody() {
    real mass = 0;
    Matrix3 tensor;
    for (const Block &block : BLOCKS) {
        mass += block.mass;
        Matrix3 own, offset;
        own.setBlockInertiaTensor(block.halfSizes, block.mass);
        offset.setSkewSymmetric(block.centre);
        tensor += own + offset * offset * -block.mass;  // Huygens and Steiner: m·(c²·1 − c·cᵀ)
    }
    RigidBody body;
    body.setMass(mass);
    body.setInertiaTensor(tensor);
    body.setAcceleration(Vector3::GRAVITY);
    return body;
}

Buoyancy makeHull(unsigned halfHull) {
    return Buoyancy(Catamaran::getHullCentre(halfHull), Catamaran::HULL_HALF_DEPTH,
                    Catamaran::HALF_HULL_VOLUME, 0);
}

TransomDrag makeTransom(const Buoyancy *hull, unsigned halfHull) {
    Vector3 centre = Catamaran::getHullCentre(halfHull);
    centre.x = -Catamaran::LENGTH / 2;
    return TransomDrag(hull, centre, Vector3(), TRANSOM);
}

bool goesAstern(const RigidBody &body) { return body.getDirectionInLocalSpace(body.getVelocity()).x < 0; }

cyclone::HullDrag makeDrag(const Buoyancy *hull, unsigned halfHull) {
    Vector3 centre = Catamaran::getHullCentre(halfHull);
    centre.x *= RESISTANCE_INWARDS;
    return cyclone::HullDrag(hull, centre, HULL_LINEAR, HULL_QUADRATIC);
}

}  // namespace

Catamaran::Catamaran(cyclone::World &w, const Vector3 *wind, const cyclone::Water *surface)
    : world(w),
      windspeed(wind),
      water(surface),
      body(makeBody()),
      hulls{makeHull(0), makeHull(1), makeHull(2), makeHull(3)},
      drags{makeDrag(&hulls[0], 0), makeDrag(&hulls[1], 1), makeDrag(&hulls[2], 2), makeDrag(&hulls[3], 3)},
      transoms{makeTransom(&hulls[0], 0), makeTransom(&hulls[2], 2)},
      sail(SAIL, SAIL_CENTRE, wind, surface),
      rudder(RUDDER, RUDDER_CENTRE, nullptr) {
    world.addBody(&body);
    cyclone::ForceRegistry &forces = world.getForceRegistry();
    for (Buoyancy &hull : hulls) {
        hull.setWater(water);
        forces.add(&body, &hull);
    }
    for (cyclone::HullDrag &drag : drags) forces.add(&body, &drag);
    for (TransomDrag &transom : transoms) forces.add(&body, &transom);
    rudder.setWater(water, RUDDER_DEPTH);
    for (AngledAero *surfaceOf : {static_cast<AngledAero *>(&sail), &rudder}) {
        surfaceOf->setRotationalFlow(true);
        forces.add(&body, surfaceOf);
    }
    launch(0, 0, 0);
}

Catamaran::~Catamaran() { world.removeBody(&body); }

void Catamaran::launch(real x, real z, real heading, real speed) {
    const real carried = body.getMass() / (1000 * 4 * HALF_HULL_VOLUME);
    const real draught = HULL_HALF_DEPTH * (2 * carried - 1);  // of the hulls' middles
    const real level = water->getHeight(Vector3(x, 0, z));
    body.setAwake(false);  // at rest, and nothing remembered of the voyage before
    body.setAwake();
    body.setPosition(x, level - draught - HULL_HEIGHT, z);
    body.setOrientation(Quaternion::fromAxisAngle(Vector3::UP, -heading));
    body.setVelocity(body.getDirectionInWorldSpace(Vector3(speed, 0, 0)));
    setRudder(0);
    setSheet(0);
    holdBoom(0);
    setBoom(0);
}

void Catamaran::setRudder(real angle) {
    rudderAngle = cyclone::real_clamp(angle, -MAX_RUDDER, MAX_RUDDER);
    rudder.setOrientation(Quaternion::fromAxisAngle(Vector3::UP, rudderAngle));
}

void Catamaran::setSheet(real angle) { sheet = cyclone::real_clamp(angle, 0, MAX_SHEET); }

void Catamaran::holdBoom(real side) { heldSide = cyclone::real_clamp(side, -1, 1); }

void Catamaran::setBoom(real angle) {
    boomAngle = angle;
    sail.setOrientation(Quaternion::fromAxisAngle(Vector3::UP, angle));
}

real Catamaran::getBoomTarget() const {
    if (heldSide != 0) return heldSide * HELD_OUT;
    if (getApparentWindSpeed() < CALM) return cyclone::real_clamp(boomAngle, -sheet, sheet);
    const real flag = -getApparentWindAngle();
    const bool isAstern = cyclone::real_abs(flag) > cyclone::REAL_PI - ASTERN;
    if (isAstern && flag * boomAngle < 0) return boomAngle < 0 ? -sheet : sheet;
    return cyclone::real_clamp(flag, -sheet, sheet);
}

void Catamaran::swingBoom(real duration) {
    const bool isFree = heldSide == 0 && cyclone::real_abs(boomAngle) <= sheet;
    const real rate = isFree ? std::max(HAND_RATE, getApparentWindSpeed() / BOOM_LENGTH) : HAND_RATE;
    const real most = rate * duration;
    setBoom(boomAngle + cyclone::real_clamp(getBoomTarget() - boomAngle, -most, most));
}

Vector3 Catamaran::getHullCentre(unsigned halfHull) {
    return Vector3(halfHull % 2 == 0 ? -1.8 : 1.8, HULL_HEIGHT,
                   halfHull < 2 ? -HULL_SPACING / 2 : HULL_SPACING / 2);
}

real Catamaran::getHeading() const { return bearing(body.getDirectionInWorldSpace(Vector3::X)); }

real Catamaran::getSpeed() const { return body.getDirectionInLocalSpace(body.getVelocity()).x; }

real Catamaran::getLeeway() const {
    const Vector3 bow = body.getDirectionInWorldSpace(Vector3::X);
    const Vector3 starboard = Vector3(-bow.z, 0, bow.x).unit();
    return body.getVelocity() * starboard;
}

real Catamaran::getHeel() const {
    return cyclone::real_atan2(-body.getDirectionInWorldSpace(Vector3::Z).y,
                               body.getDirectionInWorldSpace(Vector3::Y).y);
}

real Catamaran::getTrim() const {
    return cyclone::real_asin(cyclone::real_clamp(body.getDirectionInWorldSpace(Vector3::X).y, -1, 1));
}

real Catamaran::getTurnRate() const { return -body.getRotation().y; }

real Catamaran::getTrueWindAngle() const { return wrapAngle(bearing(*windspeed) - getHeading()); }

Vector3 Catamaran::getApparentWind() const { return body.getVelocity() + *windspeed; }

real Catamaran::getApparentWindAngle() const { return wrapAngle(bearing(getApparentWind()) - getHeading()); }

real Catamaran::getApparentWindSpeed() const {
    const Vector3 wind = getApparentWind();
    return cyclone::real_sqrt(wind.x * wind.x + wind.z * wind.z);
}

bool Catamaran::isInIrons() const {
    return cyclone::real_abs(getTrueWindAngle()) < NO_GO && getSpeed() < NO_WAY && !isCapsized();
}

bool Catamaran::isCapsized() const { return body.getDirectionInWorldSpace(Vector3::Y).y < 0; }

Vector3 TransomDrag::getForce(const RigidBody &body) const {
    return goesAstern(body) ? HullDrag::getForce(body) : Vector3();
}

void TransomDrag::updateForce(RigidBody *body, real duration) {
    if (goesAstern(*body)) HullDrag::updateForce(body, duration);
}

void TransomDrag::addResistance(const RigidBody &body, cyclone::Resistance &sum) const {
    if (goesAstern(body)) HullDrag::addResistance(body, sum);
}

bool Sail::isDry(const RigidBody &body) const {
    const Vector3 centre = body.getPointInWorldSpace(getPosition());
    return centre.y > surface->getHeight(centre);
}

Vector3 Sail::getForce(const RigidBody &body) const {
    return isDry(body) ? AngledAero::getForce(body) : Vector3();
}

void Sail::updateForce(RigidBody *body, real duration) {
    if (isDry(*body)) AngledAero::updateForce(body, duration);
}

void Sail::addResistance(const RigidBody &body, cyclone::Resistance &sum) const {
    if (isDry(body)) AngledAero::addResistance(body, sum);
}

}  // namespace sailboat
