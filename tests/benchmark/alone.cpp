#include <cstdio>

#include "benchmark.h"
#include "scene.h"
#include "timing.h"

namespace benchmark {

namespace {

constexpr std::size_t RUNS = 500, STEPS = 2000;

using cyclone::Vector3;

/// Nanoseconds per step of a body that flies alone.
template <class Body>
double timeSteps(const Body &beginning) {
    Body body = beginning;
    const double time = timeOf([&] {
        for (std::size_t n = 0; n < STEPS; ++n) body.integrate(STEP);
    });
    keep(body);
    return time / static_cast<double>(STEPS);
}

}  // namespace

void measureBodyAlone() {
    cyclone::RigidBody body;
    body.setInertiaTensor(cyclone::Matrix3(0.2, 0, 0, 0, 0.5, 0, 0, 0, 0.4));
    body.setDamping(0.95, 0.8);
    body.setAcceleration(Vector3::GRAVITY);
    body.setRotation(1, 2, 0.5);

    classic::Body classicBody;
    classicBody.inverseInertiaTensor.setDiagonal(1 / 0.2, 1 / 0.5, 1 / 0.4);
    classicBody.linearDamping = 0.95;
    classicBody.angularDamping = 0.8;
    classicBody.acceleration = Vector3::GRAVITY;
    classicBody.rotation = Vector3(1, 2, 0.5);
    classicBody.calculateDerivedData();

    Timings ours, theirs;
    for (std::size_t n = 0; n < RUNS; ++n) {
        ours.add(timeSteps(body));
        theirs.add(timeSteps(classicBody));
    }
    std::printf("\nOne body alone: integrate %.1f ns, the classic step %.1f ns, ratio %.2f\n", ours.least(),
                theirs.least(), theirs.least() / ours.least());
}

}  // namespace benchmark
