#include <cyclone/wing.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "frames.h"
#include "random.h"
#include "reference.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

constexpr real DEGREE = REAL_PI / 180, INFINITE = PLUS_INFINITY;
constexpr real RHO = 1.225;

WingSection cambered() {
    WingSection section;
    section.zeroLiftAngle = -4 * DEGREE;
    section.zeroLiftMoment = -0.1;
    section.leastDrag = 0.008;
    section.stallAngle = 14 * DEGREE;
    return section;
}

/// At an angle of attack, in straight flight at 10 m/s along the body's X axis or at a slip from it.
RigidBody flying(real angleOfAttack, real slip = 0) {
    RigidBody body;
    body.setVelocity(Vector3(std::cos(angleOfAttack) * std::cos(slip),
                             -std::sin(angleOfAttack) * std::cos(slip), std::sin(slip)) *
                     10);
    return body;
}

/// Lift and drag coefficients of a wing of 1 m² in that flight.
WingSection::Coefficients measure(const Wing &wing, real angleOfAttack) {
    const Vector3 force = wing.getForce(flying(angleOfAttack)) * (1 / (0.5 * RHO * 100));
    const real s = std::sin(angleOfAttack), c = std::cos(angleOfAttack);
    return {force.y * c + force.x * s, force.y * s - force.x * c, 0};
}

// ---- The section

TEST(WingSection, LiftsByThinAirfoilTheoryWhileAttached) {
    for (const WingSection &section : {WingSection(), cambered()}) {
        EXPECT_NEAR(section.getCoefficients(section.zeroLiftAngle).lift, 0, 1e-8);
        for (real degrees : {-3.0, -1.0, 2.0, 4.0, 6.0}) {
            const auto c = section.getCoefficients(degrees * DEGREE);
            const real theory = 2 * REAL_PI * (degrees * DEGREE - section.zeroLiftAngle);
            EXPECT_NEAR(c.lift, theory, 0.02 * std::fabs(theory)) << degrees;
            EXPECT_NEAR(c.drag, section.leastDrag, 1e-4);
            EXPECT_NEAR(c.moment, section.zeroLiftMoment, 2e-3);
        }
    }
}

TEST(WingSection, FollowsTheMeasuredOneThroughTheWholeCircle) {
    const reference::Table measured("naca0015_sandia.csv");
    WingSection section;
    section.stallAngle = 10 * DEGREE;
    section.leastDrag = 0.0115;
    real measuredPeak = 0, peak = 0;
    for (std::size_t row = 0; row < measured.size(); ++row) {
        const real degrees = measured.get(row, "alpha_deg");
        const auto c = section.getCoefficients(degrees * DEGREE);
        const real lift = measured.get(row, "cl"), drag = measured.get(row, "cd");
        if (degrees <= 9) {
            EXPECT_NEAR(c.lift, lift, 0.12) << degrees;
            EXPECT_NEAR(c.drag, drag, 0.015) << degrees;
        }
        if (degrees >= 20) {
            EXPECT_NEAR(c.lift, lift, 0.25) << degrees;
            EXPECT_NEAR(c.drag, drag, 0.3) << degrees;
        }
        if (degrees > 20) continue;
        measuredPeak = std::max(measuredPeak, lift);
        peak = std::max(peak, c.lift);
    }
    EXPECT_EQ(measured.size(), 59u);
    EXPECT_NEAR(peak, measuredPeak, 0.2 * measuredPeak);
}

TEST(WingSection, IsContinuousWithBoundedSlopesAllAround) {
    // The stall takes the lift away within about a fifth of its angle, so no slope is above ten times that of
    // attached flow; a jump would have a slope of 1e4 here.
    constexpr int STEPS = 200000;
    for (const WingSection &section : {WingSection(), cambered()})
        for (real flap : {-0.6, 0.0, 0.3}) {
            WingSection::Coefficients last = section.getCoefficients(-REAL_PI, flap);
            real steepest = 0;
            for (int n = 1; n <= STEPS; ++n) {
                const auto c = section.getCoefficients((2.0 * n / STEPS - 1) * REAL_PI, flap);
                for (real change : {c.lift - last.lift, c.drag - last.drag, c.moment - last.moment})
                    steepest = std::max(steepest, std::fabs(change) / (2 * REAL_PI / STEPS));
                last = c;
            }
            EXPECT_LT(steepest, 10 * section.liftSlope);
            EXPECT_GT(steepest, section.liftSlope);
        }
}

TEST(WingSection, TurnedUpsideDownIsItsMirrorImage) {
    WingSection up = cambered(), down = up;
    down.zeroLiftAngle = -up.zeroLiftAngle;
    down.zeroLiftMoment = -up.zeroLiftMoment;
    for (real angle = -3; angle < 3; angle += 0.1) {
        const auto a = up.getCoefficients(angle, 0.2), b = down.getCoefficients(-angle, -0.2);
        EXPECT_NEAR(a.lift, -b.lift, 1e-14);
        EXPECT_NEAR(a.drag, b.drag, 1e-14);
        EXPECT_NEAR(a.moment, -b.moment, 1e-14);
    }
}

TEST(WingSection, FlapShiftsTheLiftAsThinAirfoilTheorySays) {
    // Glauert's integral for the camber line of a plain flap, x = (1 − cos θ)/2; 0.95 is left in a real flow.
    for (real flapChord : {0.1, 0.25, 0.4}) {
        real shift = 0;
        constexpr int STEPS = 100000;
        for (int n = 0; n < STEPS; ++n) {
            const real theta = (n + 0.5) * REAL_PI / STEPS;
            if ((1 - std::cos(theta)) / 2 > 1 - flapChord) shift += (1 - std::cos(theta)) / STEPS;
        }
        const real flap = 1e-4, lift = WingSection().getCoefficients(0, flap, flapChord).lift;
        EXPECT_NEAR(lift / (2 * REAL_PI * flap), shift, 0.05 * shift);
    }
    // And its moment: cm = −½ sin θ (1 − cos θ) per rad; a quarter of the chord begins at θ = 120°.
    const real moment = WingSection().getCoefficients(0, 1e-4).moment / 1e-4;
    EXPECT_NEAR(moment, -0.75 * std::sqrt(0.75), 0.05);
}

TEST(WingSection, FlapGainsMoreLiftThanItsEarlierStallTakes) {
    real plain = 0, flapped = 0, plainAt = 0, flappedAt = 0;
    for (real angle = 0; angle < 0.4; angle += 0.001) {
        const real a = WingSection().getCoefficients(angle).lift;
        const real b = WingSection().getCoefficients(angle, 20 * DEGREE).lift;
        if (a > plain) plain = a, plainAt = angle;
        if (b > flapped) flapped = b, flappedAt = angle;
    }
    EXPECT_GT(flapped, plain + 0.3);
    EXPECT_LT(flappedAt, plainAt);
}

TEST(WingSection, FlapOfTheWholeChordTurnsTheWing) {
    for (real angle = -3; angle < 3; angle += 0.1) {
        const auto a = WingSection().getCoefficients(angle, 0.3, 1),
                   b = WingSection().getCoefficients(angle + 0.3);
        EXPECT_NEAR(a.lift, b.lift, 1e-13);
        EXPECT_NEAR(a.drag, b.drag, 1e-13);
        EXPECT_NEAR(a.moment, b.moment, 1e-13);
    }
}

TEST(WingSection, CentreOfPressureGoesFromTheQuarterToTheThreeQuarterPoint) {
    const auto leverAt = [](real angle) {
        const auto c = WingSection().getCoefficients(angle);
        return -c.moment / (c.lift * std::cos(angle) + c.drag * std::sin(angle));
    };
    EXPECT_NEAR(leverAt(2 * DEGREE), 0, 0.002);
    EXPECT_NEAR(leverAt(90 * DEGREE), 0.25, 0.005);
    EXPECT_NEAR(leverAt(178 * DEGREE), 0.5, 0.005);
}

TEST(WingSection, MayBeAsSteepAndAsThickAsNumbersGo) {
    WingSection section;
    section.liftSlope = section.leastDrag = section.plateDrag = REAL_MAX;
    EXPECT_EQ(section.findError(), nullptr);
}

TEST(WingSection, RefusesWhatNoWingHas) {
    const struct {
        const char *word;
        void (*spoil)(WingSection &);
    } errors[] = {{"slope", [](WingSection &s) { s.liftSlope = 0; }},
                  {"slope", [](WingSection &s) { s.liftSlope = INFINITE; }},
                  {"the stall must", [](WingSection &s) { s.stallAngle = 0; }},
                  {"the stall must", [](WingSection &s) { s.stallAngle = REAL_PI / 2; }},
                  {"zero-lift angle", [](WingSection &s) { s.zeroLiftAngle = s.stallAngle; }},
                  {"zero-lift angle", [](WingSection &s) { s.zeroLiftAngle = -0.3; }},
                  {"zero-lift angle", [](WingSection &s) { s.zeroLiftAngle = QUIET_NAN; }},
                  {"least drag", [](WingSection &s) { s.leastDrag = -0.01; }},
                  {"least drag", [](WingSection &s) { s.leastDrag = INFINITE; }},
                  {"plate's drag", [](WingSection &s) { s.plateDrag = -1; }},
                  {"plate's drag", [](WingSection &s) { s.plateDrag = INFINITE; }},
                  {"zero-lift moment", [](WingSection &s) { s.zeroLiftMoment = QUIET_NAN; }}};
    for (const auto &error : errors) {
        WingSection section;
        EXPECT_EQ(section.findError(), nullptr);
        error.spoil(section);
        ASSERT_NE(section.findError(), nullptr) << error.word;
        EXPECT_NE(std::string(section.findError()).find(error.word), std::string::npos) << error.word;
        EXPECT_THROW(section.getCoefficients(0), std::invalid_argument);
        Wing wing(1, 1, Vector3(), nullptr);
        EXPECT_THROW(wing.setSection(section), std::invalid_argument);
        EXPECT_EQ(wing.getSection().findError(), nullptr);
    }
    EXPECT_THROW(WingSection().getCoefficients(QUIET_NAN), std::invalid_argument);
    EXPECT_THROW(WingSection().getCoefficients(0, INFINITE), std::invalid_argument);
    EXPECT_THROW(WingSection().getCoefficients(0, 0, 1.1), std::invalid_argument);
}

TEST(WingSection, MayStallAsLateAsItLikes) {
    WingSection section;
    section.stallAngle = 1.57;
    EXPECT_EQ(section.findError(), nullptr);
}

TEST(WingSection, MayBeWithoutDrag) {
    WingSection section;
    section.leastDrag = 0;
    EXPECT_EQ(section.findError(), nullptr);
    EXPECT_NEAR(section.getCoefficients(0).drag, 0, 1e-15);
    section.plateDrag = 0;
    EXPECT_EQ(section.findError(), nullptr);
    EXPECT_NEAR(section.getCoefficients(REAL_PI / 2).drag, 0, 1e-15);
}

// ---- The wing

TEST(Wing, LiftsAsAnEllipticWingOfItsAspectRatio) {
    for (real ratio : {2.0, 6.0, 20.0}) {
        Wing wing(1, 1, Vector3(), nullptr);
        wing.setAspectRatio(ratio);
        const real angle = 1 * DEGREE;
        EXPECT_NEAR(measure(wing, angle).lift / angle, 2 * REAL_PI * ratio / (ratio + 2), 2e-3);
        wing.setSection(cambered());
        EXPECT_NEAR(measure(wing, -4 * DEGREE).lift, 0, 1e-8);
    }
}

TEST(Wing, HasAParabolicPolar) {
    Wing wing(std::sqrt(8.0), 1 / std::sqrt(8.0), Vector3(), nullptr);
    EXPECT_NEAR(wing.getAspectRatio(), 8, 1e-14);
    wing.setSection(cambered());
    for (real degrees = -8; degrees <= 6; ++degrees) {
        const auto c = measure(wing, degrees * DEGREE);
        EXPECT_NEAR(c.drag, 0.008 + c.lift * c.lift / (REAL_PI * 8), 2e-4) << degrees;
    }
}

TEST(Wing, WithoutBoundsToItsSpanIsItsSection) {
    Wing wing(1, 1, Vector3(), nullptr);
    wing.setSection(cambered());
    wing.setAspectRatio(1e12);
    wing.setFlap(0.3, 0.4);
    wing.setControl(0.5);
    for (real angle = -3; angle < 3; angle += 0.05) {
        const auto c = measure(wing, angle), section = cambered().getCoefficients(angle, 0.2, 0.3);
        EXPECT_NEAR(c.lift, section.lift, 1e-9);
        EXPECT_NEAR(c.drag, section.drag, 1e-9);
        EXPECT_NEAR(wing.getTorque(flying(angle)).z, 0.5 * RHO * 100 * section.moment, 1e-6);
    }
}

TEST(Wing, OfShortSpanStallsLaterAndHasLessDragBroadside) {
    Wing wing(1, 1, Vector3(), nullptr);
    const auto stallOf = [&wing](real ratio) {
        wing.setAspectRatio(ratio);
        real angle = 0;
        while (!wing.isStalled(flying(angle))) angle += 0.001;
        return angle;
    };
    // Where the angle less the downwash's, lift/(π·AR), is the section's; sines stand for angles.
    EXPECT_NEAR(std::sin(stallOf(1e9)), std::sin(0.26), 2e-3);
    EXPECT_NEAR(std::sin(stallOf(4)), std::sin(0.26) * (1 + 2.0 / 4), 2e-3);
    // Viterna & Corrigan: 1.11 + 0.018·AR, and no more than a plate of infinite span.
    wing.setAspectRatio(10);
    EXPECT_NEAR(measure(wing, REAL_PI / 2).drag, 1.11 + 0.18 + 0.01, 1e-4);
    wing.setAspectRatio(1000);
    EXPECT_NEAR(measure(wing, REAL_PI / 2).drag, 1.98 + 0.01, 1e-4);
}

TEST(Wing, ForceGrowsWithAreaDensityAndSquareOfSpeed) {
    Wing wing(6, 1, Vector3(), nullptr), large(12, 2, Vector3(), nullptr);
    const RigidBody body = flying(5 * DEGREE);
    RigidBody fast = body;
    fast.setVelocity(body.getVelocity() * 3);
    const Vector3 force = wing.getForce(body);
    EXPECT_GT(force.y, 100);
    EXPECT_TRUE(isNear(wing.getForce(fast), force * 9, 1e-10));
    EXPECT_TRUE(isNear(large.getForce(body), force * 4, 1e-10));
    EXPECT_TRUE(isNear(large.getTorque(body), wing.getTorque(body) * 8, 1e-10));
    wing.setDensity(0.6);
    EXPECT_TRUE(isNear(wing.getForce(body), force * (0.6 / RHO), 1e-10));
}

TEST(Wing, AtRestOrCarriedAlongNothingActs) {
    Vector3 windspeed;
    Wing wing(6, 1, Vector3(0, 0, 3), &windspeed);
    RigidBody body;
    EXPECT_EQ(wing.getForce(body), Vector3());
    EXPECT_EQ(wing.getTorque(body), Vector3());
    EXPECT_EQ(wing.getAngleOfAttack(body), 0);
    EXPECT_FALSE(wing.isStalled(body));
    body.setVelocity(-4, 1, 2);
    windspeed = Vector3(4, -1, -2);
    EXPECT_EQ(wing.getForce(body), Vector3());
}

/// Air that turns about the Y axis.
class Whirl : public WindField {
public:
    Vector3 getVelocity(const Vector3 &point) const override { return Vector3(0, 0.5, 0) % point; }
};

TEST(Wing, FlowIsItsVelocityThroughTheAirAtItsPosition) {
    const Vector3 windspeed(3, 1, -1), position(0.5, -0.2, 2);
    Random random(60);
    RigidBody body;
    body.setPosition(10, 20, 30);
    body.setOrientation(random.orientation());
    body.setVelocity(random.vector(20));
    body.setRotation(random.vector(2));
    const Whirl whirl;
    Wing wing(6, 1, position, &windspeed), plain(6, 1, Vector3(), nullptr);
    wing.setWind(&whirl);
    const Vector3 point = body.getPointInWorldSpace(position);
    RigidBody same = body;
    same.setRotation(0, 0, 0);
    same.setVelocity(body.getVelocity() + body.getRotation() % (point - body.getPosition()) + windspeed -
                     Vector3(0, 0.5, 0) % point);
    EXPECT_TRUE(isNear(wing.getForce(body), plain.getForce(same), 1e-9));
    EXPECT_GT(plain.getForce(same).magnitude(), 10);
    wing.setWind(nullptr);
    EXPECT_FALSE(isNear(wing.getForce(body), plain.getForce(same), 1));
}

TEST(Wing, TurnedInTheBodyIsTheBodyTurned) {
    Random random(61);
    for (int n = 0; n < 200; ++n) {
        const Quaternion r = random.orientation(), s = random.orientation();
        Wing turned(6, 1, Vector3(), nullptr), plain(6, 1, Vector3(), nullptr);
        turned.setSection(cambered());
        plain.setSection(cambered());
        turned.setOrientation(Quaternion(3 * s.r, 3 * s.i, 3 * s.j, 3 * s.k));
        EXPECT_TRUE(turnsLike(turned.getOrientation(), s, 1e-15));
        RigidBody body, whole;
        body.setOrientation(r);
        whole.setOrientation(r * s);
        body.setVelocity(random.vector(10));
        whole.setVelocity(body.getVelocity());
        EXPECT_TRUE(isNear(turned.getForce(body), plain.getForce(whole), 1e-10));
        EXPECT_TRUE(isNear(turned.getTorque(body), plain.getTorque(whole), 1e-10));
        EXPECT_NEAR(turned.getAngleOfAttack(body), plain.getAngleOfAttack(whole), 1e-13);
    }
}

TEST(Wing, SlipMakesNoLiftAndMeetsFriction) {
    Wing wing(6, 1, Vector3(), nullptr);
    const real angle = 5 * DEGREE, slip = 40 * DEGREE;
    const Vector3 straight = wing.getForce(flying(angle)), slipping = wing.getForce(flying(angle, slip));
    const real across = std::pow(std::cos(slip), 2), along = std::pow(std::sin(slip), 2);
    EXPECT_NEAR(slipping.y, straight.y * across, 1e-10);
    EXPECT_NEAR(slipping.x, straight.x * across, 1e-10);
    EXPECT_NEAR(slipping.z, -0.5 * RHO * 100 * along * 6 * 0.01, 1e-10);
    EXPECT_NEAR(wing.getAngleOfAttack(flying(angle, slip)), angle, 1e-14);
    EXPECT_LT(wing.getForce(flying(0, 90 * DEGREE)).z, 0);
}

TEST(Wing, NeverDrivesItsPointThroughStillAir) {
    Random random(62);
    for (int n = 0; n < 1000000; ++n) {
        WingSection section;
        section.stallAngle = random.between(0.05, 0.5);
        section.zeroLiftAngle = random.between(-0.9, 0.9) * section.stallAngle;
        section.leastDrag = random.between(1e-4, 0.05);
        Wing wing(random.between(0.5, 5), random.between(0.1, 2), random.vector(3), nullptr);
        wing.setSection(section);
        wing.setFlap(random.between(0, 1), random.between(0, 1.5));
        wing.setControl(random.between(-1, 1));
        wing.setOrientation(random.orientation());
        RigidBody body;
        body.setOrientation(random.orientation());
        body.setVelocity(random.vector(30));
        body.setRotation(random.vector(5));
        const Vector3 velocity =
            body.getVelocity() + body.getRotation() % body.getDirectionInWorldSpace(wing.getPosition());
        const real power = wing.getForce(body) * velocity;
        ASSERT_LT(power, 0) << n;
        ASSERT_LE(power + wing.getTorque(body) * body.getRotation(), -1e-12 * power) << n;
    }
}

TEST(Wing, PortAndStarboardAreMirrorImages) {
    Random random(63);
    for (int n = 0; n < 1000; ++n) {
        const Vector3 p = random.vector(2), v = random.vector(20), w = random.vector(3);
        const Quaternion q = random.orientation();
        Wing port(3, 1, p, nullptr), starboard(3, 1, Vector3(p.x, p.y, -p.z), nullptr);
        starboard.setOrientation(Quaternion(q.r, -q.i, -q.j, q.k));
        port.setOrientation(q);
        const real control = random.between(-1, 1);
        for (Wing *wing : {&port, &starboard}) {
            wing->setSection(cambered());
            wing->setFlap(0.25, 0.4);
            wing->setControl(control);
        }
        RigidBody body, image;
        body.setVelocity(v);
        body.setRotation(w);
        image.setVelocity(v.x, v.y, -v.z);
        image.setRotation(-w.x, -w.y, w.z);
        const Vector3 force = port.getForce(body), torque = port.getTorque(body);
        EXPECT_TRUE(isNear(starboard.getForce(image), Vector3(force.x, force.y, -force.z), 1e-10));
        EXPECT_TRUE(isNear(starboard.getTorque(image), Vector3(-torque.x, -torque.y, torque.z), 1e-10));
    }
}

TEST(Wing, UpAndDownAreMirrorImages) {
    Random random(64);
    Wing up(3, 1, Vector3(1, 0.5, 1), nullptr), down(3, 1, Vector3(1, -0.5, 1), nullptr);
    WingSection section = cambered();
    up.setSection(section);
    section.zeroLiftAngle *= -1;
    section.zeroLiftMoment *= -1;
    down.setSection(section);
    for (int n = 0; n < 1000; ++n) {
        const real control = random.between(-1, 1);
        up.setFlap(0.25, 0.4);
        up.setControl(control);
        down.setFlap(0.25, 0.4);
        down.setControl(-control);
        const Vector3 v = random.vector(20), w = random.vector(3);
        RigidBody body, image;
        body.setVelocity(v);
        body.setRotation(w);
        image.setVelocity(v.x, -v.y, v.z);
        image.setRotation(-w.x, w.y, -w.z);
        const Vector3 force = up.getForce(body), torque = up.getTorque(body);
        EXPECT_TRUE(isNear(down.getForce(image), Vector3(force.x, -force.y, force.z), 1e-10));
        EXPECT_TRUE(isNear(down.getTorque(image), Vector3(-torque.x, torque.y, -torque.z), 1e-10));
    }
}

TEST(Wing, ForceActsAtItsPositionAndTheCoupleBesides) {
    Random random(65);
    for (int n = 0; n < 50; ++n) {
        World world;
        RigidBody *body = world.createBody();
        body->setOrientation(random.orientation());
        body->setVelocity(random.vector(10));
        body->setMass(1000);
        body->setInertiaTensor(diagonal(1000, 1000, 1000));
        Wing wing(3, 1, random.vector(), nullptr);
        wing.setSection(cambered());
        const Vector3 force = wing.getForce(*body), couple = wing.getTorque(*body);
        const Vector3 arm = body->getDirectionInWorldSpace(wing.getPosition()), before = body->getVelocity();
        EXPECT_GT(couple.magnitude(), 0);
        world.getForceRegistry().add(body, &wing);
        run(world, 1);
        EXPECT_TRUE(isNear(body->getVelocity() - before, force * (STEP / 1000), 1e-12));
        EXPECT_TRUE(isNear(body->getAngularMomentum(), (arm % force + couple) * STEP, 1e-12));
    }
}

TEST(Wing, PitchingIsDampedAsThinAirfoilTheorySays) {
    // cm = −π/8·(q·chord/u) about the quarter chord.
    Wing wing(6, 0.8, Vector3(), nullptr);
    RigidBody body = flying(0);
    body.setRotation(3, 2, 0.5);
    const real pressure = 0.5 * RHO * 100, cm = -REAL_PI / 8 * 0.5 * 0.8 / 10;
    EXPECT_TRUE(isNear(wing.getTorque(body), Vector3(0, 0, pressure * 6 * 0.8 * 0.8 * cm), 1e-12));
}

TEST(Wing, ControlTurnsTheFlap) {
    Wing wing(6, 1, Vector3(), nullptr);
    wing.setControl(1);
    EXPECT_EQ(wing.getForce(flying(0)).y, 0);  // no flap yet
    wing.setFlap(0.25, 0.3);
    const real full = wing.getForce(flying(0)).y;
    EXPECT_GT(full, 100);
    wing.setControl(7);
    EXPECT_EQ(wing.getControl(), 1);
    EXPECT_EQ(wing.getForce(flying(0)).y, full);
    wing.setControl(-7);
    EXPECT_EQ(wing.getControl(), -1);
    EXPECT_NEAR(wing.getForce(flying(0)).y, -full, 1e-10);
    wing.setControl(0);
    EXPECT_EQ(wing.getForce(flying(0)).y, 0);
}

TEST(Wing, TellsItsAngleOfAttackAndWhetherItIsStalled) {
    Wing wing(6, 1, Vector3(), nullptr);
    for (real degrees : {-170.0, -90.0, -30.0, -5.0, 0.0, 5.0, 30.0, 90.0, 179.0}) {
        EXPECT_NEAR(wing.getAngleOfAttack(flying(degrees * DEGREE)), degrees * DEGREE, 1e-14);
        EXPECT_EQ(wing.isStalled(flying(degrees * DEGREE)),
                  std::fabs(degrees) > 20 && std::fabs(degrees) < 160);
    }
}

TEST(Wing, RefusesBadArgumentsAndStaysAsItWas) {
    EXPECT_THROW(Wing(0, 1, Vector3(), nullptr), std::invalid_argument);
    EXPECT_THROW(Wing(1, -1, Vector3(), nullptr), std::invalid_argument);
    EXPECT_THROW(Wing(INFINITE, 1, Vector3(), nullptr), std::invalid_argument);
    EXPECT_THROW(Wing(1e300, 1e-300, Vector3(), nullptr), std::invalid_argument);
    EXPECT_THROW(Wing(1, 1, Vector3(0, QUIET_NAN, 0), nullptr), std::invalid_argument);
    Wing wing(6, 1, Vector3(1, 2, 3), nullptr);
    wing.setFlap(0.3, 0.5);
    wing.setControl(0.5);
    const Vector3 before = wing.getForce(flying(0.1));
    for (real bad : {0.0, -1.0, QUIET_NAN, INFINITE}) {
        EXPECT_THROW(wing.setDensity(bad), std::invalid_argument);
        EXPECT_THROW(wing.setAspectRatio(bad), std::invalid_argument);
    }
    for (real bad : {-0.1, QUIET_NAN, 1.7}) {
        EXPECT_THROW(wing.setFlap(bad, 0.1), std::invalid_argument);
        EXPECT_THROW(wing.setFlap(0.1, bad), std::invalid_argument);
    }
    EXPECT_THROW(wing.setControl(QUIET_NAN), std::invalid_argument);
    EXPECT_THROW(wing.setOrientation(Quaternion(0, 0, 0, 0)), std::invalid_argument);
    EXPECT_EQ(wing.getForce(flying(0.1)), before);
    EXPECT_EQ(wing.getControl(), 0.5);
    EXPECT_EQ(wing.getDensity(), RHO);
    EXPECT_EQ(wing.getAspectRatio(), 6);
    EXPECT_EQ(wing.getPosition(), Vector3(1, 2, 3));
    EXPECT_TRUE(wing.actsOnItsBodyOnly());
}

}  // namespace
