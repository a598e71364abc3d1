/// @file
/// @brief The bounds of rounding errors against 100 digits: V, U, G, H, S, beta_lim, X_j, phi_j and x_k at an instant.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/speed_accuracy/table.hpp"

namespace denhartog::tests {

/// @brief How the bound of one quantity compares with its error.
struct QuantityBounds {
    long count = 0;                ///< comparisons; numbers that their formula makes zero are not counted
    long violations = 0;           ///< errors above the bound
    double most_used = 0;          ///< the largest error over its bound
    std::string worst{};           ///< where, in hexadecimal
    std::vector<long> histogram{}; ///< bound over error in twentieths of a decade; errors of zero in the last place

    /// @brief A quantile of bound over error. @param part from 0 to 1 @return upper end of the twentieth of a decade it lies in
    [[nodiscard]] double over_estimate(double part) const;
};

/// @brief Bounds against errors over seeded scenes.
struct BoundsSurvey {
    long scenes = 0;                                    ///< scenes: a system, r, beta and an instant each
    long poles = 0;                                     ///< r next to a pole of a mode without damping: no answer
    long unsettled = 0;                                 ///< frequencies at which the search for S found no end
    long full_searches = 0;                             ///< frequencies at which S was searched for in 100 digits too
    long regimes = 0;                                   ///< regimes that the bound of beta_lim decides
    long wrong_regimes = 0;                             ///< of these, wrong ones
    long open_regimes = 0;                              ///< beta within the bound of beta_lim
    std::map<std::string, QuantityBounds> quantities{}; ///< by name
    std::map<int, long> steps{};                        ///< scenes whose bounds do not leave so many digits, by their number

    /// @brief Errors above their bounds, regimes included. @return the count
    [[nodiscard]] long violations() const;
    /// @brief The largest median of bound over error. @return over all quantities
    [[nodiscard]] double largest_median() const;
};

/// @brief Compares bounds in double, modes from long double, with 100 digits.
///
/// Systems of 1 to 12 masses, chains and others, damping ratios none or from 1e-12 to 0.99; eight frequency ratios each, from
/// 1e-3 to 1e3, near resonances and near the poles of modes without damping; four friction ratios each, from 1e-6 to beyond the
/// boundary and within 1e-15 of it; an instant each. Scenes are rounded up to whole systems. Every bound is multiplied by the
/// damage: with less than 1 the survey must find violations.
[[nodiscard]] BoundsSurvey survey_bounds(long scenes, std::uint64_t seed, double damage = 1);

/// @brief The survey as tables. @param survey the survey @return bounds by quantity; steps
[[nodiscard]] std::vector<Table> tables_of(const BoundsSurvey& survey);

} // namespace denhartog::tests
