#include "picture/cells.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace demo {

CellGrid::CellGrid(int columns_, int rows_) : columns(std::max(columns_, 0)), rows(std::max(rows_, 0)) {
    cells.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
}

namespace {

constexpr std::array<int, 6> CUBE_LEVELS{0, 95, 135, 175, 215, 255};

int nearestLevel(int value) {
    int best = 0;
    for (int i = 1; i < 6; ++i) {
        const auto distance = [&](int level) {
            return std::abs(CUBE_LEVELS[static_cast<std::size_t>(level)] - value);
        };
        if (distance(i) < distance(best)) best = i;
    }
    return best;
}

int squareDistance(Colour a, int red, int green, int blue) {
    const int r = a.red - red, g = a.green - green, b = a.blue - blue;
    return r * r + g * g + b * b;
}

}  // namespace

int paletteIndex(Colour colour) {
    const int r = nearestLevel(colour.red), g = nearestLevel(colour.green), b = nearestLevel(colour.blue);
    const auto level = [](int i) { return CUBE_LEVELS[static_cast<std::size_t>(i)]; };
    const int mean = (colour.red + colour.green + colour.blue) / 3;
    const int step = std::clamp((mean - 3) / 10, 0, 23);
    const int grey = 8 + 10 * step;
    if (squareDistance(colour, grey, grey, grey) < squareDistance(colour, level(r), level(g), level(b)))
        return 232 + step;
    return 16 + 36 * r + 6 * g + b;
}

namespace {

bool looksSame(Colour a, Colour b) {
    constexpr int TOLERANCE = 3;
    return std::abs(a.red - b.red) <= TOLERANCE && std::abs(a.green - b.green) <= TOLERANCE &&
           std::abs(a.blue - b.blue) <= TOLERANCE;
}

bool looksSame(const Cell &a, const Cell &b) {
    return a.glyph == b.glyph && looksSame(a.background, b.background) &&
           (a.glyph == U' ' || looksSame(a.foreground, b.foreground));
}

Colour paletteColour(int index) {
    const auto byte = [](int value) { return static_cast<unsigned char>(value); };
    if (index >= 232)
        return {byte(8 + 10 * (index - 232)), byte(8 + 10 * (index - 232)), byte(8 + 10 * (index - 232))};
    const auto level = [&](int i) { return byte(CUBE_LEVELS[static_cast<std::size_t>(i % 6)]); };
    return {level((index - 16) / 36), level((index - 16) / 6), level(index - 16)};
}

/// The palette's colours are far apart: neighbouring pixels are pushed different ways (Bayer 1973), so that
/// their mean comes close to the wanted colour.
Colour dithered(Colour colour, int x, int y) {
    constexpr int ORDER[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    constexpr int STRENGTH = 32;  // a little less than the distance between the brighter levels
    const int push = (2 * ORDER[y % 4][x % 4] - 15) * STRENGTH / 32;
    const auto pushed = [&](int value) {
        return static_cast<unsigned char>(std::clamp(value + push, 0, 255));
    };
    return paletteColour(paletteIndex({pushed(colour.red), pushed(colour.green), pushed(colour.blue)}));
}

/// The picture in colours of the palette. Half blocks and blanks are dithered; text is not.
CellGrid inPalette(const CellGrid &picture) {
    CellGrid result = picture;
    for (int row = 0; row < picture.rows; ++row) {
        for (int column = 0; column < picture.columns; ++column) {
            Cell &cell = result.at(column, row);
            if (cell.glyph == U' ' || cell.glyph == HALF_BLOCK) {
                const Colour upper = cell.glyph == U' ' ? cell.background : cell.foreground;
                cell = {HALF_BLOCK, dithered(upper, column, 2 * row),
                        dithered(cell.background, column, 2 * row + 1)};
                if (cell.foreground == cell.background) cell.glyph = U' ';
            } else {
                cell.foreground = paletteColour(paletteIndex(cell.foreground));
                cell.background = paletteColour(paletteIndex(cell.background));
            }
        }
    }
    return result;
}

/// Writes cells with as few sequences as the terminal's present state (position and colours) allows.
class Pen {
public:
    Pen(std::string &out, ColourDepth depth) : out_(out), depth_(depth) {}

    void clearScreen() { out_ += "\x1b[0m\x1b[2J"; }

    /// Returns the cell as it was really written.
    Cell write(int column, int row, Cell cell) {
        if (column != column_ || row != row_) moveTo(column, row);
        setColour(background_, cell.background, "48");
        if (cell.glyph != U' ') setColour(foreground_, cell.foreground, "38");
        appendUtf8(out_, cell.glyph);
        ++column_;
        return {cell.glyph, foreground_.colour, background_.colour};
    }

private:
    struct Current {
        bool known = false;
        Colour colour;
    };

    void moveTo(int column, int row) {
        out_ += "\x1b[" + std::to_string(row + 1) + ';' + std::to_string(column + 1) + 'H';
        column_ = column;
        row_ = row;
    }

    void setColour(Current &current, Colour colour, const char *selector) {
        if (current.known && looksSame(current.colour, colour)) return;
        current = {true, colour};
        out_ += std::string("\x1b[") + selector;
        if (depth_ == ColourDepth::TRUECOLOUR) {
            out_ += ";2;" + std::to_string(colour.red) + ';' + std::to_string(colour.green) + ';' +
                    std::to_string(colour.blue);
        } else {
            out_ += ";5;" + std::to_string(paletteIndex(colour));
        }
        out_ += 'm';
    }

    std::string &out_;
    ColourDepth depth_;
    int column_ = -1, row_ = -1;
    Current foreground_, background_;
};

std::string writeChanges(CellGrid &shown, const CellGrid &next, ColourDepth depth) {
    std::string out;
    Pen pen(out, depth);
    const bool all = shown.columns != next.columns || shown.rows != next.rows;
    if (all) {
        shown = CellGrid(next.columns, next.rows);
        pen.clearScreen();
    }
    for (int row = 0; row < next.rows; ++row) {
        for (int column = 0; column < next.columns; ++column) {
            const Cell &wanted = next.at(column, row);
            Cell &present = shown.at(column, row);
            if (all || !looksSame(present, wanted)) present = pen.write(column, row, wanted);
        }
    }
    return out;
}

}  // namespace

std::string encodeChanges(CellGrid &shown, const CellGrid &next, ColourDepth depth) {
    return depth == ColourDepth::PALETTE ? writeChanges(shown, inPalette(next), depth)
                                         : writeChanges(shown, next, depth);
}
void appendUtf8(std::string &text, char32_t c) {
    const auto push = [&](char32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
    if (c < 0x80) {
        push(c);
    } else if (c < 0x800) {
        push(0xC0 | c >> 6);
        push(0x80 | (c & 0x3F));
    } else if (c < 0x10000) {
        push(0xE0 | c >> 12);
        push(0x80 | (c >> 6 & 0x3F));
        push(0x80 | (c & 0x3F));
    } else {
        push(0xF0 | c >> 18);
        push(0x80 | (c >> 12 & 0x3F));
        push(0x80 | (c >> 6 & 0x3F));
        push(0x80 | (c & 0x3F));
    }
}

std::u32string fromUtf8(const std::string &text) {
    std::u32string characters;
    for (std::size_t i = 0; i < text.size();) {
        const auto first = static_cast<unsigned char>(text[i++]);
        const int more = first < 0x80 ? 0 : first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
        char32_t c = more == 0 ? first : first & (0x7Fu >> (more + 1));
        bool good = first < 0x80 || (first >= 0xC2 && first <= 0xF4);
        for (int k = 0; k < more && good; ++k) {
            good = i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
            if (good) c = c << 6 | (static_cast<unsigned char>(text[i++]) & 0x3Fu);
        }
        characters += good ? c : U'\uFFFD';
    }
    return characters;
}

}  // namespace demo
