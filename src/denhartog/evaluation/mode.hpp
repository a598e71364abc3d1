/// @file
/// @brief Forms of (23), (28), (29) and of the free motions (A.8) that keep their digits, and their selection.
///
/// With \f$ E = e^{-\delta} \f$, \f$ c = \cos(\theta/2) \f$, \f$ s = \sin(\theta/2) \f$ the denominator of (28) and (29) is
/// \f$ 2E(\cosh\delta+\cos\theta) = (1-E)^2 + 4Ec^2 \f$, a sum of two positive terms: nothing cancels near the poles, and
/// nothing overflows at small R. The half angle is \f$ \pi/(2R) \f$, reduced exactly, less \f$ \pi(1-w)/(2R) \f$, so that
/// neither a rounded quotient nor a rounded w is magnified near the poles. The numerator of (29) cancels at large R; there a
/// second form is taken. Products that could leave the range of the number type on the way to a result within it are taken in
/// another order, or with a factor `scale`, a power of two that every form is free of. Every form is branch-free and proved equal
/// to the paper's in `derivation/forms/evaluation_forms.cpp`; only the selection compares numbers. From \f$ \zeta = 1 \f$ on, which
/// the paper leaves out, the selection goes to the forms of `overdamped.hpp`.
///
/// R is the modal frequency ratio (22), zeta the modal damping ratio, h the half angle and the exponent, and `scale` lifts a
/// subnormal zeta.
#pragma once

#include <limits>
#include <type_traits>

#include "denhartog/evaluation/overdamped.hpp"
#include "denhartog/evaluation/special.hpp"
#include "denhartog/formulas/mode.hpp"

namespace denhartog::evaluation {

/// @brief \f$ v_{di} \f$ with \f$ a = (1-R)(1+R) \f$, exact to rounding near resonance, and \f$ b = 2\zeta R \f$: a is larger.
/// \f[ \mathrm{Re}\{v\} = \frac{1}{a + b\,(b/a)}, \qquad \mathrm{Im}\{v\} = -\frac{b}{a}\,\mathrm{Re}\{v\} \f]
/// @eq{23}  @derivation{forms/evaluation_forms}  @domain{0 < R < 2, zeta >= 0, R not 1; keeps its digits for |a| >= b}
template <class T>
[[nodiscard]] Complex<T> complex_response_off_resonance(const T& R, const T& zeta, const T& scale) {
    const T a = (1 - R) * (1 + R);
    const T b = 2 * zeta * R;
    const T re = 1 / (a + b * (b / a));
    return {re, -(scale * zeta * (2 * R) / a * re / scale)};
}

/// @brief \f$ v_{di} \f$ with a and b as off resonance, where b is larger.
/// \f[ \mathrm{Im}\{v\} = -\frac{1}{b + a\,(a/b)}, \qquad \mathrm{Re}\{v\} = -\frac{a}{b}\,\mathrm{Im}\{v\} \f]
/// @eq{23}  @derivation{forms/evaluation_forms}  @domain{0 < R < 2, zeta > 0; keeps its digits for |a| <= b}
template <class T>
[[nodiscard]] Complex<T> complex_response_near_resonance(const T& R, const T& zeta) {
    const T a = (1 - R) * (1 + R);
    const T b = 2 * zeta * R;
    const T quotient = a / b;
    const T sum = b + a * quotient;
    return {quotient / sum, -1 / sum};
}

/// @brief \f$ v_{di} \f$ in \f$ p = 1/R \f$: no square of R overflows.
/// \f[ v_{di} = \frac{A - iB}{R^2\,(A^2+B^2)}, \qquad A = p^2-1,\quad B = 2\zeta p \f]
/// @eq{23}  @derivation{forms/evaluation_forms}  @domain{R > 0, 0 <= zeta < 1; keeps its digits for R of 2 and more}
template <class T>
[[nodiscard]] Complex<T> complex_response_high_frequency(const T& R, const T& zeta) {
    const T p = 1 / R;
    const T A = p * p - 1;
    const T B = 2 * zeta * p;
    const T D = A * A + B * B;
    return {A / D / R / R, -(2 * zeta / D / R / R / R)};
}

/// @brief \f$ v_{di} \f$: the form that keeps its digits at this place.
/// @eq{23}  @derivation{forms/evaluation_forms}  @domain{R > 0, zeta >= 0}
/// @return v_di; not a number at its pole R = 1, zeta = 0
template <class T>
[[nodiscard]] Complex<T> complex_response(const T& R, const T& zeta) {
    if (R >= 2) return zeta >= 1 ? overdamped_response(R, zeta) : complex_response_high_frequency(R, zeta);
    const T a = (1 - R) * (1 + R);
    const T b = 2 * zeta * R;
    if ((a < 0 ? T(-a) : a) < b) return complex_response_near_resonance(R, zeta);
    return complex_response_off_resonance(R, zeta, zeta >= 1 ? T(1) : T(1 / T(std::numeric_limits<T>::epsilon())));
}

/// @brief Sine, cosine and exponents that the forms of (28) and (29) share.
template <class T>
struct HalfAngle {
    T w;     ///< sqrt(1 - zeta^2)
    T delta; ///< pi zeta / R
    T s;     ///< sin(theta / 2)
    T c;     ///< cos(theta / 2)
};

/// @brief Half angle as a difference, and the exponent of the decay over the half-period.
/// \f[ \frac{\theta}{2} = \frac{\pi}{2R} - \frac{\pi(1-w)}{2R}, \qquad \delta = \frac{\pi\zeta}{R} \f]
/// @eq{28,29}  @derivation{forms/evaluation_forms}  @domain{R > 0, 0 <= zeta < 1; keeps its digits for zeta below 1/2}
template <class T>
[[nodiscard]] HalfAngle<T> half_angle(const T& R, const T& zeta) {
    const SineCosine<T> half = sine_cosine_of_half_period(R, T(one_minus_w(zeta) / (2 * R)));
    const T delta = pi<T>() * zeta / R;
    return {oscillating_w(zeta), delta, half.s, half.c};
}

/// @brief Half angle as a product, which keeps its digits where w is small, and the exponent of the decay.
/// @eq{28,29}  @derivation{forms/evaluation_forms}  @domain{R > 0, 0 <= zeta < 1; keeps its digits for zeta of 1/2 and more}
template <class T>
[[nodiscard]] HalfAngle<T> half_angle_of_heavy_damping(const T& R, const T& zeta) {
    const T w = oscillating_w(zeta);
    const T x = w / (2 * R);
    const T delta = pi<T>() * zeta / R;
    return {w, delta, sin_pi(x), cos_pi(x)};
}

/// @brief (28) and (29) in decaying exponentials and half angles.
/// \f[ u = \frac{4Esc}{R\,w\,[(1-E)^2+4Ec^2]}, \qquad g = \frac{(1-E)(1+E) - 4E\frac{\zeta}{w}sc}{(1-E)^2+4Ec^2} \f]
/// @eq{28,29}  @derivation{forms/evaluation_forms}  @domain{R > 0, 0 <= zeta < 1; keeps its digits for R below 5/4}
template <class T>
[[nodiscard]] DampingFunctions<T> damping_functions_half_angle(const T& R, const T& zeta, const HalfAngle<T>& h) {
    const T root_E = exp(T(-h.delta / 2));
    const T E = root_E * root_E;
    const T E_minus_one = exp_minus_one(T(-h.delta));
    const T denominator = E_minus_one * E_minus_one + 4 * E * h.c * h.c;
    return {root_E * h.s * h.c / denominator * (4 / h.w) / R * root_E,
            -(E_minus_one * (1 + E) + 4 * E * (zeta / h.w) * h.s * h.c) / denominator};
}

/// @brief (28) and (29) with \f$ \delta \f$ taken out of the numerator of (29), where a subnormal zeta would lose its digits.
/// \f[ g = \frac{\delta}{(1-E)^2+4Ec^2}\left[(1+E)\frac{1-E}{\delta} - \frac{4ERsc}{\pi w}\right] \f]
/// @eq{28,29}  @derivation{forms/evaluation_forms}  @domain{R > 0, 0 <= zeta < 1; keeps its digits for R below 5/4}
template <class T>
[[nodiscard]] DampingFunctions<T> damping_functions_slight_damping(const T& R, const T& zeta, const HalfAngle<T>& h,
                                                                   const T& scale) {
    const T root_E = exp(T(-h.delta / 2));
    const T E = root_E * root_E;
    const T quotient = one_minus_exp_over(h.delta);
    const T one_minus_E = quotient * h.delta;
    const T denominator = one_minus_E * one_minus_E + 4 * E * h.c * h.c;
    const T bracket = (1 + E) * quotient - 4 * E * R * h.s * h.c / (pi<T>() * h.w);
    return {root_E * h.s * h.c / denominator * (4 / h.w) / R * root_E,
            bracket / denominator * (scale * zeta) * (pi<T>() / R) / scale};
}

/// @brief (28) and (29) where both arguments are small: the numerator of (29) as a series with positive leading term.
/// \f[ u = \frac{sc}{R\,w\,(\sinh^2\frac{\delta}{2}+c^2)}, \qquad
///     g = \frac{\delta\left[\frac{\sinh\delta}{\delta}-\frac{\sin\theta}{\theta}\right]}{2\,(\sinh^2\frac{\delta}{2}+c^2)} \f]
/// @eq{28,29}  @derivation{forms/evaluation_forms}  @domain{R > 0, 0 <= zeta < 1; keeps its digits for R of 5/4 and more}
template <class T>
[[nodiscard]] DampingFunctions<T> damping_functions_small_argument(const T& R, const T& zeta, const HalfAngle<T>& h,
                                                                   const T& scale) {
    const T q = pi<T>() / R;
    const T sinh_half = sinh(T(h.delta / 2));
    const T denominator = sinh_half * sinh_half + h.c * h.c;
    const T bracket = sinhc_less_sinc_over_square(q, zeta) * q * q;
    return {h.s * h.c / denominator / h.w / R, bracket / denominator * (scale * zeta) * q / (2 * scale)};
}

/// @brief (28) and (29) at R = 1, with every power of zeta that the printed form loses taken out.
///
/// With \f$ y = \zeta^2/[2(1+w)] \f$, \f$ t = \sin(\pi y)/\zeta^2 \f$, \f$ s = \cos\pi y \f$, \f$ e = (1-E)/\zeta \f$
/// \f[ u = \frac{4Ets}{w\,(e^2+4E\zeta^2t^2)}, \qquad g = \frac{(1+E)\,e - 4E\frac{\zeta^2}{w}ts}{\zeta\,(e^2+4E\zeta^2t^2)} \f]
/// @eq{28,29}  @derivation{forms/evaluation_forms}  @domain{R = 1, 0 < zeta < 1; keeps its digits for zeta below 1/2}
template <class T>
[[nodiscard]] DampingFunctions<T> damping_functions_at_resonance(const T& zeta) {
    const T w = oscillating_w(zeta);
    const T E = exp(T(-pi<T>() * zeta));
    const T y = one_minus_w(zeta) / 2;
    const T t = pi<T>() * sinc(T(pi<T>() * y)) / (2 * (1 + w));
    const T s = cos(T(pi<T>() * y));
    const T e = pi<T>() * one_minus_exp_over(T(pi<T>() * zeta));
    const T denominator = e * e + 4 * E * (zeta * t) * (zeta * t);
    return {4 * E * t * s / (w * denominator), ((1 + E) * e - 4 * E * (zeta / w) * zeta * t * s) / denominator / zeta};
}

/// @brief Whether R is 1/n, n odd, to the last place: a mode without damping is not distinguished from its pole there.
/// @return whether 1/(2R), rounded, is half an odd number
template <class T>
[[nodiscard]] bool at_undamped_pole(const T& R) {
    return cos_pi(T(1 / (2 * R))) == 0;
}

/// @brief \f$ u_{di} \f$ and \f$ g_i \f$: the form that keeps its digits at this place.
/// @eq{28,29}  @derivation{forms/evaluation_forms}  @domain{R > 0, zeta >= 0, but for the poles at zeta = 0}
template <class T>
[[nodiscard]] DampingFunctions<T> selected_damping_functions(const T& R, const T& zeta) {
    if (zeta >= 1) return overdamped_functions(R, zeta);
    const T scale = 1 / T(std::numeric_limits<T>::epsilon());
    const bool heavy = 2 * zeta >= 1;
    if (R == 1 && !heavy) return damping_functions_at_resonance(zeta);
    const HalfAngle<T> h = heavy ? half_angle_of_heavy_damping(R, zeta) : half_angle(R, zeta);
    if (4 * R >= 5) return damping_functions_small_argument(R, zeta, h, scale);
    if (zeta < scale * (std::numeric_limits<T>::min)()) return damping_functions_slight_damping(R, zeta, h, scale);
    return damping_functions_half_angle(R, zeta, h);
}

/// @brief \f$ u_{di} \f$ and \f$ g_i \f$ as callers get them: those of float in double, so that (40) keeps its digits.
/// @eq{28,29}  @derivation{forms/evaluation_forms}  @domain{R > 0, zeta >= 0}
/// @return u, g; not finite at the poles at zeta = 0, R = 1/n, n odd
template <class T>
[[nodiscard]] DampingFunctions<T> damping_functions(const T& R, const T& zeta) {
    if (zeta == 0 && at_undamped_pole(R)) return {T(1 / zeta), T(zeta / zeta)};
    if constexpr (std::is_same_v<T, float>) {
        const DampingFunctions<double> f = selected_damping_functions<double>(R, zeta);
        return {static_cast<T>(f.u), static_cast<T>(f.g)};
    } else {
        return selected_damping_functions(R, zeta);
    }
}

/// @brief \f$ v_{di} \f$, \f$ u_{di} \f$ and \f$ g_i \f$: the form that keeps its digits at this place.
/// @eq{23,28,29}  @derivation{forms/evaluation_forms}  @domain{R > 0, zeta >= 0}
/// @return v, u, g; not finite at the poles that (23), (28), (29) have at zeta = 0
template <class T>
[[nodiscard]] ModeFunctions<T> mode_functions(const T& R, const T& zeta) {
    const DampingFunctions<T> f = damping_functions(R, zeta);
    return {complex_response(R, zeta), f.u, f.g};
}

/// @brief (A.8) and (A.9) from one exponential, one sine and one cosine, \f$ 1-\zeta^2 \f$ as a product.
/// \f[ d = e^{-\zeta x}(C+\zeta S), \quad q = e^{-\zeta x}S, \quad q' = \frac{e^{-\zeta x}}{R}(C-\zeta S), \quad
///     q'' = -\frac{e^{-\zeta x}}{R^2}[2\zeta(C-\zeta S)+S], \qquad C = \cos wx, \quad S = x\,\frac{\sin wx}{wx} \f]
/// The decay is the square of a root, between whose factors 1/R stands: neither leaves the range of the number type before the
/// rates do.
/// @eq{A.8,A.9}  @derivation{forms/evaluation_of_motion}  @domain{tau >= 0, R > 0, 0 <= zeta < 1}
template <class T>
[[nodiscard]] FreeMotion<T> oscillating_free_motion(const T& tau, const T& R, const T& zeta, const T& w) {
    const T x = tau / R;
    const T root = exp(T(-zeta * x / 2));
    const SineCosine<T> turned = sinc_cosine(T(w * x));
    const T C = turned.c;
    const T S = turned.s * x;
    const T rate = C - zeta * S;
    return {root * (C + zeta * S) * root, root * S * root, -(root * (S / R) * root), root * (rate / R) * root,
            -(root * ((2 * zeta * rate + S) / R / R) * root)};
}

/// @brief Free motions (A.8) of a mode and their rates (A.9): the form that keeps its digits at this place.
/// @eq{A.8,A.9}  @derivation{forms/evaluation_of_motion}  @domain{tau >= 0, R > 0, zeta >= 0}
template <class T>
[[nodiscard]] FreeMotion<T> free_motion(const T& tau, const T& R, const T& zeta, const T& w) {
    if (zeta >= 1) return with_rates_in_tau(overdamped_free_motion(T(tau / R), zeta), R);
    return oscillating_free_motion(tau, R, zeta, w);
}

} // namespace denhartog::evaluation
