/// @file
/// @brief The answer where the contact rests for ever: the stuck response with its error, and where the contact may rest.
#pragma once

#include <optional>
#include <vector>

#include "denhartog/answer/solution.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/model/stuck_configuration.hpp"
#include "denhartog/number/bounded.hpp"

namespace denhartog {

/// @brief The stuck response with its error.
struct HeldSolution {
    std::vector<SolvedMass> masses;          ///< N; the contact's amplitude is zero
    RestInterval rest_interval;              ///< where the contact may rest
    std::optional<Certified> sticking_by_88; ///< the boundary of permanent sticking by (88) as printed, for chains
    double relative = 0;                     ///< largest error, relative to amplitudes, absolute for phases
};

/// @brief The stuck response; its error is bounded by what it leaves over in the equations of motion.
/// @eq{88}
/// @param scene   the scene, with r and beta at or above the boundary of permanent sticking
/// @param stuck   its stuck configuration
/// @param basis   its modes with the bounds of their errors: damping ratios mean the damping matrix that these make
/// @param only    the one mass whose errors count; none for all
/// @return        the response for rest at zero
/// @throws        DomainError where the load excites the resonance of an undamped stuck mode
[[nodiscard]] HeldSolution held_solution(const Scene<double>& scene, const StuckConfiguration<double>& stuck,
                                         const ModalBasis<Bounded<double>>& basis, std::optional<Mass> only = std::nullopt);

/// @brief The boundary of permanent sticking by (88) as printed, with a bound of its error.
/// @eq{88}
/// @param scene   the scene, with r
/// @return        the boundary; none for a system that is no chain, or at a resonance
[[nodiscard]] std::optional<Certified> sticking_by_88(const Scene<double>& scene);

} // namespace denhartog
