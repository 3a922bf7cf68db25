#include "airrace/marshal.h"

#include "base/text.h"

namespace airrace {

namespace {

constexpr real MISSES_WITHIN = 100;  // m: what passes a hoop farther off was not meant for it

std::string nameOf(std::size_t hoop) { return "hoop " + std::to_string(hoop + 1); }

}  // namespace

Marshal::Marshal(const std::vector<Hoop> &c, real metres) : course(&c), clearance(metres) {}

void Marshal::startOver() {
    next = 0;
    lapStart.reset();
}

bool Marshal::isClean(const Crossing &crossing) const {
    return crossing.way == Crossing::Way::FORWARDS && crossing.offset <= (*course)[next].radius - clearance;
}

std::optional<real> Marshal::watch(const Vector3 &from, const Vector3 &to, real time, real duration) {
    std::optional<real> lap;
    real share = 0;
    bool anyPassed = false;
    // Very fast, one flies through several in a step.
    for (Crossing c = cross((*course)[next], from, to); isClean(c) && c.share >= share;
         c = cross((*course)[next], from, to)) {
        share = c.share;
        anyPassed = true;
        if (const std::optional<real> finished = pass(time - duration + share * duration)) lap = finished;
    }
    if (!anyPassed) judge(from, to);
    return lap;
}

std::optional<real> Marshal::pass(real time) {
    ++passed;
    const bool isStartLine = next == 0;
    next = (next + 1) % course->size();
    if (!isStartLine) return std::nullopt;
    const std::optional<real> lap = lapStart ? std::optional<real>(time - *lapStart) : std::nullopt;
    lapStart = time;
    return lap;
}

/// What was flown through in the wrong way, or past.
void Marshal::judge(const Vector3 &from, const Vector3 &to) {
    for (std::size_t n = 0; n < course->size(); ++n) {
        const Crossing crossing = cross((*course)[n], from, to);
        const bool isInside = crossing.offset <= (*course)[n].radius;
        if (crossing.way == Crossing::Way::NONE || crossing.offset > MISSES_WITHIN) continue;
        if (crossing.way == Crossing::Way::BACKWARDS) {
            if (isInside) reports.push_back("wrong way through " + nameOf(n));
        } else if (n != next) {
            if (isInside) reports.push_back(nameOf(n) + " does not count: fly " + nameOf(next) + " first");
        } else {
            ++missed;
            const real beside = crossing.offset - (*course)[n].radius;
            reports.push_back((beside <= clearance
                                   ? "clipped " + nameOf(n)
                                   : "missed " + nameOf(n) + " by " + demo::fixed(beside, 0) + " m") +
                              ": fly it again");
        }
    }
}

}  // namespace airrace
