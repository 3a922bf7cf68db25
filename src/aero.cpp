#include <cyclone/aero.h>

namespace cyclone {

namespace {

void requireTensor(const Matrix3 &tensor, const char *function) {
    requireMatrix(tensor.isFinite(), function, "the tensor must be finite", tensor);
}

}  // namespace

Aero::Aero(const char *function, const Matrix3 &a, const Vector3 &p, const Vector3 *wind)
    : tensor(a), position(p), windspeed(wind) {
    requireTensor(a, function);
    requireVector(p.isFinite(), function, "the position must be finite", p);
}

Aero::Aero(const Matrix3 &a, const Vector3 &p, const Vector3 *wind) : Aero("Aero::Aero", a, p, wind) {}

void Aero::updateForce(RigidBody *body, real) { body->addForceAtBodyPoint(getForce(*body), position); }

AeroControl::AeroControl(const Matrix3 &atZero, const Matrix3 &atMinusOne, const Matrix3 &atOne,
                         const Vector3 &p, const Vector3 *wind)
    : Aero("AeroControl::AeroControl", atZero, p, wind), base(atZero), min(atMinusOne), max(atOne) {
    requireTensor(min, "AeroControl::AeroControl");
    requireTensor(max, "AeroControl::AeroControl");
}

void AeroControl::setControl(real value) {
    require(real_isfinite(value), "AeroControl::setControl", "the control must be finite", {value});
    control = real_clamp(value, -1, 1);
    tensor = control < 0 ? Matrix3::linearInterpolate(base, min, -control)
                         : Matrix3::linearInterpolate(base, max, control);
}

AngledAero::AngledAero(const Matrix3 &a, const Vector3 &p, const Vector3 *wind)
    : Aero("AngledAero::AngledAero", a, p, wind), surfaceTensor(a) {}

void AngledAero::setOrientation(const Quaternion &q) {
    requireQuaternion(q.isFinite() && q != Quaternion(0, 0, 0, 0), "AngledAero::setOrientation",
                      "the quaternion must be finite and not zero", q);
    orientation = q;
    orientation.normalise();
    Matrix3 turn;
    turn.setOrientation(orientation);
    tensor = turn * surfaceTensor * turn.transpose();
}

}  // namespace cyclone
