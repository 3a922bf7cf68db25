#include "shell/script.h"

#include "base/text.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace demo {

namespace {

[[noreturn]] void fail(const std::string &why) { throw std::runtime_error(why); }

template <class Named>
std::size_t find(const std::vector<Named> &items, const std::string &name) {
    const auto at =
        std::find_if(items.begin(), items.end(), [&](const Named &item) { return item.name == name; });
    return static_cast<std::size_t>(at - items.begin());
}

real readWithin(const std::string &word, real low, real high) {
    const std::optional<real> value = readNumber(word);
    if (!value) fail("'" + word + "' is not a number");
    if (*value < low || *value > high)
        fail("'" + word + "' is not between " + shortest(low) + " and " + shortest(high));
    return *value;
}

void readSetting(Script &script, const Profile &profile, const std::vector<std::string> &words) {
    if (words.size() != 2) fail("expected a name and a value");
    const std::string choice = profile.variant.substr(0, profile.variant.find(' '));
    if (!choice.empty() && words[0] == choice) {
        if (words[0] + " " + words[1] != profile.variant) fail("it needs --" + words[0] + " " + words[1]);
        return;
    }
    if (words[0] == "seed") {
        if (words[1].find_first_not_of("0123456789") != std::string::npos)
            fail("'" + words[1] + "' is not a whole number");
        errno = 0;
        script.seed = std::strtoull(words[1].c_str(), nullptr, 10);
        if (errno == ERANGE) fail("'" + words[1] + "' is too large");
        return;
    }
    const std::size_t index = find(profile.settings, words[0]);
    if (index == profile.settings.size()) fail("'" + words[0] + "' is neither a setting nor a time");
    const Setting &setting = profile.settings[index];
    script.settings[index] = readWithin(words[1], setting.low, setting.high);
}

void readMoment(Script &script, const Profile &profile, const std::vector<std::string> &words) {
    const real time = readWithin(words[0], 0, 1e6);
    const auto step = static_cast<std::uint64_t>(std::llround(time / profile.step));
    if (words.size() == 2 && words[1] == "end") {
        script.end = step;
    } else if (words.size() == 2 && words[1] == "restart") {
        script.changes.push_back({step, Script::RESTART, 0});
    } else {
        if (words.size() != 3) fail("expected a time, a control and a value");
        const std::size_t index = find(profile.controls, words[1]);
        if (index == profile.controls.size()) fail("there is no control '" + words[1] + "'");
        const Control &control = profile.controls[index];
        script.changes.push_back({step, index, readWithin(words[2], control.low, control.high)});
    }
}

void readLine(Script &script, const Profile &profile, const std::string &line) {
    std::istringstream in(line.substr(0, line.find('#')));
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    if (words.empty()) return;
    if (words[0].find_first_of("0123456789") == 0)
        readMoment(script, profile, words);
    else
        readSetting(script, profile, words);
}

}  // namespace

Script readScript(const std::string &text, const Profile &profile) {
    Script script;
    script.settings.resize(profile.settings.size());
    std::istringstream in(text);
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        try {
            readLine(script, profile, line);
        } catch (const std::runtime_error &mistake) {
            fail("line " + std::to_string(number) + ": " + mistake.what());
        }
    }
    std::stable_sort(script.changes.begin(), script.changes.end(),
                     [](const Script::Change &a, const Script::Change &b) { return a.step < b.step; });
    return script;
}

std::string writeScript(const Script &script, const Profile &profile) {
    const auto time = [&](std::uint64_t step) { return fixed(static_cast<real>(step) * profile.step, 5); };
    std::string text = "# Inputs of " + profile.program + "; play them with --input.\n";
    if (!profile.variant.empty()) text += profile.variant + "\n";
    if (script.seed) text += "seed " + std::to_string(*script.seed) + "\n";
    for (std::size_t n = 0; n < script.settings.size(); ++n)
        if (script.settings[n]) text += profile.settings[n].name + " " + shortest(*script.settings[n]) + "\n";
    for (const Script::Change &change : script.changes)
        text += time(change.step) +
                (change.control == Script::RESTART
                     ? " restart\n"
                     : " " + profile.controls.at(change.control).name + " " + shortest(change.value) + "\n");
    if (script.end) text += time(*script.end) + " end\n";
    return text;
}

}  // namespace demo
