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
    std::vector<MassFromGround> from_ground; ///< N, where base or wall move: the same as it is seen from the ground
    RestInterval rest_interval;              ///< where the contact may rest
    std::optional<Certified> sticking_by_88; ///< the boundary of permanent sticking by (88) as printed, for chains
    double relative = 0;                     ///< largest error, relative to amplitudes, absolute for phases
};

/// @brief The stuck response for rest at zero; what it leaves over in the equations of motion bounds its error. With `only` the errors
/// of one mass count. DomainError where the load excites the resonance of an undamped stuck mode. @eq{88}
[[nodiscard]] HeldSolution held_solution(const Scene<double>& scene, const StuckConfiguration& stuck,
                                         const ModalBasis<Bounded<double>>& basis, std::optional<Mass> only = std::nullopt);

/// @brief The boundary of permanent sticking by (88) as printed; none for a system that is no chain, or at a resonance. @eq{88}
[[nodiscard]] std::optional<Certified> sticking_by_88(const Scene<double>& scene);

} // namespace denhartog
