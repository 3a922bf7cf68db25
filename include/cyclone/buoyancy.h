#pragma once

/// @file
/// What makes bodies float.
#include <cyclone/force.h>
#include <cyclone/water.h>

namespace cyclone {

/// The buoyancy of a hull, or of a part of one, that is wholly under water when its centre is maxDepth below
/// the surface, and out of it maxDepth above:
///
///     force = density·volume·gravity·clamp((h + maxDepth − y)/(2·maxDepth), 0, 1), upwards,
///
/// with y the height of the centre of buoyancy and h that of the water: the weight of the displaced water
/// (Archimedes).
class CYCLONE_API Buoyancy : public PointForce {
public:
    /// centreOfBuoyancy in body coordinates, m; maxDepth (m), volume (m³), liquidDensity (kg/m³) and gravity
    /// (m/s²) positive; waterHeight (m) of still water, world.
    Buoyancy(const Vector3 &centreOfBuoyancy, real maxDepth, real volume, real waterHeight,
             real liquidDensity = 1000, real gravity = 9.81);

    /// Water with waves in place of still water; read at each frame, it must live as long as the hull floats
    /// in it. Null is still water at the height given to the constructor.
    void setWater(const Water *surface) { water = surface; }

    /// The part of the volume that is under water now, 0 … 1.
    real getSubmersion(const RigidBody &body) const;
    Vector3 getForce(const RigidBody &body) const override;

private:
    real submersionAt(real centreHeight, real surfaceHeight) const;

    real maxDepth, volume, waterHeight, liquidDensity, gravity;
    const Water *water = nullptr;
};

}  // namespace cyclone
