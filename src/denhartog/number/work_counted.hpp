// Counts of work.
#pragma once

#include <atomic>

namespace denhartog {

// Work done since the program started, over all number types and threads; tests gate on it.
struct WorkCounted {
    std::atomic<long> eigen_solves{0};      // eigenproblems (15)
    std::atomic<long> mode_evaluations{0};  // modes at a frequency
    std::atomic<long> demand_searches{0};   // searches for the largest demand
    std::atomic<long> phases_propagated{0}; // phases of motions with stops
};

// The counts of this program.
inline WorkCounted work_counted;

} // namespace denhartog
