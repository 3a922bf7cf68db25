#pragma once

/// Text that fits small screens. Lengths are in characters, not bytes.
#include <cstddef>
#include <string>
#include <vector>

namespace demo {

/// A line as several where it is too long. Breaks are where two blanks or more are, if there is any such
/// place, else at single blanks, else where the screen ends. Further lines begin with `indent` blanks.
std::vector<std::string> broken(const std::string &line, std::size_t columns, std::size_t indent = 0);

/// Help for a screen of this size, page by page: what a key does goes on below its own text, not below the
/// key. At least a line and a column.
std::vector<std::vector<std::string>> paginated(const std::vector<std::string> &lines, std::size_t columns,
                                                std::size_t rows);

}  // namespace demo
