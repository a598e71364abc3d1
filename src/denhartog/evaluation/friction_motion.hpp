/// @file
/// @brief Forms of the braces of (40), the motion of a mode under friction alone, that keep their digits.
///
/// At large R the braces are of the size of \f$ 1/R^2 \f$, and d is 1 less as little: \f$ 1-d \f$ is formed without the
/// difference. With \f$ m = 1-e^{-\zeta x} \f$ and the half angle, one function each, it is a sum of two positive terms less
/// \f$ \zeta q \f$. Where \f$ x < 2\zeta \f$ these cancel in turn, and the series of (29) at large R takes the place of their
/// difference: then all terms are positive. What is left to cancel between \f$ 1-d \f$, \f$ g\,d \f$ and \f$ u R q \f$, next to
/// the zeros of the braces, is no more than the last place of \f$ \tau \f$ makes of them. The forms of \f$ 1-d \f$ are
/// branch-free and proved; only the selection compares numbers.
///
/// R is the modal frequency ratio (22), zeta the modal damping ratio, x = tau/R, w = sqrt(1-zeta^2) or 0, q and d are (A.8), and
/// u, g are (28), (29).
#pragma once

#include <type_traits>

#include "denhartog/evaluation/mode.hpp"

namespace denhartog::evaluation {

/// @brief \f$ 1-d \f$ from \f$ m = 1-e^{-\zeta x} \f$, the half angle and q.
/// \f[ 1-d = m + 2(1-m)\sin^2\frac{wx}{2} - \zeta q \f]
/// @eq{A.8}  @derivation{forms/evaluation_of_motion}  @domain{x >= 0, 0 <= zeta < 1; keeps its digits for x of 2 zeta and more}
template <class T>
[[nodiscard]] T one_minus_d_half_angle(const T& x, const T& zeta, const T& w, const T& q) {
    const T m = -exp_minus_one(T(-zeta * x));
    const T s = sin(T(w * x / 2));
    return m + 2 * (1 - m) * s * s - zeta * q;
}

/// @brief \f$ 1-d \f$ as a sum of positive terms.
/// \f[ 1-d = \frac{m^2}{2} + (1-m)\left[2\sin^2\frac{wx}{2} + \zeta x\left(\frac{\sinh\zeta x}{\zeta x} - \frac{\sin wx}{wx}
///     \right)\right] \f]
/// @eq{A.8}  @derivation{forms/evaluation_of_motion}  @domain{x >= 0, 0 <= zeta < 1; keeps its digits for x up to 2}
template <class T>
[[nodiscard]] T one_minus_d_of_positive_terms(const T& x, const T& zeta, const T& w) {
    const T m = -exp_minus_one(T(-zeta * x));
    const T s = sin(T(w * x / 2));
    return m * m / 2 + (1 - m) * (2 * s * s + zeta * x * sinhc_less_sinc_over_square(x, zeta) * x * x);
}

/// @brief The braces of (40) for \f$ \zeta \ge 1 \f$, from both rates a and \f$ b = \zeta+w_1 \f$.
/// \f[ 1-d = \tfrac12(1-e^{-ax})(1-e^{-bx}) + e^{-\zeta x}\zeta x\left(\frac{\sinh\zeta x}{\zeta x} - \frac{\sinh w_1x}{w_1x}
///     \right) \f]
/// @eq{A.8}  @derivation{forms/overdamped_modes}  @domain{x >= 0, zeta >= 1; keeps its digits for zeta x up to 4}
template <class T>
[[nodiscard]] T overdamped_one_minus_d_of_positive_terms(const T& x, const T& zeta) {
    const T slow = exp_minus_one(T(-slow_rate(zeta) * x)), fast = exp_minus_one(T(-(zeta + overdamped_w(zeta)) * x));
    return slow * fast / 2 + exp(T(-zeta * x)) * sinhc_less_sinhc_over_square(x, zeta) * (zeta * x) * x * x;
}

/// @brief \f$ 1-d = (1-e^{-ax}) - q/b \f$ for \f$ \zeta \ge 1 \f$.
/// @eq{A.8}  @derivation{forms/overdamped_modes}  @domain{x >= 0, zeta >= 1; keeps its digits for zeta x of 2 and more}
template <class T>
[[nodiscard]] T overdamped_one_minus_d_of_slow_rate(const T& x, const T& zeta, const T& q) {
    return -exp_minus_one(T(-slow_rate(zeta) * x)) - q / (zeta + overdamped_w(zeta));
}

/// @brief The braces of (40) with their derivatives from the free motions.
/// @eq{40,A.8,A.9}  @derivation{forms/evaluation_forms}  @domain{R > 0, zeta >= 0}
template <class T>
[[nodiscard]] FrictionMotion<T> friction_motion_of(const FreeMotion<T>& free, const T& one_minus_d, const T& R, const T& u,
                                                   const T& g) {
    return {one_minus_d - g * free.d - u * R * free.q, -((1 + g) * free.d_prime) - u * (R * free.q_prime),
            (1 + g) * (free.q_prime / R) - u * (R * free.q_double_prime)};
}

/// @brief \f$ 1-d \f$: the form that keeps its digits at this place.
/// @eq{A.8}  @derivation{forms/evaluation_of_motion}  @domain{x >= 0, zeta >= 0}
template <class T>
[[nodiscard]] T one_minus_d(const T& x, const T& zeta, const T& w, const T& q) {
    if (zeta >= 1)
        return zeta * x < 2 ? overdamped_one_minus_d_of_positive_terms(x, zeta) : overdamped_one_minus_d_of_slow_rate(x, zeta, q);
    return x < 2 * zeta ? one_minus_d_of_positive_terms(x, zeta, w) : one_minus_d_half_angle(x, zeta, w, q);
}

/// @brief The braces of (40) with their first two derivatives: the forms that keep their digits at this place, float in double.
/// @eq{40,A.8,A.9}  @derivation{forms/evaluation_forms}  @domain{0 <= tau <= pi, R > 0, zeta >= 0}
template <class T>
[[nodiscard]] FrictionMotion<T> friction_motion(const T& tau, const T& R, const T& zeta, const T& w, const T& u, const T& g) {
    if constexpr (std::is_same_v<T, float>) {
        const FrictionMotion<double> f = friction_motion<double>(tau, R, zeta, w_if_oscillating<double>(zeta), u, g);
        return {static_cast<T>(f.value), static_cast<T>(f.prime), static_cast<T>(f.double_prime)};
    } else {
        const FreeMotion<T> free = free_motion(tau, R, zeta, w);
        return friction_motion_of(free, one_minus_d(T(tau / R), zeta, w, free.q), R, u, g);
    }
}

} // namespace denhartog::evaluation
