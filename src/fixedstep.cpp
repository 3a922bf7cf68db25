#include <cyclone/check.h>
#include <cyclone/fixedstep.h>

#include <algorithm>
#include <cmath>

#include "arguments.h"

namespace cyclone {

using namespace detail;

FixedStep::FixedStep(real length, real longestTime) : step(length), longest(longestTime) {
    requirePositive(length, "FixedStep::FixedStep", "the step must be positive and finite");
    require(longestTime >= length && longestTime / length <= 1e6, "FixedStep::FixedStep",
            "the longest time must be between one step and a million", {longestTime});
}

unsigned FixedStep::advance(real elapsed) {
    requireNotNegative(elapsed, "FixedStep::advance", "the elapsed time must be finite and not negative");
    const real owed = std::min(remainder + elapsed, longest);
    remainder = std::fmod(owed, step);  // exact, so no time is lost or gained here
    return static_cast<unsigned>((owed - remainder) / step + 0.5);
}

}  // namespace cyclone
