/// @file
/// @brief A claim's comparison for a reader: both sides, the relations that make them equal, what must not be zero.
#pragma once

#include <vector>

#include "derivation/claims/claim.hpp"

namespace denhartog::derivation {

/// @brief The lines on a comparison. Of many components the first are shown, and each different line once.
/// @param before     the lines that lead to it; what they end with is not said twice
/// @param kernel     the formula under test, component by component
/// @param derived    what the derivation gives
/// @param decisions  what the zero test made of each pair
/// @return           the lines
[[nodiscard]] std::vector<Step> steps_of_comparison(const std::vector<Step>& before, const Values& kernel,
                                                    const std::vector<GiNaC::ex>& derived,
                                                    const std::vector<Decision>& decisions);

} // namespace denhartog::derivation
