#include "base/text.h"

#include <cmath>
#include <cstdlib>
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

std::string significant(real value, int digits) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << std::setprecision(digits) << value;
    return out.str();
}

std::string shortest(real value) {
    // As many digits as stand before the point, so that twenty is 20 and not 2e+01.
    const real size = std::fabs(value);
    const int least = size >= 1 && size < 1e15 ? static_cast<int>(std::log10(size)) + 1 : 1;
    for (int digits = least; digits < 17; ++digits) {
        const std::string text = significant(value, digits);
        if (readNumber(text) == value) return text;
    }
    return significant(value, 17);
}

std::optional<real> readNumber(const std::string &text) {
    // strtod alone would also take leading blanks, hexadecimal digits, "inf" and "nan".
    if (text.empty() || text.find_first_not_of("+-.0123456789eE") != std::string::npos) return std::nullopt;
    char *end = nullptr;
    const real value = std::strtod(text.c_str(), &end);
    if (*end != '\0' || !std::isfinite(value)) return std::nullopt;
    return value;
}

real compassDegrees(real angle) {
    const real degrees = std::fmod(angle / DEGREE, 360);
    return degrees < 0 ? degrees + 360 : degrees;
}

std::string compassText(real angle) {
    const std::string digits = std::to_string(std::lround(compassDegrees(angle)) % 360);
    return std::string(3 - digits.size(), '0') + digits;
}

std::string sided(real angle) {
    const std::string shown = fixed(std::fabs(angle) / DEGREE, 0);
    return shown + (shown == "0" ? "" : angle < 0 ? "P" : "S");
}

std::string counted(unsigned long long number, const std::string &what) {
    return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

}  // namespace demo
