/// Inertia tensors and mass properties: what is accepted steps finitely and keeps the angular momentum.
#include <cyclone/massproperties.h>

#include <algorithm>
#include <stdexcept>

#include "input.h"

using namespace cyclone;
using namespace cyclone_fuzz;

namespace {

MassOrDensity amount(Input &input) {
    if (input.flag()) return Mass(input.number());
    return Density(input.number());
}

MassProperties solid(Input &input) {
    switch (input.below(7)) {
        case 0:
            return MassProperties::box(input.vector(), amount(input));
        case 1:
            return MassProperties::sphere(input.number(), amount(input), input.number());
        case 2:
            return MassProperties::ellipsoid(input.vector(), amount(input));
        case 3:
            return MassProperties::cylinder(input.number(), input.number(), amount(input), input.number());
        case 4:
            return MassProperties::capsule(input.number(), input.number(), amount(input));
        case 5:
            return MassProperties::cone(input.number(), input.number(), amount(input));
        default:
            return MassProperties(input.number(), input.vector(), input.matrix());
    }
}

/// What is built of accepted parts is accepted as a part.
MassProperties assembly(Input &input) {
    MassProperties whole;
    for (unsigned n = 1 + input.below(4); n > 0; --n) {
        whole += solid(input).placedAt(input.vector(), input.quaternion());
        try {
            MassProperties(whole.getMass(), whole.getCentre(), whole.getInertiaTensor());
        } catch (const std::invalid_argument &error) {
            expect(false, error.what());
        }
    }
    return whole;
}

void setInertia(RigidBody &body, Input &input) {
    switch (input.below(3)) {
        case 0:
            return body.setInertiaTensor(input.matrix());
        case 1:
            return body.setInverseInertiaTensor(input.matrix());
        default:
            return assembly(input).applyTo(body);
    }
}

bool hasLockedAxis(const RigidBody &body) {
    const Vector3 inverse = body.getState().inverseInertia;
    return inverse.x == 0 || inverse.y == 0 || inverse.z == 0;
}

void checkSteps(RigidBody &body) {
    const Vector3 momentum = body.getAngularMomentum();
    const bool isFree = !hasLockedAxis(body);
    for (int n = 0; n < 60; ++n) {
        expect(body.integrate(1.0 / 60), "a free rotation at a sane speed does not fault");
        if (const char *error = body.getState().findError()) expect(false, error);
        if (!isFree) continue;
        expect(body.getAngularMomentum() == momentum, "free rotation keeps the angular momentum");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count) {
    Input input(bytes, count);
    RigidBody body;
    try {
        setInertia(body, input);
        if (input.flag()) body.setOrientation(input.quaternion());
        const Vector3 rotation = input.vector();
        if (const char *error = body.getState().findError()) expect(false, error);
        if (!(rotation.magnitude() <= 1e3)) return 0;
        body.setRotation(rotation);
    } catch (const std::invalid_argument &) {
        return 0;
    }
    checkSteps(body);
    return 0;
}
