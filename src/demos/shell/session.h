#pragma once

/// One run of a demonstration, step by step: who steers it, and what is kept of it.
#include "replay/recording.h"
#include "shell/script.h"

#include <iosfwd>

namespace demo {

/// Who sets the controls.
enum class Driver { PILOT, SCRIPT, HANDS };

class Session {
public:
    /// Begins the run. With a script, the script drives; else the pilot does. What the script says of seed
    /// and settings is for the caller to read.
    Session(Demonstration &demonstration, std::uint64_t seed, const std::vector<real> &settings,
            std::optional<Script> script = std::nullopt);

    /// Every step from now on as a line of a CSV file; the stream must outlive the session.
    void writeCsvTo(std::ostream &out);
    /// Keeps frames for a page, thirty a second.
    void keepFrames();

    /// One step: inputs, physics, records. A pilot who is wrecked tries again after a while.
    void step();

    /// Whether the pilot has done its work or the script has come to its end.
    bool isOver() const;

    /// Takes the controls: the script's or pilot's part is over until they get them back. Sticks that spring
    /// are at neutral then: whoever takes over has not felt how they were held.
    void takeControls();
    void givePilotControls() { driver = Driver::PILOT; }
    Driver getDriver() const { return driver; }

    /// Back to the start, and recorded as such.
    void restart();

    /// The moment after the last step.
    const Frame &getFrame() const { return frame; }
    /// The quantities at that moment.
    const std::vector<real> &getValues() const { return values; }
    /// What happened since the last call.
    std::vector<Event> takeEvents() { return std::exchange(news, {}); }

    /// Summary and state hash, some lines.
    std::string getReport() const;
    /// The inputs so far.
    Script getInputs() const;
    /// The page, if keepFrames() was called.
    void writePageTo(std::ostream &out);

private:
    void playScript();
    void noteInputs();
    void keep();
    void look();

    Demonstration &demonstration;
    std::optional<Script> script;
    Driver driver;
    std::size_t nextChange = 0;
    std::uint64_t steps = 0;
    Script inputs;
    std::vector<real> noted;  ///< the controls' values in `inputs`
    Frame frame;
    std::vector<real> values;
    std::vector<Event> news;
    std::ostream *csv = nullptr;
    std::optional<Recording> recording;
    std::uint64_t interval = 1;  ///< steps from one frame kept to the next
    bool cutPending = false;
};

}  // namespace demo
