#include "picture/solids.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace demo {

namespace {

constexpr Colour POINTER{255, 236, 110};

}  // namespace

void addFace(Part &part, const std::vector<Vector3> &corners, Colour colour) {
    part.faces.push_back({corners, colour});
}

void addLoft(Part &part, const std::vector<std::vector<Vector3>> &rings, const std::vector<Colour> &sides,
             Colour ends) {
    for (std::size_t n = 0; n + 1 < rings.size(); ++n) {
        const auto &near = rings[n], &far = rings[n + 1];
        for (std::size_t i = 0; i < near.size(); ++i) {
            const std::size_t j = (i + 1) % near.size();
            const Colour colour = sides[i % sides.size()];
            addFace(part, {near[i], near[j], far[j]}, colour);  // triangles: a quad might not be flat
            addFace(part, {near[i], far[j], far[i]}, colour);
        }
    }
    addFace(part, {rings.front().rbegin(), rings.front().rend()}, ends);
    addFace(part, rings.back(), ends);
}

void addLoft(Part &part, const std::vector<std::vector<Vector3>> &rings, Colour colour) {
    addLoft(part, rings, {colour}, colour);
}

void addBox(Part &part, const Vector3 &a, const Vector3 &b, Colour colour) {
    const Vector3 low(std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z));
    const Vector3 high(std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z));
    const auto ring = [&](real x) -> std::vector<Vector3> {
        return {{x, low.y, low.z}, {x, high.y, low.z}, {x, high.y, high.z}, {x, low.y, high.z}};
    };
    addLoft(part, {ring(low.x), ring(high.x)}, colour);
}

void addBar(Part &part, const Vector3 &from, const Vector3 &to, real width, Colour colour) {
    const Vector3 along = (to - from).unit();
    Vector3 side = along % Vector3::UP;
    if (side.magnitude() < 1e-6) side = along % Vector3::X;
    side = side.unit() * (width / 2);
    const Vector3 up = side % along;
    const auto ring = [&](const Vector3 &middle) -> std::vector<Vector3> {
        return {middle - up - side, middle + up - side, middle + up + side, middle - up + side};
    };
    addLoft(part, {ring(from), ring(to)}, colour);
}

void addWheel(Part &part, const Vector3 &lowest, real radius, real width, Colour colour) {
    constexpr int CORNERS = 10;
    std::vector<Vector3> port, starboard;
    for (int n = 0; n < CORNERS; ++n) {
        const real angle = 2 * cyclone::REAL_PI * n / CORNERS;
        const Vector3 rim =
            lowest + Vector3(cyclone::real_cos(angle), 1 + cyclone::real_sin(angle), 0) * radius;
        port.push_back(rim - Vector3(0, 0, width / 2));
        starboard.push_back(rim + Vector3(0, 0, width / 2));
    }
    addLoft(part, {starboard, port}, colour);
}

std::vector<Vector3> ringAcrossX(const Vector3 &middle, real halfHeight, real halfWidth, int corners) {
    std::vector<Vector3> ring;
    for (int n = 0; n < corners; ++n) {
        const real angle = 2 * cyclone::REAL_PI * (n + 0.5) / corners;
        ring.push_back(middle + Vector3(0, halfHeight * std::cos(angle), halfWidth * std::sin(angle)));
    }
    return ring;
}

Part makeBuoy(const std::string &name, Colour colour) {
    Part part;
    part.name = name;
    const auto ring = [](real y, real radius) {
        std::vector<Vector3> corners;
        for (int n = 0; n < 6; ++n) {
            const real angle = -cyclone::REAL_PI / 3 * n;
            corners.push_back({radius * cyclone::real_cos(angle), y, radius * cyclone::real_sin(angle)});
        }
        return corners;
    };
    addLoft(part, {ring(-0.3, 0.8), ring(0.5, 0.8), ring(2.2, 0.1)}, colour);
    return part;
}

Part makeSmoke() {
    Part part{"smoke", {}, false};
    // Rings across x, turned upright: x is up here.
    std::vector<std::vector<Vector3>> rings;
    const real radii[] = {0.6, 2.2, 3, 4.4, 5, 2};
    for (int n = 0; n < 6; ++n) rings.push_back(ringAcrossX({5.0 * n, 0.4 * n, 0.9 * n}, radii[n], radii[n]));
    for (std::vector<Vector3> &ring : rings)
        for (Vector3 &corner : ring) corner = Vector3(-corner.y, corner.x, corner.z);
    addLoft(part, rings, {62, 60, 62});
    return part;
}

Part paintRectangle(const std::string &name, real x1, real x2, real z1, real z2, Colour colour) {
    return {name, {{{{x1, 0, z2}, {x2, 0, z2}, {x2, 0, z1}, {x1, 0, z1}}, colour}}, false};
}

Part makeBuoyPointer(const std::string &name) {
    Part part;
    part.name = name;
    const auto ring = [](real y, real radius) -> std::vector<Vector3> {
        return {{radius, y, 0}, {0, y, -radius}, {-radius, y, 0}, {0, y, radius}};
    };
    addLoft(part, {ring(3, 0.05), ring(4.4, 0.9)}, POINTER);
    return part;
}

}  // namespace demo
