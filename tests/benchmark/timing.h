#pragma once

/// Times of things that are measured in turn, so that whatever else the machine does hits all of them alike.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

namespace benchmark {

/// Nanoseconds of one run.
template <class Action>
double timeOf(Action &&action) {
    const auto begin = std::chrono::steady_clock::now();
    action();
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count();
}

/// Keeps a result, so that the compiler does not leave out the work.
template <class Value>
void keep(const Value &value) {
    static_cast<void>(*reinterpret_cast<const volatile unsigned char *>(&value));
}

/// The times of some runs.
class Timings {
public:
    void add(double time) { times.push_back(time); }
    double least() const { return *std::min_element(times.begin(), times.end()); }
    double median() const {
        std::vector<double> sorted = times;
        std::sort(sorted.begin(), sorted.end());
        return sorted[sorted.size() / 2];
    }

private:
    std::vector<double> times;
};

}  // namespace benchmark
