#pragma once

/// Files that a demo reads and writes, with a clear word when it can't.
#include <fstream>
#include <string>

namespace demo {

/// A file to write, opened at once, so that a file that cannot be written is said before the run and not
/// after it. An existing file is emptied.
class OutputFile {
public:
    /// Throws std::runtime_error, "cannot write 'path': reason".
    explicit OutputFile(const std::string &path);

    std::ostream &stream() { return stream_; }

    /// Finishes the file; throws std::runtime_error if anything could not be written (a full disk shows only
    /// here). A file that is not finished is closed without a check.
    void finish();

private:
    std::string path_;
    std::ofstream stream_;
};

/// The whole file; throws std::runtime_error, "cannot read 'path': reason".
std::string readFile(const std::string &path);

}  // namespace demo
