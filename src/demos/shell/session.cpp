#include "shell/session.h"

#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace demo {

namespace {

constexpr real FRAMES_PER_SECOND = 30;
constexpr real PILOTS_PAUSE = 4;  // s beside a wreck

void writeCsvLine(std::ostream &out, real time, const std::vector<real> &values) {
    const auto written = [](real value) { return significant(value == 0 ? 0 : value, 10); };  // no sign on 0
    out << written(time);
    for (const real value : values) out << ',' << written(value);
    out << '\n';
}

Subject makeSubject(const Demonstration &demonstration) {
    const Profile &profile = demonstration.getProfile();
    Subject subject;
    subject.title = profile.title;
    subject.kind = profile.kind;
    subject.scene = demonstration.getScene();
    for (const Quantity &quantity : profile.quantities)
        if (!quantity.panel.empty())
            subject.channels.push_back({quantity.name, quantity.unit, quantity.panel});
    return subject;
}

/// Those that the page plots.
std::vector<real> getPlotted(const std::vector<real> &values, const Profile &profile) {
    std::vector<real> plotted;
    for (std::size_t n = 0; n < values.size(); ++n)
        if (!profile.quantities[n].panel.empty()) plotted.push_back(values[n]);
    return plotted;
}

}  // namespace

Session::Session(Demonstration &d, std::uint64_t seed, const std::vector<real> &settings,
                 std::optional<Script> s)
    : demonstration(d), script(std::move(s)), driver(script ? Driver::SCRIPT : Driver::PILOT) {
    const Profile &profile = demonstration.getProfile();
    demonstration.begin(seed, settings);
    inputs.seed = seed;
    for (const real value : settings) inputs.settings.push_back(value);
    for (const Control &control : profile.controls) noted.push_back(control.neutral);
    interval = static_cast<std::uint64_t>(std::max(std::lround(1 / FRAMES_PER_SECOND / profile.step), 1L));
    look();
}

void Session::look() {
    frame = demonstration.getFrame();
    values = demonstration.getValues();
}

void Session::writeCsvTo(std::ostream &out) {
    csv = &out;
    out << "time [s]";
    for (const Quantity &quantity : demonstration.getProfile().quantities)
        out << ',' << quantity.name << (quantity.unit.empty() ? "" : " [" + quantity.unit + "]");
    out << '\n';
    writeCsvLine(out, frame.time, values);
}

void Session::keepFrames() {
    recording.emplace(makeSubject(demonstration));
    recording->append(frame, getPlotted(values, demonstration.getProfile()));
}

void Session::step() {
    const bool isWrecked = !demonstration.getWreck().empty();
    frame.cut = false;
    if (driver == Driver::PILOT && !isWrecked)
        demonstration.steer();
    else if (driver == Driver::SCRIPT)
        playScript();
    noteInputs();
    demonstration.step();
    ++steps;
    keep();
    if (driver == Driver::PILOT && isWrecked && demonstration.getTimeSinceWreck() >= PILOTS_PAUSE) restart();
}

void Session::playScript() {
    for (; nextChange < script->changes.size() && script->changes[nextChange].step <= steps; ++nextChange) {
        const Script::Change &change = script->changes[nextChange];
        if (change.control == Script::RESTART)
            restart();
        else
            demonstration.setControl(change.control, change.value);
    }
}

void Session::takeControls() {
    if (driver != Driver::HANDS) demonstration.releaseSticks(1);
    driver = Driver::HANDS;
}

void Session::restart() {
    demonstration.startOver();
    inputs.changes.push_back({steps, Script::RESTART, 0});
    for (std::size_t n = 0; n < noted.size(); ++n) noted[n] = demonstration.getControl(n);
    look();
    frame.cut = cutPending = true;
}

void Session::noteInputs() {
    for (std::size_t n = 0; n < noted.size(); ++n) {
        const real value = demonstration.getControl(n);
        if (value == noted[n]) continue;
        inputs.changes.push_back({steps, n, value});
        noted[n] = value;
    }
}

void Session::keep() {
    const bool restarted = frame.cut;  // by the script, before the step
    look();
    frame.cut = frame.cut || restarted;
    // Whatever put the vehicle back put its controls back too: a script need not say so.
    cutPending = cutPending || frame.cut;
    if (frame.cut)
        for (std::size_t n = 0; n < noted.size(); ++n) noted[n] = demonstration.getControl(n);
    if (csv) writeCsvLine(*csv, frame.time, values);
    for (const Event &event : demonstration.takeEvents()) {
        news.push_back(event);
        if (recording) recording->addEvent(event.time, event.text);
    }
    if (recording && steps % interval == 0) {
        Frame kept = frame;
        kept.cut = cutPending;
        recording->append(kept, getPlotted(values, demonstration.getProfile()));
        cutPending = false;
    }
}

bool Session::isOver() const {
    if (driver == Driver::PILOT) return demonstration.isOver();
    return driver == Driver::SCRIPT && script->end && steps >= *script->end;
}

std::string Session::getReport() const {
    char hash[40];
    std::snprintf(hash, sizeof hash, "State hash: %016llx",
                  static_cast<unsigned long long>(demonstration.getHash()));
    return demonstration.getSummary() + "\n" + hash;
}

Script Session::getInputs() const {
    Script result = inputs;
    result.end = steps;
    return result;
}

void Session::writePageTo(std::ostream &out) {
    recording->setSummary(getReport());
    writePage(out, *recording);
}

}  // namespace demo
