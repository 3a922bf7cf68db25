#pragma once

/// The chapter's catamaran: two hulls that float and are resisted by the water, a sail, and a rudder that is
/// the daggerboard too.
///
/// Body axes +X bow, +Y up, +Z starboard, origin in the centre of mass. In the world +X is north, +Z east and
/// y = 0 the mean level of the water. Angles in rad; whatever has a side is positive to starboard.
#include <cyclone/aero.h>
#include <cyclone/buoyancy.h>
#include <cyclone/world.h>

#include <array>

#include "base/angle.h"

namespace sailboat {

using cyclone::Quaternion;
using cyclone::real;
using cyclone::Vector3;
using demo::bearing;
using demo::wrapAngle;

/// What a square stern costs that is dragged through the water backwards: nothing while she goes ahead.
class TransomDrag : public cyclone::HullDrag {
public:
    using HullDrag::HullDrag;
    Vector3 getForce(const cyclone::RigidBody &body) const override;
    void updateForce(cyclone::RigidBody *body, real duration) override;
    void addResistance(const cyclone::RigidBody &body, cyclone::Resistance &sum) const override;
};

/// A sail that draws above the water only: a capsized boat's does not.
class Sail : public cyclone::AngledAero {
public:
    Sail(const cyclone::Matrix3 &ownTensor, const Vector3 &centre, const Vector3 *wind,
         const cyclone::Water *sea)
        : AngledAero(ownTensor, centre, wind), surface(sea) {}
    Vector3 getForce(const cyclone::RigidBody &body) const override;
    void updateForce(cyclone::RigidBody *body, real duration) override;
    void addResistance(const cyclone::RigidBody &body, cyclone::Resistance &sum) const override;

private:
    bool isDry(const cyclone::RigidBody &body) const;

    const cyclone::Water *surface;
};

/// The boat, in a world. Its designer's numbers:
///
/// - Four half hulls of 0.22 m³ each, 0.8 m deep, carry 355 kg: they are 40 % under water, and the middle of
///   the hulls is 8 cm above the surface. One hull alone can carry the boat.
/// - The sail takes 46 times more force across its cloth than along it. For such a flat sail drive is
///   greatest when the boom bisects the angle between the stern and where the wind goes.
/// - Rudder and hulls together hold against side force at a point 0.6 m aft of the centre of mass. The sail's
///   centre of effort lies there too, so that the rudder has little to do on a straight course. The rudder
///   works as far as it is under water, the sail while its centre is above it.
/// - Her sterns are square: going astern she pushes water before them.
class Catamaran {
public:
    static constexpr real LENGTH = 6, HULL_SPACING = 2.8;  ///< m; between the hulls' middles
    static constexpr real HULL_HEIGHT = -0.55;             ///< y of the hulls' middles, m
    static constexpr real HULL_HALF_DEPTH = 0.4;           ///< m
    static constexpr real HALF_HULL_VOLUME = 0.22;         ///< m³
    static constexpr real MAX_RUDDER = 0.6;
    static constexpr real MAX_SHEET = 1.5;  ///< the shrouds stop the boom there
    static constexpr real HELD_OUT = 1.4;   ///< where a crew holds the boom to back the sail

    /// Adds the boat and its forces to the world, at rest, afloat at the origin, bow to the north. The wind
    /// (see aero.h) and the water are read at each step. All three must outlive the boat.
    Catamaran(cyclone::World &world, const Vector3 *windspeed, const cyclone::Water *water);
    ~Catamaran();
    Catamaran(const Catamaran &) = delete;
    Catamaran &operator=(const Catamaran &) = delete;

    /// Puts the boat afloat on an even keel at a point of the water, with this heading and speed ahead (m/s).
    void launch(real x, real z, real heading, real speed = 0);

    /// The rudder's trailing edge, to starboard positive: with way on, the boat turns that way. Within
    /// ±MAX_RUDDER.
    void setRudder(real angle);
    real getRudder() const { return rudderAngle; }
    /// How far the sheet lets the boom go to either side. Within 0 … MAX_SHEET.
    void setSheet(real angle);
    real getSheet() const { return sheet; }
    /// −1: the crew holds the boom out to port, against the wind if need be; 1: to starboard; 0: lets it go.
    void holdBoom(real side);
    real getHeldSide() const { return heldSide; }
    /// Lets the wind swing the boom to leeward until the sheet is taut or the sail flies like a flag. With
    /// the wind astern the boom stays on the side where it is. To be called before each step.
    void swingBoom(real duration);
    /// The boom, to starboard positive.
    real getSail() const { return boomAngle; }

    const cyclone::RigidBody &getBody() const { return body; }
    cyclone::RigidBody &getBody() { return body; }

    /// @name Readings
    /// @{
    real getHeading() const;   ///< of the bow, a compass direction
    real getSpeed() const;     ///< ahead through the water, m/s
    real getLeeway() const;    ///< sideways, m/s
    real getHeel() const;      ///< positive: the starboard side is down
    real getTrim() const;      ///< positive: the bow is up
    real getTurnRate() const;  ///< of the heading, rad/s
    /// Where the wind comes from, off the bow: −π … π, positive over the starboard side.
    real getTrueWindAngle() const;
    real getApparentWindAngle() const;
    real getApparentWindSpeed() const;  ///< m/s
    bool isCapsized() const;            ///< heeled by more than a right angle
    bool isInIrons() const;             ///< head to wind without way on: no trim of the sail helps
    /// @}

    /// @name Forces now, in N and world coordinates, and where they act
    /// @{
    Vector3 getSailForce() const { return sail.getForce(body); }
    Vector3 getRudderForce() const { return rudder.getForce(body); }
    /// Buoyancy of the half hull 0 … 3: port aft, port fore, starboard aft, starboard fore.
    Vector3 getBuoyancy(unsigned halfHull) const { return hulls[halfHull].getForce(body); }
    static Vector3 getHullCentre(unsigned halfHull);
    Vector3 getSailCentre() const { return sail.getPosition(); }
    Vector3 getRudderCentre() const { return rudder.getPosition(); }
    /// @}

private:
    Vector3 getApparentWind() const;
    void setBoom(real angle);
    real getBoomTarget() const;

    cyclone::World &world;
    const Vector3 *windspeed;
    const cyclone::Water *water;
    cyclone::RigidBody body;
    std::array<cyclone::Buoyancy, 4> hulls;
    std::array<cyclone::HullDrag, 4> drags;
    std::array<TransomDrag, 2> transoms;
    Sail sail;
    cyclone::AngledAero rudder;
    real rudderAngle = 0, sheet = 0, boomAngle = 0, heldSide = 0;
};

}  // namespace sailboat
