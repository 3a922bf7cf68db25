/// A model aircraft to fly in a terminal, or that flies by itself. Try --help.
#include "flightsim/flight.h"
#include "shell/loop.h"

int main(int argc, char *argv[]) {
    demo::Flight flight;
    return demo::runDemonstration(flight, argc, argv);
}
