#pragma once

/// @file
/// Parallel loops: the interface that a World needs, and threads for games without a job system.
#include <cyclone/export.h>

#include <cstddef>
#include <memory>

namespace cyclone {

/// A parallel for-loop. A game engine with threads of its own derives from it and hands it to
/// World::setJobSystem.
class CYCLONE_API JobSystem {
public:
    virtual ~JobSystem() = default;

    /// One part of the loop's work; called from any thread, for different indices at once.
    class CYCLONE_API Job {
    public:
        virtual ~Job() = default;
        virtual void run(std::size_t index) = 0;
    };

    /// Runs the job once for each index below count, and returns when all have been run. If one throws, the
    /// others may be left out, and the exception reaches the caller.
    virtual void parallelFor(std::size_t count, Job &job) = 0;

protected:
    JobSystem() = default;
    JobSystem(const JobSystem &) = default;
    JobSystem &operator=(const JobSystem &) = default;
};

/// Threads that wait between frames: they look out for the next loop for a tenth of a millisecond, then
/// sleep. Loops of as many parts give the same ones to the same thread, whose processor has them at hand; a
/// thread that has done its own takes over others'. While they are at work, another parallelFor, such as one
/// within a job, runs all its parts on the thread that calls it.
class CYCLONE_API Workers : public JobSystem {
public:
    static constexpr std::size_t MAX_THREADS = 256;

    /// With the calling thread, `threadCount` threads share the work; 1 to MAX_THREADS.
    explicit Workers(std::size_t threadCount);
    ~Workers() override;
    Workers(const Workers &) = delete;
    Workers &operator=(const Workers &) = delete;

    void parallelFor(std::size_t count, Job &job) override;

private:
    class Crew;
    std::unique_ptr<Crew> crew;
};

}  // namespace cyclone
