#include <cyclone/aero.h>

#include <algorithm>

#include "arguments.h"

namespace cyclone {

using namespace detail;

Aero::Aero(const char *function, const Matrix3 &a, const Vector3 &p, const Vector3 *wind)
    : PointForce(function, p), windspeed(wind) {
    requireFinite(a, function, "the tensor must be finite");
    setTensor(a);
}

/// The Frobenius norm, of numbers whose squares may overflow.
void Aero::setTensor(const Matrix3 &a) {
    tensor = a;
    real largest = 0, squares = 0;
    for (const real entry : a.data) largest = std::max(largest, real_abs(entry));
    if (largest > 0)
        for (const real entry : a.data) squares += entry / largest * (entry / largest);
    tensorSize = largest * real_sqrt(squares);
}

Aero::Aero(const Matrix3 &a, const Vector3 &p, const Vector3 *wind) : Aero("Aero::Aero", a, p, wind) {}

void Aero::setWater(const Water *sea, real depth) {
    requirePositive(depth, "Aero::setWater", "fullDepth must be positive and finite");
    water = sea;
    fullDepth = depth;
}

real Aero::wettedPart(const Vector3 &point, real surfaceHeight) const {
    return real_clamp((surfaceHeight - point.y) / fullDepth, 0, 1);
}

Vector3 Aero::getForceInWater(Vector3 flow, const RigidBody &body) const {
    const Vector3 point = body.getPointInWorldSpace(position);
    const Water::Motion motion = water->getMotion(point);
    return getForceOf(flow - motion.velocity, body) * wettedPart(point, motion.height);
}

// As PointForce does, but here compilers see which getForce it is likely to be, and build it in.
void Aero::updateForce(RigidBody *body, real) {
    body->addForceAtBodyPoint(getForce(*body), position);
    body->addResistance(tensorSize, rotationalFlow ? tensorSize * position.squareMagnitude() : 0);
}

void Aero::addResistance(const RigidBody &body, Resistance &sum) const {
    Matrix3 turn;
    turn.setOrientation(body.getOrientation());
    Matrix3 inWorld = turn * tensor * turn.transpose();
    if (water != nullptr) {
        const Vector3 point = body.getPointInWorldSpace(position);
        inWorld *= wettedPart(point, water->getHeight(point));
    }
    sum.add(inWorld, body.getDirectionInWorldSpace(position), rotationalFlow);
}

AeroControl::AeroControl(const Matrix3 &atZero, const Matrix3 &atMinusOne, const Matrix3 &atOne,
                         const Vector3 &p, const Vector3 *wind)
    : Aero("AeroControl::AeroControl", atZero, p, wind), base(atZero), min(atMinusOne), max(atOne) {
    requireFinite(min, "AeroControl::AeroControl", "the tensor must be finite");
    requireFinite(max, "AeroControl::AeroControl", "the tensor must be finite");
}

void AeroControl::setControl(real value) {
    requireFinite(value, "AeroControl::setControl", "the control must be finite");
    control = real_clamp(value, -1, 1);
    setTensor(control < 0 ? Matrix3::linearInterpolate(base, min, -control)
                          : Matrix3::linearInterpolate(base, max, control));
}

AngledAero::AngledAero(const Matrix3 &a, const Vector3 &p, const Vector3 *wind)
    : Aero("AngledAero::AngledAero", a, p, wind), surfaceTensor(a) {}

void AngledAero::setOrientation(const Quaternion &q) {
    requireRotation(q, "AngledAero::setOrientation", "the quaternion must be finite and not zero");
    orientation = q;
    orientation.normalise();
    Matrix3 turn;
    turn.setOrientation(orientation);
    setTensor(turn * surfaceTensor * turn.transpose());
}

}  // namespace cyclone
