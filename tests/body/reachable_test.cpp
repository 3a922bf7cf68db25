/// Whatever is called with whatever numbers: a body stays in a state that can be saved and restored.
#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

/// Numbers as an attacker would choose them.
class Hostile {
public:
    explicit Hostile(std::uint64_t seed) : random(seed) {}

    unsigned below(unsigned count) { return static_cast<unsigned>(random.between(0, count)); }
    real number() {
        const real sign = below(3) == 0 ? -1 : 1;
        switch (below(8)) {
            case 0:
                return sign * 0.0;
            case 1:
                return sign;
            case 2:
                return sign * std::pow(10.0, random.between(-323, 308));
            case 3:
                return sign * REAL_MAX;
            case 4:
                return sign * 5e-324;
            case 5:
                return sign * std::pow(10.0, std::floor(random.between(-20, 20)));
            default:
                return random.between(-10, 10);
        }
    }
    Vector3 vector() {
        const real x = number(), y = number(), z = number();
        return Vector3(x, y, z);
    }
    Matrix3 tensor() {
        const Matrix3 values = diagonal(std::fabs(number()), std::fabs(number()), std::fabs(number()));
        if (below(2) == 0) return values;
        const Matrix3 axes = rotationMatrix(random.orientation());
        return axes * values * axes.transpose();
    }
    Quaternion quaternion() {
        const Vector3 v = vector();
        return below(2) == 0 ? random.orientation() : Quaternion(number(), v.x, v.y, v.z);
    }
    real duration() { return below(2) == 0 ? 1.0 / 60 : std::fabs(number()); }

private:
    Random random;
};

void call(unsigned which, RigidBody &body, ForceRegistry &registry, Hostile &random) {
    switch (which) {
        case 0:
            return body.setMass(random.number());
        case 1:
            return body.setInverseMass(random.number());
        case 2:
            return body.setInertiaTensor(random.tensor());
        case 3:
            return body.setInverseInertiaTensor(random.tensor());
        case 4:
            return body.setLinearDamping(random.number());
        case 5:
            return body.setAngularDamping(random.number());
        case 6:
            return body.setPosition(random.vector());
        case 7:
            return body.setOrientation(random.quaternion());
        case 8:
            return body.setVelocity(random.vector());
        case 9:
            return body.setRotation(random.vector());
        case 10:
            return body.addVelocity(random.vector());
        case 11:
            return body.addRotation(random.vector());
        case 12:
            return body.setAcceleration(random.vector());
        case 13:
            return body.addForce(random.vector());
        case 14:
            return body.addForceAtBodyPoint(random.vector(), random.vector());
        case 15:
            return body.addForceAtPoint(random.vector(), random.vector());
        case 16:
            return body.addTorque(random.vector());
        case 17:
            return body.clearAccumulators();
        case 18:
            return body.setAwake(random.below(2) == 0);
        case 19:
            return body.setCanSleep(random.below(2) == 0);
        case 20:
            return body.setSleepEpsilon(random.number());
        case 21:
            return registry.updateForces(random.duration());
        default:
            body.integrate(random.duration());
    }
}

void expectPossible(const RigidBody &body) {
    const RigidBody::State state = body.getState();
    ASSERT_EQ(state.findError(), nullptr) << state.findError();
    RigidBody restored;
    ASSERT_NO_THROW(restored.setState(state));
    RigidBody original = body;
    ASSERT_EQ(original.integrate(0.01), restored.integrate(0.01));
    ASSERT_EQ(original.getPosition(), restored.getPosition());
    ASSERT_EQ(original.getAngularMomentum(), restored.getAngularMomentum());
}

}  // namespace

TEST(Reachable, EveryStateIsPossible) {
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        Hostile random(seed);
        RigidBody body;
        Aero aero(diagonal(-std::fabs(random.number()), -std::fabs(random.number()), random.number()),
                  random.vector(), nullptr);
        Drag drag(std::fabs(random.number()), std::fabs(random.number()));
        aero.setRotationalFlow(random.below(2) == 0);
        ForceRegistry registry;
        registry.add(&body, &aero);
        registry.add(&body, &drag);
        for (int n = 0; n < 40; ++n) {
            const unsigned which = random.below(28);
            const RigidBody before = body;
            try {
                call(which, body, registry, random);
            } catch (const std::invalid_argument &) {
                RigidBody unchanged = before;
                RigidBody *const pair[] = {&body, &unchanged};
                ASSERT_EQ(hashStates(pair, 1), hashStates(pair + 1, 1)) << "call " << which;
            }
            expectPossible(body);
            if (testing::Test::HasFatalFailure()) FAIL() << "seed " << seed << ", call " << which;
        }
    }
}
