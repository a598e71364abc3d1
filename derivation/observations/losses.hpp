/// @file
/// @brief The loss by an equation as printed: the worst relative error on the grid of the sliding scenes, and for the
///        boundary (69) the worst that a search over the frequency ratio finds.
#pragma once

#include <optional>
#include <string>

namespace denhartog::derivation {

/// @brief The loss of one printed equation.
struct Loss {
    std::string quantity;    ///< which quantity comes out wrong, and relative to what
    double on_paper = 0;     ///< worst error on the grid of the paper's own scenes
    std::string paper_scene; ///< where
    double on_others = 0;    ///< worst error over the asymmetric scenes
    std::string other_scene; ///< where
    long scenes = 0;         ///< how many scenes were computed
    long without_value = 0;  ///< in how many the printed form has no real value
    double searched = 0;    ///< worst error over all frequency ratios of the paper's systems; 0 where only the grid was looked at
    std::string place = {}; ///< where
    /// @return the worst error known for the paper's systems
    [[nodiscard]] double worst() const { return searched > on_paper ? searched : on_paper; }
};

/// @brief The loss of an equation.
/// @param equation  its number
/// @return          the loss; none where a coded print has no such number, as for slips of the scan in a definition
[[nodiscard]] std::optional<Loss> loss_of(const std::string& equation);

/// @brief The loss in a sentence. @param loss a loss @return the sentence
[[nodiscard]] std::string sentence(const Loss& loss);

} // namespace denhartog::derivation
