#pragma once

/// The demonstration that soars: the glider, an airfield, thermals under their clouds, and a pilot.
#include "flightsim/landing.h"
#include "flightsim/soarer.h"
#include "flightsim/weather.h"
#include "shell/demo.h"

namespace flightsim {

class Soaring : public Demonstration {
public:
    enum { PULL, ROLL, RUDDER, BRAKES };               ///< the controls
    enum { WIND_SPEED, WIND_DIRECTION, GUSTS, LIFT };  ///< the settings
    static constexpr real HARDEST_TOUCH_DOWN = 3;      ///< m/s downwards: what is harder is a crash
    static constexpr Runway RUNWAY{60, -60};           ///< m: what one aims at
    static const Landing WORST_LANDING;                ///< that is still fair
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
    /// For the summary.
    struct Log {
        LandingLog landings;
        unsigned crashes = 0;
        real highest = 0, distance = 0;
    };

    void fillProfile();
    void readVario();
    void watchTheGround();
    void crash(const std::string &how);
    real getHeight() const { return glider.getBody().getPosition().y - Glider::WHEEL_HEIGHT; }

    Weather weather;
    Glider glider;
    Vector3 windFrom;
    Soarer pilot;
    Soarer::Leg lastLeg = Soarer::Leg::SEARCH;
    Vector3 lastPosition, lastVelocity;  ///< before the step
    real lastEnergyHeight = 0, vario = 0;
    bool airborne = true;
    Log log;
};

}  // namespace flightsim
