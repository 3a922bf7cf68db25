#pragma once

/// The demonstration that flies: the aircraft, an airfield, wind and a pilot.
#include "base/random.h"
#include "flightsim/landing.h"
#include "flightsim/pilot.h"
#include "shell/demo.h"

namespace flightsim {

class Flight : public Demonstration {
public:
    enum { PITCH, ROLL, RUDDER, THROTTLE };        ///< the controls
    enum { WIND_SPEED, WIND_DIRECTION, GUSTS };    ///< the settings
    static constexpr real HARDEST_TOUCH_DOWN = 2;  ///< m/s downwards: what is harder is a crash
    static constexpr Runway RUNWAY{12, 88};        ///< m: what one aims at
    static const Landing WORST_LANDING;            ///< that is still fair

    Flight();

    void steer() override;
    bool isOver() const override {
        return pilot.getLeg() == Pilot::Leg::STOPPED || pilot.getLeg() == Pilot::Leg::STAY_DOWN;
    }
    std::string getHeadUpLine() const override;
    std::optional<Attitude> getAttitude() const override {
        return Attitude{aircraft.getPitch(), aircraft.getRoll()};
    }
    std::string getSummary() const override;

    const Aircraft &getAircraft() const { return aircraft; }
    /// For tests, and for whoever wants to begin in the air.
    Aircraft &getAircraft() { return aircraft; }

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
        LandingLog landings;
        unsigned crashes = 0;
        real highest = 0, distance = 0;
    };

    void fillProfile();
    void watchTheGround();
    void crash(const std::string &how);
    real getHeight() const;

    Wind wind;
    Aircraft aircraft;
    Pilot pilot;
    Pilot::Leg lastLeg = Pilot::Leg::WATCH;
    Vector3 lastPosition, lastVelocity;  ///< before the step
    real propellerAngle = 0;
    bool airborne = false;
    Log log;
};

}  // namespace flightsim
