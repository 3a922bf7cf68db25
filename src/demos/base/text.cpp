#include "base/text.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace demo {

namespace {

constexpr real DEGREE = cyclone::REAL_PI / 180;

}  // namespace

std::string fixed(real value, int decimals) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << std::fixed << std::setprecision(decimals) << value;
    const std::string text = out.str();
    const bool isZero = text.find_first_of("123456789") == std::string::npos;
    return isZero && text[0] == '-' ? text.substr(1) : text;
}

std::string signedFixed(real value, int decimals) {
    const std::string text = fixed(value, decimals);
    return text[0] == '-' ? text : '+' + text;
}

real compassDegrees(real angle) {
    const real degrees = std::fmod(angle / DEGREE, 360);
    return degrees < 0 ? degrees + 360 : degrees;
}

std::string compassText(real angle) {
    const std::string digits = std::to_string(std::lround(compassDegrees(angle)) % 360);
    return std::string(3 - digits.size(), '0') + digits;
}

}  // namespace demo
