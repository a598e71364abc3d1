/// @file
/// @brief Time as a processor spends it: a machine that is busy with something else does not count.
#pragma once

#include <ctime>

namespace denhartog::program {

/// @brief Processor seconds of the thread that asks. @return since it started
[[nodiscard]] inline double processor_seconds() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace denhartog::program
