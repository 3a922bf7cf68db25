#include <cyclone/check.h>
#include <cyclone/fixedstep.h>

#include <algorithm>
#include <cmath>

#include "arguments.h"

namespace cyclone {

using namespace detail;

FixedStep::FixedStep(real length, real maxTime) : step(length), maxElapsed(maxTime) {
    requirePositive(length, "FixedStep::FixedStep", "the step must be positive and finite");
    require(maxTime >= length && maxTime / length <= 1e6, "FixedStep::FixedStep",
            "the longest time must be between one step and a million", {maxTime});
}

unsigned FixedStep::advance(real elapsed) {
    requireNotNegative(elapsed, "FixedStep::advance", "the elapsed time must be finite and not negative");
    const real slack = SLACK * step, owed = std::min(remainder + elapsed, maxElapsed);
    const real whole = std::floor(elapsed / step + 0.5), left = owed - whole * step;
    const bool isNearWhole = whole >= 1 && real_abs(elapsed - whole * step) <= slack;
    if (isNearWhole && left >= -slack && left < step + slack) {
        remainder = left;
        return static_cast<unsigned>(whole);
    }
    if (owed < 0) {
        remainder = owed;
        return 0;
    }
    remainder = std::fmod(owed, step);  // exact, so no time is lost or gained here
    return static_cast<unsigned>((owed - remainder) / step + 0.5);
}

real FixedStep::getFraction() const { return real_clamp(remainder / step, 0, 1 - REAL_EPSILON); }

}  // namespace cyclone
