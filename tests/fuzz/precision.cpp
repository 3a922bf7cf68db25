/// The elementary functions against the C library's in long double: the error in units of the last place, and
/// special values.
#include <cyclone/precision.h>

#include <cmath>
#include <limits>

#include "input.h"

using namespace cyclone;
using namespace cyclone_fuzz;

namespace {

constexpr real WORST = 1;  // unit in the last place

bool isNan(long double x) { return x != x; }

/// The distance from the value's magnitude to the next greater double's.
long double unitInLastPlace(long double value) {
    int exponent;
    std::frexp(value, &exponent);
    return std::ldexp(1.0L, std::max(exponent - 53, -1074));
}

void check(const char *function, real got, long double want) {
    if (isNan(want)) return expect(isNan(got), function);
    // Where rounding to double would overflow, infinity is right.
    if (std::fabs(want) > std::numeric_limits<real>::max())
        return expect(std::fabs(got) >= std::numeric_limits<real>::max() && (got > 0) == (want > 0),
                      function);
    if (want == 0) return expect(got == 0 && std::signbit(got) == std::signbit(want), function);
    expect(std::fabs(got - want) <= WORST * unitInLastPlace(want), function);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count) {
    Input input(bytes, count);
    const real x = input.number(), y = input.number();
    const long double a = x, b = y;
    check("real_exp", real_exp(x), std::exp(a));
    check("real_log", real_log(x), std::log(a));
    check("real_pow", real_pow(x, y), std::pow(a, b));
    check("real_sin", real_sin(x), std::sin(a));
    check("real_cos", real_cos(x), std::cos(a));
    check("real_atan2", real_atan2(x, y), std::atan2(a, b));
    check("real_asin", real_asin(x), std::asin(a));
    check("real_sqrt", real_sqrt(x), std::sqrt(a));
    expect(real_isfinite(x) == static_cast<bool>(std::isfinite(x)), "real_isfinite");
    return 0;
}
