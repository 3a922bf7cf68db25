#pragma once

/// @file
/// Buoyancy, and the water that bodies float in.
#include <cyclone/force.h>

#include <vector>

namespace cyclone {

/// A surface of water. Derive from it for a sea of your own.
class CYCLONE_API Water {
public:
    virtual ~Water() = default;
    /// World height (m) of the surface above or below a world point.
    virtual real getHeight(const Vector3 &worldPoint) const = 0;
};

/// A sea with waves: the sum of trains of sine waves on deep water, whose speed follows from their length,
/// ω² = g·k (Airy 1845).
class CYCLONE_API Waves : public Water {
public:
    /// amplitude·sin(k·s − ω·t + phase), where s runs along `direction` and k = 2π/wavelength.
    struct Train {
        real amplitude = 0;   ///< m, half the height of the waves
        real wavelength = 1;  ///< m
        real direction = 0;   ///< rad, where the waves go: from +X towards +Z
        real phase = 0;       ///< rad
    };

    /// meanHeight in m; gravity in m/s², positive.
    explicit Waves(real meanHeight = 0, real gravity = 9.81);

    /// Amplitude finite and not negative, wavelength positive, angles finite.
    void addTrain(const Train &train);
    /// The moment (s) that getHeight tells of.
    void setTime(real seconds);
    real getTime() const { return time; }

    real getHeight(const Vector3 &worldPoint) const override;

private:
    struct Motion {
        real amplitude, alongX, alongZ, frequency, phase;
        real phaseNow;  ///< ω·t − phase, at the time set
    };

    real meanHeight, gravity;
    real time = 0;
    std::vector<Motion> motions;
};

/// The buoyancy of a hull, or of a part of one, that is wholly under water when its centre is maxDepth below
/// the surface, and out of it maxDepth above:
///
///     force = density·volume·gravity·clamp((h + maxDepth − y)/(2·maxDepth), 0, 1), upwards,
///
/// with y the height of the centre of buoyancy and h that of the water: the weight of the displaced water
/// (Archimedes).
class CYCLONE_API Buoyancy : public ForceGenerator {
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
    /// The force on the body as it lies now, N, world coordinates.
    Vector3 getForce(const RigidBody &body) const;

    void updateForce(RigidBody *body, real duration) override;
    bool actsOnItsBodyOnly() const override { return true; }

private:
    Vector3 centreOfBuoyancy;
    real maxDepth, volume, waterHeight, liquidDensity, gravity;
    const Water *water = nullptr;
};

}  // namespace cyclone
