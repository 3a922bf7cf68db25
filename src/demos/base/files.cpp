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

OutputFile::OutputFile(const std::string &path) : path_(path) {
    errno = 0;
    stream_.open(path, std::ios::binary);
    if (!stream_) fail("write", path, errno);
}

OutputFile::~OutputFile() {
    if (isFinished_) return;
    stream_.close();
    std::error_code ignored;  // a device stays, as does what has gone already
    if (std::filesystem::is_regular_file(path_, ignored)) std::filesystem::remove(path_, ignored);
}

void OutputFile::finish() {
    errno = 0;
    stream_.close();
    if (!stream_) fail("write", path_, errno);
    isFinished_ = true;
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
