/// @file
/// @brief What wrong answers have in common.
#pragma once

#include <span>
#include <vector>

#include "conformance/diagnose.hpp"

namespace denhartog::conformance {

/// @brief Properties that nine in ten of the wrong answers have, and the other answers to the same quantities less often; those
/// with the largest share of wrong answers first, five at most. Fewer than three wrong answers have nothing in common.
/// @param wrong   the wrong answers
/// @param judged  all answers
/// @return        the properties
[[nodiscard]] std::vector<InCommon> properties_in_common(std::span<const Judged* const> wrong, std::span<const Judged> judged);

/// @brief The quantities of wrong answers, most wrong ones first. @param wrong the wrong answers @param judged all answers
/// @return  the quantities
[[nodiscard]] std::vector<InCommon> by_quantity(std::span<const Judged* const> wrong, std::span<const Judged> judged);

} // namespace denhartog::conformance
