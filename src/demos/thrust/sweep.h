#pragma once

/// Whether something that moves in the plane z = 0 has touched a wall on its way, however fast it moved.
#include <optional>
#include <vector>

#include "thrust/level.h"

namespace thrust {

/// A corner before and after a step; in between it moves straight on.
struct Corner {
    Vector3 before, after;
};

/// The first of the walls that the outline touches, if any. The outline is closed; two corners make a rod.
/// Seen in the plane, whatever touches does so with a corner of the one on a side of the other: both are
/// tried, over the whole step.
std::optional<Wall> findTouch(const std::vector<Corner> &outline, const std::vector<Wall> &walls);

}  // namespace thrust
