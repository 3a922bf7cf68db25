#pragma once

/// A course round buoys, and the clock for it.
#include <cyclone/core.h>

#include <optional>
#include <vector>

namespace speedboat {

using cyclone::real;
using cyclone::Vector3;

/// To be passed on its proper side: across the gate, a line of GATE m from the buoy on.
struct Buoy {
    static constexpr real GATE = 40;

    real x = 0, z = 0;  ///< m, world
    real heading = 0;   ///< rad: which way boats go past it
    bool toPort =
        false;  ///< boats leave it to port, so that the gate lies to starboard of it; or the reverse

    Vector3 getPlace() const { return Vector3(x, 0, z); }
    /// From the buoy along the gate, a unit vector.
    Vector3 getGateDirection() const;
};

/// Rounds of the buoys, in their order; the last one ends the lap, and begins the next.
class Course {
public:
    enum class Event { PASSED, MISSED, LAP };

    /// One buoy at least.
    explicit Course(std::vector<Buoy> buoys);

    /// Before the first buoy, the clock at nought. What was done before stays.
    void startOver(real time);

    /// A step from one place to another, that ended at `time` and took `duration`, s. Passing is exact: where
    /// the way crosses the gate, the right way, wherever that is within the step. MISSED: the next buoy was
    /// passed on the wrong side, the first time of each.
    std::optional<Event> advance(const Vector3 &from, const Vector3 &to, real time, real duration);

    const std::vector<Buoy> &getBuoys() const { return buoys; }
    std::size_t getNext() const { return next; }
    const Buoy &getNextBuoy() const { return buoys[next]; }
    const Buoy &getBuoyAfter() const { return buoys[(next + 1) % buoys.size()]; }
    real getLapStart() const { return lapStart; }
    unsigned getLaps() const { return laps; }
    real getLastLap() const { return lastLap; }  ///< s; with none, 0
    real getBestLap() const { return bestLap; }

private:
    void finishLap(real time);

    std::vector<Buoy> buoys;
    std::size_t next = 0;
    bool hasMissed = false;
    unsigned laps = 0;
    real lapStart = 0, lastLap = 0, bestLap = 0;
};

}  // namespace speedboat
