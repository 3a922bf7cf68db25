#include "thrust/mission.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using cyclone::real;
using cyclone::Vector3;
using demo::Event;
using thrust::Level;
using thrust::Mission;
using thrust::Ship;

constexpr real LONGEST = 240;  // s
const std::vector<real> CALM = {0}, BREEZE = {1}, GALE = {3};

/// A hall 36 m wide and 20 m high, the pod in its middle on the ground, which is at y = 2.
const std::string HALL =
    "name The hall\ngravity 1\nfuel 20\nmap\n"
    "#                 #\n#  S              #\n#                 #\n#                 #\n"
    "#        P        #\n###################\n";

void run(Mission &mission, real seconds, bool withPilot = false) {
    for (const real end = mission.getTime() + seconds;
         mission.getTime() < end && !mission.isOver() && mission.getWreck().empty();) {
        if (withPilot) mission.steer();
        mission.step();
    }
}

Mission &begun(Mission &mission, const std::vector<real> &settings = CALM) {
    mission.begin(1, settings);
    (void)mission.takeEvents();
    return mission;
}

/// Moves the ship here, moving at that velocity, with its engine just off.
void throwFrom(Mission &mission, const Vector3 &place, const Vector3 &velocity) {
    mission.setControl(Mission::THRUST, 1);
    mission.step();
    mission.setControl(Mission::THRUST, 0);
    mission.getShip().getBody().setPosition(place);
    mission.getShip().getBody().setVelocity(velocity);
}

bool wasTold(Mission &mission, const std::string &text) {
    for (const Event &event : mission.takeEvents())
        if (event.text.find(text) != std::string::npos) return true;
    return false;
}

TEST(ThrustMission, FitsItsProfile) {
    Mission mission(1);
    EXPECT_EQ(mission.getFrame().poses.size(), demo::countParts(mission.getScene()));
    EXPECT_TRUE(mission.getFrame().cut);
    mission.step();
    EXPECT_FALSE(mission.getFrame().cut);
    EXPECT_EQ(mission.getProfile().variant, "level 1");
}

TEST(ThrustMission, PartsAreConvexAndFlat) {
    const Mission mission(3);
    std::vector<demo::Part> parts = mission.getScene().fixtures;
    for (const demo::Body &body : mission.getScene().bodies)
        parts.insert(parts.end(), body.parts.begin(), body.parts.end());
    for (const demo::Part &part : parts)
        for (const demo::Face &face : part.faces) {
            const std::size_t count = face.corners.size();
            Vector3 area;
            for (std::size_t n = 1; n + 1 < count; ++n)
                area += (face.corners[n] - face.corners[0]) % (face.corners[n + 1] - face.corners[0]);
            ASSERT_GT(area.magnitude(), 1e-6) << part.name;
            for (std::size_t n = 0; n < count; ++n) {
                const Vector3 a = face.corners[n], b = face.corners[(n + 1) % count],
                              c = face.corners[(n + 2) % count];
                EXPECT_GT(((b - a) % (c - b)) * area.unit(), -1e-9) << part.name;
                EXPECT_NEAR((a - face.corners[0]) * area.unit(), 0, 1e-9) << part.name;
            }
        }
}

TEST(ThrustMission, TheSameSeedGivesTheSameRunAndAnotherAnother) {
    const auto hashAfter = [](Mission &mission, std::uint64_t seed) {
        mission.begin(seed, BREEZE);
        run(mission, 20, true);
        return mission.getHash();
    };
    Mission one(2), used(2);
    const std::uint64_t hash = hashAfter(one, 7);
    EXPECT_NE(hashAfter(used, 8), hash);
    EXPECT_EQ(hashAfter(used, 7), hash) << "a used one is as good as new";
}

TEST(ThrustMission, ARunCanBePlayedAgainFromItsControls) {
    Mission piloted(2), played(2);
    piloted.begin(3, BREEZE);
    played.begin(3, BREEZE);
    while (piloted.getTime() < 90) {
        piloted.steer();
        for (const std::size_t n : {Mission::HEADING, Mission::THRUST})
            played.setControl(n, piloted.getControl(n));
        piloted.step();
        played.step();
    }
    EXPECT_TRUE(piloted.getShip().isHooked());
    EXPECT_EQ(piloted.getHash(), played.getHash());
}

// ---- The pilot

void expectAllFetched(std::size_t level, std::uint64_t seeds, const std::vector<real> &settings) {
    Mission mission(level);
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        mission.begin(seed, settings);
        run(mission, LONGEST, true);
        EXPECT_TRUE(mission.isOver()) << seed << ": " << mission.getSummary();
        EXPECT_GT(mission.getFuel(), 0.1 * mission.getLevel().fuel) << seed;
    }
}

TEST(ThrustMission, ThePilotFetchesThePodFromThePlainWithFortySeeds) { expectAllFetched(1, 40, BREEZE); }
TEST(ThrustMission, ThePilotFetchesThePodFromTheCaveWithFortySeeds) { expectAllFetched(2, 40, BREEZE); }
TEST(ThrustMission, ThePilotFetchesThePodFromTheLabyrinthWithFortySeeds) { expectAllFetched(3, 40, BREEZE); }
TEST(ThrustMission, ThePilotFetchesThePodInGustsToo) {
    for (const std::size_t level : {1u, 2u, 3u}) expectAllFetched(level, 2, GALE);
}

TEST(ThrustMission, ThePilotTakesOverWhereverTheShipIs) {
    Mission mission(2);
    begun(mission);
    run(mission, 25, true);
    const Vector3 place = mission.getShip().getBody().getPosition();
    mission.getShip().getBody().setPosition(place + Vector3(20, 2, 0));  // along the hall
    run(mission, LONGEST, true);
    EXPECT_TRUE(mission.isOver()) << mission.getSummary();
}

// ---- Its rules

TEST(ThrustMission, TheShipHangsUntilTheEngineBurnsAndThenFalls) {
    Mission mission(thrust::readLevel(HALL));
    begun(mission);
    const Vector3 start = mission.getShip().getBody().getPosition();
    run(mission, 3);
    EXPECT_EQ(mission.getShip().getBody().getPosition(), start);
    throwFrom(mission, start, Vector3());
    run(mission, 2);
    EXPECT_NEAR(mission.getShip().getBody().getPosition().y, start.y - 2, 0.05) << "g·t²/2";
}

TEST(ThrustMission, TheShipIsDestroyedWhenItTouchesRock) {
    Mission mission(thrust::readLevel(HALL));
    throwFrom(begun(mission), {8, 6, 0}, {0, 0, 0});
    run(mission, 10);
    EXPECT_FALSE(mission.getWreck().empty());
    // The fins are 1.1 m below the middle, the ground is at 2 m.
    EXPECT_NEAR(mission.getTime(), std::sqrt(2 * (6 - 1.1 - 2) / 1.0), 0.05);
    EXPECT_EQ(mission.getWreck(), "destroyed: the ship touched rock at 2.4 m/s");
    EXPECT_TRUE(wasTold(mission, mission.getWreck()));
    EXPECT_TRUE(mission.getShip().isBroken());
    for (int n = 0; n < 120; ++n) mission.step();
    const Vector3 hull = mission.getShip().getWreck(0).getPosition();
    EXPECT_NE(hull, mission.getShip().getWreck(1).getPosition()) << "they fly apart";
    mission.step();
    EXPECT_EQ(mission.getShip().getWreck(0).getPosition(), hull) << "and stay";
    mission.startOver();
    EXPECT_EQ(mission.getWreck(), "");
    EXPECT_FALSE(mission.getShip().isBroken());
}

TEST(ThrustMission, NoSpeedTakesItThroughARock) {
    for (const real speed : {10.0, 1e3, 1e6}) {
        Mission mission(thrust::readLevel(HALL));
        throwFrom(begun(mission), {18, 12, 0}, {speed, 0, 0});
        run(mission, 2);
        EXPECT_FALSE(mission.getWreck().empty()) << speed;
        EXPECT_TRUE(wasTold(mission, "touched rock")) << speed;
    }
}

TEST(ThrustMission, ThePodIsHookedAtItsRing) {
    Mission mission(thrust::readLevel(HALL));
    const Vector3 ring = begun(mission).getShip().getRodEnd();
    throwFrom(mission, ring + Vector3(Mission::HOOK_REACH + 0.1, 0, 0), Vector3());
    mission.step();
    EXPECT_FALSE(mission.getShip().isHooked());
    throwFrom(mission, ring + Vector3(Mission::HOOK_REACH - 0.1, 0, 0), Vector3());
    mission.step();
    EXPECT_TRUE(mission.getShip().isHooked());
    EXPECT_TRUE(wasTold(mission, "the pod is on the rod"));
}

TEST(ThrustMission, ThePodMayNotTouchEither) {
    Mission mission(thrust::readLevel(HALL));
    throwFrom(begun(mission), mission.getShip().getRodEnd(), Vector3());
    run(mission, 5);
    EXPECT_FALSE(mission.getWreck().empty());
    EXPECT_TRUE(wasTold(mission, "the pod touched rock"));
}

/// A pillar between ship and pod, under the rod.
TEST(ThrustMission, TheRodMayNotTouchEither) {
    Mission mission(
        thrust::readLevel("gravity 1\nfuel 20\nmap\n#             #\n#  S          #\n"
                          "#             #\n#          #  #\n#   P      #  #\n###############\n"));
    throwFrom(begun(mission), mission.getShip().getRodEnd(), Vector3());
    mission.step();
    ASSERT_TRUE(mission.getShip().isHooked());
    // The pillar stands at x = 22 and ends at y = 10.
    mission.getShip().getBody().setPosition(19.5, 10.3, 0);
    mission.getShip().getPod().setPosition(24.5, 10.3, 0);
    mission.getShip().getBody().setVelocity(0, -3, 0);
    mission.getShip().getPod().setVelocity(0, -3, 0);
    run(mission, 1);
    EXPECT_TRUE(wasTold(mission, "the rod touched rock"));
}

TEST(ThrustMission, TheEngineBurnsTheFuelAndThenStops) {
    Mission mission(thrust::readLevel(HALL));
    begun(mission);
    mission.setControl(Mission::THRUST, 0.25);
    run(mission, 2);
    EXPECT_NEAR(mission.getFuel(), 20 - 2 * 0.25, 0.01);
    Level level = thrust::readLevel(HALL);
    level.fuel = 0.5;
    Mission poor(level);
    begun(poor);
    poor.setControl(Mission::THRUST, 1);
    run(poor, 0.45);
    EXPECT_EQ(poor.getShip().getThrottle(), 1);
    run(poor, 0.2);
    EXPECT_EQ(poor.getShip().getThrottle(), 0);
    EXPECT_EQ(poor.getFuel(), 0);
    EXPECT_TRUE(wasTold(poor, "out of fuel"));
}

TEST(ThrustMission, IsDoneWhenShipAndPodAreAboveTheRock) {
    Mission mission(thrust::readLevel(HALL));
    throwFrom(begun(mission), {18, 30, 0}, Vector3());
    mission.step();
    EXPECT_FALSE(mission.isOver()) << "without the pod";
    throwFrom(mission, mission.getShip().getRodEnd(), Vector3());
    mission.step();
    ASSERT_TRUE(mission.getShip().isHooked());
    mission.getShip().getBody().setPosition(18, 24, 0);
    mission.getShip().getPod().setPosition(18, 19, 0);
    mission.step();
    EXPECT_FALSE(mission.isOver()) << "the pod is still below";
    mission.getShip().getBody().setPosition(18, 26, 0);
    mission.getShip().getPod().setPosition(18, 21, 0);
    mission.step();
    EXPECT_TRUE(mission.isOver());
    EXPECT_EQ(mission.getHeadUpLine(), "The pod is out with 100% of the fuel left: R to fly again");
    EXPECT_NE(mission.getSummary().find("fetched the pod"), std::string::npos);
}

TEST(ThrustMission, APointerShowsTheWayToTheRingAndThenToTheSky) {
    Mission mission(thrust::readLevel(HALL));
    const Vector3 ring = begun(mission).getShip().getRodEnd();
    const auto getPointer = [&mission] {
        const demo::Pose pose = mission.getFrame().poses.back();
        EXPECT_NEAR((pose.orientation.rotate(Vector3::X) * 2.8 -
                     (pose.position - mission.getShip().getBody().getPosition()))
                        .magnitude(),
                    0, 1e-9)
            << "it points away from the ship";
        return pose.orientation.rotate(Vector3::X);
    };
    throwFrom(mission, ring + Vector3(-6, 8, 0), Vector3());
    EXPECT_NEAR((getPointer() - Vector3(0.6, -0.8, 0)).magnitude(), 0, 1e-9);
    throwFrom(mission, ring, Vector3());
    mission.step();
    ASSERT_TRUE(mission.getShip().isHooked());
    EXPECT_NEAR((getPointer() - Vector3::UP).magnitude(), 0, 1e-9);
}

TEST(ThrustMission, FarOutsideTheShipIsLost) {
    Mission mission(thrust::readLevel(HALL));
    throwFrom(begun(mission), {18, 200, 0}, Vector3());
    mission.step();
    EXPECT_TRUE(wasTold(mission, "lost in space"));
}

TEST(ThrustMission, TheHeadUpLineSaysWhereToGo) {
    Mission mission(thrust::readLevel(HALL));
    throwFrom(begun(mission), mission.getShip().getRodEnd() + Vector3(-10, 3, 0), Vector3());
    const std::string line = mission.getHeadUpLine();
    EXPECT_NE(line.find("RING 10 m right 3 m down"), std::string::npos) << line;
}

}  // namespace
