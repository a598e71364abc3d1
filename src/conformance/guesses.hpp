/// @file
/// @brief Simple explanations of wrong answers that no known mistake explains: a factor or an offset of the answers, another value
/// of one input, another end of the chain. They are guesses; the diagnosis weighs them as it weighs known mistakes.
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
    std::function<std::optional<Value>(const Question&)> answers; ///< what is answered then; none where it says nothing
};

/// @brief Guesses that fit one of the wrong answers or need none to fit. @param wrong the wrong answers @return the guesses
[[nodiscard]] std::vector<Guess> guesses_at(std::span<const Judged* const> wrong);

} // namespace denhartog::conformance
