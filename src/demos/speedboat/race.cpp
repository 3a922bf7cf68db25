#include "speedboat/race.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angle.h"
#include "base/text.h"
#include "models/attitude.h"
#include "models/sea.h"
#include "picture/solids.h"

namespace speedboat {

namespace {

using cyclone::REAL_PI;

constexpr real DEGREE = REAL_PI / 180;
constexpr real WIND_FROM = -REAL_PI / 4;  // north-west
constexpr real GUST_MEMORY = 4;           // s
constexpr real LONG_JUMP = 0.6;           // s: told at once
constexpr real NEWTONS_PER_METRE = 3000;
constexpr Colour TO_PORT{214, 46, 40}, TO_STARBOARD{30, 150, 80};
constexpr Colour PUSH{255, 190, 60}, LIFT{90, 170, 235}, FOIL_LIFT{140, 230, 150};

/// A slalom out, a turn, a straight back, a turn.
const std::vector<Buoy> BUOYS = {
    {70, 0, 0, true},
    {130, 0, 0, false},
    {190, 0, 0, true},
    {250, 0, 0, false},
    {315, 15, 45 * DEGREE, false},
    {315, 105, 135 * DEGREE, false},
    {180, 120, 180 * DEGREE, true},
    {70, 120, 180 * DEGREE, false},
    {-5, 105, -135 * DEGREE, false},
    {-5, 15, -45 * DEGREE, false},
};

std::string nameOf(std::size_t buoy) { return "buoy " + std::to_string(buoy + 1); }

}  // namespace

Race::Race(Hull h) : hull(h), boat(world, wind.getAddress(), &sea, h), course(BUOYS) {
    fillProfile();
    scene = makeScene();
    begin(0);
}

void Race::fillProfile() {
    profile.program = "speedboat";
    profile.variant = hull == Hull::FOILS ? "hull foils" : "hull planing";
    profile.summary = "Races a motorboat round buoys: with the keyboard in a terminal, otherwise by itself.";
    profile.settings = {
        {"wind", "SPEED", "Mean wind, from the north-west, m/s", 5, 0, 15},
        {"gusts", "SPEED", "How much the wind changes (root mean square), m/s", 1, 0, 5},
        {"waves", "HEIGHT", "Height of the waves, m; 0 is a calm sea", 0.7, 0, 1.5},
    };
    const real most = Motorboat::MAX_STEERING / DEGREE;
    profile.controls = {
        {"throttle", 0, 1, 0, 's', 'w', 0.1, false},
        {"steering", -most, most, 0, 'a', 'd', 4, true},
        {"tilt", Motorboat::LEAST_TILT / DEGREE, Motorboat::MOST_TILT / DEGREE, 0, 'q', 'e', 2, true},
    };
    profile.help = {
        "W S   throttle: more, less",
        "A D   turn the motor: the boat goes left, right",
        "Q E   tilt the motor: bow down, bow up",
        "X     motor straight and upright",
        "",
        "Leave red buoys to port, your left; green ones to",
        "starboard. The yellow arrow hangs over the next.",
        "Only thrust steers: none with the throttle shut, or",
        "with the screw out of the water after a jump.",
        "Too much tilt and the boat porpoises: tilt it in.",
    };
    const RigidBody &body = boat.getBody();
    profile.quantities = {
        {"speed", "m/s", [this] { return boat.getSpeed(); }, "speed", 1},
        {"trim", "°", [&body] { return pitchOf(body) / DEGREE; }, "attitude", 1},
        {"heel", "°", [&body] { return bankOf(body) / DEGREE; }, "attitude", 1},
        {"draught", "m", [this] { return boat.getDraught(); }, "draught", 2},
        {"throttle", "", [this] { return boat.getThrottle(); }, "throttle", 2},
        {"steering", "°", [this] { return boat.getSteering() / DEGREE; }, "motor", 0},
        {"tilt", "°", [this] { return boat.getTilt() / DEGREE; }, "motor"},
        {"time dry", "s", [this] { return log.timeDry; }, "screw", 2},
        {"heading", "°", [&body] { return compassDegrees(headingOf(body)); }, "", 0},
        {"lap", "s", [this] { return getLapTime(); }, "", 1},
        {"buoy", "", [this] { return static_cast<real>(course.getNext() + 1); }, "", 0},
        {"thrust", "N", [this] { return boat.getThrust().magnitude(); }},
        {"wetted length", "m", [this] { return boat.getWettedLength(); }},
        {"airborne", "s", [this] { return airborneFor; }},
        {"north", "m", [&body] { return body.getPosition().x; }},
        {"east", "m", [&body] { return body.getPosition().z; }},
        {"height", "m", [&body] { return body.getPosition().y; }},
        {"wind speed", "m/s", [this] { return wind.getWindspeed().magnitude(); }},
    };
    profile.title =
        hull == Hull::FOILS ? "A hydrofoil on a course of buoys" : "A speedboat on a course of buoys";
    profile.kind = "motorboat";
    profile.wreckMotion = std::numeric_limits<real>::infinity();
    profile.duration = 180;
}

Scene Race::makeScene() const {
    Scene made;
    made.surroundings.terrain = Terrain::SEA;
    made.bodies = {{makeBoatParts(hull, boat.getScrew()), true, false}};
    made.bodies.push_back({makeSpray(hull), false, true});
    for (std::size_t n = 0; n < BUOYS.size(); ++n)
        made.bodies.push_back(
            {{makeBuoy(nameOf(n), BUOYS[n].toPort ? TO_PORT : TO_STARBOARD)}, false, false});
    made.bodies.push_back({{makeBuoyPointer("next buoy")}, false, false});
    made.newtonsPerMetre = NEWTONS_PER_METRE;
    made.cameras.spectator = Vector3(-10, 4, 14);
    made.cameras.spectatorFollows = true;
    made.cameras.distance = 11;
    made.cameras.height = 1;
    made.cameras.windHeight = 4;
    return made;
}

void Race::prepare(std::uint64_t seed, const std::vector<real> &settings) {
    Random random(seed);
    wind = demo::Wind(towardsBearing(WIND_FROM) * settings.at(WIND), settings.at(GUSTS), GUST_MEMORY,
                      profile.step, random.next());
    setWaves(settings.at(WAVES), random);
    course = Course(BUOYS);
    log = Log();
}

/// No two seeds meet the same waves.
void Race::setWaves(real height, Random &random) {
    scene.surroundings.waves = makeSea(height, WIND_FROM + REAL_PI);
    sea = cyclone::Waves();
    for (cyclone::Waves::Train &train : scene.surroundings.waves) {
        train.phase = random.between(0, 2 * REAL_PI);
        sea.addTrain(train);
    }
}

void Race::launch() {
    boat.launch(0, 0, 0);
    course.startOver(getTime());
    airborneFor = dryFor = 0;
    lapsBefore = course.getLaps();
}

void Race::steer() {
    const Orders orders = drive(boat, course, profile.step);
    setControl(THROTTLE, orders.throttle);
    setControl(STEERING, orders.steering / DEGREE);
    setControl(TILT, orders.tilt / DEGREE);
}

void Race::beforeStep() {
    boat.setThrottle(getWreck().empty() ? getControl(THROTTLE) : 0);
    boat.setSteering(getControl(STEERING) * DEGREE);
    boat.setTilt(getControl(TILT) * DEGREE);
    wind.advance();
    lastPosition = boat.getBody().getPosition();
}

void Race::afterStep() {
    sea.setTime(getTime());
    watchForCapsize();
    if (!getWreck().empty()) return;
    watchTheCourse();
    keepLog();
    countJumps();
}

void Race::watchTheCourse() {
    const std::size_t buoy = course.getNext();
    const auto event = course.advance(lastPosition, boat.getBody().getPosition(), getTime(), profile.step);
    if (event == Course::Event::PASSED) tell("passed " + nameOf(buoy));
    if (event == Course::Event::MISSED)
        tell("missed " + nameOf(buoy) + ": go round and leave it to " +
             (BUOYS[buoy].toPort ? "port" : "starboard"));
    if (event == Course::Event::LAP) tell("lap in " + fixed(course.getLastLap(), 2) + " s");
}

void Race::keepLog() {
    const Vector3 way = boat.getBody().getPosition() - lastPosition;
    log.distance += horizontalLength(way);
    log.topSpeed = std::max(log.topSpeed, boat.getSpeed());
    dryFor = boat.isScrewDry() ? dryFor + profile.step : 0;
    if (dryFor > 0) log.timeDry += profile.step;
}

void Race::countJumps() {
    if (boat.isAirborne()) {
        airborneFor += profile.step;
        return;
    }
    if (airborneFor >= SHORTEST_JUMP) {
        ++log.jumps;
        log.longestJump = std::max(log.longestJump, airborneFor);
        if (airborneFor >= LONG_JUMP) tell("jumped: " + fixed(airborneFor, 2) + " s in the air");
    }
    airborneFor = 0;
}

void Race::watchForCapsize() {
    if (!getWreck().empty() || !boat.isCapsized()) return;
    ++log.capsizes;
    wreckBy("capsized at " + fixed(boat.getSpeed(), 1) + " m/s");
}

std::vector<Pose> Race::getPoses() const {
    std::vector<Pose> poses = getBoatPoses(boat);
    for (const Pose &pose : getSprayPoses(boat, sea, hull)) poses.push_back(pose);
    const auto afloat = [this](const Vector3 &place) {
        return Pose{place + Vector3::UP * sea.getHeight(place), Quaternion()};
    };
    for (const Buoy &buoy : BUOYS) poses.push_back(afloat(buoy.getPlace()));
    poses.push_back(afloat(course.getNextBuoy().getPlace()));
    return poses;
}

std::vector<Arrow> Race::getArrows() const {
    const RigidBody &body = boat.getBody();
    const auto arrow = [&body](const std::string &name, const Vector3 &at, const Vector3 &force,
                               Colour colour) {
        return Arrow{name, body.getPointInWorldSpace(at), force * (1 / NEWTONS_PER_METRE), colour};
    };
    std::vector<Arrow> arrows = {arrow("screw", boat.getScrew(), boat.getThrust(), PUSH)};
    const std::vector<cyclone::Wing> &bottom = boat.getBottom();
    for (std::size_t n = 0; n < bottom.size(); n += 2) {
        Vector3 force;
        for (const std::size_t half : {n, n + 1})
            force += bottom[half].getForce(body) + boat.getFloats()[half].getForce(body);
        const Vector3 keel(bottom[n].getPosition().x, bottom[n].getPosition().y, 0);
        arrows.push_back(arrow("bottom " + std::to_string(n / 2 + 1), keel, force, LIFT));
    }
    for (std::size_t n = 0; n < boat.getFoils().size(); ++n) {
        const cyclone::Wing &foil = boat.getFoils()[n];
        arrows.push_back(
            arrow("foil " + std::to_string(n + 1), foil.getPosition(), foil.getForce(body), FOIL_LIFT));
    }
    return arrows;
}

/// Which buoy is next, where it is off the bow, and on which hand to leave it.
std::string Race::getTask() const {
    const Buoy &buoy = course.getNextBuoy();
    return "BUOY " + std::to_string(course.getNext() + 1) + " " +
           whereabouts(boat.getBody(), buoy.getPlace()) + (buoy.toPort ? " to port" : " to starboard");
}

std::string Race::getHeadUpLine() const {
    return (dryFor > 0 ? "SCREW DRY " + fixed(dryFor, 1) + " s  " : "") + "SPD " + fixed(boat.getSpeed(), 1) +
           "  " + getTask() + "  LAP " + fixed(getLapTime(), 0) + "  THR " +
           fixed(100 * boat.getThrottle(), 0) + "%  STEER " + sided(boat.getSteering()) + "  TILT " +
           fixed(boat.getTilt() / DEGREE, 0) + "  TRIM " + fixed(pitchOf(boat.getBody()) / DEGREE, 0) +
           (course.getLaps() > 0 ? "  BEST " + fixed(course.getBestLap(), 1) : "");
}

std::string Race::getSummary() const {
    const std::string laps = course.getLaps() == 0 ? "no lap; " + nameOf(course.getNext()) + " was next"
                                                   : counted(course.getLaps(), "lap") + ", the best in " +
                                                         fixed(course.getBestLap(), 2) + " s";
    return "Course: " + laps + "\nRun: " + fixed(log.distance, 0) + " m in " + fixed(getTime(), 1) +
           " s, at " + fixed(log.topSpeed, 1) + " m/s at most\nJumps: " + std::to_string(log.jumps) +
           (log.jumps > 0 ? ", the longest " + fixed(log.longestJump, 2) + " s" : "") +
           "\nScrew dry: " + fixed(log.timeDry, 2) + " s\nCapsizes: " + std::to_string(log.capsizes);
}

}  // namespace speedboat
