#ifndef _WIN32

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "terminal/terminal_device.h"

namespace demo::device {

namespace {

/// The screen that applications draw on, without a cursor; and back. An ESC also breaks off a sequence left
/// unfinished.
constexpr char ENTER[] = "\x1b[?1049h\x1b[?25l\x1b[0m\x1b[2J";
constexpr char LEAVE[] = "\x1b[?2026l\x1b[0m\x1b[?25h\x1b[?1049l";

constexpr int END_SIGNALS[] = {SIGINT, SIGTERM, SIGHUP};
constexpr int CRASH_SIGNALS[] = {SIGQUIT, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};
constexpr int SIGNALS = 32;  // more than the highest number of those handled here

/// The one exception to "no mutable globals": a process has one controlling terminal, and a signal handler
/// can find nothing but globals. Everything that handlers touch is here.
struct {
    termios before;                     // the terminal as it was; valid while `taken`
    struct sigaction old[SIGNALS];      // what to restore; valid while `owned`
    bool owned = false;                 // a Terminal exists
    volatile sig_atomic_t taken = 0;    // raw, on the alternate screen
    volatile sig_atomic_t end = 0;      // the signal that asked for the end and has not been noticed yet
    volatile sig_atomic_t suspend = 0;  // asked for by Ctrl-Z
    volatile sig_atomic_t resumed = 0;  // SIGCONT: somebody else may have had the terminal
    volatile sig_atomic_t resized = 0;
} state;

// Nothing but async-signal-safe functions from here to "ordinary code".

void writeDirectly(const char *bytes, std::size_t size) {
    while (size > 0) {
        const ssize_t written = ::write(STDOUT_FILENO, bytes, size);
        if (written < 0) return;
        bytes += written;
        size -= static_cast<std::size_t>(written);
    }
}

/// The modes are left alone if another job has the terminal by now: they are its own.
void leaveScreen() {
    if (!state.taken) return;
    state.taken = 0;
    writeDirectly(LEAVE, sizeof LEAVE - 1);
    if (tcgetpgrp(STDIN_FILENO) != getpgrp()) return;
    tcflush(STDIN_FILENO, TCIFLUSH);  // keys meant for us must not reach the shell
    tcsetattr(STDIN_FILENO, TCSANOW, &state.before);
}

void restoreAction(int signal) { sigaction(signal, &state.old[signal], nullptr); }

/// Gives the terminal back and lets the signal do what it would have done without us.
void dieOf(int signal) {
    leaveScreen();
    restoreAction(signal);
    raise(signal);
}

extern "C" void onCrash(int signal) { dieOf(signal); }

extern "C" void onEnd(int signal) {
    if (state.end) dieOf(signal);
    state.end = signal;
}

extern "C" void onSuspend(int) { state.suspend = 1; }
extern "C" void onContinue(int) { state.resumed = 1; }
extern "C" void onResize(int) { state.resized = 1; }

// Ordinary code.

/// A signal that is ignored stays ignored, as nohup wants it.
void handle(int signal, void (*handler)(int)) {
    sigaction(signal, nullptr, &state.old[signal]);
    if (state.old[signal].sa_handler == SIG_IGN) return;
    struct sigaction action {};
    action.sa_handler = handler;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

void handleSignals() {
    for (int signal : END_SIGNALS) handle(signal, onEnd);
    for (int signal : CRASH_SIGNALS) handle(signal, onCrash);
    handle(SIGTSTP, onSuspend);
    handle(SIGCONT, onContinue);
    handle(SIGWINCH, onResize);
}

void restoreSignals() {
    for (int signal : END_SIGNALS) restoreAction(signal);
    for (int signal : CRASH_SIGNALS) restoreAction(signal);
    for (int signal : {SIGTSTP, SIGCONT, SIGWINCH}) restoreAction(signal);
}

/// Single keys, without echo. Ctrl-C and Ctrl-Z stay signals.
termios raw(termios modes) {
    modes.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ECHONL | IEXTEN);
    modes.c_iflag &= ~static_cast<tcflag_t>(IXON | ICRNL | INLCR | IGNCR | ISTRIP);
    modes.c_lflag |= ISIG;
    modes.c_cc[VMIN] = 1;
    modes.c_cc[VTIME] = 0;
    return modes;
}

/// Taken again after another program had it, the terminal's modes are what that one has left: unless `taken`,
/// they are saved again. In the background tcsetattr stops the program until it is in the foreground.
bool enterScreen() {
    if (!state.taken && tcgetattr(STDIN_FILENO, &state.before) != 0) return false;
    state.taken = 1;
    const termios modes = raw(state.before);
    int result;
    do result = tcsetattr(STDIN_FILENO, TCSADRAIN, &modes);
    while (result != 0 && errno == EINTR && !state.end);
    if (result != 0) {
        state.taken = 0;
        return false;
    }
    writeDirectly(ENTER, sizeof ENTER - 1);
    return true;
}

void suspend() {
    leaveScreen();
    restoreAction(SIGTSTP);
    raise(SIGTSTP);  // here the program stands still until it is continued
    handle(SIGTSTP, onSuspend);
}

}  // namespace

bool take() {
    if (state.owned) throw std::logic_error("the terminal is taken already");
    static const int registered = std::atexit(giveBack);
    state.end = state.suspend = state.resumed = state.resized = 0;
    handleSignals();
    state.owned = true;
    if (registered == 0 && enterScreen()) return true;
    giveBack();
    return false;
}

void giveBack() {
    if (!state.owned) return;
    leaveScreen();
    restoreSignals();
    state.owned = false;
}

Events handleEvents() {
    Events events;
    if (state.end) {
        events.signal = state.end;
        state.end = 0;
        return events;
    }
    if (state.suspend) {
        state.suspend = 0;
        suspend();
        state.resumed = 1;
    }
    if (state.resumed) {
        state.resumed = 0;
        if (!state.end && !enterScreen()) events.signal = SIGHUP;
        events.redraw = true;
    }
    if (state.resized) {
        state.resized = 0;
        events.redraw = true;
    }
    return events;
}

Size size() {
    winsize window{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) != 0 || window.ws_col == 0 || window.ws_row == 0) return {};
    return {window.ws_col, window.ws_row};
}

bool read(std::string &bytes) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (poll(&input, 1, 0) <= 0) return true;
    char buffer[256];
    const ssize_t count = ::read(STDIN_FILENO, buffer, sizeof buffer);
    if (count > 0) bytes.append(buffer, static_cast<std::size_t>(count));
    return count > 0 || (count < 0 && (errno == EINTR || errno == EAGAIN));
}

bool write(const std::string &bytes) {
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count = ::write(STDOUT_FILENO, bytes.data() + done, bytes.size() - done);
        if (count > 0) {
            done += static_cast<std::size_t>(count);
        } else if (count < 0 && errno == EAGAIN) {  // whoever shares the terminal has made it non-blocking
            pollfd output{STDOUT_FILENO, POLLOUT, 0};
            poll(&output, 1, 100);
        } else if (count == 0 || errno != EINTR) {
            return false;
        }
        if (state.end) return false;
    }
    return true;
}

void sleep(double seconds) {
    timespec time{};
    time.tv_sec = static_cast<time_t>(seconds);
    time.tv_nsec = static_cast<long>((seconds - std::floor(seconds)) * 1e9);
    nanosleep(&time, nullptr);
}

}  // namespace demo::device

bool demo::isTerminal(Stream stream) { return isatty(stream) == 1; }

#endif
