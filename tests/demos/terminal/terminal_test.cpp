#ifndef _WIN32

#include "terminal/terminal.h"

#include <exception>

#include "pty.h"

using namespace demo;

namespace {

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
    Pty session(showKeys);
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
    Pty session(showKeys);
    ASSERT_TRUE(session.waitFor("ready"));
    session.type("\x03");
    EXPECT_EQ(session.end(), 128 + SIGINT);
    session.expectGivenBack();
}

TEST(DemoTerminal, TerminationAndHangUpSignalsEndTheLoop) {
    for (int number : {SIGTERM, SIGHUP}) {
        Pty session(showKeys);
        ASSERT_TRUE(session.waitFor("ready"));
        session.signal(number);
        EXPECT_EQ(session.end(), 128 + number);
        session.expectGivenBack();
    }
}

TEST(DemoTerminal, ALostTerminalEndsTheLoop) {
    Pty session(showKeys);
    ASSERT_TRUE(session.waitFor("ready"));
    session.hangUp();
    const int status = session.end();
    EXPECT_TRUE(status == 0 || status == 128 + SIGHUP) << status;
}

TEST(DemoTerminal, ASecondCtrlCEndsAProgramThatHangs) {
    Pty session([] {
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
    Pty session(showKeys);
    ASSERT_TRUE(session.waitFor("ready"));
    session.signal(SIGSEGV);
    EXPECT_NE(session.end(), 0);
    session.expectGivenBack();
}

TEST(DemoTerminal, AnUncaughtExceptionGivesTheTerminalBack) {
    Pty session([]() -> int {
        Terminal terminal;
        terminal.show(pictureOf("ready"));
        std::terminate();
    });
    EXPECT_EQ(session.end(), -SIGABRT);
    session.expectGivenBack();
}

TEST(DemoTerminal, ExitGivesTheTerminalBack) {
    Pty session([]() -> int {
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
    Pty session(runAsJob);
    ASSERT_TRUE(session.waitFor("ready"));
    session.type("\x1a");
    EXPECT_TRUE(session.waitFor(LEAVE));
    ASSERT_TRUE(session.waitFor(ENTER));
    session.type("\x1b");
    EXPECT_EQ(session.end(), 107);
    session.expectGivenBack();
}

TEST(DemoTerminal, WithoutAShellToContinueItCtrlZDoesNotStopIt) {
    Pty session(showKeys);
    ASSERT_TRUE(session.waitFor("ready"));
    session.type("\x1a");
    EXPECT_TRUE(session.waitFor(LEAVE));
    ASSERT_TRUE(session.waitFor(ENTER));
    session.type("\x1b");
    EXPECT_EQ(session.end(), 7);
    session.expectGivenBack();
}

TEST(DemoTerminal, AfterBeingContinuedItDrawsEverythingAgain) {
    Pty session([] {
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
    Pty session([] {
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
    EXPECT_EQ(Pty(ask).end(), 1);
    EXPECT_EQ(Pty(ask, "dumb").end(), 0);
    const auto askWithoutInput = [ask] {
        close(0);
        open("/dev/null", O_RDONLY);
        return ask();
    };
    EXPECT_EQ(Pty(askWithoutInput).end(), 0);
    const auto refuse = [] {
        try {
            Terminal terminal;
        } catch (const std::runtime_error &) {
            return 6;
        }
        return 0;
    };
    EXPECT_EQ(Pty(refuse, "dumb").end(), 6);
}

}  // namespace

#endif
