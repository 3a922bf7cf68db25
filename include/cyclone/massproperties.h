#pragma once

/// @file
/// Mass, centre of mass and inertia tensor of solids, and of what is put together from them.
#include <cyclone/body.h>

namespace cyclone {

/// How heavy a solid is: Mass(2.5), or Density(700) times its volume.
class MassOrDensity {
public:
    real getMass(real volume) const { return byVolume ? amount * volume : amount; }

protected:
    MassOrDensity(real givenAmount, bool isByVolume) : amount(givenAmount), byVolume(isByVolume) {}

private:
    real amount;
    bool byVolume;
};

/// kg; positive and finite.
struct Mass : MassOrDensity {
    explicit Mass(real kilograms) : MassOrDensity(kilograms, false) {}
};

/// kg/m³; positive and finite. What has no volume needs a Mass.
struct Density : MassOrDensity {
    explicit Density(real kilogramsPerCubicMetre) : MassOrDensity(kilogramsPerCubicMetre, true) {}
};

/// The mass of a thing, where its centre is, and the inertia tensor about that centre. SI units.
///
/// A vehicle is built from parts in one drawing, whose axes become the body's axes:
///
///     MassProperties boat = MassProperties::box(Vector3(2, 0.3, 0.6), Mass(150));
///     boat += MassProperties::cylinder(0.05, 8, Density(700)).placedAt(Vector3(0.2, 4.3, 0));
///     boat.applyTo(body);
///
/// The origin of a RigidBody is its centre of mass. So a point p of the drawing, where a force is to act or a
/// mesh to be drawn, is p - boat.getCentre() in body coordinates.
///
/// Tensors of solids: any handbook of mechanics, such as Beer & Johnston, "Vector Mechanics for Engineers".
class CYCLONE_API MassProperties {
public:
    /// Nothing, of no mass: where adding parts begins.
    MassProperties() = default;
    /// Mass (kg, positive) around a centre (m), with the tensor (kg·m²) about the centre that any real thing
    /// has: symmetric, no principal moment negative, none greater than the other two together. All zeros is a
    /// point.
    MassProperties(real mass, const Vector3 &centre, const Matrix3 &inertiaTensor);

    /// @name Solids
    /// Of uniform density, centred at the origin, their axis along Y; lengths in m.
    /// @{

    /// From half its edges, not negative: a plate has one of 0, a rod has two.
    static MassProperties box(const Vector3 &halfSizes, const MassOrDensity &amount);
    /// Hollow up to innerRadius, which may be as great as the radius: a thin shell.
    static MassProperties sphere(real radius, const MassOrDensity &amount, real innerRadius = 0);
    /// From half its axes, positive.
    static MassProperties ellipsoid(const Vector3 &halfAxes, const MassOrDensity &amount);
    /// Hollow up to innerRadius, a thin tube at most. Of length 0 it is a disc.
    static MassProperties cylinder(real radius, real length, const MassOrDensity &amount,
                                   real innerRadius = 0);
    /// A cylinder between two half spheres, whose centres are `length` apart; of length 0, a sphere.
    static MassProperties capsule(real radius, real length, const MassOrDensity &amount);
    /// Its base is centred at the origin, its apex at (0, height, 0); its centre of mass at height/4.
    static MassProperties cone(real radius, real height, const MassOrDensity &amount);
    /// @}

    real getMass() const { return mass; }
    Vector3 getCentre() const { return centre; }
    /// About the centre, kg·m².
    Matrix3 getInertiaTensor() const { return inertiaTensor; }
    /// About another point, along the same axes (Huygens and Steiner).
    Matrix3 getInertiaTensorAbout(const Vector3 &point) const;

    /// The same thing as a part of a larger one: turned about the origin, from its own axes to the whole's,
    /// then moved.
    MassProperties placedAt(const Vector3 &position, const Quaternion &orientation = Quaternion()) const;

    /// Both together, rigidly joined.
    void operator+=(const MassProperties &part) { *this = *this + part; }
    MassProperties operator+(const MassProperties &part) const;

    /// Gives the body this mass and tensor; neither moves it nor changes its velocity or rotation. Refuses
    /// what turns without resistance about some axis, such as a point, a rod or nothing.
    void applyTo(RigidBody &body) const;

private:
    real mass = 0;
    Vector3 centre;
    Matrix3 inertiaTensor;
};

}  // namespace cyclone
