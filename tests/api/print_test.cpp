#include <cyclone/print.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <locale>
#include <sstream>
#include <string>

#include "random.h"

namespace {

using namespace cyclone;
using namespace cyclone_test;

template <class T>
std::string printed(const T &value) {
    std::ostringstream stream;
    stream << value;
    return stream.str();
}

TEST(Print, ReadsAsInABook) {
    EXPECT_EQ(printed(Vector3(1, -2.5, 0.1)), "(1, -2.5, 0.1)");
    EXPECT_EQ(printed(Quaternion(0.5, -0.5, 0, 0.25)), "0.5-0.5i+0j+0.25k");
    EXPECT_EQ(printed(Matrix3(1, 2, 3, 4, 5, 6, 7, 8, 9)), "[1 2 3; 4 5 6; 7 8 9]");
    EXPECT_EQ(printed(rigidTransform(Quaternion(), Vector3(5, 6, 7))), "[1 0 0 5; 0 1 0 6; 0 0 1 7]");
    EXPECT_EQ(printed(Vector3(QUIET_NAN, PLUS_INFINITY, -PLUS_INFINITY)), "(nan, inf, -inf)");
    EXPECT_EQ(printed(Vector3(-QUIET_NAN, 1e300, -0.0)), "(nan, 1e+300, -0)");
}

TEST(Print, AFewDigitsStayAFewDigits) {
    // Sixteen digits of the double next to 0.94 are 0.9399999999999999.
    EXPECT_EQ(printed(Vector3(0.94, 0.943, 0.009)), "(0.94, 0.943, 0.009)");
}

TEST(Print, Bodies) {
    RigidBody body;
    body.setMass(2.5);
    body.setPosition(0, 1, 0);
    body.setVelocity(3, 0, 0);
    body.setRotation(0, 0.5, 0);
    const std::string moving =
        " at (0, 1, 0), orientation 1+0i+0j+0k, velocity (3, 0, 0), rotation (0, 0.5, 0)";
    EXPECT_EQ(printed(body), "2.5 kg" + moving);

    RigidBody immovable = body;
    immovable.setInverseMass(0);
    EXPECT_EQ(printed(immovable), "immovable" + moving);

    body.addForce(Vector3(QUIET_NAN, 0, 0));
    body.integrate(1);
    EXPECT_EQ(printed(body), "2.5 kg" + moving + ", faulted");

    RigidBody asleep;
    asleep.setAwake(false);
    EXPECT_EQ(printed(asleep),
              "1 kg at (0, 0, 0), orientation 1+0i+0j+0k, velocity (0, 0, 0), rotation (0, 0, 0), asleep");
}

TEST(Print, EveryNumberReadsBackAsItself) {
    Random random(5);
    const real special[] = {1.0 / 3, 0.1, REAL_MAX, 5e-324, 2.2250738585072014e-308, REAL_PI, 1e23};
    for (int n = 0; n < 300; ++n) {
        const real number =
            n < 7 ? special[n] : random.between(-1, 1) * std::pow(10, random.between(-30, 30));
        const std::string text = printed(Vector3(number, 0, 0));
        EXPECT_EQ(std::strtod(text.c_str() + 1, nullptr), number) << text;
    }
}

TEST(Print, TheStreamStaysAsItWas) {
    std::ostringstream stream;
    stream << std::hex << std::scientific << std::showpos << std::setprecision(3) << std::setfill('.')
           << std::setw(12) << std::left << Vector3(1, 2, 30) << 255 << ' ' << 1.5;
    EXPECT_EQ(stream.str(), "(1, 2, 30)..ff +1.500e+00");
}

TEST(Print, NoLocaleChangesIt) {
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const std::string text = printed(Vector3(12345.5, 0, 0));
    std::locale::global(before);
    EXPECT_EQ(text, "(12345.5, 0, 0)");
}

}  // namespace
