#pragma once

/// The ship, the pod, and the rod between them.
///
/// All stay in the plane z = 0, to the bit: motion along Z and rotations about X and Y are locked. Body axes
/// of the ship: +X nose, origin in the centre of mass. The heading is that of the nose, in rad: 0 is up,
/// positive to the right.
#include <cyclone/aero.h>
#include <cyclone/propulsion.h>
#include <cyclone/world.h>

#include <array>
#include <vector>

namespace thrust {

using cyclone::Quaternion;
using cyclone::real;
using cyclone::Vector3;

/// Small jets that turn a body about Z to a heading and hold it there, as a damped spring does, within what
/// torque they have.
class AttitudeJets : public cyclone::ForceGenerator {
public:
    static constexpr real MAX_TORQUE = 4000;  ///< N·m

    void setHeading(real wanted) { heading = wanted; }
    void updateForce(cyclone::RigidBody *body, real duration) override;
    bool actsOnItsBodyOnly() const override { return true; }

private:
    real heading = 0;
};

class Ship {
public:
    static constexpr real MASS = 800, POD_MASS = 300;  ///< kg
    static constexpr real MAX_PUSH = 4000;             ///< N
    static constexpr real ROD_LENGTH = 5;              ///< m, between the centres of mass
    static constexpr real POD_RADIUS = 0.6;            ///< m

    /// Adds ship and pod to the world. The windspeed (see aero.h) of the thin air is read at each step; null:
    /// there is no air. Both must outlive the ship.
    Ship(cyclone::World &world, const Vector3 *windspeed);
    ~Ship();
    Ship(const Ship &) = delete;
    Ship &operator=(const Ship &) = delete;

    /// Puts the ship here, nose up, where it is held until the engine burns, and the pod there, its rod
    /// standing on it. Both fall with this gravity (m/s²).
    void launch(const Vector3 &ship, const Vector3 &pod, real gravity);

    void setHeading(real wanted) { jets.setHeading(wanted); }
    /// 0 … 1. Whatever burns lets go of the ship.
    void setThrottle(real throttle);
    real getThrottle() const { return engine.getThrottle(); }

    /// Takes the rod by its end, wherever the ship is. A winch brings it to its length.
    void hook();
    bool isHooked() const { return hooked; }
    /// Where the rod ends until it is hooked: above the pod.
    Vector3 getRodEnd() const { return pod.getPosition() + Vector3::UP * ROD_LENGTH; }
    /// Before each step.
    void advanceWinch(real duration);

    /// Ends it: ship and pod stand still, the rod is gone, and the ship's parts fly off.
    void breakUp();
    bool isBroken() const { return broken; }

    const cyclone::RigidBody &getBody() const { return body; }
    cyclone::RigidBody &getBody() { return body; }
    const cyclone::RigidBody &getPod() const { return pod; }
    cyclone::RigidBody &getPod() { return pod; }
    /// Hull, port fin and starboard fin after breaking up.
    static constexpr std::size_t WRECK_PARTS = 3;
    const cyclone::RigidBody &getWreck(std::size_t part) const { return wreck.at(part); }

    real getHeading() const;
    /// Of the rod, once it is hooked: how far the pod has swung to the right, rad; else 0.
    real getSwing() const;
    Vector3 getPush() const { return engine.getForce(body); }  ///< N, world
    Vector3 getRodForce() const;                               ///< on the ship, N, world

    /// Corners in order, world.
    std::vector<Vector3> getOutline() const;
    std::vector<Vector3> getPodOutline() const;

    /// The ship's silhouette, body coordinates, counter-clockwise seen from +Z.
    static const std::vector<Vector3> &getSilhouette();

private:
    cyclone::World &world;
    cyclone::RigidBody body, pod;
    std::array<cyclone::RigidBody, WRECK_PARTS> wreck;
    cyclone::Thruster engine;
    AttitudeJets jets;
    cyclone::Aero air, podAir;
    cyclone::Spring rod;
    Vector3 falling;  ///< gravity, m/s²
    bool hooked = false, broken = false;
};

}  // namespace thrust
