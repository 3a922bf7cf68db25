#pragma once

/// The command line: each demo declares its options, one line each, and gets their values checked.
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <cyclone/core.h>

namespace demo {

using cyclone::real;

/// Options of the form `--name VALUE` or `--name=VALUE`; `--help` (or `-h`) and `--version` come by
/// themselves. Declare the options, then call parse() once. The variables keep their values as defaults where
/// an option isn't given; they must outlive this object.
class Options {
public:
    /// `summary` is the sentence that --help begins with, `version` what --version says behind the program's
    /// name.
    Options(std::string program, std::string summary, std::string version);

    // Each declares one option. `help` is one line, without a full stop; numbers show their default in
    // --help. `placeholder` is the word that stands for the value there, like N or FILE.

    /// A finite number in [low, high].
    void addNumber(const std::string &name, const std::string &placeholder, const std::string &help,
                   real &value, real low, real high);
    /// The same, without a default.
    void addNumber(const std::string &name, const std::string &placeholder, const std::string &help,
                   std::optional<real> &value, real low, real high);
    /// A whole number from 0 to `high`.
    void addInteger(const std::string &name, const std::string &placeholder, const std::string &help,
                    unsigned long long &value, unsigned long long high = ~0ULL);
    /// Any text but the empty one: a file's name.
    void addText(const std::string &name, const std::string &placeholder, const std::string &help,
                 std::string &value);
    /// One of the given words.
    void addChoice(const std::string &name, const std::vector<std::string> &words, const std::string &help,
                   std::string &value);

    /// Nothing if the program should go on; otherwise the status to exit with: 0 after --help or --version,
    /// which go to `out`; 2 after a mistake, which is told in one line on `err`. No variable changes then.
    std::optional<int> parse(int argc, const char *const argv[], std::ostream &out, std::ostream &err);

    /// Whether the parsed command line had this option. Throws std::logic_error for a name that was not
    /// declared.
    bool wasGiven(const std::string &name) const;

    /// The names of those that the parsed command line had.
    std::vector<std::string> getGiven() const;

    /// The text of --help.
    std::string usage() const;

private:
    /// Makes the assignment that the text asks for; throws std::invalid_argument with the reason if it can't.
    using Reader = std::function<std::function<void()>(const std::string &text)>;
    struct Option {
        std::string name, placeholder, help;
        Reader read;
        bool given = false;
    };

    void add(Option option);
    Option *find(const std::string &name);
    void parseAll(const std::vector<std::string> &arguments);

    std::string program_, summary_, version_;
    std::vector<Option> options_;
};

}  // namespace demo
