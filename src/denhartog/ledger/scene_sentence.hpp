/// @file
/// @brief What a scene shows of a printed equation, in a sentence.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace denhartog::ledger {

/// @brief A number in four digits. @param x the number @return its text
[[nodiscard]] inline std::string in_four_digits(double x) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", x);
    return text.data();
}

/// @brief What a scene shows: system, point, quantity, both values and the loss.
/// @param scene  `where`, `regime`, `quantity`, `printed`, `holds`, `loss`
/// @return       the sentence without its full stop
template <class Json>
[[nodiscard]] std::string scene_sentence(const Json& scene) {
    const auto text = [&scene](const char* key) { return scene.at(key).template get<std::string>(); };
    const auto number = [&scene](const char* key) { return in_four_digits(scene.at(key).template get<double>()); };
    std::string regime = text("regime");
    for (char& c : regime) c = c == '_' ? ' ' : c;
    return text("where") + " (" + regime + " motion): " + text("quantity") + ", " + number("printed") + " as printed, " +
           number("holds") + " as it is, a loss of " + number("loss");
}

} // namespace denhartog::ledger
