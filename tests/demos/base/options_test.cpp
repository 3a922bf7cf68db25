#include "base/options.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <sstream>
#include <stdexcept>

#include "base/files.h"

using namespace demo;

namespace {

/// A program with one option of each kind.
class DemoOptions : public testing::Test {
protected:
    std::optional<real> still;
    real seconds = 60;
    unsigned long long seed = 1;
    std::string csv, sea = "calm";
    Options options{"boat", "Sails.", "1.2.3"};
    std::ostringstream out, err;

    DemoOptions() {
        options.addNumber("still", "T", "One picture, at T (none)", still, 0, 100);
        options.addNumber("seconds", "N", "Run for N seconds", seconds, -5, 3600);
        options.addInteger("seed", "N", "Start of the random numbers", seed, 1000);
        options.addText("csv", "FILE", "Write a table", csv);
        options.addChoice("sea", {"calm", "wavy"}, "The sea", sea);
    }

    std::optional<int> parse(const std::vector<const char *> &arguments) {
        std::vector<const char *> argv{"boat"};
        argv.insert(argv.end(), arguments.begin(), arguments.end());
        return options.parse(static_cast<int>(argv.size()), argv.data(), out, err);
    }

    /// A mistake: status 2, one line that names the program and has `word` in it, and nothing changed.
    void expectMistake(const std::vector<const char *> &arguments, const std::string &word) {
        EXPECT_EQ(parse(arguments), 2);
        const std::string text = err.str();
        EXPECT_EQ(text.rfind("boat: ", 0), 0u) << text;
        EXPECT_NE(text.find(word), std::string::npos) << text;
        EXPECT_EQ(text.find('\n'), text.size() - 1) << text;
        EXPECT_EQ(out.str(), "");
        EXPECT_EQ(still, std::nullopt);
        EXPECT_EQ(seconds, 60);
        EXPECT_EQ(seed, 1u);
        EXPECT_EQ(csv, "");
        EXPECT_EQ(sea, "calm");
    }
};

TEST_F(DemoOptions, NothingGivenLeavesTheDefaults) {
    EXPECT_EQ(parse({}), std::nullopt);
    EXPECT_EQ(seconds, 60);
    EXPECT_FALSE(options.wasGiven("seconds"));
    EXPECT_EQ(out.str() + err.str(), "");
}

TEST_F(DemoOptions, TakesValuesInBothForms) {
    EXPECT_EQ(parse({"--seconds", "2.5", "--seed=7", "--csv", "a=b.csv", "--sea=wavy", "--still", "7"}),
              std::nullopt);
    EXPECT_EQ(seconds, 2.5);
    EXPECT_EQ(seed, 7u);
    EXPECT_EQ(csv, "a=b.csv");
    EXPECT_EQ(sea, "wavy");
    EXPECT_EQ(still, 7.0);
    EXPECT_TRUE(options.wasGiven("seed"));
    EXPECT_THROW(options.wasGiven("sead"), std::logic_error);
}

TEST_F(DemoOptions, TakesNegativeAndScientificNumbers) {
    EXPECT_EQ(parse({"--seconds", "-2e-1"}), std::nullopt);
    EXPECT_EQ(seconds, -0.2);
}

TEST_F(DemoOptions, WorksWithoutAnyArgumentVector) {
    EXPECT_EQ(options.parse(0, nullptr, out, err), std::nullopt);
}

TEST_F(DemoOptions, HelpTellsEveryOptionOnce) {
    EXPECT_EQ(parse({"--seconds", "nonsense", "--help"}), 0);
    const std::string text = out.str();
    for (const char *line : {"Usage: boat [options]", "Sails.", "--still T ", "One picture, at T (none)\n",
                             "--seconds N ", "Run for N seconds (60)", "--csv FILE ", "--sea calm|wavy ",
                             "The sea (calm)", "--help ", "--version "}) {
        const std::size_t first = text.find(line);
        EXPECT_NE(first, std::string::npos) << line;
        EXPECT_EQ(text.find(line, first + 1), std::string::npos) << line;
    }
    EXPECT_EQ(err.str(), "");
}

TEST_F(DemoOptions, VersionNamesTheProgram) {
    EXPECT_EQ(parse({"--version"}), 0);
    EXPECT_EQ(out.str(), "boat 1.2.3\n");
}

TEST_F(DemoOptions, UnknownOption) { expectMistake({"--sedd", "3"}, "'--sedd'"); }
TEST_F(DemoOptions, UnexpectedArgument) { expectMistake({"fast"}, "'fast'"); }
TEST_F(DemoOptions, ShortOption) { expectMistake({"-s"}, "'-s'"); }
TEST_F(DemoOptions, MissingValueAtTheEnd) { expectMistake({"--csv"}, "--csv needs a value, FILE"); }
TEST_F(DemoOptions, MissingValueBeforeAnother) { expectMistake({"--csv", "--still"}, "--csv needs a value"); }
TEST_F(DemoOptions, EmptyText) { expectMistake({"--csv="}, "empty"); }
TEST_F(DemoOptions, OptionalNumberTooLarge) { expectMistake({"--still", "101"}, "not between 0 and 100"); }
TEST_F(DemoOptions, GivenTwice) { expectMistake({"--seed", "2", "--seed", "3"}, "--seed is given twice"); }
TEST_F(DemoOptions, NotAChoice) { expectMistake({"--sea", "rough"}, "'rough' is none of calm, wavy"); }
TEST_F(DemoOptions, NumberTooLarge) { expectMistake({"--seconds", "3600.1"}, "not between -5 and 3600"); }
TEST_F(DemoOptions, NumberTooSmall) { expectMistake({"--seconds", "-5.1"}, "not between"); }
TEST_F(DemoOptions, IntegerTooLarge) { expectMistake({"--seed", "1001"}, "greater than 1000"); }
TEST_F(DemoOptions, IntegerBeyondItsType) {
    expectMistake({"--seed", "99999999999999999999"}, "greater than 1000");
}
TEST_F(DemoOptions, AMistakeLateChangesNothingEarlier) {
    expectMistake({"--seed", "5", "--seconds", "x"}, "'x'");
}

TEST_F(DemoOptions, MalformedNumbers) {
    for (const char *text : {"", "x", "1x", " 1", "1 ", "1,5", "nan", "inf", "0x10", "1e", "--5", "1e999"}) {
        err.str("");
        expectMistake({("--seconds=" + std::string(text)).c_str()}, "--seconds: ");
    }
}

TEST_F(DemoOptions, MalformedIntegers) {
    for (const char *text : {"", "x", "1.0", "-1", "+1", " 1", "1e3"}) {
        err.str("");
        expectMistake({("--seed=" + std::string(text)).c_str()}, "--seed: ");
    }
}

TEST_F(DemoOptions, DeclaringTwiceIsAProgrammersMistake) {
    EXPECT_THROW(options.addNumber("still", "T", "Again", still, 0, 1), std::logic_error);
}

std::string messageOf(const std::function<void()> &action) {
    try {
        action();
    } catch (const std::runtime_error &error) {
        return error.what();
    }
    return "";
}

TEST(DemoFiles, WhatIsWrittenCanBeRead) {
    const auto path = std::filesystem::temp_directory_path() / "cyclone_demo_options_test.bin";
    const std::string bytes("a\r\n\0\xff", 5);
    OutputFile file(path.string());
    file.stream() << bytes;
    file.finish();
    EXPECT_EQ(readFile(path.string()), bytes);
    OutputFile emptied(path.string());
    emptied.finish();
    EXPECT_EQ(readFile(path.string()), "");
    std::filesystem::remove(path);
}

TEST(DemoFiles, AFileThatCannotBeOpenedIsSaidAtOnce) {
    const std::string path = "/no such directory/file.csv";
    EXPECT_EQ(messageOf([&] { OutputFile file(path); }).rfind("cannot write '" + path + "': ", 0), 0u);
    EXPECT_EQ(messageOf([&] { readFile(path); }).rfind("cannot read '" + path + "': ", 0), 0u);
}

TEST(DemoFiles, ADirectoryIsNotAFile) {
    const std::string path = std::filesystem::temp_directory_path().string();
    EXPECT_NE(messageOf([&] { OutputFile file(path); }), "");
    EXPECT_NE(messageOf([&] { readFile(path); }), "");
}

TEST(DemoFiles, WhatIsNotFinishedIsRemoved) {
    const std::string path = testing::TempDir() + "cyclone_unfinished_" +
                             std::to_string(std::chrono::steady_clock::now().time_since_epoch().count());
    {
        OutputFile file(path);
        file.stream() << "half";
    }
    EXPECT_THROW(readFile(path), std::runtime_error);
}

TEST(DemoFiles, AFullDiskShowsWhenTheFileIsFinished) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
    OutputFile file("/dev/full");
    file.stream() << "something";
    const std::string message = messageOf([&] { file.finish(); });
    EXPECT_EQ(message.rfind("cannot write '/dev/full': ", 0), 0u) << message;
    OutputFile large("/dev/full");  // more than a stream keeps back: it fails before the end
    large.stream() << std::string(1 << 20, 'x') << std::string(1 << 20, 'y');
    EXPECT_EQ(messageOf([&] { large.finish(); }), message);
}

}  // namespace
