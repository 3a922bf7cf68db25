#include <iostream>

#include "sailboat/polar_chart.h"
#include "sailboat/sailing.h"
#include "shell/loop.h"

namespace {

void drawPolarDiagram(std::ostream &out) {
    std::vector<sailboat::Polar> polars;
    for (const int windspeed : {4, 6, 8}) {
        std::cerr << "sailing in a wind of " << windspeed << " m/s\n";
        polars.push_back(sailboat::measurePolar(windspeed, 60));
    }
    sailboat::drawPolars(out, polars);
}

}  // namespace

int main(int argc, char *argv[]) {
    sailboat::Sailing sailing;
    return demo::runDemonstration(
        sailing, argc, argv,
        {{"polar", "Instead of a run, draw how fast she sails at every angle to the wind, SVG",
          drawPolarDiagram}});
}
