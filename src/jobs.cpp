#include <cyclone/check.h>
#include <cyclone/jobs.h>

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "arguments.h"

namespace cyclone {

using namespace detail;

/// The threads and what they share. A task is announced by counting up. The caller waits for the threads that
/// have joined in, not for those that wake too late to find any part left.
class Workers::Crew {
public:
    Crew() = default;
    ~Crew() {
        {
            const std::lock_guard<std::mutex> lock(mutex);
            ending = true;
        }
        announcement.notify_all();
        for (std::thread &thread : threads) thread.join();
    }
    /// If the system refuses a thread, those that exist end with the crew.
    void start(std::size_t helpers) {
        ranges = std::vector<Range>(helpers + 1);
        threads.reserve(helpers);
        for (std::size_t n = 1; n <= helpers; ++n) threads.emplace_back([this, n] { waitAndWork(n); });
    }
    Crew(const Crew &) = delete;
    Crew &operator=(const Crew &) = delete;

    void work(std::size_t partCount, Job &work) {
        if (!announce(partCount, work)) {
            for (std::size_t part = 0; part < partCount; ++part) work.run(part);
            return;
        }
        takeParts(0);
        lookFor([this] { return active == 0; });
        std::unique_lock<std::mutex> lock(mutex);
        completion.wait(lock, [this] { return active == 0; });
        job = nullptr;
        rethrowFailure();
    }

private:
    /// Parts that belong to one thread, in a cache line of its own.
    struct alignas(64) Range {
        std::size_t begin = 0, size = 0;
        std::atomic<std::size_t> taken{0};
    };

    static constexpr int LOOKS = 300;  // a tenth of a millisecond

    /// False if there is a task already.
    bool announce(std::size_t partCount, Job &work) {
        {
            const std::lock_guard<std::mutex> lock(mutex);
            if (job != nullptr) return false;
            job = &work;
            deal(partCount);
            ++task;
        }
        announcement.notify_all();
        return true;
    }

    /// The same parts to the same thread each time, whose processor may still have at hand what it has worked
    /// on.
    void deal(std::size_t partCount) {
        const std::size_t share = partCount / ranges.size(), rest = partCount % ranges.size();
        std::size_t begin = 0;
        for (std::size_t n = 0; n < ranges.size(); ++n) {
            ranges[n].begin = begin;
            ranges[n].size = share + (n < rest ? 1 : 0);
            ranges[n].taken = 0;
            begin += ranges[n].size;
        }
    }

    void waitAndWork(std::size_t self) {
        for (std::size_t seen = 0;;) {
            const auto isAnnounced = [&] { return ending || task != seen; };
            lookFor(isAnnounced);
            std::unique_lock<std::mutex> lock(mutex);
            announcement.wait(lock, isAnnounced);
            if (ending) return;
            seen = task;
            if (job == nullptr) continue;
            ++active;
            lock.unlock();
            takeParts(self);
            lock.lock();
            if (--active == 0) completion.notify_one();
        }
    }

    /// Looks often before it is worth going to sleep: a frame's loops follow each other closely, and waking a
    /// thread takes some tens of microseconds.
    template <class Condition>
    static void lookFor(const Condition &condition) {
        for (int looks = 0; looks < LOOKS && !condition(); ++looks) std::this_thread::yield();
    }

    void takeParts(std::size_t self) {
#ifdef __cpp_exceptions
        try {
            runParts(self);
        } catch (...) {
            for (Range &range : ranges) range.taken = range.size;
            const std::lock_guard<std::mutex> lock(mutex);
            if (!failure) failure = std::current_exception();
        }
#else
        runParts(self);
#endif
    }

    /// A thread's own parts first, then those that others have not come to.
    void runParts(std::size_t self) {
        for (std::size_t n = 0; n < ranges.size(); ++n) {
            Range &range = ranges[(self + n) % ranges.size()];
            for (std::size_t k; (k = range.taken.fetch_add(1)) < range.size;) job->run(range.begin + k);
        }
    }

    void rethrowFailure() {
#ifdef __cpp_exceptions
        if (failure) std::rethrow_exception(std::exchange(failure, nullptr));
#endif
    }

    std::mutex mutex;
    std::condition_variable announcement, completion;
    Job *job = nullptr;
    std::vector<Range> ranges;                    ///< of each thread
    std::atomic<std::size_t> task{0}, active{0};  ///< changed under the lock
    std::atomic<bool> ending{false};
#ifdef __cpp_exceptions
    std::exception_ptr failure;
#endif
    std::vector<std::thread> threads;
};

Workers::Workers(std::size_t threadCount) {
    require(threadCount >= 1 && threadCount <= MAX_THREADS, "Workers::Workers",
            "the number of threads must be between 1 and 256", {static_cast<real>(threadCount)});
    crew = std::make_unique<Crew>();
    crew->start(threadCount - 1);
}

Workers::~Workers() = default;

void Workers::parallelFor(std::size_t count, Job &job) { crew->work(count, job); }

}  // namespace cyclone
