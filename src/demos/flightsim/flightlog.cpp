#include "flightsim/flightlog.h"

#include <algorithm>

#include "base/text.h"
#include "models/hull.h"

namespace flightsim {

void FlightLog::noteBeforeStep(const RigidBody &body) {
    lastPosition = body.getPosition();
    lastVelocity = body.getVelocity();
}

std::optional<FlightLog::News> FlightLog::watchAfterStep(const RigidBody &body, bool isTouching,
                                                         const std::string &brokenPart) {
    distance += (body.getPosition() - lastPosition).magnitude();
    highest = std::max(highest, getHeight(body));
    const std::optional<News> news = findNews(body, isTouching, brokenPart);
    if (news && news->isCrash) ++crashes;
    return news;
}

std::optional<FlightLog::News> FlightLog::findNews(const RigidBody &body, bool isTouching,
                                                   const std::string &brokenPart) {
    const real sinkRate = -lastVelocity.y;
    if (body.hasFaulted() || !brokenPart.empty())
        return News{describeCrash(brokenPart, body, lastVelocity), true};
    if (isTouching && sinkRate > rules.hardestTouchDown)
        return News{"crashed: touched down at " + fixed(sinkRate, 1) + " m/s", true};
    if (!airborne && !isTouching && getHeight(body) > rules.clearance) {
        airborne = true;
        return News{"took off"};
    }
    if (!airborne || !isTouching) return std::nullopt;
    airborne = false;
    const Landing landing = measureLanding(body, lastVelocity, rules.runway);
    const std::string how = describe(landing, rules.worstLanding);
    landings.add(how, judge(landing, rules.worstLanding));
    return News{"touched down at " + how};
}

std::string FlightLog::getSummary() const {
    return landings.getSummary() + "\nCrashes: " + std::to_string(crashes);
}

}  // namespace flightsim
