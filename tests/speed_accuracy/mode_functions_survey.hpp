/// @file
/// @brief The mode functions v, u, g against a reference in more digits than their cancellations use up, zone by zone.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tests/speed_accuracy/table.hpp"

namespace denhartog::tests {

/// @brief Number types that the survey is made for.
enum class Precision {
    in_float,       ///< `float`
    in_double,      ///< `double`
    in_long_double, ///< `long double`
    in_50_digits    ///< `Real50`
};

/// @brief What a precision is called. @param p the precision @return its name
[[nodiscard]] std::string name(Precision p);

/// @brief Errors of one function in one zone, over its condition number: 1 or, where larger, the relative change for one of R
/// or zeta.
///
/// The unit is eps times the size of the true value, or times the least normal number where that is larger; for u, where
/// \f$ \zeta^2 \f$ is below the least normal number, times that number over \f$ R^2 \f$.
struct FunctionErrors {
    Worst printed; ///< the paper's form as printed
    Worst by_both; ///< the shipped form
    Worst light; ///< the shipped form at zeta up to 2^-10, R taken as exact: over the condition number with respect to zeta alone
};

/// @brief Errors in one zone of (R, zeta).
struct ZoneErrors {
    std::string zone;                        ///< its name
    int points = 0;                          ///< how many
    int against_the_paper = 0;               ///< of these, compared with the paper's formulas in 100 digits and more
    int poles = 0;                           ///< points on a pole at zeta = 0, where nothing finite is the answer
    int finite_at_poles = 0;                 ///< of these, where something finite was given
    std::array<FunctionErrors, 4> functions; ///< Re v, Im v, u, g
};

/// @brief Errors of the mode functions at seeded points and at the hard ones.
/// @param precision  number type
/// @param points     how many seeded points, over all zones
/// @return           one entry a zone, the hard points last
[[nodiscard]] std::vector<ZoneErrors> survey_mode_functions(Precision precision, int points);

/// @brief The same in double with the arrays of `evaluation/mode_arrays.hpp` in place of the scalar forms, at the same points.
/// @param points  how many seeded points, over all zones
/// @return        one entry a zone, the hard points last
[[nodiscard]] std::vector<ZoneErrors> survey_array_mode_functions(int points);

/// @brief What the shipped forms are held to in every number type: units of eps over the condition number.
inline constexpr double most_allowed = 4;

/// @brief What they are held to where R is taken as exact, zeta up to 2^-10: units of eps over the condition number with respect
/// to zeta.
inline constexpr double most_allowed_with_exact_R = 6;

/// @brief The worst error of all functions in all zones.
/// @param zones  the zones
/// @param which  which error
/// @return       the error, and where
[[nodiscard]] Worst worst_of(const std::vector<ZoneErrors>& zones, Worst FunctionErrors::*which);

/// @brief The survey as a table. @param what what was surveyed @param zones the zones @return the table
[[nodiscard]] Table table_of(const std::string& what, const std::vector<ZoneErrors>& zones);

} // namespace denhartog::tests
