/// @file
/// @brief What somebody loses who codes an equation as printed: the worst relative error over the sliding scenes.
#pragma once

#include <optional>
#include <string>

namespace denhartog::derivation {

/// @brief The loss of one printed equation.
struct Loss {
    std::string quantity;    ///< which quantity comes out wrong, and relative to what
    double on_paper = 0;     ///< worst error over the paper's own scenes
    std::string paper_scene; ///< where
    double on_others = 0;    ///< worst error over the asymmetric scenes
    std::string other_scene; ///< where
    long scenes = 0;         ///< how many scenes were computed
    long without_value = 0;  ///< in how many the printed form has no real value
};

/// @brief The loss of an equation.
/// @param equation  its number
/// @return          the loss; none where a coded print has no such number, as for slips of the scan in a definition
[[nodiscard]] std::optional<Loss> loss_of(const std::string& equation);

/// @brief The loss in a sentence. @param loss a loss @return the sentence
[[nodiscard]] std::string sentence(const Loss& loss);

} // namespace denhartog::derivation
