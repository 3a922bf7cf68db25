#include "airrace/pilot.h"

#include "base/angle.h"
#include "models/attitude.h"

namespace airrace {

using cyclone::real_atan2;
using cyclone::real_clamp;
using cyclone::REAL_PI;

namespace {

constexpr real G = 9.81;
// The stabiliser's: how soon it makes up for an error, 1/s.
constexpr real BANK_GAIN = 3, CLIMB_GAIN = 1.5, PITCH_RATE_GAIN = 3;
// The pilot's.
constexpr real MARGIN = 0.8;                               // of what the wings bear, or of what stalls them
constexpr real EASED_FROM = 0.8, EASING = 2;               // of the throttle, where a turn is too tight
constexpr real SLOWEST = 0.85;                             // of the cruising speed
constexpr real SHORTEST = 0.8;                             // s, that he looks ahead
constexpr real STEEPEST_BANK = 1.4, STEEPEST_CLIMB = 0.4;  // rad
constexpr real RUN_IN = 5;                                 // s before a hoop: where he turns in
constexpr real LEAST_HEIGHT = 25;                          // m

/// m/s²: how much lift over mass he asks for.
real mostLift(const Aircraft &aircraft) {
    const real stallSpeed = aircraft.getModel().stallSpeed, speed = aircraft.getAirspeed();
    const real most = Stabiliser::MOST_LOAD,
               stall = stallSpeed > 0 ? speed * speed / (stallSpeed * stallSpeed) : most;
    return MARGIN * G * (stall < most ? stall : most);
}

/// The acceleration that brings him along `way` in so many seconds with the least effort, at first: of the
/// cubic through both places, 3·way/t² − 3·v/t where any velocity will do at its end, and 6·way/t² −
/// (4·v + 2·v')/t where it is to be v' (Bryson and Ho 1975, section 5.3). heed: how much he cares for it, 0 …
/// 1.
Vector3 accelerationFor(const Vector3 &way, const Vector3 &v, const Vector3 &vAtEnd, real heed, real t) {
    return way * ((3 + 3 * heed) / (t * t)) - (v * (3 + heed) + vAtEnd * (2 * heed)) * (1 / t);
}

}  // namespace

Sticks Stabiliser::hold(const Aircraft &aircraft, const Command &command, real duration) {
    const RigidBody &body = aircraft.getBody();
    const Model &model = aircraft.getModel();
    const real bank = demo::bankOf(body), climb = aircraft.getClimbAngle();
    const Vector3 rates = body.getDirectionInLocalSpace(body.getRotation());
    const real speed = cyclone::real_clamp(body.getVelocity().magnitude(), 1, 1000);
    // Controls bite in proportion to the airspeed.
    const real bite = real_clamp(aircraft.getAirspeed() / model.cruise, 0.3, 2);
    Sticks sticks;
    sticks.throttle = command.throttle;

    const real rollRate =
        real_clamp(BANK_GAIN * demo::wrapAngle(command.bank - bank), -model.rollRate, model.rollRate);
    sticks.aileron = (1.5 * rollRate - 0.5 * rates.x) / (model.rollRate * bite);

    // The lift across the path that turns it upwards as wanted, over the weight, and the pitch rate with it.
    const real upright = cyclone::real_cos(bank);
    const real load =
        real_clamp((cyclone::real_cos(climb) + speed / G * CLIMB_GAIN * (command.climb - climb)) /
                       real_clamp(upright, 0.17, 1),
                   LEAST_LOAD, MOST_LOAD);
    const real error = G / speed * (load - upright * cyclone::real_cos(climb)) - rates.z;
    trim = real_clamp(trim + PITCH_RATE_GAIN * error / model.pitchRate * duration, -1, 1);
    sticks.elevator = trim + error / (model.pitchRate * bite);
    return sticks;
}

Command Pilot::fly(const Aircraft &aircraft, const Hoop &hoop) {
    const RigidBody &body = aircraft.getBody();
    Vector3 position = body.getPosition(), velocity = body.getVelocity();
    const Vector3 throughAir = aircraft.getVelocityThroughAir(), wind = velocity - throughAir;
    const real airspeed = throughAir.magnitude(), speed = velocity.magnitude();
    const real speedAtHoop = airspeed + wind * hoop.axis, runIn = RUN_IN * speedAtHoop;
    const real ahead = (hoop.centre - position) * hoop.axis;
    if (ahead < -20) goesRound = true;
    if (ahead > 0.6 * runIn) goesRound = false;

    // He thinks ahead of the aircraft, which needs a while to roll.
    const Vector3 starboard = Vector3(-velocity.z, 0, velocity.x).unit();
    const real lag = 0.1 + 0.75 / aircraft.getModel().rollRate,
               bank = real_clamp(demo::bankOf(body), -STEEPEST_BANK, STEEPEST_BANK);
    const Vector3 turning = starboard * (G * cyclone::real_sin(bank) / cyclone::real_cos(bank));
    position += velocity * lag + turning * (lag * lag / 2);
    velocity += turning * lag;

    const Vector3 way = hoop.centre - hoop.axis * (goesRound ? runIn : 0) - position;
    const real time = real_clamp(1.05 * way.magnitude() / ((speed + speedAtHoop) / 2), SHORTEST, 60);
    const Vector3 wanted =
        accelerationFor(way, velocity, hoop.axis * speed, real_clamp(time / 2.5 - 0.5, 0, 1), time);

    // The climb first; the lift that is left beside it may turn him.
    const real climb = aircraft.getClimbAngle(), most = mostLift(aircraft), vertical = speed * CLIMB_GAIN;
    real newClimb = real_clamp(climb + wanted.y / vertical, -STEEPEST_CLIMB, STEEPEST_CLIMB);
    if (body.getPosition().y < LEAST_HEIGHT) newClimb = STEEPEST_CLIMB;
    const real up = real_clamp(G + vertical * (newClimb - climb), 0.04 * most, 0.9 * most);
    const real across = wanted * starboard, left = cyclone::real_sqrt(most * most - up * up);
    Command command;
    command.climb = climb + (up - G) / vertical;
    command.bank = real_clamp(real_atan2(real_clamp(across, -left, left), up), -STEEPEST_BANK, STEEPEST_BANK);
    if (airspeed > SLOWEST * aircraft.getModel().cruise)
        command.throttle = real_clamp(1 - EASING * (cyclone::real_abs(across) / left - EASED_FROM), 0, 1);
    return command;
}

}  // namespace airrace
