#pragma once

/// The catamaran as a demonstration: the boat, her sea and wind, marks to sail round, and a skipper.
#include "base/random.h"
#include "sailboat/boat.h"
#include "sailboat/skipper.h"
#include "shell/demo.h"

namespace sailboat {

using namespace demo;

/// What sailors call a course at this angle (rad, either side) to the apparent wind.
const char *pointOfSail(real apparentWindAngle);

/// What the sail needs, from the angles of the apparent wind and of the boom (rad).
const char *trimHint(real apparentWindAngle, real boomAngle);

/// A boat that has capsized is righted by her crew after a while, where she lies.
class Sailing : public Demonstration {
public:
    /// The controls: degrees to starboard; degrees; to port −1, to starboard 1.
    enum { RUDDER, SHEET, BOOM };
    enum { WIND, GUSTS, WAVES };  ///< the settings: m/s, from the north; m/s; m

    Sailing();

    void steer() override;
    bool isOver() const override { return skipper.isFinished(); }
    std::string getHeadUpLine() const override;
    std::string getSummary() const override;

    const Catamaran &getBoat() const { return boat; }

protected:
    void prepare(std::uint64_t seed, const std::vector<real> &settings) override;
    void launch() override;
    void beforeStep() override;
    void afterStep() override;
    std::vector<Pose> getPoses() const override;
    std::vector<Arrow> getArrows() const override;
    Vector3 getWindspeed() const override { return wind.getWindspeed(); }

private:
    /// For the summary.
    struct Log {
        real distance = 0, topSpeed = 0, mostHeel = 0;
        real bestLap = 0;
        unsigned capsizes = 0, laps = 0;
    };

    void fillProfile();
    void setWaves(real height);
    void applyControls();
    void keepLog();
    void watchForIrons();
    void rightIfCapsized();
    std::string getAdvice() const;
    std::string getCourse() const;
    real getLapTime() const;

    Wind wind;
    cyclone::Waves sea;
    Catamaran boat;
    Skipper skipper;
    std::uint64_t capsizedSteps = 0, ironsSteps = 0;
    real lapStart = 0, lapEnd = 0;  ///< s; the end is that of the last mark, or now
    Log log;
};

}  // namespace sailboat
