#pragma once

/// The operator new of the tests' program, defined in allocation_test.cpp: it counts, and it fails on
/// request.
#include <atomic>

namespace cyclone_test {

struct Allocations {
    std::atomic<long> made{0};
    std::atomic<long> inUse{0};
    /// How many succeed before one fails with std::bad_alloc. Negative: none fails.
    std::atomic<long> untilFailure{-1};
};

extern Allocations allocations;

/// False where a sanitizer has an operator new of its own.
bool allocationsAreCounted();

}  // namespace cyclone_test
