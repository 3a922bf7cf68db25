#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <deque>
#include <stdexcept>
#include <vector>

#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

/// Air that turns about the Y axis like a solid body: velocity = rotation × point.
class Whirl : public WindField {
public:
    explicit Whirl(real rate) : rotation(0, rate, 0) {}
    Vector3 getVelocity(const Vector3 &worldPoint) const override { return rotation % worldPoint; }

private:
    Vector3 rotation;
};

/// Turned a quarter to the left, so that its nose points to −Z and its starboard side to +X.
RigidBody turnedLeft(const Vector3 &position, const Vector3 &velocity) {
    RigidBody body;
    body.setOrientation(Quaternion::fromAxisAngle(Vector3::Y, REAL_PI / 2));
    body.setPosition(position);
    body.setVelocity(velocity);
    return body;
}

Vector3 forceOf(ForceGenerator &generator, RigidBody body) {
    body.clearAccumulators();
    generator.updateForce(&body, 0.01);
    return body.getState().added.force;
}

// ---- What feels a field

TEST(WindField, BlowsOnEachSurfaceAsItGoesWhereTheSurfaceIs) {
    const RigidBody body = turnedLeft(Vector3(3, 1, 0), Vector3(0, 0, 2));
    const Whirl whirl(2);
    const Vector3 windspeed(-1, 0, 0);
    Aero surface(diagonal(-1, -1, -1), Vector3(0, 0, 2), &windspeed);
    surface.setWind(&whirl);
    // At (5, 1, 0) the whirl goes at (0, 0, −10), and the windspeed's air at (1, 0, 0).
    EXPECT_TRUE(isNear(surface.getForce(body), Vector3(1, 0, -12), 1e-14));
    surface.setWind(nullptr);
    EXPECT_TRUE(isNear(surface.getForce(body), Vector3(1, 0, -2), 1e-14));
}

TEST(WindField, CarriesADragAlong) {
    const Whirl whirl(2);
    Drag drag(1, 0.5);
    drag.setWind(&whirl);
    // At (3, 1, 0) the air goes at (0, 0, −6): 8 m/s past the body.
    const RigidBody body = turnedLeft(Vector3(3, 1, 0), Vector3(0, 0, 2));
    EXPECT_TRUE(isNear(forceOf(drag, body), Vector3(0, 0, -(8 + 0.5 * 64)), 1e-13));
    drag.setWind(nullptr);
    EXPECT_TRUE(isNear(forceOf(drag, body), Vector3(0, 0, -(2 + 0.5 * 4)), 1e-13));
}

TEST(WindField, IsTheAirThatAPropellerBites) {
    const Whirl whirl(1);
    const Vector3 windspeed(0, 0, -1);
    Propeller propeller(Vector3::X, Vector3(0, 0, 2), 100, 20, &windspeed);
    propeller.setThrottle(1);
    propeller.setWind(&whirl);
    // Flying at 8 m/s to −Z. At (5, 0, 0) the whirl goes at (0, 0, −5), the windspeed's air at (0, 0, 1): the
    // propeller advances at 8 − 5 + 1 = 4 m/s of its 20.
    const RigidBody body = turnedLeft(Vector3(3, 0, 0), Vector3(0, 0, -8));
    EXPECT_TRUE(isNear(propeller.getForce(body), Vector3(0, 0, -80), 1e-12));
    propeller.setWind(nullptr);
    EXPECT_TRUE(isNear(propeller.getForce(body), Vector3(0, 0, -55), 1e-12));
}

// ---- The gradient

TEST(WindGradient, GrowsWithHeightByThePowerLaw) {
    const WindGradient gradient(Vector3(6, 0, -2), 10, 0.25);
    EXPECT_TRUE(isNear(gradient.getVelocity(Vector3(5, 10, 7)), Vector3(6, 0, -2), 1e-14));
    EXPECT_TRUE(isNear(gradient.getVelocity(Vector3(-9, 160, 0)), Vector3(12, 0, -4), 1e-13));
    EXPECT_TRUE(isNear(gradient.getVelocity(Vector3(0, 0.625, 0)), Vector3(3, 0, -1), 1e-14));
    EXPECT_EQ(gradient.getVelocity(Vector3(1, 0, 1)), Vector3());
    EXPECT_EQ(gradient.getVelocity(Vector3(1, -5, 1)), Vector3());
}

TEST(WindGradient, IsASeventhPowerByDefaultAndUniformWithoutExponent) {
    const WindGradient seventh(Vector3(6, 0, 0), 10), uniform(Vector3(6, 0, 0), 10, 0);
    EXPECT_NEAR(seventh.getVelocity(Vector3(0, 1280, 0)).x, 12, 1e-13);
    EXPECT_EQ(uniform.getVelocity(Vector3(0, 1e-3, 0)), Vector3(6, 0, 0));
}

// ---- The thermal

constexpr real STRENGTH = 4, RADIUS = 70, TOP = 1500;
const Vector3 FOOT(100, 20, -40);

/// What flows up through the disk of radius r at a height above the foot, m³/s: Simpson's rule.
real flowThrough(const Thermal &thermal, real r, real height) {
    const int steps = 2000;
    real sum = 0;
    for (int n = 0; n <= steps; ++n) {
        const real at = r * n / steps, weight = n == 0 || n == steps ? 1 : (n % 2 == 1 ? 4 : 2);
        const Vector3 direction(std::cos(1.0 * n), 0, std::sin(1.0 * n));
        const Vector3 point = FOOT + direction * at + Vector3(0, height, 0);
        sum += weight * 2 * REAL_PI * at * thermal.getVelocity(point).y;
    }
    return sum * r / steps / 3;
}

TEST(Thermal, RisesMostAtAThirdOfItsTop) {
    const Thermal thermal(FOOT, STRENGTH, RADIUS, TOP);
    const auto core = [&](real part) { return thermal.getVelocity(FOOT + Vector3(0, part * TOP, 0)); };
    EXPECT_TRUE(isNear(core(1.0 / 3), Vector3(0, STRENGTH, 0), 1e-13));
    EXPECT_LT(core(0.32).y, STRENGTH);
    EXPECT_LT(core(0.35).y, STRENGTH);
    EXPECT_EQ(core(0).y, 0);
    EXPECT_EQ(core(1), Vector3());
    EXPECT_EQ(core(1.5), Vector3());
}

TEST(Thermal, NetFlowThroughEachLevelIsZero) {
    const Thermal thermal(FOOT, STRENGTH, RADIUS, TOP);
    for (real height : {100.0, TOP / 3, 1400.0}) {
        // Out to r the integral is πr²·exp(−(r/R)²)·w on the axis: most at r = R, and nothing in the end.
        const real axis = thermal.getVelocity(FOOT + Vector3(0, height, 0)).y;
        const real core = REAL_PI * RADIUS * RADIUS * std::exp(-1) * axis;
        EXPECT_NEAR(flowThrough(thermal, RADIUS, height), core, 1e-9 * core);
        EXPECT_NEAR(flowThrough(thermal, 5.9 * RADIUS, height), 0, 1e-9 * core);
    }
}

TEST(Thermal, AirFlowsInBelowAndOutAboveAndKeepsItsVolume) {
    const Thermal thermal(FOOT, STRENGTH, RADIUS, TOP);
    Random random(3);
    const real d = 0.05;
    for (int n = 0; n < 300; ++n) {
        const Vector3 point =
            FOOT + Vector3(random.between(-150, 150), random.between(1, TOP - 1), random.between(-150, 150));
        const auto slope = [&](const Vector3 &axis) {
            return (thermal.getVelocity(point + axis * d) - thermal.getVelocity(point - axis * d)) * axis;
        };
        const real divergence = slope(Vector3::X) + slope(Vector3::Y) + slope(Vector3::Z);
        EXPECT_NEAR(divergence / (2 * d), 0, 1e-7);
    }
    EXPECT_LT(thermal.getVelocity(FOOT + Vector3(50, 10, 0)).x, 0);
    EXPECT_GT(thermal.getVelocity(FOOT + Vector3(50, TOP / 2, 0)).x, 0);
}

TEST(Thermal, IsContinuousAtItsEdges) {
    const Thermal thermal(FOOT, STRENGTH, RADIUS, TOP);
    for (const Vector3 &edge : {Vector3(40, TOP, 0), Vector3(40, 0, 0), Vector3(0, 300, 6 * RADIUS)}) {
        const Vector3 inside = thermal.getVelocity(FOOT + edge * (1 - 1e-9) + Vector3(0, 1e-9, 0));
        const Vector3 outside = thermal.getVelocity(FOOT + edge * (1 + 1e-9) - Vector3(0, 1e-9, 0));
        EXPECT_TRUE(isNear(inside, outside, 1e-7));
    }
}

TEST(Thermal, MovesWithItsFoot) {
    Thermal thermal(FOOT, STRENGTH, RADIUS, TOP);
    const Vector3 point(30, 400, 10), drift(-25, 3, 60);
    const Vector3 before = thermal.getVelocity(point);
    thermal.setFoot(FOOT + drift);
    EXPECT_EQ(thermal.getFoot(), FOOT + drift);
    EXPECT_TRUE(isNear(thermal.getVelocity(point + drift), before, 1e-13));
}

TEST(WindSum, AddsItsFields) {
    const WindGradient gradient(Vector3(6, 0, 0), 10);
    const Thermal thermal(FOOT, STRENGTH, RADIUS, TOP);
    const Vector3 point = FOOT + Vector3(20, 300, 30);
    WindSum sum;
    EXPECT_EQ(sum.getVelocity(point), Vector3());
    sum.add(&gradient);
    sum.add(&thermal);
    sum.add(&thermal);
    const Vector3 wanted = gradient.getVelocity(point) + thermal.getVelocity(point) * 2;
    EXPECT_TRUE(isNear(sum.getVelocity(point), wanted, 1e-13));
}

// ---- Gliders

/// A glider of one surface that keeps its nose in the flow and a constant bank. Lift L·V and drag D·V at the
/// speed V balance its weight when, with γ the angle of glide and φ the bank,
///
///     tan γ = D/(L·cos φ),    V = m·g·sin γ/D:
///
/// its polar. It circles at the radius (V·cos γ)²·m/(L·V·sin φ) and sinks at V·sin γ.
struct Glider {
    static constexpr real MASS = 300, GRAVITY = 9.81, LIFT = 200, DRAG = 6;
    real bank = 0.8, glide = std::atan(DRAG / (LIFT * std::cos(bank)));
    real speed = MASS * GRAVITY * std::sin(glide) / DRAG;
    real sink = speed * std::sin(glide);
    real radius = MASS * speed * std::cos(glide) * std::cos(glide) / (LIFT * std::sin(bank));

    RigidBody body;
    Aero surface{Matrix3(-DRAG, 0, 0, LIFT, 0, 0, 0, 0, 0), Vector3(), nullptr};

    /// Circling to the right about the axis of a thermal.
    Glider(const Vector3 &axis, real height, const Thermal &thermal) {
        body.setMass(MASS);
        body.setInverseInertiaTensor(diagonal(0, 0, 0));  // turned by the pilot alone
        body.setAcceleration(0, -GRAVITY, 0);
        body.setPosition(axis.x, height, axis.z - radius);
        body.setVelocity(Vector3(speed * std::cos(glide), -sink, 0) +
                         thermal.getVelocity(body.getPosition()));
        surface.setWind(&thermal);
    }
    /// Nose into the air that comes, w its velocity, then bank to the right.
    void steer(const Vector3 &w) {
        const Vector3 nose = (body.getVelocity() - w).unit();
        body.setOrientation(Quaternion::fromAxisAngle(Vector3::Y, std::atan2(-nose.z, nose.x)) *
                            Quaternion::fromAxisAngle(Vector3::Z, std::asin(nose.y)) *
                            Quaternion::fromAxisAngle(Vector3::X, bank));
    }
};

TEST(Thermal, AGliderThatCirclesInItClimbsAtTheRiseLessTheSinkOfItsPolar) {
    const Thermal thermal(FOOT, STRENGTH, RADIUS, 30000);
    const real height = FOOT.y + 10000;  // where air neither flows in nor out
    World world;
    Glider glider(FOOT, height, thermal);
    const real q = glider.radius * glider.radius / (RADIUS * RADIUS);
    const real rise = STRENGTH * (1 - q) * std::exp(-q);
    world.addBody(&glider.body);
    world.getForceRegistry().add(&glider.body, &glider.surface);

    const real step = 0.01, duration = 60;
    for (int n = 0; n < 6000; ++n) {
        world.startFrame();
        glider.steer(thermal.getVelocity(glider.body.getPosition()));
        world.runPhysics(step);
    }
    const Vector3 away = glider.body.getPosition() - FOOT;
    EXPECT_NEAR(std::hypot(away.x, away.z), glider.radius, 1e-3 * glider.radius);
    EXPECT_GT(rise - glider.sink, 0.5);
    EXPECT_NEAR((glider.body.getPosition().y - height) / duration, rise - glider.sink, 1e-3 * rise);
}

/// Counts how often it is asked.
class Counted : public WindField {
public:
    explicit Counted(const WindField *asked) : field(asked) {}
    Vector3 getVelocity(const Vector3 &worldPoint) const override {
        ++count;
        return field->getVelocity(worldPoint);
    }
    long getCount() const { return count; }

private:
    const WindField *field;
    mutable std::atomic<long> count{0};
};

/// Where a hundred gliders of two surfaces are after fifty frames in one field.
std::vector<Vector3> flyHundred(const WindField &field, std::size_t threads) {
    World world;
    world.setWorkers(threads);
    std::deque<Aero> surfaces;
    for (int n = 0; n < 100; ++n) {
        RigidBody *const body = world.createBody();
        body->setPosition(3.0 * n, 200, 2.0 * (n % 7));
        body->setVelocity(15, 0, 0);
        for (real side : {-3.0, 3.0}) {
            surfaces.emplace_back(Matrix3(-0.1, 0, 0, 1, -0.5, 0, 0, 0, -0.1), Vector3(0, 0, side), nullptr);
            surfaces.back().setWind(&field);
            world.getForceRegistry().add(body, &surfaces.back());
        }
    }
    for (int n = 0; n < 50; ++n) {
        world.startFrame();
        world.runPhysics(0.01);
    }
    std::vector<Vector3> positions;
    for (const RigidBody *body : world.getBodies()) positions.push_back(body->getPosition());
    return positions;
}

TEST(WindField, AHundredGlidersAskItOnceASurfaceAndFlyTheSameOnThreads) {
    const WindGradient gradient(Vector3(6, 0, 1), 10);
    const Thermal thermal(FOOT, STRENGTH, RADIUS, TOP);
    WindSum sum;
    sum.add(&gradient);
    sum.add(&thermal);
    const Counted alone(&sum), shared(&sum);
    EXPECT_EQ(flyHundred(alone, 0), flyHundred(shared, 3));
    EXPECT_EQ(alone.getCount(), 100 * 2 * 50);
    EXPECT_EQ(shared.getCount(), 100 * 2 * 50);
}

// ---- Bad arguments

TEST(WindField, RefusesWhatIsNotAWind) {
    const Vector3 bad(0, QUIET_NAN, 0);
    EXPECT_THROW(WindGradient(bad, 10), std::invalid_argument);
    EXPECT_THROW(WindGradient(Vector3(), 0), std::invalid_argument);
    EXPECT_THROW(WindGradient(Vector3(), 10, -0.1), std::invalid_argument);
    EXPECT_THROW(Thermal(bad, 1, 1, 1), std::invalid_argument);
    EXPECT_THROW(Thermal(Vector3(), PLUS_INFINITY, 1, 1), std::invalid_argument);
    EXPECT_THROW(Thermal(Vector3(), 1, 0, 1), std::invalid_argument);
    EXPECT_THROW(Thermal(Vector3(), 1, 1, -1), std::invalid_argument);
    EXPECT_THROW(WindSum().add(nullptr), std::invalid_argument);
    Thermal thermal(FOOT, 1, 1, 1);
    EXPECT_THROW(thermal.setFoot(bad), std::invalid_argument);
    EXPECT_EQ(thermal.getFoot(), FOOT);
}

}  // namespace
