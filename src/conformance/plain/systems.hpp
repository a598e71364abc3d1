/// @file
/// @brief Answers about systems beyond the paper: a contact between two masses, several loads, a moving base, matrices.
#pragma once

#include <optional>

#include "conformance/question.hpp"

namespace denhartog::conformance {

/// @brief The answer to a question about a system beyond the paper, by the library in double.
/// @param q  the question
/// @return   the answer; none where the quantity is one of a chain alone, or the motion has more than one period
/// @throws   InputError where the question breaks a rule; DomainError and PrecisionError where the library has no answer
[[nodiscard]] std::optional<Value> answer_of_system(const Question& q);

} // namespace denhartog::conformance
