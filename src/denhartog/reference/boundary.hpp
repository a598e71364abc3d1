/// @file
/// @brief The boundary of the sliding regime, proved: (54) to (58), (67), (69).
#pragma once

#include "denhartog/reference/friction.hpp"
#include "denhartog/sliding/regime_at_point.hpp"

namespace denhartog::reference {

/// @brief The friction ratios that end the sliding regime at a frequency ratio.
struct BoundaryInBalls {
    Ball exact{};       ///< (69) with the maximum over tau of the sum over modes
    Ball paper{};       ///< (69) with (56), the sum of the maxima of the modes; `exact` without damping ratios
    Ball approximate{}; ///< (67)
    Ball S{};           ///< the maximum over tau of the sum over modes of the function in (57)
    BindingCondition binding = BindingCondition::both; ///< which condition of (54) ends the regime first
};

/// @brief The boundary from the response functions.
/// @eq{54,56,57,58,67,69}
/// @param s  the scene
/// @param r  its response functions
/// @return   the boundary
/// @throws   Unproved where a maximum is not settled
[[nodiscard]] BoundaryInBalls boundary_in_balls(const SceneInBalls& s, const ResponsesInBalls& r);

} // namespace denhartog::reference
