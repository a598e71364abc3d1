/// @file
/// @brief Invariant points of a scene with the digits asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "denhartog/answer/scene_source.hpp"
#include "denhartog/number/certified.hpp"
#include "denhartog/sliding/invariant_points.hpp"

namespace denhartog {

/// @brief The ends of a range of frequency ratios as text, which every number type reads to its own digits.
struct RangeInText {
    std::string from; ///< positive
    std::string to;   ///< above it
};

/// @brief The invariant points of every mass, damping left out, from the first precision that has the digits.
/// @eq{87}
/// @param source  the scene
/// @param range   frequency ratios between which points are wanted
/// @param digits  significant digits, from 1 to `most_digits`; by default the aim is 6, and 50 digits are the last precision
/// @return        the points of each mass, in their order; stretches that the last precision leaves undecided are listed
/// @throws        InputError where the range breaks a rule of `invariant_points`; PrecisionError where a point has fewer digits
[[nodiscard]] std::vector<InvariantPointsOfMass<Certified>>
certain_invariant_points(const SceneSource& source, const RangeInText& range, std::optional<int> digits);

} // namespace denhartog
