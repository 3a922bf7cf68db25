#include "shell/layout.h"

#include "picture/cells.h"

#include <algorithm>

namespace demo {

namespace {

std::string toUtf8(const std::u32string &text) {
    std::string bytes;
    for (const char32_t character : text) appendUtf8(bytes, character);
    return bytes;
}

/// Where to end the first line of a text that is longer than that; behind the indent.
std::size_t findBreak(const std::u32string &text, std::size_t columns, std::size_t indent) {
    for (const std::u32string &gap : {std::u32string(U"  "), std::u32string(U" ")}) {
        const std::size_t at = text.rfind(gap, columns);
        if (at == std::u32string::npos) continue;
        const std::size_t end = text.find_last_not_of(U' ', at);
        if (end != std::u32string::npos && end >= indent) return end + 1;
    }
    return columns;
}

/// The column of what a key does, behind the key; 0 for a line of plain text.
std::size_t findDescription(const std::string &line) {
    const std::u32string text = fromUtf8(line);
    const std::size_t gap = text.find(U"  ");
    const std::size_t at = gap == std::u32string::npos ? gap : text.find_first_not_of(U' ', gap);
    return at == std::u32string::npos ? 0 : at;
}

}  // namespace

std::vector<std::string> broken(const std::string &line, std::size_t columns, std::size_t indent) {
    std::vector<std::string> lines;
    std::u32string rest = fromUtf8(line);
    columns = std::max<std::size_t>(columns, 1);
    if (indent >= columns) indent = 0;
    while (rest.size() > columns) {
        const std::size_t end = findBreak(rest, columns, indent);
        lines.push_back(toUtf8(rest.substr(0, end)));
        const std::size_t next = rest.find_first_not_of(U' ', end);
        if (next == std::u32string::npos) return lines;
        rest = std::u32string(indent, U' ') + rest.substr(next);
    }
    lines.push_back(toUtf8(rest));
    return lines;
}

std::vector<std::vector<std::string>> paginated(const std::vector<std::string> &lines, std::size_t columns,
                                                std::size_t rows) {
    std::vector<std::vector<std::string>> pages(1);
    for (const std::string &line : lines) {
        for (const std::string &part : broken(line, columns, findDescription(line))) {
            if (pages.back().size() >= std::max<std::size_t>(rows, 1)) pages.emplace_back();
            if (!part.empty() || !pages.back().empty()) pages.back().push_back(part);
        }
    }
    return pages;
}

}  // namespace demo
