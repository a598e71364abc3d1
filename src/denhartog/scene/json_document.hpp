// JSON text with nothing silently repaired: duplicate keys and numbers that no double holds are faults.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace denhartog {

// Reads one JSON text. Throws InputError with line and column where the text is no JSON (NaN and Infinity are none) or holds a
// zero byte, with the JSON pointer where a key is given twice, a number is beyond a double, or values are nested deeper than a
// scene's.
[[nodiscard]] nlohmann::json read_json(std::string_view text, std::size_t line = 1);

// The number in a value: a JSON number, or a text that is written like one; none for any other value.
[[nodiscard]] std::optional<double> number_in(const nlohmann::json& value);

// One step of a JSON pointer: `/key` with the two reserved characters escaped.
[[nodiscard]] std::string pointer_step(std::string_view key);

// Refuses a zero byte, at which the JSON library takes a text to end: what follows would be lost without a word. Throws
// InputError with line and column of the first zero byte.
void refuse_zero_byte(const std::string& quantity, std::string_view text, std::size_t line = 1);

// Whether a text is JSON as a whole; not where it holds a zero byte.
[[nodiscard]] bool is_json(std::string_view text);

// Whether brackets are nested deeper than in any text of this library: the JSON library copies and writes values by recursion,
// which has an end.
[[nodiscard]] bool nested_too_deeply(std::string_view text);

// The value of a text of which the caller says what is wrong with it. A discarded one, which is no object, where
// the text is no JSON as a whole, holds a zero byte, or is nested too deeply.
[[nodiscard]] nlohmann::json json_or_nothing(std::string_view text);

// The most bytes of a value that a message shows.
inline constexpr std::size_t most_of_a_value = 43;

} // namespace denhartog
