#pragma once

/// The catamaran as a demonstration: the boat, her sea and wind, marks to sail round, and a skipper.
#include "base/random.h"
#include "sailboat/boat.h"
#include "sailboat/skipper.h"
#include "shell/demo.h"

#include <memory>

namespace demo {

/// What sailors call a course at this angle (rad, either side) to the true wind.
const char *pointOfSail(real trueWindAngle);

/// Controls: 0 the rudder, 1 the sail, degrees, to starboard positive. Settings: the wind's mean speed and
/// its gusts (m/s, from the north), the height of the waves (m).
///
/// A boat that has capsized is righted by her crew after a while, where she lies.
class Sailing : public Demonstration {
public:
    Sailing();
    ~Sailing() override;

    const Profile &getProfile() const override { return profile; }
    void begin(std::uint64_t seed, const std::vector<real> &settings) override;
    void startOver() override;
    void steer() override;
    void step() override;
    bool isOver() const override;
    real getTime() const override;
    Frame getFrame() const override;
    std::string getHeadUpLine() const override;
    std::string getSummary() const override;
    std::uint64_t getHash() const override;

    const Catamaran &getBoat() const;

private:
    struct Voyage;

    void setWaves(real height);
    void applyControls();
    void keepLog();
    void rightIfCapsized();
    std::vector<Arrow> getArrows() const;
    std::vector<real> getValues() const;

    Profile profile;
    std::unique_ptr<Voyage> voyage;
};

}  // namespace demo
