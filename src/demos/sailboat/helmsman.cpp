#include "sailboat/helmsman.h"

#include <algorithm>

namespace sailboat {

namespace {

using cyclone::real_abs;
using cyclone::real_clamp;

constexpr real RUDDER_RATE = 1.2, SHEET_RATE = 1;              // rad/s
constexpr real RUDDER_PER_ERROR = 1.8, RUDDER_PER_TURN = 1.2;  // 1, s
constexpr real EASE_FROM = 0.14, EASE_TO = 0.3;                // heel at which the sail is eased, rad
constexpr real NO_GO = 0.45;                                   // off the wind, rad: closer, no sail fills
constexpr real MOST_RUDDER = 0.4;                              // beyond, it brakes more than it turns; rad
constexpr real NO_WAY = 0.8, WAY = 1.2;  // m/s: slower, she is in irons; faster, she sails again
constexpr real FALL_OFF = 1.35;          // in irons: course off the wind, rad
constexpr real FILLS = 0.9;              // in irons: off the wind, rad; closer, the sail is held out

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
    return Helmsman::bestSheet(boat) * (1 + std::max(spilled, shaking));
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

real Helmsman::bestSheet(const Catamaran &boat) { return real_abs(boat.getApparentWindAngle()) / 2; }

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
    const real most = timeInIrons > 0 && sternwards < 0 ? Catamaran::MAX_RUDDER : MOST_RUDDER;
    boat.setRudder(
        approach(boat.getRudder(), sternwards * real_clamp(wanted, -most, most), RUDDER_RATE * duration));
}

void Helmsman::sail(Catamaran &boat, real duration) {
    watchForIrons(boat, duration);
    steer(boat, duration);
    boat.setSheet(approach(boat.getSheet(), trim(boat), SHEET_RATE * duration));
    boat.holdBoom(backsSail ? -fallOffSide : 0);
}

}  // namespace sailboat
