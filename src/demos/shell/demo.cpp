#include "shell/demo.h"

namespace demo {

void Demonstration::setControl(std::size_t index, real value) {
    cyclone::detail::require(value == value, "Demonstration::setControl", "the value must be a number",
                             {value});
    const Control &control = getProfile().controls.at(index);
    controls.at(index) = cyclone::real_clamp(value, control.low, control.high);
}

void Demonstration::resetControls() {
    controls.clear();
    for (const Control &control : getProfile().controls) controls.push_back(control.neutral);
}

void Demonstration::centreControls() {
    for (std::size_t n = 0; n < controls.size(); ++n) {
        const Control &control = getProfile().controls[n];
        if (control.centres) controls[n] = control.neutral;
    }
}

}  // namespace demo
