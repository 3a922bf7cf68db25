#include "picture/cells.h"

#include <gtest/gtest.h>

using namespace demo;

namespace {

/// A terminal that knows just the sequences used here, and fails on every other one.
class Screen {
public:
    Screen(int columns, int rows) : grid(columns, rows) {}
    CellGrid grid;
    int written = 0, cleared = 0;

    void feed(const std::string &bytes) {
        const std::u32string text = fromUtf8(bytes);
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] != 0x1b) {
                ASSERT_LT(column_, grid.columns) << "beyond the right edge";
                grid.at(column_++, row_) = {text[i], foreground_, background_};
                ++written;
                continue;
            }
            ASSERT_EQ(text[++i], U'[');
            std::vector<int> numbers{0};
            for (++i; text[i] < U'@'; ++i) {
                if (text[i] == U';')
                    numbers.push_back(0);
                else
                    numbers.back() = numbers.back() * 10 + static_cast<int>(text[i] - U'0');
            }
            sequence(text[i], numbers);
        }
    }

private:
    void sequence(char32_t final, const std::vector<int> &n) {
        const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(n.at(i)); };
        if (final == U'H') {
            row_ = n.at(0) - 1;
            column_ = n.at(1) - 1;
        } else if (final == U'J') {
            grid = CellGrid(grid.columns, grid.rows);
            ++cleared;
        } else if (final == U'm' && n[0] != 0) {
            ASSERT_EQ(n.at(1), 2);
            (n[0] == 38 ? foreground_ : background_) = {byte(2), byte(3), byte(4)};
        }
    }

    int column_ = 0, row_ = 0;
    Colour foreground_, background_;
};

CellGrid colourful(int columns, int rows, int variant) {
    CellGrid grid(columns, rows);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const auto value = [&](int a, int b) {
                return static_cast<unsigned char>((a * row + b * column + 50 * variant) % 256);
            };
            grid.at(column, row) = {(row + column) % 3 == 0 ? U'é' : U'▀',
                                    {value(7, 3), value(40, 1), value(2, 90)},
                                    {value(1, 1), value(2, 5), value(60, 4)}};
        }
    return grid;
}

void expectClose(Colour a, Colour b) {
    EXPECT_NEAR(a.red, b.red, 3);
    EXPECT_NEAR(a.green, b.green, 3);
    EXPECT_NEAR(a.blue, b.blue, 3);
}

void expectShows(const CellGrid &screen, const CellGrid &wanted) {
    ASSERT_EQ(screen.cells.size(), wanted.cells.size());
    for (std::size_t i = 0; i < wanted.cells.size(); ++i) {
        EXPECT_EQ(screen.cells[i].glyph, wanted.cells[i].glyph);
        expectClose(screen.cells[i].foreground, wanted.cells[i].foreground);
        expectClose(screen.cells[i].background, wanted.cells[i].background);
    }
}

TEST(DemoCells, TheScreenShowsThePictureFrameAfterFrame) {
    Screen screen(20, 6);
    CellGrid shown;
    for (int variant = 0; variant < 4; ++variant) {
        const CellGrid picture = colourful(20, 6, variant);
        screen.feed(encodeChanges(shown, picture, ColourDepth::TRUECOLOUR));
        expectShows(screen.grid, picture);
    }
    EXPECT_EQ(screen.cleared, 1);
}

TEST(DemoCells, OnlyWhatChangesIsWritten) {
    CellGrid shown;
    CellGrid picture = colourful(20, 6, 0);
    encodeChanges(shown, picture, ColourDepth::TRUECOLOUR);
    EXPECT_EQ(encodeChanges(shown, picture, ColourDepth::TRUECOLOUR), "");

    picture.at(7, 2) = {U'x', {1, 2, 3}, {200, 100, 0}};
    EXPECT_EQ(encodeChanges(shown, picture, ColourDepth::TRUECOLOUR),
              "\x1b[3;8H\x1b[48;2;200;100;0m\x1b[38;2;1;2;3mx");
}

TEST(DemoCells, EveryChangeFindsItsPlace) {
    Screen screen(20, 6);
    CellGrid shown;
    CellGrid picture = colourful(20, 6, 0);
    screen.feed(encodeChanges(shown, picture, ColourDepth::TRUECOLOUR));
    for (int column : {2, 3, 9, 19}) picture.at(column, 4).glyph = U'o';
    picture.at(0, 5).glyph = U'o';
    screen.feed(encodeChanges(shown, picture, ColourDepth::TRUECOLOUR));
    expectShows(screen.grid, picture);
    EXPECT_EQ(screen.written, 120 + 5);
}

TEST(DemoCells, InvisibleDriftDoesNotAddUp) {
    Screen screen(9, 1);
    CellGrid shown, picture(9, 1);
    for (int grey = 0; grey < 200; ++grey) {
        for (int column = 0; column < 9; ++column) {
            const auto value = static_cast<unsigned char>(grey + column);
            picture.at(column, 0).background = {value, value, value};
        }
        screen.feed(encodeChanges(shown, picture, ColourDepth::TRUECOLOUR));
        expectShows(screen.grid, picture);
    }
    EXPECT_LT(screen.written, 200 * 9 / 2);
}

TEST(DemoCells, ANewSizeStartsAfresh) {
    CellGrid shown;
    encodeChanges(shown, colourful(20, 6, 0), ColourDepth::TRUECOLOUR);
    Screen screen(10, 9);
    screen.feed(encodeChanges(shown, colourful(10, 9, 0), ColourDepth::TRUECOLOUR));
    EXPECT_EQ(screen.cleared, 1);
    expectShows(screen.grid, colourful(10, 9, 0));
    EXPECT_EQ(encodeChanges(shown, CellGrid(), ColourDepth::TRUECOLOUR), "\x1b[0m\x1b[2J");
}

TEST(DemoCells, PaletteEntriesAreThoseOfXterm) {
    EXPECT_EQ(paletteIndex({0, 0, 0}), 16);
    EXPECT_EQ(paletteIndex({255, 255, 255}), 231);
    EXPECT_EQ(paletteIndex({255, 0, 0}), 196);
    EXPECT_EQ(paletteIndex({95, 135, 175}), 67);
    EXPECT_EQ(paletteIndex({8, 8, 8}), 232);
    EXPECT_EQ(paletteIndex({118, 118, 118}), 243);
    EXPECT_EQ(paletteIndex({238, 238, 238}), 255);
}

TEST(DemoCells, ThePaletteIsDitheredAroundTheWantedColour) {
    // (155, 155, 215) lies half-way between the cube's 135 and 175.
    CellGrid shown, picture(4, 2);
    for (Cell &cell : picture.cells) cell.background = {155, 155, 215};
    const std::string bytes = encodeChanges(shown, picture, ColourDepth::PALETTE);
    EXPECT_EQ(bytes.find(";2;"), std::string::npos);
    int sum = 0;
    for (const Cell &cell : shown.cells)
        sum += (cell.glyph == U' ' ? cell.background : cell.foreground).red + cell.background.red;
    EXPECT_NEAR(sum / 16.0, 155, 6);
    EXPECT_EQ(encodeChanges(shown, picture, ColourDepth::PALETTE), "") << "still the same picture";
}

TEST(DemoCells, Utf8ThereAndBack) {
    const std::u32string text = U"aé▀\U0001F6E9";
    std::string bytes;
    for (char32_t c : text) appendUtf8(bytes, c);
    EXPECT_EQ(bytes, "a\xc3\xa9\xe2\x96\x80\xf0\x9f\x9b\xa9");
    EXPECT_EQ(fromUtf8(bytes), text);
    EXPECT_EQ(fromUtf8("\xc3"), U"\uFFFD");
    EXPECT_EQ(fromUtf8("\xff"
                       "b\xe2\x96"),
              U"\uFFFDb\uFFFD");
}

TEST(DemoCells, ANegativeSizeIsEmpty) { EXPECT_TRUE(CellGrid(-3, 5).cells.empty()); }

}  // namespace
