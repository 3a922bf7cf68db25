#pragma once

/// What flies or sails, as the shell sees it. The shell runs any Demonstration: in a terminal, from a script
/// or under its own pilot, and makes table, CSV file, page, still and head-up display from what it finds
/// here.
#include "picture/horizon.h"
#include "picture/scene.h"
#include "terminal/keys.h"

#include <cyclone/world.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace demo {

/// Something that keys, a script or the pilot set: a stick, a sheet, the throttle.
struct Control {
    std::string name;                          ///< one word, for scripts
    real low = -1, high = 1, neutral = 0;      ///< it starts at neutral
    Key less = keys::NONE, more = keys::NONE;  ///< each stroke changes it by `stroke`
    real stroke = 0.1;
    bool centres = true;   ///< whether the centring key puts it to neutral
    bool springs = false;  ///< a stick that would spring back to neutral if its hand let go
};

/// A number on the command line that shapes the run, as in `--wind 3`.
struct Setting {
    std::string name, placeholder, help;
    real value = 0, low = 0, high = 1;  ///< the default, and the range
};

/// A number that is told of every step: in the CSV file, and if asked for in the table and the page's plots.
struct Quantity {
    std::string name, unit;
    std::function<real()> get;  ///< its value now
    std::string panel{};        ///< the plot it is drawn in, with others of the same unit; empty: none
    int decimals = -1;          ///< in the table; negative: not in it
};

/// What a run hands on to later ones, in a file of the user's choice, as in `--best laps.txt`.
struct Archive {
    std::string name{}, help{};  ///< of the option; without a name there is none
    /// Takes what earlier runs have written, nothing at first; throws std::runtime_error with what is wrong.
    std::function<void(const std::string &text)> read{};
    /// The text that is to take its place; nothing if nothing is new.
    std::function<std::optional<std::string>()> write{};
};

/// The words of a command line's option, of which one says what runs, as in `--aircraft glider`.
struct Choice {
    std::string name, help;
    std::vector<std::string> words;  ///< the first is the default
};

/// What stays the same for a demonstration.
struct Profile {
    std::string program;            ///< its name on the command line
    std::string variant{};          ///< which of the program's demonstrations, as in "aircraft glider"
    std::string summary;            ///< the sentence that --help begins with
    std::string title, kind;        ///< of the page; kind: a word or two above the title, such as "flight"
    std::vector<Setting> settings;  ///< --seed exists besides
    std::vector<Control> controls;
    Key centre = 'x';               ///< puts the controls to neutral
    std::vector<std::string> help;  ///< lines about its own keys, for the help box
    std::vector<Quantity> quantities;
    Archive archive{};
    real wreckMotion = 0;   ///< s: so long a wreck drifts or flies apart; then it stays where it is
    real step = 1.0 / 120;  ///< s, of the simulation
    real duration = 60;     ///< s, the longest run without a terminal when nobody says
};

/// A world and what happens in it. The same seed, settings and controls at the same steps give the same run,
/// bit by bit.
///
/// A program derives from it, fills in profile and scene, puts its vehicles into the world, and calls begin()
/// at the end of its constructor.
class Demonstration {
public:
    virtual ~Demonstration() = default;
    Demonstration(const Demonstration &) = delete;
    Demonstration &operator=(const Demonstration &) = delete;

    const Profile &getProfile() const { return profile; }
    /// Its waves, fixtures and paint may change in begin(); nothing does during a run.
    const Scene &getScene() const { return scene; }

    /// Begins a run at time 0; one value for each of the profile's settings. The controls are at neutral.
    void begin(std::uint64_t seed, const std::vector<real> &settings);
    /// The same with the settings' defaults.
    void begin(std::uint64_t seed);

    /// Puts the vehicle back to where it began, controls at neutral, while time and weather go on.
    void startOver();

    /// What has ended the vehicle's run, such as "crashed: a wing hit the ground"; empty while it goes on.
    /// The wreck remains until startOver(), while time goes on.
    const std::string &getWreck() const { return wreck; }
    /// s since then.
    real getTimeSinceWreck() const { return static_cast<real>(steps - wreckedAt) * profile.step; }

    /// The pilot: sets the controls for the next step. Whoever wants another pilot doesn't call it.
    virtual void steer() = 0;

    /// Advances by the profile's step with the controls as they are.
    void step();

    /// Whether the pilot has done all it set out to do.
    virtual bool isOver() const { return false; }

    /// s since begin(): steps taken times the step.
    real getTime() const { return static_cast<real>(steps) * profile.step; }

    /// The moment as it is now. It is a cut until the first step after the vehicle was put somewhere.
    Frame getFrame() const;

    /// The quantities' values now.
    std::vector<real> getValues() const;

    /// One line for the head-up display, the most important first, two blanks between one thing and the next:
    /// a narrow screen breaks it there, and a low one leaves out the end.
    virtual std::string getHeadUpLine() const = 0;

    /// For the artificial horizon; nothing: none is drawn.
    virtual std::optional<Attitude> getAttitude() const { return std::nullopt; }

    /// What has happened in words since the run began, a line or more. Without the hash.
    virtual std::string getSummary() const = 0;

    /// Of the whole state: equal states have equal hashes on every machine.
    virtual std::uint64_t getHash() const { return world.hash(); }

    /// What happened since the last call.
    std::vector<Event> takeEvents() { return std::exchange(events, {}); }

    /// By index into the profile's controls. Values are clamped to the range; NaN throws.
    void setControl(std::size_t index, real value);
    real getControl(std::size_t index) const { return controls.at(index); }
    /// Those that centre to neutral: what the centring key does.
    void centreControls();
    /// Those that spring: each goes this share of its range towards neutral, and no farther.
    void releaseSticks(real share);

protected:
    Demonstration() = default;

    /// @name A program's part
    /// @{
    /// Makes weather, course and log anew; one value for each setting. launch() follows.
    virtual void prepare(std::uint64_t seed, const std::vector<real> &settings) = 0;
    /// Puts the vehicle to where it begins. The controls are at neutral.
    virtual void launch() = 0;
    /// Before each step: controls, wind and water.
    virtual void beforeStep() = 0;
    /// After each step: what has come of it.
    virtual void afterStep() = 0;
    /// The parts' poses in the scene's order.
    virtual std::vector<Pose> getPoses() const = 0;
    /// In the scene's scale.
    virtual std::vector<Arrow> getArrows() const { return {}; }
    virtual Vector3 getWindspeed() const { return Vector3(); }
    /// @}

    void tell(const std::string &text) { events.push_back({getTime(), text}); }
    /// Ends the vehicle's run, and tells why.
    void wreckBy(const std::string &cause);
    /// The vehicle has been put somewhere by hand: nothing is drawn between there and where it was.
    void markCut() { isCut = true; }

    Profile profile;
    Scene scene;
    cyclone::World world;

private:
    std::uint64_t steps = 0, wreckedAt = 0;
    std::string wreck;
    bool isCut = true;
    std::vector<real> controls;
    std::vector<Event> events;
};

}  // namespace demo
