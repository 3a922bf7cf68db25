#include "flightsim/landing.h"

#include <cmath>

#include "base/angle.h"
#include "base/text.h"
#include "models/attitude.h"

namespace flightsim {

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

Verdict judge(const Landing &landing, const Landing &worst) {
    return Verdict({{landing.sinkRate / worst.sinkRate, "hard"},
                    {std::fabs(landing.beyondAim) / worst.beyondAim, "far from the aim"},
                    {landing.offLine / worst.offLine, "off the middle line"},
                    {landing.bank / worst.bank, "one wing low"},
                    {landing.drift / worst.drift, "drifting"}});
}

std::string describe(const Landing &landing, const Landing &worst) {
    constexpr real DEGREE = cyclone::REAL_PI / 180;
    return fixed(landing.sinkRate, 1) + " m/s, " + fixed(std::fabs(landing.beyondAim), 0) + " m " +
           (landing.beyondAim < 0 ? "short of" : "beyond") + " the aim, bank " +
           fixed(landing.bank / DEGREE, 0) + "°: " + judge(landing, worst).getText();
}

}  // namespace flightsim
