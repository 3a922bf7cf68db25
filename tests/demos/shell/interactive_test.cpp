#ifndef _WIN32

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>

#include "base/files.h"
#include "flightsim/flight.h"
#include "pty.h"
#include "sailboat/sailing.h"
#include "shell/loop.h"

using namespace demo;
using sailboat::Sailing;
using namespace flightsim;

namespace {

const std::string scriptPath =
    testing::TempDir() + "cyclone_interactive_" + std::to_string(getpid()) + ".txt";

template <class Vehicle>
int run(const char *option) {
    Vehicle vehicle;
    const char *const arguments[] = {"demo", option, scriptPath.c_str()};
    return runDemonstration(vehicle, 3, arguments);
}

std::string hashIn(const std::string &text) {
    const std::string label = "State hash: ";
    const std::size_t at = text.find(label);
    return at == std::string::npos ? "" : text.substr(at + label.size(), 16);
}

/// Until the demo has drawn what the keys typed so far have done: the frame under way now may not know of
/// them yet.
void awaitFrame(Pty &terminal) {
    terminal.skip();
    for (int n = 0; n < 3; ++n) ASSERT_TRUE(terminal.waitFor("\x1b[?2026h"));
}

/// Types the keys one after another, each in a frame of its own, and leaves. Then checks that the session was
/// recorded with these lines in this order (times left out), and that the recording plays back to the same
/// state.
template <class Vehicle>
void expectRecorded(const std::vector<std::string> &keys, const std::vector<std::string> &lines) {
    Pty terminal([] { return run<Vehicle>("--record"); });
    ASSERT_TRUE(terminal.waitFor(ENTER));
    awaitFrame(terminal);
    for (const std::string &key : keys) {
        terminal.type(key);
        awaitFrame(terminal);
    }
    terminal.type("\x1b");
    EXPECT_EQ(terminal.end(), 0);
    terminal.expectGivenBack();
    ASSERT_TRUE(terminal.waitFor("State hash: "));
    ASSERT_TRUE(terminal.waitFor("\n"));

    const std::string script = readFile(scriptPath);
    std::size_t at = 0;
    for (const std::string &line : lines) {
        at = script.find(' ' + line + '\n', at);
        ASSERT_NE(at, std::string::npos) << line << " in\n" << script;
        ++at;
    }
    testing::internal::CaptureStdout();
    EXPECT_EQ(run<Vehicle>("--input"), 0);
    EXPECT_EQ(hashIn(testing::internal::GetCapturedStdout()), hashIn(terminal.output()));
    std::remove(scriptPath.c_str());
}

}  // namespace

TEST(DemoInteractive, TheAircraftFliesByTheClassicKeys) {
    // First to the middle, from where the pilot has left them; his throttle is open.
    expectRecorded<Flight>(
        {"x", "s", "x", "w", "a", "d", "d", "q", "e", "e", "-", "-", "=", "+", "r"},
        {"pitch 0", "pitch 0.1", "pitch 0", "pitch -0.1", "roll -0.1", "roll 0", "roll 0.1", "rudder -0.1",
         "rudder 0", "rudder 0.1", "throttle 0.9", "throttle 0.8", "throttle 0.9", "throttle 1", "restart"});
}

TEST(DemoInteractive, TheBoatSailsByTheClassicKeys) {
    // First amidships; then the sheet all the way in, from where the pilot has left it.
    expectRecorded<Sailing>(
        {"w", "a", "d", "d", "q", "q", "q", "q", "q", "q", "q", "q", "q", "e", "z", "x", "x", "w"},
        {"rudder 0", "rudder -4", "rudder 0", "rudder 4", "sheet 0", "sheet 4", "boom -1", "boom 0", "boom 1",
         "boom 0"});
}

TEST(DemoInteractive, HelpTurnsItsPagesAndGoes) {
    Pty terminal([] { return run<Flight>("--record"); });
    terminal.resize(40, 12);
    ASSERT_TRUE(terminal.waitFor(ENTER));
    awaitFrame(terminal);
    terminal.type("h");
    ASSERT_TRUE(terminal.waitFor("W S"));
    for (int n = 0; n < 10; ++n) {
        terminal.type("k");  // nothing but a key
        terminal.rest(100);
    }
    awaitFrame(terminal);  // it flies again
    terminal.type("\x1b");
    EXPECT_EQ(terminal.end(), 0);
    std::remove(scriptPath.c_str());
}

TEST(DemoInteractive, NoTimePassesWhilePausedOrReading) {
    Pty terminal([] { return run<Flight>("--record"); });
    terminal.resize(80, 24);
    ASSERT_TRUE(terminal.waitFor(ENTER));
    const auto start = std::chrono::steady_clock::now();
    terminal.type("p");
    terminal.rest(500);
    terminal.type("p");
    terminal.type("h");
    terminal.rest(500);
    terminal.type("c");  // any key closes the help
    awaitFrame(terminal);
    terminal.type("\x1b");
    EXPECT_EQ(terminal.end(), 0);
    const std::chrono::duration<real> passed = std::chrono::steady_clock::now() - start;
    const std::string script = readFile(scriptPath);
    const std::size_t end = script.rfind(" end");
    ASSERT_NE(end, std::string::npos) << script;
    const real time = std::stod(script.substr(script.rfind('\n', end) + 1));
    EXPECT_GT(time, 0);
    EXPECT_LT(time, passed.count() - 0.6) << "of the second that it stood still";
    std::remove(scriptPath.c_str());
}

#endif
