#pragma once

/// What Terminal needs from the operating system, besides isTerminal(). terminal_posix.cpp and
/// terminal_windows.cpp provide it, each empty on the other's system.
#include "terminal/terminal.h"

#include <string>

namespace demo::device {

/// Raw keys, alternate screen, and handlers for signals; false if the terminal refuses.
bool take();
/// Undoes take().
void giveBack();

/// What has happened since the last call. If suspension was asked for, the program stops in here.
struct Events {
    bool redraw = false;  ///< the screen no longer shows what was written last
    int signal = 0;       ///< the one that asked the program to end; 0: none
};
Events handleEvents();

struct Size {
    int columns = 80, rows = 24;
};
Size size();

/// Appends the bytes typed so far; false once there won't be any more. Doesn't wait.
bool read(std::string &bytes);

/// Writes everything; false if the terminal is gone or a signal asks the program to end.
bool write(const std::string &bytes);

/// Returns early if a signal comes.
void sleep(double seconds);

}  // namespace demo::device
