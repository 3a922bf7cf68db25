#pragma once

/// Numbers as people read them, the same in every locale.
#include <cyclone/core.h>

#include <optional>
#include <string>

namespace demo {

using cyclone::real;

/// Rounded to so many decimals; what shows as zero has no sign.
std::string fixed(real value, int decimals);
/// With its sign in front, a plus too.
std::string signedFixed(real value, int decimals);

/// Rounded to so many digits, with an exponent where it is very large or very small.
std::string significant(real value, int digits);
/// In as few digits as give the same number back.
std::string shortest(real value);
/// The number that the whole text is, such as "-2.5" or "1e-3"; nothing if it is none or not finite.
std::optional<real> readNumber(const std::string &text);

/// A compass direction, rad, in degrees: 0 … 360.
real compassDegrees(real angle);
/// In three digits, "000" to "359".
std::string compassText(real angle);

/// An angle off the bow, rad, in degrees with its side: "12P", "12S"; what shows as nought has no side.
std::string sided(real angle);

/// "1 tack", "2 tacks".
std::string counted(unsigned long long number, const std::string &what);

}  // namespace demo
