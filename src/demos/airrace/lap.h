#pragma once

/// The best laps: how long they took, where they went, and the text that keeps them.
#include "picture/scene.h"

#include <map>
#include <optional>

namespace airrace {

using demo::Pose;
using demo::real;

/// Where an aircraft was during a lap.
struct Lap {
    static constexpr real INTERVAL = 0.1;  ///< s, from one pose to the next

    real time = 0;            ///< s
    std::vector<Pose> poses;  ///< from the start line on, and last that at the finish

    /// So many seconds after the start, at most its time.
    Pose getPose(real sinceStart) const;
    /// How many poses it should have.
    std::size_t countPoses() const;
};

/// Makes a lap from what is flown step by step.
class LapRecorder {
public:
    /// The lap began at startTime, s. Steps are told from the one on in which it did.
    void start(real startTime);
    /// A step of `duration` s that ended at `time`, from one pose to the other.
    void add(const Pose &from, const Pose &to, real time, real duration);
    /// The lap that has taken so long, after the step in which it ended.
    Lap finish(real lapTime, const Pose &from, const Pose &to, real time, real duration);

private:
    real startTime = 0;
    std::vector<Pose> poses;
};

/// For each aircraft the best lap.
class BestLaps {
public:
    /// From the text that getText() writes; an empty one has none. Throws std::runtime_error with the line
    /// and what is wrong with it. `aircraft`: the names that there are.
    static BestLaps read(const std::string &text, const std::vector<std::string> &aircraft);
    std::string getText() const;

    /// Null if there is none.
    const Lap *find(const std::string &aircraft) const;
    void set(const std::string &aircraft, const Lap &lap) { laps[aircraft] = lap; }

private:
    std::map<std::string, Lap> laps;
};

}  // namespace airrace
