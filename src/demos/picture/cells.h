#pragma once

/// A picture of character cells, and the bytes that bring a terminal from one picture to the next.
#include "picture/scene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace demo {

inline bool operator==(Colour a, Colour b) {
    return a.red == b.red && a.green == b.green && a.blue == b.blue;
}
inline bool operator!=(Colour a, Colour b) { return !(a == b); }

/// Its upper half shows the foreground, its lower half the background: two pixels in one cell.
constexpr char32_t HALF_BLOCK = U'▀';

/// One character on the screen. Glyphs are one column wide.
struct Cell {
    char32_t glyph = U' ';
    Colour foreground, background;
};

/// `columns` × `rows` cells, row by row from the top left.
struct CellGrid {
    int columns = 0, rows = 0;
    std::vector<Cell> cells;

    CellGrid() = default;
    /// Blank cells; a negative size counts as 0.
    CellGrid(int columns, int rows);

    Cell &at(int column, int row) { return cells[index(column, row)]; }
    const Cell &at(int column, int row) const { return cells[index(column, row)]; }

private:
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
};

/// How many colours a terminal can show: 24-bit, or the 256 of xterm's palette.
enum class ColourDepth { TRUECOLOUR, PALETTE };

/// The palette's nearest entry, from the 6×6×6 cube (16 to 231) or the greys (232 to 255).
int paletteIndex(Colour colour);

/// The bytes (UTF-8 with SGR and CUP sequences) that turn `shown` into `next`; afterwards `shown` is what the
/// screen shows. Only cells that differ are written; empty if none does. A colour within 3/255 per channel of
/// the wanted one counts as the same: nobody sees it, and it saves most of the bytes. If the sizes differ,
/// everything is written and the screen is cleared first.
std::string encodeChanges(CellGrid &shown, const CellGrid &next, ColourDepth depth);

/// Appends one character as UTF-8.
void appendUtf8(std::string &text, char32_t character);

/// The characters of a UTF-8 string; malformed bytes become U+FFFD.
std::u32string fromUtf8(const std::string &text);

}  // namespace demo
