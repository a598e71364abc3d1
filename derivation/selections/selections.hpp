/// @file
/// @brief Whether every form that a selection takes is proved at the place where it takes it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "derivation/claims/claim.hpp"
#include "derivation/selections/placed.hpp"

namespace denhartog::derivation {

using scalar::Placed;

/// @brief Time, frequency ratio and damping ratio at which a selection is asked, exact.
struct Place {
    GiNaC::numeric tau;  ///< non-dimensional time
    GiNaC::numeric R;    ///< modal frequency ratio
    GiNaC::numeric zeta; ///< modal damping ratio
};

/// @brief A shipped selection, and what each of its forms has to be equal to.
struct Selection {
    std::string name;                                                                                ///< the function's name
    std::function<std::vector<Placed>(const Placed& tau, const Placed& R, const Placed& zeta)> take; ///< the function itself
    /// what it stands for, from the paper or the derivation; of zeta it is asked for a symbol below 1, one above 1, 0 and 1
    std::function<std::vector<GiNaC::ex>(const GiNaC::ex& tau, const GiNaC::ex& R, const GiNaC::ex& zeta)> meaning;
};

/// @brief Runs a selection at places on both sides of each of its own conditions, on them and between them, and decides the form
/// that it takes there.
///
/// The form has to be proved equal to its meaning, and nothing that the proof divides by may be zero at the place. Where it is,
/// or where a comparison has found equality, the form is taken again with the place's number for the symbol. A place at which the
/// meaning itself divides by zero is a pole, and asks for nothing.
/// @param selection  the selection
/// @return           proved where that holds at every place; the places, conditions and forms are its steps
[[nodiscard]] Outcome check_selection(const Selection& selection);

} // namespace denhartog::derivation
