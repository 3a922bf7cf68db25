#include <cyclone/body.h>

#include <cstring>

#include "../../src/freerotation.h"
#include "reference.h"

using namespace cyclone;
using detail::FreeRotation;
using reference::difference;
using reference::turnAbout;

namespace {

constexpr int LANES = FreeRotation::LANES;

/// One body that turns freely; axis 0 is that of the middle inertia.
struct Spinner {
    Vector3 inertia;
    Vector3 momentum;  // world
    Quaternion orientation;
    Quaternion principalAxes = Quaternion();  // in the body's

    Vector3 inverseInertia() const { return Vector3(1 / inertia.x, 1 / inertia.y, 1 / inertia.z); }
    /// Angular velocity in principal axes, from the momentum by a matrix of the orientation.
    Vector3 spin() const {
        Matrix3 axes;
        axes.setOrientation(orientation * principalAxes);
        return axes.transformTranspose(momentum).componentProduct(inverseInertia());
    }
};

void putIn(const Spinner &s, FreeRotation &block, int lane) {
    const auto put = [lane](const Quaternion &q, FreeRotation::Lanes *lanes) {
        const real parts[4] = {q.r, q.i, q.j, q.k};
        for (int n = 0; n < 4; ++n) lanes[n][lane] = parts[n];
    };
    put(s.orientation, block.orientation);
    const bool isTurned = s.principalAxes != Quaternion();
    block.isTurned[lane] = isTurned;
    if (isTurned) {
        block.areAnyTurned = true;
        put(s.principalAxes, block.principalAxes);
    }
    const Vector3 inverse = s.inverseInertia();
    for (unsigned n = 0; n < 3; ++n) {
        block.inverseInertia[n][lane] = inverse[n];
        block.momentum[n][lane] = block.finalMomentum[n][lane] = s.momentum[n];
    }
}

Quaternion orientationOf(const FreeRotation &block, int lane) {
    return Quaternion(block.orientation[0][lane], block.orientation[1][lane], block.orientation[2][lane],
                      block.orientation[3][lane]);
}
Vector3 rotationOf(const FreeRotation &block, int lane) {
    return Vector3(block.rotation[0][lane], block.rotation[1][lane], block.rotation[2][lane]);
}
Matrix3 matrixOf(const FreeRotation &block, int lane) {
    Matrix3 m;
    for (int n = 0; n < 9; ++n) m.data[n] = block.matrix[n / 3][n % 3][lane];
    return m;
}

Spinner advanced(Spinner s, int steps, real duration) {
    FreeRotation block;
    for (int n = 0; n < steps; ++n) {
        putIn(s, block, 0);
        block.advance(1, duration);
        s.orientation = orientationOf(block, 0);
    }
    return s;
}

/// The same by Runge-Kutta.
Quaternion exactOrientation(const Spinner &s, real time, int steps) {
    reference::System system;
    system.inertia = s.inertia;
    reference::Motion motion;
    motion.orientation = s.orientation;
    motion.spin = s.spin();
    system.advance(motion, time, steps);
    return motion.orientation;
}

/// Any body whose axis 0 has the middle inertia, turning by about `angle` rad in a step of 1 s.
Spinner randomSpinner(reference::Random &random, real angle) {
    real a = random.logBetween(0.1, 10), b = random.logBetween(0.1, 10);
    if (a > b) std::swap(a, b);
    const real middle = random.between(a, b);
    Spinner s;
    s.inertia = random.oneIn(2) ? Vector3(middle, a, b) : Vector3(middle, b, a);
    s.orientation = random.orientation();
    s.momentum = random.vector(1).unit() * (angle * middle);
    return s;
}

/// At rest, with zeros of both signs wherever a zero can be.
Spinner atRest(reference::Random &random) {
    const auto signedly = [&random](real x) { return random.oneIn(2) ? x : -x; };
    return {Vector3(2, 1, 3), Vector3(signedly(0), signedly(0), signedly(0)),
            Quaternion(signedly(0.6), signedly(0), signedly(0.8), signedly(0))};
}

/// Equal to the last bit, signs of zeros included.
template <class Value>
bool areSameBits(const Value &a, const Value &b) {
    return std::memcmp(&a, &b, sizeof(Value)) == 0;
}
void expectSameLane(const FreeRotation &a, int laneA, const FreeRotation &b, int laneB) {
    EXPECT_TRUE(areSameBits(orientationOf(a, laneA), orientationOf(b, laneB)));
    EXPECT_TRUE(areSameBits(rotationOf(a, laneA), rotationOf(b, laneB)));
    EXPECT_TRUE(areSameBits(matrixOf(a, laneA), matrixOf(b, laneB)));
}

}  // namespace

// ---- Where a closed form exists

TEST(FreeRotation, SphereTurnsSteadily) {
    reference::Random random;
    for (int trial = 0; trial < 100; ++trial) {
        const real inertia = random.logBetween(1e-3, 1e3), rate = random.between(0, 6);
        Spinner s{Vector3(inertia, inertia, inertia), random.vector(1).unit() * (rate * inertia),
                  random.orientation()};
        const Quaternion exact = turnAbout(s.momentum.unit(), rate * 10) * s.orientation;
        EXPECT_LT(difference(advanced(s, 600, 1.0 / 60).orientation, exact), 1e-12) << rate;
    }
}

TEST(FreeRotation, SymmetricTopPrecessesAsInTheTextbook) {
    // Seen from the world a top turns about L at |L|/I1, while in its own axes it turns about its axis at
    // (1/I3 − 1/I1)·l3 (Landau & Lifshitz, Mechanics, §33).
    const Vector3 axes[] = {Vector3::X, Vector3::Y, Vector3::Z};
    reference::Random random;
    for (const real ratio : {0.1, 0.7, 1.4, 2.0})
        for (unsigned axis = 1; axis < 3; ++axis) {
            Spinner s;
            s.inertia = Vector3(1, 1, 1);
            s.inertia[axis] = ratio;
            s.orientation = random.orientation();
            s.momentum = random.vector(2);
            constexpr real TIME = 5;
            const real along = s.spin()[axis] * ratio;
            const Quaternion exact = turnAbout(s.momentum.unit(), s.momentum.magnitude() * TIME) *
                                     s.orientation * turnAbout(axes[axis], (1 / ratio - 1) * along * TIME);
            EXPECT_LT(difference(advanced(s, 500, 0.01).orientation, exact), 1e-12) << ratio << ' ' << axis;
        }
}

TEST(FreeRotation, SteadyAboutEveryPrincipalAxis) {
    for (unsigned axis = 0; axis < 3; ++axis)
        for (const real sign : {1.0, -1.0}) {
            Spinner s;
            s.inertia = Vector3(2, 1, 3.5);
            Vector3 direction;
            direction[axis] = sign;
            s.momentum = direction * s.inertia[axis];
            const Quaternion exact = turnAbout(direction, 2);
            EXPECT_LT(difference(advanced(s, 40, 0.05).orientation, exact), 1e-13) << axis;
        }
}

TEST(FreeRotation, MatrixAndRotationBelongToTheNewState) {
    reference::Random random;
    for (const real angle : {0.0, 0.1, 1.0, 5.0, 1000.0}) {
        const Spinner s = randomSpinner(random, angle);
        const Vector3 finalMomentum = random.vector(3);
        FreeRotation block;
        putIn(s, block, 0);
        for (unsigned n = 0; n < 3; ++n) block.finalMomentum[n][0] = finalMomentum[n];
        block.advance(1, 1);
        Spinner after = s;
        after.orientation = orientationOf(block, 0);
        after.momentum = finalMomentum;
        for (const Vector3 &v : {Vector3::X, Vector3::Y, Vector3::Z})
            EXPECT_LT(difference(matrixOf(block, 0) * v, after.orientation.rotate(v)), 1e-15);
        EXPECT_LT(difference(rotationOf(block, 0), after.orientation.rotate(after.spin())), 1e-13);
        EXPECT_NEAR(after.orientation.squareMagnitude(), 1, 1e-15);
    }
}

// ---- Where there is none

TEST(FreeRotation, TurnedBodiesTurnAsTheirPrincipalAxes) {
    reference::Random random;
    for (int trial = 0; trial < 100; ++trial) {
        const Spinner plain = randomSpinner(random, 0.3);
        Spinner turned = plain;
        turned.principalAxes = random.orientation();
        turned.orientation = plain.orientation * turned.principalAxes.conjugate();
        FreeRotation plainBlock, turnedBlock;
        putIn(plain, plainBlock, 0);
        putIn(turned, turnedBlock, 0);
        plainBlock.advance(1, 1);
        turnedBlock.advance(1, 1);
        EXPECT_LT(
            difference(orientationOf(turnedBlock, 0) * turned.principalAxes, orientationOf(plainBlock, 0)),
            1e-14);
        EXPECT_LT((rotationOf(turnedBlock, 0) - rotationOf(plainBlock, 0)).magnitude(), 1e-14);
        Matrix3 matrix;
        matrix.setOrientation(orientationOf(turnedBlock, 0));
        EXPECT_EQ(matrixOf(turnedBlock, 0), matrix);
    }
}

TEST(FreeRotation, IsOfFourthOrder) {
    reference::Random random;
    for (int trial = 0; trial < 20; ++trial) {
        const Spinner s = randomSpinner(random, 3);
        const Quaternion exact = exactOrientation(s, 1, 4000);
        real errors[3];
        for (int halving = 0; halving < 3; ++halving) {
            const int steps = 64 << halving;
            errors[halving] = difference(advanced(s, steps, 1.0 / steps).orientation, exact);
        }
        EXPECT_LT(errors[2], 1e-3);
        if (errors[2] < 1e-11) continue;  // nothing but rounding is left to measure
        reference::expectOrder(errors, 3.5);
    }
}

TEST(FreeRotation, KeepsEnergyNearUnstableAxis) {
    Spinner s;
    s.inertia = Vector3(2, 1, 3);
    s.momentum = Vector3(2, 0.01, 0.01);
    const auto energy = [](const Spinner &t) { return t.spin() * t.inertia.componentProduct(t.spin()) / 2; };
    const real before = energy(s);
    real turnedOver = 1;
    for (int n = 0; n < 600; ++n) {
        s = advanced(s, 6, 1.0 / 60);
        turnedOver = std::min(turnedOver, s.spin().x);
        ASSERT_NEAR(energy(s) / before, 1, 1e-8);
    }
    EXPECT_LT(turnedOver, -0.99);
}

TEST(FreeRotation, NamesOfTheAxesDoNotMatter) {
    // The same body, its axes x y z called otherwise: all six ways to share out three principal moments.
    const Vector3 moments(0.6, 1.7, 1.1), rotation(1.5, 0.4, -2.2);
    const Quaternion third = turnAbout(Vector3(1, 1, 1).unit(), 2 * REAL_PI / 3);  // x → y → z → x
    const Quaternion quarter = turnAbout(Vector3::Z, REAL_PI / 2);                 // x → y → −x
    RigidBody plain;
    Matrix3 tensor;
    tensor.setDiagonal(moments.x, moments.y, moments.z);
    plain.setInertiaTensor(tensor);
    plain.setRotation(rotation);
    for (int n = 0; n < 300; ++n) plain.integrate(0.01);

    for (const Quaternion &swap : {Quaternion(), quarter})
        for (const Quaternion &cycle : {Quaternion(), third, third * third}) {
            const Quaternion renaming = swap * cycle;  // from new body axes to old ones
            const Vector3 x = renaming.rotate(Vector3::X), y = renaming.rotate(Vector3::Y),
                          z = renaming.rotate(Vector3::Z);
            const auto momentAlong = [&](const Vector3 &v) { return v.componentProduct(v) * moments; };
            RigidBody renamed;
            tensor.setDiagonal(momentAlong(x), momentAlong(y), momentAlong(z));
            renamed.setInertiaTensor(tensor);
            renamed.setOrientation(renaming);
            renamed.setRotation(rotation);
            for (int n = 0; n < 300; ++n) renamed.integrate(0.01);
            // Swapped axes are turned in another order, which differs by the method's own error.
            const real tolerance = swap == Quaternion() ? 1e-13 : 1e-6;
            EXPECT_LT(difference(renamed.getRotation(), plain.getRotation()), tolerance);
            EXPECT_LT(difference(renamed.getOrientation(), plain.getOrientation() * renaming), tolerance);
        }
}

// ---- Large steps

TEST(FreeRotation, SphereTurnsFarInOneStep) {
    for (const real angle : {1.9, 2.1, 7.0, 30.0, 60.0}) {
        Spinner s{Vector3(2, 2, 2), Vector3(0.6, 0, 0.8) * (2 * angle), Quaternion()};
        const Quaternion exact = turnAbout(Vector3(0.6, 0, 0.8), angle);
        EXPECT_LT(difference(advanced(s, 1, 1).orientation, exact), 1e-6) << angle;
    }
}

TEST(FreeRotation, BeyondItsLimitItTurnsByTheLimit) {
    constexpr real LIMIT = 256 * 0.7;  // substeps, rad
    for (const real angle : {180.0, 1e3, 1e9}) {
        Spinner s{Vector3(1, 1, 1), Vector3(0.6, 0, 0.8) * angle, Quaternion()};
        const Quaternion exact = turnAbout(Vector3(0.6, 0, 0.8), LIMIT);
        EXPECT_LT(difference(advanced(s, 1, 1).orientation, exact), 1e-5) << angle;
    }
}

// ---- Needles: bodies with one moment far below the others

namespace {

/// A body whose thin axis spins at 125 rad/s while it tumbles.
Spinner needle(real ratio, const Vector3 &spin, real third) {
    const Vector3 inertia(1, 1 / ratio, third);
    return {inertia, inertia.componentProduct(spin), Quaternion()};
}

}  // namespace

TEST(FreeRotation, NeedlesPrecessAsInTheTextbook) {
    for (const real ratio : {10.0, 7200.0, 1e6})
        for (const real tumbling : {0.3, 1.0, 10.0}) {
            const Spinner s = needle(ratio, Vector3(tumbling, 125, 0), 1);
            const Quaternion exact = turnAbout(s.momentum.unit(), s.momentum.magnitude()) * s.orientation *
                                     turnAbout(Vector3::Y, (ratio - 1) * s.momentum.y);
            EXPECT_LT(2 * difference(advanced(s, 60, 1.0 / 60).orientation, exact), 1e-3)
                << ratio << " " << tumbling;
        }
}

TEST(FreeRotation, UnsymmetricNeedlesKeepUp) {
    for (const real ratio : {10.0, 1e3, 7200.0, 1e5, 1e6})
        for (const Vector3 &spin : {Vector3(3, 40, 0.5), Vector3(1, 125, 1), Vector3(0.3, 20, 0)}) {
            const Spinner s = needle(ratio, spin, 1.1);
            const Quaternion exact = exactOrientation(s, 1, 400000);
            EXPECT_LT(2 * difference(advanced(s, 60, 1.0 / 60).orientation, exact), 1e-2)
                << ratio << " " << spin.y;
        }
}

TEST(FreeRotation, LargeStepsStayCloseToTheMotion) {
    reference::Random random;
    for (int trial = 0; trial < 100; ++trial) {
        Spinner s = randomSpinner(random, 1);
        const Vector3 fastest = s.inverseInertia() * s.momentum.magnitude();
        s.momentum *= 3 / std::max({fastest.x, fastest.y, fastest.z});  // never faster than 3 rad/s
        const Quaternion exact = exactOrientation(s, 1, 1000);
        EXPECT_LT(difference(advanced(s, 1, 1).orientation, exact), 0.3);
        EXPECT_LT(difference(advanced(s, 4, 0.25).orientation, exact), 1e-2);
        EXPECT_LT(difference(advanced(s, 16, 1.0 / 16).orientation, exact), 1e-4);
    }
}

TEST(FreeRotation, NoStepIsTooLarge) {
    reference::Random random;
    for (int trial = 0; trial < 20000; ++trial) {
        real moments[] = {random.logBetween(1e-4, 1e4), random.logBetween(1e-4, 1e4),
                          random.logBetween(1e-4, 1e4)};
        std::sort(moments, moments + 3);
        Spinner s{Vector3(moments[1], moments[0], moments[2]),
                  random.vector(1).unit() * random.logBetween(1e-3, 1e10), random.orientation()};
        FreeRotation block;
        putIn(s, block, 0);
        block.advance(1, random.logBetween(1e-6, 1));
        ASSERT_TRUE(rotationOf(block, 0).isFinite()) << trial;
        ASSERT_NEAR(orientationOf(block, 0).squareMagnitude(), 1, 1e-14) << trial;
    }
}

// ---- Side by side

TEST(FreeRotation, EveryLaneIsComputedAlone) {
    reference::Random random;
    for (int trial = 0; trial < 200; ++trial)
        for (int lanes = 1; lanes <= LANES; ++lanes) {
            FreeRotation together, alone[LANES];
            for (int lane = 0; lane < lanes; ++lane) {
                Spinner s = randomSpinner(random, random.logBetween(0.01, 100));
                if (random.oneIn(8)) s = atRest(random);
                if (random.oneIn(4)) s.principalAxes = random.orientation();
                putIn(s, together, lane);
                putIn(s, alone[lane], 0);
            }
            if (lanes > 1 && trial % 4 == 0) {  // a poisoned lane does not reach the others
                const int poisoned = random.below(lanes);
                together.momentum[1][poisoned] = alone[poisoned].momentum[1][0] =
                    std::numeric_limits<real>::quiet_NaN();
            }
            together.advance(lanes, 1);
            for (int lane = 0; lane < lanes; ++lane) {
                alone[lane].advance(1, 1);
                if (real_isfinite(alone[lane].momentum[1][0]))
                    expectSameLane(together, lane, alone[lane], 0);
                else
                    EXPECT_FALSE(orientationOf(together, lane).isFinite());
            }
        }
}

TEST(FreeRotation, LeavesUnusedLanesAlone) {
    reference::Random random;
    for (int lanes = 1; lanes < LANES; ++lanes) {
        FreeRotation block{};
        for (int lane = 0; lane < LANES; ++lane) putIn(randomSpinner(random, 1), block, lane);
        const FreeRotation before = block;
        block.advance(lanes, 1);
        for (int lane = lanes; lane < LANES; ++lane) expectSameLane(block, lane, before, lane);
    }
}
