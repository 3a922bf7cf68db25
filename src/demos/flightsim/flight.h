#pragma once

/// The demonstration that flies: the aircraft, an airfield, wind and a pilot.
#include "base/random.h"
#include "flightsim/flightlog.h"
#include "flightsim/pilot.h"
#include "shell/demo.h"

namespace flightsim {

class Flight : public Demonstration {
public:
    enum { PITCH, ROLL, RUDDER, THROTTLE };      ///< the controls
    enum { WIND_SPEED, WIND_DIRECTION, GUSTS };  ///< the settings

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
    void fillProfile();
    real getHeight() const { return log.getHeight(aircraft.getBody()); }

    Wind wind;
    Aircraft aircraft;
    Pilot pilot;
    Pilot::Leg lastLeg = Pilot::Leg::WATCH;
    real propellerAngle = 0;
    FlightLog log;
};

}  // namespace flightsim
