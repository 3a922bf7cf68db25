/// Same input, same bits: runs a rich scene and compares the hash of all its states with the one number that
/// every compiler, every optimisation and every processor must give; then once more with threads, where a
/// second scene takes over half-way from a snapshot of the first run.
///
///     cyclone_golden                   runs and compares; exit status 1 if anything is wrong
///     cyclone_golden 700 703           prints every body's hash after these frames, to see where builds part
///     cyclone_golden --snapshot FILE   writes the snapshot, too: the same bytes on every machine
///
/// The number is this library's own output. It proves nothing about the physics, which other tests check
/// against closed forms and other people's data; it proves that this build computes what all others do. When
/// the step or the scene is changed on purpose, the number changes: run.sh beside this file shows whether all
/// builds agree on the new one.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <utility>
#include <vector>

#include "scene.h"

namespace {

using cyclone::real;
using cyclone::RigidBody;
using cyclone::Snapshot;
using golden::Scene;

constexpr std::uint64_t GOLDEN = 0xcba22ef1bc381f4e;
constexpr int FRAMES = 1500, HALF_WAY = FRAMES / 2;

[[noreturn]] void fail(const char *what, int frame) {
    std::printf("cyclone_golden: frame %d: %s\n", frame, what);
    std::exit(1);
}

void expect(bool holds, const char *otherwise, int frame) {
    if (!holds) fail(otherwise, frame);
}

/// Watches that the scene is worth hashing: nothing faults or runs away, and everything takes part.
class Witness {
public:
    explicit Witness(const Scene &s)
        : scene(&s),
          hasActed(s.getActions().size(), false),
          wasAwake(s.getWorld().getBodies().size(), true) {}

    /// Another scene takes over.
    void watch(const Scene &next) { scene = &next; }

    /// Before the step.
    void watchForces() {
        if (scene->getFrame() >= Scene::FIRST_CHANGE_OF_STRUCTURE) return;
        for (std::size_t n = 0; n < hasActed.size(); ++n) {
            const Scene::Action &action = scene->getActions()[n];
            RigidBody copy = *action.body;
            copy.clearAccumulators();
            action.generator->updateForce(&copy, scene->getDuration());
            if (copy.getState().added.force != cyclone::Vector3()) hasActed[n] = true;
        }
    }
    /// After the step.
    void watchBodies(real duration) {
        const int frame = scene->getFrame();
        expect(scene->getWorld().getFaultedBodies().empty(), "a body has faulted", frame);
        real energy = 0;
        const auto &bodies = scene->getWorld().getBodies();
        for (std::size_t n = 0; n < bodies.size(); ++n) {
            const RigidBody &body = *bodies[n];
            expect(body.getPosition().magnitude() < 5000, "a body has run away", frame);
            if (body.hasFiniteMass())
                energy += 0.5 * body.getMass() * body.getVelocity().squareMagnitude() +
                          0.5 * body.getRotation() * body.getAngularMomentum();
            if (body.getRotation().magnitude() * duration > 3) ++fastTurns;
            if (n >= wasAwake.size()) continue;
            if (wasAwake[n] && !body.getAwake()) ++timesAsleep;
            if (!wasAwake[n] && body.getAwake()) ++timesWoken;
            wasAwake[n] = body.getAwake();
        }
        expect(energy > 100 && energy < 1e5, "the energy is out of all bounds", frame);
    }
    void conclude() const {
        for (bool has : hasActed) expect(has, "a generator has never acted", FRAMES);
        expect(timesAsleep > 10 && timesWoken > 10, "too few bodies have slept and woken", FRAMES);
        expect(fastTurns > FRAMES, "too few steps have needed substeps", FRAMES);
    }

private:
    const Scene *scene;
    std::vector<bool> hasActed, wasAwake;
    int timesAsleep = 0, timesWoken = 0, fastTurns = 0;
};

void printBodies(const Scene &scene) {
    const auto &bodies = scene.getWorld().getBodies();
    for (std::size_t n = 0; n < bodies.size(); ++n)
        std::printf("frame %d body %zu %016llx\n", scene.getFrame(), n,
                    static_cast<unsigned long long>(cyclone::hashStates(&bodies[n], 1)));
}

/// A scene, and the hash of all its states so far.
class Run {
public:
    explicit Run(std::size_t threads, int printFrom = FRAMES + 1, int printTo = FRAMES)
        : scene(std::make_unique<Scene>(threads)), witness(*scene), from(printFrom), to(printTo) {}

    void advanceTo(int end) {
        while (scene->getFrame() < end) advance();
    }
    void save(Snapshot &snapshot) const { scene->getWorld().saveState(snapshot); }
    /// Goes on in a new scene, which has the states from the snapshot alone.
    void takeOverFrom(const Snapshot &snapshot, std::size_t threads) {
        auto next = std::make_unique<Scene>(threads);
        while (next->getFrame() < scene->getFrame()) {
            next->steer();
            next->skip();
        }
        next->getWorld().restoreState(snapshot);
        scene = std::move(next);
        witness.watch(*scene);
    }
    std::uint64_t conclude() const {
        witness.conclude();
        return total;
    }

private:
    void advance() {
        const real duration = scene->getDuration();
        scene->steer();
        witness.watchForces();
        scene->step();
        witness.watchBodies(duration);

        const int frame = scene->getFrame();
        if (frame >= from && frame <= to) printBodies(*scene);
        if (frame % 10 != 0) return;
        total = (total ^ scene->getWorld().hash()) * 0x9e3779b97f4a7c15;
        total ^= total >> 32;
        if (frame % 500 == 0)
            std::printf("frame %4d, %zu bodies: %016llx\n", frame, scene->getWorld().getBodies().size(),
                        static_cast<unsigned long long>(total));
    }

    std::unique_ptr<Scene> scene;
    Witness witness;
    int from, to;
    std::uint64_t total = 0;
};

/// The hash of a crowd that is large enough to be shared out over threads, as the scene is not.
std::uint64_t runCrowd(std::size_t threads) {
    golden::Random random(5);
    cyclone::World world;
    world.setWorkers(threads);
    RigidBody *last = nullptr;
    for (int n = 0; n < 5000; ++n) {
        RigidBody *const body = world.createBody();
        body->setPosition(random.vector(50));
        body->setVelocity(random.vector(5));
        body->setRotation(random.vector(3));
        world.createForce<cyclone::Drag>(body, 0.2, 0.1);
        if (last != nullptr) world.createSpring(last, random.vector(0.5), body, golden::Vector3(), 2, 1);
        last = body;
    }
    for (int n = 0; n < 20; ++n) {
        world.startFrame();
        world.runPhysics(1.0 / 60);
    }
    return world.hash();
}

void writeFile(const char *name, const Snapshot &snapshot) {
    std::ofstream file(name, std::ios::binary);
    file.write(reinterpret_cast<const char *>(snapshot.data()),
               static_cast<std::streamsize>(snapshot.size()));
    expect(!file.flush().fail(), "the snapshot cannot be written", HALF_WAY);
}

}  // namespace

int main(int argc, char **argv) {
    const bool wantsSnapshot = argc > 2 && std::strcmp(argv[1], "--snapshot") == 0;
    const int from = argc > 1 && !wantsSnapshot ? std::atoi(argv[1]) : FRAMES + 1;
    const int to = argc > 2 && !wantsSnapshot ? std::atoi(argv[2]) : from;

    Snapshot snapshot;
    Run alone(0, from, to);
    alone.advanceTo(HALF_WAY);
    alone.save(snapshot);
    alone.advanceTo(FRAMES);
    if (wantsSnapshot) writeFile(argv[2], snapshot);

    std::printf("with three threads, and from the snapshot:\n");
    Run shared(3);
    shared.advanceTo(HALF_WAY);
    shared.takeOverFrom(snapshot, 3);
    shared.advanceTo(FRAMES);

    expect(runCrowd(0) == runCrowd(3), "a crowd on three threads differs from one on one", FRAMES);

    const std::uint64_t first = alone.conclude(), second = shared.conclude();
    if (first == GOLDEN && second == GOLDEN) return 0;
    std::printf("cyclone_golden: got %016llx alone and %016llx with threads, wanted %016llx\n",
                static_cast<unsigned long long>(first), static_cast<unsigned long long>(second),
                static_cast<unsigned long long>(GOLDEN));
    return 1;
}
