#include "shell/script.h"

#include <gtest/gtest.h>

#include "flightsim/flight.h"

using namespace demo;
using namespace flightsim;

namespace {

const Profile &profile() {
    static const Flight flight;
    return flight.getProfile();
}

std::string complaint(const std::string &text) {
    try {
        readScript(text, profile());
    } catch (const std::runtime_error &error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(DemoScript, IsReadAsItsHeaderSays) {
    const Script script = readScript(
        "# a flight\n"
        "seed 7\n"
        "wind 2.5   # fresh\n"
        "\n"
        "2.5 pitch 0.3\r\n"
        "0 throttle 1\n"
        "31 restart\n"
        "60 end\n",
        profile());
    EXPECT_EQ(*script.seed, 7u);
    EXPECT_EQ(*script.settings[Flight::WIND_SPEED], 2.5);
    EXPECT_FALSE(script.settings[Flight::GUSTS]);
    ASSERT_EQ(script.changes.size(), 3u);
    EXPECT_EQ(script.changes[0].step, 0u);
    EXPECT_EQ(script.changes[0].control, std::size_t(Flight::THROTTLE));
    EXPECT_EQ(script.changes[0].value, 1);
    EXPECT_EQ(script.changes[1].step, 300u);
    EXPECT_EQ(script.changes[1].control, std::size_t(Flight::PITCH));
    EXPECT_EQ(script.changes[2].control, Script::RESTART);
    EXPECT_EQ(*script.end, 7200u);
}

TEST(DemoScript, SurvivesWritingAndReadingToTheLastBit) {
    Script script;
    script.seed = 18446744073709551615u;
    script.settings = {1.0 / 3, std::nullopt, 0.1};
    script.end = 123457;
    script.changes = {{0, Flight::ROLL, -1.0 / 7},
                      {5, Script::RESTART, 0},
                      {5, Flight::ROLL, 0.1 + 0.2},
                      {123456, Flight::THROTTLE, 5e-324}};
    const Script read = readScript(writeScript(script, profile()), profile());
    EXPECT_EQ(read.seed, script.seed);
    EXPECT_EQ(read.settings, script.settings);
    EXPECT_EQ(read.end, script.end);
    ASSERT_EQ(read.changes.size(), script.changes.size());
    for (std::size_t n = 0; n < script.changes.size(); ++n) {
        EXPECT_EQ(read.changes[n].step, script.changes[n].step);
        EXPECT_EQ(read.changes[n].control, script.changes[n].control);
        EXPECT_EQ(read.changes[n].value, script.changes[n].value);
    }
}

TEST(DemoScript, SaysWhichLineIsWrongAndWhy) {
    EXPECT_EQ(complaint("0 throttle 1\n1 flaps 1\n"), "line 2: there is no control 'flaps'");
    EXPECT_EQ(complaint("1 pitch 1.5\n"), "line 1: '1.5' is not between -1 and 1");
    EXPECT_EQ(complaint("1 pitch up\n"), "line 1: 'up' is not a number");
    EXPECT_EQ(complaint("1 pitch\n"), "line 1: expected a time, a control and a value");
    EXPECT_EQ(complaint("hello world\n"), "line 1: 'hello' is neither a setting nor a time");
    EXPECT_EQ(complaint("seed x\n"), "line 1: 'x' is not a whole number");
    EXPECT_EQ(complaint("wind 99\n"), "line 1: '99' is not between 0 and 5");
    EXPECT_EQ(complaint(""), "");
}
