#include "thrust/ship.h"

#include "base/angle.h"

namespace thrust {

namespace {

using cyclone::Matrix3;
using cyclone::real_clamp;
using cyclone::RigidBody;

constexpr real INERTIA = 600;                           // kg·m², about Z
constexpr real AIR_DRAG = 15;                           // N·s/m; there is little air
constexpr real TURN_FREQUENCY = 4, TURN_DAMPING = 0.9;  // rad/s; of critical
constexpr real WINCH_SPEED = 0.5;                       // m/s
constexpr real WRECK_SPEED = 5, WRECK_SPIN = 4;         // m/s, rad/s

// The rod is a spring so stiff that swinging stretches it by a few millimetres, and so well damped that it
// does not ring.
constexpr real ROD_FREQUENCY = 20, ROD_DAMPING = 0.5;  // rad/s; of critical
constexpr real REDUCED_MASS = Ship::MASS * Ship::POD_MASS / (Ship::MASS + Ship::POD_MASS);

/// In the plane z = 0 for good.
RigidBody makePlanarBody(real mass, real inertia) {
    RigidBody body;
    body.setMass(mass);
    body.setInverseInertiaTensor(Matrix3(0, 0, 0, 0, 0, 0, 0, 0, 1 / inertia));
    body.setLockedMotion(false, false, true);
    return body;
}

void hold(RigidBody &body) {
    body.setLockedMotion(true, true, true);
    body.setRotation(0, 0, 0);
}

/// Free in the plane, and falling.
void release(RigidBody &body, const Vector3 &gravity) {
    body.setLockedMotion(false, false, true);
    body.setAcceleration(gravity);
}

Quaternion noseAt(real heading) {
    return Quaternion::fromAxisAngle(Vector3::Z, cyclone::REAL_PI / 2 - heading);
}

real headingOf(const RigidBody &body) {
    const Vector3 nose = body.getDirectionInWorldSpace(Vector3::X);
    return cyclone::real_atan2(nose.x, nose.y);
}

/// At rest, with no memory of the flight before.
void place(RigidBody &body, const Vector3 &position, const Vector3 &gravity) {
    body.setAwake(false);
    body.setAwake();
    release(body, gravity);
    body.setPosition(position);
}

}  // namespace

void AttitudeJets::updateForce(RigidBody *body, real) {
    const real error = demo::wrapAngle(heading - headingOf(*body));  // to the right; about Z that is negative
    const real torque = -TURN_FREQUENCY * TURN_FREQUENCY * INERTIA * error -
                        2 * TURN_DAMPING * TURN_FREQUENCY * INERTIA * body->getRotation().z;
    body->addTorque(Vector3(0, 0, real_clamp(torque, -MAX_TORQUE, MAX_TORQUE)));
}

Ship::Ship(cyclone::World &w, const Vector3 *windspeed)
    : world(w),
      body(makePlanarBody(MASS, INERTIA)),
      pod(makePlanarBody(POD_MASS, 0.5 * POD_MASS * POD_RADIUS * POD_RADIUS)),
      engine(Vector3::X, Vector3(-1, 0, 0), MAX_PUSH),
      air(Matrix3(-AIR_DRAG, 0, 0, 0, -AIR_DRAG, 0, 0, 0, -AIR_DRAG), Vector3(), windspeed),
      podAir(air),
      rod(&body, Vector3(), &pod, Vector3(), REDUCED_MASS * ROD_FREQUENCY * ROD_FREQUENCY, ROD_LENGTH) {
    rod.setDamping(2 * ROD_DAMPING * ROD_FREQUENCY * REDUCED_MASS);
    wreck.fill(makePlanarBody(MASS / WRECK_PARTS, INERTIA / WRECK_PARTS));
    world.addBody(&body);
    world.addBody(&pod);
    for (RigidBody &part : wreck) world.addBody(&part);
    cyclone::ForceRegistry &forces = world.getForceRegistry();
    forces.add(&body, &engine);
    forces.add(&body, &jets);
    if (windspeed == nullptr) return;
    forces.add(&body, &air);
    forces.add(&pod, &podAir);
}

Ship::~Ship() {
    for (RigidBody &part : wreck) world.removeBody(&part);
    world.removeBody(&pod);
    world.removeBody(&body);
}

void Ship::launch(const Vector3 &shipPlace, const Vector3 &podPlace, real gravity) {
    world.getForceRegistry().remove(&rod);
    hooked = broken = false;
    falling = Vector3::UP * -gravity;
    place(body, shipPlace, falling);
    body.setOrientation(noseAt(0));
    place(pod, podPlace, falling);
    hold(body);
    hold(pod);
    for (RigidBody &part : wreck) {
        place(part, shipPlace, falling);
        part.setAwake(false);
    }
    rod.setRestLength(ROD_LENGTH);
    setHeading(0);
    engine.setThrottle(0);
}

void Ship::setThrottle(real throttle) {
    if (broken) return;
    engine.setThrottle(throttle);
    if (engine.getThrottle() == 0 || !body.isMotionLocked(0)) return;
    release(body, falling);
}

void Ship::hook() {
    hooked = true;
    release(pod, falling);
    rod.setRestLength((pod.getPosition() - body.getPosition()).magnitude());
    cyclone::ForceRegistry &forces = world.getForceRegistry();
    forces.add(&body, &rod);
    forces.add(&pod, &rod);
}

void Ship::advanceWinch(real duration) {
    const real missing = ROD_LENGTH - rod.getRestLength();
    const real most = WINCH_SPEED * duration;
    rod.setRestLength(rod.getRestLength() + real_clamp(missing, -most, most));
}

void Ship::breakUp() {
    world.getForceRegistry().remove(&rod);
    hooked = false;
    broken = true;
    engine.setThrottle(0);
    const Vector3 velocity = body.getVelocity();
    for (std::size_t n = 0; n < WRECK_PARTS; ++n) {
        const real side = static_cast<real>(n) - 1;
        RigidBody &part = wreck[n];
        part.setPosition(body.getPosition());
        part.setOrientation(body.getOrientation());
        part.setVelocity(velocity * -0.2 + Vector3(side, 1, 0) * (WRECK_SPEED / 2));
        part.setRotation(0, 0, (side + 0.4) * WRECK_SPIN);
    }
    hold(body);
    hold(pod);
}

real Ship::getHeading() const { return headingOf(body); }

real Ship::getSwing() const {
    const Vector3 toPod = pod.getPosition() - body.getPosition();
    return hooked ? cyclone::real_atan2(toPod.x, -toPod.y) : 0;
}

Vector3 Ship::getRodForce() const { return hooked ? rod.getForce(body) : Vector3(); }

const std::vector<Vector3> &Ship::getSilhouette() {
    static const std::vector<Vector3> corners = {{1.4, 0, 0},   {0.2, 0.55, 0},  {-0.5, 0.6, 0},
                                                 {-1.1, 1, 0},  {-0.8, 0.35, 0}, {-0.8, -0.35, 0},
                                                 {-1.1, -1, 0}, {-0.5, -0.6, 0}, {0.2, -0.55, 0}};
    return corners;
}

std::vector<Vector3> Ship::getOutline() const {
    std::vector<Vector3> corners = getSilhouette();
    for (Vector3 &corner : corners) corner = body.getPointInWorldSpace(corner);
    return corners;
}

std::vector<Vector3> Ship::getPodOutline() const {
    std::vector<Vector3> corners;
    constexpr int COUNT = 8;
    for (int n = 0; n < COUNT; ++n) {
        const real angle = 2 * cyclone::REAL_PI * n / COUNT;
        corners.push_back(pod.getPosition() +
                          Vector3(cyclone::real_cos(angle), cyclone::real_sin(angle), 0) * POD_RADIUS);
    }
    return corners;
}

}  // namespace thrust
