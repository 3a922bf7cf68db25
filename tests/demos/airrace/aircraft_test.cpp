// The three aircraft differ as is said of them: top speed, rolling, stalling. And none gets energy from
// nowhere.
#include "airrace/aircraft.h"

#include <gtest/gtest.h>

#include <cmath>

#include "airrace/pilot.h"
#include "base/random.h"
#include "models/attitude.h"

using namespace airrace;

namespace {

constexpr real STEP = 1.0 / 60, G = 9.81;

/// One aircraft in still air, high up.
struct Sky {
    cyclone::World world;
    cyclone::WindSum air;
    std::unique_ptr<Aircraft> aircraft;
    Stabiliser stabiliser;

    explicit Sky(const std::string &name) : aircraft(Aircraft::make(name, world, &air)) {
        aircraft->launch(Vector3(0, 2000, 0));
    }
    void step() {
        world.startFrame();
        world.runPhysics(STEP);
    }
    void hold(const Command &command, real seconds) {
        for (int n = 0; n < seconds / STEP; ++n) {
            aircraft->setSticks(stabiliser.hold(*aircraft, command, STEP));
            step();
        }
    }
    void fly(const Sticks &sticks, real seconds) {
        aircraft->setSticks(sticks);
        for (int n = 0; n < seconds / STEP; ++n) step();
    }
    real getHeight() const { return aircraft->getBody().getPosition().y; }
    Vector3 getRates() const {
        return aircraft->getBody().getDirectionInLocalSpace(aircraft->getBody().getRotation());
    }
};

real topSpeed(const std::string &name) {
    Sky sky(name);
    sky.hold(Command{0, 0, 1}, 90);
    EXPECT_NEAR(sky.aircraft->getClimbAngle(), 0, 0.002) << name;
    return sky.aircraft->getAirspeed();
}

/// rad/s, that full aileron gives at the cruising speed.
real rollRate(const std::string &name) {
    Sky sky(name);
    real most = 0;
    sky.aircraft->setSticks({0, 1, 0.5});
    for (int n = 0; n < 60; ++n) {
        sky.step();
        most = std::max(most, sky.getRates().x);
    }
    return most;
}

/// Where thrust, which falls with the speed, is drag: the speed at which it flies level.
template <class Drag>
real balance(const Model &model, Drag drag) {
    real low = 30, high = 150;
    for (int n = 0; n < 60; ++n) {
        const real speed = (low + high) / 2;
        (model.maxThrust * (1 - speed / model.pitchSpeed) > drag(speed) ? low : high) = speed;
    }
    return low;
}

}  // namespace

TEST(DemoRacers, ReachTheTopSpeedThatThrustAndDragGive) {
    // A plate with A = -diag(D, K) that lifts the weight W at u has the angle W/(K·u), and drags D·u +
    // W²/(K·u).
    const auto plates = [](const std::string &name, real lift, real drag) {
        const Model model = Sky(name).aircraft->getModel();
        const real weight = model.mass * G;
        return balance(model, [&](real u) { return drag * u + weight * weight / (lift * u); });
    };
    EXPECT_NEAR(topSpeed("bullet"), plates("bullet", 4000, 20), 0.5);
    EXPECT_NEAR(topSpeed("gnat"), plates("gnat", 3000, 28), 0.5);

    // Wings of 7.5 m × 1.25 m, a tail of 2.1 m² and a fin of 1.4 m² at CD0 = 0.01, a fuselage of 0.3 m².
    const Model model = Sky("swallow").aircraft->getModel();
    const real area = 7.5 * 1.25, ratio = 7.5 / 1.25;
    const real stalling = balance(model, [&](real u) {
        const real pressure = 0.5 * 1.225 * u * u, lift = model.mass * G / (pressure * area);
        return pressure * (0.01 * (area + 2.1 + 1.4) + 0.3 + area * lift * lift / (cyclone::REAL_PI * ratio));
    });
    EXPECT_NEAR(topSpeed("swallow"), stalling, 0.5);
}

TEST(DemoRacers, TheBulletIsFastAndSluggishAndTheGnatNimble) {
    EXPECT_GT(topSpeed("bullet"), topSpeed("swallow") + 10);
    EXPECT_GT(topSpeed("swallow"), topSpeed("gnat") + 3);
    EXPECT_GT(rollRate("gnat"), 1.5 * rollRate("swallow"));
    EXPECT_GT(rollRate("swallow"), 1.15 * rollRate("bullet"));
    for (const char *name : {"bullet", "gnat"}) {
        // Steady, the way that a wing's middle goes down cancels the angle that the aileron gives it.
        const Model model = Sky(name).aircraft->getModel();
        EXPECT_NEAR(rollRate(name), model.cruise * model.aileron / (model.span / 4), 0.07 * rollRate(name));
    }
}

TEST(DemoRacers, OnlyTheSwallowStalls) {
    for (const std::string &name : Aircraft::NAMES) {
        Sky sky(name);
        bool stalled = false;
        sky.hold(Command{0, 0, 0}, 5);
        for (int n = 0; n < 240; ++n) {
            sky.fly({1, 0, 0}, STEP);
            stalled = stalled || sky.aircraft->isStalled();
        }
        EXPECT_EQ(stalled, name == "swallow") << name;
    }
}

TEST(DemoRacers, TheSwallowStallsWhereItsModelSays) {
    Sky sky("swallow");
    const real stallSpeed = sky.aircraft->getModel().stallSpeed;
    while (!sky.aircraft->isStalled() && sky.aircraft->getAirspeed() > 10) sky.hold(Command{0, 0, 0}, STEP);
    EXPECT_NEAR(sky.aircraft->getAirspeed(), stallSpeed, 0.1 * stallSpeed);
    EXPECT_NEAR(sky.getHeight(), 2000, 20) << "it held its height until then";
}

TEST(DemoRacers, TheStallThreatensInSteepTurnsEarlier) {
    // A level turn at bank b needs the lift weight/cos(b), so it stalls at the speed V·√(1/cos(b)).
    Sky sky("swallow");
    const real bank = 1.1;
    sky.hold(Command{bank, 0, 0.8}, 4);
    while (!sky.aircraft->isStalled() && sky.aircraft->getAirspeed() > 10)
        sky.hold(Command{bank, 0, 0}, STEP);
    const real expected = sky.aircraft->getModel().stallSpeed / std::sqrt(std::cos(bank));
    EXPECT_NEAR(sky.aircraft->getAirspeed(), expected, 0.1 * expected);
}

TEST(DemoRacers, WithoutThrustNoStickGivesEnergy) {
    for (const std::string &name : Aircraft::NAMES) {
        Sky sky(name);
        demo::Random random(5);
        const auto energy = [&] {
            const RigidBody &body = sky.aircraft->getBody();
            const Vector3 w = sky.getRates(), moments = sky.aircraft->getModel().momentsOfInertia;
            return body.getMass() * (0.5 * body.getVelocity().squareMagnitude() + G * sky.getHeight()) +
                   0.5 * w.componentProduct(moments) * w;
        };
        real last = energy();
        for (int n = 0; n < 200; ++n) {
            const real elevator = random.between(-1, 1), aileron = random.between(-1, 1);
            sky.fly({elevator, aileron, 0}, 0.1);
            const real now = energy();
            EXPECT_LT(now, last) << name << " at " << n;
            last = now;
        }
    }
}

TEST(DemoStabiliser, TakesABankAndAClimbAndKeepsThem) {
    for (const std::string &name : Aircraft::NAMES)
        for (const real bank : {-0.9, 0.0, 0.5}) {
            Sky sky(name);
            sky.hold(Command{bank, 0.05, 1}, 8);
            const RigidBody &body = sky.aircraft->getBody();
            EXPECT_NEAR(demo::bankOf(body), bank, 0.05) << name;
            EXPECT_NEAR(sky.aircraft->getClimbAngle(), 0.05, 0.02) << name;
            // A steady turn: speed·ω = g·tan(bank).
            const real turning = -body.getRotation().y * body.getVelocity().magnitude();
            EXPECT_NEAR(turning, G * std::tan(bank), 0.08 * G) << name;
        }
}

TEST(DemoRacers, AnUnknownNameIsRefused) {
    cyclone::World world;
    EXPECT_THROW(Aircraft::make("zeppelin", world, nullptr), std::invalid_argument);
}
