/// @file
/// @brief What friction demands, as a curve to be searched for its largest value. Included by sources only.
#pragma once

#include <algorithm>

#include "denhartog/evaluation/demand.hpp"
#include "denhartog/number/number.hpp"
#include "denhartog/search/largest_in_double.hpp"
#include "denhartog/sums/friction_motion.hpp"

namespace denhartog {

/// @brief How far the demand may rise between two samples above the larger of them.
///
/// F sin solves y'' + y = Z, so that between two samples it exceeds the sine through them by at most z_bound (cos(tau - m) /
/// cos(h / 2) - 1); over the sine this is at most z_bound tan(h / 2) next to an end of the half-period. In place of the sines and
/// cosines stand the first terms of their series that bound them. The ends are at most 2 apart, and z_bound bounds |Z| between
/// them.
template <class T>
T rise_of_demand(const T& a, const T& b, const T& z_bound) {
    const T half = (b - a) / 2, square = half * half;
    if (!(a > 0) || !(b < pi<T>())) return z_bound * half / (1 - square / 2);
    const T from_end = std::min(a, T(pi<T>() - b));
    return z_bound * square / (2 - square) / (from_end * (1 - from_end * from_end / 6));
}

/// @brief The expression of (57) of one mode, with its limits.
template <class T>
[[nodiscard]] T s_d(const ModeSums<T>& s, std::size_t i, const T& tau) {
    return evaluation::s_d_integrand_of(tau, s.R[i], s.zeta[i], evaluation::DampingFunctions<T>{s.u[i], s.g[i]});
}

/// @brief Some modes, with their weights, as a function of tau to be maximised: F = N / sin, where N = sum weight R^2 (y' + u cos).
///
/// W = N' sin - N cos has the sign of F', and W' = (N'' + N) sin. In Z = N'' + N the cosine drops out, and the equation of free
/// motion of y leaves Z = -sum weight (2 zeta R y'' + (1 - R^2) y') = sum weight R^2 (y''' + y'). With y' made of exp(rho tau) its
/// rate is at most sum weight |c| |rho^2 + 1|, where |rho^2 + 1| R^2 = |1 - R^2 + 2 i zeta R|: little next to resonance, where |c|
/// is large. Without oscillations it is at most sum weight |c| (1 / R^2 + 1).
template <class T>
struct Demand {
    FrictionMotions<T>& y;           ///< of the modes from `first` on, as many as there are weights
    std::size_t first;               ///< the first mode
    const std::vector<T>& weights;   ///< their weights
    const ModeSums<T>& s = y.sums(); ///< modes at a frequency ratio

    /// @brief F, W, Z and the slope of W at an instant in [0, pi].
    [[nodiscard]] Sample<T> operator()(const T& tau) const {
        const FrictionMotionsAt<T>& at = y.at(tau);
        const std::pmr::vector<evaluation::FrictionMotion<T>>& now = at.y;
        const T &C = at.cosine, &S = at.sine;
        T N(0), N_prime(0), Z(0);
        for (std::size_t n = 0; n < weights.size(); ++n) {
            const T& R = s.R[first + n];
            const T& u = s.u[first + n];
            N += weights[n] * R * R * (now[n].prime + u * C);
            N_prime += weights[n] * R * R * (now[n].double_prime - u * S);
            Z -= weights[n] * (2 * s.zeta[first + n] * R * now[n].double_prime + (1 - R) * (1 + R) * now[n].prime);
        }
        if (tau > 0 && tau < pi<T>()) return {N / S, N_prime * S - N * C, Z, Z * S};
        T limit(0);
        for (std::size_t n = 0; n < weights.size(); ++n) limit += weights[n] * s_d(s, first + n, tau);
        return {limit, T(0), Z};
    }

    /// @brief A bound of how fast Z changes from an instant on.
    [[nodiscard]] T rate(const T& a) const {
        const FrictionMotionsAt<T>& now = y.at(a, true);
        T bound(0);
        for (std::size_t n = 0; n < weights.size(); ++n) {
            const T &R = s.R[first + n], &zeta = s.zeta[first + n];
            const T from_resonance = modulus(Complex<T>{(1 - R) / R * ((1 + R) / R), 2 * zeta / R});
            bound += weights[n] * now.size[n] * (zeta < 1 ? from_resonance : T(1 / (R * R) + 1));
        }
        return bound;
    }
};

} // namespace denhartog
