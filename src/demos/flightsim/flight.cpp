#include "flightsim/flight.h"

#include <algorithm>

#include "base/angle.h"
#include "base/text.h"
#include "flightsim/aircraft_parts.h"
#include "picture/windsock.h"

namespace flightsim {

namespace {

constexpr real DEGREE = cyclone::REAL_PI / 180;
constexpr real GUST_MEMORY = 1.2;       // s
constexpr real NEWTONS_PER_METRE = 10;  // of the force arrows
constexpr Colour LIFT{255, 214, 64}, THRUST{255, 120, 90};
const char *const SURFACE_NAMES[] = {"port wing", "starboard wing", "tailplane", "rudder"};

const FlightLog::Rules RULES{
    Aircraft::WHEEL_HEIGHT, 0.5, 2, {12, 88}, {1.2, 35, 4, 12 * DEGREE, 15 * DEGREE}};

Scene makeScene() {
    Scene scene;
    scene.bodies = {{makeAircraftParts(), true, false}, {makeWindsockParts(), false, false}};
    scene.paint = paintRunway();
    scene.newtonsPerMetre = NEWTONS_PER_METRE;
    scene.cameras.spectator = Vector3(20, 1.7, -16);
    scene.cameras.distance = 4;
    scene.cameras.height = 0.1;
    scene.cameras.windHeight = 1.3;
    return scene;
}

}  // namespace

Flight::Flight() : aircraft(world, wind.getAddress()), log(RULES) {
    fillProfile();
    scene = makeScene();
    begin(1);
}

void Flight::fillProfile() {
    profile.program = "flightsim";
    profile.variant = "aircraft model";
    profile.summary = "Flies a model aircraft: with the keyboard in a terminal, otherwise by itself.";
    profile.settings = {{"wind", "SPEED", "Mean wind, m/s", 1.5, 0, 5},
                        {"from", "DEGREES", "Where the wind comes from; the runway points to 0", 20, 0, 360},
                        {"gusts", "SPEED", "How much the wind changes (root mean square), m/s", 0.3, 0, 2}};
    profile.controls = {{"pitch", -1, 1, 0, 'w', 's', 0.1, true, true},
                        {"roll", -1, 1, 0, 'a', 'd', 0.1, true, true},
                        {"rudder", -1, 1, 0, 'q', 'e', 0.1, true, true},
                        {"throttle", 0, 1, 0, '-', '+', 0.1, false}};
    profile.help = {"W S      both wings down, up: nose down, up",
                    "A D      wings in opposition: roll left, right",
                    "Q E      rudder and nose wheel: left, right",
                    "X        centre them all",
                    "+ -      throttle",
                    "",
                    "Take off: + until 100 %, and S once at 8 m/s.",
                    "In the air 40 % of throttle keep it level.",
                    "Numbers are metres, metres per second, degrees."};
    profile.quantities = {
        {"x", "m", [this] { return aircraft.getBody().getPosition().x; }, "", 1},
        {"height", "m", [this] { return getHeight(); }, "height", 1},
        {"z", "m", [this] { return aircraft.getBody().getPosition().z; }, "", 1},
        {"airspeed", "m/s", [this] { return aircraft.getAirspeed(); }, "speed", 1},
        {"climb", "m/s", [this] { return aircraft.getBody().getVelocity().y; }, "speed", 1},
        {"heading", "°", [this] { return compassDegrees(aircraft.getHeading()); }, "", 0},
        {"pitch", "°", [this] { return aircraft.getPitch() / DEGREE; }, "attitude", 0},
        {"roll", "°", [this] { return aircraft.getRoll() / DEGREE; }, "attitude", 0},
        {"both wings", "", [this] { return aircraft.getControls().pitch; }, "controls", 2},
        {"opposite wings", "", [this] { return aircraft.getControls().roll; }, "controls", 2},
        {"rudder", "", [this] { return aircraft.getControls().rudder; }, "controls", 2},
        {"throttle", "", [this] { return aircraft.getControls().throttle; }, "controls", 2},
        {"ground speed", "m/s", [this] { return horizontalLength(aircraft.getBody().getVelocity()); },
         "speed"},
        {"wind x", "m/s", [this] { return wind.getWindspeed().x; }},
        {"wind y", "m/s", [this] { return wind.getWindspeed().y; }},
        {"wind z", "m/s", [this] { return wind.getWindspeed().z; }},
        {"thrust", "N", [this] { return aircraft.getPropeller().getForce(aircraft.getBody()).magnitude(); }},
    };
    profile.title = "Flight of a model aircraft";
    profile.kind = "flight";
    profile.duration = 120;
}

void Flight::prepare(std::uint64_t seed, const std::vector<real> &settings) {
    wind = Wind(towardsBearing(settings.at(WIND_DIRECTION) * DEGREE) * settings.at(WIND_SPEED),
                settings.at(GUSTS), GUST_MEMORY, profile.step, seed);
    log = FlightLog(RULES);
}

void Flight::launch() {
    aircraft.park(Vector3());
    pilot = Pilot();
    lastLeg = pilot.getLeg();
    log.launch(false);
}

void Flight::steer() {
    const FlightControls sticks = pilot.fly(aircraft, profile.step);
    setControl(PITCH, sticks.pitch);
    setControl(ROLL, sticks.roll);
    setControl(RUDDER, sticks.rudder);
    setControl(THROTTLE, sticks.throttle);
    if (pilot.getLeg() == lastLeg) return;
    lastLeg = pilot.getLeg();
    if (lastLeg == Pilot::Leg::STAY_DOWN)
        tell("stays down: wind of up to " + fixed(pilot.getStrongestWind(), 1) + " m/s, gusts of " +
             fixed(pilot.getGusts(), 1) + " m/s");
    else if (lastLeg != Pilot::Leg::CLIMB && lastLeg != Pilot::Leg::ROLL_OUT)
        tell(Pilot::getName(lastLeg));
}

void Flight::beforeStep() {
    wind.advance();
    FlightControls sticks;
    sticks.pitch = getControl(PITCH);
    sticks.roll = getControl(ROLL);
    sticks.rudder = getControl(RUDDER);
    sticks.throttle = getControl(THROTTLE);
    aircraft.setControls(sticks);
    propellerAngle += (4 + 18 * sticks.throttle) * profile.step;
    log.noteBeforeStep(aircraft.getBody());
}

void Flight::afterStep() {
    const auto news = log.watchAfterStep(aircraft.getBody(), aircraft.isOnGround(), aircraft.getBrokenPart());
    if (news) news->isCrash ? wreckBy(news->text) : tell(news->text);
}

std::vector<Pose> Flight::getPoses() const {
    std::vector<Pose> poses = poseAircraft(aircraft, propellerAngle);
    for (const Pose &pose : poseWindsock(WINDSOCK_PLACE, wind.getWindspeed())) poses.push_back(pose);
    return poses;
}

std::vector<Arrow> Flight::getArrows() const {
    const RigidBody &body = aircraft.getBody();
    std::vector<Arrow> arrows;
    std::size_t n = 0;
    for (const cyclone::Aero *surface : aircraft.getSurfaces())
        arrows.push_back({SURFACE_NAMES[n++], body.getPointInWorldSpace(surface->getPosition()),
                          surface->getForce(body) * (1 / NEWTONS_PER_METRE), LIFT});
    arrows.push_back({"thrust", body.getPointInWorldSpace(Aircraft::PROPELLER_POSITION),
                      aircraft.getPropeller().getForce(body) * (1 / NEWTONS_PER_METRE), THRUST});
    return arrows;
}

std::string Flight::getHeadUpLine() const {
    const RigidBody &body = aircraft.getBody();
    const Vector3 air = wind.getWindspeed();
    const FlightControls &sticks = aircraft.getControls();
    const real height = std::max(getHeight(), 0.0);
    return "ALT " + fixed(height, 1) + "  SPD " + fixed(aircraft.getAirspeed(), 1) + "  CLIMB " +
           signedFixed(body.getVelocity().y, 1) + "  HDG " + compassText(aircraft.getHeading()) + "  THR " +
           fixed(sticks.throttle * 100, 0) + "%  PIT " + signedFixed(sticks.pitch, 1) + " ROL " +
           signedFixed(sticks.roll, 1) + " RUD " + signedFixed(sticks.rudder, 1) + "  WIND " +
           fixed(air.magnitude(), 1) + "/" + compassText(bearing(air));
}

std::string Flight::getSummary() const {
    return "Flown: " + fixed(log.getDistance(), 0) + " m in " + fixed(getTime(), 1) + " s, up to " +
           fixed(log.getHighest(), 1) + " m high\n" + log.getSummary();
}

}  // namespace flightsim
