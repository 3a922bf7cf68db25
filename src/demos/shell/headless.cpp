#include "shell/run.h"

#include "base/text.h"
#include "picture/png.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ostream>
#include <stdexcept>
#include <utility>

namespace demo {

namespace {

constexpr int STILL_WIDTH = 1024, STILL_HEIGHT = 512;
constexpr real TIME_TOLERANCE = 1e-6;    // s
constexpr real PROGRESS_INTERVAL = 0.5;  // s of the wall clock

/// Columns as wide as their heading or their numbers need.
class Table {
public:
    Table(const Profile &p, std::ostream &o) : profile(p), out(o) {}

    void printHeading() {
        std::string names = "    time", units = "       s";
        for (const Quantity &quantity : profile.quantities) {
            if (quantity.decimals < 0) continue;
            names += "  " + padded(quantity.name, width(quantity));
            units += "  " + padded(quantity.unit, width(quantity));
        }
        out << names << '\n' << units << '\n';
    }

    void print(real time, const std::vector<real> &values) {
        std::string line = number(time, 8, 1);
        for (std::size_t n = 0; n < profile.quantities.size(); ++n) {
            const Quantity &quantity = profile.quantities[n];
            if (quantity.decimals < 0) continue;
            line += "  " + number(values[n], width(quantity), quantity.decimals);
        }
        out << line << '\n';
    }

    void print(const Event &event) { out << number(event.time, 8, 1) << "  * " << event.text << '\n'; }

private:
    static std::size_t width(const Quantity &quantity) {
        return std::max<std::size_t>(quantity.name.size(), 5 + static_cast<std::size_t>(quantity.decimals));
    }
    static std::string padded(const std::string &text, std::size_t columns) {
        // Characters, not bytes: those that go on in UTF-8 don't count.
        const auto length = static_cast<std::size_t>(std::count_if(
            text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
        return std::string(columns - std::min(columns, length), ' ') + text;
    }
    static std::string number(real value, std::size_t columns, int decimals) {
        return padded(fixed(value, decimals), columns);
    }

    const Profile &profile;
    std::ostream &out;
};

/// "42 of 600 s" on one line that is written over again and again, and wiped away at the end.
class Progress {
public:
    Progress(std::ostream *o, real seconds) : out(o), total(seconds) {}
    ~Progress() {
        if (shown) *out << "\r\x1b[K" << std::flush;
    }
    void show(real time) {
        const auto now = std::chrono::steady_clock::now();
        if (!out || std::chrono::duration<real>(now - last).count() < PROGRESS_INTERVAL) return;
        last = now;
        shown = true;
        *out << '\r' << std::lround(time) << " of " << std::lround(total) << " s" << std::flush;
    }

private:
    std::ostream *out;
    real total;
    std::chrono::steady_clock::time_point last = std::chrono::steady_clock::now();
    bool shown = false;
};

}  // namespace

Photographer::Photographer(const Still &s, const Scene &scene) : still(s), stage(scene) {
    stage.viewpoint = still.viewpoint;
    stage.zoom = still.zoom;
    stage.showForces = true;
}

void Photographer::show(const Frame &frame) {
    if (!still.out) return;
    stage.follow(frame);
    if (frame.time >= still.time - TIME_TOLERANCE) take(frame);
}

void Photographer::finish(const Frame &frame) {
    if (still.out) take(frame);
}

void Photographer::take(const Frame &frame) {
    Canvas canvas;
    stage.draw(canvas, STILL_WIDTH, STILL_HEIGHT / 2, frame, 0);
    writePng(*std::exchange(still.out, nullptr), canvas.image());
}

void runHeadless(Session &session, Demonstration &demonstration, std::optional<real> seconds,
                 const Still &still, std::ostream &out, std::ostream *progressOut) {
    const Profile &profile = demonstration.getProfile();
    const real total = seconds.value_or(profile.duration);
    const auto steps = std::lround(total / profile.step);
    const auto perLine = std::max(std::lround(1 / profile.step), 1L);

    Table table(profile, out);
    Progress progress(progressOut, total);
    table.printHeading();
    table.print(session.getFrame().time, session.getValues());
    Photographer photographer(still, demonstration.getScene());
    photographer.show(session.getFrame());
    for (long n = 1; n <= steps; ++n) {
        if (session.isOver()) {
            if (session.getDriver() != Driver::PILOT || !seconds) break;
            session.restart();
        }
        session.step();
        for (const Event &event : session.takeEvents()) table.print(event);
        if (n % perLine == 0) table.print(session.getFrame().time, session.getValues());
        if (!out) throw std::runtime_error("cannot write to the standard output");
        photographer.show(session.getFrame());
        progress.show(session.getFrame().time);
    }
    photographer.finish(session.getFrame());
    out << session.getReport() << '\n';
}

}  // namespace demo
