/// @file
/// @brief The functions of a mode, of its motion and of resonance against a reference in more digits than their cancellations use
/// up, zone by zone; and the record of it for the pages of the site.
#pragma once

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

/// @brief Worst errors of a function in a zone, in units of eps over the condition number: 1 or, where larger, the relative
/// change for one of an argument; of d, q and their rates, which turn within a few units of a large tau / R, the change for an
/// argument moved by `most_allowed` units where that is larger.
///
/// The unit is eps times the size of the true value, or times the least normal number where that is larger; for u, where
/// \f$ \zeta^2 \f$ is below the least normal number, times that number over \f$ R^2 \f$.
struct FunctionInZone {
    std::string zone;          ///< the zone of (R, zeta) or zeta
    std::string function;      ///< the function
    int points = 0;            ///< how many
    int against_the_paper = 0; ///< of these, compared with the paper's formulas in 100 digits and more
    Worst printed{};           ///< the paper's form, as corrected
    Worst shipped{};           ///< the form that callers get
    Worst light{};             ///< the same of v, u, g at zeta up to 2^-10, R taken as exact: over the condition by zeta alone
    int poles = 0;             ///< points on a pole at zeta = 0, where nothing finite is the answer
    int finite_at_poles = 0;   ///< of these, where something finite was given
};

/// @brief Errors of v, u and g at seeded points and at the hard ones. So many points are seeded over all zones, here and below.
/// An entry a function and zone, the hard points last.
[[nodiscard]] std::vector<FunctionInZone> survey_mode_functions(Precision precision, int points);

/// @brief The same in double with the arrays of `evaluation/mode_arrays.hpp` in place of the scalar forms, at the same points.
[[nodiscard]] std::vector<FunctionInZone> survey_array_mode_functions(int points);

/// @brief Errors of (A.8), (A.9) and the expression of (57), at tau uniform over the half-period and close to its ends. The hard
/// points are added. An entry a zone and function.
[[nodiscard]] std::vector<FunctionInZone> survey_motion(Precision precision, int points);

/// @brief Errors of (79), (83)-(85) from subnormal damping up. An entry a function.
[[nodiscard]] std::vector<FunctionInZone> survey_resonance(Precision precision, int points);

/// @brief What the shipped forms are held to in every number type: units of eps over the condition number.
inline constexpr double most_allowed = 4;

/// @brief What they are held to where R is taken as exact, zeta up to 2^-10: units of eps over the condition number with respect
/// to zeta.
inline constexpr double most_allowed_with_exact_R = 6;

/// @brief The worst error. @param all entries @param which which error @return the error, and where
[[nodiscard]] Worst worst_of(const std::vector<FunctionInZone>& all, Worst FunctionInZone::*which);

/// @brief Entries as a table. @param title its title @param all the entries @return the table
[[nodiscard]] Table table_of(const std::string& title, const std::vector<FunctionInZone>& all);

/// @brief The worst errors of a survey as JSON. It is an object with `type`, e.g. `double`, and `functions`: function, equations,
/// zone, points, printed, shipped, shipped_at; an error that is no number is null.
[[nodiscard]] std::string accuracy_record(const std::string& type, const std::vector<FunctionInZone>& all);

/// @brief Writes a record into the folder that the environment names in DENHARTOG_RECORDS; does nothing where it names none. The
/// name is without `.json`. False where it cannot be written.
[[nodiscard]] bool keep_record(const std::string& name, const std::string& text);

} // namespace denhartog::tests
