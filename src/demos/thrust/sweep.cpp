#include "thrust/sweep.h"

#include <algorithm>

namespace thrust {

namespace {

/// A box around what it has been given.
class Box {
public:
    void add(const Vector3 &point) {
        low = Vector3(std::min(low.x, point.x), std::min(low.y, point.y), 0);
        high = Vector3(std::max(high.x, point.x), std::max(high.y, point.y), 0);
    }
    bool meets(const Wall &wall) const {
        return std::max(wall.from.x, wall.to.x) >= low.x && std::min(wall.from.x, wall.to.x) <= high.x &&
               std::max(wall.from.y, wall.to.y) >= low.y && std::min(wall.from.y, wall.to.y) <= high.y;
    }

private:
    Vector3 low{cyclone::REAL_MAX, cyclone::REAL_MAX, 0}, high = low * -1;
};

real cross(const Vector3 &a, const Vector3 &b) { return a.x * b.y - a.y * b.x; }

/// Whether the point lies on the side from a to b at the share t of the step.
bool liesBetween(const Corner &a, const Corner &b, const Vector3 &point, real t) {
    if (!(t >= 0 && t <= 1)) return false;
    const auto at = [&](const Corner &corner) {
        return corner.before + (corner.after - corner.before) * t - point;
    };
    return at(a) * at(b) <= 0;
}

/// a, b and the point lie in line where (a − point) × (b − point) = 0, which is quadratic in the time.
bool sideMeetsPoint(const Corner &a, const Corner &b, const Vector3 &point) {
    const Vector3 a0 = a.before - point, b0 = b.before - point;
    const Vector3 da = a.after - a.before, db = b.after - b.before;
    const real c0 = cross(a0, b0), c1 = cross(a0, db) + cross(da, b0), c2 = cross(da, db);
    const real discriminant = c1 * c1 - 4 * c2 * c0;
    if (discriminant < 0) return false;
    // Both roots without cancellation; of a linear equation one is not finite.
    const real sum = -(c1 + (c1 < 0 ? -1 : 1) * cyclone::real_sqrt(discriminant)) / 2;
    return (sum != 0 && liesBetween(a, b, point, c0 / sum)) ||
           (c2 != 0 && liesBetween(a, b, point, sum / c2));
}

bool touches(const std::vector<Corner> &outline, const Wall &wall) {
    for (std::size_t n = 0; n < outline.size(); ++n) {
        const Corner &corner = outline[n], &next = outline[(n + 1) % outline.size()];
        // The corner against the wall: the same, seen from the corner.
        const Corner seenFrom{wall.from - corner.before, wall.from - corner.after};
        const Corner seenTo{wall.to - corner.before, wall.to - corner.after};
        if (sideMeetsPoint(seenFrom, seenTo, Vector3()) || sideMeetsPoint(corner, next, wall.from) ||
            sideMeetsPoint(corner, next, wall.to))
            return true;
    }
    return false;
}

}  // namespace

std::optional<Wall> findTouch(const std::vector<Corner> &outline, const std::vector<Wall> &walls) {
    Box box;
    for (const Corner &corner : outline) {
        box.add(corner.before);
        box.add(corner.after);
    }
    for (const Wall &wall : walls)
        if (box.meets(wall) && touches(outline, wall)) return wall;
    return std::nullopt;
}

}  // namespace thrust
