#pragma once

/// Simple solids to build vehicles from.
#include "picture/scene.h"

namespace demo {

/// Appends the skin between rings of as many corners each, from the first ring to the last, and closes both
/// ends. Seen along the way from the first ring to the last, the corners go clockwise. `sides`: a colour for
/// the stripe behind each corner, over again if there are fewer.
void addLoft(Part &part, const std::vector<std::vector<Vector3>> &rings, const std::vector<Colour> &sides,
             Colour ends);
void addLoft(Part &part, const std::vector<std::vector<Vector3>> &rings, Colour colour);

/// Appends a box with edges along the axes; any two opposite corners.
void addBox(Part &part, const Vector3 &oneCorner, const Vector3 &otherCorner, Colour colour);

/// Appends a bar of square section between two points, `width` m thick.
void addBar(Part &part, const Vector3 &from, const Vector3 &to, real width, Colour colour);

/// Appends a wheel that rolls along x; its lowest point.
void addWheel(Part &part, const Vector3 &lowest, real radius, real width, Colour colour);

/// A ring for addLoft, in the plane x: an ellipse about (x, y, z) with half axes along y and z.
std::vector<Vector3> ringAcrossX(const Vector3 &middle, real halfHeight, real halfWidth, int corners = 8);

/// A conical buoy, 2 m high; its origin is at the waterline.
Part makeBuoy(const std::string &name, Colour colour);

/// What stands above a wreck; its origin is on the ground.
Part makeSmoke();

/// On the land, between two corners.
Part paintRectangle(const std::string &name, real x1, real x2, real z1, real z2, Colour colour);

/// An arrowhead that hangs over a buoy.
Part makeBuoyPointer(const std::string &name);

/// Appends a flat face; counter-clockwise seen from its front.
void addFace(Part &part, const std::vector<Vector3> &corners, Colour colour);

}  // namespace demo
