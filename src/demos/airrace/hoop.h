#pragma once

/// The hoops, and whether they have been flown through.
#include <cyclone/core.h>

#include <vector>

namespace airrace {

using cyclone::real;
using cyclone::Vector3;

/// A disc to be flown through along its axis.
struct Hoop {
    Vector3 centre;
    Vector3 axis = Vector3::X;  ///< unit, horizontal: the way through
    real radius = 1;            ///< m, to the rim's inner side
};

/// How a straight way meets a hoop's plane.
struct Crossing {
    enum class Way { NONE, FORWARDS, BACKWARDS };
    Way way = Way::NONE;
    real share = 0;   ///< of the way, up to the plane
    real offset = 0;  ///< m, from the centre
};

/// However long the way is. It begins before the plane and ends on it or behind it, so of two ways end to end
/// exactly one crosses.
Crossing cross(const Hoop &hoop, const Vector3 &from, const Vector3 &to);

/// One round: it begins and ends at the first hoop.
const std::vector<Hoop> &getCourse();
/// Where the race begins, heading along +X to the first hoop.
Vector3 getStart();

}  // namespace airrace
