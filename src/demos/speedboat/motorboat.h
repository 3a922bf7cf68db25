#pragma once

/// The chapter's speedboat, and its hydrofoil: a hull that planes, an outboard motor that steers by turning
/// its thrust, and, if wanted, foils below the hull.
///
/// Body axes +X bow, +Y up, +Z starboard, origin in the centre of mass. In the world +X is north, +Z east and
/// y = 0 the mean level of the water. Angles in rad; whatever has a side is positive to starboard.
#include <cyclone/aero.h>
#include <cyclone/buoyancy.h>
#include <cyclone/propulsion.h>
#include <cyclone/wing.h>
#include <cyclone/world.h>

#include <vector>

namespace speedboat {

using cyclone::Quaternion;
using cyclone::real;
using cyclone::RigidBody;
using cyclone::Vector3;

enum class Hull { PLANING, FOILS };

/// The boat, in a world. Its designer's numbers:
///
/// - The hull is in six sections from stern to bow, on each side of the keel. Each floats, is resisted by the
///   water, and planes: its bottom is a wing that works on its lower side only, and so has half the lift of
///   one with water on both (Wagner 1932).
/// - The bottom is a V. A turn presses its outer half onto the water, and the boat leans inwards.
/// - 850 kg lie far aft. At rest the hull carries them by displacing water; from about 7 m/s on the bottom
///   does, on the hump that comes with the bow high.
/// - The foils rise outwards too. Each lifts as far as it is under water: the faster the boat, the less of
///   them is needed, and the higher it rides.
class Motorboat {
public:
    static constexpr real MASS = 850;                               ///< kg
    static constexpr real STERN = -1.24, BOW = 3.66;                ///< x, m
    static constexpr real BEAM = 1.7;                               ///< m
    static constexpr real KEEL = -0.45;                             ///< y, m
    static constexpr real MAX_STEERING = 0.5;                       ///< rad
    static constexpr real LEAST_TILT = -0.12, MOST_TILT = 0.3;      ///< rad
    static constexpr real SCREW_RADIUS = 0.14;                      ///< m
    static constexpr real MAX_THRUST = 4500;                        ///< N, standing still
    static constexpr real PITCH_SPEED = 28, FOIL_PITCH_SPEED = 18;  ///< m/s, of the screws of either boat

    /// A pair of foils, one on each side; m and rad.
    struct FoilPlan {
        real x, span, chord, incidence;
    };
    static constexpr FoilPlan FRONT_FOILS{1.5, 0.9, 0.2, 0.05}, AFT_FOILS{-1.8, 0.8, 0.2, 0.03};
    static constexpr real FOIL_Y = -1.15, FOIL_SIDE = 0.7, FOIL_DIHEDRAL = 0.35;
    static constexpr real FOIL_DEPTH = 0.7;  ///< m: deeper, a foil lifts no more

    /// Adds the boat and its forces to the world, at rest, afloat at the origin, bow to the north. The wind
    /// (see aero.h) and the water are read at each step. All three must outlive the boat.
    Motorboat(cyclone::World &world, const Vector3 *windspeed, const cyclone::Water *water, Hull hull);
    ~Motorboat();
    Motorboat(const Motorboat &) = delete;
    Motorboat &operator=(const Motorboat &) = delete;

    /// Puts the boat afloat on an even keel at a point of the water, with this heading, at rest, motor off.
    void launch(real x, real z, real heading);

    /// 0 … 1.
    void setThrottle(real value) { motor.setThrottle(value); }
    real getThrottle() const { return motor.getThrottle(); }
    /// Turns the motor: positive, the boat turns to starboard. Within ±MAX_STEERING.
    void setSteering(real angle);
    real getSteering() const { return steering; }
    /// Swings the motor's leg out from the stern: it then pushes downwards as well, and the bow comes up.
    /// Within LEAST_TILT and MOST_TILT.
    void setTilt(real angle);
    real getTilt() const { return tilt; }

    const RigidBody &getBody() const { return body; }
    RigidBody &getBody() { return body; }

    /// @name Readings
    /// @{
    real getSpeed() const;    ///< over the ground, m/s
    real getDraught() const;  ///< depth of the keel below the centre of mass, m; negative above the water
    real getWettedLength() const;  ///< of the bottom, m
    bool isScrewDry() const;       ///< all of it is above the surface
    bool isAirborne() const;       ///< neither hull nor foils touch the water
    bool isCapsized() const;       ///< heeled by more than a right angle
    /// @}

    /// @name Forces now, in N and world coordinates, and where they act
    /// @{
    Vector3 getThrust() const { return motor.getForce(body); }
    Vector3 getScrew() const { return motor.getPosition(); }
    /// By two for each section, to port and to starboard, from the stern on.
    const std::vector<cyclone::Buoyancy> &getFloats() const { return floats; }
    const std::vector<cyclone::Wing> &getBottom() const { return bottom; }
    /// Two in front, two aft, port first; none on the planing boat.
    const std::vector<cyclone::Wing> &getFoils() const { return foils; }
    /// @}

private:
    void addHull();
    void addFoils();
    void addFin(const Vector3 &position, real span, real chord);
    void registerForces();
    void aimMotor();
    real getDepth(const cyclone::PointForce &part) const;

    cyclone::World &world;
    const cyclone::Water *water;
    RigidBody body;
    std::vector<cyclone::Buoyancy> floats;
    std::vector<cyclone::HullDrag> drags;
    std::vector<cyclone::Wing> bottom, foils, fins;
    cyclone::Propeller motor;
    cyclone::Aero topsides;
    real steering = 0, tilt = 0;
};

}  // namespace speedboat
