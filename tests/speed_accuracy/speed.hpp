/// @file
/// @brief Time and digits of the exact solver and of `solve` against the paper's algorithm at its own settings, in one run.
#pragma once

#include "tests/speed_accuracy/table.hpp"

namespace denhartog::tests {

/// @brief The exact solver from rest, full answer, against the paper's algorithm, 200 cycles at 1e-6.
/// @param repeats  runs of which the median is taken
/// @return         time a point, ratio and digits on the SDOF point and on the 2DOF curve
[[nodiscard]] Table exact_solver_speed(int repeats);

/// @brief The usual questions: `solve` at a point and the map along a curve against the paper's algorithm.
/// @param repeats  runs of which the median is taken
/// @return         time a point, ratio and digits
[[nodiscard]] Table usual_questions_speed(int repeats);

} // namespace denhartog::tests
