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
        threads.reserve(helpers);
        for (std::size_t n = 0; n < helpers; ++n) threads.emplace_back([this] { waitAndWork(); });
    }
    Crew(const Crew &) = delete;
    Crew &operator=(const Crew &) = delete;

    void work(std::size_t partCount, Job &work) {
        if (!announce(partCount, work)) {
            for (std::size_t part = 0; part < partCount; ++part) work.run(part);
            return;
        }
        takeParts();
        std::unique_lock<std::mutex> lock(mutex);
        completion.wait(lock, [this] { return active == 0; });
        job = nullptr;
        rethrowFailure();
    }

private:
    /// False if there is a task already.
    bool announce(std::size_t partCount, Job &work) {
        {
            const std::lock_guard<std::mutex> lock(mutex);
            if (job != nullptr) return false;
            job = &work;
            count = partCount;
            next = 0;
            ++task;
        }
        announcement.notify_all();
        return true;
    }

    void waitAndWork() {
        std::unique_lock<std::mutex> lock(mutex);
        for (std::size_t seen = 0;;) {
            announcement.wait(lock, [&] { return ending || task != seen; });
            if (ending) return;
            seen = task;
            if (job == nullptr) continue;
            ++active;
            lock.unlock();
            takeParts();
            lock.lock();
            if (--active == 0) completion.notify_one();
        }
    }

    void takeParts() {
#ifdef __cpp_exceptions
        try {
            runParts();
        } catch (...) {
            next = count;
            const std::lock_guard<std::mutex> lock(mutex);
            if (!failure) failure = std::current_exception();
        }
#else
        runParts();
#endif
    }

    void runParts() {
        for (std::size_t part; (part = next.fetch_add(1)) < count;) job->run(part);
    }

    void rethrowFailure() {
#ifdef __cpp_exceptions
        if (failure) std::rethrow_exception(std::exchange(failure, nullptr));
#endif
    }

    std::mutex mutex;
    std::condition_variable announcement, completion;
    Job *job = nullptr;
    std::size_t count = 0;
    std::atomic<std::size_t> next{0};
    std::size_t task = 0, active = 0;
    bool ending = false;
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
