#include "flightsim/glider.h"

#include "models/hull.h"

namespace flightsim {

using cyclone::Quaternion;
using cyclone::Wing;
using cyclone::WingSection;

namespace {

constexpr real DIHEDRAL = 0.05, INCIDENCE = 0.05;  // rad
constexpr real WING_X = 0.1, WING_Y = 0.3;         // m
const Vector3 TAIL(-4.2, 1.2, 0), FIN(-4.4, 0.6, 0);
const Vector3 MOMENTS_OF_INERTIA(1300, 1900, 650);  // kg·m²

Wing makePieceOfWing(real z) {
    WingSection section;
    section.zeroLiftAngle = -0.05;
    section.zeroLiftMoment = -0.07;
    section.leastDrag = Glider::SECTION_DRAG;
    Wing piece(Glider::SPAN / 4, Glider::CHORD, Vector3(WING_X, WING_Y, z), nullptr);
    piece.setAspectRatio(Glider::SPAN / Glider::CHORD);
    piece.setSection(section);
    piece.setOrientation(Quaternion::fromAxisAngle(Vector3::X, z > 0 ? -DIHEDRAL : DIHEDRAL) *
                         Quaternion::fromAxisAngle(Vector3::Z, INCIDENCE));
    return piece;
}

Wing makeAilerons(real z) {
    Wing piece = makePieceOfWing(z);
    piece.setFlap(0.22, Glider::AILERON_THROW);
    return piece;
}

Wing makeTail(real span, real chord, const Vector3 &position, real flapChord, real flapThrow) {
    WingSection section;
    section.leastDrag = Glider::SECTION_DRAG;
    Wing tail(span, chord, position, nullptr);
    tail.setSection(section);
    tail.setFlap(flapChord, flapThrow);
    return tail;
}

Wheel::Strut makeStrut(real springConstant, real rollingFriction) {
    Wheel::Strut strut;
    strut.springConstant = springConstant;
    strut.damping = 0.12 * springConstant;
    strut.rollingFriction = rollingFriction;
    return strut;
}

const std::vector<HullPoint> HULL = {{"the nose", Vector3(2.2, -0.25, 0)},
                                     {"the canopy", Vector3(1, 0.55, 0)},
                                     {"a wing", Vector3(0, 0.5, 4)},
                                     {"a wing", Vector3(0, 0.5, -4)},
                                     {"the fin", Vector3(-4.7, 1.25, 0)}};

}  // namespace

// ---- Airbrakes

AirBrakes::AirBrakes(real area, const Vector3 &point, const cyclone::WindField *a)
    : PointForce(point), dragArea(area), air(a) {}

Vector3 AirBrakes::getForce(const RigidBody &body) const {
    const Vector3 point = body.getPointInWorldSpace(getPosition());
    const Vector3 flow = body.getVelocityAtPoint(point) - air->getVelocity(point);
    return flow * (-0.5 * Glider::DENSITY * dragArea * control * flow.magnitude());
}

// ---- The glider

Glider::Glider(cyclone::World &w, const cyclone::WindField *a)
    : world(w),
      air(a),
      wing{makeAilerons(-0.375 * SPAN), makePieceOfWing(-0.125 * SPAN), makePieceOfWing(0.125 * SPAN),
           makeAilerons(0.375 * SPAN)},
      tailplane(makeTail(TAIL_SPAN, TAIL_CHORD, TAIL, 0.4, ELEVATOR_THROW)),
      fin(makeTail(FIN_SPAN, FIN_CHORD, FIN, 0.45, RUDDER_THROW)),
      fuselage(0, 0.5 * DENSITY * FUSELAGE_DRAG_AREA),
      brakes(BRAKE_DRAG_AREA, Vector3(WING_X, WING_Y, 0), a),
      wheels{Wheel(Vector3(0.12, -WHEEL_HEIGHT, 0), makeStrut(30000, 0.12)),
             Wheel(Vector3(-4.2, -0.55, 0), makeStrut(6000, 0.3)),
             Wheel(Vector3(0, 0.4, 0.47 * SPAN), makeStrut(1500, 0.2)),
             Wheel(Vector3(0, 0.4, -0.47 * SPAN), makeStrut(1500, 0.2))} {
    cyclone::Matrix3 inertia;
    inertia.setDiagonal(MOMENTS_OF_INERTIA.x, MOMENTS_OF_INERTIA.y, MOMENTS_OF_INERTIA.z);
    body.setMass(MASS);
    body.setInertiaTensor(inertia);
    body.setAcceleration(Vector3::GRAVITY);
    fin.setOrientation(Quaternion::fromAxisAngle(Vector3::X, cyclone::REAL_PI / 2));  // lifts to starboard
    fuselage.setWind(air);
    world.addBody(&body);
    addPieces(air);
    launch(Vector3(0, 300, 0));
}

Glider::~Glider() { world.removeBody(&body); }

void Glider::addPieces(const cyclone::WindField *field) {
    cyclone::ForceRegistry &registry = world.getForceRegistry();
    const auto add = [&](Wing &piece) {
        piece.setDensity(DENSITY);
        piece.setWind(field);
        registry.add(&body, &piece);
    };
    for (Wing &piece : wing) add(piece);
    add(tailplane);
    add(fin);
    registry.add(&body, &fuselage);
    registry.add(&body, &brakes);
    for (Wheel &wheel : wheels) registry.add(&body, &wheel);
}

void Glider::launch(const Vector3 &position) {
    body.setAwake(false);  // at rest, and nothing remembered of the flight before
    body.setAwake();
    body.setPosition(position);
    body.setOrientation(Quaternion());
    body.setVelocity(Vector3(BEST_GLIDE_SPEED, 0, 0) + air->getVelocity(position));
    setControls(GliderControls());
}

void Glider::setControls(const GliderControls &c) {
    controls = c;
    tailplane.setControl(-controls.pull);
    wing.front().setControl(controls.roll);
    wing.back().setControl(-controls.roll);
    fin.setControl(-controls.pedal);
    brakes.setControl(controls.brakes);
}

Vector3 Glider::getVelocityThroughAir() const {
    return body.getVelocity() - air->getVelocity(body.getPosition());
}

real Glider::getEnergyHeight() const {
    return body.getPosition().y + getVelocityThroughAir().squareMagnitude() / (2 * 9.81);
}

real Glider::getSlip() const {
    const Vector3 flow = body.getDirectionInLocalSpace(getVelocityThroughAir());
    return cyclone::real_atan2(flow.z, flow.x);
}

std::array<const Wing *, 6> Glider::getWings() const {
    return {&wing[0], &wing[1], &wing[2], &wing[3], &tailplane, &fin};
}

bool Glider::isStalled() const {
    for (const Wing &piece : wing)
        if (piece.isStalled(body)) return true;
    return false;
}

bool Glider::isOnGround() const {
    for (const Wheel &wheel : wheels)
        if (wheel.getCompression(body) > 0) return true;
    return false;
}

std::string Glider::getBrokenPart() const { return findBrokenPart(body, HULL); }

}  // namespace flightsim
