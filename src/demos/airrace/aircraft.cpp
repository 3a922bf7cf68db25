#include "airrace/aircraft.h"

#include "base/angle.h"

namespace airrace {

using cyclone::AngledAero;
using cyclone::Matrix3;
using cyclone::Quaternion;
using cyclone::Wing;
using cyclone::WingSection;

namespace {

constexpr real G = 9.81;
const Vector3 PROPELLER(2.2, 0, 0);

/// What must not touch the ground besides the wing tips: nose, belly, tail.
const std::array<Vector3, 3> HULL = {Vector3(2.4, -0.3, 0), Vector3(0, -0.6, 0), Vector3(-4.3, -0.2, 0)};

Quaternion turned(const Vector3 &axis, real angle) { return Quaternion::fromAxisAngle(axis, angle); }

}  // namespace

// ---- What all have

const std::vector<std::string> Aircraft::NAMES = {"bullet", "gnat", "swallow"};
const Vector3 Aircraft::TAIL(-4, 0, 0), Aircraft::FIN(-4, 0.5, 0);

Aircraft::Aircraft(cyclone::World &world, const Model &m, const cyclone::WindField *a)
    : model(m),
      air(a),
      body(world.createBody()),
      propeller(world.createForce<cyclone::Propeller>(body, Vector3::X, PROPELLER, m.maxThrust, m.pitchSpeed,
                                                      nullptr)) {
    propeller.setWind(air);
    forces[4] = &propeller;
    Matrix3 inertia;
    inertia.setDiagonal(m.momentsOfInertia.x, m.momentsOfInertia.y, m.momentsOfInertia.z);
    body->setMass(model.mass);
    body->setInertiaTensor(inertia);
    body->setAcceleration(Vector3::GRAVITY);
}

void Aircraft::launch(const Vector3 &position) {
    body->setAwake(false);  // at rest, and nothing remembered of the flight before
    body->setAwake();
    body->setPosition(position);
    body->setOrientation(Quaternion());
    body->setVelocity(Vector3(model.cruise, 0, 0) + air->getVelocity(position));
    setSticks(Sticks());
}

void Aircraft::setSticks(const Sticks &s) {
    using cyclone::real_clamp;
    sticks = {real_clamp(s.elevator, -1, 1), real_clamp(s.aileron, -1, 1), real_clamp(s.throttle, 0, 1)};
    propeller.setThrottle(sticks.throttle);
    turnSurfaces(model.elevator * sticks.elevator, model.aileron * sticks.aileron);
}

Vector3 Aircraft::getVelocityThroughAir() const {
    return body->getVelocity() - air->getVelocity(body->getPosition());
}

real Aircraft::getClimbAngle() const {
    const Vector3 v = body->getVelocity();
    return cyclone::real_atan2(v.y, demo::horizontalLength(v));
}

bool Aircraft::touchesGround() const {
    const auto isBelow = [this](const Vector3 &point) { return body->getPointInWorldSpace(point).y < 0; };
    for (const Vector3 &point : HULL)
        if (isBelow(point)) return true;
    return isBelow(Vector3(0, 0, model.span / 2)) || isBelow(Vector3(0, 0, -model.span / 2));
}

// ---- Flat plates

namespace {

/// A plate resists with A = −diag(drag, lift, 0) in its own axes, N·s/m: across itself far more than along.
/// At an angle of attack α that is a lift of lift·u·α. It never drives its point through still air.
struct Plates {
    real lift, drag;  ///< of both wings together; the drag counts for the whole aircraft
    real tailLift, finLift;
};

class PlateAircraft : public Aircraft {
public:
    PlateAircraft(cyclone::World &world, const Model &m, const Plates &plates, const cyclone::WindField *a)
        : Aircraft(world, m, a),
          incidence(m.mass * G / (plates.lift * m.cruise)),
          portWing(addPlate(world, plates.lift / 2, plates.drag / 2, Vector3(0, 0, -m.span / 4))),
          starboardWing(addPlate(world, plates.lift / 2, plates.drag / 2, Vector3(0, 0, m.span / 4))),
          tailplane(addPlate(world, plates.tailLift, 0, TAIL)),
          fin(addPlate(world, plates.finLift, 0, FIN)) {
        fin.setOrientation(turned(Vector3::X, cyclone::REAL_PI / 2));
        forces = {&portWing, &starboardWing, &tailplane, &fin, forces[4]};
        launch(Vector3());
    }

private:
    AngledAero &addPlate(cyclone::World &world, real lift, real drag, const Vector3 &position) {
        Matrix3 tensor;
        tensor.setDiagonal(-drag, -lift, 0);
        AngledAero &plate = world.createForce<AngledAero>(body, tensor, position, nullptr);
        plate.setRotationalFlow(true);
        plate.setWind(air);
        return plate;
    }

    void turnSurfaces(real elevator, real aileron) override {
        portWing.setOrientation(turned(Vector3::Z, incidence + aileron));
        starboardWing.setOrientation(turned(Vector3::Z, incidence - aileron));
        tailplane.setOrientation(turned(Vector3::Z, -elevator));
    }

    real incidence;  ///< rad, of the wings: with it, level flight at cruise has the body along the path
    AngledAero &portWing, &starboardWing, &tailplane, &fin;
};

// ---- Wings that stall

class WingedAircraft : public Aircraft {
public:
    static constexpr real CHORD = 1.25, TAIL_SPAN = 2.8, TAIL_CHORD = 0.75, FIN_SPAN = 1.4, FIN_CHORD = 1.0;
    static constexpr real FUSELAGE_DRAG_AREA = 0.3;  // m²

    WingedAircraft(cyclone::World &world, const Model &m, const cyclone::WindField *a)
        : Aircraft(world, m, a),
          portWing(addWing(world, m.span / 2, CHORD, Vector3(0, 0, -m.span / 4))),
          starboardWing(addWing(world, m.span / 2, CHORD, Vector3(0, 0, m.span / 4))),
          tailplane(addWing(world, TAIL_SPAN, TAIL_CHORD, TAIL)),
          fin(addWing(world, FIN_SPAN, FIN_CHORD, FIN)) {
        const real ratio = m.span / CHORD, slope = 2 * cyclone::REAL_PI * ratio / (ratio + 2);
        const real pressure = 0.5 * DENSITY * m.cruise * m.cruise;
        for (Wing *wing : {&portWing, &starboardWing}) {
            wing->setAspectRatio(ratio);
            wing->setFlap(0.25, m.aileron);
            wing->setOrientation(turned(Vector3::Z, m.mass * G / (pressure * m.span * CHORD * slope)));
        }
        tailplane.setFlap(1, m.elevator);
        fin.setOrientation(turned(Vector3::X, cyclone::REAL_PI / 2));
        world.createForce<cyclone::Drag>(body, 0, 0.5 * DENSITY * FUSELAGE_DRAG_AREA).setWind(a);
        forces = {&portWing, &starboardWing, &tailplane, &fin, forces[4]};
        launch(Vector3());
    }

    bool isStalled() const override { return portWing.isStalled(*body) || starboardWing.isStalled(*body); }

private:
    Wing &addWing(cyclone::World &world, real span, real chord, const Vector3 &position) {
        Wing &wing = world.createForce<Wing>(body, span, chord, position, nullptr);
        wing.setDensity(DENSITY);
        wing.setWind(air);
        return wing;
    }

    void turnSurfaces(real elevator, real aileron) override {
        portWing.setControl(aileron / model.aileron);
        starboardWing.setControl(-aileron / model.aileron);
        tailplane.setControl(-elevator / model.elevator);
    }

    Wing &portWing, &starboardWing, &tailplane, &fin;
};

}  // namespace

std::unique_ptr<Aircraft> Aircraft::make(const std::string &name, cyclone::World &world,
                                         const cyclone::WindField *air) {
    if (name == "bullet")
        return std::make_unique<PlateAircraft>(
            world, Model{name, 700, Vector3(2500, 4200, 2200), 6, 4200, 170, 80, 1.9, 0.8, 0, 0.0355, 0.12},
            Plates{4000, 20, 500, 300}, air);
    if (name == "gnat")
        return std::make_unique<PlateAircraft>(
            world, Model{name, 450, Vector3(400, 1200, 900), 5, 4300, 140, 60, 4, 1.0, 0, 0.083, 0.15},
            Plates{3000, 28, 350, 250}, air);
    cyclone::detail::require(name == "swallow", "Aircraft::make", "the name must be one of NAMES", {});
    return std::make_unique<WingedAircraft>(
        world, Model{name, 600, Vector3(900, 1900, 1300), 7.5, 3600, 140, 60, 2.2, 1, 28, 0.14, 0.3}, air);
}

}  // namespace airrace
