#include "flightsim/aircraft.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace demo;
using namespace flightsim;
using cyclone::Quaternion;

namespace {

constexpr real STEP = 1.0 / 120, M = 2.5, G = 9.81, U = M * G / 3, DEGREE = cyclone::REAL_PI / 180;

// The geometry, in the letters of the equations.
const real xw = Aircraft::WING_POSITION.x, yw = Aircraft::WING_POSITION.y, zw = Aircraft::WING_POSITION.z,
           xt = Aircraft::TAIL_POSITION.x, yt = Aircraft::TAIL_POSITION.y, xr = Aircraft::RUDDER_POSITION.x,
           yr = Aircraft::RUDDER_POSITION.y, yT = Aircraft::PROPELLER_POSITION.y;
const Vector3 inertia = Aircraft::MOMENTS_OF_INERTIA;

FlightControls cruise() {
    FlightControls controls;
    controls.throttle = Aircraft::LEVEL_THROTTLE;
    return controls;
}

/// The aircraft in a world of its own.
struct Sky {
    cyclone::World world;
    Aircraft aircraft;

    explicit Sky(const Vector3 *windspeed = nullptr) : aircraft(world, windspeed) {}

    void step() {
        world.startFrame();
        world.runPhysics(STEP);
    }
    void fly(real seconds) {
        for (int n = 0; n < std::lround(seconds / STEP); ++n) step();
    }
};

/// The moment of surfaces and propeller about the centre of mass, world coordinates.
Vector3 momentOn(const Aircraft &aircraft) {
    const RigidBody &body = aircraft.getBody();
    Vector3 moment;
    for (const cyclone::Aero *surface : aircraft.getSurfaces())
        moment += body.getDirectionInWorldSpace(surface->getPosition()) % surface->getForce(body);
    return moment + body.getDirectionInWorldSpace(Aircraft::PROPELLER_POSITION) %
                        aircraft.getPropeller().getForce(body);
}

using State4 = std::array<real, 4>;
using Matrix4x4 = std::array<State4, 4>;

State4 times(const Matrix4x4 &a, const State4 &x) {
    State4 y{};
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) y[row] += a[row][column] * x[column];
    return y;
}

/// x' = A·x over one step, by the exponential's series.
State4 advanced(const Matrix4x4 &a, State4 x) {
    State4 term = x;
    for (int order = 1; order <= 8; ++order) {
        term = times(a, term);
        for (std::size_t n = 0; n < 4; ++n) x[n] += (term[n] *= STEP / order);
    }
    return x;
}

/// The small motions about level flight, by hand from the chapter's tensors. (u, v, pitch rate, pitch): u and
/// v forward and upward in body axes, as deviations.
Matrix4x4 longitudinal() {
    const real thrustSlope = -Aircraft::LEVEL_THRUST / (Aircraft::PITCH_SPEED - U);
    const real sumX = 2 * xw + xt, sumY = 2 * yw + yt + yr;
    const real sumXX = 2 * xw * xw + xt * xt, sumYY = 2 * yw * yw + yt * yt + yr * yr;
    const real sumXY = 2 * xw * yw + xt * yt;
    const real I = inertia.z;
    return {{{(-0.4 + thrustSlope) / M, 0, 0.1 * sumY / M, -G},
             {3 / M, -1.6 / M, (-(2 * yw + yt) - 0.5 * sumX - 0.1 * xr) / M - U, 0},
             {(sumX + 0.1 * sumY - yT * thrustSlope) / I, (-0.5 * sumX - 0.1 * xr) / I,
              (-sumXY - 0.5 * sumXX - 0.1 * xr * xr - 0.1 * sumYY) / I, 0},
             {0, 0, 1, 0}}};
}

/// (velocity to starboard, roll rate, yaw rate to port, roll).
Matrix4x4 lateral() {
    const real side[4] = {0.1, 0.1, 0.1, 0.5}, x[4] = {xw, xw, xt, xr}, y[4] = {yw, yw, yt, yr};
    real k = 0, kx = 0, ky = 0, kxx = 0, kxy = 0, kyy = 0;
    for (int n = 0; n < 4; ++n) {
        k += side[n];
        kx += side[n] * x[n];
        ky += side[n] * y[n];
        kxx += side[n] * x[n] * x[n];
        kxy += side[n] * x[n] * y[n];
        kyy += side[n] * y[n] * y[n];
    }
    const real zz = 2 * zw * zw;
    return {{{-k / M, -ky / M, kx / M + U, G},
             {-ky / inertia.x, (-kyy - 0.5 * zz) / inertia.x, (kxy - zz) / inertia.x, 0},
             {kx / inertia.y, kxy / inertia.y, (-kxx - 0.1 * zz) / inertia.y, 0},
             {0, 1, 0, 0}}};
}

/// Whether all roots of the characteristic polynomial have negative real parts: its coefficients by
/// Faddeev and LeVerrier, then Routh and Hurwitz.
bool isStable(const Matrix4x4 &a) {
    real c[5] = {1, 0, 0, 0, 0};
    Matrix4x4 m{};
    for (std::size_t order = 1; order <= 4; ++order) {
        Matrix4x4 next{};
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) {
                for (std::size_t l = 0; l < 4; ++l) next[i][j] += a[i][l] * m[l][j];
                if (i == j) next[i][j] += c[order - 1];
            }
        m = next;
        real trace = 0;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t l = 0; l < 4; ++l) trace += a[i][l] * m[l][i];
        c[order] = -trace / static_cast<real>(order);
    }
    return c[1] > 0 && c[2] > 0 && c[3] > 0 && c[4] > 0 &&
           c[1] * c[2] * c[3] > c[3] * c[3] + c[1] * c[1] * c[4];
}

}  // namespace

TEST(DemoAircraft, FliesLevelHandsOffForAMinute) {
    Sky sky;
    Aircraft &aircraft = sky.aircraft;
    aircraft.setControls(cruise());
    sky.fly(60);
    const RigidBody &body = aircraft.getBody();
    EXPECT_EQ(body.getLinearDamping(), 1);
    EXPECT_EQ(body.getAngularDamping(), 1);
    EXPECT_NEAR(body.getPosition().x, U * 60, 1e-6);
    EXPECT_NEAR(body.getPosition().y, 20, 1e-6);
    EXPECT_NEAR(body.getPosition().z, 0, 1e-6);
    EXPECT_NEAR(aircraft.getAirspeed(), U, 1e-9);
}

TEST(DemoAircraft, ComesBackToLevelFlightAfterAShove) {
    Sky sky;
    Aircraft &aircraft = sky.aircraft;
    aircraft.setControls(cruise());
    aircraft.getBody().addVelocity(Vector3(1.5, -1, 1));
    aircraft.getBody().addRotation(Vector3(0.6, 0.3, 0.4));
    sky.fly(60);
    EXPECT_NEAR(aircraft.getAirspeed(), U, 1e-4);
    EXPECT_NEAR(aircraft.getBody().getVelocity().y, 0, 1e-4);
    EXPECT_NEAR(aircraft.getRoll(), 0, 1e-4);
    EXPECT_NEAR(aircraft.getPitch(), 0, 1e-4);
}

TEST(DemoAircraft, PitchingUpMakesANoseDownMoment) {
    for (const real alpha : {-4 * DEGREE, 4 * DEGREE}) {
        Sky sky;
        Aircraft &aircraft = sky.aircraft;
        aircraft.setControls(cruise());
        aircraft.getBody().setOrientation(Quaternion::fromAxisAngle(Vector3::Z, alpha));
        const real perRadian = U * (0.5 * (2 * xw + xt) + 0.1 * xr);
        EXPECT_LT(perRadian, -0.5);
        EXPECT_NEAR(momentOn(aircraft).z, perRadian * alpha, 0.03 * std::fabs(perRadian * alpha));
    }
}

TEST(DemoAircraft, SmallMotionsAreThoseOfTheLinearEquations) {
    EXPECT_TRUE(isStable(longitudinal()));
    EXPECT_TRUE(isStable(lateral()));

    const real small = 1e-4;
    Sky sky;
    Aircraft &aircraft = sky.aircraft;
    aircraft.setControls(cruise());
    aircraft.getBody().addVelocity(Vector3(small, 0, small));
    aircraft.getBody().addRotation(Vector3(small, small, small));
    State4 pitching = {small, 0, small, 0}, rolling = {small, small, small, 0};
    for (int n = 1; n <= 1200; ++n) {  // ten seconds, two periods of the phugoid
        sky.step();
        pitching = advanced(longitudinal(), pitching);
        rolling = advanced(lateral(), rolling);
        if (n % 120 != 0) continue;
        const RigidBody &body = aircraft.getBody();
        const Vector3 velocity = body.getDirectionInLocalSpace(body.getVelocity());
        const Vector3 rotation = body.getDirectionInLocalSpace(body.getRotation());
        const real within = 0.02 * small;
        EXPECT_NEAR(velocity.x - U, pitching[0], within) << n;
        EXPECT_NEAR(velocity.y, pitching[1], within) << n;
        EXPECT_NEAR(rotation.z, pitching[2], within) << n;
        EXPECT_NEAR(aircraft.getPitch(), pitching[3], within) << n;
        EXPECT_NEAR(velocity.z, rolling[0], within) << n;
        EXPECT_NEAR(rotation.x, rolling[1], within) << n;
        EXPECT_NEAR(rotation.y, rolling[2], within) << n;
        EXPECT_NEAR(aircraft.getRoll(), rolling[3], within) << n;
    }
}

TEST(DemoAircraft, BothWingsUpOrDownPitchIt) {
    for (const real stick : {-0.5, 0.5}) {
        Sky sky;
        Aircraft &aircraft = sky.aircraft;
        FlightControls controls = cruise();
        controls.pitch = stick;
        aircraft.setControls(controls);
        // Per wing the control c changes lift by 0.4·c·u upwards or 1.2·c·u downwards, and drag by 0.1·|c|·u.
        const real c = stick * Aircraft::PITCH_THROW;
        const real lift = c > 0 ? 0.4 * c * U : 1.2 * c * U;
        EXPECT_NEAR(momentOn(aircraft).z, 2 * xw * lift + 2 * yw * 0.1 * std::fabs(c) * U, 1e-12);
        sky.fly(0.3);
        EXPECT_GT(aircraft.getPitch() * stick, 0);
        sky.fly(0.4);
        EXPECT_GT(aircraft.getBody().getVelocity().y * stick, 0.05);
    }
}

TEST(DemoAircraft, WingsInOppositionRollItToTheSideOfTheStick) {
    for (const real stick : {-0.5, 0.5}) {
        Sky sky;
        Aircraft &aircraft = sky.aircraft;
        FlightControls controls = cruise();
        controls.roll = stick;
        aircraft.setControls(controls);
        const real c = stick * Aircraft::ROLL_THROW;
        EXPECT_NEAR(momentOn(aircraft).x, zw * 1.6 * c * U, 1e-12);
        sky.fly(1);
        EXPECT_GT(aircraft.getRoll() * stick, 0);
        EXPECT_GT(std::fabs(aircraft.getRoll()), 20 * DEGREE);
    }
}

TEST(DemoAircraft, TheRudderYawsItToTheSideOfThePedal) {
    for (const real pedal : {-0.5, 0.5}) {
        Sky sky;
        Aircraft &aircraft = sky.aircraft;
        FlightControls controls = cruise();
        controls.rudder = pedal;
        aircraft.setControls(controls);
        // Yaw to starboard is about -Y. The force s·u acts at xr, aft.
        EXPECT_NEAR(momentOn(aircraft).y, 0.4 * Aircraft::RUDDER_THROW * pedal * U * xr, 1e-12);
        sky.fly(0.5);
        EXPECT_GT(aircraft.getHeading() * pedal, 0);
    }
}

TEST(DemoAircraft, ABankTurnsIt) {
    for (const real stick : {-0.1, 0.1}) {
        Sky sky;
        Aircraft &aircraft = sky.aircraft;
        FlightControls controls = cruise();
        controls.roll = stick;
        aircraft.launch(Vector3(0, 500, 0));
        aircraft.setControls(controls);
        sky.fly(30);
        const Vector3 before = aircraft.getBody().getVelocity();
        sky.fly(0.5);
        const Vector3 after = aircraft.getBody().getVelocity();
        const real turned =
            std::atan2(before.x * after.z - before.z * after.x, before.x * after.x + before.z * after.z);
        // A steady turn in which lift and weight are the only forces across the path.
        const real speed = std::hypot(after.x, after.z);
        EXPECT_GT(aircraft.getRoll() * stick, 0);
        EXPECT_GT(std::fabs(aircraft.getRoll()), 25 * DEGREE);
        EXPECT_NEAR(turned / 0.5 * speed / (G * std::tan(aircraft.getRoll())), 1, 0.15);
    }
}

TEST(DemoAircraft, ThrottleClimbsItAtNearlyTheSameSpeed) {
    real climb[3];
    int n = 0;
    for (const real change : {-0.2, 0.0, 0.2}) {
        Sky sky;
        Aircraft &aircraft = sky.aircraft;
        FlightControls controls = cruise();
        controls.throttle += change;
        aircraft.launch(Vector3(0, 500, 0));
        aircraft.setControls(controls);
        sky.fly(60);
        climb[n++] = aircraft.getBody().getVelocity().y;
        // Lift carries the weight at any gentle path, so the speed hardly changes.
        EXPECT_NEAR(aircraft.getAirspeed(), U, 0.08 * U);
        EXPECT_NEAR(aircraft.getBody().getLastFrameAcceleration().magnitude(), 0, 1e-3);
    }
    EXPECT_LT(climb[0], -1);
    EXPECT_NEAR(climb[1], 0, 1e-9);
    EXPECT_GT(climb[2], 1);
}

TEST(DemoAircraft, FliesInTheMovingAirAsInStillAir) {
    const Vector3 windspeed(3, 0, -2);
    Sky sky(&windspeed);
    Aircraft &aircraft = sky.aircraft;
    aircraft.setControls(cruise());
    sky.fly(20);
    EXPECT_NEAR(aircraft.getBody().getPosition().x, (U - 3) * 20, 1e-6);
    EXPECT_NEAR(aircraft.getBody().getPosition().z, 2 * 20, 1e-6);
    EXPECT_NEAR(aircraft.getBody().getPosition().y, 20, 1e-6);
}

TEST(DemoAircraft, RestsOnItsWheels) {
    Sky sky;
    Aircraft &aircraft = sky.aircraft;
    aircraft.park(Vector3(5, 0, 2));
    sky.fly(10);
    real load = 0;
    for (const Wheel &wheel : aircraft.getWheels()) load += wheel.getForce(aircraft.getBody()).y;
    EXPECT_NEAR(load, M * G, 1e-6);
    EXPECT_TRUE(aircraft.isOnGround());
    EXPECT_EQ(aircraft.getBrokenPart(), "");
    EXPECT_NEAR(aircraft.getBody().getVelocity().magnitude(), 0, 1e-6);
    EXPECT_NEAR(aircraft.getBody().getPosition().z, 2, 1e-6);
    EXPECT_NEAR(aircraft.getPitch(), 0, 3 * DEGREE);
}

TEST(DemoAircraft, TakesOffUnderFullThrottle) {
    Sky sky;
    Aircraft &aircraft = sky.aircraft;
    aircraft.park(Vector3());
    FlightControls controls;
    controls.throttle = 1;
    aircraft.setControls(controls);
    sky.fly(8);
    EXPECT_FALSE(aircraft.isOnGround());
    EXPECT_GT(aircraft.getBody().getPosition().y, 3);
    EXPECT_NEAR(aircraft.getBody().getPosition().z, 0, 1e-6);
}

TEST(DemoWheel, PushesAsItsSpringAndRollsEasierThanItSlides) {
    Wheel::Strut strut;
    const Wheel wheel(Vector3(0, -0.3, 0), strut);
    RigidBody body;
    body.setPosition(0, 0.3, 0);
    EXPECT_EQ(wheel.getForce(body), Vector3());
    body.setPosition(0, 0.28, 0);
    EXPECT_NEAR(wheel.getForce(body).y, strut.springConstant * 0.02, 1e-12);
    body.setVelocity(30, 0, 0);
    EXPECT_NEAR(wheel.getForce(body).x, -strut.rollingFriction * strut.springConstant * 0.02, 1e-3);
    EXPECT_NEAR(wheel.getForce(body).z, 0, 1e-12);
    body.setVelocity(0, 0, 30);
    EXPECT_NEAR(wheel.getForce(body).z, -strut.grip * strut.springConstant * 0.02, 1e-3);
    body.setVelocity(0, 10, 0);
    EXPECT_EQ(wheel.getForce(body), Vector3()) << "it never pulls";
}

TEST(DemoWheel, SteersToTheSideItIsTurnedTo) {
    Wheel wheel(Vector3(1, -0.3, 0), Wheel::Strut());
    wheel.setSteering(0.3);
    RigidBody body;
    body.setPosition(0, 0.28, 0);
    body.setVelocity(5, 0, 0);
    EXPECT_GT(wheel.getForce(body).z, 1);
}
