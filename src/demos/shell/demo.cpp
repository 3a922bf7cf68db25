#include "shell/demo.h"

namespace demo {

void Demonstration::begin(std::uint64_t seed, const std::vector<real> &settings) {
    steps = 0;
    events.clear();
    prepare(seed, settings);
    startOver();
}

void Demonstration::begin(std::uint64_t seed) {
    std::vector<real> defaults;
    for (const Setting &setting : profile.settings) defaults.push_back(setting.value);
    begin(seed, defaults);
}

void Demonstration::startOver() {
    controls.clear();
    for (const Control &control : profile.controls) controls.push_back(control.neutral);
    wreck.clear();
    launch();
    markCut();
}

void Demonstration::wreckBy(const std::string &cause) {
    wreck = cause;
    wreckedAt = steps;
    tell(cause);
}

void Demonstration::step() {
    isCut = false;
    if (!wreck.empty() && getTimeSinceWreck() >= profile.wreckMotion) {
        ++steps;
        return;
    }
    beforeStep();
    world.startFrame();
    world.runPhysics(profile.step);
    ++steps;
    afterStep();
}

Frame Demonstration::getFrame() const {
    Frame frame;
    frame.time = getTime();
    frame.poses = getPoses();
    frame.arrows = getArrows();
    frame.windspeed = getWindspeed();
    frame.cut = isCut;
    return frame;
}

std::vector<real> Demonstration::getValues() const {
    std::vector<real> values;
    for (const Quantity &quantity : profile.quantities) values.push_back(quantity.get());
    return values;
}

void Demonstration::setControl(std::size_t index, real value) {
    cyclone::detail::require(value == value, "Demonstration::setControl", "the value must be a number",
                             {value});
    const Control &control = profile.controls.at(index);
    controls.at(index) = cyclone::real_clamp(value, control.low, control.high);
}

void Demonstration::centreControls() {
    for (std::size_t n = 0; n < controls.size(); ++n) {
        const Control &control = profile.controls[n];
        if (control.centres) controls[n] = control.neutral;
    }
}

void Demonstration::releaseSticks(real share) {
    for (std::size_t n = 0; n < controls.size(); ++n) {
        const Control &control = profile.controls[n];
        if (!control.springs) continue;
        const real way = share * (control.high - control.low);
        controls[n] += cyclone::real_clamp(control.neutral - controls[n], -way, way);
    }
}

}  // namespace demo
