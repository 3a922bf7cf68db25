#pragma once

/// The race as a demonstration: hoops, one of three aircraft, wind, the ghost of the best lap, and a pilot.
#include "airrace/lap.h"
#include "airrace/marshal.h"
#include "airrace/pilot.h"
#include "models/attitude.h"
#include "models/weather.h"
#include "shell/demo.h"

namespace airrace {

using namespace demo;

class Race : public Demonstration {
public:
    enum { BANK, CLIMB, THROTTLE };              ///< the controls: degrees, degrees, 0 … 1
    enum { WIND_SPEED, WIND_DIRECTION, GUSTS };  ///< the settings

    static constexpr std::size_t PILOTS_LAPS = 3;  ///< then he is done

    /// One of Aircraft::NAMES.
    explicit Race(const std::string &aircraft);

    void steer() override;
    bool isOver() const override { return sinceStart.size() >= PILOTS_LAPS; }
    std::string getHeadUpLine() const override;
    std::optional<Attitude> getAttitude() const override {
        return Attitude{pitchOf(aircraft->getBody()), bankOf(aircraft->getBody())};
    }
    std::string getSummary() const override;

    const Aircraft &getAircraft() const { return *aircraft; }
    Aircraft &getAircraft() { return *aircraft; }
    const Marshal &getMarshal() const { return marshal; }
    /// s: all laps of the run.
    const std::vector<real> &getLaps() const { return laps; }
    /// Null without one.
    const Lap *getBestLap() const { return best.find(aircraft->getModel().name); }
    /// Where the ghost is now; nothing while there is none.
    std::optional<Pose> getGhost() const;

protected:
    void prepare(std::uint64_t seed, const std::vector<real> &settings) override;
    void launch() override;
    void beforeStep() override;
    void afterStep() override;
    std::vector<Pose> getPoses() const override;
    std::vector<Arrow> getArrows() const override;
    Vector3 getWindspeed() const override;

private:
    void fillProfile();
    void fillScene();
    void watchTheHoops();
    void endLap(real lapTime, const Pose &now);
    void watchTheGround();
    Pose getPose() const;
    std::optional<real> getLapClock() const;
    std::string describeNextHoop() const;

    Weather weather;
    std::unique_ptr<Aircraft> aircraft;
    Stabiliser stabiliser;
    Pilot pilot;
    Marshal marshal;
    LapRecorder recorder;
    BestLaps kept, best;                 ///< from the file of best laps, and with those of this run
    Pose before;                         ///< the step
    real lastStalled = 0;                ///< s, when
    std::vector<real> laps, sinceStart;  ///< s: of the run, and since it was last begun
    unsigned crashes = 0;
};

}  // namespace airrace
