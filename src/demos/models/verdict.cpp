#include "models/verdict.h"

#include <algorithm>

namespace demo {

namespace {

constexpr real GOOD = 0.6, EXCELLENT = 0.3;  // of the most that is fair

}  // namespace

std::string getName(Mark mark) {
    switch (mark) {
        case Mark::POOR:
            return "poor";
        case Mark::FAIR:
            return "fair";
        case Mark::GOOD:
            return "good";
        case Mark::EXCELLENT:
            return "excellent";
    }
    return "";
}

Verdict::Verdict(const std::vector<Flaw> &flaws) : worst{0, ""} {
    for (const Flaw &flaw : flaws)
        if (flaw.share > worst.share) worst = flaw;
}

Mark Verdict::getMark() const {
    return worst.share > 1           ? Mark::POOR
           : worst.share > GOOD      ? Mark::FAIR
           : worst.share > EXCELLENT ? Mark::GOOD
                                     : Mark::EXCELLENT;
}

std::string Verdict::getText() const {
    const Mark mark = getMark();
    return getName(mark) + (mark < Mark::GOOD ? std::string(", ") + worst.name : "");
}

void LandingLog::add(const std::string &how, const Verdict &verdict) {
    if (count == 0 || verdict.isBetterThan(best)) {
        bestHow = how;
        best = verdict;
    }
    ++count;
}

std::string LandingLog::getSummary() const {
    return "Landings: " + std::to_string(count) +
           (count == 0 ? "" : (count == 1 ? ", at " : ", the best at ") + bestHow);
}

}  // namespace demo
