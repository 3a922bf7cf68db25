#include "scene.h"

// Never two random numbers in one call: C++ does not say which argument is evaluated first.

namespace golden {

using namespace cyclone;

namespace {

const Matrix3 TAILPLANE(-0.1, 0, 0, 1, -0.5, 0, 0, 0, -0.1);
const Matrix3 WING_UP(-0.2, 0, 0, -0.2, -0.5, 0, 0, 0, -0.1);
const Matrix3 WING_DOWN(-0.2, 0, 0, 1.4, -0.5, 0, 0, 0, -0.1);
const Matrix3 RUDDER(-0.1, 0, 0, 0, -0.1, 0, 0, 0, -0.5);
const Matrix3 RUDDER_PORT(-0.1, 0, 0, 0, -0.1, 0, -0.4, 0, -0.5);
const Matrix3 RUDDER_STARBOARD(-0.1, 0, 0, 0, -0.1, 0, 0.4, 0, -0.5);
const Matrix3 SAIL(-2, 0, 0, 0, -1, 0, 0, 0, -40);
const Matrix3 KEEL(-20, 0, 0, 0, -5, 0, 0, 0, -300);

/// It falls 1 m in 100 m and flows fastest in the middle.
class River : public Water {
public:
    real getHeight(const Vector3 &worldPoint) const override { return -0.01 * worldPoint.x; }
    Vector3 getVelocity(const Vector3 &worldPoint) const override {
        const real across = 0.1 * (worldPoint.z - 80);
        return Vector3(2 / (1 + across * across), -0.02, 0);
    }
};

const River RIVER;

}  // namespace

RigidBody *Scene::addVehicle(const MassProperties &parts, const Vector3 &position, const Vector3 &velocity) {
    RigidBody *const body = addBody(1, diagonal(1, 1, 1), position);
    parts.applyTo(*body);
    body->setAcceleration(Vector3::GRAVITY);
    body->setVelocity(velocity);
    travellers.push_back({body, position, velocity});
    return body;
}

void Scene::addAircraft(const Vector3 &position) {
    const Matrix3 inertia(0.12, 0.01, 0.004, 0.01, 0.25, -0.006, 0.004, -0.006, 0.16);
    RigidBody *const body = addBody(2.5, inertia, position);
    body->setAcceleration(Vector3::GRAVITY);
    body->setVelocity(8.2, 0, random.between(-1, 1));
    body->setDamping(0.95, 0.8);
    travellers.push_back({body, position, body->getVelocity()});

    const auto addWing = [&](const Matrix3 &base, const Matrix3 &min, const Matrix3 &max, const Vector3 &at) {
        wings.push_back(act<AeroControl>(body, base, min, max, at, &wind));
        wings.back()->setRotationalFlow(true);
        wings.back()->setWind(&air);
    };
    addWing(TAILPLANE, WING_UP, WING_DOWN, Vector3(0.05, 0.1, -0.8));
    addWing(TAILPLANE, WING_UP, WING_DOWN, Vector3(0.05, 0.1, 0.8));
    addWing(RUDDER, RUDDER_PORT, RUDDER_STARBOARD, Vector3(-1.4, 0.1, 0));
    act<Aero>(body, TAILPLANE, Vector3(-1.2, 0.1, 0), &wind)->setRotationalFlow(true);
    act<Drag>(body, 0.01, 0.02)->setWind(&air);
    Propeller *const propeller =
        act<Propeller>(body, Vector3(1, 0, 0.01), Vector3(0.6, -0.02, 0), 20.0, 14.0, &wind);
    propeller->setWind(&air);
    thrusters.push_back(propeller);
}

void Scene::addBoat(const Vector3 &position, bool onWaves) {
    Matrix3 inertia;
    inertia.setBlockInertiaTensor(Vector3(2, 0.4, 1), 200);
    RigidBody *const body = addBody(200, inertia, position);
    body->setDamping(0.8, 0.4);
    travellers.push_back({body, position, Vector3()});
    registerAction(body, &gravity);
    for (real along : {-1.5, 1.5})
        for (real across : {-0.8, 0.8}) {
            Buoyancy *const hull = act<Buoyancy>(body, Vector3(along, -0.2, across), 0.3, 0.1, 0.05);
            if (onWaves) hull->setWater(&sea);
        }
    sails.push_back(act<AngledAero>(body, SAIL, Vector3(0.1, 1.5, 0), &wind));
    sails.push_back(act<AngledAero>(body, KEEL, Vector3(-0.3, -0.5, 0), &current));
    sails.back()->setRotationalFlow(true);
    thrusters.push_back(act<Thruster>(body, Vector3(1, 0.1, 0), Vector3(-2, -0.3, 0), 100.0));
}

/// Two halves that stall one after the other, a tailplane that turns as a whole, and a fin.
void Scene::addGlider(const Vector3 &position) {
    MassProperties parts = MassProperties::capsule(0.08, 1.2, Mass(1.5))
                               .placedAt(Vector3(-0.3, 0, 0), Quaternion::fromAxisAngle(Vector3::Z, 1.5));
    parts += MassProperties::box(Vector3(0.12, 0.01, 1.5), Mass(1.2)).placedAt(Vector3(0, 0.1, 0));
    parts += MassProperties::sphere(0.03, Density(11340)).placedAt(Vector3(0.56, 0, 0));
    RigidBody *const body = addVehicle(parts, position, Vector3(13, -0.5, 0));
    act<Drag>(body, 0.0, 0.01)->setWind(&air);

    const auto addWing = [&](real span, real chord, const Vector3 &at, real camber, const Quaternion &turn) {
        Wing *const wing = act<Wing>(body, span, chord, at - parts.getCentre(), &wind);
        WingSection section;
        section.liftSlope = 6;
        section.zeroLiftAngle = section.zeroLiftMoment = -camber;
        section.leastDrag = 0.012;
        section.stallAngle = 0.24;
        section.plateDrag = 1.9;
        wing->setSection(section);
        wing->setDensity(1.1);
        wing->setOrientation(turn);
        wing->setWind(&air);
        flaps.push_back(wing);
        return wing;
    };
    const Quaternion incidence = Quaternion::fromAxisAngle(Vector3::Z, 0.05);
    for (real side : {-1.0, 1.0}) {
        const Quaternion dihedral = Quaternion::fromAxisAngle(Vector3::X, -0.08 * side);
        Wing *const half = addWing(1.5, 0.24, Vector3(0.06, 0.1, 0.75 * side), 0.05, dihedral * incidence);
        half->setAspectRatio(12.5);
        half->setFlap(0.25, 0.3);
    }
    const Quaternion upright = Quaternion::fromAxisAngle(Vector3::X, REAL_PI / 2);
    addWing(0.6, 0.15, Vector3(-0.9, 0.1, 0), 0, Quaternion())->setFlap(1, 0.1);
    addWing(0.3, 0.2, Vector3(-0.9, 0.25, 0), 0, upright)->setFlap(0.4, 0.4);
}

/// Four parts, 1 m ahead and behind, port and starboard, that float and resist.
void Scene::addFloats(RigidBody *body, const Water *water, real y, real z, real volume) {
    for (real x : {-1.0, 1.0})
        for (real side : {-z, z}) {
            Buoyancy *const part = act<Buoyancy>(body, Vector3(x, y, side), 0.3, volume, 0.0, 1025.0, 9.8);
            part->setWater(water);
            act<HullDrag>(body, part, Vector3(x, y - 0.1, side), Vector3(5, 300, 200), Vector3(4, 80, 90));
        }
}

/// It planes, or rises on its foils.
void Scene::addMotorboat(const Vector3 &position, bool onFoils) {
    MassProperties parts = MassProperties::ellipsoid(Vector3(2, 0.3, 0.7), Mass(170));
    parts += MassProperties::cylinder(0.1, 0.7, Mass(30)).placedAt(Vector3(-1.8, 0, 0));
    RigidBody *const body = addVehicle(parts, position, Vector3(6, 0, 0));
    addFloats(body, &sea, -0.2, 0.5, 0.12);
    act<Drag>(body, 0.0, 0.5)->setWind(&air);
    sails.push_back(act<AngledAero>(body, diagonal(-5, -5, -200), Vector3(-1.8, -0.6, 0), nullptr));
    sails.back()->setWater(&sea, 0.3);
    sails.back()->setRotationalFlow(true);
    if (onFoils) {
        for (real x : {-1.2, 1.0}) {
            Wing *const foil = act<Wing>(body, 0.8, 0.12, Vector3(x, -0.8, 0), &current);
            foil->setWater(&sea, 0.2, 1025);
            foil->setOrientation(Quaternion::fromAxisAngle(Vector3::Z, x > 0 ? 0.06 : 0.03));
        }
        thrusters.push_back(act<Propeller>(body, Vector3::X, Vector3(-1.8, -0.9, 0), 900.0, 14.0, nullptr));
    } else {
        const Matrix3 bottom(-15, 0, 0, 60, -600, 0, 0, 0, -100);
        act<Aero>(body, bottom, Vector3(-0.4, -0.3, 0), nullptr)->setWater(&sea, 0.15);
        thrusters.push_back(act<Thruster>(body, Vector3::X, Vector3(-1.8, -0.5, 0), 700.0));
    }
    thrusters.back()->setWater(&sea, 0.15);
}

/// A catamaran on a winch, in a river or a lake, with an oar astern.
void Scene::addRaft(const Vector3 &position, bool inRiver) {
    const Quaternion lying = Quaternion::fromAxisAngle(Vector3::Z, REAL_PI / 2);
    MassProperties parts = MassProperties::box(Vector3(1.2, 0.05, 1), Mass(60)).placedAt(Vector3(0, 0.3, 0));
    for (real z : {-0.8, 0.8})
        parts += MassProperties::cylinder(0.25, 2.6, Mass(40), 0.24).placedAt(Vector3(0, 0, z), lying);
    parts += MassProperties::cone(0.3, 0.8, Mass(15)).placedAt(Vector3(0.5, 0.35, 0));
    RigidBody *const body = addVehicle(parts, position, Vector3());
    addFloats(body, inRiver ? &RIVER : nullptr, -0.1, 0.8, 0.1);
    wings.push_back(act<AeroControl>(body, KEEL, KEEL * 0.2, KEEL * 1.8, Vector3(-1.4, -0.2, 0), &current));
    wings.back()->setWater(inRiver ? &RIVER : nullptr, 0.4);
    addWinch(body, Vector3(1.2, 0, 0), position + Vector3(-2, 1, 0));
}

}  // namespace golden
