/// A model aircraft to fly in a terminal, or that flies by itself. Try --help.
#include "flightsim/flight.h"
#include "shell/loop.h"

int main(int argc, char *argv[]) {
    flightsim::Flight flight;
    return demo::runDemonstration(flight, argc, argv);
}
