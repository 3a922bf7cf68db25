#include "scene.h"

#include <utility>

namespace benchmark {

using cyclone::Matrix3;
using cyclone::real;
using cyclone::Vector3;

namespace {

const Vector3 WIND(-3, 0, 1);
const Matrix3 TENSOR(-0.1, 0, 0, 0.3, -0.5, 0, 0, 0, -0.1);
const Vector3 OFF_CENTRE(-0.2, 0.05, 0.1);
const Matrix3 DIAGONAL(0.2, 0, 0, 0, 0.5, 0, 0, 0, 0.4);
const Matrix3 NON_DIAGONAL(0.2, 0.02, 0.01, 0.02, 0.5, 0.03, 0.01, 0.03, 0.4);
constexpr real MASS = 2.5, LINEAR_DAMPING = 0.95, ANGULAR_DAMPING = 0.8;

template <class T>
void shuffle(std::vector<T> &items, Random &random) {
    for (std::size_t n = items.size(); n > 1; --n) std::swap(items[n - 1], items[random.below(n)]);
}

void setUp(cyclone::RigidBody &body, const Scene &scene, Random &random) {
    body.setMass(MASS);
    body.setInertiaTensor(scene.nonDiagonal ? NON_DIAGONAL : DIAGONAL);
    if (!scene.forceFree) {
        body.setDamping(LINEAR_DAMPING, ANGULAR_DAMPING);
        body.setAcceleration(Vector3::GRAVITY);
    }
    body.setPosition(random.vector(100));
    body.setVelocity(random.vector(10));
    body.setRotation(random.vector(2));
}

void setUp(classic::Body &body, const Scene &scene, Random &random) {
    body.inverseMass = 1 / MASS;
    body.inverseInertiaTensor = (scene.nonDiagonal ? NON_DIAGONAL : DIAGONAL).inverse();
    if (!scene.forceFree) {
        body.linearDamping = LINEAR_DAMPING;
        body.angularDamping = ANGULAR_DAMPING;
        body.acceleration = Vector3::GRAVITY;
    }
    body.position = random.vector(100);
    body.velocity = random.vector(10);
    body.rotation = random.vector(2);
    body.calculateDerivedData();
}

}  // namespace

real Random::between(real low, real high) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * static_cast<real>(state >> 11) * 0x1p-53;
}

std::size_t Random::below(std::size_t end) {
    return static_cast<std::size_t>(between(0, static_cast<real>(end)));
}

Vector3 Random::vector(real size) {
    const real x = between(-size, size), y = between(-size, size);
    return Vector3(x, y, between(-size, size));
}

CycloneRun::CycloneRun(const Scene &scene, std::size_t count) : storage(scene.owned ? 0 : count) {
    Random random;
    std::vector<cyclone::RigidBody *> bodies;
    for (cyclone::RigidBody &body : storage) bodies.push_back(&body);
    while (bodies.size() < count) bodies.push_back(world.createBody());
    if (scene.shuffled) shuffle(bodies, random);
    for (std::size_t n = 0; n < count; ++n) {
        const bool asleep = scene.halfAsleep && n % 2 == 1;
        setUp(*bodies[n], scene, random);
        if (asleep) bodies[n]->setAwake(false);
        if (!scene.owned) world.addBody(bodies[n]);
        if (asleep || scene.forceFree) continue;
        surfaces.emplace_back(TENSOR, OFF_CENTRE, &WIND);
        world.getForceRegistry().add(bodies[n], &surfaces.back());
    }
    world.saveState(beginning);
}

ClassicRun::ClassicRun(const Scene &scene, std::size_t count) : storage(count) {
    Random random;
    std::vector<classic::Body *> bodies;
    for (classic::Body &body : storage) bodies.push_back(&body);
    if (scene.shuffled) shuffle(bodies, random);
    for (classic::Body *body : bodies) {
        setUp(*body, scene, random);
        world.bodies.push_back(body);
        if (scene.forceFree) continue;
        surfaces.emplace_back(TENSOR, OFF_CENTRE, &WIND);
        world.registrations.push_back({body, &surfaces.back()});
    }
    beginning = storage;
}

}  // namespace benchmark
