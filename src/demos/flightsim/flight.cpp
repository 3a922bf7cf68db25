#include "flightsim/flight.h"

#include <algorithm>

#include "base/text.h"
#include "flightsim/aircraft_parts.h"

namespace demo {

namespace {

constexpr real DEGREE = cyclone::REAL_PI / 180;
constexpr real GUST_MEMORY = 1.2;       // s
constexpr real NEWTONS_PER_METRE = 10;  // of the force arrows
constexpr Colour LIFT{255, 214, 64}, THRUST{255, 120, 90};
const char *const SURFACE_NAMES[] = {"port wing", "starboard wing", "tailplane", "rudder"};

Profile makeProfile() {
    Profile profile;
    profile.program = "flightsim";
    profile.summary = "Flies a model aircraft: with the keyboard in a terminal, otherwise by itself.";
    profile.settings = {{"wind", "SPEED", "Mean wind, m/s", 1.5, 0, 5},
                        {"from", "DEGREES", "Where the wind comes from; the runway points to 0", 20, 0, 360},
                        {"gusts", "SPEED", "How much the wind changes (root mean square), m/s", 0.3, 0, 2}};
    profile.controls = {{"pitch", -1, 1, 0, 'w', 's', 0.1, true},
                        {"roll", -1, 1, 0, 'a', 'd', 0.1, true},
                        {"rudder", -1, 1, 0, 'q', 'e', 0.1, true},
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
    profile.quantities = {{"x", "m", "", 1},
                          {"height", "m", "height", 1},
                          {"z", "m", "", 1},
                          {"airspeed", "m/s", "speed", 1},
                          {"climb", "m/s", "speed", 1},
                          {"heading", "°", "", 0},
                          {"pitch", "°", "attitude", 0},
                          {"roll", "°", "attitude", 0},
                          {"both wings", "", "controls", 2},
                          {"opposite wings", "", "controls", 2},
                          {"rudder", "", "controls", 2},
                          {"throttle", "", "controls", 2},
                          {"ground speed", "m/s", "speed", -1},
                          {"wind x", "m/s", "", -1},
                          {"wind y", "m/s", "", -1},
                          {"wind z", "m/s", "", -1},
                          {"thrust", "N", "", -1}};
    profile.title = "Flight of a model aircraft";
    profile.kind = "flight";
    profile.parts = makeFlightParts();
    profile.paint = paintRunway();
    profile.newtonsPerMetre = NEWTONS_PER_METRE;
    profile.outlook.spectator = Vector3(20, 1.7, -16);
    profile.outlook.distance = 4;
    profile.outlook.height = 0.1;
    profile.outlook.windHeight = 1.3;
    profile.duration = 120;
    return profile;
}

}  // namespace

Flight::Flight() : profile(makeProfile()), aircraft(wind.getAddress()) {
    std::vector<real> settings;
    for (const Setting &setting : profile.settings) settings.push_back(setting.value);
    begin(1, settings);
}

void Flight::begin(std::uint64_t seed, const std::vector<real> &settings) {
    const real from = settings.at(WIND_DIRECTION) * DEGREE, speed = settings.at(WIND_SPEED);
    wind = Wind(Vector3(speed * cyclone::real_cos(from), 0, speed * cyclone::real_sin(from)),
                settings.at(GUSTS), GUST_MEMORY, profile.step, seed);
    steps = 0;
    landings = crashes = 0;
    highest = distance = softest = 0;
    takeEvents();
    startOver();
}

void Flight::startOver() {
    aircraft.park(Vector3());
    pilot = Pilot();
    lastLeg = pilot.getLeg();
    resetControls();
    airborne = false;
    wasPut = true;
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

void Flight::step() {
    wind.advance();
    FlightControls sticks;
    sticks.pitch = getControl(PITCH);
    sticks.roll = getControl(ROLL);
    sticks.rudder = getControl(RUDDER);
    sticks.throttle = getControl(THROTTLE);
    aircraft.setControls(sticks);

    const RigidBody &body = aircraft.getBody();
    const Vector3 before = body.getPosition();
    const real sinkRate = -body.getVelocity().y;
    aircraft.step(profile.step);
    ++steps;
    wasPut = false;
    propellerAngle += (4 + 18 * sticks.throttle) * profile.step;

    distance += (body.getPosition() - before).magnitude();
    highest = std::max(highest, body.getPosition().y - Aircraft::WHEEL_HEIGHT);
    watchTheGround(sinkRate);
}

void Flight::watchTheGround(real sinkRate) {
    const bool touches = aircraft.isOnGround();
    if (aircraft.getBody().hasFaulted() || aircraft.isBroken()) return crash("crashed");
    if (touches && sinkRate > HARDEST_TOUCH_DOWN)
        return crash("crashed: touched down at " + fixed(sinkRate, 1) + " m/s");
    if (!airborne && !touches && aircraft.getBody().getPosition().y > Aircraft::WHEEL_HEIGHT + 0.5) {
        airborne = true;
        tell("took off");
    } else if (airborne && touches) {
        airborne = false;
        softest = landings == 0 ? sinkRate : std::min(softest, sinkRate);
        ++landings;
        tell("touched down at " + fixed(sinkRate, 1) + " m/s");
    }
}

void Flight::crash(const std::string &how) {
    ++crashes;
    tell(how);
    startOver();
}

Frame Flight::getFrame() const {
    const RigidBody &body = aircraft.getBody();
    const FlightControls &sticks = aircraft.getControls();
    const Vector3 position = body.getPosition(), velocity = body.getVelocity(), air = wind.getWindspeed();
    const Vector3 thrust = aircraft.getPropeller().getForce(body);

    Frame frame;
    frame.time = getTime();
    frame.poses = poseFlightParts(aircraft, propellerAngle, air);
    std::size_t n = 0;
    for (const cyclone::Aero *surface : aircraft.getSurfaces())
        frame.arrows.push_back({SURFACE_NAMES[n++], body.getPointInWorldSpace(surface->getPosition()),
                                surface->getForce(body) * (1 / NEWTONS_PER_METRE), LIFT});
    frame.arrows.push_back({"thrust", body.getPointInWorldSpace(Aircraft::PROPELLER_POSITION),
                            thrust * (1 / NEWTONS_PER_METRE), THRUST});
    frame.windspeed = air;
    frame.values = {position.x,
                    position.y - Aircraft::WHEEL_HEIGHT,
                    position.z,
                    aircraft.getAirspeed(),
                    velocity.y,
                    compassDegrees(aircraft.getHeading()),
                    aircraft.getPitch() / DEGREE,
                    aircraft.getRoll() / DEGREE,
                    sticks.pitch,
                    sticks.roll,
                    sticks.rudder,
                    sticks.throttle,
                    cyclone::real_sqrt(velocity.x * velocity.x + velocity.z * velocity.z),
                    air.x,
                    air.y,
                    air.z,
                    thrust.magnitude()};
    frame.cut = wasPut;
    return frame;
}

std::string Flight::getHeadUpLine() const {
    const RigidBody &body = aircraft.getBody();
    const Vector3 air = wind.getWindspeed();
    const FlightControls &sticks = aircraft.getControls();
    const real height = std::max(body.getPosition().y - Aircraft::WHEEL_HEIGHT, 0.0);
    return "ALT " + fixed(height, 1) + "  SPD " + fixed(aircraft.getAirspeed(), 1) + "  CLIMB " +
           signedFixed(body.getVelocity().y, 1) + "  HDG " + compassText(aircraft.getHeading()) + "  THR " +
           fixed(sticks.throttle * 100, 0) + "%  PIT " + signedFixed(sticks.pitch, 1) + " ROL " +
           signedFixed(sticks.roll, 1) + " RUD " + signedFixed(sticks.rudder, 1) + "  WIND " +
           fixed(air.magnitude(), 1) + "/" + compassText(cyclone::real_atan2(air.z, air.x));
}

std::string Flight::getSummary() const {
    return "Flown: " + fixed(distance, 0) + " m in " + fixed(getTime(), 1) + " s, up to " +
           fixed(highest, 1) + " m high\nLandings: " + std::to_string(landings) +
           (landings > 0 ? ", the softest at " + fixed(softest, 2) + " m/s" : "") +
           "\nCrashes: " + std::to_string(crashes);
}

}  // namespace demo
