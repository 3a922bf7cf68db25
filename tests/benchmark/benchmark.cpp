/// What the library costs, part by part.
///
///     cyclone_benchmark [bodies …]        (without numbers: 1000 10000 100000 1000000)
#include "benchmark.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char **argv) {
    benchmark::Counts counts;
    for (int n = 1; n < argc; ++n) {
        const long count = std::strtol(argv[n], nullptr, 10);
        if (count < 1) {
            std::fprintf(stderr, "cyclone_benchmark: '%s' is not a number of bodies\n", argv[n]);
            return 2;
        }
        counts.push_back(static_cast<std::size_t>(count));
    }
    if (counts.empty()) counts = {1000, 10000, 100000, 1000000};

    benchmark::measureFrames(counts);
    benchmark::measureThreads(counts);
    benchmark::measureBodyAlone();
    benchmark::measureSnapshots();
    benchmark::measureRollback();
    benchmark::measureChurn();
    return 0;
}
