/// A speedboat, or a hydrofoil, to race round buoys in a terminal, or that races by itself. Try --help.
#include "shell/loop.h"
#include "speedboat/race.h"

int main(int argc, char *argv[]) {
    const demo::Choice hull{"hull", "What carries the boat", {"planing", "foils"}};
    const auto make = [](const std::string &word) -> std::unique_ptr<demo::Demonstration> {
        return std::make_unique<speedboat::Race>(word == "foils" ? speedboat::Hull::FOILS
                                                                 : speedboat::Hull::PLANING);
    };
    return demo::runDemonstration(hull, make, argc, argv);
}
