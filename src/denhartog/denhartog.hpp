/// @file
/// @brief All that a C++ user needs: a scene, `solve`, `boundary`, `map`, `motion`, and the errors.
///
/// Every number of an answer is a `Certified`: a value with the bound of its error and, where more than 15 digits were asked for,
/// its decimals. Masses are counted from 0 here, as `Mass{0}`, and from 1 in JSON.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "denhartog/answer/solution.hpp"
#include "denhartog/map/regime_map.hpp"
#include "denhartog/number/certified.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/scene/scene.hpp"
#include "denhartog/scene/scene_json.hpp"
#include "denhartog/solve/sampled_solution.hpp"

namespace denhartog {

/// @brief A scene from its JSON text. @param json the text of one scene @return the scene, checked
/// @throws InputError with quantity, rule, value and place
[[nodiscard]] Scene<double> scene(std::string_view json);

/// @brief The steady motion at the point of a scene, in every regime.
/// @param scene     the scene, with r and beta; its doubles are meant to the last bit
/// @param question  what is asked, e.g. `{.digits = 10}`
/// @return          the answer
/// @throws          InputError for a bad scene or question; DomainError at a pole of a mode without damping; PrecisionError where
///                  no model reaches the digits asked for or no steady motion is found
[[nodiscard]] Solution solve(const Scene<double>& scene, const Question& question = {});

/// @brief The friction ratios that part the regimes at the frequency ratio of a scene.
/// @eq{56,67,69,88}
/// @param scene   the scene, with r
/// @param digits  significant digits; without, 6 are aimed at
/// @return        the boundary
/// @throws        InputError for a bad scene; DomainError at a pole; PrecisionError where the digits are not reached
[[nodiscard]] Limits boundary(const Scene<double>& scene, std::optional<int> digits = std::nullopt);

/// @brief Regime, amplitudes of all masses and stops over a grid, in double.
/// @param scene  system and mu; its r and beta are not used
/// @param r      frequency ratios, the columns
/// @param beta   friction ratios
/// @return       the map
/// @throws       InputError where the scene or the grid breaks a rule
[[nodiscard]] RegimeMap map(const Scene<double>& scene, const std::vector<double>& r, const std::vector<double>& beta);

/// @brief The steady motion at equally spaced instants of its period, from the maximum of the force.
/// @param scene    the scene, with r and beta
/// @param samples  instants in a period, from 1 to `most_samples_of` the number of masses
/// @return         displacements and velocities of all masses
/// @throws         as `solve`
[[nodiscard]] SampledSolution motion(const Scene<double>& scene, std::size_t samples);

} // namespace denhartog
