/// A long game: the golden scene with a thousand bodies and every generator, guests and registrations that
/// come and go, snapshots that are gone back to. Run twice, on one thread and on three.
///
///     cyclone_soak [frames]     a million of them, if not said
///
/// Exit status 1 if a body faults, a frame that is played again differs, memory or the time of a frame grows,
/// or the two runs end with different hashes.
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "../golden/scene.h"

namespace {

using namespace cyclone;
using golden::Random;
using golden::Scene;

constexpr int SWARM = 850, MOST_GUESTS = 150;

[[noreturn]] void fail(const char *what, int frame) {
    std::printf("cyclone_soak: frame %d: %s\n", frame, what);
    std::exit(1);
}

class Game {
public:
    explicit Game(std::size_t threads) : scene(threads, SWARM) {}

    /// Up to the next change of bodies or registrations; once in a while twice.
    void advance() {
        if (chance(0.5)) welcomeOrDismiss();
        const int begin = scene.getFrame();
        const bool again = begin > 0 && chance(0.2);
        if (scene.changesStructure()) step();
        if (again) scene.getWorld().saveState(snapshot);
        const int from = scene.getFrame(), to = play(from + 20);
        if (!again) return;
        const std::uint64_t before = scene.getWorld().hash();
        scene.rewind(from);
        scene.getWorld().restoreState(snapshot);
        play(to);
        if (scene.getWorld().hash() != before) fail("played again, it differs", to);
        ++returns;
    }

    int getFrame() const { return scene.getFrame(); }
    void print(double microseconds, double megabytes) const {
        const World &world = scene.getWorld();
        std::printf(
            "frame %8d: %4zu bodies, %5zu registrations, %5d returns, %6.1f us/frame, %.1f MB, %016llx\n",
            getFrame(), world.getBodies().size(), world.getForceRegistry().size(), returns, microseconds,
            megabytes, static_cast<unsigned long long>(total));
        std::fflush(stdout);
    }
    std::uint64_t getHash() const { return total; }

private:
    bool chance(real probability) { return random.between(0, 1) < probability; }
    std::size_t pick(std::size_t count) {
        return static_cast<std::size_t>(random.between(0, static_cast<real>(count)));
    }

    void welcomeOrDismiss() {
        World &world = scene.getWorld();
        if (guests.size() < pick(MOST_GUESTS)) {
            guests.push_back(world.createBody());
            setUp(guests.back());
        } else if (!guests.empty()) {
            std::swap(guests[pick(guests.size())], guests.back());
            world.destroyBody(guests.back());
            guests.pop_back();
        }
        if (guests.empty()) return;
        RigidBody *const changed = guests[pick(guests.size())];
        if (chance(0.2)) world.getForceRegistry().remove(changed);
        world.getForceRegistry().add(changed, pickGenerator());
    }
    void setUp(RigidBody *guest) {
        const real mass = random.between(20, 300);
        Matrix3 inertia;
        inertia.setBlockInertiaTensor(Vector3(0.5, 1, 2), mass);
        guest->setMass(mass);
        guest->setInertiaTensor(inertia);
        guest->setPosition(random.vector(50));
        guest->setVelocity(random.vector(5));
        guest->setRotation(random.vector(3));
        guest->setDamping(0.9, 0.8);
        guest->setCanSleep(chance(0.5));
    }
    ForceGenerator *pickGenerator() { return scene.getActions()[pick(scene.getActions().size())].generator; }

    /// Returns the frame at the end.
    int play(int to) {
        while (scene.getFrame() < to && !scene.changesStructure()) step();
        return scene.getFrame();
    }
    void step() {
        scene.steer();
        scene.step();
        const World &world = scene.getWorld();
        if (!world.getFaultedBodies().empty()) fail("a body has faulted", getFrame());
        if (getFrame() % 100 == 0) total = (total ^ world.hash()) * 0x9e3779b97f4a7c15;
    }

    Scene scene;
    Random random{7};
    std::vector<RigidBody *> guests;
    Snapshot snapshot;
    int returns = 0;
    std::uint64_t total = 0;
};

double secondsOfProcessor() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double mostMegabytes() {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

void checkTimes(const std::vector<double> &times, int frame) {
    const auto half = times.begin() + times.size() / 2;
    if (*std::min_element(half, times.end()) > 1.2 * *std::max_element(times.begin(), half))
        fail("frames take longer and longer", frame);
}

/// In ten parts: neither time nor memory may grow after the first.
std::uint64_t run(std::size_t threads, int frames) {
    constexpr int PARTS = 10;
    Game game(threads);
    std::vector<double> times;
    double memoryAtFirst = 0;
    for (int part = 1; part <= PARTS; ++part) {
        const int begin = game.getFrame();
        const double start = secondsOfProcessor();
        while (game.getFrame() < part * (frames / PARTS)) game.advance();
        times.push_back((secondsOfProcessor() - start) / (game.getFrame() - begin) * 1e6);
        game.print(times.back(), mostMegabytes());
        if (part == 1) memoryAtFirst = mostMegabytes();
    }
    if (mostMegabytes() > memoryAtFirst + 1) fail("memory has grown", game.getFrame());
    if (threads == 0) checkTimes(times, game.getFrame());  // threads' time says how busy the machine is
    return game.getHash();
}

}  // namespace

int main(int argc, char **argv) {
    const int frames = argc > 1 ? std::atoi(argv[1]) : 1000000;
    if (frames < 1000) fail("there must be a thousand frames or more", frames);
    const std::uint64_t alone = run(0, frames);
    std::printf("with three threads:\n");
    const std::uint64_t shared = run(3, frames);
    if (alone == shared) return 0;
    std::printf("cyclone_soak: the two runs differ\n");
    return 1;
}
