/// @file
/// @brief Mistakes with a number of their own, which is found from the answers.
///
/// The maximum in (57) is sought at instants. As printed (57) has no maximum, and as corrected a coarse grid misses it: either
/// way the answer depends on the instants. What is read off before the motion has settled depends on the period. Such a number
/// is found where several answers show the same.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "conformance/verdict.hpp"

namespace denhartog::conformance {

/// @brief How many answers have to show the same number.
inline constexpr std::size_t least_agreeing = 3;

/// @brief A mistake with the number that fits.
struct Fitted {
    std::string number;                                          ///< in words: `read off in period 7 from rest`
    std::function<std::optional<Value>(const Question&)> answer; ///< what the mistake answers with it
};

/// @brief Mistakes with the numbers that fit, by their names.
using FittedMistakes = std::map<std::string, Fitted>;

/// @brief Fits `57-as-printed`, `coarse-grid-of-tau` and `transient` to the wrong answers.
/// @param judged  the answers
/// @return        those mistakes of which three answers or more show the same number
[[nodiscard]] FittedMistakes fitted_mistakes(std::span<const Judged> judged);

/// @brief Fits the instants at which the maximum of (57) is sought to wrong answers for S_j and the boundaries.
///
/// The instants may be the same in every scene, or go with r, 1 / r, R_1 or R_N.
/// @param judged  the answers
/// @return        `57-as-printed` or `coarse-grid-of-tau`, if three answers or more show the same instants
[[nodiscard]] FittedMistakes fitted_instants(std::span<const Judged> judged);

/// @brief Fits the period from rest, up to the 200th, in which wrong answers for amplitude and motion are read off.
/// @param judged  the answers
/// @return        `transient`, if three answers or more show the same period
[[nodiscard]] FittedMistakes fitted_transient(std::span<const Judged> judged);

} // namespace denhartog::conformance
