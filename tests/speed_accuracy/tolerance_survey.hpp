/// @file
/// @brief The paper's algorithm against the closed form: error against tolerance.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/speed_accuracy/table.hpp"
#include "tests/support/sample_scenes.hpp"

namespace denhartog::tests {

/// @brief Tolerances of the paper's algorithm.
struct Tolerance {
    double absolute = 1e-6; ///< absolute
    double relative = 1e-6; ///< relative
};

/// @brief Tolerances that the surveys run through, the paper's absolute one with both readings of the relative one first.
/// @return  1e-6 with 1e-3 (the default of Matlab's ode45), then both 1e-6, 1e-8, 1e-10, 1e-12
[[nodiscard]] std::vector<Tolerance> tolerances();

/// @brief A tolerance as a column's name. @param t the tolerance @return e.g. `1e-06, rel 1e-03`
[[nodiscard]] std::string name(const Tolerance& t);

/// @brief Errors over a group of scenes.
struct ToleranceErrors {
    Worst from_rest; ///< amplitudes in the last of the cycles from rest, relative
    Worst on_closed; ///< the same, started on the closed form
    Worst phase;     ///< phases, started on the closed form, radians
    int failed = 0;  ///< integrations without an answer
};

/// @brief The paper's algorithm on scenes that slide, against the closed form.
/// @param scenes     scenes; those that do not slide are passed over
/// @param tolerance  tolerances
/// @param cycles     cycles
/// @param with_rest  whether to start from rest too
/// @return           errors of the amplitudes of all masses
[[nodiscard]] ToleranceErrors tolerance_errors(const std::vector<NamedScene<double>>& scenes, const Tolerance& tolerance,
                                               int cycles, bool with_rest);

/// @brief The paper's scenes by system and damping: the name up to the point.
/// @return groups of scenes, each with the name they share
[[nodiscard]] std::vector<std::pair<std::string, std::vector<NamedScene<double>>>> paper_scene_groups();

} // namespace denhartog::tests
