#include "thrust/mission.h"

#include <algorithm>

#include "base/text.h"
#include "thrust/parts.h"
#include "thrust/sweep.h"

namespace thrust {

namespace {

constexpr real DEGREE = cyclone::REAL_PI / 180;
constexpr real GUST_MEMORY = 3;    // s
constexpr real START_SCATTER = 1;  // m
constexpr real POD_STAND = 0.15;   // m, between the pod and the rock below it
constexpr real FARTHEST = 60;      // m beyond the map
constexpr real WRECK_MOTION = 1;   // s: the parts fly, but not through the rock
constexpr real NEWTONS_PER_METRE = 1200;
constexpr Colour PUSH{255, 190, 60}, ROD_FORCE{120, 235, 140};

Scene makeScene(const Level &level) {
    Scene scene;
    scene.surroundings.terrain = Terrain::SPACE;
    scene.bodies = makeBodies();
    scene.fixtures = makeRock(level);
    scene.newtonsPerMetre = NEWTONS_PER_METRE;
    scene.cameras.viewpoints = {Viewpoint::PLANE, Viewpoint::SPECTATOR};
    scene.cameras.spectator = Vector3(-10, level.height / 2 + 8, 45);
    scene.cameras.spectatorFollows = true;
    scene.cameras.distance = 23;
    scene.cameras.windHeight = 4;
    return scene;
}

/// "12 m right"; what shows as nought is nothing.
std::string told(real metres, const char *positive, const char *negative) {
    const std::string shown = fixed(std::abs(metres), 0);
    return shown == "0" ? "" : " " + shown + " m " + (metres > 0 ? positive : negative);
}

}  // namespace

Mission::Mission(std::size_t number) : Mission(thrust::getLevel(number)) {
    profile.variant = "level " + std::to_string(number);
}

Mission::Mission(Level l) : level(std::move(l)), ship(world, &windspeed), pilot(level) {
    fillProfile();
    scene = makeScene(level);
    begin(0);
}

void Mission::fillProfile() {
    profile.program = "thrust";
    profile.summary = "Fetches a pod from a cave: with the keyboard in a terminal, otherwise by itself.";
    profile.settings = {{"gusts", "SPEED", "How much the air moves (root mean square), m/s", 1, 0, 4}};
    profile.controls = {
        {"heading", -180, 180, 0, 'a', 'd', 10, false},
        {"thrust", 0, 1, 0, 's', 'w', 0.05, true},
    };
    profile.help = {
        "A D   turn the nose left, right",
        "W S   more thrust, less",
        "X     engine off",
        "",
        "Fly to the ring above the pod, where the green",
        "pointer points: it hooks the rod.",
        "Carry the pod out above the rock. Slowly: it swings.",
        "Touch nothing, neither with ship nor rod nor pod.",
    };
    const cyclone::RigidBody &body = ship.getBody(), &pod = ship.getPod();
    profile.quantities = {
        {"speed", "m/s", [&] { return body.getVelocity().magnitude(); }, "speed", 1},
        {"climb", "m/s", [&] { return body.getVelocity().y; }, "speed", 1},
        {"heading", "°", [this] { return ship.getHeading() / DEGREE; }, "angle", 0},
        {"swing", "°", [this] { return ship.getSwing() / DEGREE; }, "angle", 0},
        {"thrust", "N", [this] { return ship.getPush().magnitude(); }, "force", 0},
        {"rod", "N", [this] { return ship.getRodForce().magnitude(); }, "force", 0},
        {"fuel", "s", [this] { return fuel; }, "fuel", 1},
        {"x", "m", [&] { return body.getPosition().x; }, "", 1},
        {"y", "m", [&] { return body.getPosition().y; }, "", 1},
        {"pod x", "m", [&] { return pod.getPosition().x; }},
        {"pod y", "m", [&] { return pod.getPosition().y; }},
    };
    profile.title = level.name;
    profile.kind = "thrust";
    profile.wreckMotion = WRECK_MOTION;
    profile.duration = 240;
}

void Mission::prepare(std::uint64_t seed, const std::vector<real> &settings) {
    random = Random(seed);
    wind = Wind(Vector3(), settings.at(GUSTS), GUST_MEMORY, profile.step, random.next());
    for (real time = 0; time < 3 * GUST_MEMORY; time += profile.step)
        advanceWind();  // it does not begin calm
    topSpeed = 0;
}

void Mission::launch() {
    const auto scatter = [this] { return random.between(-START_SCATTER, START_SCATTER); };
    const real aside = scatter(), up = scatter();
    ship.launch(level.start + Vector3(aside, up, 0), level.pod + Vector3::UP * (Ship::POD_RADIUS + POD_STAND),
                level.gravity);
    pilot.startOver(ship);
    fuel = level.fuel;
    fetched = false;
}

void Mission::steer() {
    pilot.fly(ship, profile.step);
    setControl(HEADING, pilot.getHeading() / DEGREE);
    setControl(THRUST, pilot.getThrottle());
}

void Mission::beforeStep() {
    advanceWind();
    ship.setHeading(getControl(HEADING) * DEGREE);
    burn();
    ship.advanceWinch(profile.step);
    outlines = getOutlines();
}

void Mission::advanceWind() {
    wind.advance();
    windspeed = wind.getWindspeed();
    windspeed.z = 0;
}

void Mission::burn() {
    ship.setThrottle(fuel > 0 ? getControl(THRUST) : 0);
    if (fuel <= 0 || fetched) return;
    fuel -= ship.getThrottle() * profile.step;
    if (fuel > 0) return;
    fuel = 0;
    tell("out of fuel");
}

void Mission::afterStep() {
    if (isDecided()) return;
    topSpeed = std::max(topSpeed, ship.getBody().getVelocity().magnitude());
    const Outlines now = getOutlines();
    destroyIfTouching("ship", outlines.ship, now.ship);
    if (ship.isHooked()) {
        destroyIfTouching("pod", outlines.pod, now.pod);
        destroyIfTouching("rod", outlines.rod, now.rod);
    }
    hookIfReached();
    watchTheSky();
}

void Mission::hookIfReached() {
    const Vector3 way = ship.getRodEnd() - ship.getBody().getPosition();
    if (isDecided() || ship.isHooked() || way.magnitude() > HOOK_REACH) return;
    ship.hook();
    tell("the pod is on the rod: carry it out");
}

Mission::Outlines Mission::getOutlines() const {
    return {
        ship.getOutline(), ship.getPodOutline(), {ship.getBody().getPosition(), ship.getPod().getPosition()}};
}

void Mission::destroyIfTouching(const char *part, const std::vector<Vector3> &before,
                                const std::vector<Vector3> &after) {
    std::vector<Corner> corners;
    for (std::size_t n = 0; n < before.size(); ++n) corners.push_back({before[n], after[n]});
    if (isDecided() || !findTouch(corners, level.walls)) return;
    destroy(std::string("the ") + part + " touched rock at " +
            fixed(ship.getBody().getVelocity().magnitude(), 1) + " m/s");
}

void Mission::destroy(const std::string &why) {
    wreckBy("destroyed: " + why);
    ship.breakUp();
}

void Mission::watchTheSky() {
    if (isDecided()) return;
    const Vector3 place = ship.getBody().getPosition();
    const real top = level.height;
    if (ship.isHooked() && place.y > top && ship.getPod().getPosition().y > top) {
        fetched = true;
        tell("the pod is out: well flown");
    } else if (place.x < -FARTHEST || place.x > level.width + FARTHEST || place.y > top + FARTHEST) {
        destroy("lost in space");
    }
}

std::vector<Pose> Mission::getPoses() const { return thrust::getPoses(ship); }

std::vector<Arrow> Mission::getArrows() const {
    const cyclone::RigidBody &body = ship.getBody();
    const real scale = 1 / NEWTONS_PER_METRE;
    return {{"engine", body.getPosition(), ship.getPush() * scale, PUSH},
            {"rod", body.getPosition(), ship.getRodForce() * scale, ROD_FORCE}};
}

std::string Mission::getHeadUpLine() const {
    const std::string fuelLeft = fixed(100 * fuel / level.fuel, 0) + "%";
    if (fetched) return "The pod is out with " + fuelLeft + " of the fuel left: R to fly again";
    const cyclone::RigidBody &body = ship.getBody();
    const Vector3 way = ship.getRodEnd() - body.getPosition();
    const std::string task =
        ship.isHooked() ? "POD hooked, SKY" + told(level.height - ship.getPod().getPosition().y, "up", "down")
                        : "RING" + told(way.x, "right", "left") + told(way.y, "up", "down");
    return "THRUST " + fixed(100 * ship.getThrottle(), 0) + "%  FUEL " + fuelLeft + "  " + task + "  SPEED " +
           fixed(body.getVelocity().magnitude(), 1) + "  CLIMB " + signedFixed(body.getVelocity().y, 1);
}

std::string Mission::getSummary() const {
    const std::string ending = fetched              ? "fetched the pod"
                               : getWreck().empty() ? "not at an end"
                                                    : getWreck();
    return level.name + ": " + ending + "\nTime: " + fixed(getTime(), 1) +
           " s\nFuel left: " + fixed(100 * fuel / level.fuel, 0) + " %\nTop speed: " + fixed(topSpeed, 1) +
           " m/s";
}

}  // namespace thrust
