/// One small change at a time in a C++ source that is formatted as this library's are: signs, comparisons,
/// conditions, constants, dropped statements, swapped arguments. Comments, texts and preprocessor lines stay.
///
///     mutate FILE            how many such changes there are
///     mutate FILE NUMBER     the whole file with that change, from 0; to stderr, the line before and after
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

using Lines = std::vector<std::string>;

struct Change {
    std::size_t line, begin, length;
    std::string replacement;
};

bool isWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// The line with comments and texts blanked out, so that positions stay.
std::string codeOf(std::string line) {
    const std::size_t first = line.find_first_not_of(' ');
    if (first != std::string::npos && line[first] == '#') return std::string(line.size(), ' ');
    bool inText = false;
    for (std::size_t n = 0; n < line.size(); ++n) {
        if (!inText && line.compare(n, 2, "//") == 0) {
            std::fill(line.begin() + static_cast<std::ptrdiff_t>(n), line.end(), ' ');
            break;
        }
        const bool escaped = n > 0 && line[n - 1] == '\\';
        if (line[n] == '"' && !escaped)
            inText = !inText;
        else if (inText)
            line[n] = ' ';
    }
    return line;
}

/// The end of what the parenthesis at `open` encloses on this line, or npos.
std::size_t closingOf(const std::string &code, std::size_t open) {
    int depth = 0;
    for (std::size_t n = open; n < code.size(); ++n) {
        if (std::string("([{").find(code[n]) != std::string::npos) ++depth;
        if (std::string(")]}").find(code[n]) != std::string::npos && --depth == 0) return n;
    }
    return std::string::npos;
}

class Finder {
public:
    explicit Finder(const Lines &all) {
        for (line = 0; line < all.size(); ++line) {
            code = codeOf(all[line]);
            if (!mayMatter()) continue;
            findOperators();
            findSigns();
            findConditions();
            findConstants();
            findStatements();
            findArguments();
        }
    }
    const std::vector<Change> &get() const { return changes; }

private:
    /// Prefetches change nothing but the speed.
    bool mayMatter() const {
        for (const char *word : {"static_assert", "= delete", "prefetch", "PREFETCH"})
            if (code.find(word) != std::string::npos) return false;
        return true;
    }

    void add(std::size_t begin, std::size_t length, const std::string &replacement) {
        changes.push_back({line, begin, length, replacement});
    }

    void findOperators() {
        static const std::pair<const char *, const char *> SWAPS[] = {
            {" < ", " <= "},  {" <= ", " < "},   {" > ", " >= "},  {" >= ", " > "},  {" == ", " != "},
            {" != ", " == "}, {" && ", " || "},  {" || ", " && "}, {" + ", " - "},   {" - ", " + "},
            {" * ", " / "},   {" / ", " * "},    {" += ", " -= "}, {" -= ", " += "}, {"++", "--"},
            {" % ", " * "},   {"true", "false"}, {"false", "true"}};
        for (const auto &[from, to] : SWAPS)
            for (std::size_t n = code.find(from); n != std::string::npos; n = code.find(from, n + 1))
                if (!joinsTexts(n, std::string(from).size())) add(n, std::string(from).size(), to);
    }
    bool joinsTexts(std::size_t begin, std::size_t length) const {
        const std::string neighbours = code.substr(begin - (begin > 0), 1) + code.substr(begin + length, 1);
        return neighbours.find_first_of("\"'") != std::string::npos;
    }

    /// -x becomes x.
    void findSigns() {
        for (std::size_t n = 1; n + 1 < code.size(); ++n) {
            const bool begins = code[n - 1] == '(' || code[n - 1] == ' ' || code[n - 1] == '{';
            if (code[n] == '-' && begins && (isWordCharacter(code[n + 1]) || code[n + 1] == '('))
                add(n, 1, "");
        }
    }

    void findConditions() {
        for (const char *keyword : {"if (", "while ("}) {
            const std::size_t n = code.find(keyword);
            if (n == std::string::npos) continue;
            const std::size_t open = n + std::string(keyword).size() - 1, close = closingOf(code, open);
            if (close == std::string::npos || code.find(';', open) < close) continue;
            add(open, close + 1 - open, "(!" + code.substr(open, close + 1 - open) + ")");
        }
    }

    /// Whole numbers become one more, others twice as large.
    void findConstants() {
        for (std::size_t n = 1; n < code.size(); ++n) {
            const char before = code[n - 1];
            if (!std::isdigit(static_cast<unsigned char>(code[n])) || isWordCharacter(before) ||
                before == '.' || before == '[')
                continue;
            std::size_t end = n;
            while (end < code.size() &&
                   (isWordCharacter(code[end]) || code[end] == '.' || isExponentSign(end, n)))
                ++end;
            const std::string number = code.substr(n, end - n);
            const bool isHex = number.compare(0, 2, "0x") == 0;
            const bool isReal = number.find_first_of(isHex ? ".p" : ".e") != std::string::npos;
            add(n, end - n, isReal ? "(2 * " + number + ")" : "(" + number + " + 1)");
            n = end;
        }
    }
    bool isExponentSign(std::size_t n, std::size_t begin) const {
        const bool isHex = code.compare(begin, 2, "0x") == 0;
        return (code[n] == '-' || code[n] == '+') && code[n - 1] == (isHex ? 'p' : 'e');
    }

    /// Calls and assignments that fill a line, or its end after a condition.
    void findStatements() {
        std::size_t begin = code.find_first_not_of(' ');
        if (begin == std::string::npos) return;
        for (const char *keyword : {"if (", "for ("})
            if (code.compare(begin, std::string(keyword).size(), keyword) == 0) {
                const std::size_t close = closingOf(code, code.find('(', begin));
                if (close == std::string::npos || close + 2 >= code.size()) return;
                begin = close + 2;
            }
        const std::size_t end = code.find_last_not_of(' ');
        if (code[end] != ';' || begin >= end) return;
        std::size_t wordEnd = begin;
        while (isWordCharacter(code[wordEnd]) ||
               std::string(".:->[]*+").find(code[wordEnd]) != std::string::npos)
            ++wordEnd;
        const std::string rest = code.substr(wordEnd, 4);
        const bool isStatement = wordEnd > begin && (rest[0] == '(' || rest[0] == ';' || rest.find("= ") < 3);
        const std::string word = code.substr(begin, wordEnd - begin);
        if (!isStatement || word == "return" || word == "break" || word == "continue") return;
        if (std::count(code.begin(), code.end(), '(') != std::count(code.begin(), code.end(), ')')) return;
        add(begin, end - begin, "");
    }

    /// The first two arguments of a call.
    void findArguments() {
        for (std::size_t open = code.find('('); open != std::string::npos; open = code.find('(', open + 1)) {
            const std::size_t close = closingOf(code, open);
            if (open == 0 || !isWordCharacter(code[open - 1]) || close == std::string::npos) continue;
            if (isCommutative(open)) continue;
            const std::vector<std::size_t> commas = commasBetween(open, close);
            if (commas.empty() || code.find(';', open) < close) continue;
            const std::size_t second = commas.size() > 1 ? commas[1] : close;
            const std::string a = code.substr(open + 1, commas[0] - open - 1);
            const std::string b = code.substr(commas[0] + 2, second - commas[0] - 2);
            if (isParameter(a) || isParameter(b)) continue;
            if (a != b && a.find('"') == std::string::npos && b.find('"') == std::string::npos)
                add(open + 1, second - open - 1, b + ", " + a);
        }
    }
    /// A type and a name, not an expression.
    static bool isParameter(const std::string &argument) {
        const std::size_t space = argument.rfind(' ');
        return space != std::string::npos && space > 0 && space + 1 < argument.size() &&
               (isWordCharacter(argument[space - 1]) || argument[space - 1] == '>') &&
               (isWordCharacter(argument[space + 1]) || std::string("&*").find(argument[space + 1]) < 2);
    }
    /// Whether the function that is called here gives the same for either order, to the last bit.
    bool isCommutative(std::size_t open) const {
        std::size_t begin = open;
        while (begin > 0 && isWordCharacter(code[begin - 1])) --begin;
        const std::string name = code.substr(begin, open - begin);
        for (const char *each :
             {"min", "max", "sum", "product", "add", "multiply", "multiply_high", "cosineBetween"})
            if (name == each) return true;
        return false;
    }
    std::vector<std::size_t> commasBetween(std::size_t open, std::size_t close) const {
        std::vector<std::size_t> commas;
        int depth = 0;
        for (std::size_t n = open; n < close; ++n) {
            if (std::string("([{").find(code[n]) != std::string::npos) ++depth;
            if (std::string(")]}").find(code[n]) != std::string::npos) --depth;
            if (code[n] == ',' && depth == 1) commas.push_back(n);
        }
        return commas;
    }

    std::size_t line = 0;
    std::string code;
    std::vector<Change> changes;
};

std::string trimmed(const std::string &line) {
    const std::size_t begin = line.find_first_not_of(' ');
    return begin == std::string::npos ? "" : line.substr(begin);
}

}  // namespace

int main(int argc, char **argv) {
    std::ifstream file(argc > 1 ? argv[1] : "");
    if (!file) {
        std::cerr << "mutate FILE [NUMBER]\n";
        return 1;
    }
    Lines lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    const Finder finder(lines);
    if (argc < 3) {
        std::cout << finder.get().size() << '\n';
        return 0;
    }
    const Change &change = finder.get().at(std::strtoul(argv[2], nullptr, 10));
    std::string &line = lines[change.line];
    std::cerr << trimmed(line) << " ==> ";
    line.replace(change.begin, change.length, change.replacement);
    std::cerr << trimmed(line) << '\n';
    for (const std::string &each : lines) std::cout << each << '\n';
}
