#include "skipper.h"

namespace demo {

namespace {

using cyclone::real_abs;

constexpr real CLOSE_HAULED = 0.87, LEEWAY = 0.08;  // rad; best to windward by the polar diagram
constexpr real ROUNDING = 9, BERTH = 6;             // m: how near counts, and how far off the mark to aim
constexpr real CORRIDOR = 26;                       // m to either side of the mark's line downwind
constexpr real LONGEST_MEMORY = 5, SHORTEST_BOARD = 10;  // s

real signOf(real x) { return x < 0 ? -1 : 1; }

}  // namespace

void Skipper::senseWind(const Vector3 &windspeed, real duration) {
    const real share = duration / (LONGEST_MEMORY + duration);
    meanWind = meanWind == Vector3() ? windspeed : meanWind * (1 - share) + windspeed * share;
}

void Skipper::sail(Catamaran &boat, const Vector3 &windspeed, real duration) {
    senseWind(windspeed, duration);
    sinceTack += duration;
    noteManoeuvres(boat);
    if (!isFinished()) {
        const Mark &mark = course[rounded];
        const Vector3 position = boat.getBody().getPosition();
        const Vector3 toMark(mark.x - position.x, 0, mark.z - position.z);
        const real distance = toMark.magnitude();
        // To leave it to port he aims to starboard of it.
        const Vector3 berth = Vector3(-toMark.z, 0, toMark.x).unit() * BERTH;
        const real heading = bearing(toMark + berth);
        const real windFrom = bearing(meanWind);
        const real markOffWind = wrapAngle(heading - windFrom);
        const bool tooClose = real_abs(markOffWind) < CLOSE_HAULED + (beating ? LEEWAY : 0);
        if (tooClose && !beating) tack = boat.getTrueWindAngle() < 0 ? -1 : 1;
        beating = tooClose;
        if (beating)
            beat(boat, markOffWind, distance * cyclone::real_sin(wrapAngle(bearing(toMark) - windFrom)));
        else
            helmsman.steerHeading(heading +
                                  (real_abs(markOffWind) < 1.2 ? signOf(-markOffWind) * LEEWAY : 0));
        const bool abeam = real_abs(wrapAngle(bearing(toMark) - boat.getHeading())) > 1.5;
        if (distance < ROUNDING || (distance < 3 * ROUNDING && abeam && !beating)) {
            ++rounded;
            beating = false;
            reports.push_back("rounded the " + mark.name + " mark");
        }
    }
    helmsman.sail(boat, duration);
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

void Skipper::noteManoeuvres(const Catamaran &boat) {
    const real wind = boat.getTrueWindAngle();
    if (real_abs(cyclone::real_sin(wind)) < 0.1) return;  // not yet on one side or the other
    const real now = signOf(wind);
    if (side != 0 && now != side) {
        const bool ahead = real_abs(wind) < cyclone::REAL_PI / 2;
        ++(ahead ? tacks : gybes);
        reports.push_back(ahead ? "tacked" : "gybed");
    }
    side = now;
}

}  // namespace demo
