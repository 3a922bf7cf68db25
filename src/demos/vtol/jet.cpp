#include "vtol/jet.h"

#include <algorithm>

#include "models/hull.h"

namespace vtol {

using cyclone::Quaternion;
using cyclone::real_clamp;
using cyclone::Thruster;
using cyclone::Wing;

const Vector3 Jet::MOMENTS_OF_INERTIA(700, 2200, 1700);

namespace {

constexpr real TAIL_SPAN = 3, TAIL_CHORD = 0.9, FIN_SPAN = 1.6, FIN_CHORD = 1.2;  // m
constexpr real NOZZLE_SIDE = 0.6;                                                 // m
const Vector3 TAIL(-3.8, 0.5, 0), FIN(-3.8, 0.9, 0);
const Vector3 NOSE_WHEEL(2, -Jet::WHEEL_HEIGHT, 0), MAIN_WHEEL(-0.9, -Jet::WHEEL_HEIGHT, 1.2);

const std::vector<HullPoint> HULL = {
    {"the nose", Vector3(3.5, -0.3, 0)},     {"a wing tip", Vector3(-0.2, -0.1, 4)},
    {"a wing tip", Vector3(-0.2, -0.1, -4)}, {"the belly", Vector3(0, -0.65, 0)},
    {"the tail", Vector3(-4.4, -0.1, 0)},    {"the fin", Vector3(-4.5, 1.9, 0)},
    {"the canopy", Vector3(1.4, 0.8, 0)}};

Vector3 mirrored(const Vector3 &v) { return Vector3(v.x, v.y, -v.z); }

Wing makeWing(real side) {
    Wing wing(Jet::SPAN / 2, Jet::CHORD, Vector3(0, 0, side * Jet::SPAN / 4), nullptr);
    wing.setAspectRatio(Jet::ASPECT_RATIO);
    wing.setOrientation(Quaternion::fromAxisAngle(Vector3::Z, Jet::INCIDENCE));
    wing.setFlap(0.25, Jet::AILERON_THROW);
    return wing;
}

Wing makeTailplane() {
    Wing tail(TAIL_SPAN, TAIL_CHORD, TAIL, nullptr);
    tail.setFlap(1, Jet::ELEVATOR_THROW);
    return tail;
}

/// It lifts to starboard.
Wing makeFin() {
    Wing fin(FIN_SPAN, FIN_CHORD, FIN, nullptr);
    fin.setOrientation(Quaternion::fromAxisAngle(Vector3::X, cyclone::REAL_PI / 2));
    fin.setFlap(0.35, Jet::RUDDER_THROW);
    return fin;
}

Thruster makeNozzle(real side) {
    return Thruster(Vector3::Y, Vector3(0, 0, side * NOZZLE_SIDE), Jet::MAX_THRUST / Jet::NOZZLES);
}

Thruster makePuffer(const Vector3 &direction, const Vector3 &position) {
    return Thruster(direction, position, Jet::PUFF);
}

Wheel::Strut makeStrut() {
    Wheel::Strut strut;
    strut.springConstant = 30000;
    strut.damping = 3600;
    return strut;
}

}  // namespace

Jet::Jet(cyclone::World &w, const cyclone::WindField *a)
    : world(w),
      air(a),
      surfaces{makeWing(-1), makeWing(1), makeTailplane(), makeFin()},
      fuselage(0, 0.5 * DENSITY * FUSELAGE_DRAG_AREA),
      nozzles{makeNozzle(-1), makeNozzle(1)},
      puffers{makePuffer(Vector3::Y, Vector3(NOSE_ARM, 0, 0)),
              makePuffer(Vector3::Y, Vector3(-TAIL_ARM, 0, 0)),
              makePuffer(Vector3::Y, Vector3(0, 0, -TIP_ARM)),
              makePuffer(Vector3::Y, Vector3(0, 0, TIP_ARM)),
              makePuffer(-Vector3::Z, Vector3(-TAIL_ARM, 0, 0)),
              makePuffer(Vector3::Z, Vector3(-TAIL_ARM, 0, 0))},
      wheels{Wheel(NOSE_WHEEL, makeStrut()), Wheel(mirrored(MAIN_WHEEL), makeStrut()),
             Wheel(MAIN_WHEEL, makeStrut())} {
    cyclone::Matrix3 inertia;
    inertia.setDiagonal(MOMENTS_OF_INERTIA.x, MOMENTS_OF_INERTIA.y, MOMENTS_OF_INERTIA.z);
    body.setMass(MASS);
    body.setInertiaTensor(inertia);
    body.setAcceleration(Vector3::GRAVITY);
    world.addBody(&body);
    addForces();
    park(Vector3());
}

Jet::~Jet() { world.removeBody(&body); }

void Jet::addForces() {
    cyclone::ForceRegistry &registry = world.getForceRegistry();
    for (Wing &surface : surfaces) {
        surface.setDensity(DENSITY);
        surface.setWind(air);
        registry.add(&body, &surface);
    }
    fuselage.setWind(air);
    registry.add(&body, &fuselage);
    for (Thruster &nozzle : nozzles) registry.add(&body, &nozzle);
    for (Thruster &puffer : puffers) registry.add(&body, &puffer);
    for (Wheel &wheel : wheels) registry.add(&body, &wheel);
}

void Jet::park(const Vector3 &below) {
    JetControls off;
    off.nozzles = cyclone::REAL_PI / 2;
    launch(Vector3(below.x, WHEEL_HEIGHT, below.z), 0, off);
    body.setVelocity(Vector3());
}

void Jet::launch(const Vector3 &position, real speed, const JetControls &c) {
    body.setAwake(false);  // at rest, and nothing remembered of the flight before
    body.setAwake();
    body.setPosition(position);
    body.setOrientation(Quaternion());
    body.setVelocity(Vector3(speed, 0, 0) + air->getVelocity(position));
    engine = c.throttle;
    nozzleAngle = c.nozzles;
    setControls(c);
    advance(0);
}

void Jet::setControls(const JetControls &c) {
    controls = {real_clamp(c.pitch, -1, 1), real_clamp(c.roll, -1, 1), real_clamp(c.pedal, -1, 1),
                real_clamp(c.throttle, 0, 1), real_clamp(c.nozzles, 0, MOST_NOZZLES)};
    surfaces[0].setControl(controls.roll);
    surfaces[1].setControl(-controls.roll);
    surfaces[2].setControl(-controls.pitch);
    surfaces[3].setControl(-controls.pedal);
    wheels[0].setSteering(RUDDER_THROW * controls.pedal);
    steerPuffers();
}

/// Of each pair one blows, with the engine's air.
void Jet::steerPuffers() {
    const auto blow = [this](std::size_t towards, std::size_t against, real control) {
        puffers[towards].setThrottle(engine * control);
        puffers[against].setThrottle(engine * -control);
    };
    blow(0, 1, controls.pitch);
    blow(2, 3, controls.roll);
    blow(4, 5, controls.pedal);
}

void Jet::advance(real duration) {
    engine += (controls.throttle - engine) * std::min(duration / ENGINE_LAG, 1.0);
    const real most = NOZZLE_RATE * duration;
    nozzleAngle += real_clamp(controls.nozzles - nozzleAngle, -most, most);
    for (Thruster &nozzle : nozzles) {
        nozzle.setThrottle(engine);
        nozzle.setDirection(Vector3(cyclone::real_cos(nozzleAngle), cyclone::real_sin(nozzleAngle), 0));
    }
    steerPuffers();
}

Vector3 Jet::getVelocityThroughAir() const {
    return body.getVelocity() - air->getVelocity(body.getPosition());
}

real Jet::getAngleOfAttack() const {
    const Vector3 flow = body.getDirectionInLocalSpace(getVelocityThroughAir());
    return cyclone::real_atan2(-flow.y, flow.x);
}

Vector3 Jet::getAirForce() const {
    Vector3 sum = fuselage.getForce(body);
    for (const Wing &surface : surfaces) sum += surface.getForce(body);
    return sum;
}

bool Jet::isStalled() const { return surfaces[0].isStalled(body) || surfaces[1].isStalled(body); }

bool Jet::isOnGround() const {
    return std::any_of(wheels.begin(), wheels.end(),
                       [this](const Wheel &wheel) { return wheel.getCompression(body) > 0; });
}

std::string Jet::getBrokenPart() const { return findBrokenPart(body, HULL); }

}  // namespace vtol
