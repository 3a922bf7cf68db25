/// A ship in a cave, under weak gravity, to fly in a terminal, or that flies by itself. Try --help.
#include "shell/loop.h"
#include "thrust/mission.h"

int main(int argc, char *argv[]) {
    const demo::Choice level{"level", "Which cave", {"1", "2", "3"}};
    return demo::runDemonstration(
        level, [](const std::string &word) { return std::make_unique<thrust::Mission>(std::stoul(word)); },
        argc, argv);
}
