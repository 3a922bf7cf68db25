// Built with the library's sources, without exceptions and run-time type information, as game engines are:
// flies a frame, then breaks a rule. That must print the rule to stderr and abort.
#include <cyclone/cyclone.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

using namespace cyclone;

namespace {

/// The program's end as it should be; ctest takes a plain abort for a failure.
void onAbort(int) {
    std::fputs("aborted\n", stderr);
    std::_Exit(EXIT_SUCCESS);
}

bool fliesAFrame() {
    World world;
    world.setWorkers(2);
    Gravity gravity;
    for (int n = 0; n < 1000; ++n) world.getForceRegistry().add(world.createBody(), &gravity);
    world.startFrame();
    world.runPhysics(0.5);
    const real speed = world.getBodies().back()->getVelocity().y;
    return speed < -4.904 && speed > -4.906;
}

}  // namespace

int main() {
    if (!fliesAFrame()) return EXIT_FAILURE;
    std::signal(SIGABRT, onAbort);
    RigidBody().setMass(-1);
    std::fputs("not refused\n", stderr);
    return EXIT_FAILURE;
}
