#pragma once

/// The 3-D view of a scene in character cells: each cell shows two pixels, one above the other, as a half
/// block.
#include <optional>
#include <string>
#include <vector>

#include "picture/camera.h"
#include "picture/cells.h"
#include "picture/raster.h"

namespace demo {

/// A picture in pixels, row by row from the top left.
struct Image {
    int width = 0, height = 0;
    std::vector<Colour> pixels;
};

/// Draws one frame after another: begin(), the surroundings, then shadows, solids, lines and arrows in any
/// order (the nearer one hides the farther one), then text; cells() is the finished picture. Whatever is not
/// finite is not drawn.
class Canvas {
public:
    /// The unit vector towards the sun (world).
    static Vector3 sun();

    /// Starts a frame of columns × rows cells, that is columns × 2·rows pixels. Throws std::invalid_argument
    /// for a camera that is not finite or has a field of view outside (0, π).
    void begin(int columns, int rows, const Camera &camera);

    int columns() const { return raster_.width(); }
    int rows() const { return raster_.height() / 2; }
    const View &view() const { return view_; }

    /// Sky, and the ground or the sea with its waves at `time` (s) and grid lines 10 m apart. Replaces all
    /// that was drawn.
    void draw(const Surroundings &surroundings, real time);

    /// Colours the bare ground: a runway, a mark. The part counts as flat, at the height 0.
    void drawOnGround(const Part &part, const Pose &pose);

    /// The shadow that the part's portion above y = 0 casts on bare ground or sea.
    void drawShadow(const Part &part, const Pose &pose);

    /// Whether faces keep their own colours, whatever light falls on them, as on a map.
    bool isFlat = false;

    /// A face is brighter the more it faces the sun. One that is seen from behind is drawn only if the part
    /// is twoSided. What one sees through (opacity below 1) hides nothing: draw it last.
    void draw(const Part &part, const Pose &pose, real opacity = 1);

    /// A straight line (world, m) of constant width in pixels, hidden by what is nearer.
    void drawLine(const Vector3 &from, const Vector3 &to, Colour colour, real width = 1);

    /// A line with a head at its tip; its name isn't shown. Too short for a head, it is all head.
    void draw(const Arrow &arrow);
    /// The arrow's name beside its tail.
    void label(const Arrow &arrow);

    /// Text (UTF-8) on a darkened strip of the picture; a negative row counts from the bottom, -1 being the
    /// last; a negative column from the right in the same way. What doesn't fit is cut off.
    void print(int column, int row, const std::string &text, Colour colour = {235, 240, 245});

    /// Lines of text in a box in the middle of the picture, or with its top at the given row.
    void printBox(const std::vector<std::string> &lines, Colour colour = {235, 240, 245},
                  std::optional<int> top = std::nullopt);

    /// A picture upon the picture, its top left corner at the cell. Its last row is left out if it has an odd
    /// number of them; what lies outside isn't shown.
    void paste(int column, int row, const Image &picture);

    /// The picture with its text, for Terminal::show. Valid until the next begin().
    const CellGrid &cells();

    /// The picture without its text.
    Image image() const;

private:
    struct Glyph {
        char32_t character;
        Colour colour;
        std::optional<Colour> background{};  ///< else the picture, darkened
    };

    std::optional<Glyph> *findGlyph(int column, int row);

    static std::vector<Vector3> toWorld(const Face &face, const Pose &pose);
    std::vector<Vector3> toView(std::vector<Vector3> corners) const;
    /// Cuts a polygon in view coordinates at the near plane, and puts the rest into the picture.
    std::vector<ScreenPoint> toPicture(const std::vector<Vector3> &inView) const;
    /// Fills a polygon (world) with exactly this colour.
    void fill(const std::vector<Vector3> &corners, Colour colour, real opacity = 1);

    View view_;
    Raster raster_;
    std::vector<std::optional<Glyph>> text_;
    CellGrid cells_;
};

}  // namespace demo
