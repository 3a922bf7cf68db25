#ifndef _WIN32

#include "../src/demos/terminal.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <functional>
#include <stdexcept>

using namespace demo;

namespace {

constexpr char ENTER[] = "\x1b[?1049h", LEAVE[] = "\x1b[?1049l";

/// Runs `program` in a child process whose terminal is ours to watch.
class Session {
public:
    explicit Session(const std::function<int()> &program, const char *type = "xterm-256color") {
        master_ = posix_openpt(O_RDWR | O_NOCTTY);
        if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0)
            throw std::runtime_error("no pty");
        const std::string name = ptsname(master_);
        slave_ = open(name.c_str(), O_RDWR | O_NOCTTY);
        resize(40, 10);
        before_ = modes();
        child_ = fork();
        if (child_ != 0) return;

        setsid();
        const int terminal = open(name.c_str(), O_RDWR);
        ioctl(terminal, TIOCSCTTY, 0);
        for (int fd : {0, 1, 2}) dup2(terminal, fd);
        for (int fd = 3; fd < 64; ++fd) close(fd);
        setenv("TERM", type, 1);
        setenv("COLORTERM", "truecolor", 1);
        std::_Exit(program());
    }
    ~Session() {
        if (child_ > 0) {
            kill(child_, SIGKILL);
            waitpid(child_, nullptr, 0);
        }
        close(slave_);
        if (master_ >= 0) close(master_);
    }
    Session(const Session &) = delete;
    Session &operator=(const Session &) = delete;

    /// Reads until `text` comes, after what was waited for before; false after five seconds.
    bool waitFor(const std::string &text) {
        for (int tries = 0; tries < 500; ++tries) {
            const std::size_t at = output_.find(text, seen_);
            if (at != std::string::npos) {
                seen_ = at + text.size();
                return true;
            }
            readFor(10);
        }
        return false;
    }

    void type(const std::string &bytes) {
        ASSERT_EQ(write(master_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }
    void signal(int number) { kill(child_, number); }
    void resize(unsigned short columns, unsigned short rows) {
        winsize size{};
        size.ws_col = columns;
        size.ws_row = rows;
        ioctl(master_, TIOCSWINSZ, &size);
    }
    void hangUp() {
        close(slave_);
        close(master_);
        slave_ = master_ = -1;
    }

    /// How the child ended: its exit status, or minus the signal that killed it.
    int end() {
        int status = 0;
        for (int tries = 0; tries < 500 && waitpid(child_, &status, WNOHANG) == 0; ++tries) {
            readFor(10);
            if (tries == 499) return 9999;
        }
        child_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }

    void expectGivenBack() {
        EXPECT_TRUE(waitFor(LEAVE));
        const termios after = modes();
        EXPECT_EQ(after.c_iflag, before_.c_iflag);
        EXPECT_EQ(after.c_oflag, before_.c_oflag);
        EXPECT_EQ(after.c_cflag, before_.c_cflag);
        EXPECT_EQ(after.c_lflag, before_.c_lflag);
        for (int i = 0; i < NCCS; ++i) EXPECT_EQ(after.c_cc[i], before_.c_cc[i]) << i;
    }
    termios modes() const {
        termios result{};
        tcgetattr(slave_, &result);
        return result;
    }

private:
    void readFor(int milliseconds) {
        pollfd ready{master_, POLLIN, 0};  // without a master it is only a pause
        if (poll(&ready, 1, milliseconds) <= 0) return;
        char buffer[4096];
        const ssize_t count = read(master_, buffer, sizeof buffer);
        if (count > 0) output_.append(buffer, static_cast<std::size_t>(count));
    }

    std::string output_;
    int master_ = -1, slave_ = -1;
    pid_t child_ = -1;
    termios before_{};
    std::size_t seen_ = 0;
};

CellGrid pictureOf(const std::string &text) {
    CellGrid picture(static_cast<int>(text.size()), 1);
    for (std::size_t i = 0; i < text.size(); ++i) picture.cells[i].glyph = static_cast<char32_t>(text[i]);
    return picture;
}

/// Shows "ready" and then every key's number, until Esc.
int showKeys() {
    Terminal terminal;
    terminal.show(pictureOf("ready"));
    while (terminal.isOpen()) {
        for (Key key; (key = terminal.readKey()) != keys::NONE;) {
            if (key == keys::ESCAPE) return 7;
            terminal.show(pictureOf("<" + std::to_string(key) + "," + std::to_string(terminal.columns()) +
                                    "x" + std::to_string(terminal.rows()) + ">"));
        }
        terminal.wait(0.005);
    }
    return terminal.exitStatus();
}

TEST(DemoTerminal, EscEndsItAndTheTerminalIsAsItWas) {
    Session session(showKeys);
    ASSERT_TRUE(session.waitFor(ENTER));
    ASSERT_TRUE(session.waitFor("ready"));
    EXPECT_EQ(session.modes().c_lflag & (ICANON | ECHO), 0u);
    session.type("\x1b[A");
    EXPECT_TRUE(session.waitFor("<1114112,40x10>"));
    session.resize(33, 11);
    session.type("w");
    EXPECT_TRUE(session.waitFor("<119,33x11>"));
    session.type("\x1b");
    EXPECT_EQ(session.end(), 7);
    session.expectGivenBack();
}

TEST(DemoTerminal, CtrlCEndsTheLoop) {
    Session session(showKeys);
    ASSERT_TRUE(session.waitFor("ready"));
    session.type("\x03");
    EXPECT_EQ(session.end(), 128 + SIGINT);
    session.expectGivenBack();
}

TEST(DemoTerminal, TerminationAndHangUpSignalsEndTheLoop) {
    for (int number : {SIGTERM, SIGHUP}) {
        Session session(showKeys);
        ASSERT_TRUE(session.waitFor("ready"));
        session.signal(number);
        EXPECT_EQ(session.end(), 128 + number);
        session.expectGivenBack();
    }
}

TEST(DemoTerminal, ALostTerminalEndsTheLoop) {
    Session session(showKeys);
    ASSERT_TRUE(session.waitFor("ready"));
    session.hangUp();
    const int status = session.end();
    EXPECT_TRUE(status == 0 || status == 128 + SIGHUP) << status;
}

TEST(DemoTerminal, ASecondCtrlCEndsAProgramThatHangs) {
    Session session([] {
        Terminal terminal;
        terminal.show(pictureOf("ready"));
        for (;;) pause();
        return 0;
    });
    ASSERT_TRUE(session.waitFor("ready"));
    session.signal(SIGINT);
    usleep(20000);
    session.signal(SIGINT);
    EXPECT_EQ(session.end(), -SIGINT);
    session.expectGivenBack();
}

TEST(DemoTerminal, ACrashGivesTheTerminalBack) {
    Session session(showKeys);
    ASSERT_TRUE(session.waitFor("ready"));
    session.signal(SIGSEGV);
    EXPECT_NE(session.end(), 0);
    session.expectGivenBack();
}

TEST(DemoTerminal, AnUncaughtExceptionGivesTheTerminalBack) {
    Session session([]() -> int {
        Terminal terminal;
        terminal.show(pictureOf("ready"));
        std::terminate();
    });
    EXPECT_EQ(session.end(), -SIGABRT);
    session.expectGivenBack();
}

TEST(DemoTerminal, ExitGivesTheTerminalBack) {
    Session session([]() -> int {
        Terminal terminal;
        terminal.show(pictureOf("ready"));
        std::exit(5);
    });
    EXPECT_EQ(session.end(), 5);
    session.expectGivenBack();
}

/// Runs showKeys() as a shell would, as a job that it continues when it stops. Returns how the job ended,
/// plus 100 if it stopped on the way and left its terminal in order.
int runAsJob() {
    ::signal(SIGTTOU, SIG_IGN);
    const pid_t job = fork();
    if (job == 0) {
        setpgid(0, 0);
        tcsetpgrp(0, getpid());
        ::signal(SIGTTOU, SIG_DFL);
        std::_Exit(showKeys());
    }
    int status = 0;
    waitpid(job, &status, WUNTRACED);
    if (!WIFSTOPPED(status)) return WEXITSTATUS(status);
    tcsetpgrp(0, getpgrp());
    termios modes{};
    tcgetattr(0, &modes);
    const bool inOrder = (modes.c_lflag & (ICANON | ECHO)) == (ICANON | ECHO);
    tcsetpgrp(0, job);
    kill(-job, SIGCONT);
    waitpid(job, &status, 0);
    return WEXITSTATUS(status) + (inOrder ? 100 : 0);
}

TEST(DemoTerminal, CtrlZStopsItAndItGoesOnWhereItWas) {
    Session session(runAsJob);
    ASSERT_TRUE(session.waitFor("ready"));
    session.type("\x1a");
    EXPECT_TRUE(session.waitFor(LEAVE));
    ASSERT_TRUE(session.waitFor(ENTER));
    session.type("\x1b");
    EXPECT_EQ(session.end(), 107);
    session.expectGivenBack();
}

TEST(DemoTerminal, WithoutAShellToContinueItCtrlZDoesNotStopIt) {
    Session session(showKeys);
    ASSERT_TRUE(session.waitFor("ready"));
    session.type("\x1a");
    EXPECT_TRUE(session.waitFor(LEAVE));
    ASSERT_TRUE(session.waitFor(ENTER));
    session.type("\x1b");
    EXPECT_EQ(session.end(), 7);
    session.expectGivenBack();
}

TEST(DemoTerminal, AfterBeingContinuedItDrawsEverythingAgain) {
    Session session([] {
        Terminal terminal;
        while (terminal.isOpen()) {
            terminal.show(pictureOf("picture"));
            terminal.wait(0.005);
        }
        return terminal.exitStatus();
    });
    ASSERT_TRUE(session.waitFor("picture"));
    session.signal(SIGSTOP);
    session.signal(SIGCONT);
    EXPECT_TRUE(session.waitFor(ENTER));
    EXPECT_TRUE(session.waitFor("picture"));
}

TEST(DemoTerminal, ThereIsOneTerminalAtATimeButOneAfterAnother) {
    Session session([] {
        { Terminal first; }
        Terminal second;
        try {
            Terminal third;
        } catch (const std::logic_error &) {
            return 3;
        }
        return 4;
    });
    EXPECT_EQ(session.end(), 3);
    session.expectGivenBack();
}

TEST(DemoTerminal, IsInteractiveOnlyOnATerminalThatShowsPictures) {
    const auto ask = [] { return Terminal::isInteractive() ? 1 : 0; };
    EXPECT_EQ(Session(ask).end(), 1);
    EXPECT_EQ(Session(ask, "dumb").end(), 0);
    const auto askWithoutInput = [ask] {
        close(0);
        open("/dev/null", O_RDONLY);
        return ask();
    };
    EXPECT_EQ(Session(askWithoutInput).end(), 0);
    const auto refuse = [] {
        try {
            Terminal terminal;
        } catch (const std::runtime_error &) {
            return 6;
        }
        return 0;
    };
    EXPECT_EQ(Session(refuse, "dumb").end(), 6);
}

}  // namespace

#endif
