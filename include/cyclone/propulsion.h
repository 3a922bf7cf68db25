#pragma once

/// @file
/// What drives vehicles: a thruster and a propeller.
#include <cyclone/force.h>
#include <cyclone/water.h>
#include <cyclone/wind.h>

namespace cyclone {

/// A push of throttle·maxForce along a direction that is fixed to the body: a rocket, a jet, an outboard
/// motor.
class CYCLONE_API Thruster : public PointForce {
public:
    /// Direction of the push (any length but zero) and where it acts, m, in body coordinates; maxForce in N,
    /// finite and not negative. The throttle is closed at first.
    Thruster(const Vector3 &direction, const Vector3 &position, real maxForce);

    /// 0 … 1; clamped. Finite.
    void setThrottle(real value);
    real getThrottle() const { return throttle; }
    /// Turns the push, as a gimbal or an outboard motor does.
    void setDirection(const Vector3 &bodyDirection);
    Vector3 getDirection() const { return direction; }

    /// Makes the push that of a screw in water, with this radius in m, positive: it fades as the screw comes
    /// out, and is none with the position a radius above the surface. The water must live as long as the
    /// thruster acts; null is none: it pushes anywhere.
    void setWater(const Water *sea, real radius);

    Vector3 getForce(const RigidBody &body) const override;

protected:
    /// For derived classes: `function` is whose arguments they are.
    Thruster(const char *function, const Vector3 &direction, const Vector3 &position, real maxForce);

    /// N, as far as the screw is under water.
    real getPush(const RigidBody &body) const;

    Vector3 direction;
    real maxForce;
    real throttle = 0;
    const Water *water = nullptr;
    real radius = 1;
};

/// A thruster that bites less the faster it already moves through the air, or the water that it is in:
/// throttle·maxForce·(1 − u/pitchSpeed), where u is that speed along the push. Beyond pitchSpeed it brakes,
/// as a propeller at idle does; backwards it pushes no more than standing still.
class CYCLONE_API Propeller : public Thruster {
public:
    /// As Thruster. pitchSpeed in m/s, positive: pitch times revolutions. windspeed as for Aero.
    Propeller(const Vector3 &direction, const Vector3 &position, real maxForce, real pitchSpeed,
              const Vector3 *windspeed);

    /// A wind that differs from place to place, as Aero::setWind, read where the push acts.
    void setWind(const WindField *field) { windField = field; }

    Vector3 getForce(const RigidBody &body) const override;
    void updateForce(RigidBody *body, real duration) override;
    void addResistance(const RigidBody &body, Resistance &sum) const override;

private:
    real pitchSpeed;
    const Vector3 *windspeed;
    const WindField *windField = nullptr;
};

}  // namespace cyclone
