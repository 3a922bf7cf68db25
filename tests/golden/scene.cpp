#include "scene.h"

// Never two random numbers in one call: C++ does not say which argument is evaluated first.

namespace golden {

using namespace cyclone;

Scene::Scene(std::size_t threads, int swarmSize) {
    air.add(&shear);
    air.add(&thermal);
    air.add(&downburst);
    air.add(&gusts);
    sea.addTrain({0.25, 9, 0.3, 0});
    sea.addTrain({0.1, 4, 1.2, 0.7});
    for (int n = 0; n < 3; ++n) sea.addTrain({0.02, 2.0 + n, 2.0 * n, 0.1});
    for (int n = 0; n < 4; ++n) addAircraft(Vector3(40.0 * n, 100, 0));
    for (int n = 0; n < 2; ++n) addGlider(Vector3(30.0 * n, 60, 20));
    for (int n = 0; n < 4; ++n) addBoat(Vector3(12.0 * n, 0, 50), n % 2 == 1);
    for (int n = 0; n < 2; ++n) addMotorboat(Vector3(-12.0 * n, 0.2, 50), n % 2 == 1);
    for (int n = 0; n < 2; ++n) addRaft(Vector3(0, 0, 80 + 10.0 * n), n == 0);
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
    for (int n = 0; n < 2; ++n) addPod(Vector3(10.0 * n, 20, 170));
    addOwned(Vector3(0, 20, 180));
    for (real strength : {30.0, 1e9}) addStiff(Vector3(0, 10 * real_log(strength), 190), strength);
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
    sendHome();
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
    downburst.setFoot(Vector3(10 * real_sin(0.2 * time), -10, 30));
    thermal.setFoot(Vector3(60 + 40 * real_sin(0.05 * time), -20, 0));
    makeGust();
    sea.setTime(time);
    for (std::size_t n = 0; n < wings.size(); ++n)
        wings[n]->setControl(1.1 * real_sin(0.9 * time + static_cast<real>(n)));
    for (std::size_t n = 0; n < flaps.size(); ++n)
        flaps[n]->setControl(1.1 * real_sin(0.7 * time + static_cast<real>(n)));
    for (std::size_t n = 0; n < sails.size(); ++n)
        sails[n]->setOrientation(
            Quaternion::fromAxisAngle(Vector3::UP, 0.6 * real_sin(0.5 * time + static_cast<real>(n))));
    for (std::size_t n = 0; n < thrusters.size(); ++n) {
        thrusters[n]->setThrottle(0.5 + 0.6 * real_sin(1.1 * time + static_cast<real>(n)));
        thrusters[n]->setDirection(Vector3(1, 0.05 * real_sin(time), 0.1 * real_cos(time)));
    }
    for (std::size_t n = 0; n < winches.size(); ++n) {
        const real turn = real_sin(0.3 * time + static_cast<real>(n));
        winches[n].spring->setAnchor(winches[n].place + Vector3(0, 0.5 * turn, 0));
        winches[n].spring->setRestLength(1.5 + turn);
        winches[n].spring->setSpringConstant(40 + 20 * turn);
        winches[n].spring->setDamping(10 + 10 * turn);
    }
}

/// Other gusts every few frames, so that those of a frame follow from its number alone.
void Scene::makeGust() {
    gusts = Turbulence(8, static_cast<std::uint64_t>(frame / 16));
    gusts.setWindAt6Metres(8 + 4 * real_cos(0.2 * time));
    for (int n = 0; n <= frame % 16; ++n) gusts.advance(Vector3(14, 0, 3 * real_sin(time)), 100, 1.0 / 60);
}

void Scene::addForces() {
    for (std::size_t n = 0; n < doors.size(); ++n)
        doors[n]->addTorque(random.vector(2) + Vector3(0, real_sin(2 * time), 0));
    RigidBody *const pushed = swarm[static_cast<std::size_t>(frame) % swarm.size()];
    pushed->addForceAtPoint(random.vector(30), pushed->getPointInWorldSpace(Vector3(0.1, 0.2, 0)));
    links[static_cast<std::size_t>(frame) % links.size()]->addForceAtBodyPoint(random.vector(5),
                                                                               Vector3(0, 0.2, 0));
    RigidBody *const lifted = travellers[static_cast<std::size_t>(frame) % travellers.size()].body;
    lifted->addForce(sea.getNormal(lifted->getPosition()));
    if (frame % 350 == 349)
        for (RigidBody *sleeper : sleepers) sleeper->addForce(random.vector(60));
}

void Scene::useSetters() {
    if (frame % 200 == 100) platform->setVelocity(0, random.between(-0.5, 0.5), 0);
    if (frame % 29 != 28) return;
    const real linear = random.between(0.6, 1), angular = random.between(0.6, 1);
    RigidBody *const changed = swarm[static_cast<std::size_t>(frame / 29) % swarm.size()];
    switch (frame / 29 % 8) {
        case 0:
            return changed->setMass(random.between(0.5, 3));
        case 1:
            return changed->setInertiaTensor(Matrix3(0.5, 0.05, 0.1, 0.05, 0.4, 0, 0.1, 0, 0.6));
        case 2:
            return changed->addVelocity(random.vector(3));
        case 3:
            return changed->setDamping(linear, angular);
        case 4:
            return changed->setLockedMotion(linear < 0.7, angular<0.7, angular> 0.9);
        case 5:
            changed->addImpulseAtPoint(random.vector(3), changed->getPosition() + Vector3(0.1, 0, 0.2));
            return changed->addRotation(random.vector(2));
        case 6:
            sleepers[static_cast<std::size_t>(frame) % sleepers.size()]->setAwake(false);
            return changed->addImpulse(random.vector(3));
        default:
            changed->setOrientation(real_cos(time), real_sin(time), 0.2, -0.1);
    }
}

void Scene::sendHome() {
    if (frame % 25 != 24) return;
    const Traveller &traveller = travellers[static_cast<std::size_t>(frame / 25) % travellers.size()];
    traveller.body->setPosition(traveller.home);
    traveller.body->setOrientation(Quaternion());
    traveller.body->setVelocity(traveller.velocity);
    traveller.body->setRotation(0, 0, 0);
}

void Scene::changeRegistrations() {
    const std::size_t which = static_cast<std::size_t>(frame / 45);
    RigidBody *const body = swarm[which % swarm.size()];
    world.getForceRegistry().remove(body, &gravity);
    if (which % 2 == 0) world.getForceRegistry().add(body, &gravity);
    world.getForceRegistry().add(swarm[which * 7 % swarm.size()], wings.front());
    world.getForceRegistry().remove(swarm[(which - 1) * 7 % swarm.size()], wings.front());
    shoot();
}

/// At one of the swarm, with a rubber band between. All of it belongs to the world.
void Scene::shoot() {
    if (shots.size() == 6) {
        world.destroyBody(shots.front());
        shots.pop_front();
    }
    RigidBody *const shot = world.createBody();
    RigidBody *const target = swarm[static_cast<std::size_t>(frame) * 13 % swarm.size()];
    shot->setPosition(target->getPosition() + random.vector(2));
    shot->setVelocity(random.vector(20));
    ForceGenerator &fuel = world.createForce<Gravity>(shot, Vector3(3, 0, 0));
    world.createForce<Drag>(shot, 0.02, 0.01).setWind(&air);
    world.createSpring<Bungee>(shot, Vector3(0.1, 0, 0), target, Vector3(), 5, 2).setDamping(0.5);
    if (shots.size() % 2 == 0) world.destroyForce(fuel);
    shots.push_back(shot);
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
        if (swarmSprings[place] != nullptr)
            swarmSprings[place]->setAnchor(swarm[place]->getPosition() + random.vector(3));
    }
}

}  // namespace golden
