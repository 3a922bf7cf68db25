#pragma once

/// Waves as the wind makes them.
#include <cyclone/water.h>

#include <vector>

namespace demo {

using cyclone::real;

/// Three trains, 6 to 17 m long, that go about the same way: `direction`, rad, from +X towards +Z. `height`,
/// m, is from trough to crest where all meet; with 0 there are none.
std::vector<cyclone::Waves::Train> makeSea(real height, real direction);

}  // namespace demo
