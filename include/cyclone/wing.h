#pragma once

/// @file
/// Wings that stall: lift and drag that grow with the square of the speed, at every angle of attack.
///
/// The angle of attack is that between the chord and the flow across the span; positive when the flow meets
/// the lower side. windspeed and WindField are those of aero.h.
#include <cyclone/force.h>
#include <cyclone/water.h>
#include <cyclone/wind.h>

namespace cyclone {

/// The section of a wing: what its lift, drag and moment are made of. The defaults are a symmetric section.
///
/// Attached flow is thin-airfoil theory, separated flow that past a flat plate, and the stall goes from one
/// to the other smoothly (after Khan & Nahon 2015, "Real-time modeling of agile fixed-wing UAV aerodynamics",
/// and Selig 2014, "Real-time flight simulation of highly maneuverable unmanned aerial vehicles").
struct CYCLONE_API WingSection {
    /// Of lift, drag and nose-up moment about the quarter chord: over ½·density·speed² and the area, the
    /// moment over the chord as well.
    struct Coefficients {
        real lift = 0, drag = 0, moment = 0;
    };

    real liftSlope = 2 * REAL_PI;  ///< of attached flow, per rad; positive
    real zeroLiftAngle = 0;        ///< rad, negative with camber; closer to 0 than the stall
    real zeroLiftMoment = 0;       ///< nose-up coefficient without lift, negative with camber
    real leastDrag = 0.01;         ///< coefficient of attached flow; not negative
    /// rad, less than π/2: where half of the lift of attached flow is lost, to both sides. The lift is
    /// greatest just before.
    real stallAngle = 0.26;
    real plateDrag = 1.98;  ///< coefficient broadside to the flow; not negative. 1.98: Hoerner 1965

    /// At any angle of attack (rad), for a wing of infinite span. A plain flap that takes up the rear
    /// `flapChord` of the chord, 0 … 1, is turned by flapAngle (rad, down is positive).
    Coefficients getCoefficients(real angleOfAttack, real flapAngle = 0, real flapChord = 0.25) const;

    /// The rule of the above that a number breaks; null if none does.
    const char *findError() const;
};

namespace detail {

/// A section with its flap at one angle, in a wing of one aspect ratio, in terms of the angle from the flow
/// to the line from leading to trailing edge.
struct WingCurve {
    real cosFlapTurn = 1, sinFlapTurn = 0;  ///< of the angle from the chord to that line
    real sinZeroLift = 0;
    real liftSlope = 0;
    real inducedDrag = 0;                  ///< per square of the lift
    real stallScale = 0, stallOffset = 0;  ///< to the sine of the section's angle, over that of the stall
    real steepestStall = 0;                ///< bound of the slopes that the stall adds
    real leastDrag = 0, zeroLiftMoment = 0;
    real plateDrag = 0;

    WingCurve() = default;
    WingCurve(const WingSection &section, real flapAngle, real flapChord, real aspectRatio);

    struct Response {
        WingSection::Coefficients coefficients;
        real slopeBound;  ///< no less than what lift and drag together grow by with the angle, per rad
    };

    /// From sine and cosine of the angle of attack.
    Response respondTo(real sine, real cosine) const;
    bool isStalled(real sine, real cosine) const;

private:
    real getLineSine(real sine, real cosine) const { return sine * cosFlapTurn + cosine * sinFlapTurn; }
    /// 1 or −1 at the stall.
    real getStallProgress(real lineSine) const { return stallScale * lineSine + stallOffset; }
};

}  // namespace detail

/// A wing, tailplane, fin or foil, or a piece of one:
///
///     force = ½·density·u²·span·chord·(lift across the flow, drag against it)
///
/// at a point of the body, and the couple of its section's moment, with u the velocity of that point through
/// the air, its own turning included. Pitching is damped as in thin-airfoil theory, π/8·chord/u per rad/s.
/// Wing axes: +X forward along the chord, +Y the side of lift, +Z along the span. The flow along the span
/// makes no lift; it meets friction, ½·density·u_z²·area·leastDrag. So the force never drives its point
/// through still air.
///
/// One flow counts for the whole wing: to damp roll, and to drop a wing in a stall, an aircraft needs at
/// least one Wing on each side. A wing far too large for the step (some 10 m² on 1 kg at 60 Hz) that is free
/// to turn can feed energy into the motion slowly: its lift turns the flow too far within one step.
///
/// Finite span is Prandtl's lifting line with elliptic lift: slope 2π·AR/(AR + 2), induced drag
/// lift²/(π·AR). When separated, the drag broadside falls with AR too (Viterna & Corrigan 1982).
class CYCLONE_API Wing : public PointForce {
public:
    /// Span and chord (m) are positive; position is that of the quarter chord in the middle of the span, in
    /// body coordinates. windspeed as for Aero.
    Wing(real span, real chord, const Vector3 &position, const Vector3 *windspeed);

    void setSection(const WingSection &section);
    const WingSection &getSection() const { return section; }
    /// Of the air, kg/m³; positive. 1.225 by default, the standard atmosphere's at sea level.
    void setDensity(real kilogramsPerCubicMetre);
    real getDensity() const { return density; }
    /// Span² over area of the whole wing of which this is a piece, positive; by default span/chord.
    void setAspectRatio(real ratio);
    real getAspectRatio() const { return aspectRatio; }

    /// A plain flap (aileron, elevator, rudder) that takes up the rear chordFraction of the chord, 0 … 1, and
    /// turns by up to maxAngle, 0 … π/2 rad, to either side. 1 is a wing that turns as a whole. None by
    /// default.
    void setFlap(real chordFraction, real maxAngle);
    /// −1 … 1; clamped. Finite. +1 turns the flap's trailing edge down, for more lift.
    void setControl(real value);
    real getControl() const { return control; }

    /// From wing axes to body axes. Any length but zero; it is made a unit quaternion. Turning does not move
    /// the position.
    void setOrientation(const Quaternion &wingToBody);
    Quaternion getOrientation() const { return orientation; }

    /// As Aero::setWind.
    void setWind(const WindField *field) { windField = field; }
    /// Puts the wing into water of this density, kg/m³, positive: a keel, a rudder, a hydrofoil. The flow is
    /// then that past the water too, and force and couple are multiplied by clamp(depth/fullDepth, 0, 1): out
    /// of the water it does nothing. fullDepth in m, positive. The water must live as long as the wing acts;
    /// null is none.
    void setWater(const Water *sea, real fullDepth, real kilogramsPerCubicMetre = 1000);

    Vector3 getForce(const RigidBody &body) const override;
    /// The couple, besides the force's moment about the centre of mass, N·m, world coordinates.
    Vector3 getTorque(const RigidBody &body) const;
    /// −π … π rad; 0 without a flow.
    real getAngleOfAttack(const RigidBody &body) const;
    /// Whether the flow has separated, to either side.
    bool isStalled(const RigidBody &body) const;

    void updateForce(RigidBody *body, real duration) override;
    void addResistance(const RigidBody &body, Resistance &sum) const override;

private:
    struct Flow {
        Vector3 velocity;   ///< through the air or water, in wing axes
        real speed;         ///< across the span
        real sine, cosine;  ///< of the angle of attack
        real scale;         ///< ½·density·area, of the part that feels the flow
        Vector3 arm, axis;  ///< of the position, and the direction of the span, in world coordinates
    };
    /// Takes the water's motion from the velocity; returns the part of the wing that is in the water.
    real immerse(const RigidBody &body, Vector3 &velocity) const;
    Flow getFlow(const RigidBody &body) const;
    Vector3 getForceBy(const Flow &flow, const WingSection::Coefficients &c, const RigidBody &body) const;
    Vector3 getTorqueBy(const Flow &flow, const WingSection::Coefficients &c, const RigidBody &body) const;
    /// N·m per rad/s.
    real getPitchDamping(const Flow &flow) const;
    Vector3 getResistance(const Flow &flow, const detail::WingCurve::Response &response) const;
    real getCoupleResistance(const Flow &flow, const Vector3 &resistance) const;
    void updateCurve();

    real span, chord;
    const Vector3 *windspeed;
    const WindField *windField = nullptr;
    const Water *water = nullptr;
    real fullDepth = 1;
    WingSection section;
    real density = 1.225;
    real aspectRatio;
    real flapChord = 0, maxFlapAngle = 0, control = 0;
    Quaternion orientation;
    Matrix3 wingToBody;
    bool isTurned = false;  ///< wingToBody is not the identity
    detail::WingCurve curve;
};

}  // namespace cyclone
