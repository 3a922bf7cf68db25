#pragma once

/// The jump jet: wings, an engine whose nozzles swivel, puffers and wheels on one rigid body.
#include "models/attitude.h"
#include "models/undercarriage.h"

#include <cyclone/cyclone.h>

#include <array>
#include <string>

namespace vtol {

using namespace demo;

/// Where sticks and levers are.
struct JetControls {
    real pitch = 0;     ///< −1 … 1, positive raises the nose
    real roll = 0;      ///< −1 … 1, positive to starboard
    real pedal = 0;     ///< −1 … 1, positive turns the nose to starboard
    real throttle = 0;  ///< 0 … 1
    real nozzles = 0;   ///< rad, what the push is turned to: 0 forward, π/2 up, up to MOST_NOZZLES
};

/// A jet of 800 kg. Body axes: +X forward, +Y up, +Z starboard; the origin is the centre of mass.
///
/// The push of the nozzles goes through the centre of mass at any angle, so neither throttle nor nozzles turn
/// the aircraft. In the hover that is left to the puffers, jets of the engine's air at nose, tail and wing
/// tips: they have no more than the engine gives, and as the surfaces do they follow the sticks.
///
/// The wing lifts at the centre of mass, so the tail alone makes pitch and yaw stable. With the body along
/// the path it carries the weight at LEVEL_SPEED, by its incidence.
class Jet {
public:
    static constexpr real MASS = 800;             ///< kg
    static constexpr real WEIGHT = MASS * 9.81;   ///< N
    static constexpr real SPAN = 8, CHORD = 1.5;  ///< m
    static constexpr real LEVEL_SPEED = 50;       ///< m/s
    static constexpr real DENSITY = 1.225;        ///< kg/m³, of the air
    static constexpr real ASPECT_RATIO = SPAN / CHORD;
    static constexpr real LIFT_SLOPE = 2 * cyclone::REAL_PI * ASPECT_RATIO / (ASPECT_RATIO + 2);  ///< per rad
    static constexpr real INCIDENCE =
        WEIGHT / (0.5 * DENSITY * LEVEL_SPEED * LEVEL_SPEED * SPAN * CHORD * LIFT_SLOPE);  ///< rad
    static constexpr real FUSELAGE_DRAG_AREA = 0.8;  ///< m², its wheels are always down
    static constexpr real MAX_THRUST = 10000;        ///< N, of all nozzles together
    static constexpr real ENGINE_LAG = 0.4;  ///< s, the time constant with which it follows the throttle
    static constexpr real MOST_NOZZLES = 100 * cyclone::REAL_PI / 180;    ///< rad: a little astern
    static constexpr real NOZZLE_RATE = 30 * cyclone::REAL_PI / 180;      ///< rad/s
    static constexpr real PUFF = 600;                                     ///< N, of each puffer at most
    static constexpr real NOSE_ARM = 3.2, TAIL_ARM = 3.8, TIP_ARM = 3.8;  ///< m, of the puffers
    static constexpr real ELEVATOR_THROW = 0.35, AILERON_THROW = 0.15, RUDDER_THROW = 0.4;  ///< rad
    static constexpr real WHEEL_HEIGHT = 1.2;  ///< m: the centre of mass above the wheels' lowest points
    static const Vector3 MOMENTS_OF_INERTIA;   ///< kg·m²
    static constexpr std::size_t NOZZLES = 2, PUFFERS = 6, SURFACES = 4;

    /// Adds the jet and its forces to the world. The air must outlive it, as the world must.
    Jet(cyclone::World &world, const cyclone::WindField *air);
    ~Jet();
    Jet(const Jet &) = delete;
    Jet &operator=(const Jet &) = delete;

    /// On its wheels over that point of the ground, along +X, engine off, nozzles for the hover.
    void park(const Vector3 &below);
    /// In the air, along +X, at that speed through it, with the controls as if they had long been so.
    void launch(const Vector3 &position, real speed, const JetControls &controls);

    void setControls(const JetControls &wanted);
    const JetControls &getControls() const { return controls; }
    /// Before each step: engine and nozzles follow their levers.
    void advance(real duration);

    /// rad, where they are now.
    real getNozzles() const { return nozzleAngle; }
    /// N, of all nozzles.
    real getThrust() const { return engine * MAX_THRUST; }

    const RigidBody &getBody() const { return body; }
    /// For tests, and for whoever wants to disturb it.
    RigidBody &getBody() { return body; }
    real getHeight() const { return body.getPosition().y - WHEEL_HEIGHT; }  ///< m, of the wheels

    Vector3 getVelocityThroughAir() const;
    real getAirspeed() const { return getVelocityThroughAir().magnitude(); }
    /// rad, between body and flow in the body's plane of symmetry.
    real getAngleOfAttack() const;
    /// Of wings, tail and fuselage, N, world coordinates.
    Vector3 getAirForce() const;
    bool isStalled() const;

    bool isOnGround() const;
    /// What is in the ground though it isn't a wheel; empty while all is well.
    std::string getBrokenPart() const;

    const std::array<cyclone::Thruster, NOZZLES> &getNozzleJets() const { return nozzles; }
    /// At nose, tail, port tip and starboard tip, pushing up; at the tail, to port and to starboard.
    const std::array<cyclone::Thruster, PUFFERS> &getPuffers() const { return puffers; }
    /// Port wing, starboard wing, tailplane, fin.
    const std::array<cyclone::Wing, SURFACES> &getSurfaces() const { return surfaces; }

private:
    void addForces();
    void steerPuffers();

    cyclone::World &world;
    const cyclone::WindField *air;
    RigidBody body;
    std::array<cyclone::Wing, SURFACES> surfaces;
    cyclone::Drag fuselage;
    std::array<cyclone::Thruster, NOZZLES> nozzles;
    std::array<cyclone::Thruster, PUFFERS> puffers;
    std::array<Wheel, 3> wheels;
    JetControls controls;
    real engine = 0;  ///< 0 … 1
    real nozzleAngle = 0;
};

}  // namespace vtol
