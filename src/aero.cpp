#include <cyclone/aero.h>

#include "arguments.h"

namespace cyclone {

using namespace detail;

Aero::Aero(const char *function, const Matrix3 &a, const Vector3 &p, const Vector3 *wind)
    : tensor(a), position(p), windspeed(wind) {
    requireFinite(a, function, "the tensor must be finite");
    requireFinite(p, function, "the position must be finite");
}

Aero::Aero(const Matrix3 &a, const Vector3 &p, const Vector3 *wind) : Aero("Aero::Aero", a, p, wind) {}

void Aero::updateForce(RigidBody *body, real) { body->addForceAtBodyPoint(getForce(*body), position); }

AeroControl::AeroControl(const Matrix3 &atZero, const Matrix3 &atMinusOne, const Matrix3 &atOne,
                         const Vector3 &p, const Vector3 *wind)
    : Aero("AeroControl::AeroControl", atZero, p, wind), base(atZero), min(atMinusOne), max(atOne) {
    requireFinite(min, "AeroControl::AeroControl", "the tensor must be finite");
    requireFinite(max, "AeroControl::AeroControl", "the tensor must be finite");
}

void AeroControl::setControl(real value) {
    requireFinite(value, "AeroControl::setControl", "the control must be finite");
    control = real_clamp(value, -1, 1);
    tensor = control < 0 ? Matrix3::linearInterpolate(base, min, -control)
                         : Matrix3::linearInterpolate(base, max, control);
}

AngledAero::AngledAero(const Matrix3 &a, const Vector3 &p, const Vector3 *wind)
    : Aero("AngledAero::AngledAero", a, p, wind), surfaceTensor(a) {}

void AngledAero::setOrientation(const Quaternion &q) {
    requireRotation(q, "AngledAero::setOrientation", "the quaternion must be finite and not zero");
    orientation = q;
    orientation.normalise();
    Matrix3 turn;
    turn.setOrientation(orientation);
    tensor = turn * surfaceTensor * turn.transpose();
}

}  // namespace cyclone
