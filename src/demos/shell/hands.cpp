#include "shell/hands.h"

#include <algorithm>

namespace demo {

namespace {

constexpr real GRIP_TIME = 0.5;    // s; a key held down repeats after less
constexpr real RETURN_TIME = 0.7;  // s, from one end of the range to the other

}  // namespace

bool Hands::knows(Key key) const {
    const Profile &profile = demonstration.getProfile();
    return key == profile.centre ||
           std::any_of(profile.controls.begin(), profile.controls.end(),
                       [&](const Control &control) { return key == control.less || key == control.more; });
}

void Hands::stroke(Key key) {
    const Profile &profile = demonstration.getProfile();
    sinceStroke = 0;
    if (key == profile.centre) return demonstration.centreControls();
    for (std::size_t n = 0; n < profile.controls.size(); ++n) {
        const Control &control = profile.controls[n];
        if (key != control.less && key != control.more) continue;
        demonstration.setControl(
            n, demonstration.getControl(n) + (key == control.more ? control.stroke : -control.stroke));
    }
}

void Hands::advance(real duration) {
    sinceStroke += duration;
    if (springBack && sinceStroke > GRIP_TIME) demonstration.releaseSticks(duration / RETURN_TIME);
}

}  // namespace demo
