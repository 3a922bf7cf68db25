#include "models/sea.h"

#include <array>

namespace demo {

namespace {

/// A share of the height, and how far the train's way turns from the others'.
struct Swell {
    real share, wavelength, turn, phase;
};
constexpr std::array<Swell, 3> SWELLS = {{{0.5, 17, 0.15, 0}, {0.3, 10, -0.4, 2}, {0.2, 6.5, 0.6, 4}}};

}  // namespace

std::vector<cyclone::Waves::Train> makeSea(real height, real direction) {
    std::vector<cyclone::Waves::Train> trains;
    if (height == 0) return trains;
    for (const Swell &swell : SWELLS)
        trains.push_back({swell.share * height / 2, swell.wavelength, direction + swell.turn, swell.phase});
    return trains;
}

}  // namespace demo
