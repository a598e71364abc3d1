// Text from outside as a message shows it. Read `legible` first: it cuts long text and escapes the characters that a
// terminal would obey, which `is_obeyed` decides.
#include "denhartog/number/legible.hpp"

#include <cstdint>
#include <cstdio>
#include <vector>

namespace denhartog {
namespace {

struct Character {
    std::size_t bytes = 0; // 0 if the text does not start with a character of UTF-8
    std::uint32_t code = 0;
};

Character character_at_start(std::string_view text) {
    constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const auto lead = static_cast<unsigned char>(text.front());
    if (lead < 0x80) return {1, lead};
    const std::size_t bytes = lead >= 0xF8 ? 0 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 0;
    if (bytes == 0 || text.size() < bytes) return {};
    std::uint32_t code = lead & (0x7FU >> bytes);
    for (std::size_t n = 1; n < bytes; ++n) {
        const auto next = static_cast<unsigned char>(text[n]);
        if ((next & 0xC0U) != 0x80) return {};
        code = code << 6U | (next & 0x3FU);
    }
    const bool surrogate = code >= 0xD800 && code < 0xE000;
    return code < least[bytes] || surrogate || code > 0x10FFFF ? Character{} : Character{bytes, code};
}

// Control characters, line and paragraph separators, and what turns the direction of writing.
bool is_obeyed(std::uint32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x61C || code == 0x200E || code == 0x200F ||
           (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

// The characters of a text, those that are obeyed and bytes that are none escaped.
std::vector<std::string> characters_of(std::string_view text) {
    std::vector<std::string> all;
    while (!text.empty()) {
        const Character c = character_at_start(text);
        const std::size_t bytes = c.bytes == 0 ? 1 : c.bytes;
        std::string& shown = all.emplace_back(text.substr(0, bytes));
        if (c.bytes == 0 || is_obeyed(c.code)) {
            shown.clear();
            for (const char byte : text.substr(0, bytes)) {
                char escaped[5];
                std::snprintf(escaped, sizeof escaped, "\\x%02X", static_cast<unsigned char>(byte));
                shown += escaped;
            }
        }
        text.remove_prefix(bytes);
    }
    return all;
}

} // namespace

std::string legible(std::string_view text, std::size_t most) {
    constexpr std::string_view dots = "...";
    // Of a text that is far too long the ends are enough: the seam between them is in the middle that is left out.
    std::string ends;
    if (text.size() > 2 * most) text = ends = std::string(text.substr(0, most)).append(text.substr(text.size() - most));
    const std::vector<std::string> all = characters_of(text);
    std::string whole;
    for (const std::string& each : all) whole += each;
    if (whole.size() <= most) return whole;
    const std::size_t room = most - dots.size(), head_room = room - room / 3;
    std::string head, tail;
    for (auto each = all.begin(); head.size() + each->size() <= head_room; ++each) head += *each;
    for (auto each = all.rbegin(); head.size() + tail.size() + each->size() <= room; ++each) tail.insert(0, *each);
    return head.append(dots).append(tail);
}

} // namespace denhartog
