#include "base/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace demo {

namespace {

[[noreturn]] void fail(const std::string &what, const std::string &path, int error) {
    std::string text = "cannot " + what + " '" + path + "'";
    if (error != 0) text += std::string(": ") + std::strerror(error);
    throw std::runtime_error(text);
}

}  // namespace

OutputFile::Buffer::int_type OutputFile::Buffer::overflow(int_type c) {
    errno = 0;
    const int_type result = std::filebuf::overflow(c);
    if (traits_type::eq_int_type(result, traits_type::eof()) && error == 0) error = errno;
    return result;
}

std::streamsize OutputFile::Buffer::xsputn(const char *text, std::streamsize count) {
    errno = 0;
    const std::streamsize written = std::filebuf::xsputn(text, count);
    if (written < count && error == 0) error = errno;
    return written;
}

OutputFile::OutputFile(const std::string &path) : path_(path), stream_(nullptr) {
    errno = 0;
    if (!buffer_.open(path, std::ios::out | std::ios::binary)) fail("write", path, errno);
    stream_.rdbuf(&buffer_);
}

OutputFile::~OutputFile() {
    if (isFinished_) return;
    buffer_.close();
    std::error_code ignored;  // a device stays, as does what has gone already
    if (std::filesystem::is_regular_file(path_, ignored)) std::filesystem::remove(path_, ignored);
}

void OutputFile::finish() {
    errno = 0;
    const bool closed = buffer_.close() != nullptr;
    if (!stream_ || !closed) fail("write", path_, buffer_.getError() != 0 ? buffer_.getError() : errno);
    isFinished_ = true;
}

// ---- A file that is kept

namespace {

/// Where a link leads: it is the file that is replaced, not the link.
std::string resolved(const std::string &path) {
    std::error_code error;
    const std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
    return error ? path : target.string();
}

std::string readIfThere(const std::string &path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) return "";
    if (!std::filesystem::is_regular_file(path, error))
        throw std::runtime_error("cannot keep '" + path + "': it is not a file");
    return readFile(path);
}

}  // namespace

KeptFile::KeptFile(const std::string &path)
    : path_(resolved(path)), text_(readIfThere(path_)), next_(path_ + ".new") {}

void KeptFile::replace(const std::string &text) {
    next_.stream() << text;
    next_.finish();
    std::error_code error;
    std::filesystem::rename(path_ + ".new", path_, error);
    if (error) fail("write", path_, error.value());
}

bool isSameFile(const std::string &a, const std::string &b) {
    namespace fs = std::filesystem;
    std::error_code error;
    if (fs::exists(a, error) && fs::exists(b, error))
        return fs::is_regular_file(a, error) && fs::equivalent(a, b, error);
    return fs::weakly_canonical(fs::absolute(a), error) == fs::weakly_canonical(fs::absolute(b), error);
}

std::string readFile(const std::string &path) {
    std::FILE *file = std::fopen(path.c_str(), "rb");
    if (!file) fail("read", path, errno);
    std::string text;
    char block[4096];
    std::size_t count;
    while ((count = std::fread(block, 1, sizeof block, file)) > 0) text.append(block, count);
    const int error = std::ferror(file) ? errno : 0;
    std::fclose(file);
    if (error != 0) fail("read", path, error);
    return text;
}

}  // namespace demo
