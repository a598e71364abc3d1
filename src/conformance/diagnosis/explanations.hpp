// What the diagnosis says of wrong answers that no known mistake explains.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "conformance/diagnose.hpp"

namespace denhartog::conformance {

// Which link a question belongs to. From 0; the functions of one mass come before the sums over modes.
[[nodiscard]] std::size_t place_in_chain(const ProtocolQuestion& q);

// The chain from the frequencies to the motion: natural frequencies, R, shapes, v, u, g, V, U, G, H, S, boundary, amplitude,
// phase, motion. Links without an answer are left out.
[[nodiscard]] std::vector<Link> chain_of(std::span<const Judged* const> wrong, std::span<const Judged> judged);

// Properties that nine in ten of the wrong answers have, and the other answers to the same quantities less often; those with the
// largest share of wrong answers first, five at most. Fewer than three wrong answers have nothing in common.
[[nodiscard]] std::vector<InCommon> properties_in_common(std::span<const Judged* const> wrong, std::span<const Judged> judged);

// The quantities of wrong answers, most wrong ones first.
[[nodiscard]] std::vector<InCommon> by_quantity(std::span<const Judged* const> wrong, std::span<const Judged> judged);

// A simple explanation: a factor or an offset in the answers, another value of one input, a chain read from its other end. It is a
// guess, which the diagnosis weighs as it weighs known mistakes.
struct Guess {
    std::string told;                                                     // in words: `beta times 1.414`
    std::function<std::optional<Value>(const ProtocolQuestion&)> answers; // the answer by this guess; none if it says nothing
};

// Guesses whose number fits a wrong answer, and guesses without a number.
[[nodiscard]] std::vector<Guess> guesses_at(std::span<const Judged* const> wrong);

// Where a function changes its sign between neighbours of a grid, each place by a number of halvings.
[[nodiscard]] std::vector<double> sign_changes(const std::function<double(double)>& f, const std::vector<double>& grid,
                                               int halvings);

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
