/// @file
/// @brief Invariant points by the reference: to any number of digits, every number proved.
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

/// @brief The invariant points of every mass, damping left out. Bits are doubled until every point has its digits.
/// @eq{87}
/// @param source   the scene
/// @param range    frequency ratios between which points are wanted
/// @param digits   significant digits, all certain in the answer; where none are asked for the aim is 6, and bits are doubled once
///                 at most
/// @return         the points of each mass, in their order; every number is proved. Stretches that stay undecided are listed
/// @throws         InputError where the range breaks a rule, see `invariant_points_in_balls`; PrecisionError where something
///                 cannot be proved, the budget of work is spent, or the library was built without the reference
[[nodiscard]] std::vector<InvariantPointsOfMass<Certified>> invariant_points(const SceneSource& source, const RangeInText& range,
                                                                             std::optional<int> digits = {});

} // namespace denhartog
