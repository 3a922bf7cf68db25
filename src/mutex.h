#pragma once

/// @file
/// A mutex that is also there where the standard library knows no threads, and nothing has to be locked out.
#include <mutex>

namespace cyclone {
namespace detail {

#ifdef _LIBCPP_HAS_NO_THREADS  // libc++ for wasm32
class Mutex {};
class Lock {
public:
    explicit Lock(Mutex &) {}
};
#else
using Mutex = std::mutex;
using Lock = std::lock_guard<std::mutex>;
#endif

}  // namespace detail
}  // namespace cyclone
