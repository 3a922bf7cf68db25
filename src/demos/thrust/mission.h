#pragma once

/// Thrust as a demonstration: a level, the ship and her pod, gusts, and a pilot. The pod is to be fetched and
/// carried out into the sky above the map; whatever of ship, rod and pod touches rock on the way is the end.
#include "base/random.h"
#include "shell/demo.h"
#include "thrust/pilot.h"

namespace thrust {

using namespace demo;

class Mission : public Demonstration {
public:
    enum { HEADING, THRUST };  ///< the controls: degrees, positive to the right; 0 … 1
    enum { GUSTS };            ///< the settings: m/s

    static constexpr real HOOK_REACH = 0.8;  ///< m, from the ship's middle to the rod's end

    /// One of the program's levels, or any other.
    explicit Mission(std::size_t level);
    explicit Mission(Level level);

    void steer() override;
    bool isOver() const override { return fetched; }
    std::string getHeadUpLine() const override;
    std::string getSummary() const override;

    const Level &getLevel() const { return level; }
    const Ship &getShip() const { return ship; }
    Ship &getShip() { return ship; }
    real getFuel() const { return fuel; }  ///< s of full thrust

protected:
    void prepare(std::uint64_t seed, const std::vector<real> &settings) override;
    void launch() override;
    void beforeStep() override;
    void afterStep() override;
    std::vector<Pose> getPoses() const override;
    std::vector<Arrow> getArrows() const override;
    Vector3 getWindspeed() const override { return windspeed; }

private:
    /// The outlines of what must not touch, world.
    struct Outlines {
        std::vector<Vector3> ship, pod, rod;
    };

    void fillProfile();
    bool isDecided() const { return fetched || !getWreck().empty(); }
    void advanceWind();
    void burn();
    void hookIfReached();
    Outlines getOutlines() const;
    void destroyIfTouching(const char *part, const std::vector<Vector3> &before,
                           const std::vector<Vector3> &after);
    void destroy(const std::string &why);
    void watchTheSky();

    Level level;
    Wind wind;
    Vector3 windspeed;  ///< the wind's, in the plane
    Ship ship;
    Pilot pilot;
    Random random;
    Outlines outlines;  ///< before the step
    real fuel = 0;
    bool fetched = false;
    real topSpeed = 0;
};

}  // namespace thrust
