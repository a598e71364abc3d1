/// @file
/// @brief For each printed equation that does not hold, a scene of an actual system in which somebody sees it.
///
/// A point that refutes in symbols need be no system: u and g of a mode do not go with its R and zeta there. The scenes here are
/// the paper's own or chains with ordinary numbers, and are solved; what the equation gives is compared with what holds.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "derivation/observations/sliding_scenes.hpp"

namespace denhartog::derivation {

/// @brief The values of an equation in a scene, as printed and as it holds.
struct Compared {
    std::string quantity; ///< what is compared, with its unit
    double printed = 0;   ///< as printed
    double holds = 0;     ///< by the shipped formula
    double size = 0;      ///< what the difference is measured by
};

/// @brief A scene for an equation.
struct RefutationScene {
    std::string equation;                                  ///< the number of the equation
    std::string where;                                     ///< which system it is, in words
    System<double> system;                                 ///< the system
    double mu;                                             ///< static over kinetic friction, Eq. (3)
    double r;                                              ///< frequency ratio, Eq. (10)
    double beta;                                           ///< friction ratio, Eq. (11)
    bool slides;                                           ///< whether the contact is to slide throughout
    std::function<Compared(const SlidingScene&)> compared; ///< the comparison; without a state where the contact does not slide
};

/// @brief The scenes for motions and initial values, (40)-(52) and the Appendix. @return one an equation
[[nodiscard]] std::vector<RefutationScene> scenes_of_motions();

/// @brief The scenes for the boundaries of the regimes and the resonances, (56)-(88). @return one an equation
[[nodiscard]] std::vector<RefutationScene> scenes_of_boundaries();

/// @brief Solves a scene and compares.
/// @param scene  the scene
/// @return       `where`, `scene` as users write it, `regime`, `quantity`, `printed`, `holds`, and `loss`, the difference over
///               the size
/// @throws       std::logic_error where the scene is not in the regime that it is said to be in
[[nodiscard]] nlohmann::json solved(const RefutationScene& scene);

/// @brief All scenes, and the reasons where there can be none.
/// @return  an object by the number of the equation: what `solved` gives, or `none`, the reason
[[nodiscard]] nlohmann::json scenes_of_refutations();

} // namespace denhartog::derivation
