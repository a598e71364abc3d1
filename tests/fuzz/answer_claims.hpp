/// @file
/// @brief What the fuzz targets claim of the answers that the conformance kit reads.
#pragma once

#include <algorithm>
#include <cmath>

#include "conformance/question.hpp"
#include "denhartog/number/number_text.hpp"
#include "tests/fuzz/claims.hpp"

namespace denhartog::fuzz {

/// @brief An answer is finite numbers, or one regime, or words; what is unusable has a message.
inline void claim_answer(const conformance::Answer& answer) {
    if (const auto* unusable = std::get_if<conformance::Unusable>(&answer)) claim_message(unusable->reason);
    const auto* value = std::get_if<conformance::Value>(&answer);
    if (value == nullptr) return;
    claim(std::all_of(value->numbers.begin(), value->numbers.end(), [](double x) { return std::isfinite(x); }),
          "an answer's numbers are finite");
    const std::string& word = value->word;
    claim(word.empty() || word == "continuous" || word == "stick_slip" || word == "permanent_sticking", "a word is a regime",
          word);
    claim(word.empty() || value->numbers.empty(), "an answer is numbers or a word", word);
}

/// @brief A value as words with single spaces. @param value the value @return its numbers, or its word
[[nodiscard]] inline std::string words_of(const conformance::Value& value) {
    std::string words = value.word;
    for (const double x : value.numbers) words += (words.empty() ? "" : " ") + number_to_text(x);
    return words;
}

/// @brief An answer that was written and read again is the value that it was. `shown` is its text.
inline void claim_same(const conformance::Answer& again, const conformance::Value& value, const std::string& shown) {
    const auto* read = std::get_if<conformance::Value>(&again);
    claim(read != nullptr && read->numbers == value.numbers && read->word == value.word, "a value is the same again", shown);
}

} // namespace denhartog::fuzz
