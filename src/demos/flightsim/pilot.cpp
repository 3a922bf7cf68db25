#include "flightsim/pilot.h"

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

real wrapped(real angle) {
    while (angle > REAL_PI) angle -= 2 * REAL_PI;
    while (angle < -REAL_PI) angle += 2 * REAL_PI;
    return angle;
}

real heightOf(const Aircraft &aircraft) {
    return aircraft.getBody().getPosition().y - Aircraft::WHEEL_HEIGHT;
}

/// The faster it flies, the less stick it takes.
real stickScale(const Aircraft &aircraft) {
    const real speed = aircraft.getAirspeed();
    return speed > Aircraft::LEVEL_SPEED ? Aircraft::LEVEL_SPEED / speed : 1;
}

real groundSpeed(const Aircraft &aircraft) {
    const Vector3 velocity = aircraft.getBody().getVelocity();
    return cyclone::real_sqrt(velocity.x * velocity.x + velocity.z * velocity.z);
}

}  // namespace

std::string Pilot::getName(Leg leg) {
    switch (leg) {
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
    }
    return "";
}

void Pilot::chooseLeg(const Aircraft &aircraft) {
    const Vector3 position = aircraft.getBody().getPosition();
    const real height = heightOf(aircraft);
    switch (leg) {
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
            return real_clamp(0.5 * (slope - height) - GLIDE_SLOPE * groundSpeed(aircraft), -2, 0.5);
        }
        case Leg::FLARE:
            return -0.15 - 0.5 * height;
        case Leg::ROLL_OUT:
        case Leg::STOPPED:
            break;
    }
    return 0;
}

/// Nose wheel and rudder keep it on the line z = 0; wings with little lift keep it on its wheels.
void Pilot::steerOnGround(const Aircraft &aircraft) {
    const RigidBody &body = aircraft.getBody();
    const real wanted = real_clamp(-0.15 * body.getPosition().z, -0.3, 0.3);
    const real error = wrapped(wanted - aircraft.getHeading());
    sticks.rudder = real_clamp(1.2 * error + 0.3 * body.getRotation().y, -0.6, 0.6);
    sticks.roll = real_clamp(-6 * aircraft.getRoll(), -1, 1);
}

/// Banks until the track over the ground has the given course and the distance to starboard of it is gone.
void Pilot::follow(const Aircraft &aircraft, real course, real offTrack) {
    const RigidBody &body = aircraft.getBody();
    const Vector3 velocity = body.getVelocity();
    const real track = cyclone::real_atan2(velocity.z, velocity.x);
    const real wanted = course - real_clamp(0.03 * offTrack, -0.6, 0.6);
    const real bank = real_clamp(0.9 * wrapped(wanted - track), -MAX_BANK, MAX_BANK);
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
    sticks.pitch =
        real_clamp(real_clamp(stick, -0.35, 0.6) + 0.15 * tooFast, -0.35, 0.6) * stickScale(aircraft);

    const real tooSlow = Aircraft::LEVEL_SPEED * (1 + 0.25 * bank * bank) - airspeed;
    throttleTrim = real_clamp(throttleTrim + 0.03 * tooSlow * duration, -0.3, 0.3);
    sticks.throttle =
        real_clamp(Aircraft::LEVEL_THROTTLE + throttleTrim + 0.17 * climb + 0.15 * tooSlow, 0, 1);
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
        case Leg::ROLL_OUT:
        case Leg::STOPPED:
            steerOnGround(aircraft);
            sticks.throttle = 0;
            sticks.pitch = -1;
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
