/// @file
/// @brief JSON text with nothing silently repaired: duplicate keys and numbers that no double holds are faults.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace denhartog {

/// @brief Reads one JSON text.
/// @param text  the text
/// @param line  number of its first line, for messages
/// @return      the value
/// @throws InputError with line and column where the text is no JSON (NaN and Infinity are none), with the JSON pointer where a
///         key is given twice, a number is beyond a double, or values are nested deeper than a scene's
[[nodiscard]] nlohmann::json read_json(std::string_view text, std::size_t line = 1);

/// @brief One step of a JSON pointer.
/// @param key  a key
/// @return     `/key` with the two reserved characters escaped
[[nodiscard]] std::string pointer_step(std::string_view key);

/// @brief Text fit for an error message.
/// @param text  any bytes
/// @return      printable characters, at most 40 of them
[[nodiscard]] std::string printable(std::string_view text);

} // namespace denhartog
