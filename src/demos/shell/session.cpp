#include "shell/session.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace demo {

namespace {

constexpr real FRAMES_PER_SECOND = 30;

std::string written(real value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.10g", value == 0 ? 0 : value);  // no sign on a zero
    return text;
}

void writeCsvLine(std::ostream &out, const Frame &frame) {
    out << written(frame.time);
    for (const real value : frame.values) out << ',' << written(value);
    out << '\n';
}

Subject makeSubject(const Profile &profile) {
    Subject subject;
    subject.title = profile.title;
    subject.kind = profile.kind;
    subject.surroundings = profile.surroundings;
    subject.parts = profile.parts;
    subject.paint = profile.paint;
    subject.newtonsPerMetre = profile.newtonsPerMetre;
    for (const Quantity &quantity : profile.quantities)
        if (!quantity.panel.empty())
            subject.channels.push_back({quantity.name, quantity.unit, quantity.panel});
    return subject;
}

/// With the values that the page plots.
Frame forRecording(Frame frame, const Profile &profile) {
    std::vector<real> values;
    for (std::size_t n = 0; n < frame.values.size(); ++n)
        if (!profile.quantities[n].panel.empty()) values.push_back(frame.values[n]);
    frame.values = values;
    return frame;
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
    frame = demonstration.getFrame();
}

void Session::writeCsvTo(std::ostream &out) {
    csv = &out;
    out << "time [s]";
    for (const Quantity &quantity : demonstration.getProfile().quantities)
        out << ',' << quantity.name << (quantity.unit.empty() ? "" : " [" + quantity.unit + "]");
    out << '\n';
    writeCsvLine(out, frame);
}

void Session::keepFrames() {
    recording.emplace(makeSubject(demonstration.getProfile()));
    recording->append(forRecording(frame, demonstration.getProfile()));
}

void Session::step() {
    if (driver == Driver::PILOT)
        demonstration.steer();
    else if (driver == Driver::SCRIPT)
        playScript();
    noteInputs();
    demonstration.step();
    ++steps;
    keep();
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

void Session::restart() {
    demonstration.startOver();
    inputs.changes.push_back({steps, Script::RESTART, 0});
    for (std::size_t n = 0; n < noted.size(); ++n) noted[n] = demonstration.getControl(n);
    frame = demonstration.getFrame();
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
    frame = demonstration.getFrame();
    // Whatever put the vehicle back put its controls back too: a script need not say so.
    cutPending = cutPending || frame.cut;
    if (frame.cut)
        for (std::size_t n = 0; n < noted.size(); ++n) noted[n] = demonstration.getControl(n);
    if (csv) writeCsvLine(*csv, frame);
    for (const Event &event : demonstration.takeEvents()) {
        news.push_back(event);
        if (recording) recording->addEvent(event.time, event.text);
    }
    if (recording && steps % interval == 0) {
        Frame kept = forRecording(frame, demonstration.getProfile());
        kept.cut = cutPending;
        recording->append(kept);
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
