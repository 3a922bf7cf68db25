#pragma once

/// The demonstration that soars: the glider, an airfield, thermals under their clouds, and a pilot.
#include "flightsim/flightlog.h"
#include "flightsim/soarer.h"
#include "models/weather.h"
#include "shell/demo.h"

namespace flightsim {

class Soaring : public Demonstration {
public:
    enum { PULL, ROLL, RUDDER, BRAKES };               ///< the controls
    enum { WIND_SPEED, WIND_DIRECTION, GUSTS, LIFT };  ///< the settings
    static constexpr real RELEASE_HEIGHT = 350;        ///< m: where the tow ends and a run begins

    Soaring();

    void steer() override;
    bool isOver() const override { return pilot.getLeg() == Soarer::Leg::STOPPED; }
    std::string getHeadUpLine() const override;
    std::optional<Attitude> getAttitude() const override {
        return Attitude{pitchOf(glider.getBody()), bankOf(glider.getBody())};
    }
    std::string getSummary() const override;

    const Glider &getGlider() const { return glider; }
    /// For tests, and for whoever wants to begin elsewhere.
    Glider &getGlider() { return glider; }
    const Weather &getWeather() const { return weather; }
    real getHeightGained() const { return pilot.getHeightGained(); }

protected:
    void prepare(std::uint64_t seed, const std::vector<real> &settings) override;
    void launch() override;
    void beforeStep() override;
    void afterStep() override;
    std::vector<Pose> getPoses() const override;
    std::vector<Arrow> getArrows() const override;
    Vector3 getWindspeed() const override { return -weather.getVelocity(glider.getBody().getPosition()); }

private:
    void fillProfile();
    void readVario();
    std::string getGoals() const;
    real getHeight() const { return log.getHeight(glider.getBody()); }

    Weather weather;
    Glider glider;
    Vector3 windFrom;
    Soarer pilot;
    Soarer::Leg lastLeg = Soarer::Leg::SEARCH;
    real lastEnergyHeight = 0, vario = 0;
    FlightLog log;
};

}  // namespace flightsim
