/// @file
/// @brief Simple explanations of wrong answers that no known mistake explains: a factor or an offset in the answers, another
/// value of one input, a chain read from its other end. They are guesses, which the diagnosis weighs as it weighs known mistakes.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "conformance/verdict.hpp"

namespace denhartog::conformance {

/// @brief A simple explanation.
struct Guess {
    std::string told;                                             ///< in words: `beta times 1.414`
    std::function<std::optional<Value>(const ProtocolQuestion&)> answers; ///< the answer by this guess; none if it says nothing
};

/// @brief Guesses whose number fits a wrong answer, and guesses without a number. @param wrong these @return the guesses
[[nodiscard]] std::vector<Guess> guesses_at(std::span<const Judged* const> wrong);

} // namespace denhartog::conformance
