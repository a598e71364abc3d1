/// @file
/// @brief What a batch costs against the number of modes and the size of its grid, and at what rates it runs.
#pragma once

#include <string>
#include <vector>

#include "denhartog/scene/scene.hpp"
#include "tests/speed_accuracy/table.hpp"

namespace denhartog::tests {

/// @brief Nanoseconds now: of the processor where one thread works, so that other programs do not count; else of the clock on the
/// wall. @param threads how many work @return the time
[[nodiscard]] double now(unsigned threads);

/// @brief Equal steps. @param from the first number @param to the last @param n how many @return the numbers
[[nodiscard]] std::vector<double> grid(double from, double to, std::size_t n);

/// @brief One batch and its time.
struct BatchCost {
    std::string series;                 ///< what was varied
    std::size_t modes;                  ///< number of modes
    std::size_t ratios;                 ///< number of frequency ratios
    std::size_t rows;                   ///< number of friction ratios, 0 where there are none
    unsigned threads;                   ///< threads
    double nanoseconds;                 ///< least time of the repeats
    long evaluations;                   ///< modes evaluated over arrays
    [[nodiscard]] double items() const; ///< modes times frequency ratios, or points of the grid
};

/// @brief The least beta_lim over frequency ratios: below it no point of a map needs a motion to be followed.
[[nodiscard]] double least_boundary(const Scene<double>& scene, const std::vector<double>& r);

/// @brief Batches after the eigen-solve: N from 1 to 2000 at 2000 frequency ratios, then grids of 100 to 10^6 frequency ratios
/// and of 10^4 to 10^7 points (r, beta) for five masses. Of so many runs the least is taken.
[[nodiscard]] std::vector<BatchCost> batch_costs(int repeats);

/// @brief Exponent of a power law through the costs of a series, by least squares over batches of 10^4 items and more. It is 1
/// where the cost is linear.
[[nodiscard]] double fitted_exponent(const std::vector<BatchCost>& costs, const std::string& series);

/// @brief The costs as a table, a line a batch, with the fitted exponents below. @param costs the costs @return the table
[[nodiscard]] Table table_of(const std::vector<BatchCost>& costs);

/// @brief The costs as CSV with what is needed to repeat them: compiler, processor, widest vectors.
[[nodiscard]] std::string batch_cost_csv(const std::vector<BatchCost>& costs, int repeats);

/// @brief Nanoseconds an (r, mode), an r and an (r, beta) for modes, sums and maps over arrays, each with its limit. Of so many
/// runs the median is taken.
[[nodiscard]] Table batch_speed(int repeats);

/// @brief Errors of the vector maths library and of the functions used instead, in units in the last place. They are the worst
/// over seeded arguments, against long double.
[[nodiscard]] Table vector_function_errors();

} // namespace denhartog::tests
