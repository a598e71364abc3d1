/// @file
/// @brief Mistakes with a number of their own, which is found from the answers.
///
/// The maximum in (57) is sought at instants. As printed (57) has no maximum, and as corrected a coarse grid misses it: either
/// way the answer depends on the instants. They are found where several answers show the same.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "conformance/verdict.hpp"

namespace denhartog::conformance {

/// @brief What mistakes answer with the numbers that fit, by their names.
using FittedAnswers = std::map<std::string, std::function<std::optional<Value>(const Question&)>>;

/// @brief Fits `57-as-printed` and `coarse-grid-of-tau` to wrong answers for S_j and the boundaries.
/// @param judged  the answers
/// @return        those mistakes of which three answers or more show the same instants
[[nodiscard]] FittedAnswers fitted_answers(std::span<const Judged> judged);

} // namespace denhartog::conformance
