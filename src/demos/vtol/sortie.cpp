#include "vtol/sortie.h"

#include <algorithm>

#include "base/angle.h"
#include "base/text.h"
#include "models/hull.h"
#include "picture/solids.h"
#include "picture/windsock.h"
#include "vtol/parts.h"

namespace vtol {

namespace {

constexpr real DEGREE = cyclone::REAL_PI / 180;
constexpr real NEWTONS_PER_METRE = 2500;                 // of the force arrows
constexpr real ON_HER_WINGS = 0.9, OFF_HER_WINGS = 0.3;  // of the weight
constexpr Colour LIFT_COLOUR{255, 214, 64}, PUSH_COLOUR{255, 120, 90}, PUFF_COLOUR{150, 220, 255};
const char *const SURFACE_NAMES[] = {"port wing", "starboard wing", "tailplane", "fin"};
const char *const NOZZLE_NAMES[] = {"port nozzles", "starboard nozzles"};
const char *const PUFFER_NAMES[] = {"nose puffer",      "tail puffer",    "port puffer",
                                    "starboard puffer", "puffer to port", "puffer to starboard"};

Scene makeScene() {
    Scene scene;
    scene.bodies = {{makeJetParts(), true, false}, {{makeSmoke()}, false, false}};
    for (std::size_t n = 0; n < PADS.size(); ++n) scene.bodies.push_back({makeWindsockParts(), false, false});
    scene.paint = paintPads();
    scene.newtonsPerMetre = NEWTONS_PER_METRE;
    scene.cameras.spectator = Vector3(-16, 5, -18);
    scene.cameras.spectatorFollows = true;
    scene.cameras.distance = 17;
    scene.cameras.windHeight = 4;
    return scene;
}

Arrow makeArrow(const char *name, const cyclone::PointForce &force, const RigidBody &body, Colour colour) {
    return {name, body.getPointInWorldSpace(force.getPosition()),
            force.getForce(body) * (1 / NEWTONS_PER_METRE), colour};
}

}  // namespace

Sortie::Sortie() : jet(world, &weather) {
    fillProfile();
    scene = makeScene();
    begin(1);
}

void Sortie::fillProfile() {
    profile.program = "vtol";
    profile.summary =
        "Flies a jet that takes off straight up: with the keyboard in a terminal, otherwise by itself.";
    profile.settings = {
        {"wind", "SPEED", "Mean wind 10 m above the ground, m/s", 3, 0, 8},
        {"from", "DEGREES", "Where the wind comes from; she stands pointing to 0", 30, 0, 360},
        {"gusts", "SPEED", "How much the air heaves (root mean square), m/s", 0.4, 0, 1}};
    profile.controls = {
        {"pitch", -1, 1, 0, 'w', 's', 0.1, true, true},  {"roll", -1, 1, 0, 'a', 'd', 0.1, true, true},
        {"pedals", -1, 1, 0, 'q', 'e', 0.1, true, true}, {"throttle", 0, 1, 0, '-', '+', 0.05, false},
        {"nozzles", 0, 100, 90, 'm', 'n', 10, false},    {"stabiliser", 0, 1, 1, 'o', 'i', 1, false}};
    profile.help = {"+ -      throttle; in the hover 80% carries her",
                    "N M      nozzles down, aft: 90° lifts, 0° drives",
                    "W S      nose down, up",
                    "A D      bank to port, to starboard",
                    "Q E      turn to port, to starboard",
                    "X        centre sticks and pedals",
                    "I O      stabiliser in, out",
                    "",
                    "Up with the throttle. Then M, M, M: she speeds up,",
                    "and the wings take over (WING 100%) above 35 m/s.",
                    "Back with N, N, N, well before the pad (PAD), and",
                    "down on the H. Less throttle as the wings lift,",
                    "more as they let go. The stabiliser keeps the",
                    "attitude that the sticks ask for, and when she is",
                    "slow leans against drift and damps rise and fall;",
                    "without it the sticks move puffers and flaps."};
    const RigidBody &body = jet.getBody();
    profile.quantities = {
        {"x", "m", [&] { return body.getPosition().x; }, "", 0},
        {"height", "m", [this] { return jet.getHeight(); }, "height", 1},
        {"z", "m", [&] { return body.getPosition().z; }, "", 0},
        {"airspeed", "m/s", [this] { return jet.getAirspeed(); }, "speed", 1},
        {"climb", "m/s", [&] { return body.getVelocity().y; }, "climb", 1},
        {"nozzles", "°", [this] { return jet.getNozzles() / DEGREE; }, "nozzles", 0},
        {"thrust", "N", [this] { return jet.getThrust(); }, "lift", 0},
        {"wings lift", "N", [this] { return jet.getAirForce().y; }, "lift", 0},
        {"heading", "°", [&] { return compassDegrees(headingOf(body)); }, "", 0},
        {"pitch", "°", [&] { return pitchOf(body) / DEGREE; }, "attitude", 0},
        {"bank", "°", [&] { return bankOf(body) / DEGREE; }, "attitude", 0},
        {"stick to and fro", "", [this] { return jet.getControls().pitch; }, "controls"},
        {"stick to starboard", "", [this] { return jet.getControls().roll; }, "controls"},
        {"pedals", "", [this] { return jet.getControls().pedal; }, "controls"},
        {"throttle", "", [this] { return jet.getControls().throttle; }, "controls", 2},
        {"stabiliser", "", [this] { return isStabilised() ? 1.0 : 0.0; }},
        {"angle of attack", "°", [this] { return jet.getAngleOfAttack() / DEGREE; }},
        {"wind x", "m/s", [this] { return getWindspeed().x; }},
        {"wind y", "m/s", [this] { return getWindspeed().y; }},
        {"wind z", "m/s", [this] { return getWindspeed().z; }},
    };
    profile.title = "A jump jet between two pads";
    profile.kind = "flight";
    profile.step = 1.0 / 60;
    profile.duration = 300;
}

void Sortie::prepare(std::uint64_t seed, const std::vector<real> &settings) {
    windFrom = towardsBearing(settings.at(WIND_DIRECTION) * DEGREE) * settings.at(WIND_SPEED);
    weather = Weather(seed, windFrom, settings.at(GUSTS));
    landings.clear();
    log = LandingLog();
    crashes = transitions = 0;
}

void Sortie::launch() {
    lastPad = 0;
    jet.park(PADS[lastPad].centre);
    pilot = Pilot(lastPad, 1 - lastPad, windFrom);
    lastLeg = pilot.getLeg();
    lastSteered = getTime();
    airborne = wingborne = false;
    stabilised = true;
}

void Sortie::steer() {
    if (getTime() - lastSteered > 1.5 * profile.step) {  // somebody else has flown
        pilot = Pilot(lastPad, 1 - lastPad, windFrom);
        pilot.takeOver(jet);
    }
    lastSteered = getTime();
    const JetControls wanted = pilot.fly(jet, profile.step);
    setControl(PITCH, wanted.pitch);
    setControl(ROLL, wanted.roll);
    setControl(PEDALS, wanted.pedal);
    setControl(THROTTLE, wanted.throttle);
    setControl(NOZZLES, wanted.nozzles / DEGREE);
    setControl(STABILISER, 1);
    if (pilot.getLeg() == lastLeg) return;
    lastLeg = pilot.getLeg();
    tell(Pilot::getName(lastLeg));
}

JetControls Sortie::readControls() const {
    return {getControl(PITCH), getControl(ROLL), getControl(PEDALS), getControl(THROTTLE),
            getControl(NOZZLES) * DEGREE};
}

void Sortie::beforeStep() {
    const JetControls asked = readControls();
    jet.setControls(isStabilised() ? Stabiliser::hold(jet, asked) : asked);
    jet.advance(profile.step);
    weather.advance(jet.getVelocityThroughAir(), jet.getHeight(), profile.step);
    lastVelocity = jet.getBody().getVelocity();
}

void Sortie::afterStep() {
    watchTheStabiliser();
    watchTheWings();
    watchTheGround();
}

void Sortie::watchTheStabiliser() {
    if (isStabilised() == stabilised) return;
    stabilised = !stabilised;
    tell(stabilised ? "stabiliser in: sticks ask for attitudes, she leans against drift"
                    : "stabiliser out: the sticks move puffers and flaps");
}

void Sortie::watchTheWings() {
    if (!wingborne && getWingborne() > ON_HER_WINGS && jet.getNozzles() < 10 * DEGREE) {
        wingborne = true;
        ++transitions;
        tell("the wings carry her at " + fixed(jet.getAirspeed(), 0) + " m/s");
    } else if (wingborne && getWingborne() < OFF_HER_WINGS && jet.getNozzles() > 60 * DEGREE) {
        wingborne = false;
        tell("the engine carries her again at " + fixed(jet.getAirspeed(), 0) + " m/s");
    }
}

void Sortie::watchTheGround() {
    const RigidBody &body = jet.getBody();
    const std::string broken = jet.getBrokenPart();
    if (body.hasFaulted() || !broken.empty()) return crash(describeCrash(broken, body, lastVelocity));
    if (airborne && jet.isOnGround()) {
        touchDown();
    } else if (!airborne && jet.getHeight() > 1.5) {
        airborne = true;
    }
}

void Sortie::touchDown() {
    airborne = false;
    const Landing landing = measureLanding(jet.getBody(), lastVelocity);
    if (landing.sinkRate > HARDEST_TOUCH_DOWN)
        return crash("crashed: touched down at " + fixed(landing.sinkRate, 1) + " m/s");
    const std::string how = describe(landing);
    landings.push_back(landing);
    log.add(how, judge(landing));
    if (landing.isOnPad()) lastPad = landing.pad;
    tell("touched down at " + how);
}

void Sortie::crash(const std::string &how) {
    ++crashes;
    wreckBy(how);
}

std::vector<Pose> Sortie::getPoses() const {
    std::vector<Pose> poses = poseJet(jet);
    const Vector3 place = jet.getBody().getPosition();
    poses.push_back(getWreck().empty() ? NOWHERE : Pose{Vector3(place.x, 0, place.z), cyclone::Quaternion()});
    for (const Pad &pad : PADS) {
        const Vector3 foot = pad.centre + Vector3(18, 0, -14);
        for (const Pose &pose :
             poseWindsock(foot, -weather.getVelocity(foot + Vector3::UP * WINDSOCK_HEIGHT)))
            poses.push_back(pose);
    }
    return poses;
}

std::vector<Arrow> Sortie::getArrows() const {
    const RigidBody &body = jet.getBody();
    std::vector<Arrow> arrows;
    for (std::size_t n = 0; n < Jet::SURFACES; ++n)
        arrows.push_back(makeArrow(SURFACE_NAMES[n], jet.getSurfaces()[n], body, LIFT_COLOUR));
    for (std::size_t n = 0; n < Jet::NOZZLES; ++n)
        arrows.push_back(makeArrow(NOZZLE_NAMES[n], jet.getNozzleJets()[n], body, PUSH_COLOUR));
    for (std::size_t n = 0; n < Jet::PUFFERS; ++n)
        arrows.push_back(makeArrow(PUFFER_NAMES[n], jet.getPuffers()[n], body, PUFF_COLOUR));
    return arrows;
}

std::string Sortie::getHeadUpLine() const {
    const RigidBody &body = jet.getBody();
    const auto percent = [](real share) { return fixed(100 * share, 0) + "%"; };
    return "ALT " + fixed(std::max(jet.getHeight(), 0.0), 0) + "  SPD " + fixed(jet.getAirspeed(), 0) +
           "  NOZ " + fixed(jet.getNozzles() / DEGREE, 0) + "°  THR " + percent(getControl(THROTTLE)) +
           "  WING " + percent(std::max(getWingborne(), 0.0)) + "  CLIMB " +
           signedFixed(body.getVelocity().y, 1) + "  PAD " + whereabouts(body, getNextPad().centre) +
           (jet.isStalled() && airborne && jet.getAirspeed() > 10 ? "  STALL" : "") +
           (isStabilised() ? "" : "  STAB OUT") + "  HDG " + compassText(headingOf(body));
}

std::string Sortie::getSummary() const {
    return "Went over to the wings: " + counted(transitions, "time") + "\n" + log.getSummary() +
           "\nCrashes: " + std::to_string(crashes);
}

}  // namespace vtol
