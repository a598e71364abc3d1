/// @file
/// @brief The scenes in which somebody sees that a printed equation does not hold, brought into the ledger.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace denhartog::derivation {

/// @brief The least loss that somebody would see who compares with the right formula: a hundredth.
constexpr double visible_loss = 0.01;

/// @brief Writes into each entry of the ledger its `scene`: an object, empty where the printed form is not refuted.
/// @param entries  the ledger
/// @param scenes   by the number of the equation: `where`, `scene`, `regime`, `quantity`, `printed`, `holds`, `loss`; or `none`,
///                 the reason why no scene shows it
/// @return         a sentence for each refuted or illegible equation with neither, for each scene with a loss below
///                 `visible_loss`, and for each scene of an equation that stands
[[nodiscard]] std::vector<std::string> add_scenes(nlohmann::json& entries, const nlohmann::json& scenes);

/// @brief A scene in a sentence, or why there is none. @param scene an entry's `scene`, not empty @return Markdown
[[nodiscard]] std::string scene_markdown(const nlohmann::json& scene);

} // namespace denhartog::derivation
