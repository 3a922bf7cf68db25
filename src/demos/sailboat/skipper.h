#pragma once

/// Who decides where to sail.
#include "sailboat/helmsman.h"

#include <string>
#include <utility>
#include <vector>

namespace sailboat {

/// Takes the boat round a course of marks, each left to port. A mark that lies too close to the wind is
/// reached by beating: close hauled on one tack, then on the other.
class Skipper {
public:
    struct Mark {
        std::string name;
        real x = 0, z = 0;  ///< m, world coordinates
    };

    explicit Skipper(std::vector<Mark> marks = {}) : course(std::move(marks)) {}

    /// Works the boat's rudder, sheet and boom for a step of `duration` seconds.
    void sail(Catamaran &boat, real duration);
    /// Keeps an eye on wind and marks after every step, whoever works the boat. The windspeed as for aero.h.
    void watch(const Catamaran &boat, const Vector3 &windspeed, real duration);
    /// Before the first mark again; what he has counted stays.
    void startOver();

    /// The one to be rounded next; null after the last.
    const Mark *getNextMark() const { return isFinished() ? nullptr : &course[next]; }
    bool isFinished() const { return next == course.size(); }
    unsigned getRounded() const { return rounded; }
    unsigned getTacks() const { return tacks; }
    unsigned getGybes() const { return gybes; }
    /// What was done since the last call, in a word or two each.
    std::vector<std::string> takeReports() { return std::exchange(reports, {}); }

private:
    bool isStuck() const;
    void senseWind(const Vector3 &windspeed, real duration);
    void noteManoeuvre(const Catamaran &boat);
    void noteTack(real windAngle);
    void noteGybe(real boomAngle);
    void noteRounding(const Catamaran &boat);
    void steerFor(const Mark &mark, const Catamaran &boat);
    void beat(const Catamaran &boat, real markOffWind, real offset);

    std::vector<Mark> course;
    std::size_t next = 0;  ///< mark
    Helmsman helmsman;
    Vector3 meanWind;  ///< of late: he doesn't tack for every gust
    bool beating = false;
    real tack = 1;           ///< on a beat: 1 with the wind over the starboard side, else −1
    real side = 0;           ///< where the wind comes from, as tack; 0: not known
    bool triesTack = false;  ///< through the wind's eye, but not yet sailing on the other tack
    real sinceTack = 0;      ///< s
    unsigned tacks = 0, gybes = 0, rounded = 0;
    std::vector<std::string> reports;
};

}  // namespace sailboat
