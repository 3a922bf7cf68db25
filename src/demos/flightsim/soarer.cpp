#include "flightsim/soarer.h"

#include <algorithm>

#include "base/angle.h"

namespace flightsim {

using cyclone::real_clamp;
using cyclone::REAL_PI;

namespace {

constexpr real DEGREE = REAL_PI / 180;
constexpr real AVERAGE = 25;                                                // s
constexpr real LIFT = 0.5, HARDLY_LIFT = 0.3;                               // m/s
constexpr real CEILING = 650, LOWEST_SEARCH = 220;                          // m
constexpr real SEARCH_TIME = 420;                                           // s; then he goes home
constexpr real CRUISE_SPEED = 27, THERMAL_SPEED = 24, APPROACH_SPEED = 26;  // m/s
constexpr real CIRCLE = 80, CIRCLE_BANK = 36 * DEGREE;  // m, rad: what THERMAL_SPEED makes of each other
constexpr real CENTRING = 0.015;  // 1/m: how far he shifts the circle for what the variometer shows
constexpr real MAX_BANK = 48 * DEGREE;
// The circuit, in the runway's frame: +X is the way he lands.
constexpr real DOWNWIND_Z = -320, BASE_X = -450, AIM_X = -50;  // m
constexpr real CIRCUIT_HEIGHT = 140, FLARE_HEIGHT = 5;         // m
constexpr real GLIDE_SLOPE = 0.11;

real groundSpeed(const Glider &glider) { return horizontalLength(glider.getBody().getVelocity()); }

real heightOf(const Glider &glider) { return glider.getBody().getPosition().y - Glider::WHEEL_HEIGHT; }

real horizontalDistance(const Vector3 &a, const Vector3 &b) { return horizontalLength(a - b); }

}  // namespace

Soarer::Soarer(const std::vector<Vector3> &c, const Vector3 &windFrom)
    : clouds(c), direction(windFrom.x < 0 ? -1 : 1) {}

std::string Soarer::getName(Leg leg) {
    switch (leg) {
        case Leg::SEARCH:
            return "flies to a cloud";
        case Leg::CIRCLE:
            return "circles in lift";
        case Leg::RETURN:
            return "returns to the field";
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

// ---- Decisions

void Soarer::chooseCloud(const Vector3 &position) {
    hasCloud = !clouds.empty();
    if (!hasCloud) return;
    const auto nearest =
        std::min_element(clouds.begin(), clouds.end(), [&](const Vector3 &a, const Vector3 &b) {
            return horizontalDistance(a, position) < horizontalDistance(b, position);
        });
    cloud = *nearest;
    clouds.erase(nearest);
}

/// At the ceiling, or when a whole circle has hardly gained.
bool Soarer::leavesThermal(real height, real duration) {
    circled += duration;
    if (height > CEILING) return true;
    return circled > AVERAGE && averageClimb < HARDLY_LIFT;
}

void Soarer::chooseLeg(const Glider &glider, real duration) {
    const Vector3 position = glider.getBody().getPosition(), p = toRunway(position);
    const real height = heightOf(glider);
    switch (leg) {
        case Leg::SEARCH:
            if (!hasCloud) chooseCloud(position);
            if (!hasCloud || height < LOWEST_SEARCH || time > SEARCH_TIME) {
                leg = Leg::RETURN;
            } else if (vario > LIFT && horizontalDistance(position, cloud) < 120) {
                leg = Leg::CIRCLE;
                centre = cloud;
                circled = 0;
                averageClimb = vario;
                heightAtEntry = height;
            } else if (horizontalDistance(position, cloud) < 40) {
                hasCloud = false;  // there is nothing to be had
            }
            break;
        case Leg::CIRCLE:
            if (!leavesThermal(height, duration)) break;
            gained += std::max(height - heightAtEntry, 0.0);
            hasCloud = false;
            leg = Leg::SEARCH;
            break;
        case Leg::RETURN:
            if (height < CIRCUIT_HEIGHT + 15 ||
                (height < CIRCUIT_HEIGHT + 60 && p.x > 0 && p.x < 300 && p.z < -200))
                leg = Leg::DOWNWIND;
            break;
        case Leg::DOWNWIND:
            if (p.x < BASE_X + 80) leg = Leg::BASE;
            break;
        case Leg::BASE:
            if (p.z > -110) leg = Leg::FINAL;
            break;
        case Leg::FINAL:
            if (height < FLARE_HEIGHT) leg = Leg::FLARE;
            break;
        case Leg::FLARE:
            if (glider.isOnGround()) leg = Leg::ROLL_OUT;
            break;
        case Leg::ROLL_OUT:
            if (groundSpeed(glider) < 0.2) leg = Leg::STOPPED;
            break;
        case Leg::STOPPED:
            break;
    }
}

// ---- Stick, pedals and brakes

/// Pitch keeps the airspeed.
void Soarer::holdSpeed(const Glider &glider, real speed, real duration) {
    const RigidBody &body = glider.getBody();
    const real tooFast = glider.getAirspeed() - speed;
    pitchTrim = real_clamp(pitchTrim + 0.004 * tooFast * duration, -0.15, 0.15);
    const real pitch = real_clamp(pitchTrim + 0.02 * tooFast, -0.3, 0.3);
    const real rate = body.getDirectionInLocalSpace(body.getRotation()).z, bank = bankOf(body);
    const real turning = 0.5 * bank * bank;  // the nose must be pulled round
    controls.pull = real_clamp(2.5 * (pitch - pitchOf(body)) - 1.0 * rate + turning, -1, 1);
}

/// Stick and pedals together: the pedals keep the air from coming from the side.
void Soarer::bankTo(const Glider &glider, real bank) {
    const RigidBody &body = glider.getBody();
    const Vector3 rates = body.getDirectionInLocalSpace(body.getRotation());
    controls.roll = real_clamp(1.6 * (bank - bankOf(body)) - 1.2 * rates.x, -1, 1);
    controls.pedal = real_clamp(2.5 * glider.getSlip() + 0.25 * controls.roll, -1, 1);
}

void Soarer::steerTowards(const Glider &glider, const Vector3 &target) {
    follow(glider, bearing(target - glider.getBody().getPosition()), 0);
}

/// Banks until the track over the ground has the course and the distance to starboard of it is gone.
void Soarer::follow(const Glider &glider, real course, real offTrack) {
    const real track = bearing(glider.getBody().getVelocity());
    const real wanted = course - real_clamp(0.008 * offTrack, -0.6, 0.6);
    const real most = std::min(0.04 * heightOf(glider), MAX_BANK);  // she lands with level wings
    bankTo(glider, real_clamp(1.4 * wrapAngle(wanted - track), -most, most));
}

/// Round the place where he takes the lift to be best, which he shifts to the side of the circle on which the
/// variometer shows more than its average.
void Soarer::circle(const Glider &glider, real duration) {
    const Vector3 position = glider.getBody().getPosition();
    Vector3 outwards = position - centre;
    outwards.y = 0;
    centre += outwards * (CENTRING * (vario - averageClimb) * duration);
    const real distance = outwards.magnitude();
    const real inwards = real_clamp(0.7 * (distance / CIRCLE - 1), -0.8, 0.8);
    const real track = bearing(glider.getBody().getVelocity());
    const real error = wrapAngle(bearing(outwards) + REAL_PI / 2 + inwards - track);
    bankTo(glider, real_clamp(CIRCLE_BANK + 1.2 * error, 0.25 * CIRCLE_BANK, MAX_BANK));
}

/// Out when she is above that height, in when below.
void Soarer::brakeDownTo(const Glider &glider, real height) {
    const real wanted = real_clamp(0.4 + 0.06 * (heightOf(glider) - height), 0, 1);
    controls.brakes += real_clamp(wanted - controls.brakes, -0.02, 0.02);
}

void Soarer::land(const Glider &glider, real duration) {
    const Vector3 p = toRunway(glider.getBody().getPosition());
    const real along = direction > 0 ? 0 : REAL_PI, height = heightOf(glider);
    switch (leg) {
        case Leg::DOWNWIND:
            follow(glider, along + REAL_PI, DOWNWIND_Z - p.z);
            brakeDownTo(glider, CIRCUIT_HEIGHT - 0.06 * (200 - p.x));
            break;
        case Leg::BASE:
            follow(glider, along + REAL_PI / 2, 0);
            brakeDownTo(glider, GLIDE_SLOPE * (AIM_X - p.x - p.z));
            break;
        case Leg::FINAL:
            follow(glider, along, p.z);
            brakeDownTo(glider, GLIDE_SLOPE * (AIM_X - p.x));
            break;
        default:
            break;
    }
    if (leg != Leg::FLARE) return holdSpeed(glider, APPROACH_SPEED, duration);
    // The sink rate goes down with the height; the wheel touches at a quarter of a metre per second.
    const RigidBody &body = glider.getBody();
    follow(glider, along, p.z);
    const real sink = -0.25 - 0.45 * std::max(height, 0.0),
               rate = body.getDirectionInLocalSpace(body.getRotation()).z;
    controls.pull = real_clamp(0.25 + 0.45 * (sink - body.getVelocity().y) - 1.0 * rate, -0.3, 1);
    controls.brakes = 0.4;
}

GliderControls Soarer::fly(const Glider &glider, real shown, real duration) {
    time += duration;
    vario = shown;
    averageClimb += (vario - averageClimb) * duration / AVERAGE;
    chooseLeg(glider, duration);
    controls.brakes = leg == Leg::SEARCH || leg == Leg::CIRCLE ? 0 : controls.brakes;
    switch (leg) {
        case Leg::SEARCH:
            steerTowards(glider, cloud);
            holdSpeed(glider, CRUISE_SPEED, duration);
            break;
        case Leg::CIRCLE:
            circle(glider, duration);
            holdSpeed(glider, THERMAL_SPEED, duration);
            break;
        case Leg::RETURN: {
            const Vector3 entry = toRunway(Vector3(150, 0, DOWNWIND_Z));
            if (horizontalDistance(glider.getBody().getPosition(), entry) < 400) {
                brakeDownTo(glider, CIRCUIT_HEIGHT);
            } else {
                controls.brakes = 0;
            }
            steerTowards(glider, entry);
            holdSpeed(glider, CRUISE_SPEED, duration);
            break;
        }
        case Leg::DOWNWIND:
        case Leg::BASE:
        case Leg::FINAL:
        case Leg::FLARE:
            land(glider, duration);
            break;
        case Leg::ROLL_OUT:
        case Leg::STOPPED: {
            const real along = direction > 0 ? 0 : REAL_PI,
                       offLine = toRunway(glider.getBody().getPosition()).z;
            const real wanted = along - real_clamp(0.03 * offLine, -0.3, 0.3);
            controls.pedal = real_clamp(8 * wrapAngle(wanted - headingOf(glider.getBody())), -1, 1);
            controls.roll = real_clamp(-3 * bankOf(glider.getBody()), -1, 1);
            controls.pull = 0;
            controls.brakes = 1;
            break;
        }
    }
    return controls;
}

}  // namespace flightsim
