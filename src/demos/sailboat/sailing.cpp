#include "sailboat/sailing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angle.h"
#include "base/text.h"
#include "models/attitude.h"
#include "models/sea.h"
#include "picture/solids.h"
#include "sailboat/boat_parts.h"

namespace sailboat {

namespace {

using cyclone::REAL_PI;

constexpr real DEGREE = REAL_PI / 180;
constexpr real CAPSIZED_FOR = 6;  // s, until the crew has righted her
constexpr real GUST_MEMORY = 4;   // s
constexpr real IRONS_FOR = 2;     // s, until it is told
constexpr real HEAD_TO_WIND = 20 * DEGREE;
constexpr real WELL_TRIMMED = 6 * DEGREE;  // off the best angle, where next to nothing is lost
constexpr real START_HEADING = -1.2, START_SPEED = 1;

const std::vector<Skipper::Mark> MARKS = {{"windward", 85, 5}, {"wing", 40, -60}, {"leeward", -15, -10}};
constexpr std::array<Colour, 3> MARK_COLOURS = {{{240, 120, 30}, {235, 200, 40}, {210, 60, 90}}};

constexpr Colour SAIL_FORCE{235, 90, 60}, RUDDER_FORCE{240, 200, 60}, LIFT{90, 170, 235};
constexpr real NEWTONS_PER_METRE = 250;

Scene makeScene() {
    Scene scene;
    scene.surroundings.terrain = Terrain::SEA;
    scene.bodies = {{makeBoatParts(), true, false}};
    for (std::size_t n = 0; n < MARKS.size(); ++n)
        scene.bodies.push_back({{makeBuoy(MARKS[n].name + " mark", MARK_COLOURS[n])}, false, false});
    scene.bodies.push_back({{makeBuoyPointer("next mark")}, false, false});
    scene.newtonsPerMetre = NEWTONS_PER_METRE;
    scene.cameras.spectator = Vector3(-16, 4, 20);
    scene.cameras.spectatorFollows = true;
    scene.cameras.distance = 15;
    scene.cameras.height = 3.6;
    scene.cameras.windHeight = 8.6;
    return scene;
}

}  // namespace

const char *pointOfSail(real apparentWindAngle) {
    if (std::fabs(apparentWindAngle) < HEAD_TO_WIND) return "head to wind";
    const real degrees = std::fabs(apparentWindAngle) / DEGREE;
    return degrees < 45    ? "close hauled"
           : degrees < 75  ? "close reach"
           : degrees < 105 ? "beam reach"
           : degrees < 155 ? "broad reach"
                           : "running";
}

const char *trimHint(real apparentWindAngle, real boomAngle) {
    if (std::fabs(apparentWindAngle) < HEAD_TO_WIND) return "fall off";
    // A flat sail drives best where it meets the wind at half the wind's angle off the bow.
    const real meetsWindAt = std::fabs(apparentWindAngle) - std::fabs(boomAngle);
    const real tooMuch = meetsWindAt - std::fabs(apparentWindAngle) / 2;
    return tooMuch > WELL_TRIMMED ? "ease" : tooMuch < -WELL_TRIMMED ? "sheet in" : "well trimmed";
}

Sailing::Sailing() : boat(world, wind.getAddress(), &sea), skipper(MARKS) {
    fillProfile();
    scene = makeScene();
    begin(0);
}

void Sailing::fillProfile() {
    profile.program = "sailboat";
    profile.summary = "Sails a catamaran: with the keyboard in a terminal, otherwise by itself.";
    profile.settings = {
        {"wind", "SPEED", "Mean wind, from the north, m/s", 6, 0, 15},
        {"gusts", "SPEED", "How much the wind changes (root mean square), m/s", 0.8, 0, 5},
        {"waves", "HEIGHT", "Height of the waves, m; 0 is a calm sea", 0.3, 0, 1.5},
    };
    profile.controls = {
        {"rudder", -Catamaran::MAX_RUDDER / DEGREE, Catamaran::MAX_RUDDER / DEGREE, 0, 'a', 'd', 4, true},
        {"sheet", 0, Catamaran::MAX_SHEET / DEGREE, 30, 'q', 'e', 4, false},
        {"boom", -1, 1, 0, 'z', 'x', 1, true},
    };
    profile.centre = 'w';
    profile.help = {
        "A D   rudder: turns the boat to port, to starboard",
        "Q E   sheet: in, out; the wind swings the boom",
        "Z X   hold the boom out to port, to starboard",
        "W     rudder amidships, boom let go",
        "",
        "Ease until the sail flaps, then haul in half way.",
        "Nobody sails straight upwind: zigzag, and tack with",
        "way on. In irons (stopped, head to wind): boom to one",
        "side, rudder to the other, until she falls off; W.",
        "WIND as felt on board, and the next MARK: m/s, m and",
        "degrees, to Port or Starboard. An arrow hangs over it.",
    };
    profile.quantities = {
        {"boat speed", "m/s", [this] { return boat.getSpeed(); }, "speed", 2},
        {"apparent wind", "m/s", [this] { return boat.getApparentWindSpeed(); }, "speed", 2},
        {"heel", "°", [this] { return boat.getHeel() / DEGREE; }, "heel", 1},
        {"sail", "°", [this] { return boat.getSail() / DEGREE; }, "helm", 1},
        {"rudder", "°", [this] { return boat.getRudder() / DEGREE; }, "helm", 1},
        {"apparent wind angle", "°", [this] { return boat.getApparentWindAngle() / DEGREE; }, "wind angle",
         0},
        {"true wind angle", "°", [this] { return boat.getTrueWindAngle() / DEGREE; }, "wind angle"},
        {"true wind", "m/s", [this] { return wind.getWindspeed().magnitude(); }},
        {"heading", "°", [this] { return compassDegrees(boat.getHeading()); }, "", 0},
        {"leeway", "m/s", [this] { return boat.getLeeway(); }},
        {"trim", "°", [this] { return boat.getTrim() / DEGREE; }},
        {"north", "m", [this] { return boat.getBody().getPosition().x; }, "", 1},
        {"east", "m", [this] { return boat.getBody().getPosition().z; }, "", 1},
        {"height", "m", [this] { return boat.getBody().getPosition().y; }},
        {"sheet", "°", [this] { return boat.getSheet() / DEGREE; }},
        {"lap", "s", [this] { return getLapTime(); }},
    };
    profile.title = "A catamaran under sail";
    profile.kind = "sailing";
    profile.duration = 150;
}

void Sailing::prepare(std::uint64_t seed, const std::vector<real> &settings) {
    wind = Wind(Vector3(settings.at(WIND), 0, 0), settings.at(GUSTS), GUST_MEMORY, profile.step, seed);
    setWaves(settings.at(WAVES));
    skipper = Skipper(MARKS);
    log = Log();
}

void Sailing::setWaves(real height) {
    scene.surroundings.waves = makeSea(height, REAL_PI);
    sea = cyclone::Waves();
    for (const cyclone::Waves::Train &train : scene.surroundings.waves) sea.addTrain(train);
}

void Sailing::launch() {
    boat.launch(0, 0, START_HEADING, START_SPEED);
    skipper.startOver();
    capsizedSteps = ironsSteps = 0;
    lapStart = lapEnd = getTime();
}

void Sailing::steer() {
    applyControls();
    skipper.sail(boat, profile.step);
    setControl(RUDDER, boat.getRudder() / DEGREE);
    setControl(SHEET, boat.getSheet() / DEGREE);
    setControl(BOOM, boat.getHeldSide());
}

void Sailing::beforeStep() {
    applyControls();
    wind.advance();
    boat.swingBoom(profile.step);
}

void Sailing::afterStep() {
    sea.setTime(getTime());
    skipper.watch(boat, wind.getWindspeed(), profile.step);
    for (const std::string &report : skipper.takeReports()) tell(report);
    keepLog();
    watchForIrons();
    rightIfCapsized();
}

void Sailing::applyControls() {
    boat.setRudder(getControl(RUDDER) * DEGREE);
    boat.setSheet(getControl(SHEET) * DEGREE);
    boat.holdBoom(getControl(BOOM));
}

void Sailing::keepLog() {
    const Vector3 velocity = boat.getBody().getVelocity();
    log.distance += horizontalLength(velocity) * profile.step;
    log.topSpeed = std::max(log.topSpeed, boat.getSpeed());
    log.mostHeel = std::max(log.mostHeel, std::fabs(boat.getHeel()));
    if (skipper.isFinished() && lapEnd == lapStart) {
        lapEnd = getTime();
        log.bestLap = log.laps++ == 0 ? getLapTime() : std::min(log.bestLap, getLapTime());
        tell("round the course in " + fixed(getLapTime(), 1) + " s");
    }
}

void Sailing::watchForIrons() {
    ironsSteps = boat.isInIrons() ? ironsSteps + 1 : 0;
    if (ironsSteps == static_cast<std::uint64_t>(IRONS_FOR / profile.step)) tell("in irons");
}

real Sailing::getLapTime() const { return (lapEnd > lapStart ? lapEnd : getTime()) - lapStart; }

void Sailing::rightIfCapsized() {
    if (!boat.isCapsized()) {
        capsizedSteps = 0;
        return;
    }
    if (capsizedSteps++ == 0) {
        ++log.capsizes;
        tell("capsized");
    }
    if (static_cast<real>(capsizedSteps) * profile.step < CAPSIZED_FOR) return;
    const Vector3 position = boat.getBody().getPosition();
    boat.launch(position.x, position.z, boat.getHeading());
    centreControls();
    setControl(SHEET, Catamaran::MAX_SHEET / DEGREE);  // let fly
    capsizedSteps = 0;
    markCut();
    tell("righted");
}

std::vector<Pose> Sailing::getPoses() const {
    std::vector<Pose> poses = getBoatPoses(boat);
    const auto afloat = [this](const Skipper::Mark &mark) {
        const Vector3 place(mark.x, 0, mark.z);
        return Pose{place + Vector3::UP * sea.getHeight(place), Quaternion()};
    };
    for (const Skipper::Mark &mark : MARKS) poses.push_back(afloat(mark));
    const Skipper::Mark *next = skipper.getNextMark();
    poses.push_back(next ? afloat(*next) : NOWHERE);
    return poses;
}

std::vector<Arrow> Sailing::getArrows() const {
    const auto arrow = [this](const char *name, const Vector3 &at, const Vector3 &force, Colour colour) {
        return Arrow{name, boat.getBody().getPointInWorldSpace(at), force * (1 / NEWTONS_PER_METRE), colour};
    };
    return {
        arrow("sail", boat.getSailCentre(), boat.getSailForce(), SAIL_FORCE),
        arrow("rudder", boat.getRudderCentre(), boat.getRudderForce(), RUDDER_FORCE),
        arrow("port aft", Catamaran::getHullCentre(0), boat.getBuoyancy(0), LIFT),
        arrow("port fore", Catamaran::getHullCentre(1), boat.getBuoyancy(1), LIFT),
        arrow("starboard aft", Catamaran::getHullCentre(2), boat.getBuoyancy(2), LIFT),
        arrow("starboard fore", Catamaran::getHullCentre(3), boat.getBuoyancy(3), LIFT),
    };
}

/// The point of sail, what the sheet needs and where the mark is, or what is wrong and what helps.
std::string Sailing::getAdvice() const {
    if (boat.isInIrons())
        return std::string("in irons: boom to ") + (boat.getTrueWindAngle() > 0
                                                        ? "port (Z), rudder to starboard (D)"
                                                        : "starboard (X), rudder to port (A)");
    const real angle = boat.getApparentWindAngle();
    return std::string(pointOfSail(angle)) + "  SHEET " + fixed(boat.getSheet() / DEGREE, 0) + " " +
           (boat.getHeldSide() != 0 ? "boom held (W)" : trimHint(angle, boat.getSail())) + getCourse();
}

/// Where the next mark is, off the bow.
std::string Sailing::getCourse() const {
    const Skipper::Mark *mark = skipper.getNextMark();
    if (!mark) return "";
    return "  MARK " + whereabouts(boat.getBody(), Vector3(mark->x, 0, mark->z));
}

std::string Sailing::getHeadUpLine() const {
    if (boat.isCapsized()) return "capsized: the crew rights her in a moment";
    return "SPD " + fixed(boat.getSpeed(), 1) + "  WIND " + fixed(boat.getApparentWindSpeed(), 0) + "/" +
           sided(boat.getApparentWindAngle()) + "  " + getAdvice() + "  RUD " + sided(boat.getRudder()) +
           "  LAP " + fixed(getLapTime(), 0) + "  HEEL " + sided(boat.getHeel()) + "  HDG " +
           compassText(boat.getHeading());
}

std::string Sailing::getSummary() const {
    const real time = getTime();
    const Skipper::Mark *mark = skipper.getNextMark();
    return "Sailed: " + fixed(log.distance, 0) + " m in " + fixed(time, 1) +
           " s\nSpeed: " + fixed(time > 0 ? log.distance / time : 0, 1) + " m/s on average, " +
           fixed(log.topSpeed, 1) + " m/s at best\nHeel: " + fixed(log.mostHeel / DEGREE, 0) +
           "° at most\nManoeuvres: " + counted(skipper.getTacks(), "tack") + ", " +
           counted(skipper.getGybes(), "gybe") + ", " + counted(skipper.getRounded(), "mark") +
           " rounded\nCapsizes: " + std::to_string(log.capsizes) + "\nCourse: " + counted(log.laps, "lap") +
           (log.laps > 0 ? ", the best in " + fixed(log.bestLap, 1) + " s" : "") +
           (mark ? "; the " + mark->name + " mark is next, " + fixed(getLapTime(), 1) + " s after the start"
                 : "");
}

}  // namespace sailboat
