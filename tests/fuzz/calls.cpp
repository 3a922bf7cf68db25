/// Any sequence of calls, with any numbers: what the README promises holds after each, and the same calls
/// give the same bits on one thread and on three.
#include <cyclone/cyclone.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <vector>

#include "input.h"

using namespace cyclone;
using namespace cyclone_fuzz;

namespace {

constexpr std::size_t MOST_BODIES = 12, MOST_FORCES = 24;

/// A game: a world, the bodies and generators that the caller owns, and what was saved.
class Game {
public:
    Game(std::size_t threads, bool hasCrowd) {
        waves.addTrain({0.5, 20, 0.3, 1});
        air.add(&breeze);
        air.add(&thermal);
        air.add(&turbulence);
        world.setWorkers(threads);
        // Below some thousands a world stays on one thread.
        for (int n = 0; hasCrowd && n < 4100; ++n) {
            RigidBody *const body = world.createBody();
            body->setVelocity(n, 1, 0);
            world.getForceRegistry().add(body, &drag);
        }
        crowd = world.getBodies().size();
    }

    /// One call. Its arguments may be refused, but then no body has changed.
    void call(Input &input) {
        const std::uint64_t before = hashBodies();
        try {
            const unsigned which = input.below(8);
            if (which < 4)
                callBody(input);
            else if (which < 6)
                callForces(input);
            else
                callWorld(input);
        } catch (const std::invalid_argument &) {
            expect(hashBodies() == before, "a refused call changes nothing");
        }
    }

    void check() const {
        for (const RigidBody *body : world.getBodies()) {
            const RigidBody::State state = body->getState();
            const char *const error = state.findError();
            expect(error == nullptr, error);
            expect(real_abs(state.orientation.squareMagnitude() - 1) < 1e-12, "orientations are unit");
            expect(body->getTransform().getAxisVector(3) == state.position, "transforms are current");
        }
        for (const RigidBody *body : world.getFaultedBodies()) {
            const World::RigidBodies &bodies = world.getBodies();
            expect(std::find(bodies.begin(), bodies.end(), body) != bodies.end(), "what is listed is there");
        }
    }
    std::uint64_t hash() const { return world.hash(); }

private:
    std::uint64_t hashBodies() const {
        const World::RigidBodies &bodies = world.getBodies();
        return crowd > 0 ? 0 : hashStates(bodies.data(), bodies.size());
    }
    RigidBody *body(Input &input) {
        const World::RigidBodies &bodies = world.getBodies();
        return bodies.empty()
                   ? nullptr
                   : bodies[bodies.size() - 1 - input.byte() % std::min(bodies.size(), MOST_BODIES)];
    }

    void callBody(Input &input) {
        RigidBody *const its = body(input);
        if (its == nullptr) return;
        switch (input.below(26)) {
            case 0:
                return its->setMass(input.number());
            case 1:
                return its->setInverseMass(input.number());
            case 2:
                return its->setInertiaTensor(input.matrix());
            case 3:
                return its->setInverseInertiaTensor(input.matrix());
            case 4:
                return its->setDamping(input.number(), input.number());
            case 5:
                return its->setPosition(input.vector());
            case 6:
                return its->setOrientation(input.quaternion());
            case 7:
                return its->setVelocity(input.vector());
            case 8:
                return its->setRotation(input.vector());
            case 9:
                return its->addVelocity(input.vector());
            case 10:
                return its->addRotation(input.vector());
            case 11:
                return its->setAcceleration(input.vector());
            case 12:
                return its->addForce(input.vector());
            case 13:
                return its->addForceAtPoint(input.vector(), input.vector());
            case 14:
                return its->addForceAtBodyPoint(input.vector(), input.vector());
            case 15:
                return its->addTorque(input.vector());
            case 16:
                return its->clearAccumulators();
            case 17:
                return its->setAwake(input.flag());
            case 18:
                return its->setCanSleep(input.flag());
            case 19:
                return its->setSleepEpsilon(input.number());
            case 20:
                its->integrate(input.duration());
                return;
            case 21:
                return MassProperties::box(input.vector(), Mass(input.number())).applyTo(*its);
            case 22: {
                RigidBody copy = *its;
                copy.setState(its->getState());
                expect(copy.integrate(0.01) == RigidBody(*its).integrate(0.01), "a copy steps alike");
                return;
            }
            case 23:
                return its->addResistance(input.number(), input.number());
            case 24: {
                const std::uint8_t locks = input.byte();
                return its->setLockedMotion((locks & 1) != 0, (locks & 2) != 0, (locks & 4) != 0);
            }
            default:
                its->calculateDerivedData();
        }
    }

    void callForces(Input &input) {
        ForceRegistry &registry = world.getForceRegistry();
        RigidBody *const its = body(input);
        if (its == nullptr || registry.size() > crowd + MOST_FORCES) return registry.clear();
        switch (input.below(4)) {
            case 0:
                return callSprings(*its, input);
            case 1:
                return callSurfaces(*its, input);
            case 2:
                return callEngines(*its, input);
            default:
                return callRegistry(*its, input);
        }
    }

    void callSprings(RigidBody &its, Input &input) {
        switch (input.below(5)) {
            case 0:
                return damp(spring<Spring>(its, input), input);
            case 1:
                return damp(spring<Bungee>(its, input), input);
            case 2:
                return damp(world.createForce<AnchoredSpring>(&its, input.vector(), input.vector(),
                                                              input.number(), input.number()),
                            input);
            case 3:
                return anchored.setAnchor(input.vector());
            default:
                return damp(anchored, input);
        }
    }
    template <class Kind>
    Kind &spring(RigidBody &its, Input &input) {
        const Vector3 here = input.vector(), there = input.vector();
        return world.createSpring<Kind>(&its, here, body(input), there, input.number(), input.number());
    }
    void damp(ElasticForce &force, Input &input) {
        force.setDamping(input.number());
        if (input.flag()) force.setRestLength(input.number());
        if (input.flag()) force.setSpringConstant(input.number());
    }

    void callSurfaces(RigidBody &its, Input &input) {
        const Vector3 *const wind = input.flag() ? &windspeed : nullptr;
        const WindField *const field = input.flag() ? &air : nullptr;
        switch (input.below(5)) {
            case 0:
                return world.createForce<Drag>(&its, input.number(), input.number()).setWind(field);
            case 1: {
                Aero &aero = world.createForce<Aero>(&its, input.matrix(), input.vector(), wind);
                aero.setWind(field);
                if (input.flag()) aero.setWater(&waves, input.number());
                return aero.setRotationalFlow(input.flag());
            }
            case 2:
                return world
                    .createForce<AeroControl>(&its, input.matrix(), input.matrix(), input.matrix(),
                                              input.vector(), wind)
                    .setControl(input.number());
            case 3:
                return world.createForce<AngledAero>(&its, input.matrix(), input.vector(), wind)
                    .setOrientation(input.quaternion());
            default: {
                Wing &wing =
                    world.createForce<Wing>(&its, input.number(), input.number(), input.vector(), wind);
                wing.setWind(field);
                wing.setFlap(input.number(), input.number());
                wing.setControl(input.number());
                return wing.setOrientation(input.quaternion());
            }
        }
    }

    void callEngines(RigidBody &its, Input &input) {
        const Vector3 *const wind = input.flag() ? &windspeed : nullptr;
        switch (input.below(5)) {
            case 0:
                return world
                    .createForce<Buoyancy>(&its, input.vector(), input.number(), input.number(),
                                           input.number(), input.number(), input.number())
                    .setWater(input.flag() ? &waves : nullptr);
            case 1:
                return world.createForce<Thruster>(&its, input.vector(), input.vector(), input.number())
                    .setThrottle(input.number());
            case 2:
                return world
                    .createForce<Propeller>(&its, input.vector(), input.vector(), input.number(),
                                            input.number(), wind)
                    .setThrottle(input.number());
            case 3:
                world.createForce<HullDrag>(&its, &hull, input.vector(), input.vector(), input.vector());
                return;
            default:
                world.createForce<Gravity>(&its, input.vector());
        }
    }

    void callRegistry(RigidBody &its, Input &input) {
        ForceRegistry &registry = world.getForceRegistry();
        switch (input.below(7)) {
            case 0:
                return registry.add(&its, &drag);
            case 1:
                return registry.remove(&its, &drag);
            case 2:
                return registry.remove(&its);
            case 3:
                return registry.add(&its, &anchored);
            case 4:
                return waves.setTime(input.number());
            case 5:
                return turbulence.advance(input.vector(), input.number(), input.duration());
            default:
                windspeed = input.vector();
        }
    }

    void callWorld(Input &input) {
        switch (input.below(12)) {
            case 0:
                if (world.getBodies().size() < crowd + MOST_BODIES) world.createBody();
                return;
            case 1:
                return world.addBody(&own[input.below(2)]);
            case 2:
                world.removeBody(&own[input.below(2)]);
                return;
            case 3:
                if (RigidBody *its = body(input)) world.destroyBody(its);
                return;
            case 4:
                return world.startFrame();
            case 5:
                return world.integrate(input.duration());
            case 6:
                world.saveState(saved);
                savedHash = world.hash();
                return;
            case 7:
                if (saved.empty()) return;
                world.restoreState(saved);
                expect(world.hash() == savedHash, "what is restored is what was saved");
                return;
            case 8:
                return world.clear();
            default:
                return world.runPhysics(input.duration());
        }
    }

    Vector3 windspeed{1, 2, 3};
    WindGradient breeze{Vector3(6, 0, 0), 10};
    Thermal thermal{Vector3(3, 0, 0), 3, 80, 1200};
    Turbulence turbulence{6};
    WindSum air;
    Waves waves;
    Drag drag{0.1, 0.2};
    Buoyancy hull{Vector3(0, -1, 0), 0.5, 0.2, 0};
    AnchoredSpring anchored{Vector3(), Vector3(1, 2, 3), 10, 1};
    RigidBody own[2];
    Snapshot saved;
    std::uint64_t savedHash = 0;
    World world;
    std::size_t crowd = 0;
};

std::uint64_t play(const std::uint8_t *bytes, std::size_t count, std::size_t threads, bool hasCrowd) {
    Game game(threads, hasCrowd);
    Input input(bytes, count);
    while (!input.isAtEnd()) {
        game.call(input);
        if (!hasCrowd) game.check();
    }
    game.check();
    return game.hash();
}

/// One input in so many plays in a crowd, which is slow; not at the choice of the fuzzer, which would take it
/// for interesting.
bool isInCrowd(const std::uint8_t *bytes, std::size_t count) {
    std::uint32_t sum = 1;
    for (std::size_t n = 0; n < count; ++n) sum = (sum ^ bytes[n]) * 0x9e3779b1u;
    return count < 64 && sum >> 22 == 0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count) {
    const bool hasCrowd = isInCrowd(bytes, count);
    const std::uint64_t alone = play(bytes, count, 1, hasCrowd);
    expect(alone == play(bytes, count, hasCrowd ? 3 : 1, hasCrowd), "the same calls give the same bits");
    return 0;
}
