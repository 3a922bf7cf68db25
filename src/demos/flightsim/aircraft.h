#pragma once

/// The chapter's model aircraft: four surfaces, a propeller and three wheels on one rigid body.
#include "models/attitude.h"
#include "models/undercarriage.h"

#include <cyclone/cyclone.h>

#include <array>
#include <string>

namespace flightsim {

using namespace demo;

/// Where the sticks are: −1 … 1, throttle 0 … 1. At zero the aircraft flies straight.
struct FlightControls {
    real pitch = 0;   ///< both wings: positive for more lift, which raises the nose
    real roll = 0;    ///< the wings in opposition: positive to starboard
    real rudder = 0;  ///< positive to starboard; steers the nose wheel too
    real throttle = 0;
};

/// A model aircraft of 2.5 kg. Body axes: +X forward, +Y up, +Z starboard; the origin is the centre of mass.
///
/// The tensors are the chapter's. What it leaves open, where the surfaces are, follows from these demands.
/// Level, with the body along the flight path at speed u, each of the two wings and the tailplane lifts 1·u
/// and each of the four surfaces drags 0.1·u, hence
///
///     lift = weight:    3·u = m·g                                    u = 8.175 m/s
///     thrust = drag:    T = 0.4·u                                    T = 3.27 N
///     no pitching:      2·xw + xt + 0.1·(2·yw + yt + yr) − 0.4·yT = 0
///
/// so it flies level with all sticks at zero. Pitching up by α adds the moment u·(0.5·(2·xw + xt) +
/// 0.1·xr)·α, which is negative, hence stable, as the tailplane is far enough aft. The nose-down moment of
/// the lift that follows is balanced by drag that acts high up: wings and tailplane sit above the centre of
/// mass. That also makes a slip lift the leading wing, and each wing's lift acts close to the middle: so the
/// spiral mode is stable too. The fin is far aft, for weathercock stability. A propeller, which pulls less
/// the faster it flies, damps the phugoid (period 4.4 s, damping ratio 0.25).
///
/// The tensors have a quirk: the power u·A·u that a wing gives is positive at angles of attack from −6° to
/// −62°. Held in a steady push, the aircraft gains speed from nowhere.
class Aircraft {
public:
    static constexpr real MASS = 2.5;                        ///< kg
    static constexpr real LEVEL_SPEED = MASS * 9.81 / 3;     ///< m/s
    static constexpr real LEVEL_THRUST = 0.4 * LEVEL_SPEED;  ///< N
    static constexpr real MAX_THRUST = 20;                   ///< N, standing still
    static constexpr real PITCH_SPEED = 14;                  ///< m/s, where the propeller no longer pulls
    /// The throttle that keeps it level.
    static constexpr real LEVEL_THROTTLE = LEVEL_THRUST / (MAX_THRUST * (1 - LEVEL_SPEED / PITCH_SPEED));
    /// The height of the centre of mass when the wheels just touch, m.
    static constexpr real WHEEL_HEIGHT = 0.3;

    /// The throws: what the sticks' full deflection is to the surfaces, whose own range is −1 … 1.
    static constexpr real PITCH_THROW = 0.25, ROLL_THROW = 0.1, RUDDER_THROW = 0.25;
    static constexpr real STEERING_THROW = 0.4;  ///< rad, of the nose wheel

    /// Adds the aircraft and its forces to the world, in the air. The air is still unless windspeed says
    /// otherwise, which is read at each step. Both must outlive the aircraft.
    explicit Aircraft(cyclone::World &world, const Vector3 *windspeed = nullptr);
    ~Aircraft();
    Aircraft(const Aircraft &) = delete;
    Aircraft &operator=(const Aircraft &) = delete;

    /// On its wheels, on the runway's line, pointing along +X, at rest.
    void park(const Vector3 &below);
    /// In the air, flying level along +X at its level speed through the air.
    void launch(const Vector3 &position);

    void setControls(const FlightControls &sticks);
    const FlightControls &getControls() const { return controls; }

    const RigidBody &getBody() const { return body; }
    /// For tests, and for whoever wants to disturb it.
    RigidBody &getBody() { return body; }

    Vector3 getVelocityThroughAir() const;
    real getAirspeed() const { return getVelocityThroughAir().magnitude(); }
    /// rad; heading clockwise from +X as seen from above, −π … π; pitch up and roll to starboard positive.
    real getHeading() const { return headingOf(body); }
    real getPitch() const { return pitchOf(body); }
    real getRoll() const { return bankOf(body); }

    /// Port wing, starboard wing, tailplane, rudder.
    const std::array<const cyclone::Aero *, 4> &getSurfaces() const { return surfaces; }
    const cyclone::Propeller &getPropeller() const { return propeller; }
    /// Nose, port, starboard.
    const std::array<Wheel, 3> &getWheels() const { return wheels; }
    bool isOnGround() const;
    /// What is in the ground though it isn't a wheel, such as "a wing tip"; empty while all is well.
    std::string getBrokenPart() const;

    static const Vector3 WING_POSITION;  ///< of the starboard wing
    static const Vector3 TAIL_POSITION, RUDDER_POSITION, PROPELLER_POSITION;
    static const Vector3 MOMENTS_OF_INERTIA;  ///< kg·m²

private:
    cyclone::World &world;
    RigidBody body;
    cyclone::AeroControl portWing, starboardWing;
    cyclone::Aero tailplane;
    cyclone::AeroControl rudder;
    cyclone::Propeller propeller;
    std::array<Wheel, 3> wheels;
    std::array<const cyclone::Aero *, 4> surfaces;
    const Vector3 *windspeed;
    FlightControls controls;
};

}  // namespace flightsim
