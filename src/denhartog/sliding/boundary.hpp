/// @file
/// @brief The boundary of the sliding regime at one frequency ratio, four ways: (56), (57), (67), (69), and permanent sticking (88);
/// the regime of the steady state at one point (r, beta), with the reason.
#pragma once

#include <optional>
#include <vector>

#include "denhartog/evaluation/demand.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/sliding/mode_sums.hpp"
#include "denhartog/sliding/regime_at_point.hpp"

namespace denhartog {

/// @brief The two friction ratios that part the regimes at one frequency ratio.
template <class T>
struct RegimeBoundary {
    T exact;                   ///< (69) with the maximum over tau of the sum over modes
    std::optional<T> sticking; ///< the smallest beta at which the contact never moves; none if no friction can hold it
};

/// @brief The friction ratios that bound the regimes at one frequency ratio.
template <class T>
struct Boundary : RegimeBoundary<T> {
    T paper;                  ///< (69) with (56): the sum of the maxima of the modes; never larger than `exact`
    T approximate;            ///< (67), with (72) in place of S_dj; never smaller than `exact`
    T S_exact;                ///< maximum over tau of the sum over modes
    T S_paper;                ///< S_dj, Eq. (56)
    T instant;                ///< where the sum is largest; 0 stands for the limit
    std::vector<T> instants;  ///< where the expression (57) of each mode is largest, N values
    BindingCondition binding; ///< the condition that ends the sliding regime first
};

/// @brief The expression of (57) of one mode at an instant, the limits at 0 and pi included. @eq{57,71}
template <class T>
[[nodiscard]] T s_d_of_mode(const ModeSums<T>& s, std::size_t i, const T& tau) {
    return evaluation::s_d_integrand_of(tau, s.R[i], s.zeta[i], evaluation::DampingFunctions<T>{s.u[i], s.g[i]});
}

/// @brief Sum over the modes of (57)'s expression at an instant, the limits at 0 and pi included. @eq{56,57,71}
template <class T>
[[nodiscard]] T sliding_demand(const ModeSums<T>& sums, const T& tau);

/// @brief (69) and (88) with S, the largest `sliding_demand`, known.
///
/// The contact can rest if a force f of at most mu beta makes its displacement zero: \f$ V_{dj} - f Y_{jj} = 0 \f$, hence
/// `sticking` \f$ = |V_{dj}/Y_{jj}|/\mu \f$, which is \f$ 1/\mu \f$ if the load acts on the contact. Both are zero if the load does
/// not reach the contact. InputError if mu is below 1 or not finite. @eq{54,58,69,88}
template <class T>
[[nodiscard]] RegimeBoundary<T> regime_boundary_at(const ModeSums<T>& sums, const T& mu, const T& S);

/// @brief The boundary if the instants of the maxima are known: `instant` is that of the sum, where 0 stands for the limit, and
/// `instants` are those of each mode. If damping couples the modes, (56) has no modes to sum over, and `paper` is `exact`.
/// @eq{54,56,57,58,67,69,71,72}
template <class T>
[[nodiscard]] Boundary<T> boundary_at(const ModeSums<T>& sums, const T& mu, const T& instant, std::vector<T> instants);

/// @brief The boundary, with both maxima guaranteed by `global_maximum`. @eq{54,56,57,58,67,69,71,72}
[[nodiscard]] Boundary<double> boundary(const ModeSums<double>& sums, double mu);

/// @brief The regime at a friction ratio and nothing else: what a map asks for at every point. @eq{54,69,88}
template <class T>
[[nodiscard]] Regime regime_of(const RegimeBoundary<T>& boundary, const T& beta) {
    if (beta < boundary.exact) return Regime::continuous;
    return boundary.sticking && beta >= *boundary.sticking ? Regime::permanent_sticking : Regime::stick_slip;
}

/// @brief The regime at a friction ratio: sliding below (69), permanent sticking from `sticking` on, stick-slip between. A ratio that
/// differs from one of them by less than the error of that is said to be on it.
///
/// With mu > 1 the sliding regime can reach beyond `sticking`: the contact then slides if it is moving, and rests if it rests.
/// @eq{54,69,88}
[[nodiscard]] RegimeAtPoint regime_at(const Boundary<Bounded<double>>& boundary, double beta);

} // namespace denhartog
