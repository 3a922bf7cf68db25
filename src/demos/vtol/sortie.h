#pragma once

/// The demonstration: the jet, two pads, wind and a pilot.
#include "models/weather.h"
#include "shell/demo.h"
#include "vtol/pilot.h"

namespace vtol {

class Sortie : public Demonstration {
public:
    enum { PITCH, ROLL, PEDALS, THROTTLE, NOZZLES, STABILISER };  ///< the controls; nozzles in degrees
    enum { WIND_SPEED, WIND_DIRECTION, GUSTS };                   ///< the settings
    static constexpr real HARDEST_TOUCH_DOWN = 4;  ///< m/s downwards: what is harder is a crash

    Sortie();

    void steer() override;
    bool isOver() const override { return pilot.getLeg() == Pilot::Leg::STOPPED && !airborne; }
    std::string getHeadUpLine() const override;
    std::optional<Attitude> getAttitude() const override {
        return Attitude{pitchOf(jet.getBody()), bankOf(jet.getBody())};
    }
    std::string getSummary() const override;

    const Jet &getJet() const { return jet; }
    /// For tests, and for whoever wants to begin elsewhere.
    Jet &getJet() { return jet; }
    bool isStabilised() const { return getControl(STABILISER) >= 0.5; }
    /// How much of the weight wings, tail and fuselage carry; 1: all of it.
    real getWingborne() const { return jet.getAirForce().y / Jet::WEIGHT; }
    /// All landings of the run.
    const std::vector<Landing> &getLandings() const { return landings; }

protected:
    void prepare(std::uint64_t seed, const std::vector<real> &settings) override;
    void launch() override;
    void beforeStep() override;
    void afterStep() override;
    std::vector<Pose> getPoses() const override;
    std::vector<Arrow> getArrows() const override;
    Vector3 getWindspeed() const override { return -weather.getVelocity(jet.getBody().getPosition()); }

private:
    void fillProfile();
    JetControls readControls() const;
    void watchTheStabiliser();
    void watchTheWings();
    void watchTheGround();
    void touchDown();
    void crash(const std::string &how);
    const Pad &getNextPad() const { return PADS[1 - lastPad]; }

    Weather weather;
    Jet jet;
    Vector3 windFrom;
    Pilot pilot;
    Pilot::Leg lastLeg = Pilot::Leg::LIFT_OFF;
    real lastSteered = 0;     ///< s
    std::size_t lastPad = 0;  ///< where she last stood
    Vector3 lastVelocity;     ///< before the step
    bool airborne = false, wingborne = false, stabilised = true;
    std::vector<Landing> landings;
    LandingLog log;
    unsigned crashes = 0, transitions = 0;
};

}  // namespace vtol
