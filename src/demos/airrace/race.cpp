#include "airrace/race.h"

#include <algorithm>

#include "airrace/parts.h"
#include "base/angle.h"
#include "base/text.h"
#include "picture/solids.h"

namespace airrace {

namespace {

constexpr real DEGREE = cyclone::REAL_PI / 180;
constexpr real STALL_MEMORY = 4;  // s: what hits the ground so soon after a stall has fallen
constexpr real NEWTONS_PER_METRE = 4000;
constexpr Colour LIFT{255, 214, 64}, THRUST{255, 120, 90};
const char *const FORCE_NAMES[] = {"port wing", "starboard wing", "tailplane", "fin", "thrust"};

}  // namespace

Race::Race(const std::string &name)
    : aircraft(Aircraft::make(name, world, &weather)), marshal(getCourse(), aircraft->getModel().span / 2) {
    fillProfile();
    fillScene();
    begin(1);
}

void Race::fillProfile() {
    profile.program = "airrace";
    profile.variant = "aircraft " + aircraft->getModel().name;
    profile.summary = "Races through hoops: with the keyboard in a terminal, otherwise by itself.";
    profile.settings = {
        {"wind", "SPEED", "Mean wind 10 m above the ground, m/s", 3, 0, 8},
        {"from", "DEGREES", "Where the wind comes from; the race starts towards 0", 40, 0, 360},
        {"gusts", "SPEED", "How much the air heaves (root mean square), m/s", 0.5, 0, 1}};
    profile.controls = {{"bank", -80, 80, 0, 'a', 'd', 10, true},
                        {"climb", -30, 30, 0, 'w', 's', 5, true},
                        {"throttle", 0, 1, 1, '-', '+', 0.1, false}};
    profile.help = {"A D      bank left, right: the aircraft turns",
                    "S W      climb, descend",
                    "X        wings level, neither climb nor descent",
                    "+ -      throttle",
                    "",
                    "Fly through the orange hoop, then the yellow one;",
                    "the arrow above you points to it, HOOP tells how far,",
                    "how many degrees to Port or Starboard, how much up.",
                    "The pale aircraft is the best lap. The swallow",
                    "stalls in steep turns when it is slow."};
    const RigidBody &body = aircraft->getBody();
    const auto orderedBank = [this] { return getControl(BANK); };
    const auto orderedClimb = [this] { return getControl(CLIMB); };
    profile.quantities = {
        {"x", "m", [&] { return body.getPosition().x; }, "", 0},
        {"height", "m", [&] { return body.getPosition().y; }, "height", 0},
        {"z", "m", [&] { return body.getPosition().z; }, "", 0},
        {"airspeed", "m/s", [this] { return aircraft->getAirspeed(); }, "speed", 1},
        {"bank", "°", [&] { return bankOf(body) / DEGREE; }, "bank", 0},
        {"bank wanted", "°", orderedBank, "bank", 0},
        {"climb", "°", [this] { return aircraft->getClimbAngle() / DEGREE; }, "climb", 0},
        {"climb wanted", "°", orderedClimb, "climb", 0},
        {"load", "g",
         [&] {
             return (body.getLastFrameAcceleration() - Vector3::GRAVITY) *
                    body.getTransform().getAxisVector(1) / 9.81;
         },
         "load", 1},
        {"throttle", "", [this] { return aircraft->getSticks().throttle; }, "sticks", 1},
        {"elevator", "", [this] { return aircraft->getSticks().elevator; }, "sticks"},
        {"aileron", "", [this] { return aircraft->getSticks().aileron; }, "sticks"},
        {"hoop", "", [this] { return static_cast<real>(marshal.getNext() + 1); }, "", 0},
        {"lap", "s", [this] { return getLapClock().value_or(0); }, "", 1},
        {"stalled", "", [this] { return aircraft->isStalled() ? 1.0 : 0.0; }},
        {"wind x", "m/s", [this] { return getWindspeed().x; }},
        {"wind y", "m/s", [this] { return getWindspeed().y; }},
        {"wind z", "m/s", [this] { return getWindspeed().z; }},
    };
    profile.archive = {
        "best", "Keep the best lap of each aircraft in this file, for the ghost",
        [this](const std::string &text) { kept = best = BestLaps::read(text, Aircraft::NAMES); },
        [this]() -> std::optional<std::string> {
            const Lap *now = getBestLap(), *then = kept.find(aircraft->getModel().name);
            if (!now || (then && then->time <= now->time)) return std::nullopt;
            return best.getText();
        }};
    profile.title = "Air race: the " + aircraft->getModel().name;
    profile.kind = "flight";
    profile.step = 1.0 / 60;
    profile.duration = 300;
}

void Race::fillScene() {
    const Model &model = aircraft->getModel();
    const std::vector<Hoop> &course = getCourse();
    scene.bodies = {{{makeAircraftPart(model)}, true, false},
                    {{makePointer()}, false, false},
                    {{makeNextMarker(course.front().radius)}, false, false},
                    {{makeSecondMarker(course.front().radius)}, false, false},
                    {{makeSmoke()}, false, false},
                    {{makeGhostPart(model)}, false, true}};
    scene.fixtures = makeHoops(course);
    scene.paint = paintStartLine(course.front());
    scene.newtonsPerMetre = NEWTONS_PER_METRE;
    scene.cameras.spectator = Vector3(-30, 12, -40);
    scene.cameras.spectatorFollows = true;
    scene.cameras.distance = 17;
    scene.cameras.height = 1;
    scene.cameras.windHeight = 5;
}

void Race::prepare(std::uint64_t seed, const std::vector<real> &settings) {
    const Vector3 windFrom = towardsBearing(settings.at(WIND_DIRECTION) * DEGREE) * settings.at(WIND_SPEED);
    weather = Weather(seed, windFrom, settings.at(GUSTS));
    marshal = Marshal(getCourse(), aircraft->getModel().span / 2);
    best = kept;
    laps.clear();
    crashes = 0;
}

void Race::launch() {
    aircraft->launch(getStart());
    stabiliser = Stabiliser();
    pilot = Pilot();
    marshal.startOver();
    sinceStart.clear();
    lastStalled = -STALL_MEMORY;
}

void Race::steer() {
    const Command command = pilot.fly(*aircraft, getCourse()[marshal.getNext()]);
    setControl(BANK, command.bank / DEGREE);
    setControl(CLIMB, command.climb / DEGREE);
    setControl(THROTTLE, command.throttle);
}

void Race::beforeStep() {
    before = getPose();
    const Command command{getControl(BANK) * DEGREE, getControl(CLIMB) * DEGREE, getControl(THROTTLE)};
    aircraft->setSticks(stabiliser.hold(*aircraft, command, profile.step));
    weather.advance(aircraft->getVelocityThroughAir(), before.position.y, profile.step);
}

void Race::afterStep() {
    if (aircraft->isStalled()) {
        if (getTime() - lastStalled > STALL_MEMORY) tell("stalled: less bank, nose down");
        lastStalled = getTime();
    }
    watchTheHoops();
    watchTheGround();
}

void Race::watchTheHoops() {
    const Pose now = getPose();
    const real time = getTime();
    const std::optional<real> lastStart = marshal.getLapStart();
    const std::optional<real> lap = marshal.watch(before.position, now.position, time, profile.step);
    for (const std::string &report : marshal.takeReports()) tell(report);
    if (lap) endLap(*lap, now);
    if (marshal.getLapStart() != lastStart) recorder.start(*marshal.getLapStart());
    if (marshal.getLapStart()) recorder.add(before, now, time, profile.step);
}

void Race::endLap(real lapTime, const Pose &now) {
    const Lap *last = getBestLap();
    const bool isBest = !last || lapTime < last->time;
    tell("lap " + std::to_string(laps.size() + 1) + ": " + fixed(lapTime, 3) + " s" +
         (!last    ? ""
          : isBest ? ", the best so far"
                   : ", " + fixed(lapTime - last->time, 3) + " s behind the best"));
    laps.push_back(lapTime);
    sinceStart.push_back(lapTime);
    const Lap lap = recorder.finish(lapTime, before, now, getTime(), profile.step);
    if (isBest) best.set(aircraft->getModel().name, lap);
}

void Race::watchTheGround() {
    const RigidBody &body = aircraft->getBody();
    if (!body.hasFaulted() && !aircraft->touchesGround()) return;
    ++crashes;
    const std::string how = body.hasFaulted()                        ? "broke up"
                            : getTime() - lastStalled < STALL_MEMORY ? "stalled, and fell to the ground"
                                                                     : "flew into the ground";
    wreckBy("crashed: " + how + " at " + fixed(aircraft->getAirspeed(), 0) + " m/s");
}

Pose Race::getPose() const {
    const RigidBody &body = aircraft->getBody();
    return {body.getPosition(), body.getOrientation()};
}

std::optional<real> Race::getLapClock() const {
    const std::optional<real> start = marshal.getLapStart();
    return start ? std::optional<real>(getTime() - *start) : std::nullopt;
}

std::optional<Pose> Race::getGhost() const {
    const std::optional<real> clock = getLapClock();
    const Lap *lap = getBestLap();
    if (!clock || !lap || *clock > lap->time) return std::nullopt;
    return lap->getPose(*clock);
}

std::vector<Pose> Race::getPoses() const {
    const std::vector<Hoop> &course = getCourse();
    const Hoop &next = course[marshal.getNext()], &second = course[(marshal.getNext() + 1) % course.size()];
    const Pose pose = getPose();
    const Pose smoke = {Vector3(pose.position.x, 0, pose.position.z), cyclone::Quaternion()};
    return {pose,
            !getWreck().empty() ? NOWHERE : posePointer(pose, next.centre),
            poseMarker(next),
            poseMarker(second),
            getWreck().empty() ? NOWHERE : smoke,
            getGhost().value_or(NOWHERE)};
}

std::vector<Arrow> Race::getArrows() const {
    const RigidBody &body = aircraft->getBody();
    std::vector<Arrow> arrows;
    std::size_t n = 0;
    for (const cyclone::PointForce *force : aircraft->getForces()) {
        arrows.push_back({FORCE_NAMES[n], body.getPointInWorldSpace(force->getPosition()),
                          force->getForce(body) * (1 / NEWTONS_PER_METRE), n == 4 ? THRUST : LIFT});
        ++n;
    }
    return arrows;
}

Vector3 Race::getWindspeed() const { return -weather.getVelocity(aircraft->getBody().getPosition()); }

std::string Race::describeNextHoop() const {
    const std::size_t next = marshal.getNext();
    const RigidBody &body = aircraft->getBody();
    const Vector3 &centre = getCourse()[next].centre;
    return "HOOP " + std::to_string(next + 1) + "/" + std::to_string(getCourse().size()) + " " +
           whereabouts(body, centre) + " " + signedFixed(centre.y - body.getPosition().y, 0);
}

std::string Race::getHeadUpLine() const {
    const std::optional<real> clock = getLapClock();
    const Lap *lap = getBestLap();
    return describeNextHoop() + "  LAP " + (clock ? fixed(*clock, 1) : "-") + "  BEST " +
           (lap ? fixed(lap->time, 2) : "-") + (aircraft->isStalled() ? "  STALL" : "") + "  BANK " +
           signedFixed(getControl(BANK), 0) + "  CLIMB " + signedFixed(getControl(CLIMB), 0) + "  SPD " +
           fixed(aircraft->getAirspeed(), 0) + " ALT " + fixed(aircraft->getBody().getPosition().y, 0) +
           "  THR " + fixed(100 * getControl(THROTTLE), 0) + "%";
}

std::string Race::getSummary() const {
    std::string text = "Laps of the " + aircraft->getModel().name + ": " + std::to_string(laps.size());
    for (std::size_t n = 0; n < laps.size(); ++n) text += (n == 0 ? ", in " : ", ") + fixed(laps[n], 3);
    if (!laps.empty()) text += " s";
    if (const Lap *lap = getBestLap()) text += "\nBest lap: " + fixed(lap->time, 3) + " s";
    text += "\nHoops: " + std::to_string(marshal.getPassed()) + " passed, " +
            std::to_string(marshal.getMissed()) + " missed\nCrashes: " + std::to_string(crashes);
    return text;
}

}  // namespace airrace
