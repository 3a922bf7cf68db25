#ifdef _WIN32

#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include "picture/cells.h"
#include "terminal/terminal_device.h"

namespace demo::device {

namespace {

constexpr char ENTER[] = "\x1b[?1049h\x1b[?25l\x1b[0m\x1b[2J";
constexpr char LEAVE[] = "\x1b[0m\x1b[?25h\x1b[?1049l";

/// The one exception to "no mutable globals": a process has one console, and its control handler, which runs
/// on a thread of its own, can find nothing but globals.
struct {
    DWORD inputMode = 0, outputMode = 0;
    UINT inputCodePage = 0, outputCodePage = 0;
    std::atomic<bool> taken{false};
    std::atomic<int> end{0};  // the signal that asked for the end and has not been noticed yet
    Size lastSize;
} state;

HANDLE input() { return GetStdHandle(STD_INPUT_HANDLE); }
HANDLE output() { return GetStdHandle(STD_OUTPUT_HANDLE); }

bool writeDirectly(const char *bytes, std::size_t size) {
    while (size > 0) {
        DWORD written = 0;
        if (!WriteFile(output(), bytes, static_cast<DWORD>(size), &written, nullptr) || written == 0)
            return false;
        bytes += written;
        size -= written;
    }
    return true;
}

void leaveScreen() {
    if (!state.taken.exchange(false)) return;
    writeDirectly(LEAVE, sizeof LEAVE - 1);
    FlushConsoleInputBuffer(input());
    SetConsoleMode(input(), state.inputMode);
    SetConsoleMode(output(), state.outputMode);
    SetConsoleCP(state.inputCodePage);
    SetConsoleOutputCP(state.outputCodePage);
}

/// The first request is left to the program's loop. A second one, and a window that closes (the system ends
/// the program as soon as this returns), give the console back here.
BOOL WINAPI onControl(DWORD event) {
    const bool first =
        state.end.exchange(event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT ? SIGINT : SIGTERM) == 0;
    if (first && (event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT)) return TRUE;
    leaveScreen();
    return FALSE;
}

bool enterScreen() {
    if (!GetConsoleMode(input(), &state.inputMode) || !GetConsoleMode(output(), &state.outputMode))
        return false;
    state.inputCodePage = GetConsoleCP();
    state.outputCodePage = GetConsoleOutputCP();
    state.taken = true;
    const DWORD inputMode = ENABLE_PROCESSED_INPUT | ENABLE_VIRTUAL_TERMINAL_INPUT | ENABLE_EXTENDED_FLAGS;
    const DWORD outputMode =
        ENABLE_PROCESSED_OUTPUT | ENABLE_VIRTUAL_TERMINAL_PROCESSING | DISABLE_NEWLINE_AUTO_RETURN;
    if (SetConsoleMode(input(), inputMode) && SetConsoleMode(output(), outputMode) && SetConsoleCP(CP_UTF8) &&
        SetConsoleOutputCP(CP_UTF8) && writeDirectly(ENTER, sizeof ENTER - 1))
        return true;
    leaveScreen();
    return false;
}

}  // namespace

bool take() {
    if (state.taken) throw std::logic_error("the terminal is taken already");
    static const int registered = std::atexit(giveBack);
    state.end = 0;
    state.lastSize = size();
    return registered == 0 && SetConsoleCtrlHandler(onControl, TRUE) && enterScreen();
}

void giveBack() {
    if (!state.taken) return;
    leaveScreen();
    SetConsoleCtrlHandler(onControl, FALSE);
}

Events handleEvents() {
    Events events;
    events.signal = state.end.exchange(0);
    const Size now = size();
    events.redraw = now.columns != state.lastSize.columns || now.rows != state.lastSize.rows;
    state.lastSize = now;
    return events;
}

Size size() {
    CONSOLE_SCREEN_BUFFER_INFO info;
    if (!GetConsoleScreenBufferInfo(output(), &info)) return {};
    return {info.srWindow.Right - info.srWindow.Left + 1, info.srWindow.Bottom - info.srWindow.Top + 1};
}

bool read(std::string &bytes) {
    for (;;) {
        DWORD waiting = 0, count = 0;
        if (!GetNumberOfConsoleInputEvents(input(), &waiting)) return false;
        if (waiting == 0) return true;
        INPUT_RECORD record;
        if (!ReadConsoleInputW(input(), &record, 1, &count)) return false;
        if (count == 1 && record.EventType == KEY_EVENT && record.Event.KeyEvent.bKeyDown &&
            record.Event.KeyEvent.uChar.UnicodeChar != 0)
            appendUtf8(bytes, record.Event.KeyEvent.uChar.UnicodeChar);
    }
}

bool write(const std::string &bytes) { return writeDirectly(bytes.data(), bytes.size()); }

void sleep(double seconds) { Sleep(static_cast<DWORD>(seconds * 1000)); }

}  // namespace demo::device

bool demo::isTerminal(Stream stream) {
    static constexpr DWORD HANDLES[] = {STD_INPUT_HANDLE, STD_OUTPUT_HANDLE, STD_ERROR_HANDLE};
    DWORD mode;
    return GetConsoleMode(GetStdHandle(HANDLES[stream]), &mode) != 0;
}

#endif
