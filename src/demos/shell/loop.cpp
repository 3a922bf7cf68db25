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

namespace demo {

namespace {

constexpr real LONGEST_PAGE = 3600;  // s; some 20 MB
const std::string STANDARD = "-";    // the standard output, as a file's name

std::string getVersion() {
    return std::to_string(CYCLONE_VERSION_MAJOR) + "." + std::to_string(CYCLONE_VERSION_MINOR) + "." +
           std::to_string(CYCLONE_VERSION_PATCH);
}

/// What the command line says.
struct RunOptions {
    unsigned long long seed = 1;
    std::vector<real> settings;
    std::optional<real> seconds;
    std::string input, record, csv, html, still, archive, camera;
    real stillTime = 5, zoom = 1;
    std::vector<std::string> products;
};

void declare(Options &options, RunOptions &given, const Demonstration &demonstration,
             const std::vector<Product> &products) {
    const Profile &profile = demonstration.getProfile();
    const std::string longest = std::to_string(std::lround(profile.duration));
    options.addNumber("seconds", "N",
                      "Run this long, without a terminal (once round, at most " + longest + ")",
                      given.seconds, 0, 1e6);
    options.addInteger("seed", "N", "Seed of all that is random", given.seed);
    for (const Setting &setting : profile.settings) given.settings.push_back(setting.value);
    for (std::size_t n = 0; n < profile.settings.size(); ++n) {
        const Setting &setting = profile.settings[n];
        options.addNumber(setting.name, setting.placeholder, setting.help, given.settings[n], setting.low,
                          setting.high);
    }
    options.addText("input", "FILE", "Play a script of control inputs", given.input);
    options.addText("record", "FILE", "Save the control inputs as a script", given.record);
    options.addText("csv", "FILE", "Write every step's numbers; - is the standard output", given.csv);
    options.addText("html", "FILE", "Write a page that replays the run in a browser", given.html);
    options.addText("still", "FILE", "Write a picture of the run, PNG", given.still);
    options.addNumber("at", "SECONDS", "When to take the picture", given.stillTime, 0, 1e6);
    std::vector<std::string> cameras;
    for (const Viewpoint viewpoint : demonstration.getScene().cameras.viewpoints)
        cameras.push_back(Stage::getName(viewpoint));
    const std::string side = Stage::getName(Viewpoint::SIDE);
    given.camera = std::count(cameras.begin(), cameras.end(), side) > 0 ? side : cameras.front();
    options.addChoice("camera", cameras, "From where to take it", given.camera);
    options.addNumber("zoom", "FACTOR", "How close to take it", given.zoom, 0.1, 10);
    if (!profile.archive.name.empty())
        options.addText(profile.archive.name, "FILE", profile.archive.help, given.archive);
    given.products.resize(products.size());
    for (std::size_t n = 0; n < products.size(); ++n)
        options.addText(products[n].name, "FILE", products[n].help, given.products[n]);
}

std::optional<Script> readInput(const RunOptions &given, const Profile &profile) {
    if (given.input.empty()) return std::nullopt;
    const std::string text = readFile(given.input);
    try {
        return readScript(text, profile);
    } catch (const std::runtime_error &mistake) {
        throw std::runtime_error("'" + given.input + "', " + mistake.what());
    }
}

void readArchive(const std::string &path, const KeptFile &file, const Archive &archive) {
    try {
        archive.read(file.getText());
    } catch (const std::runtime_error &mistake) {
        throw std::runtime_error("'" + path + "', " + mistake.what());
    }
}

/// What the script says counts where the command line says nothing.
void adopt(const Script &script, const Profile &profile, const Options &options, RunOptions &given) {
    if (script.seed && !options.wasGiven("seed")) given.seed = *script.seed;
    for (std::size_t n = 0; n < profile.settings.size(); ++n)
        if (script.settings[n] && !options.wasGiven(profile.settings[n].name))
            given.settings[n] = *script.settings[n];
}

std::optional<OutputFile> open(const std::string &path) {
    if (path.empty()) return std::nullopt;
    return std::optional<OutputFile>(std::in_place, path);
}

void finish(std::optional<OutputFile> &file) {
    if (file) file->finish();
}

/// Writes what was asked for instead of a run; false if nothing was. What belongs to a run has no place
/// beside it.
bool makeProducts(const RunOptions &given, const Options &options, const std::vector<Product> &products) {
    std::size_t made = 0;
    for (std::size_t n = 0; n < products.size(); ++n) {
        if (given.products[n].empty()) continue;
        for (const std::string &other : options.getGiven())
            if (other != products[n].name)
                throw std::runtime_error("--" + other + " does not go with --" + products[n].name);
        OutputFile file(given.products[n]);
        products[n].write(file.stream());
        file.finish();
        ++made;
    }
    return made > 0;
}

Still makeStill(const RunOptions &given, const Scene &scene, std::optional<OutputFile> &file) {
    Still still;
    if (file) still.out = &file->stream();
    still.time = given.stillTime;
    for (const Viewpoint viewpoint : scene.cameras.viewpoints)
        if (Stage::getName(viewpoint) == given.camera) still.viewpoint = viewpoint;
    still.zoom = given.zoom;
    return still;
}

/// One file under two names would be written over, or read away.
void requireDifferent(const std::vector<std::string> &paths) {
    for (std::size_t n = 0; n < paths.size(); ++n)
        for (std::size_t m = 0; m < n; ++m)
            if (!paths[n].empty() && !paths[m].empty() && isSameFile(paths[n], paths[m]))
                throw std::runtime_error("'" + paths[m] + "' and '" + paths[n] + "' are one file");
}

int run(Demonstration &demonstration, const Options &options, RunOptions given) {
    const Profile &profile = demonstration.getProfile();
    std::optional<Script> script = readInput(given, profile);
    if (script) adopt(*script, profile, options, given);
    std::optional<real> seconds = given.seconds;
    if (!given.html.empty() && seconds > LONGEST_PAGE)
        throw std::runtime_error("--html: a page holds " + std::to_string(std::lround(LONGEST_PAGE)) +
                                 " s at most");
    requireDifferent({given.input, given.csv, given.html, given.record, given.still, given.archive});
    std::optional<KeptFile> archive;
    if (!given.archive.empty()) readArchive(given.archive, archive.emplace(given.archive), profile.archive);
    const bool pipesCsv = given.csv == STANDARD;
    std::optional<OutputFile> csv = open(pipesCsv ? "" : given.csv), html = open(given.html),
                              record = open(given.record), picture = open(given.still);

    if (script && script->end && !given.seconds) seconds = static_cast<real>(*script->end) * profile.step;
    Session session(demonstration, given.seed, given.settings, std::move(script));
    if (csv || pipesCsv) session.writeCsvTo(csv ? csv->stream() : std::cout);
    if (html) session.keepFrames();
    const Still still = makeStill(given, demonstration.getScene(), picture);

    int status = 0;
    if (!given.seconds && !pipesCsv && Terminal::isInteractive()) {
        status = runInteractive(session, demonstration, still);
        std::cout << session.getReport() << '\n';
    } else {
        const bool showsProgress = isTerminal(STANDARD_ERROR) && !isTerminal(STANDARD_OUTPUT) && !pipesCsv;
        runHeadless(session, demonstration, seconds, still, pipesCsv ? std::cerr : std::cout,
                    showsProgress ? &std::cerr : nullptr);
    }
    if (html) session.writePageTo(html->stream());
    if (record) record->stream() << writeScript(session.getInputs(), profile);
    for (std::optional<OutputFile> *file : {&csv, &html, &record, &picture}) finish(*file);
    if (archive)
        if (const std::optional<std::string> text = profile.archive.write()) archive->replace(*text);
    return status;
}

/// The word behind `--name` among the arguments, or the first of the choice. A wrong one is told later, with
/// all other mistakes.
std::string findChosen(const Choice &choice, int argc, const char *const argv[]) {
    const std::string option = "--" + choice.name;
    for (int n = 1; n < argc; ++n) {
        const std::string argument = argv[n];
        std::string word;
        if (argument == option && n + 1 < argc) word = argv[n + 1];
        if (argument.rfind(option + "=", 0) == 0) word = argument.substr(option.size() + 1);
        if (std::count(choice.words.begin(), choice.words.end(), word) > 0) return word;
    }
    return choice.words.front();
}

int parseAndRun(Demonstration &demonstration, const Choice *choice, std::string chosen, int argc,
                const char *const argv[], const std::vector<Product> &products) {
    const Profile &profile = demonstration.getProfile();
    Options options(profile.program, profile.summary, getVersion());
    if (choice) options.addChoice(choice->name, choice->words, choice->help, chosen);
    RunOptions given;
    declare(options, given, demonstration, products);
    try {
        std::optional<int> status = options.parse(argc, argv, std::cout, std::cerr);
        if (!status) status = makeProducts(given, options, products) ? 0 : run(demonstration, options, given);
        if (!std::cout.flush()) throw std::runtime_error("cannot write to the standard output");
        return *status;
    } catch (const std::runtime_error &error) {
        std::cerr << profile.program << ": " << error.what() << '\n';
        return 2;
    }
}

}  // namespace

int runDemonstration(Demonstration &demonstration, int argc, const char *const argv[],
                     const std::vector<Product> &products) {
    return parseAndRun(demonstration, nullptr, "", argc, argv, products);
}

int runDemonstration(const Choice &choice,
                     const std::function<std::unique_ptr<Demonstration>(const std::string &word)> &make,
                     int argc, const char *const argv[]) {
    const std::string chosen = findChosen(choice, argc, argv);
    return parseAndRun(*make(chosen), &choice, chosen, argc, argv, {});
}

}  // namespace demo
