#include "vtol/stabiliser.h"

#include <algorithm>

#include "base/angle.h"

namespace vtol {

using cyclone::real_clamp;

namespace {

constexpr real DEGREE = cyclone::REAL_PI / 180;
constexpr real SLOW = 8, FAST = 16;                    // m/s over the ground
constexpr real LEAN = 2 * DEGREE;                      // rad per m/s of drift
constexpr real LIFT = 0.06, MOST_LIFT = 0.25;          // of the throttle, per m/s of rise
constexpr real PITCH_GAIN = 2.5, PITCH_DAMPING = 2.5;  // of the stick, per rad and rad/s
constexpr real BANK_GAIN = 3, BANK_DAMPING = 2, TURN_GAIN = 3;
constexpr real STRONG_SPEED = 25;  // m/s, where surfaces turn her as strongly as puffers

/// 1 in the hover, 0 in flight.
real getHover(const Jet &jet) {
    return real_clamp((FAST - horizontalLength(jet.getBody().getVelocity())) / (FAST - SLOW), 0, 1);
}

}  // namespace

Stabiliser::Correction Stabiliser::getCorrection(const Jet &jet) {
    const RigidBody &body = jet.getBody();
    const Vector3 velocity = body.getVelocity();
    const real hover = getHover(jet);
    const Vector3 ahead = towardsBearing(headingOf(body));
    Correction correction;
    correction.pitch = hover * LEAN * (velocity * ahead);
    correction.bank = -hover * LEAN * (velocity * (ahead % Vector3::UP));
    correction.throttle = -hover * cyclone::real_sin(jet.getNozzles()) * LIFT * velocity.y;
    correction.pitch = real_clamp(correction.pitch, -MOST_PITCH, MOST_PITCH);
    correction.bank = real_clamp(correction.bank, -MOST_BANK, MOST_BANK);
    correction.throttle = real_clamp(correction.throttle, -MOST_LIFT, MOST_LIFT);
    return correction;
}

JetControls Stabiliser::hold(const Jet &jet, const JetControls &asked) {
    const RigidBody &body = jet.getBody();
    const Vector3 rates = body.getDirectionInLocalSpace(body.getRotation());
    const Correction correction = getCorrection(jet);
    const real airspeed = jet.getAirspeed(), ratio = airspeed / STRONG_SPEED, bank = bankOf(body);
    const real softness = 1 / (1 + ratio * ratio);  // the faster, the stronger the surfaces
    const real pitchError =
        real_clamp(MOST_PITCH * asked.pitch + correction.pitch, -MOST_PITCH, MOST_PITCH) - pitchOf(body);
    const real bankError = real_clamp(MOST_BANK * asked.roll + correction.bank, -MOST_BANK, MOST_BANK) - bank;
    // The tailplane lies in the flow, whatever the angle of attack.
    const real trim = (1 - softness) * jet.getAngleOfAttack() / Jet::ELEVATOR_THROW;
    const real cleanTurn = (1 - getHover(jet)) * 9.81 * cyclone::real_sin(bank) / std::max(airspeed, FAST);

    JetControls held = asked;
    held.pitch = trim + softness * (PITCH_GAIN * pitchError - PITCH_DAMPING * rates.z);
    held.roll = softness * (BANK_GAIN * bankError - BANK_DAMPING * rates.x);
    held.pedal = softness * TURN_GAIN * (MOST_TURN * asked.pedal + cleanTurn + rates.y);
    held.throttle = asked.throttle + correction.throttle;
    return held;
}

}  // namespace vtol
