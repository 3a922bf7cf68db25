#include "flightsim/landing.h"

#include "base/angle.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flightsim {

namespace {

constexpr real DEGREE = cyclone::REAL_PI / 180;
constexpr real GOOD = 0.6, EXCELLENT = 0.3;  // of the most that is fair

struct Fault {
    real share;  ///< of the most that is fair
    const char *name;
};

Fault findWorstFault(const Landing &landing, const Landing &worst) {
    const std::array<Fault, 5> faults = {
        {{landing.sinkRate / worst.sinkRate, "hard"},
         {std::fabs(landing.beyondAim) / worst.beyondAim, "far from the aim"},
         {landing.offLine / worst.offLine, "off the middle line"},
         {landing.bank / worst.bank, "one wing low"},
         {landing.drift / worst.drift, "drifting"}}};
    return *std::max_element(faults.begin(), faults.end(),
                             [](const Fault &a, const Fault &b) { return a.share < b.share; });
}

}  // namespace

Landing measureLanding(const RigidBody &body, const Vector3 &velocity, const Runway &runway) {
    const Vector3 position = body.getPosition();
    Landing landing;
    landing.sinkRate = -velocity.y;
    landing.beyondAim = velocity.x < 0 ? runway.oppositeAim - position.x : position.x - runway.aim;
    landing.offLine = std::fabs(position.z);
    landing.bank = std::fabs(bankOf(body));
    landing.drift = std::fabs(wrapAngle(headingOf(body) - bearing(velocity)));
    return landing;
}

std::string getName(Mark mark) {
    switch (mark) {
        case Mark::POOR:
            return "poor";
        case Mark::FAIR:
            return "fair";
        case Mark::GOOD:
            return "good";
        case Mark::EXCELLENT:
            return "excellent";
    }
    return "";
}

Mark judge(const Landing &landing, const Landing &worst) {
    const real share = findWorstFault(landing, worst).share;
    return share > 1           ? Mark::POOR
           : share > GOOD      ? Mark::FAIR
           : share > EXCELLENT ? Mark::GOOD
                               : Mark::EXCELLENT;
}

std::string describe(const Landing &landing, const Landing &worst) {
    const Mark mark = judge(landing, worst);
    return fixed(landing.sinkRate, 1) + " m/s, " + fixed(std::fabs(landing.beyondAim), 0) + " m " +
           (landing.beyondAim < 0 ? "short of" : "beyond") + " the aim, bank " +
           fixed(landing.bank / DEGREE, 0) + "°: " + getName(mark) +
           (mark < Mark::GOOD ? std::string(", ") + findWorstFault(landing, worst).name : "");
}

void LandingLog::add(const Landing &landing) {
    if (count == 0 || findWorstFault(landing, worst).share < findWorstFault(best, worst).share)
        best = landing;
    ++count;
}

std::string LandingLog::getSummary() const {
    return "Landings: " + std::to_string(count) +
           (count == 0 ? "" : (count == 1 ? ", at " : ", the best at ") + describe(best, worst));
}

std::string findBrokenPart(const RigidBody &body, const std::vector<HullPoint> &hull) {
    for (const HullPoint &part : hull)
        if (body.getPointInWorldSpace(part.point).y < 0) return part.name;
    return "";
}

std::string describeCrash(const std::string &part, const RigidBody &body, const Vector3 &velocity) {
    if (part.empty()) return "crashed: broke up in the air";
    const real pitch = pitchOf(body) / DEGREE;
    return "crashed: " + part + " hit the ground at " + fixed(velocity.magnitude(), 0) + " m/s, bank " +
           fixed(std::fabs(bankOf(body)) / DEGREE, 0) + "°, nose " + fixed(std::fabs(pitch), 0) + "° " +
           (pitch < 0 ? "down" : "up");
}

}  // namespace flightsim
