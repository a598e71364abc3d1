/// @file
/// @brief The closed form of the sliding regime where it does not hold any more: what one computes who forgets the boundary.
#pragma once

#include <optional>

#include "conformance/question.hpp"

namespace denhartog::conformance {

/// @brief The answer of the closed form (38)-(53) with no look at the boundary (69).
/// @param q  a question whose scene keeps the rules
/// @return   the answer; none where the quantity is not of the steady motion or the root in (38) is not real
[[nodiscard]] std::optional<Value> closed_form_beyond_boundary(const Question& q);

} // namespace denhartog::conformance
