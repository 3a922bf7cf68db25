#pragma once

/// Files that a demo reads and writes, with a clear word when it can't.
#include <fstream>
#include <ostream>
#include <string>

namespace demo {

/// A file to write, opened at once, so that a file that cannot be written is said before the run and not
/// after it. An existing file is emptied. What doesn't get finished is removed: no half files.
class OutputFile {
public:
    /// Throws std::runtime_error, "cannot write 'path': reason".
    explicit OutputFile(const std::string &path);
    ~OutputFile();
    OutputFile(const OutputFile &) = delete;
    OutputFile &operator=(const OutputFile &) = delete;

    std::ostream &stream() { return stream_; }

    /// Finishes the file; throws std::runtime_error if anything could not be written (a full disk shows only
    /// here).
    void finish();

private:
    /// Remembers why it failed: a stream only knows that it did.
    class Buffer : public std::filebuf {
    public:
        int getError() const { return error; }

    protected:
        int_type overflow(int_type c) override;
        std::streamsize xsputn(const char *text, std::streamsize count) override;

    private:
        int error = 0;
    };

    std::string path_;
    Buffer buffer_;
    std::ostream stream_;
    bool isFinished_ = false;
};

/// A text file that is read first, and may be replaced at the end. Until then the new text is on its way in
/// another file beside it, so the old one is there whatever goes wrong.
class KeptFile {
public:
    /// Reads it; a file that isn't there yet has no text. Throws std::runtime_error if it can't be read, or
    /// if it can't be written later: then it is said before the run, too.
    explicit KeptFile(const std::string &path);

    const std::string &getText() const { return text_; }
    /// Throws std::runtime_error, "cannot write 'path': reason", and the old file stays.
    void replace(const std::string &text);

private:
    std::string path_, text_;
    OutputFile next_;
};

/// Whether both names lead to one file, existing or to be made; devices are nobody's, so that two outputs may
/// go to /dev/null.
bool isSameFile(const std::string &a, const std::string &b);

/// The whole file; throws std::runtime_error, "cannot read 'path': reason".
std::string readFile(const std::string &path);

}  // namespace demo
