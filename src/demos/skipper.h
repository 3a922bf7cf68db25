#pragma once

/// Who decides where to sail.
#include "helmsman.h"

#include <string>
#include <utility>
#include <vector>

namespace demo {

/// Takes the boat round a course of marks, each left to port. A mark that lies too close to the wind is
/// reached by beating: close hauled on one tack, then on the other.
class Skipper {
public:
    struct Mark {
        std::string name;
        real x = 0, z = 0;  ///< m, world coordinates
    };

    explicit Skipper(std::vector<Mark> marks = {}) : course(std::move(marks)) {}

    /// Works the boat for a step. The windspeed as for aero.h.
    void sail(Catamaran &boat, const Vector3 &windspeed, real duration);

    bool isFinished() const { return rounded == course.size(); }
    std::size_t getRounded() const { return rounded; }
    unsigned getTacks() const { return tacks; }
    unsigned getGybes() const { return gybes; }
    /// What was decided or done since the last call, in a word or two each.
    std::vector<std::string> takeReports() { return std::exchange(reports, {}); }

private:
    void senseWind(const Vector3 &windspeed, real duration);
    void beat(const Catamaran &boat, real markOffWind, real offset);
    void noteManoeuvres(const Catamaran &boat);

    std::vector<Mark> course;
    std::size_t rounded = 0;
    Helmsman helmsman;
    Vector3 meanWind;  ///< of late: he doesn't tack for every gust
    real tack = 1;     ///< on a beat: 1 with the wind over the starboard side, else −1
    bool beating = false;
    real side = 0;       ///< where the wind came from last, as tack; 0: not known
    real sinceTack = 0;  ///< s
    unsigned tacks = 0, gybes = 0;
    std::vector<std::string> reports;
};

}  // namespace demo
