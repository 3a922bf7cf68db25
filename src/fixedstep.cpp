#include <cyclone/check.h>
#include <cyclone/fixedstep.h>

namespace cyclone {

FixedStep::FixedStep(real length, real longestTime) : step(length), longest(longestTime) {
    require(length > 0 && length <= REAL_MAX, "FixedStep::FixedStep", "the step must be positive and finite",
            {length});
    require(longestTime >= length && longestTime / length <= 1e6, "FixedStep::FixedStep",
            "the longest time must be between one step and a million", {longestTime});
}

unsigned FixedStep::advance(real elapsed) {
    require(elapsed >= 0 && elapsed <= REAL_MAX, "FixedStep::advance",
            "the elapsed time must be finite and not negative", {elapsed});
    remainder += elapsed;
    if (remainder > longest) remainder = longest;
    const unsigned steps = static_cast<unsigned>(remainder / step);
    remainder = real_clamp(remainder - steps * step, 0, step);
    return steps;
}

}  // namespace cyclone
