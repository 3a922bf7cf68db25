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
    return curve.getCoefficients(real_sin(angleOfAttack), real_cos(angleOfAttack));
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
}

bool WingCurve::isStalled(real sine, real cosine) const {
    return real_abs(getStallProgress(sine * cosFlapTurn + cosine * sinFlapTurn)) > 1;
}

namespace {

/// Between a (part 0) and b (part 1).
real blend(real a, real b, real part) { return a + part * (b - a); }

}  // namespace

// Angles from the flow to the line from leading to trailing edge. Flow from behind is met alike, hence the
// cosines: attached lift and moment act at the quarter chord that the flow meets first, and on a plate the
// centre of pressure moves from near there to the middle (Hoerner 1965, cosine in place of his 1 − 2α/π).
inline WingSection::Coefficients WingCurve::getCoefficients(real sine, real cosine) const {
    const real s = sine * cosFlapTurn + cosine * sinFlapTurn;
    const real c = cosine * cosFlapTurn - sine * sinFlapTurn;
    const real progress = getStallProgress(s);
    const real p2 = progress * progress, p4 = p2 * p2, p8 = p4 * p4;
    const real attached = 1 / (1 + p8 * p8);

    const real lift = liftSlope * c * (s - sinZeroLift);
    const real moment = zeroLiftMoment * c - lift * c * (0.25 - 0.25 * c);
    const real plateForce = plateDrag * s;  // across the plate
    const real plateMoment = -plateForce * (0.25 - 0.175 * c);
    return {blend(plateForce * c, lift, attached),
            leastDrag + blend(plateForce * s, inducedDrag * lift * lift, attached),
            blend(plateMoment, moment, attached)};
}

// ---- The wing

Wing::Wing(real spanLength, real chordLength, const Vector3 &p, const Vector3 *windspeedAddress)
    : span(spanLength),
      chord(chordLength),
      position(p),
      windspeed(windspeedAddress),
      aspectRatio(spanLength / chordLength) {
    requirePositive(span, "Wing::Wing", "the span must be positive and finite");
    requirePositive(chord, "Wing::Wing", "the chord must be positive and finite");
    requireFinite(position, "Wing::Wing", "the position must be finite");
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
}

void Wing::updateCurve() { curve = WingCurve(section, control * maxFlapAngle, flapChord, aspectRatio); }

inline Wing::Flow Wing::getFlow(const RigidBody &body) const {
    Vector3 velocity = body.getVelocity() + body.getRotation() % body.getDirectionInWorldSpace(position);
    if (windspeed != nullptr) velocity += *windspeed;
    if (wind != nullptr) velocity -= wind->getVelocity(body.getPointInWorldSpace(position));
    const Vector3 u = wingToBody.transformTranspose(body.getDirectionInLocalSpace(velocity));
    const real square = u.x * u.x + u.y * u.y;
    if (square < 1e-300) return {u.x, u.y, u.z, 0, 0, 1};
    const real speed = real_sqrt(square);
    const real inverse = speed * (1 / square);  // the division does not wait for the root
    return {u.x, u.y, u.z, speed, -u.y * inverse, u.x * inverse};
}

// The lift's direction is (−y, x)/speed, exactly across the flow.
inline Wrench Wing::getWrench(const RigidBody &body) const {
    const Flow flow = getFlow(body);
    const WingSection::Coefficients c = curve.getCoefficients(flow.sine, flow.cosine);
    const real scale = 0.5 * density * span * chord;
    const real lift = scale * flow.speed * c.lift, drag = scale * flow.speed * c.drag;
    const real friction = scale * section.leastDrag * real_abs(flow.z);
    const Vector3 force(-lift * flow.y - drag * flow.x, lift * flow.x - drag * flow.y, -friction * flow.z);
    const real couple = scale * chord * flow.speed * flow.speed * c.moment;
    return {wingToBody * force, wingToBody.getAxisVector(2) * couple};
}

Vector3 Wing::getForce(const RigidBody &body) const {
    return body.getDirectionInWorldSpace(getWrench(body).force);
}

Vector3 Wing::getTorque(const RigidBody &body) const {
    return body.getDirectionInWorldSpace(getWrench(body).torque);
}

real Wing::getAngleOfAttack(const RigidBody &body) const {
    const Flow flow = getFlow(body);
    return real_atan2(flow.sine, flow.cosine);
}

bool Wing::isStalled(const RigidBody &body) const {
    const Flow flow = getFlow(body);
    return curve.isStalled(flow.sine, flow.cosine);
}

void Wing::updateForce(RigidBody *body, real) {
    const Wrench wrench = getWrench(*body);
    body->addWrench({body->getDirectionInWorldSpace(wrench.force),
                     body->getDirectionInWorldSpace(position % wrench.force + wrench.torque)});
}

}  // namespace cyclone
