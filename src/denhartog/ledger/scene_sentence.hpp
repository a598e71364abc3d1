/// @file
/// @brief What a scene shows of a printed equation, in a sentence.
#pragma once

#include <string>

#include "denhartog/number/number_text.hpp"

namespace denhartog::ledger {

/// @brief What a scene shows: system, point, quantity, both values and the loss.
/// @param scene  `where`, `regime`, `quantity`, `printed`, `holds`, `loss`
/// @return       the sentence without its full stop
template <class Json>
[[nodiscard]] std::string scene_sentence(const Json& scene) {
    const auto text = [&scene](const char* key) { return scene.at(key).template get<std::string>(); };
    const auto number = [&scene](const char* key) { return number_in_digits(scene.at(key).template get<double>(), 4); };
    std::string regime = text("regime");
    for (char& c : regime) c = c == '_' ? ' ' : c;
    return text("where") + " (" + regime + " motion): " + text("quantity") + ", " + number("printed") + " as printed, " +
           number("holds") + " as it is, a loss of " + number("loss");
}

} // namespace denhartog::ledger
