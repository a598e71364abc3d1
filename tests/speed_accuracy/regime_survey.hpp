/// @file
/// @brief The regime of seeded points by the boundary formulas and by the exact solver, and what is behind each disagreement.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/speed_accuracy/table.hpp"

namespace denhartog::tests {

/// @brief How the two answers at a point go together. All but the first and the last two were verified by a further motion.
enum class Comparison {
    agree,           ///< the same regime
    on_boundary,     ///< beta is within 1e-9 of a boundary
    several_motions, ///< the formula's motion is there, and rest leads to another one: mu > 1 or a mode without damping
    never_settles,   ///< rest leads to no periodic motion in the time allowed: mu > 1 or a mode without damping
    turns,           ///< sliding without a stop, but it turns back more than twice a period
    asymmetric,      ///< sliding without a stop that does not mirror itself after half a period
    pole,            ///< a mode without damping resonates: there is no boundary
    unexplained      ///< none of these
};

/// @brief What to call a comparison. @param c the comparison @return a phrase
[[nodiscard]] std::string name(Comparison c);

/// @brief The points compared, and counts.
struct RegimeSurvey {
    int points = 0;                                   ///< points
    std::map<std::pair<bool, Comparison>, int> count; ///< unique steady velocities or not; comparison
    std::map<Comparison, std::string> example;        ///< the first point of each kind
    std::map<std::string, int> regimes;               ///< agreements by regime
    std::vector<std::string> unexplained;             ///< all that are
};

/// @brief Compares seeded points: random systems, half of them with mu = 1, friction up to 1.25 times the upper boundary. Systems
/// have at most 10 masses. After `most_periods` of propagation a motion is taken not to settle; ten times as many where the
/// steady velocities are unique.
[[nodiscard]] RegimeSurvey survey_regimes(int points, std::size_t most_masses, int most_periods, std::uint64_t seed);

/// @brief The survey as tables. @param s the survey @return counts by kind
[[nodiscard]] Table table_of(const RegimeSurvey& s);

} // namespace denhartog::tests
