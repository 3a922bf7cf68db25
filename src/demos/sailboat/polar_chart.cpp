#include "sailboat/polar_chart.h"

#include "base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <stdexcept>

namespace sailboat {

using namespace demo;

namespace {

constexpr real DEGREE = cyclone::REAL_PI / 180, KNOT = 1852.0 / 3600;  // rad, m/s
constexpr real WIDTH = 860, HEIGHT = 900, CENTRE_X = 110, CENTRE_Y = 480, RADIUS = 370, LEGEND_X = 510;

/// From light wind to strong.
constexpr std::array<const char *, 4> COLOURS = {"#2a9d8f", "#1d5fa8", "#7b3fa0", "#c2410c"};

const char *const STYLE =
    "text{font-family:system-ui,-apple-system,'Segoe UI','DejaVu "
    "Sans',sans-serif;font-size:14px;fill:#37424d}"
    ".title{font-size:24px;font-weight:600;fill:#17202a}.sub{font-size:15px;fill:#5b6670}"
    ".name{font-style:italic;fill:#6b7680}.ring{fill:none;stroke:#c3ccd4}.spoke{stroke:#d9dfe4}"
    ".axis{stroke:#9aa5ae}.curve{fill:none;stroke-width:3;stroke-linejoin:round}"
    ".best{stroke:#fff;stroke-width:2}";

std::string degrees(real angle) { return fixed(angle / DEGREE, 0) + "°"; }

/// A place in the picture.
struct Place {
    real x = 0, y = 0;
};

/// The chart while it is drawn: where a speed at an angle lies.
class Chart {
public:
    Chart(std::ostream &stream, const std::vector<Polar> &drawn) : out(stream), polars(drawn) {
        real most = 0;
        for (const Polar &polar : polars)
            if (!polar.points.empty()) most = std::max(most, polar.fastest().speed);
        if (most <= 0) throw std::invalid_argument("drawPolars: there is no speed to draw");
        spacing = 0.5;
        while (most / spacing > 10) spacing *= 2;
        rings = static_cast<int>(std::ceil(most / spacing));
    }

    void draw() {
        out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << fixed(WIDTH, 0) << ' '
            << fixed(HEIGHT, 0) << "\" role=\"img\" aria-label=\"Polar diagram of the catamaran\">\n<style>"
            << STYLE << "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fdfdfb\"/>\n";
        drawScale();
        drawPointsOfSail();
        drawWind();
        for (std::size_t n = 0; n < polars.size(); ++n) drawCurve(polars[n], COLOURS[n % COLOURS.size()]);
        drawLegend();
        out << "</svg>\n";
    }

private:
    Place at(real angle, real speed) const {
        const real r = RADIUS * speed / (spacing * rings);
        return {CENTRE_X + r * std::sin(angle), CENTRE_Y - r * std::cos(angle)};
    }

    void write(Place where, const std::string &text, const char *anchor = "start", const char *kind = "") {
        out << "<text x=\"" << fixed(where.x, 1) << "\" y=\"" << fixed(where.y, 1) << "\" text-anchor=\""
            << anchor << "\" class=\"" << kind << "\">" << text << "</text>\n";
    }

    void drawLine(Place from, Place to, const char *kind) {
        out << "<line x1=\"" << fixed(from.x, 1) << "\" y1=\"" << fixed(from.y, 1) << "\" x2=\""
            << fixed(to.x, 1) << "\" y2=\"" << fixed(to.y, 1) << "\" class=\"" << kind << "\"/>\n";
    }

    void drawScale() {
        const real edge = spacing * rings;
        drawNoGo(edge);
        for (int ring = 1; ring <= rings; ++ring) {
            const Place top = at(0, ring * spacing), bottom = at(cyclone::REAL_PI, ring * spacing);
            const real r = CENTRE_Y - top.y;
            out << "<path d=\"M" << fixed(top.x, 1) << ' ' << fixed(top.y, 1) << 'A' << fixed(r, 1) << ' '
                << fixed(r, 1) << " 0 0 1 " << fixed(bottom.x, 1) << ' ' << fixed(bottom.y, 1)
                << "\" class=\"ring\"/>\n";
            const std::string label = fixed(ring * spacing, spacing < 1 ? 1 : 0);
            write({top.x - 8, top.y + 5}, ring == rings ? label + " m/s" : label, "end");
            write({bottom.x - 8, bottom.y + 5}, label, "end");
        }
        for (int angle = 15; angle < 180; angle += 15)
            drawLine(at(angle * DEGREE, angle % 30 == 0 ? 0 : spacing), at(angle * DEGREE, edge), "spoke");
        for (int angle = 30; angle < 180; angle += 30) {
            const Place rim = at(angle * DEGREE, edge * 1.03);
            write({rim.x, rim.y + 5}, std::to_string(angle) + "°");
        }
        drawLine(at(0, edge), at(cyclone::REAL_PI, edge), "axis");
    }

    /// Where no course can be held in any of these winds.
    void drawNoGo(real edge) {
        real limit = cyclone::REAL_PI;
        for (const Polar &polar : polars)
            for (const PolarPoint &point : polar.points)
                if (point.speed > 0) limit = std::min(limit, point.windAngle);
        const Place top = at(0, edge), side = at(limit, edge);
        out << "<path d=\"M" << fixed(CENTRE_X, 1) << ' ' << fixed(CENTRE_Y, 1) << 'L' << fixed(top.x, 1)
            << ' ' << fixed(top.y, 1) << 'A' << fixed(RADIUS, 1) << ' ' << fixed(RADIUS, 1) << " 0 0 1 "
            << fixed(side.x, 1) << ' ' << fixed(side.y, 1) << "Z\" fill=\"#f6e3df\"/>\n";
    }

    void drawPointsOfSail() {
        const struct {
            real angle;
            const char *name;
        } names[] = {{8, "in irons"},
                     {45, "close hauled"},
                     {90, "beam reach"},
                     {135, "broad reach"},
                     {168, "running"}};
        for (const auto &point : names) {
            const Place rim = at(point.angle * DEGREE, spacing * rings * 1.03);
            // Where a number of degrees stands already, the name goes below it.
            write({rim.x, rim.y + (point.angle == 90 ? 24 : 5)}, point.name, "start", "name");
        }
    }

    void drawWind() {
        const real x = CENTRE_X, y = CENTRE_Y - RADIUS - 16;
        out << "<path d=\"M" << fixed(x, 1) << ' ' << fixed(y - 34, 1) << "v24m-7 0h14l-7 12z"
            << "\" stroke=\"#37424d\" stroke-width=\"2.5\" fill=\"#37424d\"/>\n";
        write({x - 14, y - 16}, "wind", "end");
    }

    void drawCurve(const Polar &polar, const char *colour) {
        out << "<path class=\"curve\" stroke=\"" << colour << "\" d=\"";
        for (std::size_t n = 0; n < polar.points.size(); ++n) {
            const Place place = at(polar.points[n].windAngle, polar.points[n].speed);
            out << (n == 0 ? 'M' : 'L') << fixed(place.x, 1) << ' ' << fixed(place.y, 1);
        }
        out << "\"/>\n";
        for (const PolarPoint &point : {polar.bestUpwind(), polar.fastest(), polar.bestDownwind()}) {
            const Place place = at(point.windAngle, point.speed);
            out << "<circle class=\"best\" cx=\"" << fixed(place.x, 1) << "\" cy=\"" << fixed(place.y, 1)
                << "\" r=\"6\" fill=\"" << colour << "\"/>\n";
        }
    }

    void drawLegend() {
        write({40, 40}, "How fast the catamaran sails", "start", "title");
        real y = 44;
        for (std::size_t n = 0; n < polars.size(); ++n) {
            const Polar &polar = polars[n];
            y += 30;
            out << "<rect x=\"" << fixed(LEGEND_X - 26, 1) << "\" y=\"" << fixed(y - 9, 1)
                << "\" width=\"18\" height=\"8\" rx=\"2\" fill=\"" << COLOURS[n % COLOURS.size()] << "\"/>\n";
            write({LEGEND_X, y},
                  "wind " + fixed(polar.windspeed, 1) + " m/s (" + fixed(polar.windspeed / KNOT, 0) + " kn)");
            drawLegendLine(y, "fastest, at ", polar.fastest(), polar.fastest().speed);
            drawLegendLine(y, "made good to windward, at ", polar.bestUpwind(), polar.bestUpwind().madeGood);
            drawLegendLine(y, "made good to leeward, at ", polar.bestDownwind(),
                           -polar.bestDownwind().madeGood);
        }
        write({WIDTH - 30, HEIGHT - 40}, "Dots: the fastest course, and the best ones", "end", "sub");
        write({WIDTH - 30, HEIGHT - 20}, "to windward and to leeward.", "end", "sub");
    }

    void drawLegendLine(real &y, const std::string &what, const PolarPoint &point, real speed) {
        y += 19;
        write({LEGEND_X, y}, what + degrees(point.windAngle), "start", "sub");
        write({WIDTH - 30, y}, fixed(speed, 1) + " m/s", "end", "sub");
    }

    std::ostream &out;
    const std::vector<Polar> &polars;
    real spacing = 1;  // m/s between rings
    int rings = 1;
};

}  // namespace

void drawPolars(std::ostream &out, const std::vector<Polar> &polars) { Chart(out, polars).draw(); }

}  // namespace sailboat
