#pragma once

/// A glider: wings that stall, airbrakes and a wheel on one rigid body.
#include "models/attitude.h"
#include "models/undercarriage.h"

#include <cyclone/cyclone.h>

#include <array>
#include <string>

namespace flightsim {

using namespace demo;

/// Where stick, pedals and lever are: −1 … 1, brakes 0 … 1.
struct GliderControls {
    real pull = 0;   ///< the stick: positive towards the pilot, which raises the nose
    real roll = 0;   ///< the stick: positive to starboard
    real pedal = 0;  ///< positive to starboard
    real brakes = 0;
};

/// Plates that rise out of the wings: −½·density·area·brakes·|u|·u at a point of the body, u its velocity
/// through the air.
class AirBrakes : public cyclone::PointForce {
public:
    /// area (m²) times drag coefficient, fully out.
    AirBrakes(real dragArea, const Vector3 &position, const cyclone::WindField *air);

    /// 0 … 1.
    void setControl(real value) { control = value; }
    Vector3 getForce(const RigidBody &body) const override;

private:
    real dragArea, control = 0;
    const cyclone::WindField *air;
};

/// A glider of 340 kg and 15 m span. Body axes: +X forward, +Y up, +Z starboard; the origin is the centre of
/// mass.
///
/// The wing is made of four pieces, of which the outer ones have ailerons; so each meets its own air, a stall
/// drops one side first, and a thermal lifts the wing that is in it. With CD0 the drag without lift, its
/// polar is
///
///     CD = CD0 + CL²/(π·AR)      best glide: CL = √(π·AR·CD0), ratio √(π·AR/CD0)/2
///
/// which is 39 at 24.5 m/s, where it sinks at 0.63 m/s.
class Glider {
public:
    static constexpr real MASS = 340;                         ///< kg
    static constexpr real SPAN = 15, CHORD = 0.7;             ///< m, of the wing
    static constexpr real TAIL_SPAN = 2.6, TAIL_CHORD = 0.5;  ///< m
    static constexpr real FIN_SPAN = 1.3, FIN_CHORD = 0.85;   ///< m
    static constexpr real SECTION_DRAG = 0.006;               ///< of the wings' sections, without lift
    static constexpr real FUSELAGE_DRAG_AREA = 0.04;          ///< m²
    static constexpr real BRAKE_DRAG_AREA = 0.9;              ///< m²
    static constexpr real DENSITY = 1.225;                    ///< kg/m³, of the air
    static constexpr real BEST_GLIDE_SPEED = 24.5;            ///< m/s
    static constexpr real WHEEL_HEIGHT = 0.7;  ///< m: the centre of mass above the wheel's lowest point
    static constexpr real AILERON_THROW = 0.35, ELEVATOR_THROW = 0.35, RUDDER_THROW = 0.5;  ///< rad

    /// Adds the glider and its forces to the world. The air must outlive it, as the world must.
    Glider(cyclone::World &world, const cyclone::WindField *air);
    ~Glider();
    Glider(const Glider &) = delete;
    Glider &operator=(const Glider &) = delete;

    /// In the air, along +X, at its speed of best glide.
    void launch(const Vector3 &position);

    void setControls(const GliderControls &controls);
    const GliderControls &getControls() const { return controls; }

    const RigidBody &getBody() const { return body; }
    /// For tests, and for whoever wants to disturb it.
    RigidBody &getBody() { return body; }

    Vector3 getVelocityThroughAir() const;
    real getAirspeed() const { return getVelocityThroughAir().magnitude(); }
    /// m: what height it would have if all its speed were height. What it gains comes from the air.
    real getEnergyHeight() const;
    /// rad: positive when the air comes from starboard.
    real getSlip() const;

    /// The wing from port to starboard, tailplane, fin.
    std::array<const cyclone::Wing *, 6> getWings() const;
    const AirBrakes &getBrakes() const { return brakes; }
    bool isStalled() const;
    bool isOnGround() const;
    /// What is in the ground though it is no wheel or skid, such as "the nose"; empty while all is well.
    std::string getBrokenPart() const;

private:
    void addPieces(const cyclone::WindField *air);

    cyclone::World &world;
    const cyclone::WindField *air;
    RigidBody body;
    std::array<cyclone::Wing, 4> wing;
    cyclone::Wing tailplane, fin;
    cyclone::Drag fuselage;
    AirBrakes brakes;
    std::array<Wheel, 4> wheels;  ///< main wheel, tail skid, a skid below each wing tip
    GliderControls controls;
};

}  // namespace flightsim
