#include "vtol/pilot.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"

namespace vtol {

using cyclone::real_atan2;
using cyclone::real_clamp;
using cyclone::real_sqrt;

namespace {

constexpr real HOVER_HEIGHT = 20, CRUISE_HEIGHT = 80, APPROACH_HEIGHT = 25;  // m
constexpr real HOVER_TIME = 4;                                               // s
constexpr real JET_BORNE = 34, WING_BORNE = 42;      // m/s: between them the wings take over
constexpr real JET_PITCH = 0.07, MOST_PITCH = 0.25;  // rad
constexpr real GATE_SHORT = 1850, GATE_ASIDE = 450, SLOWING_WAY = 1200;  // m
constexpr real CLOSE = 300;                                              // m: from there he hovers to the pad
constexpr real SLOWING = 1.1;                                            // m/s²
constexpr real MOST_BRAKING = 0.3;  // of what pushes upwards: the nozzles don't turn far astern

real groundSpeed(const Jet &jet) { return horizontalLength(jet.getBody().getVelocity()); }

/// Along the heading, and to starboard, of a vector in the world.
Vector3 ahead(const Jet &jet) { return towardsBearing(headingOf(jet.getBody())); }
Vector3 starboard(const Jet &jet) { return ahead(jet) % Vector3::UP; }

/// 0: the jet carries her, 1: the wings do.
real getWingShare(const Jet &jet) {
    return real_clamp((jet.getAirspeed() - JET_BORNE) / (WING_BORNE - JET_BORNE), 0, 1);
}

/// rad: what makes her climb like that when the wings carry her. The angle of attack beyond that of level
/// flight is what the lift lacks at this speed, in this turn.
real pitchForClimb(const Jet &jet, real climb) {
    const real speed = std::max(jet.getAirspeed(), JET_BORNE), ratio = Jet::LEVEL_SPEED / speed;
    const real load = 1 / std::max(cyclone::real_cos(bankOf(jet.getBody())), 0.5);
    const real rise = jet.getBody().getVelocity().y;
    return Jet::INCIDENCE * (ratio * ratio * load - 1) + (climb + (climb - rise)) / speed;
}

}  // namespace

std::string Pilot::getName(Leg leg) {
    switch (leg) {
        case Leg::LIFT_OFF:
            return "lifts off";
        case Leg::HOVER:
            return "hovers, and turns into the wind";
        case Leg::SPEED_UP:
            return "swivels the nozzles aft";
        case Leg::CRUISE:
            return "flies on her wings";
        case Leg::FINAL:
            return "turns towards the pad";
        case Leg::SLOW_DOWN:
            return "swivels the nozzles down";
        case Leg::OVER_THE_PAD:
            return "hovers to the pad";
        case Leg::LAND:
            return "descends";
        case Leg::STOPPED:
            return "stands";
    }
    return "";
}

Pilot::Pilot(std::size_t from, std::size_t to, const Vector3 &windFrom)
    : home(PADS.at(from).centre),
      pad(PADS.at(to).centre),
      upwind(windFrom == Vector3() ? Vector3::X : windFrom.unit()) {
    const Vector3 aside = upwind % Vector3::UP;
    const real side = (home - pad) * aside < 0 ? -1 : 1;
    gate = pad - upwind * GATE_SHORT + aside * (side * GATE_ASIDE);
}

void Pilot::takeOver(const Jet &jet) {
    const bool isNear = horizontalLength(jet.getBody().getPosition() - pad) < CLOSE;
    leg = jet.isOnGround()                 ? Leg::LIFT_OFF
          : jet.getAirspeed() > WING_BORNE ? Leg::CRUISE
          : isNear                         ? Leg::OVER_THE_PAD
                                           : Leg::SPEED_UP;
    waited = 0;
}

real Pilot::getShortOf(const Vector3 &place) const { return (pad - place) * upwind; }
real Pilot::getOffLine(const Vector3 &place) const { return (place - pad) * (upwind % Vector3::UP); }

void Pilot::chooseLeg(const Jet &jet, real duration) {
    const Vector3 place = jet.getBody().getPosition();
    const real off = horizontalLength(place - pad);
    switch (leg) {
        case Leg::LIFT_OFF:
            if (jet.getHeight() > HOVER_HEIGHT - 2) leg = Leg::HOVER;
            break;
        case Leg::HOVER:
            if (std::fabs(wrapAngle(bearing(upwind) - headingOf(jet.getBody()))) < 0.1) waited += duration;
            if (waited > HOVER_TIME) leg = Leg::SPEED_UP;
            break;
        case Leg::SPEED_UP:
            if (jet.getAirspeed() > WING_BORNE + 3 && jet.getHeight() > HOVER_HEIGHT) leg = Leg::CRUISE;
            break;
        case Leg::CRUISE:
            if (horizontalLength(place - gate) < 200) leg = Leg::FINAL;
            break;
        case Leg::FINAL:
            if (getShortOf(place) < SLOWING_WAY) leg = Leg::SLOW_DOWN;
            break;
        case Leg::SLOW_DOWN:
            if (groundSpeed(jet) < 8) leg = Leg::OVER_THE_PAD;
            break;
        case Leg::OVER_THE_PAD:
            if (off < 1.5 && groundSpeed(jet) < 0.7) leg = Leg::LAND;
            break;
        case Leg::LAND:
            if (jet.isOnGround()) leg = Leg::STOPPED;
            break;
        case Leg::STOPPED:
            break;
    }
}

/// In the hover: there, and into the wind.
Pilot::Aim Pilot::aimAtPlace(const Jet &jet, const Vector3 &place, real climb) const {
    const Vector3 way = place - jet.getBody().getPosition(), velocity = jet.getBody().getVelocity();
    const real distance = horizontalLength(way);
    const real speed = std::min({0.3 * distance, real_sqrt(2 * SLOWING * distance), 60.0});
    const Vector3 wanted = way * (distance > 0 ? speed / distance : 0);
    Aim aim;
    aim.climb = climb;
    aim.acceleration = real_clamp(0.6 * ((wanted - velocity) * ahead(jet)), -4, 4);
    aim.bank = real_clamp(0.08 * ((wanted - velocity) * starboard(jet)), -0.35, 0.35);
    aim.heading = bearing(upwind);
    return aim;
}

/// On her wings, on this course over the ground.
Pilot::Aim Pilot::aimAlong(const Jet &jet, real course, real climb) const {
    Aim aim;
    aim.climb = climb;
    aim.acceleration = real_clamp(0.5 * (Jet::LEVEL_SPEED - jet.getAirspeed()), -3, 5);
    const real turn = wrapAngle(course - bearing(jet.getBody().getVelocity()));
    aim.bank = real_clamp(1.2 * turn, -0.6, 0.6) * getWingShare(jet);
    aim.heading = bearing(upwind);
    return aim;
}

/// Slower and slower along the line that ends at the pad.
Pilot::Aim Pilot::aimAtLine(const Jet &jet) const {
    const Vector3 place = jet.getBody().getPosition(), velocity = jet.getBody().getVelocity();
    const real toGo = std::max(getShortOf(place), 0.0), off = getOffLine(place);
    const real speed = std::min({real_sqrt(2 * SLOWING * toGo), 0.3 * toGo + 1, Jet::LEVEL_SPEED});
    const real side = real_clamp(-0.15 * off, -8, 8);
    Aim aim;
    aim.climb = real_clamp(0.3 * (APPROACH_HEIGHT - jet.getHeight()), -3, 2);
    aim.acceleration = real_clamp(0.6 * (speed - velocity * upwind), -4, 2);
    aim.bank = real_clamp(0.08 * (side - velocity * (upwind % Vector3::UP)), -0.35, 0.35);
    aim.heading = bearing(upwind);
    return aim;
}

Pilot::Aim Pilot::aim(const Jet &jet) const {
    const Vector3 place = jet.getBody().getPosition();
    const real height = jet.getHeight();
    const auto climbTo = [&](real wanted) { return real_clamp(0.4 * (wanted - height), -3, 3); };
    switch (leg) {
        case Leg::LIFT_OFF:
        case Leg::HOVER:
            return aimAtPlace(jet, home, climbTo(HOVER_HEIGHT));
        case Leg::SPEED_UP:
            return aimAlong(jet, bearing(upwind), climbTo(CRUISE_HEIGHT));
        case Leg::CRUISE:
            return aimAlong(jet, bearing(gate - place), climbTo(CRUISE_HEIGHT));
        case Leg::FINAL: {
            const real across = real_clamp(0.004 * getOffLine(place), -1, 1);
            return aimAlong(jet, bearing(upwind) - across, climbTo(CRUISE_HEIGHT));
        }
        case Leg::SLOW_DOWN:
            return aimAtLine(jet);
        case Leg::OVER_THE_PAD:
            return aimAtPlace(jet, pad, climbTo(APPROACH_HEIGHT));
        case Leg::LAND:
        case Leg::STOPPED:
            break;
    }
    return aimAtPlace(jet, pad, -real_clamp(0.3 * height, 0.5, 2.5));
}

/// The push that moves her so, and the sticks.
JetControls Pilot::moveTo(const Jet &jet, const Aim &aim) const {
    const RigidBody &body = jet.getBody();
    const real wings = getWingShare(jet), rise = body.getVelocity().y;
    const Vector3 air = jet.getAirForce();
    const real up = (1 - wings) * std::max(Jet::WEIGHT + Jet::MASS * 0.8 * (aim.climb - rise) - air.y, 0.0);
    const real forward = std::max(Jet::MASS * aim.acceleration - air * ahead(jet), -MOST_BRAKING * up);
    const real nozzles = real_clamp(real_atan2(up, forward) - pitchOf(body), 0, Jet::MOST_NOZZLES);

    const Stabiliser::Correction own = Stabiliser::getCorrection(jet);
    const real pitch = JET_PITCH * real_clamp(jet.getAirspeed() / 15 - 0.5, 0, 1) * (1 - wings) +
                       wings * real_clamp(pitchForClimb(jet, aim.climb), -MOST_PITCH, MOST_PITCH);
    const real turn = wrapAngle(aim.heading - headingOf(body));
    JetControls controls;
    controls.pitch = (pitch - own.pitch) / Stabiliser::MOST_PITCH;
    controls.roll = (aim.bank - own.bank) / Stabiliser::MOST_BANK;
    controls.pedal = real_clamp(turn, -0.5, 0.5) * (1 - wings) / Stabiliser::MOST_TURN;
    controls.nozzles = up + forward > 0 ? nozzles : jet.getNozzles();
    controls.throttle = real_sqrt(up * up + forward * forward) / Jet::MAX_THRUST - own.throttle;
    return controls;
}

JetControls Pilot::fly(const Jet &jet, real duration) {
    chooseLeg(jet, duration);
    if (leg != Leg::STOPPED) return moveTo(jet, aim(jet));
    JetControls off;
    off.nozzles = cyclone::REAL_PI / 2;
    return off;
}

}  // namespace vtol
