/// @file
/// @brief Time of batches beside the bare functions they cannot do without, in one run.
#pragma once

#include "tests/speed_accuracy/table.hpp"

namespace denhartog::tests {

/// @brief Nanoseconds an (r, mode), an r and an (r, beta) for modes, sums and maps over arrays, each with its limit. Of so many
/// runs the median is taken.
[[nodiscard]] Table batch_speed(int repeats);

/// @brief Errors of the vector maths library and of the functions used instead, in units in the last place. They are the worst
/// over seeded arguments, against long double.
[[nodiscard]] Table vector_function_errors();

} // namespace denhartog::tests
