/// @file
/// @brief The formulas that a page offers for copying and for a reader's own number: the library's, written down by themselves.
#pragma once

#include <string>
#include <vector>

#include "derivation/offers/written.hpp"

namespace denhartog::offers {

/// @brief A formula of an equation.
struct OfferedFormula {
    std::string equation;   ///< its number
    std::string what;       ///< LaTeX of what it computes
    WrittenFormula holds;   ///< the library's function
    WrittenFormula printed; ///< as printed, where that is refuted; no results where it is not
};

/// @brief All formulas that are offered, in the paper's order. @return the formulas
[[nodiscard]] const std::vector<OfferedFormula>& offered_formulas();

} // namespace denhartog::offers
