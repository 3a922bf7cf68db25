#pragma once

/// A level: rock, where the ship and the pod begin, and the pilot's way between them, as a text file says
/// (see levels/1.txt). All in the plane z = 0.
#include <cyclone/core.h>

#include <string>
#include <string_view>
#include <vector>

namespace thrust {

using cyclone::real;
using cyclone::Vector3;

/// A piece of the rock's surface; the rock lies to the left of the way from `from` to `to`.
struct Wall {
    Vector3 from, to;
};

struct Level {
    static constexpr real ACROSS = 2, DOWN = 4;  ///< m, from one character of the map to the next

    std::string name;
    real gravity = 1, fuel = 60;  ///< m/s²; s of full thrust
    real width = 0, height = 0;   ///< m, of the map, which begins at the origin
    Vector3 start, pod;           ///< of the pod, the rock below its middle
    std::vector<Vector3> way;     ///< of the pilot, from start to pod
    std::vector<Wall> walls;
    std::vector<std::vector<Vector3>> rock;  ///< convex, counter-clockwise seen from +Z
};

/// Throws std::runtime_error with the number of the line and what is wrong with it.
Level readLevel(std::string_view text);

/// The program's own levels, 1 to 3. Throws std::out_of_range for others.
Level getLevel(std::size_t number);

}  // namespace thrust
