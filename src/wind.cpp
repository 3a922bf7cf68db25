#include <cyclone/wind.h>

#include "arguments.h"

namespace cyclone {

using namespace detail;

WindGradient::WindGradient(const Vector3 &velocity, real height, real power)
    : velocityAtReference(velocity), referenceHeight(height), exponent(power) {
    requireFinite(velocity, "WindGradient::WindGradient", "the velocity must be finite");
    requirePositive(height, "WindGradient::WindGradient", "the reference height must be positive and finite");
    requireNotNegative(power, "WindGradient::WindGradient", "the exponent must be finite and not negative");
}

Vector3 WindGradient::getVelocity(const Vector3 &point) const {
    if (!(point.y > 0)) return Vector3();
    return velocityAtReference * real_pow(point.y / referenceHeight, exponent);
}

Thermal::Thermal(const Vector3 &point, real rise, real coreRadius, real height)
    : foot(point), strength(rise), radius(coreRadius), top(height) {
    requireFinite(point, "Thermal::Thermal", "the foot must be finite");
    requireFinite(rise, "Thermal::Thermal", "the strength must be finite");
    requirePositive(coreRadius, "Thermal::Thermal", "the radius must be positive and finite");
    requirePositive(height, "Thermal::Thermal", "the top must be positive and finite");
}

void Thermal::setFoot(const Vector3 &worldPoint) {
    requireFinite(worldPoint, "Thermal::setFoot", "the foot must be finite");
    foot = worldPoint;
}

Vector3 Thermal::getVelocity(const Vector3 &point) const {
    const real x = point.x - foot.x, z = point.z - foot.z;
    const real q = (x * x + z * z) / (radius * radius);
    const real height = (point.y - foot.y) / top;
    if (!(height < 1 && q < 36)) return Vector3();

    const real level = height > 0 ? height : 0;
    const real peak = strength * real_exp(-q) * (27.0 / 4);
    const real rise = peak * level * (1 - level) * (1 - level) * (1 - q);
    const real inflow = peak * (1 - level) * (1 - 3 * level) / (2 * top);
    return Vector3(-inflow * x, rise, -inflow * z);
}

void WindSum::add(const WindField *field) {
    fields.push_back(requireNonNull(field, "WindSum::add", "the field must not be null"));
}

Vector3 WindSum::getVelocity(const Vector3 &worldPoint) const {
    Vector3 sum;
    for (const WindField *field : fields) sum += field->getVelocity(worldPoint);
    return sum;
}

}  // namespace cyclone
