#pragma once

/// A terminal of one's own for a program under test. POSIX only.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>

constexpr char ENTER[] = "\x1b[?1049h", LEAVE[] = "\x1b[?1049l";

/// Runs `program` in a child process whose terminal is ours to watch.
class Pty {
public:
    explicit Pty(const std::function<int()> &program, const char *type = "xterm-256color") {
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
    ~Pty() {
        if (child_ > 0) {
            kill(child_, SIGKILL);
            waitpid(child_, nullptr, 0);
        }
        close(slave_);
        if (master_ >= 0) close(master_);
    }
    Pty(const Pty &) = delete;
    Pty &operator=(const Pty &) = delete;

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
    /// Forgets what has come so far.
    void skip() {
        for (std::size_t before = 0; before != output_.size();) {
            before = output_.size();
            readFor(0);
        }
        seen_ = output_.size();
    }

    /// Lets the child run for a while.
    void rest(int milliseconds) {
        for (; milliseconds > 0; milliseconds -= 10) {
            usleep(10000);
            readFor(0);
        }
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
    const std::string &output() const { return output_; }
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
