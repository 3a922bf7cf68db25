#pragma once

/// The demonstration that flies: the aircraft, an airfield, wind and a pilot.
#include "base/random.h"
#include "flightsim/pilot.h"
#include "shell/demo.h"

namespace demo {

class Flight : public Demonstration {
public:
    enum { PITCH, ROLL, RUDDER, THROTTLE };        ///< the controls
    enum { WIND_SPEED, WIND_DIRECTION, GUSTS };    ///< the settings
    static constexpr real HARDEST_TOUCH_DOWN = 2;  ///< m/s downwards: what is harder is a crash

    Flight();

    const Profile &getProfile() const override { return profile; }
    void begin(std::uint64_t seed, const std::vector<real> &settings) override;
    void startOver() override;
    void steer() override;
    void step() override;
    bool isOver() const override {
        return pilot.getLeg() == Pilot::Leg::STOPPED || pilot.getLeg() == Pilot::Leg::STAY_DOWN;
    }
    real getTime() const override { return static_cast<real>(steps) * profile.step; }
    Frame getFrame() const override;
    std::string getHeadUpLine() const override;
    std::string getSummary() const override;
    std::uint64_t getHash() const override { return aircraft.getWorld().hash(); }

    const Aircraft &getAircraft() const { return aircraft; }
    /// For tests, and for whoever wants to begin in the air.
    Aircraft &getAircraft() { return aircraft; }

private:
    void watchTheGround(real sinkRate);
    void crash(const std::string &how);

    Profile profile;
    Wind wind;
    Aircraft aircraft;
    Pilot pilot;
    Pilot::Leg lastLeg = Pilot::Leg::WATCH;
    std::uint64_t steps = 0;
    real propellerAngle = 0;
    bool wasPut = true, airborne = false;

    // For the summary.
    unsigned landings = 0, crashes = 0;
    real highest = 0, distance = 0, softest = 0;
};

}  // namespace demo
