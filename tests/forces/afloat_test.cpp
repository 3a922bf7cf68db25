// Boats and floats in water that moves: buoyancy, hull drag, and surfaces and screws that know where the
// water is.
#include <cyclone/cyclone.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "frames.h"
#include "random.h"

using namespace cyclone;
using namespace cyclone_test;

namespace {

/// Level water at y = 0 that flows.
class River : public Water {
public:
    explicit River(const Vector3 &velocity) : current(velocity) {}
    real getHeight(const Vector3 &) const override { return 0; }
    Vector3 getVelocity(const Vector3 &) const override { return current; }

private:
    Vector3 current;
};

RigidBody at(const Vector3 &position) {
    RigidBody body;
    body.setPosition(position);
    return body;
}

// ---- Surfaces and screws

TEST(AeroInWater, WorksAsFarAsItIsUnderWater) {
    const Waves still(2);
    Aero keel(diagonal(-1, -2, -300), Vector3(0, -1, 0), nullptr);
    keel.setWater(&still, 0.5);
    const real heights[] = {9, 3, 2.875, 2.75, 2.5, -50}, shares[] = {0, 0, 0.25, 0.5, 1, 1};
    for (int n = 0; n < 6; ++n) {
        RigidBody boat = at(Vector3(0, heights[n], 0));
        boat.setVelocity(3, 0, -2);
        EXPECT_TRUE(isNear(keel.getForce(boat), Vector3(-3, 0, 600) * shares[n], 1e-12)) << heights[n];
    }
    RigidBody dry = at(Vector3(0, 9, 0));
    dry.setVelocity(3, 0, -2);
    keel.setWater(nullptr, 0.5);
    EXPECT_EQ(keel.getForce(dry), Vector3(-3, 0, 600));
}

TEST(AeroInWater, FeelsTheFlowPastTheWater) {
    const River river(Vector3(2, 0, -1));
    RigidBody boat;
    boat.setVelocity(3, 0, 0);
    boat.setRotation(0, 0.5, 0);  // rotation × (2, −1, 0) is (0, 0, −1)
    AngledAero rudder(diagonal(-1, -2, -300), Vector3(2, -1, 0), nullptr);
    rudder.setWater(&river, 0.5);
    EXPECT_TRUE(isNear(rudder.getForce(boat), Vector3(-1, 0, -300), 1e-12));
    rudder.setRotationalFlow(true);
    EXPECT_TRUE(isNear(rudder.getForce(boat), Vector3(-1, 0, 0), 1e-12));
}

TEST(ThrusterInWater, FadesAsItsScrewComesOut) {
    const Waves still;
    Thruster engine(Vector3::X, Vector3(-2, -0.5, 0), 100);
    engine.setThrottle(1);
    engine.setWater(&still, 0.2);
    const real heights[] = {5, 0.7, 0.6, 0.5, 0.4, 0.3, -9}, shares[] = {0, 0, 0.25, 0.5, 0.75, 1, 1};
    for (int n = 0; n < 7; ++n)
        EXPECT_TRUE(
            isNear(engine.getForce(at(Vector3(0, heights[n], 0))), Vector3(100 * shares[n], 0, 0), 1e-12));
    engine.setWater(nullptr, 0.2);
    EXPECT_EQ(engine.getForce(at(Vector3(0, 5, 0))), Vector3(100, 0, 0));
}

TEST(PropellerInWater, AdvancesThroughTheWater) {
    const River river(Vector3(4, 0, 0));
    Propeller screw(Vector3::X, Vector3(0, -1, 0), 100, 10, nullptr);
    screw.setThrottle(1);
    screw.setWater(&river, 0.2);
    RigidBody boat;
    boat.setVelocity(9, 0, 0);
    EXPECT_TRUE(isNear(screw.getForce(boat), Vector3(50, 0, 0), 1e-12));
}

// ---- Hull drag

TEST(HullDrag, IsLinearPlusQuadraticAlongEachAxisOfTheHull) {
    const Buoyancy deep(Vector3(), 0.5, 1, 100), half(Vector3(), 0.5, 1, 0), dry(Vector3(), 0.5, 1, -100);
    const Vector3 linear(3, 5, 7), quadratic(2, 1, 4);
    RigidBody body;
    body.setVelocity(2, -1, 3);
    const Vector3 full(-(3 + 2 * 2) * 2, 5 + 1, -(7 + 4 * 3) * 3);
    EXPECT_EQ(HullDrag(&deep, Vector3(), linear, quadratic).getForce(body), full);
    EXPECT_EQ(HullDrag(&half, Vector3(), linear, quadratic).getForce(body), full * 0.5);
    EXPECT_EQ(HullDrag(&dry, Vector3(), linear, quadratic).getForce(body), Vector3());

    body.setOrientation(Quaternion::fromAxisAngle(Vector3::Y, -REAL_PI / 2));  // the bow towards +Z
    body.setVelocity(0, 0, 2);
    EXPECT_TRUE(
        isNear(HullDrag(&deep, Vector3(), linear, quadratic).getForce(body), Vector3(0, 0, -14), 1e-12));
}

TEST(HullDrag, FeelsTurningAndTheCurrent) {
    const River river(Vector3(1, 0, 0));
    Buoyancy hull(Vector3(0, -5, 0), 0.5, 1, 0);
    hull.setWater(&river);
    EXPECT_EQ(hull.getWater(), &river);
    const HullDrag drag(&hull, Vector3(0, 0, 2), Vector3(3, 3, 3), Vector3(1, 1, 1));
    RigidBody body;
    EXPECT_EQ(drag.getForce(body), Vector3(3 + 1, 0, 0));
    EXPECT_EQ(drag.getPosition(), Vector3(0, 0, 2));
    body.setRotation(0, 1, 0);  // rotation × (0, 0, 2) is (2, 0, 0), and the water goes at 1
    EXPECT_TRUE(isNear(drag.getForce(body), Vector3(-(3 + 1), 0, 0), 1e-12));
}

TEST(HullDrag, TakesEnergyAndNeverGivesAny) {
    Random random(32);
    const Buoyancy hull(Vector3(), 1, 1, 5);
    const HullDrag drag(&hull, Vector3(), Vector3(3, 5, 7), Vector3(1, 2, 4));
    RigidBody body;
    for (int n = 0; n < 100; ++n) {
        body.setOrientation(random.orientation());
        body.setVelocity(random.vector(5));
        EXPECT_LT(drag.getForce(body) * body.getVelocity(), 0);
    }
}

TEST(HullDrag, MayBeAsStrongAsItLikes) {
    // Far beyond what an explicit step bears: the hull stops, in the water and on its way, and never goes
    // back.
    for (const real strength : {1e3, 1e6, 1e12}) {
        World world;
        RigidBody *body = world.createBody();
        const Buoyancy hull(Vector3(), 0.5, 1, 100);
        HullDrag drag(&hull, Vector3(0.3, 0, 0), Vector3(0.1, 1, 1) * strength, Vector3(1, 1, 1) * strength);
        world.getForceRegistry().add(body, &drag);
        body->setVelocity(20, 5, -3);
        body->setRotation(1, 2, 3);
        const auto energy = [&] {  // of 1 kg and unit inertia
            return body->getVelocity().squareMagnitude() + body->getRotation().squareMagnitude();
        };
        real last = energy();
        for (int n = 0; n < 600; ++n) {
            run(world, 1);
            ASSERT_LE(energy(), 1.0001 * last) << strength << " at frame " << n;
            last = energy();
        }
        const Vector3 centre = body->getPointInWorldSpace(drag.getPosition());
        EXPECT_LT(body->getVelocityAtPoint(centre).magnitude(), 0.05) << strength;
    }
}

// ---- Carried by the water

TEST(Afloat, SmallFloatMovesWithTheWaterOfALongWave) {
    // A particle of the surface goes round (x + a·cos θ, a·sin θ), θ = k·x − ω·t, apart from Stokes' drift.
    const real amplitude = 0.3, wavelength = 100, k = 2 * REAL_PI / wavelength, omega = std::sqrt(9.81 * k);
    Waves sea;
    sea.addTrain({amplitude, wavelength, 0, 0});
    World world;
    RigidBody *body = world.createBody();
    body->setMass(50);
    body->setAcceleration(Vector3::GRAVITY);
    Buoyancy ball(Vector3(), 0.25, 0.1, 0);
    ball.setWater(&sea);
    HullDrag drag(&ball, Vector3(), Vector3(100, 100, 100), Vector3());
    world.getForceRegistry().add(body, &ball);
    world.getForceRegistry().add(body, &drag);

    const int frames = static_cast<int>(std::lround(4 * 2 * REAL_PI / omega / STEP));  // four periods
    const auto frame = [&] {
        sea.setTime(sea.getTime() + STEP);
        run(world, 1);
    };
    for (int n = 0; n < frames; ++n) frame();

    // Fourier's component at ω, the drift taken out: of the position a·e^{−iθ} = a·e^{iωt}·e^{−ikx}.
    std::vector<Vector3> path;
    const real start = sea.getTime();
    for (int n = 0; n <= frames; ++n, frame()) path.push_back(body->getPosition());
    const Vector3 drift = (path.back() - path.front()) * (1.0 / frames);
    std::complex<real> along, up;
    real meanX = 0;
    for (int n = 0; n < frames; ++n) {
        const auto turn = std::polar(2.0 / frames, -omega * (start + n * STEP));
        const Vector3 p = path[static_cast<std::size_t>(n)] - drift * n;
        along += turn * p.x;
        up += turn * p.y;
        meanX += p.x / frames;
    }
    EXPECT_NEAR(std::abs(along), amplitude, 0.05 * amplitude);
    EXPECT_NEAR(std::abs(up), amplitude, 0.05 * amplitude);
    // cos θ = cos(ωt − kx); sin θ = cos(ωt − kx + π/2).
    const std::complex<real> i(0, 1), atMean = std::polar(1.0, -k * meanX);
    EXPECT_NEAR(std::arg(along / atMean), 0, 0.05);
    EXPECT_NEAR(std::arg(up / (atMean * i)), 0, 0.05);
}

/// A boat whose hull is in quarters, at ±quarter.x and ±quarter.z.
struct Boat {
    World world;
    RigidBody *body = world.createBody();
    std::vector<Buoyancy> hulls;
    std::vector<HullDrag> drags;

    struct Hull {
        Vector3 quarter;
        real maxDepth, volume;      // of each quarter
        Vector3 linear, quadratic;  // likewise
    };

    Boat(const Water *water, real mass, const Vector3 &halfSizes, const Hull &hull) {
        Matrix3 inertia;
        inertia.setBlockInertiaTensor(halfSizes, mass);
        body->setMass(mass);
        body->setInertiaTensor(inertia);
        body->setAcceleration(Vector3::GRAVITY);
        hulls.reserve(4);
        for (const Vector3 &centre : quarters(hull.quarter)) {
            hulls.emplace_back(centre, hull.maxDepth, hull.volume, 0);
            hulls.back().setWater(water);
            drags.emplace_back(&hulls.back(), centre, hull.linear, hull.quadratic);
        }
        for (Buoyancy &part : hulls) add(part);
        for (HullDrag &drag : drags) add(drag);
    }
    static std::array<Vector3, 4> quarters(const Vector3 &q) {
        return {q, Vector3(q.x, q.y, -q.z), Vector3(-q.x, q.y, q.z), Vector3(-q.x, q.y, -q.z)};
    }
    void add(PointForce &force) {
        world.getForceRegistry().add(body, &force);
        forces.push_back(&force);
    }
    /// By all forces and gravity, N.
    Vector3 sumOfForces() const {
        Vector3 sum = Vector3::GRAVITY * body->getMass();
        for (const PointForce *force : forces) sum += force->getForce(*body);
        return sum;
    }
    real pitch() const { return std::asin(body->getDirectionInWorldSpace(Vector3::X).y); }

private:
    std::vector<PointForce *> forces;
};

/// 2 t, 6 m × 2 m, draws 0.4 m of the 0.8 m of its hull.
struct Barge : Boat {
    explicit Barge(const Water *water)
        : Boat(water, 2000, Vector3(3, 0.5, 1),
               {Vector3(1.8, -0.2, 0.7), 0.4, 1, Vector3(100, 2000, 800), Vector3(20, 200, 200)}) {
        body->setPosition(0, 0.2, 0);
    }
};

TEST(Afloat, BoatBeamOnToLongWavesRollsWithTheirSlope) {
    const real amplitude = 0.8, wavelength = 60, steepness = amplitude * 2 * REAL_PI / wavelength;
    Waves sea;
    sea.addTrain({amplitude, wavelength, REAL_PI / 2, 0});
    Barge barge(&sea);
    real greatest = 0;
    for (int n = 0; n < 60 * 120; ++n) {
        sea.setTime(n * STEP);
        run(barge.world, 1);
        if (n < 20 * 120) continue;  // set going
        const Vector3 up = barge.body->getDirectionInWorldSpace(Vector3::UP);
        const Vector3 normal = sea.getNormal(barge.body->getPosition());
        ASSERT_TRUE(isNear(up, normal, 0.15 * steepness)) << n * STEP;
        greatest = std::fmax(greatest, std::fabs(up.z));
    }
    EXPECT_NEAR(greatest, std::sin(std::atan(steepness)), 0.1 * steepness);
}

TEST(Afloat, CurrentCarriesADriftingBoatAtItsSpeed) {
    const River river(Vector3(1.5, 0, -0.5));
    Barge barge(&river);
    Aero keel(diagonal(-20, -20, -900), Vector3(0, -0.8, 0), nullptr);
    keel.setWater(&river, 0.5);
    barge.add(keel);
    run(barge.world, 120 * 120);
    EXPECT_TRUE(isNear(barge.body->getVelocity(), Vector3(1.5, 0, -0.5), 1e-3));
    EXPECT_TRUE(isNear(barge.body->getRotation(), Vector3(), 1e-3));
}

// ---- Lifted by the water

/// 1 t with an outboard motor of 3 kN and a flat bottom, far wider than deep, that is 5° up at the bow.
struct PlaningBoat : Boat {
    std::vector<AngledAero> bottom;
    Aero leg{diagonal(-50, 0, -300), Vector3(-2.2, -0.9, 0), nullptr};
    Thruster motor{Vector3::X, Vector3(-2.2, -0.9, 0), 3000};
    Drag air{0, 0.5};

    explicit PlaningBoat(const Water *water)
        : Boat(water, 1000, Vector3(2.5, 0.4, 1),
               {Vector3(1.5, -0.1, 0.6), 0.2, 0.45, Vector3(30, 1500, 400), Vector3(20, 100, 100)}) {
        bottom.reserve(4);
        for (const Vector3 &point : quarters(Vector3(1.5, -0.3, 0.6))) {
            bottom.emplace_back(diagonal(-5, -5000, 0), point, nullptr);
            bottom.back().setOrientation(Quaternion::fromAxisAngle(Vector3::Z, 5 * REAL_PI / 180));
            bottom.back().setRotationalFlow(true);
            bottom.back().setWater(water, 0.1);
            add(bottom.back());
        }
        leg.setRotationalFlow(true);
        leg.setWater(water, 0.2);
        motor.setWater(water, 0.15);
        for (PointForce *force : {static_cast<PointForce *>(&leg), static_cast<PointForce *>(&motor),
                                  static_cast<PointForce *>(&air)})
            add(*force);
    }
    real dynamicLift() const {
        real lift = 0;
        for (const AngledAero &plate : bottom) lift += plate.getForce(*body).y;
        return lift;
    }
};

TEST(Afloat, FlatBottomPlanesAndSettlesAtASpeed) {
    const Waves still;
    PlaningBoat boat(&still);
    run(boat.world, 60 * 120);
    const real height = boat.body->getPosition().y;
    EXPECT_NEAR(boat.dynamicLift(), 0, 1) << "at rest it floats";

    boat.motor.setThrottle(1);
    run(boat.world, 60 * 120);
    EXPECT_GT(boat.dynamicLift(), 0.8 * 9810) << "its bottom carries it";
    EXPECT_GT(boat.body->getPosition().y, height + 0.1);
    const real speed = boat.body->getVelocity().x;
    EXPECT_GT(speed, 10);
    EXPECT_LT(std::fabs(boat.pitch()), 0.02);
    run(boat.world, 20 * 120);
    EXPECT_NEAR(boat.body->getVelocity().x, speed, 1e-3 * speed);
    EXPECT_TRUE(isNear(boat.sumOfForces(), Vector3(), 1));
}

/// 400 kg on four foils, 0.9 m below its hull.
struct FoilBoat : Boat {
    static constexpr real LIFT = 150, ACROSS = 1500, DRAG = 10, FULL_DEPTH = 0.8, FOIL_DEPTH = 1, AIR = 2;

    std::vector<Aero> foils;
    Thruster engine{Vector3::X, Vector3(0, -0.8, 0), 1000};
    Drag air{0, AIR};

    explicit FoilBoat(const Water *water)
        : Boat(water, 400, Vector3(2.5, 0.3, 0.8),
               {Vector3(1.5, -0.1, 0.6), 0.2, 0.2, Vector3(10, 800, 300), Vector3(10, 100, 100)}) {
        foils.reserve(4);
        for (const Vector3 &point : quarters(Vector3(1.5, -FOIL_DEPTH, 0.6))) {
            foils.emplace_back(Matrix3(-DRAG, 0, 0, LIFT, -ACROSS, 0, 0, 0, -100), point, nullptr);
            foils.back().setRotationalFlow(true);
            foils.back().setWater(water, FULL_DEPTH);
            add(foils.back());
        }
        add(engine);
        add(air);
    }
};

TEST(Afloat, HydrofoilBoatLiftsOutAndFliesLevelAtItsHeight) {
    const Waves still;
    FoilBoat boat(&still);
    const real weight = 400 * 9.81;
    real lastHeight = 0;
    for (const real throttle : {0.2, 0.4, 0.7, 1.0}) {
        boat.engine.setThrottle(throttle);
        run(boat.world, 60 * 120);
        const real speed = boat.body->getVelocity().x, height = boat.body->getPosition().y;
        EXPECT_GT(height, lastHeight + 0.03) << throttle;
        lastHeight = height;
        EXPECT_LT(std::fabs(boat.pitch()), 0.02);
        // Foils as deep as they can be carry the boat from 4·LIFT·v = weight on.
        EXPECT_EQ(boat.hulls[0].getSubmersion(*boat.body) == 0, 4 * FoilBoat::LIFT * speed > weight);
        if (throttle < 0.5) continue;
        // Level flight: 4·(LIFT + ACROSS·pitch)·v·depth/FULL_DEPTH = weight; about weight·DRAG/LIFT + AIR·v²
        // is the drag.
        const real lift = 4 * (FoilBoat::LIFT + FoilBoat::ACROSS * boat.pitch()) * speed;
        const real depth = FoilBoat::FULL_DEPTH * weight / lift;
        EXPECT_NEAR(height, FoilBoat::FOIL_DEPTH - depth, 0.01);
        const real drag = weight * FoilBoat::DRAG / FoilBoat::LIFT;
        EXPECT_NEAR(speed, std::sqrt((1000 * throttle - drag) / FoilBoat::AIR), 0.05 * speed);
        EXPECT_TRUE(isNear(boat.sumOfForces(), Vector3(), 1));
    }
}

}  // namespace
