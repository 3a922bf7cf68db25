#include "flightsim/soaring.h"

#include <algorithm>

#include "base/angle.h"
#include "base/text.h"
#include "flightsim/aircraft_parts.h"
#include "flightsim/glider_parts.h"
#include "picture/windsock.h"

namespace flightsim {

namespace {

constexpr real DEGREE = cyclone::REAL_PI / 180;
constexpr real NEWTONS_PER_METRE = 200;  // of the force arrows
constexpr real VARIO_MEMORY = 1.5;       // s
constexpr Colour LIFT_COLOUR{255, 214, 64}, BRAKE_COLOUR{255, 120, 90};
const char *const WING_NAMES[] = {"port tip",      "port wing", "starboard wing",
                                  "starboard tip", "tailplane", "fin"};

const FlightLog::Rules RULES{Glider::WHEEL_HEIGHT, 3, 3, {60, -60}, {2, 150, 15, 10 * DEGREE, 12 * DEGREE}};

Scene makeScene() {
    Scene scene;
    scene.bodies = {{makeGliderParts(), true, false}, {makeWindsockParts(), false, false}};
    scene.paint = paintAirfield();
    scene.newtonsPerMetre = NEWTONS_PER_METRE;
    scene.cameras.spectator = Vector3(22, 3, -24);
    scene.cameras.spectatorFollows = true;
    scene.cameras.distance = 20;
    scene.cameras.windHeight = 3;
    return scene;
}

}  // namespace

Soaring::Soaring() : glider(world, &weather), log(RULES) {
    fillProfile();
    scene = makeScene();
    begin(1);
}

void Soaring::fillProfile() {
    profile.program = "flightsim";
    profile.variant = "aircraft glider";
    profile.summary = "Flies a glider in thermals: with the keyboard in a terminal, otherwise by itself.";
    profile.settings = {
        {"wind", "SPEED", "Mean wind 10 m above the ground, m/s", 2, 0, 6},
        {"from", "DEGREES", "Where the wind comes from; the runway points to 0", 20, 0, 360},
        {"gusts", "SPEED", "How much the air heaves (root mean square), m/s", 0.3, 0, 1.5},
        {"lift", "SPEED", "How fast the thermals rise; 0 is an evening without, m/s", 3.5, 0, 6}};
    profile.controls = {{"pull", -1, 1, 0, 'w', 's', 0.1, true, true},
                        {"roll", -1, 1, 0, 'a', 'd', 0.1, true, true},
                        {"rudder", -1, 1, 0, 'q', 'e', 0.1, true, true},
                        {"brakes", 0, 1, 0, '-', '+', 0.1, false}};
    profile.help = {"W S      stick forward, back: nose down, up",
                    "A D      stick left, right",
                    "Q E      pedals left, right",
                    "X        centre them all",
                    "+ -      airbrakes out, in",
                    "",
                    "Under each cloud the air rises: the nearest CLOUD is so",
                    "far away, so many degrees to Port or Starboard. When",
                    "VARIO is positive, circle: A or D, then E or Q with it.",
                    "Glide at 25 m/s; below 18 she stalls."};
    const auto airspeed = [this] { return glider.getAirspeed(); };
    const auto air = [this] { return weather.getVelocity(glider.getBody().getPosition()); };
    profile.quantities = {
        {"x", "m", [this] { return glider.getBody().getPosition().x; }, "", 0},
        {"height", "m", [this] { return getHeight(); }, "height", 0},
        {"z", "m", [this] { return glider.getBody().getPosition().z; }, "", 0},
        {"airspeed", "m/s", airspeed, "speed", 1},
        {"vario", "m/s", [this] { return vario; }, "lift", 1},
        {"air rises", "m/s", [air] { return air().y; }, "lift", 1},
        {"heading", "°", [this] { return compassDegrees(headingOf(glider.getBody())); }, "", 0},
        {"pitch", "°", [this] { return pitchOf(glider.getBody()) / DEGREE; }, "attitude", 0},
        {"roll", "°", [this] { return bankOf(glider.getBody()) / DEGREE; }, "attitude", 0},
        {"pull", "", [this] { return glider.getControls().pull; }, "controls", 2},
        {"stick to starboard", "", [this] { return glider.getControls().roll; }, "controls"},
        {"pedals", "", [this] { return glider.getControls().pedal; }, "controls"},
        {"brakes", "", [this] { return glider.getControls().brakes; }, "controls", 1},
        {"slip", "°", [this] { return glider.getSlip() / DEGREE; }},
        {"wind x", "m/s", [air] { return -air().x; }},
        {"wind z", "m/s", [air] { return -air().z; }},
    };
    profile.title = "A glider in thermals";
    profile.kind = "flight";
    profile.step = 1.0 / 60;
    profile.duration = 1200;
}

void Soaring::prepare(std::uint64_t seed, const std::vector<real> &settings) {
    windFrom = towardsBearing(settings.at(WIND_DIRECTION) * DEGREE) * settings.at(WIND_SPEED);
    weather = Weather(seed, windFrom, settings.at(GUSTS), settings.at(LIFT));
    scene.fixtures = makeClouds(weather.getClouds());
    log = FlightLog(RULES);
}

void Soaring::launch() {
    glider.launch(Vector3(0, RELEASE_HEIGHT, 0));
    pilot = Soarer(weather.getClouds(), windFrom);
    lastLeg = pilot.getLeg();
    lastEnergyHeight = glider.getEnergyHeight();
    vario = 0;
    log.launch(true);
}

void Soaring::steer() {
    const GliderControls wanted = pilot.fly(glider, vario, profile.step);
    setControl(PULL, wanted.pull);
    setControl(ROLL, wanted.roll);
    setControl(RUDDER, wanted.pedal);
    setControl(BRAKES, wanted.brakes);
    if (pilot.getLeg() == lastLeg) return;
    const bool hasClimbed = lastLeg == Soarer::Leg::CIRCLE;
    lastLeg = pilot.getLeg();
    tell(hasClimbed ? "leaves the lift, " + fixed(getHeight(), 0) + " m high" : Soarer::getName(lastLeg));
}

void Soaring::beforeStep() {
    GliderControls wanted;
    wanted.pull = getControl(PULL);
    wanted.roll = getControl(ROLL);
    wanted.pedal = getControl(RUDDER);
    wanted.brakes = getControl(BRAKES);
    glider.setControls(wanted);
    weather.advance(glider.getVelocityThroughAir(), getHeight(), profile.step);
    log.noteBeforeStep(glider.getBody());
}

void Soaring::afterStep() {
    readVario();
    const auto news = log.watchAfterStep(glider.getBody(), glider.isOnGround(), glider.getBrokenPart());
    if (news) news->isCrash ? wreckBy(news->text) : tell(news->text);
}

/// What the air gives: the change of the energy height, with an instrument's delay.
void Soaring::readVario() {
    const real energyHeight = glider.getEnergyHeight();
    vario += ((energyHeight - lastEnergyHeight) / profile.step - vario) * profile.step / VARIO_MEMORY;
    lastEnergyHeight = energyHeight;
}

std::vector<Pose> Soaring::getPoses() const {
    std::vector<Pose> poses = poseGlider(glider);
    for (const Pose &pose : poseWindsock(WINDSOCK_PLACE, -weather.getVelocity(Vector3(0, 3, 0))))
        poses.push_back(pose);
    return poses;
}

std::vector<Arrow> Soaring::getArrows() const {
    const RigidBody &body = glider.getBody();
    std::vector<Arrow> arrows;
    std::size_t n = 0;
    for (const cyclone::Wing *wing : glider.getWings())
        arrows.push_back({WING_NAMES[n++], body.getPointInWorldSpace(wing->getPosition()),
                          wing->getForce(body) * (1 / NEWTONS_PER_METRE), LIFT_COLOUR});
    arrows.push_back({"airbrakes", body.getPointInWorldSpace(glider.getBrakes().getPosition()),
                      glider.getBrakes().getForce(body) * (1 / NEWTONS_PER_METRE), BRAKE_COLOUR});
    return arrows;
}

/// Where the nearest cloud is, and the airfield.
std::string Soaring::getGoals() const {
    const RigidBody &body = glider.getBody();
    const std::vector<Vector3> &clouds = weather.getClouds();
    const auto nearest =
        std::min_element(clouds.begin(), clouds.end(), [&](const Vector3 &a, const Vector3 &b) {
            return horizontalLength(a - body.getPosition()) < horizontalLength(b - body.getPosition());
        });
    return (nearest == clouds.end() ? "" : "  CLOUD " + whereabouts(body, *nearest)) + "  FIELD " +
           whereabouts(body, Vector3());
}

std::string Soaring::getHeadUpLine() const {
    const RigidBody &body = glider.getBody();
    return "ALT " + fixed(std::max(getHeight(), 0.0), 0) + "  SPD " + fixed(glider.getAirspeed(), 1) +
           "  VARIO " + signedFixed(vario, 1) + getGoals() + "  BANK " +
           signedFixed(bankOf(body) / DEGREE, 0) + "  HDG " + compassText(headingOf(body)) + "  SLIP " +
           signedFixed(glider.getSlip() / DEGREE, 0) + "  BRK " +
           fixed(glider.getControls().brakes * 100, 0) + "%" + (glider.isStalled() ? "  STALL" : "");
}

std::string Soaring::getSummary() const {
    return "Flown: " + fixed(log.getDistance() / 1000, 1) + " km in " + fixed(getTime(), 0) + " s, up to " +
           fixed(log.getHighest(), 0) + " m high; released at " + fixed(RELEASE_HEIGHT, 0) + " m, " +
           fixed(pilot.getHeightGained(), 0) + " m gained in thermals\n" + log.getSummary();
}

}  // namespace flightsim
