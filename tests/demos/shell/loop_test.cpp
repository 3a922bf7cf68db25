#include "shell/loop.h"

#include <cyclone/version.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <ostream>

#include "base/files.h"
#include "flightsim/flight.h"
#include "flightsim/soaring.h"

using namespace demo;
using namespace flightsim;

namespace {

struct Outcome {
    int status;
    std::string out, err;
};

Outcome run(std::vector<const char *> arguments, const std::vector<Product> &products = {}) {
    Flight flight;
    arguments.insert(arguments.begin(), "flightsim");
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int status =
        runDemonstration(flight, static_cast<int>(arguments.size()), arguments.data(), products);
    return {status, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

/// A program of several demonstrations.
Outcome runChosen(std::vector<const char *> arguments) {
    arguments.insert(arguments.begin(), "flightsim");
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const auto make = [](const std::string &word) -> std::unique_ptr<Demonstration> {
        if (word == "glider") return std::make_unique<Soaring>();
        return std::make_unique<Flight>();
    };
    const int status = runDemonstration({"aircraft", "What to fly", {"model", "glider"}}, make,
                                        static_cast<int>(arguments.size()), arguments.data());
    return {status, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

std::string lastLine(std::string text) {
    text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

class DemoLoop : public testing::Test {
protected:
    /// A file of this run's own: tests run side by side.
    std::string path(const std::string &name) {
        static const auto stamp = std::chrono::steady_clock::now().time_since_epoch().count();
        const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
        files.push_back(testing::TempDir() + "cyclone_" + test + "_" + std::to_string(stamp) + "_" + name);
        return files.back();
    }
    void TearDown() override {
        for (const std::string &file : files) std::remove(file.c_str());
    }

private:
    std::vector<std::string> files;
};

}  // namespace

TEST_F(DemoLoop, PrintsATableALineASecondAndTheHash) {
    const Outcome outcome = run({"--seconds", "3"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("airspeed"), std::string::npos);
    for (const char *time : {"\n     0.0 ", "\n     1.0 ", "\n     2.0 ", "\n     3.0 "})
        EXPECT_NE(outcome.out.find(time), std::string::npos) << time;
    EXPECT_EQ(outcome.out.find("\n     4.0 "), std::string::npos);
    EXPECT_EQ(lastLine(outcome.out).rfind("State hash: ", 0), 0u);
}

TEST_F(DemoLoop, TheSeedDecides) {
    const std::string one = run({"--seconds", "3", "--seed", "1"}).out;
    EXPECT_EQ(run({"--seconds", "3", "--seed", "1"}).out, one);
    EXPECT_NE(lastLine(run({"--seconds", "3", "--seed", "2"}).out), lastLine(one));
}

TEST_F(DemoLoop, ARecordedRunPlaysBackWithItsSettings) {
    const std::string script = path("script.txt");
    const Outcome flown =
        run({"--seconds", "6", "--seed", "9", "--wind", "2.5", "--gusts=0.7", "--record", script.c_str()});
    const Outcome replayed = run({"--seconds", "6", "--input", script.c_str()});
    EXPECT_EQ(replayed.status, 0);
    EXPECT_EQ(lastLine(replayed.out), lastLine(flown.out));
}

TEST_F(DemoLoop, AWordChoosesTheDemonstration) {
    EXPECT_NE(runChosen({"--help"}).out.find("--aircraft model|glider"), std::string::npos);
    EXPECT_EQ(runChosen({"--seconds", "1"}).out, runChosen({"--seconds", "1", "--aircraft", "model"}).out);
    for (const std::vector<const char *> &spelling :
         {std::vector<const char *>{"--seconds", "1", "--aircraft", "glider"},
          {"--aircraft=glider", "--seconds=1"}})
        EXPECT_NE(runChosen(spelling).out.find("vario"), std::string::npos);
    const Outcome wrong = runChosen({"--aircraft", "balloon"});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_EQ(wrong.err, "flightsim: --aircraft: 'balloon' is none of model, glider\n");
    EXPECT_EQ(runChosen({"--lift", "3"}).status, 2) << "a setting of the other demonstration";
}

TEST_F(DemoLoop, AScriptPlaysInTheDemonstrationThatItIsOf) {
    const std::string script = path("script.txt");
    const Outcome flown = runChosen({"--aircraft", "glider", "--seconds", "5", "--record", script.c_str()});
    EXPECT_EQ(lastLine(runChosen({"--aircraft", "glider", "--input", script.c_str()}).out),
              lastLine(flown.out));
    const Outcome other = runChosen({"--input", script.c_str()});
    EXPECT_EQ(other.status, 2);
    EXPECT_NE(other.err.find("it needs --aircraft glider"), std::string::npos) << other.err;
}

TEST_F(DemoLoop, ALongerRunThanTheCircuitBeginsAgain) {
    const std::string out = run({"--seconds", "70", "--wind", "1"}).out;
    EXPECT_NE(out.find("* stopped"), out.rfind("* took off"));
    EXPECT_GT(out.rfind("* took off"), out.find("* stopped"));
}

TEST_F(DemoLoop, WritesEveryFile) {
    const std::string csv = path("a.csv"), html = path("a.html"), still = path("a.png");
    EXPECT_EQ(run({"--seconds", "1", "--csv", csv.c_str(), "--html", html.c_str(), "--still", still.c_str()})
                  .status,
              0);
    EXPECT_EQ(readFile(csv).rfind("time [s],", 0), 0u);
    EXPECT_NE(readFile(html).find("</html>"), std::string::npos);
    EXPECT_EQ(readFile(still).substr(1, 3), "PNG");
}

TEST_F(DemoLoop, AStillShowsTheMomentItWasAskedFor) {
    const auto stillAt = [&](const char *seconds) {
        const std::string still = path(std::string(seconds) + ".png");
        run({"--seconds", "2", "--still", still.c_str(), "--at", seconds});
        return readFile(still);
    };
    const std::string start = stillAt("0"), middle = stillAt("1"), end = stillAt("2");
    EXPECT_NE(start, middle);
    EXPECT_NE(middle, end);
    EXPECT_NE(start, end);
    EXPECT_EQ(stillAt("60"), end) << "later than the run is at its end";
}

TEST_F(DemoLoop, MistakesAreOneLineAndStatusTwo) {
    const std::string bad = path("bad.txt");
    std::ofstream(bad) << "0 throttle 1\n1 pitch 3\n";
    const std::string unwritable = testing::TempDir() + "no/such/directory/file";
    for (const std::vector<const char *> &arguments : {std::vector<const char *>{"--bogus"},
                                                       {"--wind", "fast"},
                                                       {"--input", unwritable.c_str()},
                                                       {"--input", bad.c_str()},
                                                       {"--seconds", "1", "--csv", unwritable.c_str()},
                                                       {"--seconds", "1", "--html", unwritable.c_str()},
                                                       {"--seconds", "1", "--record", unwritable.c_str()},
                                                       {"--seconds", "1", "--still", unwritable.c_str()}}) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments[0];
        EXPECT_EQ(outcome.out, "") << "it is said before the run: " << arguments[0];
        EXPECT_EQ(outcome.err.rfind("flightsim: ", 0), 0u);
        EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    }
    EXPECT_NE(run({"--input", bad.c_str()}).err.find("line 2"), std::string::npos);
}

TEST_F(DemoLoop, OneFileUnderTwoNamesIsRefusedBeforeAnythingIsWritten) {
    const std::string file = path("one"),
                      spelled = testing::TempDir() + "./" + file.substr(testing::TempDir().size());
    const std::string script = "0 throttle 1\n1 end\n";
    for (const char *option : {"--csv", "--html", "--record"}) {
        std::ofstream(file) << script;
        const Outcome outcome = run({"--input", file.c_str(), option, spelled.c_str()});
        EXPECT_EQ(outcome.status, 2) << option;
        EXPECT_NE(outcome.err.find("one file"), std::string::npos) << outcome.err;
        EXPECT_EQ(readFile(file), script) << option;
    }
    std::remove(file.c_str());
    EXPECT_EQ(run({"--seconds", "1", "--csv", file.c_str(), "--html", spelled.c_str()}).status, 2);
    EXPECT_FALSE(std::ifstream(file));
}

TEST_F(DemoLoop, TheCsvFileMayBeTheStandardOutput) {
    const std::string csv = path("a.csv");
    run({"--seconds", "1", "--csv", csv.c_str()});
    const Outcome piped = run({"--seconds", "1", "--csv", "-"});
    EXPECT_EQ(piped.status, 0);
    EXPECT_EQ(piped.out, readFile(csv));
    EXPECT_NE(piped.err.find("State hash: "), std::string::npos) << "the rest is told on the other stream";
}

TEST_F(DemoLoop, LeavesNoFilesBehindWhenOneCannotBeWritten) {
    const std::string csv = path("half.csv"), unwritable = testing::TempDir() + "no/such/directory/file";
    EXPECT_EQ(run({"--seconds", "1", "--csv", csv.c_str(), "--still", unwritable.c_str()}).status, 2);
    EXPECT_FALSE(std::ifstream(csv));
}

TEST_F(DemoLoop, RefusesAPageTooLongToLoad) {
    const std::string html = path("long.html");
    const Outcome outcome = run({"--seconds", "3601", "--html", html.c_str()});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find("3600 s"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::ifstream(html));
}

TEST_F(DemoLoop, HelpAndVersionSayWhatIsTrue) {
    const std::string help = run({"--help"}).out;
    EXPECT_NE(help.find("at most 120"), std::string::npos) << help;
    EXPECT_EQ(run({"--version"}).out, "flightsim " + std::to_string(CYCLONE_VERSION_MAJOR) + '.' +
                                          std::to_string(CYCLONE_VERSION_MINOR) + '.' +
                                          std::to_string(CYCLONE_VERSION_PATCH) + '\n');
}

TEST_F(DemoLoop, MakesAProductInsteadOfARun) {
    const std::string file = path("product");
    const Outcome outcome =
        run({"--polar", file.c_str()}, {{"polar", "Draw it", [](std::ostream &out) { out << "drawn"; }}});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(readFile(file), "drawn");
    const Outcome both = run({"--polar", file.c_str(), "--seed", "3"},
                             {{"polar", "Draw it", [](std::ostream &out) { out << "drawn"; }}});
    EXPECT_EQ(both.status, 2);
    EXPECT_NE(both.err.find("--seed does not go with --polar"), std::string::npos) << both.err;
}
