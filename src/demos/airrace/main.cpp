/// An air race through hoops, to fly in a terminal, or that is flown by itself. Try --help.
#include "airrace/race.h"
#include "shell/loop.h"

int main(int argc, char *argv[]) {
    const demo::Choice aircraft{"aircraft", "What to fly", airrace::Aircraft::NAMES};
    return demo::runDemonstration(
        aircraft, [](const std::string &name) { return std::make_unique<airrace::Race>(name); }, argc, argv);
}
