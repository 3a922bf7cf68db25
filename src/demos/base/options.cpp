#include "base/options.h"

#include "base/text.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace demo {

namespace {

std::string quoted(const std::string &text) { return "'" + text + "'"; }

real readWithin(const std::string &text, real low, real high) {
    const std::optional<real> value = readNumber(text);
    if (!value) throw std::invalid_argument(quoted(text) + " is not a number");
    if (!(*value >= low && *value <= high))
        throw std::invalid_argument(quoted(text) + " is not between " + shortest(low) + " and " +
                                    shortest(high));
    return *value;
}

unsigned long long readInteger(const std::string &text, unsigned long long high) {
    if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos)
        throw std::invalid_argument(quoted(text) + " is not a whole number");
    errno = 0;
    const unsigned long long value = std::strtoull(text.c_str(), nullptr, 10);
    if (errno == ERANGE || value > high)
        throw std::invalid_argument(quoted(text) + " is greater than " + std::to_string(high));
    return value;
}

std::string joined(const std::vector<std::string> &words, const std::string &between) {
    std::string text;
    for (const std::string &word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

}  // namespace

Options::Options(std::string program, std::string summary, std::string version)
    : program_(std::move(program)), summary_(std::move(summary)), version_(std::move(version)) {}

void Options::addNumber(const std::string &name, const std::string &placeholder, const std::string &help,
                        real &value, real low, real high) {
    add({name, placeholder, help + " (" + shortest(value) + ")",
         [&value, low, high](const std::string &text) {
             return [&value, number = readWithin(text, low, high)] { value = number; };
         }});
}

void Options::addNumber(const std::string &name, const std::string &placeholder, const std::string &help,
                        std::optional<real> &value, real low, real high) {
    add({name, placeholder, help, [&value, low, high](const std::string &text) {
             return [&value, number = readWithin(text, low, high)] { value = number; };
         }});
}

void Options::addInteger(const std::string &name, const std::string &placeholder, const std::string &help,
                         unsigned long long &value, unsigned long long high) {
    add({name, placeholder, help + " (" + std::to_string(value) + ")",
         [&value, high](const std::string &text) {
             return [&value, number = readInteger(text, high)] { value = number; };
         }});
}

void Options::addText(const std::string &name, const std::string &placeholder, const std::string &help,
                      std::string &value) {
    add({name, placeholder, help, [&value](const std::string &text) {
             if (text.empty()) throw std::invalid_argument("the value is empty");
             return [&value, text] { value = text; };
         }});
}

void Options::addChoice(const std::string &name, const std::vector<std::string> &words,
                        const std::string &help, std::string &value) {
    add({name, joined(words, "|"), help + " (" + value + ")", [&value, words](const std::string &text) {
             if (std::find(words.begin(), words.end(), text) == words.end())
                 throw std::invalid_argument(quoted(text) + " is none of " + joined(words, ", "));
             return [&value, text] { value = text; };
         }});
}

void Options::add(Option option) {
    if (find(option.name)) throw std::logic_error("Options: --" + option.name + " is declared twice");
    options_.push_back(std::move(option));
}

Options::Option *Options::find(const std::string &name) {
    for (Option &option : options_)
        if (option.name == name) return &option;
    return nullptr;
}

bool Options::wasGiven(const std::string &name) const {
    for (const Option &option : options_)
        if (option.name == name) return option.given;
    throw std::logic_error("Options: --" + name + " is not declared");
}

std::vector<std::string> Options::getGiven() const {
    std::vector<std::string> names;
    for (const Option &option : options_)
        if (option.given) names.push_back(option.name);
    return names;
}

std::optional<int> Options::parse(int argc, const char *const argv[], std::ostream &out, std::ostream &err) {
    const std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    for (const std::string &argument : arguments) {
        if (argument == "--help" || argument == "-h") {
            out << usage();
            return 0;
        }
        if (argument == "--version") {
            out << program_ << ' ' << version_ << '\n';
            return 0;
        }
    }
    try {
        parseAll(arguments);
    } catch (const std::invalid_argument &mistake) {
        err << program_ << ": " << mistake.what() << '\n';
        return 2;
    }
    return std::nullopt;
}

void Options::parseAll(const std::vector<std::string> &arguments) {
    std::vector<std::function<void()>> assignments;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string &argument = arguments[i];
        if (argument.rfind("--", 0) != 0)
            throw std::invalid_argument("unexpected argument " + quoted(argument) +
                                        "; --help lists the options");
        const std::size_t equals = argument.find('=');
        const std::string name = argument.substr(2, equals == std::string::npos ? equals : equals - 2);
        Option *option = find(name);
        if (!option)
            throw std::invalid_argument("unknown option " + quoted("--" + name) +
                                        "; --help lists the options");
        if (option->given) throw std::invalid_argument("--" + name + " is given twice");

        std::string text;
        if (equals != std::string::npos) {
            text = argument.substr(equals + 1);
        } else {
            if (i + 1 == arguments.size() || arguments[i + 1].rfind("--", 0) == 0)
                throw std::invalid_argument("--" + name + " needs a value, " + option->placeholder);
            text = arguments[++i];
        }
        try {
            assignments.push_back(option->read(text));
        } catch (const std::invalid_argument &reason) {
            throw std::invalid_argument("--" + name + ": " + reason.what());
        }
        option->given = true;
    }
    for (const auto &assign : assignments) assign();
}

std::string Options::usage() const {
    std::vector<std::pair<std::string, std::string>> lines;
    for (const Option &option : options_)
        lines.emplace_back("--" + option.name + " " + option.placeholder, option.help);
    lines.emplace_back("--help", "Show this and exit");
    lines.emplace_back("--version", "Show the version and exit");

    std::size_t width = 0;
    for (const auto &line : lines) width = std::max(width, line.first.size());
    std::string text = "Usage: " + program_ + " [options]\n" + summary_ + "\n\n";
    for (const auto &line : lines)
        text += "  " + line.first + std::string(width + 2 - line.first.size(), ' ') + line.second + "\n";
    return text;
}

}  // namespace demo
