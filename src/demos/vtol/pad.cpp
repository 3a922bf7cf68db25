#include "vtol/pad.h"

#include "base/angle.h"
#include "base/text.h"

namespace vtol {

const std::array<Pad, 2> PADS = {
    {{"the home pad", Vector3(0, 0, 0)}, {"the far pad", Vector3(1000, 0, 400)}}};

namespace {

const Landing WORST{0, PAD_RADIUS / 2, 2, 2, 10 * cyclone::REAL_PI / 180};  // that is still fair

}  // namespace

std::size_t findNearestPad(const Vector3 &place) {
    std::size_t nearest = 0;
    for (std::size_t n = 1; n < PADS.size(); ++n)
        if (horizontalLength(place - PADS[n].centre) < horizontalLength(place - PADS[nearest].centre))
            nearest = n;
    return nearest;
}

Landing measureLanding(const cyclone::RigidBody &body, const Vector3 &velocity) {
    const Vector3 place = body.getPosition(), up = body.getTransform().getAxisVector(1);
    Landing landing;
    landing.pad = findNearestPad(place);
    landing.offCentre = horizontalLength(place - PADS[landing.pad].centre);
    landing.sinkRate = -velocity.y;
    landing.drift = horizontalLength(velocity);
    landing.tilt = cyclone::real_atan2(horizontalLength(up), up.y);
    return landing;
}

Verdict judge(const Landing &landing) {
    return Verdict(
        {{landing.sinkRate / WORST.sinkRate, "hard"},
         {landing.offCentre / WORST.offCentre, landing.isOnPad() ? "far from the middle" : "beside the pad"},
         {landing.drift / WORST.drift, "drifting"},
         {landing.tilt / WORST.tilt, "tilted"}});
}

std::string describe(const Landing &landing) {
    return fixed(landing.sinkRate, 1) + " m/s, " + fixed(landing.offCentre, 1) + " m from the middle of " +
           PADS[landing.pad].name + ", drifting at " + fixed(landing.drift, 1) +
           " m/s: " + judge(landing).getText();
}

}  // namespace vtol
