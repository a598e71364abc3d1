/// @file
/// @brief JSON documents that are no scenes, read and checked in the same way.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace denhartog {

/// @brief Reads one JSON text as `read_json` reads a scene.
/// @param text     the text
/// @param line     number of its first line, for messages
/// @param of       what the text is, for messages
/// @param deepest  how deeply its values may be nested
/// @return         the value
/// @throws         InputError as `read_json` of a scene
[[nodiscard]] nlohmann::json read_json(std::string_view text, std::size_t line, const std::string& of, std::size_t deepest);

/// @brief The nearest of some words to one that is none of them, as the end of a sentence.
/// @param unknown  the word
/// @param known    the words, at least one
/// @return         e.g. `; did you mean mass_ratios?`; empty where none is near
[[nodiscard]] std::string did_you_mean(std::string_view unknown, std::span<const std::string_view> known);

/// @brief The rule that an unknown key breaks, with the key that was meant, if there is one like it, and all keys.
/// @param of       what has the keys, with its article
/// @param unknown  the key
/// @param known    the keys that there are
/// @return         the rule
[[nodiscard]] std::string rule_of_keys(std::string_view of, std::string_view unknown, std::span<const std::string_view> known);

} // namespace denhartog
