#include <cyclone/massproperties.h>

#include <algorithm>

#include "arguments.h"
#include "principalaxes.h"

namespace cyclone {

using namespace detail;

namespace {

/// ∫(r²·1 − r·rᵀ)dm of a mass at the point r.
Matrix3 pointInertia(real mass, const Vector3 &r) {
    const real xx = mass * r.x * r.x, yy = mass * r.y * r.y, zz = mass * r.z * r.z;
    Matrix3 result;
    result.setInertiaTensorCoeffs(yy + zz, xx + zz, xx + yy, mass * r.x * r.y, mass * r.x * r.z,
                                  mass * r.y * r.z);
    return result;
}

/// By how much the moments miss those of a real thing, none of which is negative or greater than the other
/// two together. Not positive: not at all.
real triangleError(const Matrix3 &symmetricTensor) {
    Vector3 moments;
    Quaternion axes;
    findPrincipalAxes(symmetricTensor, moments, axes);
    const real least = std::min({moments.x, moments.y, moments.z});
    const real greatest = std::max({moments.x, moments.y, moments.z});
    return std::max(-least, greatest - (moments.x + moments.y + moments.z - greatest));
}

void requireRadii(real radius, real innerRadius, const char *function) {
    requirePositive(radius, function, "the radius must be positive and finite");
    require(innerRadius >= 0 && innerRadius <= radius, function,
            "the inner radius must be between 0 and the radius", {innerRadius});
}

void requireLength(real length, const char *function) {
    requireNotNegative(length, function, "the length must be finite and not negative");
}

/// The mass of a solid of that volume.
real massOf(const MassOrDensity &amount, real volume, const char *function) {
    const real mass = amount.getMass(volume);
    requirePositive(mass, function, "the mass, or density times volume, must be positive and finite");
    return mass;
}

/// A solid whose axes are principal, from its mass and the mean squares of its points' coordinates about its
/// centre.
MassProperties fromMeanSquares(real mass, const Vector3 &centre, const Vector3 &squares,
                               const char *function) {
    Matrix3 tensor;
    tensor.setDiagonal(mass * (squares.y + squares.z), mass * (squares.x + squares.z),
                       mass * (squares.x + squares.y));
    requireVector(tensor.isFinite(), function, "sizes and mass must have a finite inertia tensor", squares);
    return MassProperties(mass, centre, tensor);
}

}  // namespace

MassProperties::MassProperties(real kilograms, const Vector3 &centreOfMass, const Matrix3 &tensor)
    : mass(kilograms), centre(centreOfMass) {
    const char *const function = "MassProperties::MassProperties";
    requirePositive(mass, function, "the mass must be positive and finite");
    requireFinite(centre, function, "the centre must be finite");
    const char *const rule =
        "the tensor must be symmetric, with moments not negative and none greater than the others' sum";
    requireMatrix(tensor.isFinite() && isSymmetric(tensor), function, rule, tensor);
    inertiaTensor = symmetricPart(tensor);
    const real *d = tensor.data;
    const real tolerance = 1e-9 * std::max({real_abs(d[0]), real_abs(d[4]), real_abs(d[8])}) + DBL_MIN;
    const real error = triangleError(inertiaTensor);
    requireMatrix(error <= tolerance, function, rule, tensor);
    for (int n = 0; n < 9; n += 4) inertiaTensor.data[n] += std::max<real>(error, 0);  // takes rounding back
}

// ---- Solids

MassProperties MassProperties::box(const Vector3 &halfSizes, const MassOrDensity &amount) {
    const char *const function = "MassProperties::box";
    requireVector(halfSizes.isFinite() && std::min({halfSizes.x, halfSizes.y, halfSizes.z}) >= 0, function,
                  "half the edges must be finite and not negative", halfSizes);
    const real mass = massOf(amount, 8 * halfSizes.x * halfSizes.y * halfSizes.z, function);
    return fromMeanSquares(mass, Vector3(), halfSizes.componentProduct(halfSizes) * (1.0 / 3), function);
}

MassProperties MassProperties::sphere(real radius, const MassOrDensity &amount, real innerRadius) {
    const char *const function = "MassProperties::sphere";
    requireRadii(radius, innerRadius, function);
    const real R = radius, r = innerRadius;
    // (R⁵ − r⁵)/(R³ − r³), with R − r divided out of both.
    const real squares = R * R + R * r + r * r;
    const real fourthPowers = R * R * R * R + R * R * R * r + R * R * r * r + R * r * r * r + r * r * r * r;
    const real mass = massOf(amount, REAL_PI * 4 / 3 * squares * (R - r), function);
    const real meanSquare = fourthPowers / squares / 5;
    return fromMeanSquares(mass, Vector3(), Vector3(1, 1, 1) * meanSquare, function);
}

MassProperties MassProperties::ellipsoid(const Vector3 &halfAxes, const MassOrDensity &amount) {
    const char *const function = "MassProperties::ellipsoid";
    requireVector(halfAxes.isFinite() && std::min({halfAxes.x, halfAxes.y, halfAxes.z}) > 0, function,
                  "half the axes must be positive and finite", halfAxes);
    const real mass = massOf(amount, REAL_PI * 4 / 3 * halfAxes.x * halfAxes.y * halfAxes.z, function);
    return fromMeanSquares(mass, Vector3(), halfAxes.componentProduct(halfAxes) * 0.2, function);
}

MassProperties MassProperties::cylinder(real radius, real length, const MassOrDensity &amount,
                                        real innerRadius) {
    const char *const function = "MassProperties::cylinder";
    requireRadii(radius, innerRadius, function);
    requireLength(length, function);
    const real area = REAL_PI * (radius + innerRadius) * (radius - innerRadius);
    const real mass = massOf(amount, area * length, function);
    const real across = (radius * radius + innerRadius * innerRadius) / 4;
    return fromMeanSquares(mass, Vector3(), Vector3(across, length * length / 12, across), function);
}

MassProperties MassProperties::capsule(real radius, real length, const MassOrDensity &amount) {
    const char *const function = "MassProperties::capsule";
    requireRadii(radius, 0, function);
    requireLength(length, function);
    const real shaftVolume = length, ballVolume = 4.0 / 3 * radius;  // both divided by the area π·radius²
    const real mass = massOf(amount, REAL_PI * radius * radius * (shaftVolume + ballVolume), function);
    const real shaft = shaftVolume / (shaftVolume + ballVolume), ball = 1 - shaft;
    // The flat side of each half sphere lies at half the length, its centre 3/8·radius further out.
    const real halfLength = length / 2;
    const real across = radius * radius * (shaft / 4 + ball / 5);
    const real along = shaft * length * length / 12 +
                       ball * (radius * radius / 5 + halfLength * (halfLength + 0.75 * radius));
    return fromMeanSquares(mass, Vector3(), Vector3(across, along, across), function);
}

MassProperties MassProperties::cone(real radius, real height, const MassOrDensity &amount) {
    const char *const function = "MassProperties::cone";
    requireRadii(radius, 0, function);
    requirePositive(height, function, "the height must be positive and finite");
    const real mass = massOf(amount, REAL_PI / 3 * radius * radius * height, function);
    const real across = radius * radius * (3.0 / 20);
    const real along = height * height * (3.0 / 80);
    return fromMeanSquares(mass, Vector3(0, height / 4, 0), Vector3(across, along, across), function);
}

// ---- Parts and wholes

Matrix3 MassProperties::getInertiaTensorAbout(const Vector3 &point) const {
    return inertiaTensor + pointInertia(mass, point - centre);
}

MassProperties MassProperties::placedAt(const Vector3 &position, const Quaternion &orientation) const {
    const char *const function = "MassProperties::placedAt";
    requireFinite(position, function, "the position must be finite");
    requireRotation(orientation, function, "the orientation must be finite and not zero");
    Quaternion turn = orientation;
    turn.normalise();
    Matrix3 axes;
    axes.setOrientation(turn);
    MassProperties result = *this;
    result.centre = axes * centre + position;
    requireVector(result.centre.isFinite(), function, "the centre must stay finite", result.centre);
    result.inertiaTensor = symmetricPart(axes * inertiaTensor * axes.transpose());
    requireMatrix(result.inertiaTensor.isFinite(), function, "the tensor must stay finite",
                  result.inertiaTensor);
    return result;
}

MassProperties MassProperties::operator+(const MassProperties &part) const {
    if (part.mass == 0) return *this;
    if (mass == 0) return part;
    MassProperties result;
    result.mass = mass + part.mass;
    // Two masses about their common centre: as the reduced mass at the distance between them.
    const real share = part.mass / result.mass;
    const Vector3 span = part.centre - centre;
    result.centre = centre + span * share;
    result.inertiaTensor = inertiaTensor + part.inertiaTensor + pointInertia(mass * share, span);
    require(real_isfinite(result.mass) && result.inertiaTensor.isFinite(), "MassProperties::operator+",
            "the sum must be finite", {result.mass});
    return result;
}

void MassProperties::applyTo(RigidBody &body) const {
    require(mass > 0, "MassProperties::applyTo", "the mass must be positive", {mass});
    RigidBody changed = body;
    changed.setMass(mass);
    changed.setInertiaTensor(inertiaTensor);
    body = changed;
}

}  // namespace cyclone
