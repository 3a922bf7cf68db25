#include <cyclone/aero.h>

#include "arguments.h"

namespace cyclone {

using namespace detail;

Aero::Aero(const char *function, const Matrix3 &a, const Vector3 &p, const Vector3 *windspeedAddress)
    : PointForce(function, p), tensor(a), windspeed(windspeedAddress) {
    requireFinite(a, function, "the tensor must be finite");
}

Aero::Aero(const Matrix3 &a, const Vector3 &p, const Vector3 *windspeedAddress)
    : Aero("Aero::Aero", a, p, windspeedAddress) {}

void Aero::setWater(const Water *sea, real depth) {
    requirePositive(depth, "Aero::setWater", "fullDepth must be positive and finite");
    water = sea;
    fullDepth = depth;
}

Vector3 Aero::getForceInWater(const Vector3 &flow, const RigidBody &body) const {
    const Vector3 point = body.getPointInWorldSpace(position);
    const Water::Motion motion = water->getMotion(point);
    const real wetted = real_clamp((motion.height - point.y) / fullDepth, 0, 1);
    return getForceOf(flow - motion.velocity, body) * wetted;
}

// As PointForce does, but here compilers see which getForce it is likely to be, and build it in.
void Aero::updateForce(RigidBody *body, real) { body->addForceAtBodyPoint(getForce(*body), position); }

AeroControl::AeroControl(const Matrix3 &atZero, const Matrix3 &atMinusOne, const Matrix3 &atOne,
                         const Vector3 &p, const Vector3 *windspeedAddress)
    : Aero("AeroControl::AeroControl", atZero, p, windspeedAddress),
      base(atZero),
      min(atMinusOne),
      max(atOne) {
    requireFinite(min, "AeroControl::AeroControl", "the tensor must be finite");
    requireFinite(max, "AeroControl::AeroControl", "the tensor must be finite");
}

void AeroControl::setControl(real value) {
    requireFinite(value, "AeroControl::setControl", "the control must be finite");
    control = real_clamp(value, -1, 1);
    tensor = control < 0 ? Matrix3::linearInterpolate(base, min, -control)
                         : Matrix3::linearInterpolate(base, max, control);
}

AngledAero::AngledAero(const Matrix3 &a, const Vector3 &p, const Vector3 *windspeedAddress)
    : Aero("AngledAero::AngledAero", a, p, windspeedAddress), surfaceTensor(a) {}

void AngledAero::setOrientation(const Quaternion &q) {
    requireRotation(q, "AngledAero::setOrientation", "the quaternion must be finite and not zero");
    orientation = q;
    orientation.normalise();
    Matrix3 turn;
    turn.setOrientation(orientation);
    tensor = turn * surfaceTensor * turn.transpose();
}

}  // namespace cyclone
