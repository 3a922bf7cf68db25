#pragma once

/// A scene with everything in it, the same on every machine: for tests of equal bits.
#include <cyclone/cyclone.h>

#include <cstdint>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

namespace golden {

using cyclone::Matrix3;
using cyclone::Quaternion;
using cyclone::real;
using cyclone::RigidBody;
using cyclone::Vector3;

/// The same pseudo-random numbers on every machine (a linear congruential generator; Knuth, MMIX).
class Random {
public:
    explicit Random(std::uint64_t seed) : state(seed) {}
    real between(real low, real high) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return low + (high - low) * (static_cast<real>(state >> 11) * 0x1p-53);
    }
    Vector3 vector(real size) {
        const real x = between(-size, size), y = between(-size, size), z = between(-size, size);
        return Vector3(x, y, z);
    }

private:
    std::uint64_t state;
};

inline Matrix3 diagonal(real a, real b, real c) {
    Matrix3 result;
    result.setDiagonal(a, b, c);
    return result;
}

/// Aircraft, boats, chains, doors, tops, sleepers and a swarm, with every generator, wind and water of the
/// library and some of its own, steered by inputs that depend on nothing but the frame's number and, now and
/// then, the bodies' states.
class Scene {
public:
    explicit Scene(std::size_t threads = 0, int swarmSize = 180);
    Scene(const Scene &) = delete;
    Scene &operator=(const Scene &) = delete;

    /// Begins a frame: drops old forces, then does what a game does before the step: moves controls, adds
    /// forces, adds and removes registrations and bodies.
    void steer();
    /// Ends it: advances the world by the frame's duration.
    void step();
    /// Ends it without advancing the world. Run so from the start, another scene becomes ready for a snapshot
    /// that was saved at the same frame.
    void skip() { ++frame; }
    /// Returns to a frame since which no registration and no body has come or gone: the caller restores the
    /// world's state.
    void rewind(int toFrame) { frame = toFrame; }

    int getFrame() const { return frame; }
    /// s; it changes every few frames.
    real getDuration() const;
    /// Whether this frame adds or removes registrations or bodies.
    bool changesStructure() const;

    cyclone::World &getWorld() { return world; }
    const cyclone::World &getWorld() const { return world; }

    /// Every registration that acts on its body only, as it was at the start, of the scene's own generators.
    struct Action {
        RigidBody *body;
        cyclone::ForceGenerator *generator;
    };
    const std::vector<Action> &getActions() const { return actions; }
    static constexpr int FIRST_CHANGE_OF_STRUCTURE = 90;

private:
    RigidBody *addBody(real mass, const Matrix3 &inertia, const Vector3 &position);
    template <class Generator, class... Arguments>
    Generator *act(RigidBody *body, Arguments... arguments) {
        auto generator = std::make_unique<Generator>(arguments...);
        Generator *const result = generator.get();
        generators.push_back(std::move(generator));
        registerAction(body, result);
        return result;
    }
    void registerAction(RigidBody *body, cyclone::ForceGenerator *generator);
    void setUpSwarmBody(RigidBody *body);

    RigidBody *addVehicle(const cyclone::MassProperties &parts, const Vector3 &position,
                          const Vector3 &velocity);
    void addAircraft(const Vector3 &position);
    void addGlider(const Vector3 &position);
    void addBoat(const Vector3 &position, bool onWaves);
    void addMotorboat(const Vector3 &position, bool onFoils);
    void addRaft(const Vector3 &position, bool inRiver);
    void addFloats(RigidBody *body, const cyclone::Water *water, real y, real z, real volume);

    void addChain(const Vector3 &position);
    void addTetheredPair(const Vector3 &position);
    void addPlatform(const Vector3 &position);
    void addDoor(const Vector3 &position, bool oblique);
    void addTop(const Vector3 &position, const Vector3 &rotation);
    void addSleeper(const Vector3 &position);
    void addSwarm(int count);
    void addWinch(RigidBody *body, const Vector3 &point, const Vector3 &place);
    void addPod(const Vector3 &position);
    void addOwned(const Vector3 &position);
    void addStiff(const Vector3 &position, real strength);

    void moveControls();
    void makeGust();
    void addForces();
    void useSetters();
    void sendHome();
    void changeRegistrations();
    void changeBodies();
    void shoot();

    Random random{1};
    real time = 0;
    int frame = 0;

    Vector3 wind{-4, 0, 1}, current{0.2, 0, -0.1};
    cyclone::WindGradient shear{Vector3(1, 0, 0.5), 10, 0.2};
    cyclone::Thermal thermal{Vector3(60, -20, 0), 3, 80, 900}, downburst{Vector3(0, -10, 30), -2, 60, 400};
    cyclone::Turbulence gusts{8};
    cyclone::WindSum air;
    cyclone::Waves sea{0.1, 9.8};
    cyclone::Gravity gravity;
    std::deque<RigidBody> storage;
    std::vector<std::unique_ptr<cyclone::ForceGenerator>> generators;
    std::vector<Action> actions;

    /// A body that is sent home now and then, lest it leave all that acts on it.
    struct Traveller {
        RigidBody *body;
        Vector3 home, velocity;
    };
    std::vector<Traveller> travellers;
    std::vector<cyclone::AeroControl *> wings;
    std::vector<cyclone::Wing *> flaps;
    std::vector<cyclone::AngledAero *> sails;
    std::vector<cyclone::Thruster *> thrusters;
    struct Winch {
        cyclone::AnchoredSpring *spring;
        Vector3 place;
    };
    std::vector<Winch> winches;
    std::vector<RigidBody *> links, doors, sleepers, swarm;
    /// By place in the swarm; every other has no spring.
    std::vector<std::vector<cyclone::ForceGenerator *>> swarmForces;
    std::vector<cyclone::AnchoredSpring *> swarmSprings;
    std::deque<RigidBody *> shots;
    RigidBody *platform = nullptr;
    RigidBody visitor;
    bool visitorIsIn = false;

    cyclone::World world;  // last, so that it ends before what it refers to
};

}  // namespace golden
