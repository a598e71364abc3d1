/// @file
/// @brief The boundary of the sliding regime at one frequency ratio, four ways: (56), (57), (67), (69), and permanent sticking.
#pragma once

#include <optional>
#include <vector>

#include "denhartog/evaluation/demand.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/number/work_counted.hpp"
#include "denhartog/sliding/regime_at_point.hpp"
#include "denhartog/sums/friction_motion.hpp"
#include "denhartog/sums/mode_sums.hpp"

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

/// @brief The boundary at a frequency ratio, with both maxima guaranteed by `global_maximum`.
///
/// The contact can rest if a force f of at most mu beta makes its displacement zero: \f$ V_{dj} - f Y_{jj} = 0 \f$, hence
/// `sticking` \f$ = |V_{dj}/Y_{jj}|/\mu \f$, which is \f$ 1/\mu \f$ if the load acts on the contact. All four boundaries are zero
/// if the load does not reach the contact: V_dj is then below the rounding errors of its own terms. If damping couples the modes,
/// (56) has no modes to sum over, and `paper` is `exact`. InputError if mu is below 1 or not finite.
/// @eq{54,56,57,58,67,69,71,72}
[[nodiscard]] Boundary<double> boundary(const ModeSums<double>& sums, double mu);

/// @brief The two friction ratios alone, which is what a map asks for: the maxima of the modes by themselves are not sought, and
/// the maximum of their sum only if `largest_at_start` does not decide it. The numbers are those of `boundary`, with bounds of
/// their errors; PrecisionError if the maximum is not settled. @eq{54,57,58,67,69,71,72}
[[nodiscard]] RegimeBoundary<Bounded<double>> regime_boundary(const ModeSums<Bounded<double>>& sums, const Bounded<double>& mu);

/// @brief Whether (57) of every mode is certain to be largest for tau -> 0, by `evaluation::excess_at_the_end`: so is the sum.
/// False says nothing. @eq{57,71}
template <class T>
[[nodiscard]] bool largest_at_start(const ModeSums<T>& sums);

/// @brief The instant in [0, pi] of the largest sum of (57)'s expression over the modes, by `global_maximum`; 0 stands for
/// the limit. The search has its share of `effort`. PrecisionError if the maximum is not settled. @eq{56,57}
[[nodiscard]] double instant_of_largest_demand(const ModeSums<double>& sums, Effort* effort = nullptr);

/// @brief Number of searches for the largest demand since the program started; tests gate on it.
[[nodiscard]] inline long demand_searches() { return work_counted.demand_searches; }

/// @brief The boundary, in double or with bounds of its errors, if the instants of the maxima are known. `instant` is that of
/// the sum, where 0 stands for the limit, and `instants` are those of each mode.
template <class T>
[[nodiscard]] Boundary<T> boundary_at(const ModeSums<T>& sums, const T& mu, const T& instant, std::vector<T> instants);

/// @brief The expression of (57) of one mode at an instant, the limits at 0 and pi included. @eq{57,71}
template <class T>
[[nodiscard]] T s_d_of_mode(const ModeSums<T>& s, std::size_t i, const T& tau) {
    return evaluation::s_d_integrand_of(tau, s.R[i], s.zeta[i], evaluation::DampingFunctions<T>{s.u[i], s.g[i]});
}

/// @brief Sum over the modes of (57)'s expression at an instant, the limits at 0 and pi included. @eq{56,57,71}
template <class T>
[[nodiscard]] T sliding_demand(const ModeSums<T>& sums, const T& tau);

/// @brief N + 1 instants in [0, pi]: where the sum over the modes of (57)'s expression is largest, and where that of each mode
/// is; 0 stands for the limit. What `y` remembers serves the next search. PrecisionError if a maximum is not settled.
/// @eq{56,57}
[[nodiscard]] std::vector<double> instants_of_demands(FrictionMotions& y);

} // namespace denhartog
