/// @file
/// @brief The regime of the steady state at one point (r, beta), with the reason.
#pragma once

#include "denhartog/number/bounded.hpp"
#include "denhartog/sliding/boundary.hpp"
#include "denhartog/sliding/regime_at_point.hpp"

namespace denhartog {

/// @brief Accuracy of the two friction ratios that part the regimes; zero if one is known exactly.
struct BoundaryError {
    double exact;    ///< absolute error of `Boundary::exact`
    double sticking; ///< absolute error of `Boundary::sticking`
};

/// @brief The regime at a friction ratio and nothing else: what a map asks for at every point. @eq{54,69}
template <class T>
[[nodiscard]] Regime regime_of(const RegimeBoundary<T>& boundary, const T& beta) {
    if (beta < boundary.exact) return Regime::continuous;
    return boundary.sticking && beta >= *boundary.sticking ? Regime::permanent_sticking : Regime::stick_slip;
}

/// @brief Whether a friction ratio is a boundary between two regimes, to the accuracy of the boundary.
[[nodiscard]] bool on_boundary(const RegimeBoundary<double>& boundary, double beta, const BoundaryError& error);

/// @brief The regime at a friction ratio: sliding below (69), permanent sticking from `sticking` on, stick-slip between.
///
/// With mu > 1 the sliding regime can reach beyond `sticking`: the contact then slides if it is moving, and rests if it rests.
/// @eq{54,69}
[[nodiscard]] RegimeAtPoint regime_at(const Boundary<double>& boundary, double beta, const BoundaryError& error);

/// @brief Regime at a point, from a boundary with bounds of its errors. @eq{54,69}
[[nodiscard]] RegimeAtPoint regime_at(const Boundary<Bounded<double>>& boundary, double beta);

} // namespace denhartog
