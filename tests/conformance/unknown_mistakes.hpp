/// @file
/// @brief Mistakes that are not on the list of the known ones, drawn by seeded rules: the diagnosis must not name any of them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "conformance/plain/closed_form.hpp"

namespace denhartog::tests {

/// @brief A mistake as what it changes: the question that is read, the formulas, the answer that is given.
struct UnknownMistake {
    std::string rule;                                                                          ///< by which it was drawn
    std::string told;                                                                          ///< what it is
    std::function<void(conformance::ProtocolQuestion&)> read;                                  ///< changes the question
    std::function<void(conformance::Choices&)> choose;                                         ///< changes the formulas
    std::function<void(const conformance::ProtocolQuestion&, conformance::Value&)> answer_out; ///< changes the answer
};

/// @brief Mistakes drawn by the rules: scale an input, swap two, drop a term, use another norm, change an answer. There are some
/// of every rule; the seed is that of factors and places.
[[nodiscard]] std::vector<UnknownMistake> unknown_mistakes(std::uint64_t seed);

/// @brief One mistake on top of another. @param a the one @param b the other @return both
[[nodiscard]] UnknownMistake both(const UnknownMistake& a, const UnknownMistake& b);

/// @brief What a program with a mistake answers that has the closed form alone. None where it has no answer.
[[nodiscard]] std::optional<conformance::Value> answer_of(const UnknownMistake& mistake, const conformance::ProtocolQuestion& q);

} // namespace denhartog::tests
