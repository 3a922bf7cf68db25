#include "sailboat/helmsman.h"

#include <algorithm>

namespace sailboat {

namespace {

using cyclone::real_abs;
using cyclone::real_clamp;

constexpr real RUDDER_RATE = 1.2, SAIL_RATE = 1;               // rad/s
constexpr real RUDDER_PER_ERROR = 1.8, RUDDER_PER_TURN = 1.2;  // 1, s
constexpr real EASE_FROM = 0.14, EASE_TO = 0.3;                // heel at which the sail is eased, rad
constexpr real NO_GO = 0.45;                                   // off the wind, rad: closer, no sail fills
constexpr real ASTERN = 0.3;                  // the wind is astern if it is within this of it, rad
constexpr real MOST_RUDDER = 0.4;             // beyond, it brakes more than it turns; rad
constexpr real NO_WAY = 0.8, WAY = 1.2;       // m/s: slower, she is in irons; faster, she sails again
constexpr real FALL_OFF = 1.2, BACKED = 1.2;  // in irons: course off the wind, and the sail; rad
constexpr real FILLS = 0.85;                  // in irons: off the wind, rad; closer, the sail is held out

real approach(real now, real target, real mostChange) {
    return now + real_clamp(target - now, -mostChange, mostChange);
}

/// 0 up to `low`, 1 from `high` on.
real ramp(real x, real low, real high) { return real_clamp((x - low) / (high - low), 0, 1); }

/// Best trim, but spilling wind when the boat heels or digs in its bows, and letting the sail shake in the
/// wind's eye.
real trim(const Catamaran &boat) {
    const real wind = boat.getApparentWindAngle();
    const real heelToLeeward = wind > 0 ? -boat.getHeel() : boat.getHeel();
    const real spilled = ramp(std::max(heelToLeeward, -2 * boat.getTrim()), EASE_FROM, EASE_TO);
    const real shaking = 1 - ramp(real_abs(boat.getTrueWindAngle()), NO_GO, NO_GO + 0.15);
    return Helmsman::bestSail(boat) * (1 + std::max(spilled, shaking));
}

}  // namespace

void Helmsman::steerHeading(real heading) {
    course = heading;
    relativeToWind = false;
}

void Helmsman::steerWindAngle(real angle) {
    course = angle;
    relativeToWind = true;
}

real Helmsman::bestSail(const Catamaran &boat) {
    const real best = -boat.getApparentWindAngle() / 2;
    const real otherSide = best > 0 ? best - cyclone::REAL_PI : best + cyclone::REAL_PI;
    const bool eitherWillDo = real_abs(otherSide) < cyclone::REAL_PI / 2 + ASTERN / 2;
    return eitherWillDo && otherSide * boat.getSail() > 0 ? otherSide : best;
}

real Helmsman::wantedWindAngle(const Catamaran &boat) const {
    if (timeInIrons > 0) return fallOffSide * FALL_OFF;
    return relativeToWind ? course : wrapAngle(boat.getTrueWindAngle() + boat.getHeading() - course);
}

void Helmsman::watchForIrons(const Catamaran &boat, real duration) {
    const real offWind = boat.getTrueWindAngle();
    if (timeInIrons == 0) {
        if (boat.getSpeed() > NO_WAY || real_abs(offWind) > NO_GO) return;
        fallOffSide = wantedWindAngle(boat) < 0 ? -1 : 1;
    } else if (boat.getSpeed() > WAY && real_abs(offWind) > NO_GO) {
        timeInIrons = 0;
        backsSail = false;
        return;
    }
    timeInIrons += duration;
    backsSail = fallOffSide * offWind < (backsSail ? FILLS : NO_GO);
}

void Helmsman::steer(Catamaran &boat, real duration) const {
    const real error = wrapAngle(boat.getTrueWindAngle() - wantedWindAngle(boat));
    const real wanted = RUDDER_PER_ERROR * error - RUDDER_PER_TURN * boat.getTurnRate();
    const real sternwards = boat.getSpeed() < 0 ? -1 : 1;  // going astern, the rudder works the other way
    boat.setRudder(approach(boat.getRudder(), sternwards * real_clamp(wanted, -MOST_RUDDER, MOST_RUDDER),
                            RUDDER_RATE * duration));
}

void Helmsman::sail(Catamaran &boat, real duration) {
    watchForIrons(boat, duration);
    steer(boat, duration);
    boat.setSail(
        approach(boat.getSail(), backsSail ? -fallOffSide * BACKED : trim(boat), SAIL_RATE * duration));
}

}  // namespace sailboat
