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

/// Resists of its own, with any strength.
class Honey : public ForceGenerator {
public:
    explicit Honey(real newtonSecondsPerMetre) : c(newtonSecondsPerMetre) {}
    void updateForce(RigidBody *body, real) override {
        body->addForce(body->getVelocity() * -c);
        body->addTorque(body->getRotation() * -c);
        body->addResistance(c, c);
    }
    void addResistance(const RigidBody &, Resistance &sum) const override {
        sum.forceByVelocity += diagonal(-c, -c, -c);
        sum.torqueByRotation += diagonal(-c, -c, -c);
    }
    bool actsOnItsBodyOnly() const override { return true; }

private:
    real c;
};

}  // namespace

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
    sleeper->setSleepEpsilon(0.02);
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
        swarmSprings.push_back(nullptr);
        if (n % 2 != 0) continue;
        const Vector3 anchor = body->getPosition() + random.vector(3);
        swarmSprings.back() = act<AnchoredSpring>(body, random.vector(0.3), anchor, 15.0, 1.0);
        swarmForces.back().push_back(swarmSprings.back());
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

void Scene::addWinch(RigidBody *body, const Vector3 &point, const Vector3 &place) {
    winches.push_back({act<AnchoredSpring>(body, point, place, 0.0, 0.0), place});
}

/// A load on a rod that swings in a plane, below a craft that can only move and turn in it.
void Scene::addPod(const Vector3 &position) {
    RigidBody *const craft = addBody(3, diagonal(1, 1, 1), position);
    RigidBody *const load = addBody(2, diagonal(0.1, 0.1, 0.1), position - Vector3(0.5, 2, 0));
    for (RigidBody *body : {craft, load}) {
        body->setLockedMotion(false, false, true);
        body->setAcceleration(0, -1.6, 0);
        act<Drag>(body, 0.1, 0.02)->setWind(&air);
    }
    craft->setInverseInertiaTensor(diagonal(0, 0, 2));
    load->setLinearDamping(0.9);
    Spring *const rod = act<Spring>(craft, craft, Vector3(), load, Vector3(0, 0.2, 0.1), 300.0, 2.0);
    rod->setDamping(5);
    registerAction(load, rod);
    thrusters.push_back(act<Thruster>(craft, Vector3::X, Vector3(0, -0.4, 0.1), 30.0));
    addWinch(craft, Vector3(0.1, 0.3, 0), position + Vector3(0, 3, 0));
}

/// Two bodies on a rubber band, one of them on a line: all of it belongs to the world.
void Scene::addOwned(const Vector3 &position) {
    RigidBody *const upper = world.createBody(), *const lower = world.createBody();
    upper->setPosition(position);
    lower->setPosition(position - Vector3(1, 2, 0.5));
    lower->setDamping(0.9, 0.5);
    for (RigidBody *body : {upper, lower}) {
        world.createForce<Gravity>(body, Vector3(0, -3.7, 0));
        world.createForce<Drag>(body, 0.05, 0.1).setWind(&shear);
    }
    world.createForce<AnchoredSpring>(upper, Vector3(0, 0.5, 0), position, 90, 1).setDamping(3);
    world.createSpring<Bungee>(upper, Vector3(0, -0.3, 0), lower, Vector3(0.1, 0.2, 0), 60, 1)
        .setDamping(200);
}

/// All kinds that resist, each with this strength, N·s/m, on bodies of 1 kg.
void Scene::addStiff(const Vector3 &position, real strength) {
    RigidBody *bodies[3];
    real x = 0;
    for (RigidBody *&body : bodies) {
        body = addBody(1, diagonal(0.2, 0.3, 0.4), position + Vector3(x += 3, 0, 0));
        body->setVelocity(random.vector(3));
        body->setRotation(random.vector(3));
        travellers.push_back({body, body->getPosition(), body->getVelocity()});
    }
    act<Drag>(bodies[0], strength, strength)->setWind(&air);
    thrusters.push_back(act<Propeller>(bodies[0], Vector3::X, Vector3(), 10 * strength, 10.0, &wind));

    const Matrix3 tensor = diagonal(-strength, -0.1 * strength, -2 * strength);
    act<Aero>(bodies[1], tensor, Vector3(0.2, 0.1, 0), &wind)->setRotationalFlow(true);
    act<Wing>(bodies[1], 1.0, 0.3, Vector3(0.1, 0, 0), &wind)->setWind(&air);

    const Vector3 centre(0.1, -0.2, 0), drag(strength, 2 * strength, 0.5 * strength);
    Buoyancy *const hull = act<Buoyancy>(bodies[2], centre, 0.2, 0.002, position.y);
    act<HullDrag>(bodies[2], hull, centre, drag, drag);
    registerAction(bodies[2], &gravity);
    const Vector3 anchor = position + Vector3(9, 2, 0);
    act<AnchoredSpring>(bodies[2], Vector3(0.1, 0.2, 0), anchor, 50.0, 1.0)->setDamping(strength);
    act<Honey>(bodies[2], 0.1 * strength);
}

}  // namespace golden
