/// @file
/// @brief The formulas that a page offers for copying and for a reader's own number: the library's, written down by themselves.
#pragma once

#include <string>
#include <vector>

#include "derivation/offers/written.hpp"

namespace denhartog::offers {

/// @brief A formula of an equation, as a function of its arguments.
struct OfferedFormula {
    std::string equation;               ///< its number
    std::string what;                   ///< LaTeX of what it computes
    std::string name;                   ///< of the function
    std::vector<std::string> arguments; ///< their names, in order
    std::vector<std::string> of_modes;  ///< those of them that have a value a mode
    std::vector<Written> results;       ///< the library's, one, or real and imaginary part
    std::vector<Written> printed;       ///< as printed, where that is refuted; none where it is not
};

/// @brief All formulas that are offered, in the paper's order. @return the formulas
[[nodiscard]] const std::vector<OfferedFormula>& offered_formulas();

} // namespace denhartog::offers
