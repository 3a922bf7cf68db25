#include "speedboat/pilot.h"

#include "base/angle.h"
#include "models/attitude.h"

namespace speedboat {

namespace {

using cyclone::real_abs;
using cyclone::real_clamp;

constexpr real BERTH = 5, CLEAR = 2.5;                              // m from the buoy: his aim, and enough
constexpr real SOON = 2;                                            // s: then he looks at the next but one
constexpr real EARLY = 0.5, MOST_EARLY = 0.4;                       // 1, rad
constexpr real SLOW = 3;                                            // m/s: no track to speak of
constexpr real STEERING_PER_ERROR = 1.2, STEERING_PER_TURN = 0.35;  // 1, s
constexpr real STEERING_RATE = 1.5, THROTTLE_RATE = 0.4;            // rad/s, 1/s
constexpr real SLIGHT_TURN = 0.3, TIGHT_TURN = 1;                   // rad
constexpr real EASED = 0.6;                                         // throttle in a tight turn
constexpr real HIGH_BOW = 0.3;                                      // rad: higher, he eases as well
constexpr real TRIMMED = -0.03;  // rad, of the motor: a little in, for waves

real approach(real now, real target, real mostChange) {
    return now + real_clamp(target - now, -mostChange, mostChange);
}

/// Whether going straight on passes the buoy soon, on the proper side.
bool isMade(const Buoy &buoy, const RigidBody &body) {
    const Vector3 gate = buoy.getGateDirection(), place = body.getPosition() - buoy.getPlace();
    const Vector3 ahead = demo::towardsBearing(buoy.heading);
    const real speed = body.getVelocity() * ahead;
    if (speed <= 0) return false;
    const real time = -(place * ahead) / speed;
    const real offset = place * gate + body.getVelocity() * gate * time;
    return time < SOON && offset > CLEAR && offset < 2 * BERTH;
}

/// How far he is off his course, rad: it leads to the water beside the buoy, and comes round early so as to
/// go past it the right way.
real findError(const Motorboat &boat, const Buoy &buoy) {
    const RigidBody &body = boat.getBody();
    const real towards =
        demo::bearing(buoy.getPlace() + buoy.getGateDirection() * BERTH - body.getPosition());
    const real early = EARLY * demo::wrapAngle(towards - buoy.heading);
    const bool isSlow = boat.getSpeed() < SLOW;
    const real track = isSlow ? demo::headingOf(body) : demo::bearing(body.getVelocity());
    return demo::wrapAngle(towards + real_clamp(early, -MOST_EARLY, MOST_EARLY) - track);
}

}  // namespace

Orders drive(const Motorboat &boat, const Course &course, real duration) {
    const RigidBody &body = boat.getBody();
    const bool made = isMade(course.getNextBuoy(), body);
    const real error = findError(boat, made ? course.getBuoyAfter() : course.getNextBuoy());
    const real turnRate = -body.getRotation().y;
    const real steering = STEERING_PER_ERROR * error - STEERING_PER_TURN * turnRate;
    const real turn = real_clamp((real_abs(error) - SLIGHT_TURN) / (TIGHT_TURN - SLIGHT_TURN), 0, 1);
    const real throttle = demo::pitchOf(body) > HIGH_BOW ? EASED : 1 - (1 - EASED) * turn;

    const real most = Motorboat::MAX_STEERING;
    return {approach(boat.getThrottle(), throttle, THROTTLE_RATE * duration),
            approach(boat.getSteering(), real_clamp(steering, -most, most), STEERING_RATE * duration),
            TRIMMED};
}

}  // namespace speedboat
