#pragma once

/// The terminal that the program runs in, taken for the time of one run and always given back.
#include "picture/cells.h"
#include "terminal/keys.h"

#include <chrono>
#include <string>

namespace demo {

/// Numbered as the systems do.
enum Stream { STANDARD_INPUT, STANDARD_OUTPUT, STANDARD_ERROR };
bool isTerminal(Stream stream);

/// Takes the terminal: raw keys, alternate screen, hidden cursor. Gives it back exactly as it was when the
/// object ends, and also when the program is suspended (Ctrl-Z), crashes, calls std::exit or dies of an
/// uncaught exception.
///
/// Ctrl-C, SIGTERM, a hang-up and the end of the input don't kill the program: isOpen() becomes false, and
/// the caller leaves its loop, saves what it has to save, and returns exitStatus(). A second Ctrl-C or
/// SIGTERM that comes before the loop has noticed the first gives the terminal back and ends the program at
/// once.
///
/// A frame of a demo's loop: while isOpen(), take every key with readKey(), draw to the size of columns() ×
/// rows(), show() the picture, wait().
class Terminal {
public:
    /// True if standard input and output are both terminals that can show pictures (TERM is not "dumb").
    static bool isInteractive();

    /// Throws std::runtime_error if not isInteractive() or if the terminal can't be taken, and
    /// std::logic_error if another Terminal exists.
    Terminal();
    ~Terminal();
    Terminal(const Terminal &) = delete;
    Terminal &operator=(const Terminal &) = delete;

    /// False once the run should end. If the program was suspended or the window resized, this is also where
    /// it stops, and where it takes the terminal again: call it once a frame.
    bool isOpen();
    /// 128 + the signal that ended the run, as shells have it; 0 if none did.
    int exitStatus() const;

    /// The size in characters, current at every call; 80 × 24 if the terminal doesn't say.
    int columns() const;
    int rows() const;

    /// The next key that was typed, or keys::NONE. Doesn't wait.
    Key readKey();

    /// Shows a picture, cut off at the terminal's edge. Only what has changed is written, as one synchronised
    /// update.
    void show(const CellGrid &picture);

    /// Sleeps until `seconds` after the last wait() ended, so that a loop runs at an even pace however long
    /// its work took; returns at once if that time has passed already. A signal ends it early.
    void wait(double seconds);

private:
    CellGrid shown_;
    std::string typed_;
    std::chrono::steady_clock::time_point lastTyped_{}, lastWait_{};
    ColourDepth depth_;
    bool ended_ = false;
    int signal_ = 0;
};

}  // namespace demo
