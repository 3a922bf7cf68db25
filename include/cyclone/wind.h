#pragma once

/// @file
/// Wind that differs from place to place: the shear above the ground, thermals, turbulence.
///
/// A field answers one question: how does the air move at this point? A surface that is given a field
/// (Aero::setWind and the like) asks at its own position, so the two tips of a wing can feel different air,
/// and an aircraft that banks at the edge of a thermal is rolled out of it.
///
///     WindGradient breeze(Vector3(6, 0, 0), 10);          // 6 m/s towards +X at 10 m, less below
///     Thermal thermal(Vector3(300, 0, 0), 3, 80, 1200);   // rises at up to 3 m/s
///     WindSum air;
///     air.add(&breeze);
///     air.add(&thermal);
///     leftWing.setWind(&air);
///
/// A field's velocity is the way the air goes, m/s in world coordinates, Y up. The `windspeed` of surfaces
/// has the opposite sign: it points to where the wind comes from. A surface that has both adds them up: its
/// flow is the velocity of its point + windspeed − the field's velocity.
#include <cyclone/core.h>

#include <cstdint>
#include <vector>

namespace cyclone {

/// Air in motion. Derive from it for a wind of your own. Several threads may read it at once when the World
/// has workers, so reading must not change it; the program changes it between two frames.
class CYCLONE_API WindField {
public:
    virtual ~WindField() = default;
    /// Where the air at a world point goes, m/s, world coordinates.
    virtual Vector3 getVelocity(const Vector3 &worldPoint) const = 0;

protected:
    WindField() = default;
    WindField(const WindField &) = default;
    WindField &operator=(const WindField &) = default;
};

/// The shear above the ground, where friction slows the wind, by the power law of wind engineering:
///
///     velocity = velocityAtReference·(y / referenceHeight)^exponent
///
/// over ground at y = 0, below which the air is still. Gliders feel it when they land: the headwind that
/// carried them fades.
class CYCLONE_API WindGradient : public WindField {
public:
    /// velocityAtReference in m/s, finite; referenceHeight in m, positive; exponent finite and not negative:
    /// 1/10 over open water, 1/7 over grassland, 1/4 over suburbs.
    WindGradient(const Vector3 &velocityAtReference, real referenceHeight, real exponent = 1.0 / 7);
    Vector3 getVelocity(const Vector3 &worldPoint) const override;

private:
    Vector3 velocityAtReference;
    real referenceHeight, exponent;
};

/// A thermal: warm air that rises in a core and sinks around it. With r the horizontal distance from the axis
/// and z the height above the foot, the air rises at
///
///     w = strength·(27/4)·(z/top)·(1 − z/top)²·(1 − (r/radius)²)·exp(−(r/radius)²)
///
/// Across, it is the profile of Gedeon (1973), whose net flow through each level is zero: as much sinks
/// outside of `radius` as rises within. Upwards, it is nothing at the ground, strongest at a third of the top
/// and fades towards the top, much as Lenschow and Stephens (1980) measured. The air that the core needs
/// flows in below and out above, so that its volume is preserved everywhere:
///
///     towards the axis: (r/2)·exp(−(r/radius)²)·dw/dz on the axis
///
/// Above the top and beyond six radii the air is still.
class CYCLONE_API Thermal : public WindField {
public:
    /// foot: the point of the ground below the axis, m, world; finite. strength: how fast the core rises at
    /// most, m/s, finite; a negative one is a downburst. radius (m) of the rising core and top (m above the
    /// foot), positive.
    Thermal(const Vector3 &foot, real strength, real radius, real top);

    /// Moves the thermal, as when it drifts with the wind.
    void setFoot(const Vector3 &worldPoint);
    Vector3 getFoot() const { return foot; }

    Vector3 getVelocity(const Vector3 &worldPoint) const override;

private:
    Vector3 foot;
    real strength, radius, top;
};

/// Several fields at once: the sum of their velocities. It owns none of them; they must outlive it.
class CYCLONE_API WindSum : public WindField {
public:
    /// Not null.
    void add(const WindField *field);
    Vector3 getVelocity(const Vector3 &worldPoint) const override;

private:
    std::vector<const WindField *> fields;
};

/// The gusts that an aircraft meets on its way: random velocities with the spectra of Dryden, as the military
/// specification MIL-F-8785C prescribes them for low altitude. Sums with the mean wind in a WindSum.
///
/// Turbulence is random over distance, as if frozen while the aircraft flies through it (Taylor's
/// hypothesis). Along the flight (u), across it (v) and up (w), at Ω radians of gust per metre of way, the
/// spectra are
///
///     Φu = σu²·(2·Lu/π) / (1 + (Lu·Ω)²)
///     Φv = σv²·(Lv/π)·(1 + 3·(Lv·Ω)²) / (1 + (Lv·Ω)²)²,    Φw alike
///
/// each with the integral σ² over Ω > 0. With h the height in feet and W the mean wind at 20 feet:
///
///     Lw = h,       Lu = Lv = h / (0.177 + 0.000823·h)^1.2
///     σw = 0.1·W,   σu = σv = σw / (0.177 + 0.000823·h)^0.4
///
/// Each step is exact however long it is: neither variance nor spectrum depends on it. The gust is one
/// velocity for all points, right for a craft that is small against the gusts; each craft has its own. A copy
/// goes on with the same gusts, and a seed gives the same ones on every machine.
class CYCLONE_API Turbulence : public WindField {
public:
    /// Mean wind 6 m (20 feet) above the ground, m/s, finite and not negative: 8 is light turbulence, 15
    /// moderate, 23 severe. No gust yet.
    explicit Turbulence(real windAt6Metres, std::uint64_t seed = 0);

    /// Lets the wind freshen or calm down; the gusts follow at the next step.
    void setWindAt6Metres(real speed);
    real getWindAt6Metres() const { return windAt6Metres; }

    /// Makes the gust at the end of a step. velocityThroughAir in m/s, world coordinates, finite: its length
    /// times the duration is the way through the gusts, and its horizontal direction is that of u. In
    /// vertical flight the last such direction stays, at first +X. height above the ground in m, finite,
    /// taken into the model's range of 3 to 305 m. duration in s, finite and not negative.
    void advance(const Vector3 &velocityThroughAir, real height, real duration);

    Vector3 getVelocity(const Vector3 &) const override { return gust; }

private:
    /// A gust across the flight and what is left of it later: white noise through 1/(1 + p) and again.
    struct Transverse {
        real once, twice;
        void start(const real (&normal)[2]);
        void advance(real way, const real (&normal)[2]);
        real getGust() const;
    };

    std::uint64_t nextBits();
    /// Two independent numbers of normal distribution, variance 1.
    void drawNormals(real (&normal)[2]);

    real windAt6Metres;
    std::uint64_t bits;
    Vector3 forward = Vector3::X;
    real along;  ///< u, of variance 1
    Transverse across, up;
    Vector3 gust;
};

}  // namespace cyclone
