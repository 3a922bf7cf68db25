#include "sailboat/skipper.h"

namespace sailboat {

namespace {

using cyclone::real_abs;

constexpr real CLOSE_HAULED = 0.87, LEEWAY = 0.08;  // rad; best to windward by the polar diagram
constexpr real ROUNDING = 9, BERTH = 6;             // m: how near counts, and how far off the mark to aim
constexpr real CORRIDOR = 26;                       // m to either side of the mark's line downwind
constexpr real REACHING = 1.2;                      // rad off the wind: leeway no longer matters
constexpr real MEMORY = 5, SHORTEST_BOARD = 10;     // s
constexpr real LONGEST_IN_IRONS = 30;               // s
constexpr real IN_THE_EYE = 0.1, FILLED = 0.6;      // rad off the wind: neither side, and a full sail

real signOf(real x) { return x < 0 ? -1 : 1; }

Vector3 wayTo(const Skipper::Mark &mark, const Catamaran &boat) {
    const Vector3 position = boat.getBody().getPosition();
    return Vector3(mark.x - position.x, 0, mark.z - position.z);
}

}  // namespace

void Skipper::startOver() {
    next = 0;
    helmsman = Helmsman();
    beating = false;
    side = 0;
    triesTack = false;
}

void Skipper::watch(const Catamaran &boat, const Vector3 &windspeed, real duration) {
    senseWind(windspeed, duration);
    sinceTack += duration;
    if (boat.isCapsized()) return;
    noteManoeuvre(boat);
    if (!isFinished()) noteRounding(boat);
}

void Skipper::senseWind(const Vector3 &windspeed, real duration) {
    const real share = duration / (MEMORY + duration);
    meanWind = meanWind == Vector3() ? windspeed : meanWind * (1 - share) + windspeed * share;
}

/// Ahead of the beam the wind's side counts, abaft it the boom's.
void Skipper::noteManoeuvre(const Catamaran &boat) {
    const real wind = boat.getTrueWindAngle();
    if (side == 0)
        side = signOf(wind);
    else if (real_abs(wind) < cyclone::REAL_PI / 2)
        noteTack(wind);
    else
        noteGybe(boat.getSail());
}

/// Each try is told once, when it is over: she sails on the other tack, or on the old one again.
void Skipper::noteTack(real windAngle) {
    if (side * windAngle < -IN_THE_EYE) triesTack = true;
    if (!triesTack || real_abs(windAngle) < FILLED) return;
    triesTack = false;
    const bool tacked = side * windAngle < 0;
    if (tacked) ++tacks;
    reports.push_back(tacked ? "tacked" : "missed the tack");
    side = signOf(windAngle);
}

void Skipper::noteGybe(real boomAngle) {
    if (side * boomAngle < IN_THE_EYE) return;
    side = -side;
    triesTack = false;
    ++gybes;
    reports.push_back("gybed");
}

void Skipper::noteRounding(const Catamaran &boat) {
    const Vector3 way = wayTo(course[next], boat);
    const bool isAbeam = real_abs(wrapAngle(bearing(way) - boat.getHeading())) > 1.5;
    const real distance = way.magnitude();
    if (distance >= ROUNDING && !(distance < 3 * ROUNDING && isAbeam && !beating)) return;
    reports.push_back("rounded the " + course[next].name + " mark");
    ++rounded;
    ++next;
    beating = false;
}

void Skipper::sail(Catamaran &boat, real duration) {
    if (!isFinished()) steerFor(course[next], boat);
    const bool wasStuck = isStuck();
    helmsman.sail(boat, duration);
    if (isStuck() && !wasStuck) reports.push_back("in irons: too little wind");
}

bool Skipper::isStuck() const { return helmsman.getTimeInIrons() > LONGEST_IN_IRONS; }

void Skipper::steerFor(const Mark &mark, const Catamaran &boat) {
    const Vector3 way = wayTo(mark, boat);
    // To leave it to port he aims to starboard of it.
    const real heading = bearing(way + Vector3(-way.z, 0, way.x).unit() * BERTH);
    const real windFrom = bearing(meanWind);
    const real markOffWind = wrapAngle(heading - windFrom);
    const bool isTooClose = real_abs(markOffWind) < CLOSE_HAULED + (beating ? LEEWAY : 0);
    if (isTooClose && !beating) tack = signOf(boat.getTrueWindAngle());
    beating = isTooClose;
    if (beating)
        return beat(boat, markOffWind,
                    way.magnitude() * cyclone::real_sin(wrapAngle(bearing(way) - windFrom)));
    const bool makesLeeway = real_abs(markOffWind) < REACHING;
    helmsman.steerHeading(heading + (makesLeeway ? signOf(-markOffWind) * LEEWAY : 0));
}

/// markOffWind: the mark's direction from the wind's, positive to starboard of it; offset: how far the mark
/// lies that way from the boat, m.
void Skipper::beat(const Catamaran &boat, real markOffWind, real offset) {
    // On a tack the boat goes to the other side than the wind comes over: on starboard tack (1) to port. The
    // mark can be laid on the other tack once it is that far off the wind, on the other side.
    const bool laysMark = tack * markOffWind > CLOSE_HAULED + LEEWAY;
    const bool outside = tack * offset > CORRIDOR;
    const bool hasWay = boat.getSpeed() > 1.5;
    if ((laysMark || outside) && hasWay && sinceTack > SHORTEST_BOARD) {
        tack = -tack;
        sinceTack = 0;
    }
    helmsman.steerWindAngle(tack * CLOSE_HAULED);
}

}  // namespace sailboat
