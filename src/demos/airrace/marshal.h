#pragma once

/// Who watches the hoops and holds the clock.
#include "airrace/hoop.h"

#include <optional>
#include <string>
#include <utility>

namespace airrace {

/// The hoops are to be flown in order. The clock starts at the first one, which is also where a lap ends and
/// the next begins.
class Marshal {
public:
    /// clearance: m, that the aircraft's middle must keep from the rim. The course must outlive it.
    Marshal(const std::vector<Hoop> &course, real clearance);

    /// To the first hoop again, with the clock stopped.
    void startOver();

    /// What was flown in a step of `duration` s that ended at `time`, straight on. Returns the time of the
    /// lap that ended in it, if one did, exact to the crossing.
    std::optional<real> watch(const Vector3 &from, const Vector3 &to, real time, real duration);

    /// By index into the course.
    std::size_t getNext() const { return next; }
    /// s: when the first hoop was passed last; nothing before it has been.
    std::optional<real> getLapStart() const { return lapStart; }
    /// Since the race was begun.
    unsigned getPassed() const { return passed; }
    unsigned getMissed() const { return missed; }
    /// What went wrong since the last call, in words.
    std::vector<std::string> takeReports() { return std::exchange(reports, {}); }

private:
    bool isClean(const Crossing &crossing) const;
    std::optional<real> pass(real time);
    void judge(const Vector3 &from, const Vector3 &to);

    const std::vector<Hoop> *course;
    real clearance;
    std::size_t next = 0;
    std::optional<real> lapStart;
    unsigned passed = 0, missed = 0;
    std::vector<std::string> reports;
};

}  // namespace airrace
