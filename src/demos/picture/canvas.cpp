#include "picture/canvas.h"

#include <algorithm>
#include <cmath>

#include "picture/backdrop.h"

namespace demo {

namespace {

constexpr real NEAR_PLANE = 0.05;  // m in front of the eye
constexpr Colour SHADOW{8, 16, 24};
constexpr real SHADOW_DEPTH = 0.55;
constexpr real HEAD_LENGTH = 7, HEAD_WIDTH = 6, SHAFT_WIDTH = 1.5;  // an arrow, pixels,
constexpr real ARROW_HEIGHT =
    280;  // of a picture up to this many pixels high; larger ones have larger arrows
/// Lines stand out this much from the faces that they lie on, as a share of their distance.
constexpr real LINE_LIFT = 0.003;

/// A normal of a flat polygon, as long as twice its area (Newell's method).
Vector3 normalOf(const std::vector<Vector3> &corners) {
    Vector3 normal;
    for (std::size_t i = 0; i < corners.size(); ++i)
        normal += (corners[i] - corners[0]) % (corners[i + 1 == corners.size() ? 0 : i + 1] - corners[0]);
    return normal;
}

/// The part of a convex polygon where height(corner) ≥ 0 (Sutherland and Hodgman 1974).
template <typename Height>
std::vector<Vector3> cut(const std::vector<Vector3> &corners, Height height) {
    std::vector<Vector3> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vector3 &a = corners[i], &b = corners[i + 1 == corners.size() ? 0 : i + 1];
        const real ha = height(a), hb = height(b);
        if (ha >= 0) kept.push_back(a);
        if ((ha < 0) != (hb < 0)) kept.push_back(a + (b - a) * (ha / (ha - hb)));
    }
    return kept;
}

real beyondNearPlane(const Vector3 &inView) { return inView.z - NEAR_PLANE; }

bool areFinite(const std::vector<Vector3> &corners) {
    return std::all_of(corners.begin(), corners.end(),
                       [](const Vector3 &corner) { return corner.isFinite(); });
}

/// Sunlight, and light from the sky that comes rather from above. Cloth lets light through: it is never dark,
/// and glows where the sun shines on it from behind.
Colour lit(Colour colour, const Vector3 &unitNormal, bool isThin) {
    const real facing = unitNormal * Canvas::sun();
    const real sunlight = facing > 0 ? facing : isThin ? -0.6 * facing : 0;
    const real skylight = (isThin ? 0.68 : 0.54) + 0.1 * unitNormal.y;
    return mix({0, 0, 0}, colour, std::min(skylight + 0.37 * sunlight, 1.0));
}

/// 1/z of the plane through a polygon that is given in view coordinates.
std::optional<InverseDepth> inverseDepthOf(const std::vector<Vector3> &corners, const Vector3 &normal,
                                           const View &view) {
    const real offset = normal * corners[0];
    if (std::abs(offset) < 1e-12 * normal.magnitude()) return std::nullopt;  // seen edge-on
    InverseDepth inverseDepth;
    inverseDepth.perX = normal.x / (offset * view.scale());
    inverseDepth.perY = -normal.y / (offset * view.scale());
    inverseDepth.atOrigin =
        normal.z / offset - inverseDepth.perX * view.centreX() - inverseDepth.perY * view.centreY();
    return inverseDepth;
}

}  // namespace

Vector3 Canvas::sun() { return Vector3(0.35, 0.85, -0.4).unit(); }

void Canvas::begin(int columns, int rows, const Camera &camera) {
    const int width = std::max(columns, 0), height = 2 * std::max(rows, 0);
    view_ = View(camera, width, height);
    raster_.reset(width, height);
    text_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height / 2), std::nullopt);
}

void Canvas::draw(const Surroundings &surroundings, real time) {
    paintBackdrop(raster_, view_, surroundings, time, sun());
}

std::vector<Vector3> Canvas::toWorld(const Face &face, const Pose &pose) {
    std::vector<Vector3> corners;
    for (const Vector3 &corner : face.corners)
        corners.push_back(pose.position + pose.orientation.rotate(corner));
    return corners;
}

std::vector<Vector3> Canvas::toView(std::vector<Vector3> corners) const {
    for (Vector3 &corner : corners) corner = view_.toView(corner);
    return corners;
}

std::vector<ScreenPoint> Canvas::toPicture(const std::vector<Vector3> &inView) const {
    std::vector<ScreenPoint> points;
    for (const Vector3 &corner : cut(inView, beyondNearPlane))
        points.push_back({view_.pixelX(corner), view_.pixelY(corner)});
    return points;
}

void Canvas::draw(const Part &part, const Pose &pose, real opacity) {
    for (const Face &face : part.faces) {
        const std::vector<Vector3> corners = toWorld(face, pose);
        if (corners.size() < 3 || !areFinite(corners)) continue;
        Vector3 normal = normalOf(corners).unit();
        if (normal * (view_.eye() - corners[0]) < 0) {
            if (!part.twoSided) continue;
            normal.invert();
        }
        fill(corners, isFlat ? face.colour : lit(face.colour, normal, part.twoSided), opacity);
    }
}

void Canvas::fill(const std::vector<Vector3> &corners, Colour colour, real opacity) {
    const std::vector<Vector3> inView = toView(corners);
    if (const auto inverseDepth = inverseDepthOf(inView, normalOf(inView), view_))
        raster_.fill(toPicture(inView), *inverseDepth, colour, opacity);
}

void Canvas::drawOnGround(const Part &part, const Pose &pose) {
    for (const Face &face : part.faces) {
        std::vector<Vector3> corners = toWorld(face, pose);
        for (Vector3 &corner : corners) corner.y = 0;
        if (areFinite(corners)) raster_.fillOnGround(toPicture(toView(corners)), face.colour, 1, false);
    }
}

void Canvas::drawShadow(const Part &part, const Pose &pose) {
    for (const Face &face : part.faces) {
        std::vector<Vector3> corners = toWorld(face, pose);
        if (!areFinite(corners)) continue;
        corners = cut(corners, [](const Vector3 &corner) { return corner.y; });
        for (Vector3 &corner : corners) corner -= sun() * (corner.y / sun().y);
        raster_.fillOnGround(toPicture(toView(corners)), SHADOW, SHADOW_DEPTH, true);
    }
}

void Canvas::drawLine(const Vector3 &from, const Vector3 &to, Colour colour, real width) {
    if (!from.isFinite() || !to.isFinite()) return;
    const std::vector<Vector3> ends = cut({view_.toView(from), view_.toView(to)}, beyondNearPlane);
    if (ends.size() < 2) return;
    const ScreenPoint a{view_.pixelX(ends[0]), view_.pixelY(ends[0])},
        b{view_.pixelX(ends[1]), view_.pixelY(ends[1])};
    const real length = std::hypot(b.x - a.x, b.y - a.y);
    if (!(length > 0)) return;
    const ScreenPoint along{(b.x - a.x) / length, (b.y - a.y) / length};
    const ScreenPoint side{-along.y * width / 2, along.x * width / 2};

    const real nearA = (1 + LINE_LIFT) / ends[0].z, nearB = (1 + LINE_LIFT) / ends[1].z;
    InverseDepth inverseDepth;
    inverseDepth.perX = along.x * (nearB - nearA) / length;
    inverseDepth.perY = along.y * (nearB - nearA) / length;
    inverseDepth.atOrigin = nearA - inverseDepth.perX * a.x - inverseDepth.perY * a.y;
    raster_.fill({{a.x - side.x, a.y - side.y},
                  {a.x + side.x, a.y + side.y},
                  {b.x + side.x, b.y + side.y},
                  {b.x - side.x, b.y - side.y}},
                 inverseDepth, colour);
}

void Canvas::draw(const Arrow &arrow) {
    const Vector3 tip = arrow.tail + arrow.vector;
    const real length = arrow.vector.magnitude();
    const real distance = view_.toView(tip).z;
    const Vector3 along = arrow.vector.unit();
    const Vector3 side = (along % (view_.eye() - tip)).unit();
    if (!arrow.tail.isFinite() || !tip.isFinite()) return;
    if (distance < NEAR_PLANE || side.squareMagnitude() == 0)  // no head to be seen
        return drawLine(arrow.tail, tip, arrow.colour, SHAFT_WIDTH);

    const real size = std::max(raster_.height() / ARROW_HEIGHT, 1.0);
    const real pixel = size * distance / view_.scale();  // m at the tip
    const real head = std::min(HEAD_LENGTH * pixel, length);
    const Vector3 neck = tip - along * head, halfWidth = side * (0.5 * HEAD_WIDTH * pixel);
    drawLine(arrow.tail, neck, arrow.colour, SHAFT_WIDTH * size);
    fill({tip, neck + halfWidth, neck - halfWidth}, arrow.colour);
}

void Canvas::label(const Arrow &arrow) {
    const Vector3 tail = view_.toView(arrow.tail), tip = view_.toView(arrow.tail + arrow.vector);
    if (!tail.isFinite() || !tip.isFinite() || tail.z < NEAR_PLANE || tip.z < NEAR_PLANE) return;
    const real x = view_.pixelX(tail), y = view_.pixelY(tail);
    if (x < 0 || x >= raster_.width() || y < 0 || y >= raster_.height()) return;
    const int column = static_cast<int>(x), length = static_cast<int>(fromUtf8(arrow.name).size());
    const bool pointsRight = view_.pixelX(tip) > x;
    print(std::max(pointsRight ? column - length : column + 1, 0), static_cast<int>(y) / 2, arrow.name);
}

void Canvas::print(int column, int row, const std::string &text, Colour colour) {
    if (row < 0) row += rows();
    if (column < 0) column += columns();
    for (const char32_t character : fromUtf8(text))
        if (auto *glyph = findGlyph(column++, row)) *glyph = Glyph{character, colour};
}

void Canvas::paste(int column, int row, const Image &picture) {
    const auto pixel = [&](int x, int y) {
        return picture.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                              static_cast<std::size_t>(x)];
    };
    for (int y = 0; y + 1 < picture.height; y += 2)
        for (int x = 0; x < picture.width; ++x)
            if (auto *glyph = findGlyph(column + x, row + y / 2))
                *glyph = Glyph{HALF_BLOCK, pixel(x, y), pixel(x, y + 1)};
}

/// Null outside the picture.
std::optional<Canvas::Glyph> *Canvas::findGlyph(int column, int row) {
    if (column < 0 || column >= columns() || row < 0 || row >= rows()) return nullptr;
    return &text_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) +
                  static_cast<std::size_t>(column)];
}

void Canvas::printBox(const std::vector<std::string> &lines, Colour colour, std::optional<int> top) {
    std::size_t widest = 0;
    for (const std::string &line : lines) widest = std::max(widest, fromUtf8(line).size());
    const int column = std::max((columns() - static_cast<int>(widest) - 4) / 2, 0);
    int row = std::max(top.value_or((rows() - static_cast<int>(lines.size()) - 2) / 2), 0);
    const std::string blank(widest + 4, ' ');
    print(column, row++, blank, colour);
    for (const std::string &line : lines)
        print(column, row++, "  " + line + std::string(widest + 2 - fromUtf8(line).size(), ' '), colour);
    print(column, row, blank, colour);
}

const CellGrid &Canvas::cells() {
    constexpr real DARKENING = 0.65;
    if (cells_.columns != columns() || cells_.rows != rows()) cells_ = CellGrid(columns(), rows());
    for (int row = 0; row < rows(); ++row) {
        for (int column = 0; column < columns(); ++column) {
            const Colour upper = raster_.pixel(column, 2 * row), lower = raster_.pixel(column, 2 * row + 1);
            Cell &cell = cells_.at(column, row);
            const auto &glyph = text_[static_cast<std::size_t>(&cell - cells_.cells.data())];
            if (glyph)
                cell = {glyph->character, glyph->colour,
                        glyph->background.value_or(mix(mix(upper, lower, 0.5), {0, 0, 0}, DARKENING))};
            else
                cell = {upper == lower ? U' ' : HALF_BLOCK, upper, lower};
        }
    }
    return cells_;
}

Image Canvas::image() const {
    Image image{raster_.width(), raster_.height(), {}};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) image.pixels.push_back(raster_.pixel(x, y));
    return image;
}

}  // namespace demo
