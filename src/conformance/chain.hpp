/// @file
/// @brief The chain of quantities, each made of those before it: the first that is wrong is where to look.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "conformance/verdict.hpp"

namespace denhartog::conformance {

/// @brief A link of the chain.
struct Link {
    std::string name;         ///< in words, e.g. `shapes`
    std::size_t answered = 0; ///< answers to its quantities
    std::size_t wrong = 0;    ///< of these the wrong ones in question
};

/// @brief Which link a question belongs to. @param q the question @return its place, from 0; the functions of one mass come
/// before the sums over modes
[[nodiscard]] std::size_t place_in_chain(const ProtocolQuestion& q);

/// @brief The chain from the frequencies to the motion: natural frequencies, R, shapes, v, u, g, V, U, G, H, S, boundary,
/// amplitude, phase, motion. Links without an answer are left out.
/// @param wrong   the wrong answers in question
/// @param judged  all answers
/// @return        the links in order
[[nodiscard]] std::vector<Link> chain_of(std::span<const Judged* const> wrong, std::span<const Judged> judged);

} // namespace denhartog::conformance
