#pragma once

/// What flies or sails, as the loop sees it. The loop runs any Demonstration: in a terminal, from a script or
/// under its own pilot, and makes table, CSV file, page, still and head-up display from what it finds here.
#include "replay/recording.h"
#include "terminal/keys.h"

#include <cstddef>
#include <cstdint>
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
    bool centres = true;  ///< whether the centring key puts it to neutral
};

/// A number on the command line that shapes the run, as in `--wind 3`.
struct Setting {
    std::string name, placeholder, help;
    real value = 0, low = 0, high = 1;  ///< the default, and the range
};

/// A number that is told of every step: in the CSV file, and if asked for in the table and the page's plots.
struct Quantity {
    std::string name, unit;
    std::string panel;  ///< the plot it is drawn in, with others of the same unit; empty: none
    int decimals = -1;  ///< in the table; negative: not in it
};

/// From where one can look: besides chase (behind) and side, there is a spectator who stays in one place.
struct Outlook {
    Vector3 spectator{0, 1.7, 20};  ///< m
    real distance = 6;              ///< m, of chase and side at zoom 1
    real height = 0;                ///< m above the vehicle's origin: what the cameras aim at
    real windHeight = 1;            ///< m above the vehicle's origin: where the wind is shown
    bool spectatorFollows = false;  ///< the spectator keeps the offset to the vehicle, as from another boat
};

/// What stays the same for a demonstration.
struct Profile {
    std::string program;            ///< its name on the command line
    std::string summary;            ///< the sentence that --help begins with
    std::vector<Setting> settings;  ///< --seed exists besides
    std::vector<Control> controls;
    Key centre = 'x';               ///< puts the controls to neutral
    std::vector<std::string> help;  ///< lines about its own keys, for the help box
    std::vector<Quantity> quantities;
    std::string title, kind;  ///< of the page, see Subject
    Surroundings surroundings;
    std::vector<Part> parts;   ///< parts[0] is the vehicle's body, +X forward
    std::vector<Part> paint;   ///< flat marks on the ground, world coordinates: a runway
    real newtonsPerMetre = 0;  ///< scale of the force arrows
    Outlook outlook;
    real step = 1.0 / 120;  ///< s, of the simulation
    real duration = 60;     ///< s, the longest run without a terminal when nobody says
};

/// A world with one vehicle in it. The same seed, settings and controls at the same steps give the same
/// run, bit by bit.
class Demonstration {
public:
    virtual ~Demonstration() = default;
    Demonstration(const Demonstration &) = delete;
    Demonstration &operator=(const Demonstration &) = delete;

    virtual const Profile &getProfile() const = 0;

    /// Begins a run at time 0; one value for each of the profile's settings. The controls are at neutral.
    virtual void begin(std::uint64_t seed, const std::vector<real> &settings) = 0;

    /// Puts the vehicle back to where it began, controls at neutral, while time and weather go on.
    virtual void startOver() = 0;

    /// The pilot: sets the controls for the next step. Whoever wants another pilot doesn't call it.
    virtual void steer() = 0;

    /// Advances by the profile's step with the controls as they are.
    virtual void step() = 0;

    /// Whether the pilot has done all it set out to do.
    virtual bool isOver() const { return false; }

    /// s since begin(): steps taken times the step.
    virtual real getTime() const = 0;

    /// The moment as it is now: a pose for each part (not for paint), a value for each quantity, the same
    /// arrows every time. `cut` is true in the first frame after the vehicle was put somewhere.
    virtual Frame getFrame() const = 0;

    /// One line for the head-up display, the most important first; it is cut off where the screen ends.
    virtual std::string getHeadUpLine() const = 0;

    /// What has happened in words since the run began, a line or more. Without the hash.
    virtual std::string getSummary() const = 0;

    /// Of the whole state: equal states have equal hashes on every machine.
    virtual std::uint64_t getHash() const = 0;

    /// What happened since the last call.
    std::vector<Event> takeEvents() { return std::exchange(events, {}); }

    /// By index into the profile's controls. Values beyond the range become its nearer end; NaN throws.
    void setControl(std::size_t index, real value);
    real getControl(std::size_t index) const { return controls.at(index); }
    /// All to neutral.
    void resetControls();
    /// Those that centre to neutral: what the centring key does.
    void centreControls();

protected:
    Demonstration() = default;
    void tell(const std::string &text) { events.push_back({getTime(), text}); }

private:
    std::vector<real> controls;  // filled by resetControls()
    std::vector<Event> events;
};

}  // namespace demo
