/// @file
/// @brief The score of an implementation: counts of verdicts and digits for each tier and group, but never one percentage.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "conformance/verdict.hpp"

namespace denhartog::conformance {

/// @brief Counts of verdicts.
using Counts = std::array<std::size_t, number_of_verdicts>;

/// @brief The score in one group of one tier.
struct Score {
    std::string tier;                    ///< `must`, `should` or `stress`
    std::string group;                   ///< the group
    std::size_t asked = 0;               ///< number of questions
    Counts counts{};                     ///< verdicts on them
    std::optional<double> median_digits; ///< median of the correct digits of numerical answers; empty if there are none
    std::optional<double> worst_digits;  ///< fewest correct digits of a numerical answer; empty if there are none
};

/// @brief Counts verdicts. @param judged the answers @return the counts
[[nodiscard]] Counts counts_of(std::span<const Judged> judged);

/// @brief Scores by tier, most binding first, and group. @param judged the answers @return the scores
[[nodiscard]] std::vector<Score> scores(std::span<const Judged> judged);

/// @brief Error divided by the tolerance of `pass`. @param judged an answer @return the quotient; empty without an error
[[nodiscard]] std::optional<double> error_over_tolerance(const Judged& judged);

/// @brief The answers that are not right, the worst first: by verdict, then by error over tolerance.
/// @param judged  the answers
/// @return        pointers into them, without the skipped ones
[[nodiscard]] std::vector<const Judged*> worst_first(std::span<const Judged> judged);

/// @brief Whether an implementation conforms: it answered something, every answer of the tier `must` is right or skipped, and
/// none of the needed quantities is skipped.
/// @param judged  the answers
/// @param needed  quantities that must not be skipped
/// @return        whether it does
[[nodiscard]] bool conforms(std::span<const Judged> judged, const std::set<std::string>& needed);

} // namespace denhartog::conformance
