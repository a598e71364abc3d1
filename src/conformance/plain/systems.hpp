/// @file
/// @brief Answers about systems beyond the paper: a contact between two masses, several loads, a moving base, matrices.
#pragma once

#include <optional>

#include "conformance/question.hpp"

namespace denhartog::conformance {

/// @brief The answer to a question about a system beyond the paper, by the library in double.
/// @param q  the question
/// @return   the answer; none if only a chain has the quantity, or if the motion takes more than one period to repeat
/// @throws   InputError if the question breaks a rule; DomainError and PrecisionError if the library has no answer
[[nodiscard]] std::optional<Value> answer_of_system(const ProtocolQuestion& q);

} // namespace denhartog::conformance
