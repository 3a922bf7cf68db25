#pragma once

/// The parts of the benchmark. Each prints a table; each figure has its ratio to something in the same run.
#include <cstddef>
#include <vector>

namespace benchmark {

typedef std::vector<std::size_t> Counts;

/// Whole frames of worlds of so many bodies, beside a plain first-order engine.
void measureFrames(const Counts &counts);
/// The same frames on two threads, beside one.
void measureThreads(const Counts &counts);
/// RigidBody::integrate of a single body, beside the first-order step.
void measureBodyAlone();
/// Saving, restoring and hashing, beside a plain copy of the bodies.
void measureSnapshots();
/// Eight frames of rollback, beside eight frames.
void measureRollback();
/// Bodies that come and go, beside new and delete.
void measureChurn();

}  // namespace benchmark
