/// @file
/// @brief The response at one point (r, beta): boundary, regime and, where the contact slides throughout, the steady state.
#pragma once

#include <optional>

#include "denhartog/sliding/regime.hpp"
#include "denhartog/sliding/steady_state.hpp"

namespace denhartog {

/// @brief What is known of the steady state at one point.
template <class T>
struct Response {
    T r;                                        ///< frequency ratio, Eq. (10)
    T mu;                                       ///< static over kinetic friction, Eq. (3)
    std::optional<T> beta;                      ///< friction ratio, Eq. (11); none where only the boundary was asked for
    Mass contact;                               ///< the mass in contact, j
    Boundary<T> boundary;                       ///< the boundary at r
    std::optional<RegimeAtPoint> regime;        ///< the regime at beta
    std::optional<SteadyState<T>> steady_state; ///< the steady state, in the sliding regime only
};

/// @brief The response at the point of a scene.
/// @eq{38,39,44,45,47,52,53,69}
/// @param scene  the scene, with r; without beta the boundary alone is computed
/// @param only   the one mass whose maximum is wanted besides that of the contact; none for all
/// @return       the response; displacements in units of P / k_1
/// @throws       InputError where the scene breaks a rule or has no r; DomainError at a pole of a mode without damping
template <class T>
[[nodiscard]] Response<T> response(const Scene<T>& scene, std::optional<Mass> only = std::nullopt);

/// @brief The response at the point of a scene with the instants of its maxima known: what a check in more digits costs.
/// @param scene  the scene
/// @param known  the response in another number type, instants converted
/// @param only   as above
/// @return       the response; no steady state where either boundary puts beta outside the sliding regime
template <class T>
[[nodiscard]] Response<T> response_at(const Scene<T>& scene, const Response<T>& known, std::optional<Mass> only = std::nullopt);

} // namespace denhartog
