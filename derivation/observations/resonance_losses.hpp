/// @file
/// @brief Losses of the printed forms of (81), (82), (86): what the systems of the sliding scenes lose at their resonances and at
/// high frequency ratios.
#pragma once

#include <optional>

#include "derivation/observations/sliding_scenes.hpp"

namespace denhartog::derivation {

/// @brief Largest error of (81) as printed at the resonances of a scene's system, over the largest amplitude (52) there.
///
/// V and G are the resonant terms (77) and (80), the friction ratio is the scene's. Passed over: resonances without damping,
/// those where the contact does not slide, and masses for which (81) has no real value with the correct signs.
/// @param scene  a scene
/// @return       the error; none where no resonance is left
[[nodiscard]] std::optional<double> error_with_81(const SlidingScene& scene);

/// @brief The error of (82) with the complex response function. @param scene a scene @return the error; none as above
[[nodiscard]] std::optional<double> error_with_82(const SlidingScene& scene);

/// @brief Relative error of the limit (86) as printed. @param scene a scene @return the error; none where j is not l
[[nodiscard]] std::optional<double> error_with_86(const SlidingScene& scene);

} // namespace denhartog::derivation
