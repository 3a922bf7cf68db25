#pragma once

/// Marks for landings.
#include <cyclone/precision.h>

#include <string>
#include <vector>

namespace demo {

using cyclone::real;

enum class Mark { POOR, FAIR, GOOD, EXCELLENT };
std::string getName(Mark mark);

/// What mars a landing: its share of the most that is still fair.
struct Flaw {
    real share;
    const char *name;
};

/// The mark is that of the worst flaw. Up to three fifths of the most that is fair are good, three tenths
/// excellent.
class Verdict {
public:
    explicit Verdict(const std::vector<Flaw> &flaws);

    Mark getMark() const;
    bool isBetterThan(const Verdict &other) const { return worst.share < other.worst.share; }
    /// "good"; with the lower marks the flaw is named: "fair, far from the aim".
    std::string getText() const;

private:
    Flaw worst;
};

/// All landings of a run.
class LandingLog {
public:
    /// how: "0.3 m/s, 5 m beyond the aim: good".
    void add(const std::string &how, const Verdict &verdict);
    unsigned getCount() const { return count; }
    /// "Landings: 2, the best at 0.3 m/s, …".
    std::string getSummary() const;

private:
    std::string bestHow;
    Verdict best{{}};
    unsigned count = 0;
};

}  // namespace demo
