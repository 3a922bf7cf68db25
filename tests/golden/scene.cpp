#include "scene.h"

// Never two random numbers in one call: C++ does not say which argument is evaluated first.

namespace golden {

using namespace cyclone;

namespace {

/// A damped spring that acts on both of its ends.
class Tether : public ForceGenerator {
public:
    Tether(RigidBody *otherEnd, real springConstant) : other(otherEnd), constant(springConstant) {}
    void updateForce(RigidBody *body, real) override {
        const Vector3 apart = body->getPosition() - other->getPosition();
        const Vector3 speed = body->getVelocity() - other->getVelocity();
        const Vector3 force = apart * -constant - speed * 0.1;
        body->addForceAtBodyPoint(force, Vector3(0.1, 0, 0.05));
        other->addForceAtBodyPoint(-force, Vector3(0, -0.1, 0));
    }

private:
    RigidBody *other;
    real constant;
};

const Matrix3 TAILPLANE(-0.1, 0, 0, 1, -0.5, 0, 0, 0, -0.1);
const Matrix3 WING_UP(-0.2, 0, 0, -0.2, -0.5, 0, 0, 0, -0.1);
const Matrix3 WING_DOWN(-0.2, 0, 0, 1.4, -0.5, 0, 0, 0, -0.1);
const Matrix3 RUDDER(-0.1, 0, 0, 0, -0.1, 0, 0, 0, -0.5);
const Matrix3 RUDDER_PORT(-0.1, 0, 0, 0, -0.1, 0, -0.4, 0, -0.5);
const Matrix3 RUDDER_STARBOARD(-0.1, 0, 0, 0, -0.1, 0, 0.4, 0, -0.5);
const Matrix3 SAIL(-2, 0, 0, 0, -1, 0, 0, 0, -40);
const Matrix3 KEEL(-20, 0, 0, 0, -5, 0, 0, 0, -300);

Matrix3 diagonal(real a, real b, real c) {
    Matrix3 result;
    result.setDiagonal(a, b, c);
    return result;
}

}  // namespace

Scene::Scene(std::size_t threads, int swarmSize) {
    air.add(&shear);
    air.add(&thermal);
    air.add(&gusts);
    sea.addTrain({0.25, 9, 0.3, 0});
    sea.addTrain({0.1, 4, 1.2, 0.7});
    for (int n = 0; n < 4; ++n) addAircraft(Vector3(40.0 * n, 100, 0));
    for (int n = 0; n < 4; ++n) addBoat(Vector3(12.0 * n, 0, 50), n % 2 == 1);
    for (int n = 0; n < 3; ++n) addTetheredPair(Vector3(5.0 * n, 20, -30));
    addChain(Vector3(0, 30, -60));
    addPlatform(Vector3(0, 10, -90));
    for (int n = 0; n < 4; ++n) addDoor(Vector3(3.0 * n, 0, -100), n % 2 == 1);
    addTop(Vector3(0, 0, 120), Vector3(200, 30, -100));
    addTop(Vector3(2, 0, 120), Vector3(-3, 90, 0.01));
    addTop(Vector3(4, 0, 120), Vector3(6000, 1, 20));  // more than 64 rad a step
    addTop(Vector3(6, 0, 120), Vector3(5, 12, -8));
    for (int n = 0; n < 6; ++n) addSleeper(Vector3(2.0 * n, 0, 140));
    addSwarm(swarmSize);
    visitor.setPosition(0, 0, 160);
    visitor.setRotation(1, 2, 3);
    world.setWorkers(threads);
}

RigidBody *Scene::addBody(real mass, const Matrix3 &inertia, const Vector3 &position) {
    storage.emplace_back();
    RigidBody *const body = &storage.back();
    body->setMass(mass);
    body->setInertiaTensor(inertia);
    body->setPosition(position);
    world.addBody(body);
    return body;
}

void Scene::registerAction(RigidBody *body, ForceGenerator *generator) {
    world.getForceRegistry().add(body, generator);
    if (generator->actsOnItsBodyOnly()) actions.push_back({body, generator});
}

void Scene::addAircraft(const Vector3 &position) {
    const Matrix3 inertia(0.12, 0.01, 0.004, 0.01, 0.25, -0.006, 0.004, -0.006, 0.16);
    RigidBody *const body = addBody(2.5, inertia, position);
    body->setAcceleration(Vector3::GRAVITY);
    body->setVelocity(8.2, 0, random.between(-1, 1));
    body->setDamping(0.95, 0.8);

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

void Scene::addChain(const Vector3 &position) {
    const Vector3 left(-0.2, 0, 0), right(0.2, 0, 0);
    for (int n = 0; n < 12; ++n) {
        RigidBody *const link =
            addBody(1 + 0.1 * n, diagonal(0.05, 0.06, 0.08), position + Vector3(1.2 * n, 0, 0));
        link->setDamping(0.8, 0.7);
        registerAction(link, &gravity);
        if (n == 0) {
            act<AnchoredSpring>(link, left, position - Vector3(1, 0, 0), 400.0, 0.5);
        } else {
            act<Spring>(link, left, static_cast<const RigidBody *>(links.back()), right, 200.0, 0.8);
            act<Spring>(links.back(), right, static_cast<const RigidBody *>(link), left, 200.0, 0.8);
        }
        links.push_back(link);
    }
    act<AnchoredSpring>(links.back(), right, position + Vector3(14, 0, 0), 400.0, 0.5);
}

void Scene::addTetheredPair(const Vector3 &position) {
    RigidBody *const a = addBody(2, diagonal(0.3, 0.5, 0.4), position);
    RigidBody *const b =
        addBody(3, Matrix3(0.6, 0.1, 0, 0.1, 0.5, 0, 0, 0, 0.4), position + Vector3(1, 0, 2));
    b->setVelocity(random.vector(3));
    act<Tether>(a, b, 12.0);
    act<Drag>(b, 0.05, 0.01);
}

void Scene::addPlatform(const Vector3 &position) {
    platform = addBody(1, diagonal(1, 1, 1), position);
    platform->setInverseMass(0);
    platform->setRotation(0, 0.7, 0);
    for (real side : {-3.0, 3.0}) {
        RigidBody *const jumper =
            addBody(70, diagonal(10, 2, 10), position + Vector3(side, side < 0 ? -6.0 : -3.0, 0));
        jumper->setDamping(0.99, 0.6);
        jumper->setAcceleration(Vector3::GRAVITY);
        act<Bungee>(jumper, Vector3(0, -0.8, 0), static_cast<const RigidBody *>(platform),
                    Vector3(side, 0, 0), 300.0, 3.0);
    }
}

void Scene::addDoor(const Vector3 &position, bool oblique) {
    RigidBody *const door = addBody(20, diagonal(1, 1, 1), position);
    Matrix3 axes;
    axes.setOrientation(Quaternion::fromAxisAngle(Vector3(1, 2, -1), oblique ? 0.8 : 0));
    door->setInverseInertiaTensor(axes * diagonal(0, 0.5, oblique ? 0.2 : 0) * axes.transpose());
    door->setRotation(axes * Vector3(0, 0.5, 0));
    door->setAngularDamping(0.7);
    act<Aero>(door, diagonal(-1, -1, -4), Vector3(0.5, 0, 0), &wind)->setRotationalFlow(true);
    act<AnchoredSpring>(door, Vector3(), position, 800.0, 0.0);
    doors.push_back(door);
}

void Scene::addTop(const Vector3 &position, const Vector3 &rotation) {
    RigidBody *const top = addBody(0.1, diagonal(1e-4, 3e-4, 2e-4), position);
    top->setRotation(rotation);
    top->setAngularDamping(0.995);
}

void Scene::addSleeper(const Vector3 &position) {
    RigidBody *const sleeper = addBody(1, diagonal(0.1, 0.1, 0.2), position);
    sleeper->setDamping(0.2, 0.3);
    sleeper->setCanSleep(true);
    sleeper->setVelocity(random.vector(2));
    sleeper->setRotation(random.vector(2));
    sleepers.push_back(sleeper);
}

void Scene::addSwarm(int count) {
    for (int n = 0; n < count; ++n) {
        RigidBody *const body = world.createBody();
        setUpSwarmBody(body);
        swarm.push_back(body);
        registerAction(body, &gravity);
        const real k1 = random.between(0.1, 0.4), k2 = random.between(0.05, 0.1);
        Drag *const drag = act<Drag>(body, k1, k2);
        Aero *const wing = act<Aero>(body, diagonal(-0.2, -0.3, -0.1), random.vector(0.3), &wind);
        wing->setRotationalFlow(n % 3 == 0);
        swarmForces.push_back({&gravity, drag, wing});
        if (n % 2 == 0) {
            const Vector3 anchor = body->getPosition() + random.vector(3);
            act<AnchoredSpring>(body, random.vector(0.3), anchor, 15.0, 1.0);
        }
    }
}

/// Every elementary function of the library has a part in where the swarm begins.
void Scene::setUpSwarmBody(RigidBody *body) {
    const real a = random.between(-1, 1), b = random.between(0.1, 9), c = random.between(-1e3, 1e3);
    body->setMass(real_exp(a));
    const Matrix3 inertia(0.3 + 0.1 * b, 0.03 * a, 0.02, 0.03 * a, 0.5, -0.04, 0.02, -0.04, 0.4);
    body->setInertiaTensor(a < 0 ? inertia : diagonal(0.3, 0.4 + 0.1 * a, 0.5));
    body->setPosition(10 * real_log(b), real_pow(b, a), 20 * real_atan2(a, b));
    body->setOrientation(real_cos(c), real_sin(c), real_asin(a), real_acos(a));
    body->setVelocity(random.vector(5));
    body->setRotation(random.vector(4));
    const real linear = random.between(0.7, 1), angular = random.between(0.5, 1);
    body->setDamping(linear, angular);
}

// ---- A frame

real Scene::getDuration() const {
    static constexpr real DURATIONS[] = {1.0 / 60, 1.0 / 60, 1.0 / 50, 0.0125, 1.0 / 120, 1.0 / 30};
    return DURATIONS[frame / 37 % 6];
}

bool Scene::changesStructure() const {
    return frame >= FIRST_CHANGE_OF_STRUCTURE && (frame % 45 == 0 || frame % 211 == 0 || frame % 400 == 0);
}

void Scene::steer() {
    world.startFrame();
    random = Random(static_cast<std::uint64_t>(frame) + 1000);
    time = frame * (1.0 / 60);
    moveControls();
    useSetters();
    if (changesStructure()) {
        if (frame % 45 == 0) changeRegistrations();
        if (frame % 211 == 0 || frame % 400 == 0) changeBodies();
    }
    addForces();
}

void Scene::step() {
    world.runPhysics(getDuration());
    ++frame;
}

void Scene::moveControls() {
    wind = Vector3(-4 + real_sin(0.7 * time), 0.3 * real_sin(1.9 * time), 2 * real_cos(0.3 * time));
    current = Vector3(0.2, 0, 0.3 * real_sin(0.1 * time));
    thermal.setFoot(Vector3(60 + 2 * time, -20, 0));
    makeGust();
    sea.setTime(time);
    for (std::size_t n = 0; n < wings.size(); ++n)
        wings[n]->setControl(1.1 * real_sin(0.9 * time + static_cast<real>(n)));
    for (std::size_t n = 0; n < sails.size(); ++n)
        sails[n]->setOrientation(
            Quaternion::fromAxisAngle(Vector3::UP, 0.6 * real_sin(0.5 * time + static_cast<real>(n))));
    for (std::size_t n = 0; n < thrusters.size(); ++n) {
        thrusters[n]->setThrottle(0.5 + 0.6 * real_sin(0.4 * time + static_cast<real>(n)));
        thrusters[n]->setDirection(Vector3(1, 0.05 * real_sin(time), 0.1 * real_cos(time)));
    }
}

/// Other gusts every few frames, so that those of a frame follow from its number alone.
void Scene::makeGust() {
    gusts = Turbulence(8, static_cast<std::uint64_t>(frame / 16));
    for (int n = 0; n <= frame % 16; ++n) gusts.advance(Vector3(14, 0, 3 * real_sin(time)), 100, 1.0 / 60);
}

void Scene::addForces() {
    for (std::size_t n = 0; n < doors.size(); ++n)
        doors[n]->addTorque(random.vector(2) + Vector3(0, real_sin(2 * time), 0));
    RigidBody *const pushed = swarm[static_cast<std::size_t>(frame) % swarm.size()];
    pushed->addForceAtPoint(random.vector(30), pushed->getPointInWorldSpace(Vector3(0.1, 0.2, 0)));
    links[static_cast<std::size_t>(frame) % links.size()]->addForceAtBodyPoint(random.vector(5),
                                                                               Vector3(0, 0.2, 0));
    if (frame % 350 == 349)
        for (RigidBody *sleeper : sleepers) sleeper->addForce(random.vector(60));
}

void Scene::useSetters() {
    if (frame % 200 == 100) platform->setVelocity(0, random.between(-0.5, 0.5), 0);
    if (frame % 29 != 28) return;
    const real linear = random.between(0.6, 1), angular = random.between(0.6, 1);
    RigidBody *const changed = swarm[static_cast<std::size_t>(frame / 29) % swarm.size()];
    switch (frame / 29 % 5) {
        case 0:
            return changed->setMass(random.between(0.5, 3));
        case 1:
            return changed->setInertiaTensor(Matrix3(0.5, 0.05, 0.1, 0.05, 0.4, 0, 0.1, 0, 0.6));
        case 2:
            return changed->addVelocity(random.vector(3));
        case 3:
            return changed->setDamping(linear, angular);
        default:
            changed->setOrientation(real_cos(time), real_sin(time), 0.2, -0.1);
    }
}

void Scene::changeRegistrations() {
    const std::size_t which = static_cast<std::size_t>(frame / 45);
    RigidBody *const body = swarm[which % swarm.size()];
    world.getForceRegistry().remove(body, &gravity);
    if (which % 2 == 0) world.getForceRegistry().add(body, &gravity);
    world.getForceRegistry().add(swarm[which * 7 % swarm.size()], wings.front());
    world.getForceRegistry().remove(swarm[(which - 1) * 7 % swarm.size()], wings.front());
}

void Scene::changeBodies() {
    if (frame % 400 == 0) {
        if (visitorIsIn)
            world.removeBody(&visitor);
        else
            world.addBody(&visitor);
        visitorIsIn = !visitorIsIn;
    } else {
        const std::size_t place = static_cast<std::size_t>(frame / 211) * 11 % swarm.size();
        world.destroyBody(swarm[place]);
        swarm[place] = world.createBody();
        setUpSwarmBody(swarm[place]);
        for (ForceGenerator *force : swarmForces[place]) world.getForceRegistry().add(swarm[place], force);
    }
}

}  // namespace golden
