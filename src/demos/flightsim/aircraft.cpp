#include "flightsim/aircraft.h"

#include "models/hull.h"

namespace flightsim {

using cyclone::Matrix3;

const Vector3 Aircraft::WING_POSITION(0.25, 0.35, 0.2);
const Vector3 Aircraft::TAIL_POSITION(-0.6, 0.4, 0);
const Vector3 Aircraft::RUDDER_POSITION(-0.85, 0.3, 0);
const Vector3 Aircraft::PROPELLER_POSITION(0.45, 0.1, 0);
const Vector3 Aircraft::MOMENTS_OF_INERTIA(0.05, 0.14, 0.1);

namespace {

// Velocity through the air to force, N·s/m, body axes.
constexpr Matrix3 WING_LESS(-0.2, 0, 0, -0.2, -0.5, 0, 0, 0, -0.1);
constexpr Matrix3 WING(-0.1, 0, 0, 1, -0.5, 0, 0, 0, -0.1);
constexpr Matrix3 WING_MORE(-0.2, 0, 0, 1.4, -0.5, 0, 0, 0, -0.1);
constexpr Matrix3 TAILPLANE(-0.1, 0, 0, 1, -0.5, 0, 0, 0, -0.1);

/// side: the force to starboard per m/s forward. Aft of the centre of mass it turns the nose to port.
constexpr Matrix3 rudderTensor(real side) { return Matrix3(-0.1, 0, 0, 0, -0.1, 0, side, 0, -0.5); }

Vector3 mirrored(const Vector3 &v) { return Vector3(v.x, v.y, -v.z); }

const Vector3 NOSE_WHEEL(0.35, -Aircraft::WHEEL_HEIGHT, 0), MAIN_WHEEL(-0.12, -Aircraft::WHEEL_HEIGHT, 0.3);

const std::vector<HullPoint> HULL = {{"the propeller", Vector3(0.47, -0.09, 0)},
                                     {"a wing tip", Vector3(0.2, 0.35, 0.75)},
                                     {"a wing tip", Vector3(0.2, 0.35, -0.75)},
                                     {"the tail", Vector3(-0.9, 0.05, 0)},
                                     {"the fin", Vector3(-0.85, 0.45, 0)},
                                     {"the nose", Vector3(0.3, -0.12, 0)},
                                     {"the back", Vector3(0, 0.4, 0)}};

}  // namespace

Aircraft::Aircraft(cyclone::World &w, const Vector3 *wind)
    : world(w),
      portWing(WING, WING_LESS, WING_MORE, mirrored(WING_POSITION), wind),
      starboardWing(WING, WING_LESS, WING_MORE, WING_POSITION, wind),
      tailplane(TAILPLANE, TAIL_POSITION, wind),
      rudder(rudderTensor(0), rudderTensor(-0.4), rudderTensor(0.4), RUDDER_POSITION, wind),
      propeller(Vector3::X, PROPELLER_POSITION, MAX_THRUST, PITCH_SPEED, wind),
      wheels{Wheel(NOSE_WHEEL, Wheel::Strut()), Wheel(mirrored(MAIN_WHEEL), Wheel::Strut()),
             Wheel(MAIN_WHEEL, Wheel::Strut())},
      surfaces{&portWing, &starboardWing, &tailplane, &rudder},
      windspeed(wind) {
    Matrix3 inertia;
    inertia.setDiagonal(MOMENTS_OF_INERTIA.x, MOMENTS_OF_INERTIA.y, MOMENTS_OF_INERTIA.z);
    body.setMass(MASS);
    body.setInertiaTensor(inertia);
    body.setAcceleration(Vector3::GRAVITY);

    world.addBody(&body);
    cyclone::ForceRegistry &registry = world.getForceRegistry();
    for (cyclone::Aero *surface :
         {static_cast<cyclone::Aero *>(&portWing), static_cast<cyclone::Aero *>(&starboardWing), &tailplane,
          static_cast<cyclone::Aero *>(&rudder)}) {
        surface->setRotationalFlow(true);
        registry.add(&body, surface);
    }
    registry.add(&body, &propeller);
    for (Wheel &wheel : wheels) registry.add(&body, &wheel);
    launch(Vector3(0, 20, 0));
}

Aircraft::~Aircraft() { world.removeBody(&body); }

void Aircraft::park(const Vector3 &below) {
    launch(Vector3(below.x, WHEEL_HEIGHT, below.z));
    body.setVelocity(Vector3());
}

void Aircraft::launch(const Vector3 &position) {
    body.setAwake(false);  // at rest, and nothing remembered of the flight before
    body.setAwake();
    body.setPosition(position);
    body.setOrientation(cyclone::Quaternion());
    const Vector3 throughAir(LEVEL_SPEED, 0, 0);
    body.setVelocity(windspeed ? throughAir - *windspeed : throughAir);
    setControls(FlightControls());
}

void Aircraft::setControls(const FlightControls &sticks) {
    controls = sticks;
    const real both = PITCH_THROW * sticks.pitch, opposite = ROLL_THROW * sticks.roll;
    portWing.setControl(both + opposite);
    starboardWing.setControl(both - opposite);
    rudder.setControl(-RUDDER_THROW * sticks.rudder);
    propeller.setThrottle(sticks.throttle);
    wheels[0].setSteering(STEERING_THROW * sticks.rudder);
}

Vector3 Aircraft::getVelocityThroughAir() const {
    return windspeed ? body.getVelocity() + *windspeed : body.getVelocity();
}

bool Aircraft::isOnGround() const {
    for (const Wheel &wheel : wheels)
        if (wheel.getCompression(body) > 0) return true;
    return false;
}

std::string Aircraft::getBrokenPart() const { return findBrokenPart(body, HULL); }

}  // namespace flightsim
