#include <ostream>

#include "loop.h"
#include "polar_chart.h"
#include "sailing.h"

namespace {

void drawPolarDiagram(std::ostream &out) {
    std::vector<demo::Polar> polars;
    for (const demo::real windspeed : {4.0, 6.0, 8.0}) polars.push_back(demo::measurePolar(windspeed, 45));
    demo::drawPolars(out, polars);
}

}  // namespace

int main(int argc, char *argv[]) {
    demo::Sailing sailing;
    return demo::runDemonstration(
        sailing, argc, argv,
        {{"polar", "Draw how fast she sails at every angle to the wind, SVG", drawPolarDiagram}});
}
