#pragma once

/// The speedboat as a demonstration: the boat, its sea and wind, a course of buoys, and a pilot.
#include "base/random.h"
#include "shell/demo.h"
#include "speedboat/motorboat_parts.h"
#include "speedboat/pilot.h"

namespace speedboat {

/// Laps round the buoys. A boat that has capsized drifts, its motor drowned.
class Race : public Demonstration {
public:
    enum { THROTTLE, STEERING, TILT };  ///< the controls: 0 … 1; degrees to starboard; degrees out
    enum { WIND, GUSTS, WAVES };        ///< the settings: m/s, from the north-west; m/s; m

    static constexpr real SHORTEST_JUMP = 0.25;  ///< s in the air

    explicit Race(Hull hull);

    void steer() override;
    bool isOver() const override { return course.getLaps() > lapsBefore; }
    std::string getHeadUpLine() const override;
    std::string getSummary() const override;

    const Motorboat &getBoat() const { return boat; }
    /// For tests, and for whoever wants to begin elsewhere.
    Motorboat &getBoat() { return boat; }
    const Course &getCourse() const { return course; }

    /// What is told at the end.
    struct Log {
        real distance = 0, topSpeed = 0;    ///< m, m/s
        real timeDry = 0, longestJump = 0;  ///< s
        unsigned jumps = 0, capsizes = 0;
    };
    const Log &getLog() const { return log; }

protected:
    void prepare(std::uint64_t seed, const std::vector<real> &settings) override;
    void launch() override;
    void beforeStep() override;
    void afterStep() override;
    std::vector<Pose> getPoses() const override;
    std::vector<Arrow> getArrows() const override;
    Vector3 getWindspeed() const override { return wind.getWindspeed(); }

private:
    void fillProfile();
    Scene makeScene() const;
    void setWaves(real height, Random &random);
    void watchTheCourse();
    void keepLog();
    void countJumps();
    void watchForCapsize();
    std::string getTask() const;
    real getLapTime() const { return getTime() - course.getLapStart(); }

    Hull hull;
    Wind wind;
    cyclone::Waves sea;
    Motorboat boat;
    Course course;
    Vector3 lastPosition;              ///< before the step
    real airborneFor = 0, dryFor = 0;  ///< s, until now
    unsigned lapsBefore = 0;           ///< when it was launched
    Log log;
};

}  // namespace speedboat
