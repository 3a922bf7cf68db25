#pragma once

/// What carries an aircraft on the ground.
#include <cyclone/force.h>

namespace demo {

using cyclone::real;
using cyclone::RigidBody;
using cyclone::Vector3;

/// A sprung wheel on the ground, the plane y = 0.
///
/// The wheel's lowest point P, fixed to the body while the strut is out, is pressed d = −P.y into the ground.
/// The strut pushes upwards with N = k·d − c·dP.y/dt, and never pulls. The wheel resists rolling with μr·N
/// and sliding sideways with μs·N (Coulomb); each of them fades with v/√(v² + s²) below the creep speed s, so
/// that a wheel at rest doesn't rattle.
class Wheel : public cyclone::ForceGenerator {
public:
    struct Strut {
        real springConstant = 400;                ///< k, N/m
        real damping = 16;                        ///< c, N·s/m
        real rollingFriction = 0.06, grip = 0.5;  ///< μr and μs
        real creepSpeed = 0.3;                    ///< s, m/s
    };

    /// The wheel's lowest point, in body coordinates.
    Wheel(const Vector3 &lowestPoint, const Strut &s) : point(lowestPoint), strut(s) {}

    /// Turns the wheel by an angle (rad), towards starboard if positive.
    void setSteering(real angle) { steering = angle; }

    /// How far the strut is pressed in, m; 0 in the air.
    real getCompression(const RigidBody &body) const;
    /// How fast the lowest point moves (world, m/s).
    Vector3 getPointVelocity(const RigidBody &body) const;
    /// The force on the body as it moves now, N, world coordinates.
    Vector3 getForce(const RigidBody &body) const;

    Vector3 getPosition() const { return point; }

    void updateForce(RigidBody *body, real duration) override;
    bool actsOnItsBodyOnly() const override { return true; }

private:
    Vector3 point;
    Strut strut;
    real steering = 0;
};

}  // namespace demo
