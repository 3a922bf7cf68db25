#include <cyclone/cyclone.h>

#include <cstdio>
#include <deque>
#include <functional>
#include <memory>

#include "benchmark.h"
#include "scene.h"
#include "timing.h"

namespace benchmark {

namespace {

using namespace cyclone;

constexpr std::size_t BODIES = 1000, RUNS = 300;

/// Bodies in all attitudes about the water's surface, each with a generator of one kind.
class Crowd {
public:
    Crowd(const char *label, const std::function<std::unique_ptr<ForceGenerator>()> &makeGenerator)
        : name(label) {
        for (std::size_t n = 0; n < BODIES; ++n) {
            const real angle = 0.7 * static_cast<real>(n);
            bodies.emplace_back();
            RigidBody &body = bodies.back();
            body.setMass(300);
            body.setInertiaTensor(Matrix3(300, 0, 0, 0, 500, 0, 0, 0, 400));
            body.setPosition(angle, 0.5 * real_sin(angle), 0);
            body.setOrientation(Quaternion::fromAxisAngle(Vector3(0.3, 1, 0.2), angle));
            body.setVelocity(15 * real_cos(angle), real_sin(2 * angle), 15 * real_sin(angle));
            body.setRotation(0.1, 0.2, 0.3);
            generators.push_back(makeGenerator());
            registry.add(&body, generators.back().get());
        }
    }

    void measure() {
        times.add(timeOf([this] { registry.updateForces(STEP); }) / BODIES);
        for (RigidBody &body : bodies) body.clearAccumulators();
    }

    const char *name;
    Timings times;

private:
    std::deque<RigidBody> bodies;
    std::deque<std::unique_ptr<ForceGenerator>> generators;
    ForceRegistry registry;
};

}  // namespace

void measureGenerators() {
    const Vector3 windspeed(-3, 0, 1), position(0.5, 0.1, 1);
    const Matrix3 tensor(-0.1, 0, 0, 0.3, -0.5, 0, 0, 0, -0.1);
    const WindGradient breeze(Vector3(6, 0, 0), 10);
    Waves sea;
    for (const real wavelength : {50.0, 31.0, 17.0, 9.0})
        sea.addTrain({0.01 * wavelength, wavelength, 0.1 * wavelength, wavelength});
    const Buoyancy hull(Vector3(), 0.5, 1, 0);

    std::deque<Crowd> crowds;
    crowds.emplace_back("Aero", [&] { return std::make_unique<Aero>(tensor, position, &windspeed); });
    crowds.emplace_back("Aero in a WindGradient", [&] {
        auto aero = std::make_unique<Aero>(tensor, position, &windspeed);
        aero->setWind(&breeze);
        return aero;
    });
    crowds.emplace_back("Wing", [&] { return std::make_unique<Wing>(3, 1, position, &windspeed); });
    crowds.emplace_back("Buoyancy in 4 trains of waves", [&] {
        auto buoyancy = std::make_unique<Buoyancy>(Vector3(), 0.5, 1, 0);
        buoyancy->setWater(&sea);
        return buoyancy;
    });
    crowds.emplace_back("HullDrag", [&] {
        return std::make_unique<HullDrag>(&hull, Vector3(), Vector3(10, 20, 30), Vector3(1, 2, 3));
    });

    for (std::size_t n = 0; n < RUNS; ++n)
        for (Crowd &crowd : crowds) crowd.measure();
    std::printf("\nA generator, of %zu bodies            ns a body and step   times an Aero\n", BODIES);
    for (const Crowd &crowd : crowds)
        std::printf("%-36s %20.1f %15.2f\n", crowd.name, crowd.times.least(),
                    crowd.times.least() / crowds.front().times.least());
}

}  // namespace benchmark
