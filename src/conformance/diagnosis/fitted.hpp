// Mistakes that have a number of their own, which the answers reveal.
//
// Programs look for the maximum in (57) at instants. As printed (57) has no maximum, and a coarse grid misses the maximum of the
// corrected (57): either way the answer depends on the instants. If a program reads off a motion before it has settled, the
// answer depends on the period. Such a number counts as found if several answers show the same one.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "conformance/verdict.hpp"

namespace denhartog::conformance {

// The number of answers that have to show the same number.
inline constexpr std::size_t least_agreeing = 3;

// A mistake with the number that fits.
struct Fitted {
    std::string number;                                                  // in words: `read off in period 7 from rest`
    std::function<std::optional<Value>(const ProtocolQuestion&)> answer; // the answer of the mistake with this number
};

// Mistakes with the numbers that fit, by name.
using FittedMistakes = std::map<std::string, Fitted>;

// Fits `57-as-printed`, `coarse-grid-of-tau` and `transient` to the wrong answers: those for which three or more answers show the same number.
[[nodiscard]] FittedMistakes fitted_mistakes(std::span<const Judged> judged);

// Finds the instants at which a program looks for the maximum of (57), from wrong answers for S_j and the boundaries. The
// instants may be the same in every scene, or proportional to r, 1 / r, R_1 or R_N.
[[nodiscard]] FittedMistakes fitted_instants(std::span<const Judged> judged);

// Finds the period from rest, up to the 200th, in which a program reads off wrong amplitudes and motions.
[[nodiscard]] FittedMistakes fitted_transient(std::span<const Judged> judged);

} // namespace denhartog::conformance
