#include "flightsim/pilot.h"

#include <algorithm>

#include "base/angle.h"

namespace flightsim {

using cyclone::real_clamp;
using cyclone::REAL_PI;

namespace {

constexpr real DEGREE = REAL_PI / 180;
constexpr real CIRCUIT_HEIGHT = 15;      // m
constexpr real DOWNWIND_Z = -50;         // m
constexpr real BASE_X = -55, AIM_X = 8;  // m
constexpr real LAST_TOUCH_DOWN_X = 70;   // m
constexpr real GLIDE_SLOPE = 0.125;
constexpr real FLARE_HEIGHT = 1.2;   // m
constexpr real MAX_AIRSPEED = 10.5;  // m/s
constexpr real MAX_BANK = 32 * DEGREE;
// In a wind of less than CALM he takes off without a watch. TOO_MUCH is the strongest wind and the root mean
// square of the gusts together.
constexpr real WATCH = 12;                  // s
constexpr real CALM = 2.5, TOO_MUCH = 6.5;  // m/s

real heightOf(const Aircraft &aircraft) {
    return aircraft.getBody().getPosition().y - Aircraft::WHEEL_HEIGHT;
}

/// The faster it flies, the less stick it takes.
real stickScale(const Aircraft &aircraft) {
    const real speed = aircraft.getAirspeed();
    return speed > Aircraft::LEVEL_SPEED ? Aircraft::LEVEL_SPEED / speed : 1;
}

real groundSpeed(const Aircraft &aircraft) { return horizontalLength(aircraft.getBody().getVelocity()); }

/// rad: from how far to the side the air may come on the ground before it tips the aircraft over. The
/// surfaces' force to the side grows with the square of the airspeed; against it stands the weight that is
/// left on the wheels, as the lift is 2.4·airspeed. The factor is by trial.
real maxSlip(real airspeed) {
    const real load = Aircraft::MASS * 9.81 - 2.4 * airspeed;
    return real_clamp(1.5 * load / (airspeed * airspeed + 0.01), 0, 2);
}

}  // namespace

std::string Pilot::getName(Leg leg) {
    switch (leg) {
        case Leg::WATCH:
            return "watching the windsock";
        case Leg::TAKE_OFF:
            return "take-off";
        case Leg::CLIMB:
            return "climb";
        case Leg::CROSSWIND:
            return "crosswind leg";
        case Leg::DOWNWIND:
            return "downwind leg";
        case Leg::BASE:
            return "base leg";
        case Leg::FINAL:
            return "final approach";
        case Leg::FLARE:
            return "flare";
        case Leg::ROLL_OUT:
            return "roll-out";
        case Leg::STOPPED:
            return "stopped";
        case Leg::STAY_DOWN:
            return "stays down";
    }
    return "";
}

void Pilot::chooseLeg(const Aircraft &aircraft) {
    const Vector3 position = aircraft.getBody().getPosition();
    const real height = heightOf(aircraft);
    switch (leg) {
        case Leg::WATCH:
            if (watched > 0 && strongest < CALM) leg = Leg::TAKE_OFF;
            if (watched >= WATCH) leg = Leg::TAKE_OFF;
            if (strongest + getGusts() > TOO_MUCH) leg = Leg::STAY_DOWN;
            break;
        case Leg::TAKE_OFF:
            if (!aircraft.isOnGround() && height > 0.5) leg = Leg::CLIMB;
            break;
        case Leg::CLIMB:
            if (height > 0.6 * CIRCUIT_HEIGHT) leg = Leg::CROSSWIND;
            break;
        case Leg::CROSSWIND:
            if (position.z < DOWNWIND_Z + 12) leg = Leg::DOWNWIND;
            break;
        case Leg::DOWNWIND:
            if (position.x < BASE_X + 6) leg = Leg::BASE;
            break;
        case Leg::BASE:
            if (position.z > -14) leg = Leg::FINAL;
            break;
        case Leg::FINAL:
            if (height < FLARE_HEIGHT) leg = Leg::FLARE;
            if (position.x > LAST_TOUCH_DOWN_X) leg = Leg::CLIMB;  // once more
            break;
        case Leg::FLARE:
            if (position.x > LAST_TOUCH_DOWN_X) leg = Leg::CLIMB;
            if (aircraft.isOnGround()) leg = Leg::ROLL_OUT;
            break;
        case Leg::ROLL_OUT:
            if (groundSpeed(aircraft) < 0.1) leg = Leg::STOPPED;
            break;
        case Leg::STOPPED:
        case Leg::STAY_DOWN:
            break;
    }
}

/// m/s: what the leg asks for.
real Pilot::chooseClimb(const Aircraft &aircraft) const {
    const Vector3 position = aircraft.getBody().getPosition();
    const real height = heightOf(aircraft);
    switch (leg) {
        case Leg::TAKE_OFF:
        case Leg::CLIMB:
        case Leg::CROSSWIND:
        case Leg::DOWNWIND:
            return real_clamp(0.4 * (CIRCUIT_HEIGHT - height), -1.5, 1.8);
        case Leg::BASE:
        case Leg::FINAL: {
            const real toGo = AIM_X - position.x + (leg == Leg::BASE ? -position.z : 0);
            const real slope = GLIDE_SLOPE * toGo;
            const real steepest = real_clamp(-0.4 - 0.2 * height, -2, 0);  // lest a gust press it down
            return real_clamp(0.5 * (slope - height) - GLIDE_SLOPE * groundSpeed(aircraft), steepest, 0.5);
        }
        case Leg::FLARE:
            return -0.15 - 0.5 * height;
        case Leg::WATCH:
        case Leg::ROLL_OUT:
        case Leg::STOPPED:
        case Leg::STAY_DOWN:
            break;
    }
    return 0;
}

/// Nose wheel and rudder keep it on the line z = 0, as far as the wind from the side allows; when it tips, it
/// turns to that side, as a bicycle does. Wings with little lift keep it on its wheels.
void Pilot::steerOnGround(const Aircraft &aircraft) {
    const RigidBody &body = aircraft.getBody();
    const real wanted = real_clamp(-0.15 * body.getPosition().z, -0.3, 0.3);
    const Vector3 air = body.getDirectionInLocalSpace(aircraft.getVelocityThroughAir());
    const real slip = cyclone::real_atan2(air.z, real_clamp(air.x, 0.1, 100));
    const real most = maxSlip(cyclone::real_sqrt(air.x * air.x + air.z * air.z));
    const real error = real_clamp(wrapAngle(wanted - aircraft.getHeading()), slip - most, slip + most);
    const real rudder = 1.2 * error + 0.3 * body.getRotation().y + 8 * aircraft.getRoll();
    sticks.rudder = real_clamp(rudder, -1, 1);
    sticks.roll = real_clamp(-6 * aircraft.getRoll(), -1, 1);
}

/// The wings' little lift brakes it, but not so little that the nose goes down and the tail comes up. A touch
/// of throttle when the wind pushes it back.
void Pilot::stop(const Aircraft &aircraft) {
    const RigidBody &body = aircraft.getBody();
    steerOnGround(aircraft);
    sticks.pitch = real_clamp(-1 - 20 * (aircraft.getPitch() + 0.03), -1, 0.5);
    sticks.throttle = real_clamp(-0.3 * body.getDirectionInLocalSpace(body.getVelocity()).x, 0, 0.4);
}

/// What the windsock tells while the aircraft stands.
void Pilot::watchTheWind(const Aircraft &aircraft, real duration) {
    const Vector3 air = aircraft.getVelocityThroughAir();
    watched += duration;
    windSum += air * duration;
    windSquare += air.squareMagnitude() * duration;
    strongest = std::max(strongest, air.magnitude());
}

real Pilot::getGusts() const {
    return watched > 0 ? cyclone::real_sqrt(std::max(
                             0.0, windSquare / watched - (windSum * (1 / watched)).squareMagnitude()))
                       : 0;
}

/// Banks until the track over the ground has the given course and the distance to starboard of it is gone.
void Pilot::follow(const Aircraft &aircraft, real course, real offTrack) {
    const RigidBody &body = aircraft.getBody();
    const real track = bearing(body.getVelocity());
    const real wanted = course - real_clamp(0.03 * offTrack, -0.6, 0.6);
    const real maxBank = real_clamp(0.1 * heightOf(aircraft), 0, MAX_BANK);  // it lands wings level
    const real bank = real_clamp(0.9 * wrapAngle(wanted - track), -maxBank, maxBank);
    const real rollRate = body.getDirectionInLocalSpace(body.getRotation()).x;
    const real stick = 0.17 * bank + 1.2 * (bank - aircraft.getRoll()) - 0.12 * rollRate;
    sticks.roll = real_clamp(stick, -0.8, 0.8) * stickScale(aircraft);
    sticks.rudder = 0;
}

/// Attitude makes the path, as the angle of attack hardly changes; power keeps the speed.
void Pilot::holdClimb(const Aircraft &aircraft, real climb, real duration) {
    const RigidBody &body = aircraft.getBody();
    const real bank = aircraft.getRoll(), airspeed = aircraft.getAirspeed();
    const real pitchRate = body.getDirectionInLocalSpace(body.getRotation()).z;

    const real pitch = (climb + 1.0 * (climb - body.getVelocity().y)) / Aircraft::LEVEL_SPEED;
    // Not far down: pushed, the chapter's wings pull the aircraft forward. Too fast, it is braked by pulling.
    const real tooFast = real_clamp(airspeed - MAX_AIRSPEED, 0, 5);
    const real stick = 2 * (pitch - aircraft.getPitch()) - 0.4 * pitchRate + 0.4 * bank * bank;
    sticks.pitch = real_clamp(real_clamp(stick, -0.35, 1) + 0.15 * tooFast, -0.35, 1) * stickScale(aircraft);

    // Lift grows with speed, so power helps at once against a gust that makes it sink.
    const real sinking = climb - body.getVelocity().y;
    const real reserve = leg == Leg::FINAL || leg == Leg::FLARE ? 0.2 * getGusts() : 0;
    const real tooSlow = Aircraft::LEVEL_SPEED * (1 + 0.25 * bank * bank) + reserve - airspeed;
    throttleTrim = real_clamp(throttleTrim + 0.03 * tooSlow * duration, -0.3, 0.3);
    sticks.throttle = real_clamp(Aircraft::LEVEL_THROTTLE + throttleTrim + 0.17 * climb + 0.5 * tooSlow +
                                     0.8 * real_clamp(sinking, 0, 3),
                                 0, 1);
}

FlightControls Pilot::fly(const Aircraft &aircraft, real duration) {
    chooseLeg(aircraft);
    const Vector3 position = aircraft.getBody().getPosition();
    switch (leg) {
        case Leg::TAKE_OFF:
            steerOnGround(aircraft);
            sticks.throttle = 1;
            sticks.pitch = aircraft.getAirspeed() > 9 ? 0.3 : -0.5;
            return sticks;
        case Leg::WATCH:
            watchTheWind(aircraft, duration);
            stop(aircraft);
            return sticks;
        case Leg::ROLL_OUT:
        case Leg::STOPPED:
        case Leg::STAY_DOWN:
            stop(aircraft);
            return sticks;
        case Leg::CROSSWIND:
            follow(aircraft, -REAL_PI / 2, 0);
            break;
        case Leg::DOWNWIND:
            follow(aircraft, REAL_PI, DOWNWIND_Z - position.z);
            break;
        case Leg::BASE:
            follow(aircraft, REAL_PI / 2, 0);
            break;
        case Leg::CLIMB:
        case Leg::FINAL:
        case Leg::FLARE:
            follow(aircraft, 0, position.z);
            break;
    }
    holdClimb(aircraft, chooseClimb(aircraft), duration);
    return sticks;
}

}  // namespace flightsim
