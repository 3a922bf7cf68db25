// In place of src/jobs.cpp where the target has no threads: the caller does all the work.
#include <cyclone/jobs.h>

namespace cyclone {

class Workers::Crew {};

Workers::Workers(std::size_t) {}
Workers::~Workers() = default;

void Workers::parallelFor(std::size_t count, Job &job) {
    for (std::size_t part = 0; part < count; ++part) job.run(part);
}

}  // namespace cyclone
