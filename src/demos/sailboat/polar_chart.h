#pragma once

/// The polar diagram as a picture.
#include "sailboat/polar.h"

#include <iosfwd>

namespace sailboat {

/// Draws one curve for each polar into one SVG picture: speed outwards, the wind from above. With no polar
/// that has a point with speed in it, throws std::invalid_argument.
void drawPolars(std::ostream &out, const std::vector<Polar> &polars);

}  // namespace sailboat
