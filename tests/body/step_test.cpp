// How accurate the step is, at 1/60 s unless said otherwise.
#include <cyclone/cyclone.h>

#include "reference.h"

using namespace cyclone;
using reference::difference;
using reference::expectBelow;
using reference::Motion;
using reference::Table;

namespace {

constexpr real STEP = 1.0 / 60;
constexpr int STEPS_PER_ROW = 6;  // the tables have a row for every tenth of a second

Matrix3 diagonal(const Vector3 &v) { return cyclone_test::diagonal(v.x, v.y, v.z); }

RigidBody spinningBody(const Vector3 &inertia, const Vector3 &rotation) {
    RigidBody body;
    body.setInertiaTensor(diagonal(inertia));
    body.setRotation(rotation);
    return body;
}

void advance(RigidBody &body, int steps, real duration = STEP) {
    for (int n = 0; n < steps; ++n) ASSERT_TRUE(body.integrate(duration));
}

Vector3 bodyRates(const RigidBody &body) { return body.getDirectionInLocalSpace(body.getRotation()); }

real kineticEnergyOfRotation(const Vector3 &inertia, const RigidBody &body) {
    const Vector3 w = bodyRates(body);
    return w.componentProduct(inertia) * w / 2;
}

}  // namespace

// ---- Free rotation

TEST(FreeMotion, TumblingBrickOfNasaCheckCase2) {
    const Table table("nesc_atmos02.csv");
    constexpr real DEGREE = REAL_PI / 180;
    RigidBody body = spinningBody(Vector3(0.0025682174740883, 0.00842101103762734, 0.00975465593923173),
                                  Vector3(10, 20, 30) * DEGREE);
    real error = 0, simulators = 0;
    ASSERT_EQ(table.size(), 301u);
    for (std::size_t row = 0; row < table.size(); ++row) {
        const Vector3 exact = table.getVector(row, "p_exact_deg_s", "q_exact_deg_s", "r_exact_deg_s");
        error = std::max(error, difference(bodyRates(body) * (1 / DEGREE), exact));
        simulators = std::max(simulators, table.get(row, "q_spread_deg_s"));
        advance(body, STEPS_PER_ROW);
    }
    expectBelow(error, 1e-6, "error in deg/s");
    EXPECT_GT(simulators, 1000 * error) << "NASA's simulators differ by far more";
}

TEST(FreeMotion, FlipAboutTheIntermediateAxis) {
    const Table table("ref_dzhanibekov.csv");
    RigidBody body = spinningBody(Vector3(1, 2, 3), Vector3(0.01, 1, 0.01));
    real rateError = 0, orientationError = 0, slowest = 1;
    ASSERT_EQ(table.size(), 601u);
    for (std::size_t row = 0; row < table.size(); ++row) {
        const Vector3 rates = table.getVector(row, "wx_body", "wy_body", "wz_body");
        const Quaternion q(table.get(row, "qr"), table.get(row, "qi"), table.get(row, "qj"),
                           table.get(row, "qk"));
        rateError = std::max(rateError, difference(bodyRates(body), rates));
        orientationError = std::max(orientationError, difference(body.getOrientation(), q));
        slowest = std::min(slowest, rates.y);
        advance(body, STEPS_PER_ROW);
    }
    EXPECT_LT(slowest, -0.99) << "it has turned over";
    expectBelow(rateError, 1e-7, "error of the rates");
    expectBelow(orientationError, 1e-7, "error of the orientation");
}

TEST(FreeMotion, AnHourOfTumblingKeepsEnergyAndMomentum) {
    const Vector3 inertia(0.4, 1.1, 0.7);
    RigidBody body = spinningBody(inertia, Vector3(1.3, -2, 0.9));
    body.setOrientation(Quaternion(0.3, -0.5, 0.7, 0.2));
    const Vector3 momentum = body.getAngularMomentum();
    const real energy = kineticEnergyOfRotation(inertia, body);
    real energyError = 0, momentumError = 0;
    for (int second = 0; second < 3600; ++second) {
        advance(body, 60);
        const Vector3 fromRotation = body.getInertiaTensorWorld() * body.getRotation();
        energyError = std::max(energyError, std::fabs(kineticEnergyOfRotation(inertia, body) / energy - 1));
        momentumError = std::max(momentumError, difference(fromRotation, momentum) / momentum.magnitude());
        ASSERT_EQ(body.getAngularMomentum(), momentum) << "not by one bit";
    }
    expectBelow(energyError, 1e-7, "relative error of the energy");
    expectBelow(momentumError, 1e-10, "relative error of the angular momentum");
}

TEST(FreeMotion, AnHourWithObliqueTensorKeepsEnergyAndMomentum) {
    const Matrix3 tensor(0.9, 0.2, -0.1, 0.2, 0.6, 0.15, -0.1, 0.15, 1.1);
    RigidBody body;
    body.setInertiaTensor(tensor);
    body.setRotation(0.4, 1.7, -1.1);
    const Vector3 momentum = body.getAngularMomentum();
    EXPECT_LT(difference(momentum, tensor * body.getRotation()), 1e-14);
    const real energy = momentum * body.getRotation() / 2;
    for (int second = 0; second < 3600; ++second) advance(body, 60);
    EXPECT_EQ(body.getAngularMomentum(), momentum);
    const Vector3 fromRotation = body.getDirectionInWorldSpace(tensor * bodyRates(body));
    expectBelow(difference(fromRotation, momentum), 1e-10, "error of the angular momentum");
    expectBelow(std::fabs(momentum * body.getRotation() / 2 / energy - 1), 1e-7,
                "relative error of the energy");
    expectBelow(std::fabs(body.getOrientation().squareMagnitude() - 1), 1e-14, "error of the length");
}

TEST(FreeMotion, ConvergesWithFourthOrder) {
    const Vector3 inertia(0.7, 1.9, 1.2), spin(1.5, -2.2, 3.1);
    Motion truth;
    truth.spin = spin;
    reference::System system;
    system.inertia = inertia;
    system.advance(truth, 4, 8000);
    real errors[3];
    for (int halving = 0; halving < 3; ++halving) {
        RigidBody body = spinningBody(inertia, spin);
        const int steps = 100 << halving;
        advance(body, steps, 4.0 / steps);
        errors[halving] =
            difference(bodyRates(body), truth.spin) + difference(body.getOrientation(), truth.orientation);
    }
    reference::expectOrder(errors, 3.5);
    expectBelow(errors[1], 1e-5, "error at 1/50 s");
}

TEST(FreeMotion, AMillionBodiesAndStepsOfAnySize) {
    reference::Random random;
    constexpr int BODIES = 1000, ROUNDS = 1000;
    std::vector<RigidBody> bodies(BODIES);
    std::vector<RigidBody *> pointers;
    for (RigidBody &body : bodies) pointers.push_back(&body);
    for (int round = 0; round < ROUNDS; ++round) {
        for (RigidBody &body : bodies) {
            if (round % 10 != 0) break;
            body.setInertiaTensor(diagonal(Vector3(random.logBetween(1e-4, 1e4), random.logBetween(1e-4, 1e4),
                                                   random.logBetween(1e-4, 1e4))));
            body.setOrientation(random.orientation());
            body.setRotation(random.vector(1).unit() * random.logBetween(1e-3, 1e6));
        }
        std::vector<Vector3> momenta;
        for (const RigidBody &body : bodies) momenta.push_back(body.getAngularMomentum());
        const real duration = random.logBetween(1e-9, 1);
        ASSERT_EQ(RigidBody::integrate(pointers.data(), BODIES, duration), 0u);
        for (std::size_t n = 0; n < BODIES; ++n) {
            const RigidBody &body = bodies[n];
            const bool sound = body.getAngularMomentum() == momenta[n] && body.getRotation().isFinite() &&
                               std::fabs(body.getOrientation().squareMagnitude() - 1) < 1e-14;
            ASSERT_TRUE(sound) << "after a step of " << duration << " s";
        }
    }
}

// ---- Forces

TEST(ForcedMotion, ConstantGravityIsExactWhateverTheStep) {
    const Vector3 start(1, 200, -3), velocity(12, 25, -7), g = Vector3::GRAVITY;
    for (const bool asForce : {false, true}) {
        reference::Random random;
        World world;
        RigidBody body;
        Gravity gravity(g);
        body.setMass(3.7);
        body.setPosition(start);
        body.setVelocity(velocity);
        world.addBody(&body);
        if (asForce)
            world.getForceRegistry().add(&body, &gravity);
        else
            body.setAcceleration(g);
        real time = 0;
        for (int n = 0; n < 1000; ++n) {
            const real h = n < 300 ? STEP : random.logBetween(1e-5, 0.3);
            world.startFrame();
            world.runPhysics(h);
            time += h;
            const Vector3 exact = start + velocity * time + g * (time * time / 2);
            ASSERT_LT(difference(body.getPosition(), exact), 1e-13 * (1000 + exact.magnitude()));
            ASSERT_LT(difference(body.getVelocity(), velocity + g * time), 1e-13 * (100 + 10 * time));
        }
        EXPECT_GT(time, 20);
    }
}

TEST(ForcedMotion, ProjectileWithLinearDrag) {
    const Table table("ref_projectile_lineardrag.csv");
    const Vector3 windspeed(-4, 0, 2);
    Aero aero(diagonal(Vector3(-0.6, -0.9, -0.3)), Vector3(), &windspeed);
    World world;
    RigidBody body;
    body.setMass(3);
    body.setAcceleration(Vector3::GRAVITY);
    body.setPosition(0, 10, 0);
    body.setVelocity(30, 40, -5);
    world.addBody(&body);
    world.getForceRegistry().add(&body, &aero);
    real error = 0;
    ASSERT_EQ(table.size(), 101u);
    for (std::size_t row = 0; row < table.size(); ++row) {
        error = std::max(error, difference(body.getPosition(), table.getVector(row, "x", "y", "z")));
        for (int n = 0; n < STEPS_PER_ROW; ++n) {
            world.startFrame();
            world.runPhysics(STEP);
        }
    }
    expectBelow(error, 3e-3, "error in m");
}

TEST(ForcedMotion, FloatingBodyBobs) {
    const Table table("ref_buoyancy_bob.csv");
    for (const bool damped : {false, true}) {
        Buoyancy buoyancy(Vector3(), 0.5, 0.8, 2);
        World world;
        RigidBody body;
        body.setMass(400);
        body.setAcceleration(Vector3::GRAVITY);
        body.setLinearDamping(damped ? 0.9 : 1);
        body.setPosition(0, 2.3, 0);
        world.addBody(&body);
        world.getForceRegistry().add(&body, &buoyancy);
        real error = 0;
        ASSERT_EQ(table.size(), 301u);
        for (std::size_t row = 0; row < table.size(); ++row) {
            const real exact = table.get(row, damped ? "y_damped" : "y_undamped");
            error = std::max(error, std::fabs(body.getPosition().y - exact));
            for (int n = 0; n < STEPS_PER_ROW; ++n) {
                world.startFrame();
                world.runPhysics(STEP);
            }
        }
        expectBelow(error, 1.2e-2, damped ? "error in m, damped" : "error in m, undamped");
    }
}

/// From rest, as ∫A·d^t dt says, for dampings at which it takes a series and others.
TEST(ForcedMotion, DampedAccelerationIsIntegratedExactly) {
    for (const real damping : {0.999, 0.95, 0.9, 0.8, 0.1}) {
        RigidBody body;
        body.setLinearDamping(damping);
        body.setAcceleration(2, 0, 0);
        advance(body, 1);
        const real rate = -std::log(damping), wanted = 2 * -std::expm1(-rate * STEP) / rate;
        EXPECT_NEAR(body.getVelocity().x, wanted, 1e-12 * wanted) << damping;
    }
}

namespace {

/// The weight of a top whose pivot is the body's origin, as a torque.
class TopWeight : public ForceGenerator {
public:
    static Vector3 torque(const RigidBody &body) {
        return body.getDirectionInWorldSpace(Vector3(0, 0.1, 0)) % Vector3(0, -9.81, 0);
    }
    void updateForce(RigidBody *body, real) override { body->addTorque(torque(*body)); }
};

/// The largest error of the axis of a top in steady precession over ten seconds.
real errorOfHeavyTop(bool byGenerator) {
    const Table table("ref_heavytop_steady.csv");
    TopWeight weight;
    World world;
    RigidBody top;
    top.setInertiaTensor(diagonal(Vector3(0.05, 0.02, 0.05)));
    top.setOrientation(reference::turnAbout(Vector3::Z, REAL_PI / 6));
    top.setRotation(top.getDirectionInWorldSpace(Vector3(0.42157631156795422, 60, 0)));
    world.addBody(&top);
    if (byGenerator) world.getForceRegistry().add(&top, &weight);
    real error = 0;
    EXPECT_EQ(table.size(), 101u);
    for (std::size_t row = 0; row < table.size(); ++row) {
        const Vector3 axis = table.getVector(row, "axis_x", "axis_y", "axis_z");
        error = std::max(error, difference(top.getDirectionInWorldSpace(Vector3::Y), axis));
        for (int n = 0; n < STEPS_PER_ROW; ++n) {
            world.startFrame();
            if (!byGenerator) top.addTorque(TopWeight::torque(top));
            world.runPhysics(STEP);
        }
    }
    return error;
}

}  // namespace

TEST(ForcedMotion, HeavyTopPrecessesSteadily) {
    expectBelow(errorOfHeavyTop(true), 5e-3, "error of the axis");
    expectBelow(errorOfHeavyTop(false), 2e-2, "error of the axis, torque added by the caller");
}

namespace {

/// A body that hangs with a corner on a spring.
struct HangingBody {
    static constexpr real MASS = 2, STIFFNESS = 30, LENGTH = 1;
    const Vector3 inertia = Vector3(0.12, 0.2, 0.15), corner = Vector3(0.3, 0.4, -0.2),
                  anchor = Vector3(0, 4, 0);
    const Vector3 position = Vector3(0.5, 2, 0.3), velocity = Vector3(0.2, 0, -0.4),
                  spin = Vector3(0.5, 1, -0.3);

    Motion exact(real time) const {
        reference::System system;
        system.mass = MASS;
        system.inertia = inertia;
        system.loads = [this](const Motion &m) {
            const Vector3 arm = m.toWorld(corner), span = m.position + arm - anchor;
            const real length = std::sqrt(span * span);
            const Vector3 pull = span * (-STIFFNESS * (length - LENGTH) / length);
            return reference::Loads{pull + Vector3(0, -9.81 * MASS, 0), arm % pull};
        };
        Motion motion;
        motion.position = position;
        motion.velocity = velocity;
        motion.spin = spin;
        system.advance(motion, time, static_cast<int>(time * 1200 + 0.5));
        return motion;
    }
};

}  // namespace

TEST(ForcedMotion, BodyOnAnOffCentreSpring) {
    const HangingBody setup;
    AnchoredSpring spring(setup.corner, setup.anchor, HangingBody::STIFFNESS, HangingBody::LENGTH);
    World world;
    RigidBody body = spinningBody(setup.inertia, setup.spin);
    body.setMass(HangingBody::MASS);
    body.setPosition(setup.position);
    body.setVelocity(setup.velocity);
    body.setAcceleration(Vector3::GRAVITY);
    world.addBody(&body);
    world.getForceRegistry().add(&body, &spring);
    real error = 0, orientationError = 0, turned = 0;
    for (int second = 1; second <= 10; ++second) {
        for (int n = 0; n < 60; ++n) {
            world.startFrame();
            world.runPhysics(STEP);
        }
        const Motion exact = setup.exact(second);
        error = std::max(error, (body.getPosition() - exact.position).magnitude());
        orientationError = std::max(orientationError, difference(body.getOrientation(), exact.orientation));
        turned = std::max(turned, difference(exact.orientation, Quaternion()));
    }
    EXPECT_GT(turned, 0.5) << "the spring turns the body";
    expectBelow(error, 1e-2, "error in m");
    expectBelow(orientationError, 5e-2, "error of the orientation");
}

TEST(ForcedMotion, ConvergesWithSecondOrder) {
    const Vector3 inertia(0.3, 0.5, 0.4), windspeed(3, 0, 1), anchor(0, 1, 0), corner(0.2, 0.1, -0.3),
        wing(-0.4, 0.1, 0.2);
    const Matrix3 tensor(-0.2, 0, 0, 0.5, -0.6, 0, 0, 0, -0.3);
    reference::System system;
    system.mass = 2;
    system.inertia = inertia;
    system.loads = [&](const Motion &m) {
        const Vector3 drag = m.velocity * -(0.4 + 0.1 * std::sqrt(m.velocity * m.velocity));
        const Vector3 arm = m.toWorld(corner), span = m.position + arm - anchor;
        const real length = std::sqrt(span * span);
        const Vector3 pull = span * (-15 * (length - 0.5) / length);
        const Vector3 place = m.toWorld(wing), flow = m.velocity + windspeed + m.toWorld(m.spin) % place;
        const Vector3 lift = m.toWorld(tensor * m.toBody(flow));
        return reference::Loads{drag + pull + lift, arm % pull + place % lift};
    };
    Motion truth;
    truth.velocity = Vector3(2, 3, -1);
    truth.spin = Vector3(1, -2, 1.5);
    const Motion start = truth;
    system.advance(truth, 1, 2000);

    real errors[3];
    for (int halving = 0; halving < 3; ++halving) {
        Drag drag(0.4, 0.1);
        AnchoredSpring spring(corner, anchor, 15, 0.5);
        Aero aero(tensor, wing, &windspeed);
        aero.setRotationalFlow(true);
        World world;
        RigidBody body = spinningBody(inertia, start.spin);
        body.setMass(2);
        body.setVelocity(start.velocity);
        world.addBody(&body);
        for (ForceGenerator *generator :
             {static_cast<ForceGenerator *>(&drag), static_cast<ForceGenerator *>(&spring),
              static_cast<ForceGenerator *>(&aero)})
            world.getForceRegistry().add(&body, generator);
        const int steps = 60 << halving;
        for (int n = 0; n < steps; ++n) {
            world.startFrame();
            world.runPhysics(1.0 / steps);
        }
        errors[halving] =
            difference(body.getPosition(), truth.position) + difference(body.getVelocity(), truth.velocity) +
            difference(body.getOrientation(), truth.orientation) + difference(bodyRates(body), truth.spin);
    }
    reference::expectOrder(errors, 1.8);
    expectBelow(errors[0], 1e-2, "error at 1/60 s");
}

// ---- Blocks

namespace {

/// One of every kind of body that a step treats in its own way.
RigidBody anyBody(reference::Random &random) {
    RigidBody body;
    body.setMass(random.logBetween(0.1, 10));
    const Matrix3 tensor =
        diagonal(Vector3(random.logBetween(0.1, 10), random.logBetween(0.1, 10), random.logBetween(0.1, 10)));
    const Matrix3 tilt = cyclone_test::rotationMatrix(random.orientation());
    body.setInertiaTensor(random.oneIn(2) ? tensor : tilt * tensor * tilt.transpose());
    if (random.oneIn(6)) body.setInverseInertiaTensor(cyclone_test::diagonal(1, 0, random.below(2)));
    if (random.oneIn(6)) body.setInverseMass(0);
    if (random.oneIn(2)) body.setDamping(0.7, 0.8);
    body.setPosition(random.vector(10));
    body.setOrientation(random.orientation());
    body.setVelocity(random.vector(10));
    body.setRotation(random.vector(random.oneIn(4) ? 500 : 5));
    body.setAcceleration(random.oneIn(2) ? Vector3::GRAVITY : Vector3());
    if (random.oneIn(6)) body.setAwake(false);
    return body;
}

}  // namespace

TEST(Blocks, GiveTheBitsOfOneBodyAtATime) {
    reference::Random random;
    for (std::size_t count = 0; count <= 40; ++count) {
        std::vector<RigidBody> together, alone;
        for (std::size_t n = 0; n < count; ++n) together.push_back(anyBody(random));
        alone = together;
        std::vector<RigidBody *> pointers;
        for (RigidBody &body : together) pointers.push_back(&body);
        for (int round = 0; round < 20; ++round) {
            const real h = random.logBetween(1e-3, 0.1);
            for (std::size_t n = 0; n < count; ++n) {
                if (!random.oneIn(3)) continue;
                const Vector3 force = random.vector(10) * (random.oneIn(30) ? cyclone_test::QUIET_NAN : 1);
                const Vector3 arm = random.vector(1);
                for (RigidBody *body : {&together[n], &alone[n]}) body->addForceAtBodyPoint(force, arm);
            }
            std::size_t faults = 0;
            for (RigidBody &body : alone)
                if (!body.integrate(h)) ++faults;
            ASSERT_EQ(RigidBody::integrate(pointers.data(), count, h), faults);
            for (std::size_t n = 0; n < count; ++n) {
                const RigidBody &a = together[n], &b = alone[n];
                ASSERT_EQ(a.getAwake(), b.getAwake());
                ASSERT_EQ(a.hasFaulted(), b.hasFaulted());
                ASSERT_TRUE(a.getTransform() == b.getTransform() &&
                            a.getOrientation() == b.getOrientation() && a.getVelocity() == b.getVelocity() &&
                            a.getRotation() == b.getRotation() &&
                            a.getAngularMomentum() == b.getAngularMomentum() &&
                            a.getLastFrameAcceleration() == b.getLastFrameAcceleration())
                    << "body " << n << " of " << count;
            }
        }
    }
}

TEST(Blocks, PassSleepersAndFaultsBy) {
    std::vector<RigidBody> bodies(20);
    std::vector<RigidBody *> pointers;
    for (RigidBody &body : bodies) {
        body.setVelocity(1, 2, 3);
        pointers.push_back(&body);
    }
    bodies[3].addForce(Vector3(cyclone_test::QUIET_NAN, 0, 0));
    bodies[11].setAwake(false);
    bodies[17].addTorque(Vector3(0, cyclone_test::PLUS_INFINITY, 0));
    EXPECT_EQ(RigidBody::integrate(pointers.data(), pointers.size(), 0.5), 2u);
    for (std::size_t n = 0; n < bodies.size(); ++n) {
        const bool advanced = n != 3 && n != 11 && n != 17;
        EXPECT_EQ(bodies[n].getPosition(), advanced ? Vector3(0.5, 1, 1.5) : Vector3()) << n;
        EXPECT_EQ(bodies[n].hasFaulted(), n == 3 || n == 17) << n;
    }
    EXPECT_EQ(RigidBody::integrate(nullptr, 0, 1), 0u);
}
