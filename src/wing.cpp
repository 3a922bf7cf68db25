#include <cyclone/wing.h>

#include "arguments.h"

namespace cyclone {

using namespace detail;

namespace {

/// What a plain flap does to attached flow, per rad (Glauert 1927, thin airfoils): `lift` as a change of the
/// zero-lift angle, `moment` about the quarter chord.
struct FlapEffect {
    real lift, moment;
};

FlapEffect findFlapEffect(real flapChord) {
    const real cosine = 2 * flapChord - 1;  // x = (1 − cos θ)/2 of the chord, at the hinge
    const real sine = 2 * real_sqrt(flapChord * (1 - flapChord));
    return {1 - (real_acos(cosine) - sine) / REAL_PI, -0.5 * sine * (1 - cosine)};
}

/// How much of that is left in a real flow: 0.8 at 10°, 0.4 at 60° (a fit to McCormick 1995, fig. 3.33).
real flapEffectiveness(real flapAngle) { return 0.95 / (1 + 1.5 * real_abs(flapAngle)); }

/// Of the drag broadside, relative to an infinite span; at most 1 (Viterna & Corrigan 1982).
real plateDragFactor(real aspectRatio) { return real_clamp((1.11 + 0.018 * aspectRatio) / 1.98, 0, 1); }

}  // namespace

// ---- The section

const char *WingSection::findError() const {
    if (!(liftSlope > 0 && liftSlope <= REAL_MAX)) return "the lift's slope must be positive and finite";
    if (!(stallAngle > 0 && stallAngle < REAL_PI / 2)) return "the stall must be between 0 and pi/2";
    if (!(real_abs(zeroLiftAngle) < stallAngle))
        return "the zero-lift angle must be closer to 0 than the stall";
    if (!real_isfinite(zeroLiftMoment)) return "the zero-lift moment must be finite";
    if (!(leastDrag >= 0 && leastDrag <= REAL_MAX)) return "the least drag must be finite and not negative";
    if (!(plateDrag >= 0 && plateDrag <= REAL_MAX)) return "the plate's drag must be finite and not negative";
    return nullptr;
}

namespace {

void requireSection(const WingSection &section, const char *function) {
    const char *error = section.findError();
    if (error != nullptr)
        reject(function, error,
               {section.liftSlope, section.zeroLiftAngle, section.zeroLiftMoment, section.leastDrag,
                section.stallAngle, section.plateDrag});
}

void requireFlapChord(real flapChord, const char *function) {
    require(flapChord >= 0 && flapChord <= 1, function, "the flap's part of the chord must be 0 to 1",
            {flapChord});
}

}  // namespace

WingSection::Coefficients WingSection::getCoefficients(real angleOfAttack, real flapAngle,
                                                       real flapChord) const {
    const char *function = "WingSection::getCoefficients";
    requireSection(*this, function);
    requireFinite(angleOfAttack, function, "the angle of attack must be finite");
    requireFinite(flapAngle, function, "the flap's angle must be finite");
    requireFlapChord(flapChord, function);
    const WingCurve curve(*this, flapAngle, flapChord, std::numeric_limits<real>::infinity());
    return curve.respondTo(real_sin(angleOfAttack), real_cos(angleOfAttack)).coefficients;
}

// ---- The curve

// A flap that is turned by δ and takes up E of the chord turns the line from leading to trailing edge by
// about E·δ: that line is the plate when the flow has separated, and decides when it does. The rest of what
// the flap does to the lift is camber.
//
// The wing's own downwash reduces the angle at which its section meets the air by lift/(π·AR).
WingCurve::WingCurve(const WingSection &section, real flapAngle, real flapChord, real aspectRatio)
    : cosFlapTurn(real_cos(flapChord * flapAngle)),
      sinFlapTurn(real_sin(flapChord * flapAngle)),
      inducedDrag(1 / (REAL_PI * aspectRatio)),
      leastDrag(section.leastDrag),
      plateDrag(section.plateDrag * plateDragFactor(aspectRatio)) {
    const FlapEffect flap = findFlapEffect(flapChord);
    const real camber = flapEffectiveness(flapAngle) * flapAngle;
    sinZeroLift = real_sin(section.zeroLiftAngle - (flap.lift - flapChord) * camber);
    zeroLiftMoment = section.zeroLiftMoment + flap.moment * camber;

    const real downwash = section.liftSlope * inducedDrag;
    liftSlope = section.liftSlope / (1 + downwash);
    stallScale = 1 / ((1 + downwash) * real_sin(section.stallAngle));
    stallOffset = downwash * sinZeroLift * stallScale;
    // The derivative of 1/(1 + p¹⁶) is 16·attached·(1 − attached)/p, where p is near 1 or −1.
    steepestStall = 20 * (liftSlope + plateDrag) * (1 + real_abs(sinZeroLift) / real_sin(section.stallAngle));
}

bool WingCurve::isStalled(real sine, real cosine) const {
    return real_abs(getStallProgress(getLineSine(sine, cosine))) > 1;
}

namespace {

/// The part of the flow that is attached: a half at the stall, 1/(1 + p¹⁶).
real getAttached(real stallProgress) {
    const real p2 = stallProgress * stallProgress, p4 = p2 * p2, p8 = p4 * p4;
    return 1 / (1 + p8 * p8);
}

/// Between a (part 0) and b (part 1).
real blend(real a, real b, real part) { return a + part * (b - a); }

}  // namespace

// Angles from the flow to the line from leading to trailing edge. Flow from behind is met alike, hence the
// cosines: attached lift and moment act at the quarter chord that the flow meets first, and on a plate the
// centre of pressure moves from near there to the middle (Hoerner 1965, cosine in place of his 1 − 2α/π).
inline WingCurve::Response WingCurve::respondTo(real sine, real cosine) const {
    const real s = getLineSine(sine, cosine), c = cosine * cosFlapTurn - sine * sinFlapTurn;
    const real attached = getAttached(getStallProgress(s));

    const real lift = liftSlope * c * (s - sinZeroLift);
    const real moment = zeroLiftMoment * c - lift * c * (0.25 - 0.25 * c);
    const real plateForce = plateDrag * s;  // across the plate
    const real plateMoment = -plateForce * (0.25 - 0.175 * c);
    return {{blend(plateForce * c, lift, attached),
             leastDrag + blend(plateForce * s, inducedDrag * lift * lift, attached),
             blend(plateMoment, moment, attached)},
            blend(2 * plateDrag + steepestStall * attached, liftSlope + 2 * real_abs(lift), attached)};
}

// ---- The wing

Wing::Wing(real spanLength, real chordLength, const Vector3 &p, const Vector3 *wind)
    : PointForce("Wing::Wing", p),
      span(spanLength),
      chord(chordLength),
      windspeed(wind),
      aspectRatio(spanLength / chordLength) {
    requirePositive(span, "Wing::Wing", "the span must be positive and finite");
    requirePositive(chord, "Wing::Wing", "the chord must be positive and finite");
    requirePositive(aspectRatio, "Wing::Wing", "span over chord must be positive and finite");
    wingToBody.setOrientation(orientation);
    updateCurve();
}

void Wing::setSection(const WingSection &value) {
    requireSection(value, "Wing::setSection");
    section = value;
    updateCurve();
}

void Wing::setDensity(real value) {
    requirePositive(value, "Wing::setDensity", "the density must be positive and finite");
    density = value;
}

void Wing::setAspectRatio(real ratio) {
    requirePositive(ratio, "Wing::setAspectRatio", "the aspect ratio must be positive and finite");
    aspectRatio = ratio;
    updateCurve();
}

void Wing::setFlap(real chordFraction, real maxAngle) {
    requireFlapChord(chordFraction, "Wing::setFlap");
    require(maxAngle >= 0 && maxAngle <= REAL_PI / 2, "Wing::setFlap",
            "the flap's greatest angle must be 0 to pi/2", {maxAngle});
    flapChord = chordFraction;
    maxFlapAngle = maxAngle;
    updateCurve();
}

void Wing::setControl(real value) {
    requireFinite(value, "Wing::setControl", "the control must be finite");
    control = real_clamp(value, -1, 1);
    updateCurve();
}

void Wing::setOrientation(const Quaternion &q) {
    requireRotation(q, "Wing::setOrientation", "the quaternion must be finite and not zero");
    orientation = q;
    orientation.normalise();
    wingToBody.setOrientation(orientation);
    isTurned = orientation != Quaternion();
}

void Wing::setWater(const Water *sea, real depth, real kilogramsPerCubicMetre) {
    requirePositive(depth, "Wing::setWater", "fullDepth must be positive and finite");
    requirePositive(kilogramsPerCubicMetre, "Wing::setWater", "the density must be positive and finite");
    water = sea;
    fullDepth = depth;
    density = kilogramsPerCubicMetre;
}

void Wing::updateCurve() { curve = WingCurve(section, control * maxFlapAngle, flapChord, aspectRatio); }

real Wing::immerse(const RigidBody &body, Vector3 &velocity) const {
    const Vector3 point = body.getPointInWorldSpace(position);
    const Water::Motion motion = water->getMotion(point);
    velocity -= motion.velocity;
    return real_clamp((motion.height - point.y) / fullDepth, 0, 1);
}

inline Wing::Flow Wing::getFlow(const RigidBody &body) const {
    const Vector3 arm = body.getDirectionInWorldSpace(position);
    const Vector3 axis = isTurned ? body.getDirectionInWorldSpace(wingToBody.getAxisVector(2))
                                  : body.getTransform().getAxisVector(2);
    real scale = 0.5 * density * span * chord;
    Vector3 velocity = body.getVelocity() + body.getRotation() % arm;
    if (windspeed != nullptr) velocity += *windspeed;
    if (windField != nullptr) velocity -= windField->getVelocity(body.getPointInWorldSpace(position));
    if (water != nullptr) scale *= immerse(body, velocity);

    const Vector3 local = body.getDirectionInLocalSpace(velocity);
    const Vector3 u = isTurned ? wingToBody.transformTranspose(local) : local;
    const real square = u.x * u.x + u.y * u.y;
    if (square < 1e-300) return {u, 0, 0, 1, scale, arm, axis};
    const real speed = real_sqrt(square);
    const real inverse = speed * (1 / square);  // the division does not wait for the root
    return {u, speed, -u.y * inverse, u.x * inverse, scale, arm, axis};
}

// The lift's direction is (−y, x)/speed, exactly across the flow.
inline Vector3 Wing::getForceBy(const Flow &flow, const WingSection::Coefficients &c,
                                const RigidBody &body) const {
    const Vector3 &u = flow.velocity;
    const real lift = flow.scale * flow.speed * c.lift, drag = flow.scale * flow.speed * c.drag;
    const real friction = flow.scale * section.leastDrag * real_abs(u.z);
    const Vector3 force(-lift * u.y - drag * u.x, lift * u.x - drag * u.y, -friction * u.z);
    return body.getDirectionInWorldSpace(isTurned ? wingToBody * force : force);
}

// The couple may drive the rotation, as in a wing that tumbles; but not by more than the power that the drag
// takes, lest the wing gain energy from still air.
inline Vector3 Wing::getTorqueBy(const Flow &flow, const WingSection::Coefficients &c,
                                 const RigidBody &body) const {
    const real pressure = flow.scale * flow.speed * flow.speed, pitching = body.getRotation() * flow.axis;
    const real dragPower = pressure * flow.speed * c.drag;
    real moment = pressure * chord * c.moment;
    if (moment * pitching > dragPower) moment = dragPower / pitching;
    return flow.axis * (moment - getPitchDamping(flow) * pitching);
}

inline real Wing::getPitchDamping(const Flow &flow) const {
    return REAL_PI / 8 * flow.scale * chord * chord * flow.speed;
}

Vector3 Wing::getForce(const RigidBody &body) const {
    const Flow flow = getFlow(body);
    return getForceBy(flow, curve.respondTo(flow.sine, flow.cosine).coefficients, body);
}

Vector3 Wing::getTorque(const RigidBody &body) const {
    const Flow flow = getFlow(body);
    return getTorqueBy(flow, curve.respondTo(flow.sine, flow.cosine).coefficients, body);
}

real Wing::getAngleOfAttack(const RigidBody &body) const {
    const Flow flow = getFlow(body);
    return real_atan2(flow.sine, flow.cosine);
}

bool Wing::isStalled(const RigidBody &body) const {
    const Flow flow = getFlow(body);
    return curve.isStalled(flow.sine, flow.cosine);
}

// Along the flow, across it and along the span, N·s/m: no less than what the force changes by, in whatever
// direction, when the flow changes in that one. To tell exactly what it changes by would do harm: a step that
// is long for a wing goes from one side of the stall to the other.
inline Vector3 Wing::getResistance(const Flow &flow, const WingCurve::Response &response) const {
    const real lift = real_abs(response.coefficients.lift), drag = response.coefficients.drag;
    const real scale = flow.scale * flow.speed;
    return Vector3(scale * (2 * drag + 5 * lift), scale * (3 * (drag + lift) + response.slopeBound),
                   2 * flow.scale * section.leastDrag * real_abs(flow.velocity.z));
}

/// Of the couple, to rotation about the span, N·m·s: its damping, and how it answers to the flow by the arm.
inline real Wing::getCoupleResistance(const Flow &flow, const Vector3 &resistance) const {
    return getPitchDamping(flow) + resistance.y * chord * position.magnitude();
}

void Wing::updateForce(RigidBody *body, real) {
    const Flow flow = getFlow(*body);
    const WingCurve::Response response = curve.respondTo(flow.sine, flow.cosine);
    const Vector3 force = getForceBy(flow, response.coefficients, *body);
    body->addWrench({force, flow.arm % force + getTorqueBy(flow, response.coefficients, *body)});

    const Vector3 resistance = getResistance(flow, response);
    const real greatest = resistance.y + resistance.z;
    body->addResistance(greatest,
                        greatest * position.squareMagnitude() + getCoupleResistance(flow, resistance));
}

void Wing::addResistance(const RigidBody &body, Resistance &sum) const {
    const Flow flow = getFlow(body);
    const Vector3 resistance = getResistance(flow, curve.respondTo(flow.sine, flow.cosine));
    const Vector3 along(flow.cosine, -flow.sine, 0), across(flow.sine, flow.cosine, 0);
    Matrix3 turn;
    turn.setOrientation(body.getOrientation());
    turn = turn * wingToBody * Matrix3(along, across, Vector3::Z);
    Matrix3 tensor;
    tensor.setDiagonal(-resistance.x, -resistance.y, -resistance.z);
    sum.add(turn * tensor * turn.transpose(), flow.arm, true);

    const Vector3 couple = flow.axis * -getCoupleResistance(flow, resistance);
    sum.torqueByRotation += Matrix3(couple * flow.axis.x, couple * flow.axis.y, couple * flow.axis.z);
}

}  // namespace cyclone
