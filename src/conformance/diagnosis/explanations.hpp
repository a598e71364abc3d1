// Explanations by mistakes with a number of their own, and properties of wrong answers that no known mistake explains.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "conformance/diagnose.hpp"

namespace denhartog::conformance {

// The chain from the frequencies to the motion: natural frequencies, R, shapes, v, u, g, V, U, G, H, S, boundary, rest interval,
// initial values, displacement, monoharmonic response, amplitude, phase, motion and stops. Links without an answer are left out.
[[nodiscard]] std::vector<InCommon> chain_of(std::span<const Judged* const> wrong, std::span<const Judged> judged);

// Properties that nine in ten of the wrong answers have, and the other answers to the same quantities less often; those that
// separate best first, three at most. Fewer than three wrong answers have nothing in common.
[[nodiscard]] std::vector<InCommon> properties_in_common(std::span<const Judged* const> wrong, std::span<const Judged> judged);

// The quantities of wrong answers, most wrong ones first.
[[nodiscard]] std::vector<InCommon> by_quantity(std::span<const Judged* const> wrong, std::span<const Judged> judged);

// Simple explanations: a factor or an offset in the answers, another value of one input, a chain read from its other end. Those
// with a number fit a wrong answer; the diagnosis weighs all as it weighs known mistakes.
[[nodiscard]] std::vector<Mistake> guesses_at(std::span<const Judged* const> wrong);

// Least number of answers that must show the same number of a mistake that has one, such as the instants of (57) or a period.
// Programs look for the maximum in (57) at instants. As printed (57) has no maximum, and a coarse grid misses the maximum of the
// corrected (57): either way the answer depends on the instants. If a program reads off a motion before it has settled, the
// answer depends on the period.
inline constexpr std::size_t least_agreeing = 3;

// Finds the period from rest, up to the 200th, in which a program reads off wrong amplitudes and motions, for `transient`.
[[nodiscard]] std::optional<Mistake> fitted_transient(std::span<const Judged> judged);

// Where a function changes its sign between neighbours of a grid.
[[nodiscard]] std::vector<double> sign_changes(const std::function<double(double)>& f, const std::vector<double>& grid);

[[nodiscard]] inline double share(std::size_t part, std::size_t whole) {
    return static_cast<double>(part) / static_cast<double>(whole);
}

// A few elements of a list, from all over it.
template <class T>
[[nodiscard]] std::vector<T> spread(const std::vector<T>& all, std::size_t most) {
    const std::size_t count = std::min(all.size(), most);
    std::vector<T> some;
    for (std::size_t n = 0; n < count; ++n) some.push_back(all[n * all.size() / count]);
    return some;
}

} // namespace denhartog::conformance
