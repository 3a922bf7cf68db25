/// A jump jet to fly in a terminal, or that flies by itself. Try --help.
#include "shell/loop.h"
#include "vtol/sortie.h"

int main(int argc, char *argv[]) {
    vtol::Sortie sortie;
    return demo::runDemonstration(sortie, argc, argv);
}
