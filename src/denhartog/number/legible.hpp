// Text from outside, fit for a message: what a terminal would obey is escaped, what is long is shortened.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace denhartog {

// The most bytes of a text from outside that a message shows, unless it says otherwise.
inline constexpr std::size_t most_shown = 200;

// Any bytes as text that can be printed on a terminal. Valid UTF-8 stays as it is. Control characters, characters that turn the
// direction of writing, and bytes that are no UTF-8 become `\xHH`. A longer text loses its middle, for which three dots stand. A
// text that is legible comes out unchanged. The most bytes are at least 8.
[[nodiscard]] std::string legible(std::string_view text, std::size_t most = most_shown);

} // namespace denhartog
