/// @file
/// @brief The chart as files: CSV with all that is needed to repeat it, data of its pictures, tables.
#pragma once

#include "tests/speed_accuracy/chart_survey.hpp"
#include "tests/speed_accuracy/table.hpp"

namespace denhartog::tests {

/// @brief What a run was made with.
struct ChartRun {
    std::uint64_t seed = 0; ///< seed of the points
    std::string version;    ///< version of the source
    std::string compiler;   ///< compiler and its options
    std::string processor;  ///< the processor
};

/// @brief The processor as the system names it. @return its name, or that it is not known
[[nodiscard]] std::string processor_name();

/// @brief The rows as CSV: one a method, setting and scene, a method that was not there included.
[[nodiscard]] std::string csv(const std::vector<ChartRow>& rows, const ChartRun& run);

/// @brief The points with the truth and the limits of every scene as CSV.
[[nodiscard]] std::string csv(const std::vector<ChartGround>& grounds, const ChartRun& run);

/// @brief Data of the pictures: a block a scene and method of digits (worst, median), time, setup, tolerance asked for, share of
/// the points that were right, failures as `failure_names`; before them the limits of the scene and, as comments, all names.
[[nodiscard]] std::string picture_data(const std::vector<ChartRow>& rows, const std::vector<ChartGround>& grounds);

/// @brief Who is fastest at 2, 4, 8, 12, 15 and 30 digits on every scene, beside `solve` asked for them. With the setup a single
/// question is meant, without it one more of many.
[[nodiscard]] Table front_table(const std::vector<ChartRow>& rows, bool with_setup);

/// @brief Failures by name: every method and setting that was not right everywhere, or was not there.
[[nodiscard]] Table failure_table(const std::vector<ChartRow>& rows);

/// @brief What `solve` did for its answers: modes evaluated, eigenproblems, phases propagated, models used. A row a scene and
/// number of digits.
[[nodiscard]] Table solve_work_table(const std::vector<ChartGround>& grounds);

} // namespace denhartog::tests
