/// @file
/// @brief Invariant points of a scene with the digits asked for.
#pragma once

#include <optional>
#include <vector>

#include "denhartog/answer/reference_invariant_points.hpp"

namespace denhartog {

/// @brief The invariant points of every mass, damping left out: in double, or by the reference where that leaves something open.
///
/// The reference answers where a proof or more than 14 digits are asked for, where double leaves a stretch undecided and where a
/// point has fewer digits than are wanted. Where neither digits nor a proof are asked for, it is not asked about more than 40
/// masses.
/// @eq{87}
/// @param source  the scene
/// @param range   frequency ratios between which points are wanted
/// @param digits  significant digits, from 1 to `most_digits`; by default the aim is 6
/// @param proved  whether every number must be proved
/// @return        the points of each mass, in their order; stretches that stay undecided are listed
/// @throws        InputError where the range breaks a rule of `check_range`; PrecisionError where a point has fewer digits
[[nodiscard]] std::vector<InvariantPointsOfMass<Certified>>
certain_invariant_points(const SceneSource& source, const RangeInText& range, std::optional<int> digits, bool proved = false);

} // namespace denhartog
