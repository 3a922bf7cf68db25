/// A model aircraft, or a glider, to fly in a terminal, or that flies by itself. Try --help.
#include "flightsim/flight.h"
#include "flightsim/soaring.h"
#include "shell/loop.h"

namespace {

std::unique_ptr<demo::Demonstration> make(const std::string &aircraft) {
    if (aircraft == "glider") return std::make_unique<flightsim::Soaring>();
    return std::make_unique<flightsim::Flight>();
}

}  // namespace

int main(int argc, char *argv[]) {
    const demo::Choice aircraft{"aircraft", "What to fly", {"model", "glider"}};
    return demo::runDemonstration(aircraft, make, argc, argv);
}
