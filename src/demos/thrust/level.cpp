#include "thrust/level.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "base/text.h"
#include "thrust/level_texts.h"

namespace thrust {

namespace {

/// The map as it stands in the file. To the sides and downwards its edges go on; above it is the sky.
class Map {
public:
    void addRow(const std::string &row) {
        for (std::size_t column = 0; column < row.size(); ++column) addMark(row[column], column);
        rows.push_back(row);
        columns = std::max(columns, static_cast<int>(row.size()));
    }
    bool has(char mark) const { return marks.count(mark) > 0; }
    Vector3 placeOf(char mark) const {
        const auto [column, row] = marks.at(mark);
        return place(column, row);
    }
    int width() const { return columns; }
    int height() const { return static_cast<int>(rows.size()); }
    char at(int column, int row) const {
        const std::string &text = rows[static_cast<std::size_t>(row)];
        return column < static_cast<int>(text.size()) ? text[static_cast<std::size_t>(column)] : ' ';
    }
    bool isRock(int column, int row) const {
        return row >= 0 && at(std::clamp(column, 0, columns - 1), std::min(row, height() - 1)) == '#';
    }
    Vector3 place(real column, real row) const {
        return Vector3(column * Level::ACROSS, (height() - 1 - row) * Level::DOWN, 0);
    }

private:
    void addMark(char mark, std::size_t column) {
        if (mark == ' ' || mark == '#') return;
        if (mark != 'S' && mark != 'P' && (mark < 'a' || mark > 'z'))
            throw std::runtime_error(std::string("the map has an unknown mark, ") + mark);
        if (!marks.emplace(mark, std::make_pair(static_cast<int>(column), height())).second)
            throw std::runtime_error(std::string("the map has two marks ") + mark);
    }

    std::vector<std::string> rows;
    int columns = 0;
    std::map<char, std::pair<int, int>> marks;  ///< column and row
};

constexpr int BORDER = 40, FOOT = 10;  // how far the rock goes on beyond the map, in characters

/// Between four characters the rock's surface runs through the middles of those sides where rock and air
/// meet ("marching squares", Lorensen and Cline 1987, in the plane).
void addCell(Level &level, const Map &map, int column, int row) {
    const int corners[4][2] = {{column, row + 1}, {column + 1, row + 1}, {column + 1, row}, {column, row}};
    std::vector<Vector3> solid;
    std::vector<std::size_t> crossings;  // of `solid`, where rock and air meet
    for (int n = 0; n < 4; ++n) {
        const int *const here = corners[n], *const next = corners[(n + 1) % 4];
        const bool isRock = map.isRock(here[0], here[1]);
        if (isRock) solid.push_back(map.place(here[0], here[1]));
        if (isRock == map.isRock(next[0], next[1])) continue;
        crossings.push_back(solid.size());
        solid.push_back(map.place((here[0] + next[0]) / 2.0, (here[1] + next[1]) / 2.0));
    }
    if (solid.empty()) return;
    level.rock.push_back(solid);
    // The surface goes from where the rock ends to where it begins again.
    for (const std::size_t from : crossings) {
        const std::size_t to = (from + 1) % solid.size();
        if (std::count(crossings.begin(), crossings.end(), to) > 0)
            level.walls.push_back({solid[from], solid[to]});
    }
}

/// A row of cells, those that are all rock as one.
void addRow(Level &level, const Map &map, int row) {
    int fullSince = -BORDER;
    const auto isFull = [&](int column) {
        return map.isRock(column, row) && map.isRock(column + 1, row) && map.isRock(column, row + 1) &&
               map.isRock(column + 1, row + 1);
    };
    const auto finishRun = [&](int end) {
        if (end > fullSince)
            level.rock.push_back({map.place(fullSince, row + 1), map.place(end, row + 1), map.place(end, row),
                                  map.place(fullSince, row)});
        fullSince = end + 1;
    };
    const int end = map.width() - 1 + BORDER;
    for (int column = -BORDER; column < end; ++column) {
        if (isFull(column)) continue;
        finishRun(column);
        addCell(level, map, column, row);
    }
    finishRun(end);
}

void readMap(Level &level, const Map &map) {
    if (!map.has('S') || !map.has('P')) throw std::runtime_error("the map needs a ship, S, and a pod, P");
    level.start = map.placeOf('S');
    level.pod = map.placeOf('P') - Vector3(0, Level::DOWN / 2, 0);
    for (char mark = 'a'; mark <= 'z'; ++mark)
        if (map.has(mark)) level.way.push_back(map.placeOf(mark));
    level.width = (map.width() - 1) * Level::ACROSS;
    level.height = (map.height() - 1) * Level::DOWN;
    for (int row = -1; row < map.height() + FOOT; ++row) addRow(level, map, row);
}

/// A line before the map: a word and its value.
void readLine(Level &level, const std::string &line) {
    const std::size_t space = std::min(line.find(' '), line.size());
    const std::string word = line.substr(0, space), value = line.substr(std::min(space + 1, line.size()));
    if (word == "name" && !value.empty()) {
        level.name = value;
        return;
    }
    real *const number = word == "gravity" ? &level.gravity : word == "fuel" ? &level.fuel : nullptr;
    if (number == nullptr) throw std::runtime_error("'" + line + "' is not understood");
    const std::optional<real> read = demo::readNumber(value);
    if (!read || *read <= 0) throw std::runtime_error(word + " must be a positive number");
    *number = *read;
}

}  // namespace

Level readLevel(std::string_view text) {
    Level level;
    Map map;
    bool isMap = false;
    std::istringstream in{std::string(text)};
    int number = 0;
    try {
        for (std::string line; std::getline(in, line);) {
            ++number;
            if (!line.empty() && line.back() == '\r') line.pop_back();
            if (isMap)
                map.addRow(line);
            else if (line == "map")
                isMap = true;
            else if (!line.empty() && line[0] != '#')
                readLine(level, line);
        }
        readMap(level, map);
    } catch (const std::runtime_error &mistake) {
        throw std::runtime_error("line " + std::to_string(number) + ": " + mistake.what());
    }
    return level;
}

Level getLevel(std::size_t number) { return readLevel(levelTexts.at(number - 1)); }

}  // namespace thrust
