#include "terminal/terminal.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "terminal/terminal_device.h"

namespace demo {

namespace {

using Clock = std::chrono::steady_clock;

/// An Esc that isn't followed by anything for this long was the Esc key.
constexpr std::chrono::milliseconds ESCAPE_TIME(30);

std::string environment(const char *name) {
    const char *value = std::getenv(name);
    return value ? value : "";
}

ColourDepth promisedColours() {
    const std::string promise = environment("COLORTERM");
#ifdef _WIN32
    if (promise.empty()) return ColourDepth::TRUECOLOUR;  // every console that knows sequences at all
#endif
    return promise == "truecolor" || promise == "24bit" ? ColourDepth::TRUECOLOUR : ColourDepth::PALETTE;
}

CellGrid cutTo(const CellGrid &picture, int columns, int rows) {
    CellGrid result(std::min(picture.columns, columns), std::min(picture.rows, rows));
    for (int row = 0; row < result.rows; ++row)
        for (int column = 0; column < result.columns; ++column)
            result.at(column, row) = picture.at(column, row);
    return result;
}

}  // namespace

bool Terminal::isInteractive() {
    return isTerminal(STANDARD_INPUT) && isTerminal(STANDARD_OUTPUT) && environment("TERM") != "dumb";
}

Terminal::Terminal() : lastWait_(Clock::now()), depth_(promisedColours()) {
    if (!isInteractive()) throw std::runtime_error("standard input and output are not a terminal");
    if (!device::take()) throw std::runtime_error("the terminal cannot be switched to single keys");
}

Terminal::~Terminal() { device::giveBack(); }

bool Terminal::isOpen() {
    const device::Events events = device::handleEvents();
    if (events.redraw) shown_ = CellGrid();
    if (events.signal != 0) signal_ = events.signal;
    ended_ = ended_ || signal_ != 0;
    return !ended_;
}

int Terminal::exitStatus() const { return signal_ == 0 ? 0 : 128 + signal_; }

int Terminal::columns() const { return device::size().columns; }
int Terminal::rows() const { return device::size().rows; }

Key Terminal::readKey() {
    const std::size_t before = typed_.size();
    if (!device::read(typed_)) ended_ = true;
    const Clock::time_point now = Clock::now();
    if (typed_.size() != before) lastTyped_ = now;
    return takeKey(typed_, now - lastTyped_ > ESCAPE_TIME);
}

void Terminal::show(const CellGrid &picture) {
    const bool fits = picture.columns <= columns() && picture.rows <= rows();
    const std::string changes =
        encodeChanges(shown_, fits ? picture : cutTo(picture, columns(), rows()), depth_);
    if (changes.empty()) return;
    if (!device::write("\x1b[?2026h" + changes + "\x1b[0m\x1b[?2026l")) ended_ = true;
}

void Terminal::wait(double seconds) {
    const std::chrono::duration<double> period(std::max(seconds, 0.0));
    const std::chrono::duration<double> left = lastWait_ + period - Clock::now();
    if (left.count() > 0) device::sleep(left.count());
    lastWait_ = Clock::now();
}

}  // namespace demo
