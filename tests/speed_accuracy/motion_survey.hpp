/// @file
/// @brief d, q, their rates, the expression of (57), and (79), (83)-(85) against a reference in more digits, zone by zone.
#pragma once

#include <string>
#include <vector>

#include "tests/speed_accuracy/mode_functions_survey.hpp"

namespace denhartog::tests {

/// @brief Worst errors of a function in a zone, in units of eps over the condition number: 1 or, where larger, the relative
/// change for one of an argument; of d, q and their rates, which turn within a few units of a large tau / R, the change for an
/// argument moved by `most_allowed` units where that is larger.
///
/// The unit is eps times the size of the true value, or times the least normal number where that is larger.
struct FunctionInZone {
    std::string zone;          ///< the zone of (R, zeta) or zeta
    std::string function;      ///< the function
    int points = 0;            ///< how many
    int against_the_paper = 0; ///< of these, compared with the paper's formulas in 100 digits and more
    Worst printed;             ///< the paper's form, as corrected
    Worst shipped;             ///< the form that callers get
};

/// @brief Errors of (A.8), (A.9) and the expression of (57), at tau uniform over the half-period and close to its ends.
/// @param precision  number type
/// @param points     how many seeded points, over all zones; the hard ones are added
/// @return           one entry a zone and function
[[nodiscard]] std::vector<FunctionInZone> survey_motion(Precision precision, int points);

/// @brief Errors of (79), (83)-(85) from subnormal damping up.
/// @param precision  number type
/// @param points     how many seeded points
/// @return           one entry a function
[[nodiscard]] std::vector<FunctionInZone> survey_resonance(Precision precision, int points);

/// @brief The worst error. @param all entries @param which which error @return the error, and where
[[nodiscard]] Worst worst_of(const std::vector<FunctionInZone>& all, Worst FunctionInZone::*which);

/// @brief Entries as a table. @param title its title @param all the entries @return the table
[[nodiscard]] Table table_of(const std::string& title, const std::vector<FunctionInZone>& all);

} // namespace denhartog::tests
