#include <cyclone/aero.h>

namespace cyclone {

namespace {

void requireSurface(const Matrix3 &tensor, const Vector3 &position, const char *function) {
    requireMatrix(tensor.isFinite(), function, "the tensor must be finite", tensor);
    requireVector(position.isFinite(), function, "the position must be finite", position);
}

}  // namespace

Aero::Aero(const Matrix3 &a, const Vector3 &p, const Vector3 *wind)
    : tensor(a), position(p), windspeed(wind) {
    requireSurface(a, p, "Aero::Aero");
}

void Aero::updateForce(RigidBody *body, real) { body->addForceAtBodyPoint(getForce(*body), position); }

AeroControl::AeroControl(const Matrix3 &atZero, const Matrix3 &atMinusOne, const Matrix3 &atOne,
                         const Vector3 &p, const Vector3 *wind)
    : Aero(atZero, p, wind), base(atZero), min(atMinusOne), max(atOne) {
    requireSurface(base, p, "AeroControl::AeroControl");
    requireSurface(min, p, "AeroControl::AeroControl");
    requireSurface(max, p, "AeroControl::AeroControl");
}

void AeroControl::setControl(real value) {
    require(value == value, "AeroControl::setControl", "the control must be a number", {value});
    control = real_clamp(value, -1, 1);
    tensor = control < 0 ? Matrix3::linearInterpolate(base, min, -control)
                         : Matrix3::linearInterpolate(base, max, control);
}

AngledAero::AngledAero(const Matrix3 &a, const Vector3 &p, const Vector3 *wind)
    : Aero(a, p, wind), surfaceTensor(a) {}

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
