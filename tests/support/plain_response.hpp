/// @file
/// @brief The closed form at one point without bounds, what answers are compared with: in double the library's own, in more digits
/// that of `closed_form.hpp`.
#pragma once

#include <concepts>
#include <limits>
#include <optional>

#include "tests/support/closed_form.hpp"

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

/// @brief A boundary with bounds of what rounding alone does to it, where nothing better is known.
[[nodiscard]] inline Boundary<Bounded<double>> with_rounding(const Boundary<double>& boundary) {
    const double few = 16 * std::numeric_limits<double>::epsilon();
    Boundary<Bounded<double>> b{};
    b.exact = {boundary.exact, few * boundary.exact};
    if (boundary.sticking) b.sticking = Bounded<double>(*boundary.sticking, few * *boundary.sticking);
    b.binding = boundary.binding;
    return b;
}

/// @brief The response at the point of a scene, as the number type rounds it.
/// @eq{38,39,44,45,47,52,53,69}
/// @throws       InputError where the scene breaks a rule or has no r; DomainError at a pole of a mode without damping
template <class T>
[[nodiscard]] Response<T> response(const Scene<T>& scene, std::optional<Mass> only = std::nullopt) {
    check(scene);
    if (!scene.r) throw InputError("r", "must be given", "");
    const ModeSums<T> sums = mode_sums(modal_basis(scene.system), contact_row(scene.system), load_rows(scene.system), *scene.r);
    Response<T> all{*scene.r, scene.mu, scene.beta, scene.system.contact, boundary(sums, scene.mu), std::nullopt, std::nullopt};
    if (!scene.beta) return all;
    if constexpr (std::same_as<T, double>)
        all.regime = regime_at(with_rounding(all.boundary), *scene.beta);
    else
        all.regime = RegimeAtPoint{regime_of(all.boundary, *scene.beta), {}, false, {}};
    if (all.regime->regime == Regime::continuous) all.steady_state = steady_state(sums, all.boundary, *scene.beta, only);
    return all;
}

} // namespace denhartog
