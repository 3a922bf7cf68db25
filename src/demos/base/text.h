#pragma once

/// Numbers as people read them, the same in every locale.
#include <cyclone/core.h>

#include <string>

namespace demo {

using cyclone::real;

/// Rounded to so many decimals; what shows as zero has no sign.
std::string fixed(real value, int decimals);
/// With its sign in front, a plus too.
std::string signedFixed(real value, int decimals);

/// A compass direction, rad, in degrees: 0 … 360.
real compassDegrees(real angle);
/// In three digits, "000" to "359".
std::string compassText(real angle);

}  // namespace demo
