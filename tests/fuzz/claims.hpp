/// @file
/// @brief What the fuzz targets claim of every input. A claim that does not hold ends the program: the fuzzer keeps the input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/legible.hpp"

namespace denhartog::fuzz {

/// @brief Ends the program where something that must hold does not. `shown` is what it does not hold of.
inline void claim(bool holds, std::string_view what, std::string_view shown = {}) {
    if (holds) return;
    std::fprintf(stderr, "does not hold: %.*s: %s\n", static_cast<int>(what.size()), what.data(), legible(shown, 4000).c_str());
    std::abort();
}

/// @brief A message says something, is short, and holds nothing that a terminal would obey. It has at most so many bytes.
inline void claim_message(std::string_view text, std::size_t most = 999) {
    claim(!text.empty(), "a message says something");
    claim(text.size() <= most, "a message is short", text);
    claim(legible(text, most) == text, "a message holds no character that a terminal obeys", text);
}

/// @brief Runs a question. What is thrown and is not an error of the library's own goes on, and ends the program. False where it
/// was refused with a message.
template <class Body>
bool answers(const Body& body) {
    try {
        body();
        return true;
    } catch (const InputError& e) {
        claim(!e.quantity.empty() && !e.rule.empty(), "an error of input names quantity and rule", e.what());
        claim_message(e.what());
    } catch (const DomainError& e) {
        claim_message(e.what());
    } catch (const PrecisionError& e) {
        claim_message(e.what());
    }
    return false;
}

/// @brief The bytes of an input as text. @param data the bytes @param size their number @return the text
inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// @brief Takes the first line off a text. @param text the text; loses the line and its end @return the line
inline std::string_view first_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    return line;
}

} // namespace denhartog::fuzz
