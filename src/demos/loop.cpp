#include "loop.h"

#include "files.h"
#include "options.h"
#include "run.h"
#include "terminal.h"

#include <iostream>
#include <stdexcept>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace demo {

namespace {

const char *const VERSION = "0.1.0";

bool isErrorATerminal() {
#ifdef _WIN32
    return _isatty(2) != 0;
#else
    return isatty(2) != 0;
#endif
}

/// What the command line says.
struct Wishes {
    unsigned long long seed = 1;
    std::vector<real> settings;
    real seconds = 60;
    std::string input, record, csv, html, still, camera = "side";
    real stillTime = 5, zoom = 1;
    std::vector<std::string> products;
};

void declare(Options &options, Wishes &wishes, const Profile &profile, const std::vector<Product> &products) {
    options.addNumber("seconds", "N", "Run this long without a terminal", wishes.seconds, 0, 1e6);
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

int run(Demonstration &demonstration, const Options &options, Wishes wishes) {
    const Profile &profile = demonstration.getProfile();
    std::optional<Script> script = readInput(wishes, profile);
    if (script) adopt(*script, profile, options, wishes);
    std::optional<OutputFile> csv = open(wishes.csv), html = open(wishes.html), record = open(wishes.record),
                              picture = open(wishes.still);

    real seconds = options.wasGiven("seconds") ? wishes.seconds : -1;
    if (script && seconds < 0 && script->end) seconds = static_cast<real>(*script->end) * profile.step;
    Session session(demonstration, wishes.seed, wishes.settings, std::move(script));
    if (csv) session.writeCsvTo(csv->stream());
    if (html) session.keepFrames();
    const Still still = makeStill(wishes, picture);

    int status = 0;
    if (!options.wasGiven("seconds") && Terminal::isInteractive()) {
        status = runInteractive(session, demonstration, still);
        std::cout << session.getReport() << '\n';
    } else {
        runHeadless(session, demonstration, seconds, still, std::cout,
                    isErrorATerminal() ? &std::cerr : nullptr);
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
    Options options(profile.program, profile.summary, VERSION);
    Wishes wishes;
    declare(options, wishes, profile, products);
    if (const std::optional<int> status = options.parse(argc, argv, std::cout, std::cerr)) return *status;
    try {
        return makeProducts(wishes, products) ? 0 : run(demonstration, options, wishes);
    } catch (const std::runtime_error &error) {
        std::cerr << profile.program << ": " << error.what() << '\n';
        return 2;
    }
}

}  // namespace demo
