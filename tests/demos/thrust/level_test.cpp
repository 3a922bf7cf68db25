#include "thrust/level.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace {

using cyclone::real;
using cyclone::Vector3;
using thrust::Level;
using thrust::Wall;

const std::string VALLEY = "gravity 2\nfuel 30\nmap\n#  S    #\n#     P #\n#########\n";

real cross(const Vector3 &a, const Vector3 &b) { return a.x * b.y - a.y * b.x; }

bool isRock(const Level &level, const Vector3 &point) {
    for (const std::vector<Vector3> &polygon : level.rock) {
        bool inside = true;
        for (std::size_t n = 0; n < polygon.size(); ++n) {
            const Vector3 &a = polygon[n], &b = polygon[(n + 1) % polygon.size()];
            inside = inside && cross(b - a, point - a) >= 0;
        }
        if (inside) return true;
    }
    return false;
}

TEST(ThrustLevel, IsReadFromItsMapTrueToScale) {
    const Level level = thrust::readLevel(VALLEY);
    EXPECT_EQ(level.gravity, 2);
    EXPECT_EQ(level.fuel, 30);
    EXPECT_EQ(level.width, 8 * Level::ACROSS);
    EXPECT_EQ(level.height, 2 * Level::DOWN);
    EXPECT_EQ(level.start, Vector3(3 * Level::ACROSS, 2 * Level::DOWN, 0));
    EXPECT_EQ(level.pod, Vector3(6 * Level::ACROSS, Level::DOWN / 2, 0)) << "on the rock";
}

TEST(ThrustLevel, ARowOfRockHasAFlatSurfaceHalfARowAboveIt) {
    const Level level = thrust::readLevel("map\nSP\n##\n");
    ASSERT_FALSE(level.walls.empty());
    for (const Wall &wall : level.walls) {
        EXPECT_EQ(wall.from.y, Level::DOWN / 2);
        EXPECT_EQ(wall.to.y, Level::DOWN / 2);
    }
}

/// Everywhere, in the program's own levels too.
TEST(ThrustLevel, EachWallHasRockOnItsLeftAndAirOnItsRight) {
    for (const Level &level :
         {thrust::readLevel(VALLEY), thrust::getLevel(1), thrust::getLevel(2), thrust::getLevel(3)})
        for (const Wall &wall : level.walls) {
            const Vector3 along = (wall.to - wall.from).unit(), left(-along.y, along.x, 0);
            const Vector3 middle = (wall.from + wall.to) * 0.5;
            EXPECT_TRUE(isRock(level, middle + left * 0.01)) << level.name;
            EXPECT_FALSE(isRock(level, middle - left * 0.01)) << level.name;
        }
}

TEST(ThrustLevel, RockIsConvex) {
    for (std::size_t number = 1; number <= 3; ++number)
        for (const std::vector<Vector3> &polygon : thrust::getLevel(number).rock)
            for (std::size_t n = 0; n < polygon.size(); ++n) {
                const Vector3 &a = polygon[n], &b = polygon[(n + 1) % polygon.size()],
                              &c = polygon[(n + 2) % polygon.size()];
                EXPECT_GE(cross(b - a, c - b), 0);
            }
}

TEST(ThrustLevel, ThePilotsWayIsInAlphabeticalOrder) {
    const Level level = thrust::readLevel("map\n#S b#\n#aPc#\n#####\n");
    const std::vector<Vector3> way = {{2, 4, 0}, {6, 8, 0}, {6, 4, 0}};
    EXPECT_EQ(level.way, way);
}

TEST(ThrustLevel, MistakesAreToldWithTheirLine) {
    const auto mistake = [](const std::string &text) -> std::string {
        try {
            thrust::readLevel(text);
        } catch (const std::runtime_error &error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_EQ(mistake("# a comment\ngravity much\nmap\n"), "line 2: gravity must be a positive number");
    EXPECT_EQ(mistake("fuel -1\nmap\n"), "line 1: fuel must be a positive number");
    EXPECT_EQ(mistake("colour red\n"), "line 1: 'colour red' is not understood");
    EXPECT_EQ(mistake("map\n#P#\n###\n"), "line 3: the map needs a ship, S, and a pod, P");
    EXPECT_EQ(mistake("map\nSPS\n###\n"), "line 2: the map has two marks S");
    EXPECT_EQ(mistake("map\nSP?\n###\n"), "line 2: the map has an unknown mark, ?");
    EXPECT_EQ(mistake(""), "line 0: the map needs a ship, S, and a pod, P");
}

TEST(ThrustLevel, TheProgramHasThree) {
    for (std::size_t number = 1; number <= 3; ++number) EXPECT_FALSE(thrust::getLevel(number).name.empty());
    EXPECT_THROW(thrust::getLevel(0), std::out_of_range);
    EXPECT_THROW(thrust::getLevel(4), std::out_of_range);
}

}  // namespace
