/// @file
/// @brief Modes with \f$ \zeta \ge 1 \f$, which the paper leaves out: (23), (28), (29), (40), (A.8), (A.9) of such a mode.
///
/// In \f$ w^2 = 1-\zeta^2 \f$ the cosine \f$ C = \cos wx \f$ and the sine over w, \f$ S = \sin(wx)/w \f$, are entire, so that
/// the paper's formulas hold for every damping ratio once they are written in them. Only \f$ e^{-\zeta x}C \f$ and
/// \f$ e^{-\zeta x}S \f$ are formed. Up to \f$ w_1x = 1 \f$, \f$ w_1 = \sqrt{\zeta^2-1} \f$, they come from series in its
/// square, which make no exception of \f$ \zeta = 1 \f$; beyond from the decaying exponentials \f$ e^{-ax} \f$ and
/// \f$ e^{-x/a} \f$, \f$ a = \zeta - w_1 \f$. Every form is branch-free and proved in `derivation/forms/overdamped_modes.cpp`, from
/// the equation of motion of the mode and the conditions at \f$ \tau = \pi \f$; `damping_functions_of_free_motion` is the
/// paper's formula below \f$ \zeta = 1 \f$ too. Only the selections, at the end, compare numbers.
///
/// R is the modal frequency ratio (22), zeta the modal damping ratio, x = tau/R, and h the parts at the end of the half-period.
#pragma once

#include "denhartog/evaluation/detail/entire_functions.hpp"
#include "denhartog/evaluation/mode_values.hpp"

namespace denhartog::evaluation {

/// @brief \f$ v_{di} \f$ in \f$ p = 1/R \f$ where \f$ A = (p-1)(p+1) \f$ is larger than \f$ B = 2\zeta p \f$.
/// \f[ \mathrm{Re}\{v\} = \frac{p^2}{A + B\,(B/A)}, \qquad \mathrm{Im}\{v\} = -\frac{B}{A}\,\mathrm{Re}\{v\} \f]
/// @eq{23}  @derivation{forms/overdamped_modes}  @domain{R > 0, zeta >= 0, R not 1; keeps its digits for R of 2 and more}
template <class T>
[[nodiscard]] Complex<T> complex_response_above_resonance(const T& R, const T& zeta) {
    const T p = 1 / R;
    const T A = (p - 1) * (p + 1);
    const T quotient = 2 * zeta * p / A;
    const T re = p / (A + 2 * zeta * p * quotient) * p;
    return {re, -(quotient * re)};
}

/// @brief The response function (23), for B larger than A.
/// \f[ \mathrm{Im}\{v\} = -\frac{p^2}{B + A\,(A/B)}, \qquad \mathrm{Re}\{v\} = -\frac{A}{B}\,\mathrm{Im}\{v\} \f]
/// @eq{23}  @derivation{forms/overdamped_modes}  @domain{R > 0, zeta > 0; keeps its digits for R of 2 and more}
template <class T>
[[nodiscard]] Complex<T> complex_response_of_heavy_damping(const T& R, const T& zeta) {
    const T p = 1 / R;
    const T A = (p - 1) * (p + 1);
    const T quotient = A / (2 * zeta * p);
    const T size = p / (2 * zeta * p + A * quotient);
    return {quotient * size * p, -(size * p)};
}

/// @brief Free motions next to \f$ \zeta = 1 \f$, from the series of C and S in \f$ w^2x^2 \f$: \f$ d = C + \zeta S \f$,
/// \f$ q = S \f$, \f$ dq/dx = C - \zeta S \f$, \f$ d^2q/dx^2 = \zeta^2S + (\zeta^2-1)S - 2\zeta C \f$.
/// @eq{A.8,A.9}  @derivation{forms/overdamped_modes}  @domain{x >= 0, zeta >= 1; keeps its digits up to w_1 x = 1}
template <class T>
[[nodiscard]] FreeMotion<T> free_motion_near_critical(const T& x, const T& zeta) {
    const T E = exp(T(-zeta * x));
    const T C = E * overdamped_cosine(zeta, x);
    const T S = E * x * overdamped_sinc(zeta, x);
    return {C + zeta * S, S, -S, C - zeta * S, zeta * (zeta * S) + (zeta - 1) * ((zeta + 1) * S) - 2 * zeta * C};
}

/// @brief Free motions from two decaying exponentials, with \f$ a = \zeta-w_1 \f$ and \f$ q = e^{-ax}(1-e^{-2w_1x})/(2w_1) \f$.
/// \f[ d = e^{-ax} + aq, \qquad \frac{dq}{dx} = e^{-x/a} - aq, \qquad \frac{d^2q}{dx^2} = a^2q - 2\zeta e^{-x/a} \f]
/// @eq{A.8,A.9}  @derivation{forms/overdamped_modes}  @domain{x >= 0, zeta > 1; keeps its digits for w_1 x of 1 and more}
template <class T>
[[nodiscard]] FreeMotion<T> free_motion_of_two_rates(const T& x, const T& zeta) {
    const T a = slow_rate(zeta);
    const T slow = exp(T(-a * x));
    const T root_of_fast = exp(T(-(zeta + overdamped_w(zeta)) * x / 2));
    const T q = slow * overdamped_difference(zeta, x);
    return {slow + a * q, q, -q, root_of_fast * root_of_fast - a * q, a * a * q - 2 * zeta * root_of_fast * root_of_fast};
}

/// @brief The rates in \f$ \tau = R_ix \f$ in place of those in x.
/// @eq{A.9}  @derivation{forms/overdamped_modes}  @domain{R > 0}
/// @return the free motions, their rates those in tau
template <class T>
[[nodiscard]] FreeMotion<T> with_rates_in_tau(const FreeMotion<T>& free, const T& R) {
    return {free.d, free.q, free.d_prime / R, free.q_prime / R, free.q_double_prime / R / R};
}

/// @brief Parts of (28) and (29): \f$ S = \rho^2K \f$ and \f$ \Sigma = 1 + 2C + e^{-2\delta} \f$ at \f$ x = \pi/R \f$.
template <class T>
struct HalfPeriodDecay {
    T root; ///< rho, the root of an exponential that decays
    T K;    ///< S over rho^2
    T sum;  ///< 1 + 2 C + exp(-2 delta)
};

/// @brief \f$ \rho = e^{-\delta/2} \f$, and C, S by their series.
/// @eq{28,29}  @derivation{forms/overdamped_modes}  @domain{R > 0, zeta >= 1; keeps its digits up to pi w_1 / R = 1}
template <class T>
[[nodiscard]] HalfPeriodDecay<T> half_period_near_critical(const T& R, const T& zeta) {
    const T x = pi<T>() / R;
    const T root = exp(T(-zeta * x / 2));
    const T E = root * root;
    return {root, x * overdamped_sinc(zeta, x), 1 + 2 * E * overdamped_cosine(zeta, x) + E * E};
}

/// @brief \f$ \rho = e^{-\pi a/(2R)} \f$, and \f$ \Sigma = (1+e^{-\pi a/R})(1+e^{-\pi/(aR)}) \f$.
/// @eq{28,29}  @derivation{forms/overdamped_modes}  @domain{R > 0, zeta > 1; keeps its digits for pi w_1 / R of 1 and more}
template <class T>
[[nodiscard]] HalfPeriodDecay<T> half_period_of_two_rates(const T& R, const T& zeta) {
    const T x = pi<T>() / R;
    const T root = exp(T(-slow_rate(zeta) * x / 2));
    const T fast = exp(T(-(zeta + overdamped_w(zeta)) * x));
    return {root, overdamped_difference(zeta, x), (1 + root * root) * (1 + fast)};
}

/// @brief \f$ u_{di} = 2S/(R\,\Sigma) \f$, a product of positive factors.
/// @eq{28}  @derivation{forms/overdamped_modes}  @domain{R > 0, zeta >= 1}
template <class T>
[[nodiscard]] T first_damping_function_of_free_motion(const T& R, const HalfPeriodDecay<T>& h) {
    return product_over(h.root, h.K, R) * 2 / h.sum * h.root;
}

/// @brief (28) and (29) in entire functions of \f$ w^2 \f$, with \f$ E = e^{-\delta} \f$: the paper's for every damping ratio.
/// \f[ u = \frac{2S}{R\,\Sigma}, \qquad g = \frac{1 - E^2 - 2\zeta S}{\Sigma}, \qquad \Sigma = 1 + 2C + E^2 \f]
/// @eq{28,29}  @derivation{forms/overdamped_modes}  @domain{R > 0, zeta >= 0; keeps its digits for zeta >= 1, delta of 4 and more}
template <class T>
[[nodiscard]] DampingFunctions<T> damping_functions_of_free_motion(const T& R, const T& zeta, const HalfPeriodDecay<T>& h) {
    const T S = h.root * h.root * h.K;
    return {first_damping_function_of_free_motion(R, h), (1 - exp(T(-2 * zeta * (pi<T>() / R))) - 2 * zeta * S) / h.sum};
}

/// @brief (29) where \f$ \delta \f$ is small: its numerator as a series of positive terms.
/// \f[ g = \frac{2E\,\delta}{\Sigma}\left[\frac{\sinh\delta}{\delta} - \frac{\sinh\theta_1}{\theta_1}\right], \qquad
///     \theta_1 = \pi w_1/R \f]
/// @eq{28,29}  @derivation{forms/overdamped_modes}  @domain{R > 0, zeta >= 1; keeps its digits for delta up to 4}
template <class T>
[[nodiscard]] DampingFunctions<T> overdamped_functions_small_argument(const T& R, const T& zeta, const HalfPeriodDecay<T>& h) {
    const T q = pi<T>() / R;
    const T delta = zeta * q;
    return {first_damping_function_of_free_motion(R, h),
            2 * exp(T(-delta)) * sinhc_less_sinhc_over_square(q, zeta) / h.sum * delta * q * q};
}

/// @brief (29) where the slow rate is small: \f$ t_a = \tanh(\pi a/2R) \f$, \f$ t_b = \tanh(\pi b/2R) \f$, \f$ b = 1/a \f$.
/// \f[ g = \frac{b\,t_a - a\,t_b}{2w_1} \f]
/// @eq{28,29}  @derivation{forms/overdamped_modes}  @domain{R > 0, zeta > 1; keeps its digits for pi a / R up to 3/2, delta from 4}
template <class T>
[[nodiscard]] DampingFunctions<T> overdamped_functions_slow_rate(const T& R, const T& zeta, const HalfPeriodDecay<T>& h) {
    const T x = pi<T>() / R;
    const T w = overdamped_w(zeta);
    const T a = slow_rate(zeta);
    const T b = zeta + w;
    const T t_a = -exp_minus_one(T(-a * x)) / (1 + exp(T(-a * x)));
    const T t_b = -exp_minus_one(T(-b * x)) / (1 + exp(T(-b * x)));
    return {first_damping_function_of_free_motion(R, h), (b * t_a - a * t_b) / (2 * w)};
}

/// @brief \f$ v_{di} \f$ of a mode with \f$ \zeta \ge 1 \f$ and R of 2 and more: the form that keeps its digits at this place.
/// @eq{23}  @derivation{forms/overdamped_modes}  @domain{R >= 2, zeta >= 1}
template <class T>
[[nodiscard]] Complex<T> overdamped_response(const T& R, const T& zeta) {
    const T p = 1 / R;
    if ((1 - p) * (1 + p) < 2 * zeta * p) return complex_response_of_heavy_damping(R, zeta);
    return complex_response_above_resonance(R, zeta);
}

/// @brief \f$ u_{di} \f$ and \f$ g_i \f$ of a mode with \f$ \zeta \ge 1 \f$: the form that keeps its digits at this place.
/// @eq{28,29}  @derivation{forms/overdamped_modes}  @domain{R > 0, zeta >= 1}
template <class T>
[[nodiscard]] DampingFunctions<T> overdamped_functions(const T& R, const T& zeta) {
    const T x = pi<T>() / R;
    const bool near_critical = square_of_overdamped_angle(zeta, x) <= 1;
    const HalfPeriodDecay<T> h = near_critical ? half_period_near_critical(R, zeta) : half_period_of_two_rates(R, zeta);
    if (zeta * x <= 4) return overdamped_functions_small_argument(R, zeta, h);
    if (!near_critical && 2 * slow_rate(zeta) * x < 3) return overdamped_functions_slow_rate(R, zeta, h);
    return damping_functions_of_free_motion(R, zeta, h);
}

/// @brief Free motions of a mode with \f$ \zeta \ge 1 \f$: the form that keeps its digits at this place.
/// @eq{A.8,A.9}  @derivation{forms/overdamped_modes}  @domain{x >= 0, zeta >= 1}
template <class T>
[[nodiscard]] FreeMotion<T> overdamped_free_motion(const T& x, const T& zeta) {
    if (square_of_overdamped_angle(zeta, x) <= 1) return free_motion_near_critical(x, zeta);
    return free_motion_of_two_rates(x, zeta);
}

} // namespace denhartog::evaluation
