#pragma once

/// The three aircraft of the race.
#include <cyclone/cyclone.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace airrace {

using cyclone::real;
using cyclone::RigidBody;
using cyclone::Vector3;

struct Sticks {
    real elevator = 0;  ///< −1 … 1, positive raises the nose
    real aileron = 0;   ///< −1 … 1, positive rolls to starboard
    real throttle = 0;  ///< 0 … 1
};

/// What is told of an aircraft before it flies.
struct Model {
    std::string name;
    real mass;                 ///< kg
    Vector3 momentsOfInertia;  ///< kg·m²
    real span;                 ///< m
    real maxThrust;            ///< N, standing still
    real pitchSpeed;           ///< m/s, where the propeller no longer pulls
    real cruise;               ///< m/s: level with the sticks at zero, if the throttle keeps the speed
    real rollRate;             ///< rad/s at cruise with full aileron
    real pitchRate;            ///< rad/s at cruise with full elevator
    real stallSpeed;           ///< m/s in level flight; 0: it does not stall
    real aileron, elevator;    ///< rad, full throw
};

/// One rigid body with a wing on each side, a tailplane that turns as a whole, a fin and a propeller. Body
/// axes: +X forward, +Y up, +Z starboard; the origin is the centre of mass.
///
/// The wings lift at the centre of mass, so the tail alone makes pitch and yaw stable, and sets the angle of
/// attack.
class Aircraft {
public:
    static constexpr real DENSITY = 1.225;  ///< kg/m³, of the air

    /// Adds the aircraft to the world, which owns its body and forces. The air must outlive it.
    ///
    /// "bullet" is fast and sluggish, "gnat" nimble: their wings are flat plates whose lift grows with the
    /// angle of attack without end. Those of the "swallow" have less drag in a turn, and stall.
    static std::unique_ptr<Aircraft> make(const std::string &name, cyclone::World &world,
                                          const cyclone::WindField *air);
    /// What make() knows.
    static const std::vector<std::string> NAMES;

    virtual ~Aircraft() = default;
    Aircraft(const Aircraft &) = delete;
    Aircraft &operator=(const Aircraft &) = delete;

    /// In the air, along +X, at its cruising speed through it.
    void launch(const Vector3 &position);
    void setSticks(const Sticks &s);
    const Sticks &getSticks() const { return sticks; }

    const Model &getModel() const { return model; }
    const RigidBody &getBody() const { return *body; }
    /// For tests, and for whoever wants to disturb it.
    RigidBody &getBody() { return *body; }
    Vector3 getVelocityThroughAir() const;
    real getAirspeed() const { return getVelocityThroughAir().magnitude(); }
    /// rad: of the path over the ground.
    real getClimbAngle() const;

    virtual bool isStalled() const { return false; }
    /// Whether some part is in the ground.
    bool touchesGround() const;
    /// Port wing, starboard wing, tailplane, fin, propeller.
    const std::array<const cyclone::PointForce *, 5> &getForces() const { return forces; }

protected:
    Aircraft(cyclone::World &world, const Model &model, const cyclone::WindField *air);
    /// Turns the surfaces by these angles, rad: the tailplane's leading edge down, and the starboard wing for
    /// less lift.
    virtual void turnSurfaces(real elevator, real aileron) = 0;

    static const Vector3 TAIL, FIN;

    Model model;
    const cyclone::WindField *air;
    RigidBody *body;
    std::array<const cyclone::PointForce *, 5> forces{};

private:
    cyclone::Propeller &propeller;
    Sticks sticks;
};

}  // namespace airrace
