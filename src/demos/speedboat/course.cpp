#include "speedboat/course.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/angle.h"

namespace speedboat {

namespace {

/// Where a way crosses a buoy's line.
struct Crossing {
    real share;   // of the way
    real offset;  // m from the buoy along the gate; negative on the wrong side
};

std::optional<Crossing> findCrossing(const Buoy &buoy, const Vector3 &from, const Vector3 &to) {
    const Vector3 ahead = demo::towardsBearing(buoy.heading);
    const Vector3 start = from - buoy.getPlace(), end = to - buoy.getPlace();
    const real before = start * ahead, after = end * ahead;
    if (before >= 0 || after < 0) return std::nullopt;  // not across, or the wrong way
    const real share = before / (before - after);
    return Crossing{share, (start + (end - start) * share) * buoy.getGateDirection()};
}

}  // namespace

Vector3 Buoy::getGateDirection() const {
    const Vector3 starboard(-cyclone::real_sin(heading), 0, cyclone::real_cos(heading));
    return toPort ? starboard : -starboard;
}

Course::Course(std::vector<Buoy> b) : buoys(std::move(b)) {
    if (buoys.empty()) throw std::invalid_argument("Course::Course: there must be a buoy at least");
}

void Course::startOver(real time) {
    next = 0;
    hasMissed = false;
    lapStart = time;
}

std::optional<Course::Event> Course::advance(const Vector3 &from, const Vector3 &to, real time,
                                             real duration) {
    const std::optional<Crossing> crossing = findCrossing(buoys[next], from, to);
    if (!crossing || crossing->offset > Buoy::GATE || crossing->offset < -Buoy::GATE) return std::nullopt;
    if (crossing->offset < 0) {
        if (std::exchange(hasMissed, true)) return std::nullopt;
        return Event::MISSED;
    }
    hasMissed = false;
    next = (next + 1) % buoys.size();
    if (next != 0) return Event::PASSED;
    finishLap(time - duration * (1 - crossing->share));
    return Event::LAP;
}

void Course::finishLap(real time) {
    lastLap = time - lapStart;
    bestLap = laps++ == 0 ? lastLap : std::min(bestLap, lastLap);
    lapStart = time;
}

}  // namespace speedboat
