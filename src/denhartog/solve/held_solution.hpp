/// @file
/// @brief The answer where the contact rests for ever: the stuck response with its error, and where the contact may rest.
#pragma once

#include "denhartog/solve/solution.hpp"

namespace denhartog {

/// @brief The stuck response with its error.
template <class T>
struct HeldSolution {
    std::vector<SolvedMass<T>> masses; ///< N; the contact's amplitude is zero
    RestInterval<T> rest_interval;     ///< where the contact may rest
    std::optional<T> sticking_by_88;   ///< the boundary of permanent sticking by (88) as printed, for chains
    double relative = 0;               ///< largest error, relative to amplitudes, absolute for phases
};

/// @brief The stuck response in double; its error is bounded by what it leaves over in the equations of motion.
/// @eq{88}
/// @param scene  the scene, with r and beta at or above the boundary of permanent sticking
/// @param stuck  its stuck configuration
/// @param only   the one mass whose errors count; none for all
/// @return       the response for rest at zero
/// @throws       DomainError where the load excites the resonance of an undamped stuck mode
[[nodiscard]] HeldSolution<double> held_solution(const Scene<double>& scene, const StuckConfiguration<double>& stuck,
                                                 std::optional<Mass> only = std::nullopt);

/// @brief The stuck response with errors measured against a wider number type.
/// @eq{88}
/// @param scene  the scene
/// @param wide   the scene in the wider type
/// @param only   as above
/// @return       the response for rest at zero
/// @throws       as above
template <class T, class Wide>
[[nodiscard]] HeldSolution<T> held_solution(const Scene<T>& scene, const Scene<Wide>& wide,
                                            std::optional<Mass> only = std::nullopt);

/// @brief The boundary of permanent sticking by (88) as printed.
/// @eq{88}
/// @param scene  the scene, with r
/// @return       the boundary; none for a system that is no chain, or at a resonance
template <class T>
[[nodiscard]] std::optional<T> sticking_by_88(const Scene<T>& scene);

} // namespace denhartog
