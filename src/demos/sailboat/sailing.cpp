#include "sailboat/sailing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "sailboat/boat_parts.h"

namespace demo {

namespace {

using cyclone::REAL_PI;
using cyclone::Waves;

constexpr real DEGREE = REAL_PI / 180;
constexpr real CAPSIZED_FOR = 6;  // s, until the crew has righted her
constexpr real START_HEADING = -1.2, START_SPEED = 1;
enum ControlIndex : std::size_t { RUDDER, SAIL };
enum SettingIndex : std::size_t { WIND, GUSTS, WAVES };

const std::vector<Skipper::Mark> MARKS = {{"windward", 85, 5}, {"wing", 40, -60}, {"leeward", -15, -10}};
constexpr std::array<Colour, 3> MARK_COLOURS = {{{240, 120, 30}, {235, 200, 40}, {210, 60, 90}}};

/// A share of the waves' height, and how far their way turns from the wind's.
struct Swell {
    real share, wavelength, turn, phase;
};
constexpr std::array<Swell, 3> SWELLS = {{{0.5, 17, 0.15, 0}, {0.3, 10, -0.4, 2}, {0.2, 6.5, 0.6, 4}}};

constexpr Colour SAIL_FORCE{235, 90, 60}, RUDDER_FORCE{240, 200, 60}, LIFT{90, 170, 235};
constexpr real NEWTONS_PER_METRE = 250;

/// "12P"; an angle that shows as nought has no side.
std::string sided(real angle) {
    const std::string shown = fixed(std::fabs(angle) / DEGREE, 0);
    return shown + (shown == "0" ? "" : angle < 0 ? "P" : "S");
}

Profile makeProfile() {
    Profile profile;
    profile.program = "sailboat";
    profile.summary = "Sails a catamaran: with the keyboard in a terminal, otherwise by itself.";
    profile.settings = {
        {"wind", "SPEED", "Mean wind, from the north, m/s", 6, 0, 15},
        {"gusts", "SPEED", "How much the wind changes (root mean square), m/s", 0.8, 0, 5},
        {"waves", "HEIGHT", "Height of the waves, m; 0 is a calm sea", 0.3, 0, 1.5},
    };
    profile.controls = {
        {"rudder", -Catamaran::MAX_RUDDER / DEGREE, Catamaran::MAX_RUDDER / DEGREE, 0, 'a', 'd', 4, true},
        {"sail", -Catamaran::MAX_SAIL / DEGREE, Catamaran::MAX_SAIL / DEGREE, 0, 'q', 'e', 4, true},
    };
    profile.centre = 'w';
    profile.help = {
        "A D   rudder: turns the boat to port, to starboard",
        "Q E   sail: swings the boom to port, to starboard",
        "W     rudder and sail amidships",
        "",
        "Keep the boom to leeward, about half way between",
        "the stern and where the wind goes. Too close to the",
        "wind no sail draws: zigzag, and tack with way on.",
        "WIND is the wind felt on board. Numbers are metres",
        "per second and degrees, to Port or Starboard.",
    };
    profile.quantities = {
        {"boat speed", "m/s", "speed", 2},
        {"apparent wind", "m/s", "speed", 2},
        {"heel", "°", "heel", 1},
        {"sail", "°", "helm", 1},
        {"rudder", "°", "helm", 1},
        {"apparent wind angle", "°", "wind angle", 0},
        {"true wind angle", "°", "wind angle"},
        {"true wind", "m/s", ""},
        {"heading", "°", "", 0},
        {"leeway", "m/s", ""},
        {"trim", "°", ""},
        {"north", "m", "", 1},
        {"east", "m", "", 1},
        {"height", "m", ""},
    };
    profile.title = "A catamaran under sail";
    profile.kind = "sailing";
    profile.surroundings.sea = true;
    profile.parts = makeBoatParts();
    for (std::size_t n = 0; n < MARKS.size(); ++n)
        profile.parts.push_back(makeMark(MARKS[n].name + " mark", MARK_COLOURS[n]));
    profile.newtonsPerMetre = NEWTONS_PER_METRE;
    profile.outlook.spectator = Vector3(-16, 4, 20);
    profile.outlook.distance = 15;
    profile.outlook.height = 3.6;
    profile.outlook.windHeight = 8.6;
    profile.outlook.spectatorFollows = true;
    profile.duration = 150;
    return profile;
}

}  // namespace

const char *pointOfSail(real trueWindAngle) {
    const real degrees = std::fabs(trueWindAngle) / DEGREE;
    return degrees < 23    ? "in irons"
           : degrees < 65  ? "close hauled"
           : degrees < 115 ? "beam reach"
           : degrees < 155 ? "broad reach"
                           : "running";
}

/// Everything that a run changes.
struct Sailing::Voyage {
    cyclone::World world;
    Wind wind;
    Waves sea;
    Catamaran boat;
    Skipper skipper;
    unsigned long long steps = 0;
    unsigned long long capsizedSteps = 0;
    bool cut = true;               // the boat was put here; until a frame has told of it
    mutable bool hasTold = false;  // whether a frame has, since then

    // The log.
    real distance = 0, topSpeed = 0, mostHeel = 0;
    unsigned capsizes = 0;

    Voyage(const Wind &w) : wind(w), boat(&world, wind.getAddress(), &sea), skipper(MARKS) {}

    void putHere() {
        cut = true;
        hasTold = false;
    }
};

Sailing::Sailing() : profile(makeProfile()) {
    std::vector<real> settings;
    for (const Setting &setting : profile.settings) settings.push_back(setting.value);
    begin(0, settings);
}

Sailing::~Sailing() = default;

void Sailing::begin(std::uint64_t seed, const std::vector<real> &settings) {
    constexpr real MEMORY = 4;  // s
    voyage = std::make_unique<Voyage>(
        Wind(Vector3(settings.at(WIND), 0, 0), settings.at(GUSTS), MEMORY, profile.step, seed));
    setWaves(settings.at(WAVES));
    takeEvents();
    startOver();
}

/// From trough to crest, where all trains meet.
void Sailing::setWaves(real height) {
    profile.surroundings.waves.clear();
    if (height == 0) return;
    for (const Swell &swell : SWELLS) {
        const real downwind = REAL_PI + swell.turn;
        profile.surroundings.waves.push_back(
            {swell.share * height / 2, swell.wavelength, downwind, swell.phase});
        voyage->sea.addTrain({swell.share * height / 2, swell.wavelength, downwind, swell.phase});
    }
}

void Sailing::startOver() {
    resetControls();
    voyage->boat.launch(0, 0, START_HEADING, START_SPEED);
    voyage->skipper.startOver();
    voyage->capsizedSteps = 0;
    voyage->putHere();
}

void Sailing::steer() {
    Voyage &v = *voyage;
    applyControls();
    v.skipper.sail(v.boat, profile.step);
    setControl(RUDDER, v.boat.getRudder() / DEGREE);
    setControl(SAIL, v.boat.getSail() / DEGREE);
}

void Sailing::step() {
    Voyage &v = *voyage;
    if (v.hasTold) v.cut = false;
    applyControls();
    v.wind.advance();
    v.world.startFrame();
    v.world.runPhysics(profile.step);
    ++v.steps;
    v.sea.setTime(getTime());
    v.skipper.watch(v.boat, v.wind.getWindspeed(), profile.step);
    for (const std::string &report : v.skipper.takeReports()) tell(report);
    keepLog();
    rightIfCapsized();
}

void Sailing::applyControls() {
    voyage->boat.setRudder(getControl(RUDDER) * DEGREE);
    voyage->boat.setSail(getControl(SAIL) * DEGREE);
}

void Sailing::keepLog() {
    Voyage &v = *voyage;
    const Vector3 velocity = v.boat.getBody().getVelocity();
    v.distance += Vector3(velocity.x, 0, velocity.z).magnitude() * profile.step;
    v.topSpeed = std::max(v.topSpeed, v.boat.getSpeed());
    if (!v.boat.isCapsized()) v.mostHeel = std::max(v.mostHeel, std::fabs(v.boat.getHeel()));
}

void Sailing::rightIfCapsized() {
    Voyage &v = *voyage;
    if (!v.boat.isCapsized()) {
        v.capsizedSteps = 0;
        return;
    }
    if (v.capsizedSteps++ == 0) {
        ++v.capsizes;
        tell("capsized");
    }
    if (static_cast<real>(v.capsizedSteps) * profile.step < CAPSIZED_FOR) return;
    const Vector3 position = v.boat.getBody().getPosition();
    v.boat.launch(position.x, position.z, v.boat.getHeading());
    centreControls();
    v.capsizedSteps = 0;
    v.putHere();
    tell("righted");
}

bool Sailing::isOver() const { return voyage->skipper.isFinished(); }

real Sailing::getTime() const { return static_cast<real>(voyage->steps) * profile.step; }

const Catamaran &Sailing::getBoat() const { return voyage->boat; }

Frame Sailing::getFrame() const {
    Frame frame;
    frame.time = getTime();
    frame.poses = getBoatPoses(voyage->boat);
    for (const Skipper::Mark &mark : MARKS) {
        const Vector3 place(mark.x, 0, mark.z);
        frame.poses.push_back({place + Vector3::UP * voyage->sea.getHeight(place), Quaternion()});
    }
    frame.arrows = getArrows();
    frame.windspeed = voyage->wind.getWindspeed();
    frame.values = getValues();
    frame.cut = voyage->cut;
    voyage->hasTold = true;
    return frame;
}

std::vector<Arrow> Sailing::getArrows() const {
    const Catamaran &boat = voyage->boat;
    const auto arrow = [&](const char *name, const Vector3 &at, const Vector3 &force, Colour colour) {
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

std::vector<real> Sailing::getValues() const {
    const Catamaran &boat = voyage->boat;
    const Vector3 position = boat.getBody().getPosition(), wind = voyage->wind.getWindspeed();
    return {boat.getSpeed(),
            boat.getApparentWindSpeed(),
            boat.getHeel() / DEGREE,
            boat.getSail() / DEGREE,
            boat.getRudder() / DEGREE,
            boat.getApparentWindAngle() / DEGREE,
            boat.getTrueWindAngle() / DEGREE,
            wind.magnitude(),
            compassDegrees(boat.getHeading()),
            boat.getLeeway(),
            boat.getTrim() / DEGREE,
            position.x,
            position.z,
            position.y};
}

std::string Sailing::getHeadUpLine() const {
    const Catamaran &boat = voyage->boat;
    if (boat.isCapsized()) return "capsized: the crew rights her in a moment";
    return "HDG " + compassText(boat.getHeading()) + "  SPD " + fixed(boat.getSpeed(), 1) + "  " +
           pointOfSail(boat.getTrueWindAngle()) + "  WIND " + fixed(boat.getApparentWindSpeed(), 1) + "/" +
           sided(boat.getApparentWindAngle()) + "  HEEL " + sided(boat.getHeel()) + "  SAIL " +
           sided(boat.getSail()) + "  RUD " + sided(boat.getRudder());
}

std::string Sailing::getSummary() const {
    const Voyage &v = *voyage;
    const auto count = [](unsigned long long n, const std::string &what) {
        return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
    };
    const real time = getTime();
    return "Sailed: " + fixed(v.distance, 0) + " m in " + fixed(time, 1) +
           " s\nSpeed: " + fixed(time > 0 ? v.distance / time : 0, 1) + " m/s on average, " +
           fixed(v.topSpeed, 1) + " m/s at best\nHeel: " + fixed(v.mostHeel / DEGREE, 0) +
           "° at most\nManoeuvres: " + count(v.skipper.getTacks(), "tack") + ", " +
           count(v.skipper.getGybes(), "gybe") + ", " + count(v.skipper.getRounded(), "mark") +
           " rounded\nCapsizes: " + std::to_string(v.capsizes);
}

std::uint64_t Sailing::getHash() const { return voyage->world.hash(); }

}  // namespace demo
