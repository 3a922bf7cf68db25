#pragma once

/// @file
/// What water does to hulls: it carries and resists them.
#include <cyclone/force.h>
#include <cyclone/water.h>

namespace cyclone {

/// The buoyancy of a hull, or of a part of one, that is wholly under water when its centre is maxDepth below
/// the surface, and out of it maxDepth above:
///
///     force = density·volume·(gravity·up + a)·submersion,
///     submersion = clamp((h + maxDepth − y)/(2·maxDepth), 0, 1),
///
/// with y the height of the centre of buoyancy, and h the height and a the acceleration of the water there:
/// in still water the weight of what is displaced (Archimedes), in waves the gradient of their pressure
/// (Froude 1861 and Krylov 1896), which carries a small float along as the water goes.
class CYCLONE_API Buoyancy : public PointForce {
public:
    /// centreOfBuoyancy in body coordinates, m; maxDepth (m), volume (m³), liquidDensity (kg/m³) and gravity
    /// (m/s²) positive; waterHeight (m) of still water, world.
    Buoyancy(const Vector3 &centreOfBuoyancy, real maxDepth, real volume, real waterHeight,
             real liquidDensity = 1000, real gravity = 9.81);

    /// Water with waves in place of still water; read at each frame, it must live as long as the hull floats
    /// in it. Null is still water at the height given to the constructor.
    void setWater(const Water *sea) { water = sea; }
    const Water *getWater() const { return water; }

    /// The part of the volume that is under water now, 0 … 1.
    real getSubmersion(const RigidBody &body) const;
    Vector3 getForce(const RigidBody &body) const override;

private:
    real submersionAt(real centreHeight, real surfaceHeight) const;

    real maxDepth, volume, waterHeight, liquidDensity, gravity;
    const Water *water = nullptr;
};

/// How the water resists a hull, or a part of one, that moves through it: along each body axis
///
///     force = −submersion·(linear·u + quadratic·|u|·u),
///
/// with u the velocity of the point where it acts, past the water there. Along a hull the quadratic term is
/// friction and wave making; sideways a hull is a wall; and what it spends up and down on making waves is
/// what ends heaving, rolling and pitching. It may be of any strength, see
/// ForceGenerator::addResistance.
class CYCLONE_API HullDrag : public PointForce {
public:
    /// Acts at `centre`, m, body coordinates, as far as `hull` is under water; the water is the hull's.
    /// `hull` must live as long as the drag acts. linear in N·s/m and quadratic in N·s²/m², one for each body
    /// axis, wholly under water; finite and not negative.
    HullDrag(const Buoyancy *hull, const Vector3 &centre, const Vector3 &linear, const Vector3 &quadratic);

    Vector3 getForce(const RigidBody &body) const override;
    void updateForce(RigidBody *body, real duration) override;
    void addResistance(const RigidBody &body, Resistance &sum) const override;

private:
    Vector3 flowInBodyAxes(const RigidBody &body) const;
    Vector3 getForceOf(const Vector3 &flow, real submersion, const RigidBody &body) const;
    /// −∂force/∂flow along each body axis.
    Vector3 resistanceTo(const Vector3 &flow, real submersion) const;

    const Buoyancy *hull;
    Vector3 linear, quadratic;
};

}  // namespace cyclone
