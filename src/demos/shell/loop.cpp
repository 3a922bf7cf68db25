#include "shell/loop.h"

#include "base/files.h"
#include "base/options.h"
#include "shell/run.h"
#include "terminal/terminal.h"

#include <cyclone/version.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <stdexcept>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace demo {

namespace {

constexpr real LONGEST_PAGE = 3600;  // s; some 20 MB

std::string getVersion() {
    return std::to_string(CYCLONE_VERSION_MAJOR) + "." + std::to_string(CYCLONE_VERSION_MINOR) + "." +
           std::to_string(CYCLONE_VERSION_PATCH);
}

/// 1: stdout, 2: stderr.
bool isTerminal(int stream) {
#ifdef _WIN32
    return _isatty(stream) != 0;
#else
    return isatty(stream) != 0;
#endif
}

/// What the command line says.
struct Wishes {
    unsigned long long seed = 1;
    std::vector<real> settings;
    std::optional<real> seconds;
    std::string input, record, csv, html, still, camera = "side";
    real stillTime = 5, zoom = 1;
    std::vector<std::string> products;
};

void declare(Options &options, Wishes &wishes, const Profile &profile, const std::vector<Product> &products) {
    const std::string longest = std::to_string(std::lround(profile.duration));
    options.addNumber("seconds", "N",
                      "Run this long, without a terminal (once round, at most " + longest + ")",
                      wishes.seconds, 0, 1e6);
    options.addInteger("seed", "N", "Seed of all that is random", wishes.seed);
    for (const Setting &setting : profile.settings) wishes.settings.push_back(setting.value);
    for (std::size_t n = 0; n < profile.settings.size(); ++n) {
        const Setting &setting = profile.settings[n];
        options.addNumber(setting.name, setting.placeholder, setting.help, wishes.settings[n], setting.low,
                          setting.high);
    }
    options.addText("input", "FILE", "Play a script of control inputs", wishes.input);
    options.addText("record", "FILE", "Save the control inputs as a script", wishes.record);
    options.addText("csv", "FILE", "Write every step's numbers", wishes.csv);
    options.addText("html", "FILE", "Write a page that replays the run in a browser", wishes.html);
    options.addText("still", "FILE", "Write a picture of the run, PNG", wishes.still);
    options.addNumber("at", "SECONDS", "When to take the picture", wishes.stillTime, 0, 1e6);
    options.addChoice("camera", {"side", "chase", "spectator"}, "From where to take it", wishes.camera);
    options.addNumber("zoom", "FACTOR", "How close to take it", wishes.zoom, 0.1, 10);
    wishes.products.resize(products.size());
    for (std::size_t n = 0; n < products.size(); ++n)
        options.addText(products[n].name, "FILE", products[n].help, wishes.products[n]);
}

std::optional<Script> readInput(const Wishes &wishes, const Profile &profile) {
    if (wishes.input.empty()) return std::nullopt;
    const std::string text = readFile(wishes.input);
    try {
        return readScript(text, profile);
    } catch (const std::runtime_error &mistake) {
        throw std::runtime_error("'" + wishes.input + "', " + mistake.what());
    }
}

/// What the script says counts where the command line says nothing.
void adopt(const Script &script, const Profile &profile, const Options &options, Wishes &wishes) {
    if (script.seed && !options.wasGiven("seed")) wishes.seed = *script.seed;
    for (std::size_t n = 0; n < profile.settings.size(); ++n)
        if (script.settings[n] && !options.wasGiven(profile.settings[n].name))
            wishes.settings[n] = *script.settings[n];
}

std::optional<OutputFile> open(const std::string &path) {
    if (path.empty()) return std::nullopt;
    return std::optional<OutputFile>(std::in_place, path);
}

void finish(std::optional<OutputFile> &file) {
    if (file) file->finish();
}

/// Writes what was asked for instead of a run; false if nothing was.
bool makeProducts(const Wishes &wishes, const std::vector<Product> &products) {
    bool any = false;
    for (std::size_t n = 0; n < products.size(); ++n) {
        if (wishes.products[n].empty()) continue;
        OutputFile file(wishes.products[n]);
        products[n].write(file.stream());
        file.finish();
        any = true;
    }
    return any;
}

Still makeStill(const Wishes &wishes, std::optional<OutputFile> &file) {
    Still still;
    if (file) still.out = &file->stream();
    still.time = wishes.stillTime;
    still.viewpoint = wishes.camera == "chase"       ? Viewpoint::CHASE
                      : wishes.camera == "spectator" ? Viewpoint::SPECTATOR
                                                     : Viewpoint::SIDE;
    still.zoom = wishes.zoom;
    return still;
}

/// Two files under one name would be written over each other.
void requireDifferent(std::vector<std::string> paths) {
    std::sort(paths.begin(), paths.end());
    for (std::size_t n = 1; n < paths.size(); ++n)
        if (!paths[n].empty() && paths[n] == paths[n - 1])
            throw std::runtime_error("'" + paths[n] + "' is to be written twice");
}

int run(Demonstration &demonstration, const Options &options, Wishes wishes) {
    const Profile &profile = demonstration.getProfile();
    std::optional<Script> script = readInput(wishes, profile);
    if (script) adopt(*script, profile, options, wishes);
    std::optional<real> seconds = wishes.seconds;
    if (!wishes.html.empty() && seconds > LONGEST_PAGE)
        throw std::runtime_error("--html: a page holds " + std::to_string(std::lround(LONGEST_PAGE)) +
                                 " s at most");
    requireDifferent({wishes.csv, wishes.html, wishes.record, wishes.still});
    std::optional<OutputFile> csv = open(wishes.csv), html = open(wishes.html), record = open(wishes.record),
                              picture = open(wishes.still);

    if (script && script->end && !wishes.seconds) seconds = static_cast<real>(*script->end) * profile.step;
    Session session(demonstration, wishes.seed, wishes.settings, std::move(script));
    if (csv) session.writeCsvTo(csv->stream());
    if (html) session.keepFrames();
    const Still still = makeStill(wishes, picture);

    int status = 0;
    if (!wishes.seconds && Terminal::isInteractive()) {
        status = runInteractive(session, demonstration, still);
        std::cout << session.getReport() << '\n';
    } else {
        runHeadless(session, demonstration, seconds, still, std::cout,
                    isTerminal(2) && !isTerminal(1) ? &std::cerr : nullptr);
    }
    if (html) session.writePageTo(html->stream());
    if (record) record->stream() << writeScript(session.getInputs(), profile);
    for (std::optional<OutputFile> *file : {&csv, &html, &record, &picture}) finish(*file);
    return status;
}

}  // namespace

int runDemonstration(Demonstration &demonstration, int argc, const char *const argv[],
                     const std::vector<Product> &products) {
    const Profile &profile = demonstration.getProfile();
    Options options(profile.program, profile.summary, getVersion());
    Wishes wishes;
    declare(options, wishes, profile, products);
    try {
        std::optional<int> status = options.parse(argc, argv, std::cout, std::cerr);
        if (!status) status = makeProducts(wishes, products) ? 0 : run(demonstration, options, wishes);
        if (!std::cout.flush()) throw std::runtime_error("cannot write to the standard output");
        return *status;
    } catch (const std::runtime_error &error) {
        std::cerr << profile.program << ": " << error.what() << '\n';
        return 2;
    }
}

}  // namespace demo
