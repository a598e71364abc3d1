/// @file
/// @brief What callers get for (23), (28), (29) and the motion (40): forms that keep their digits, and their selection.
///
/// With \f$ E = e^{-\delta} \f$, \f$ c = \cos(\theta/2) \f$, \f$ s = \sin(\theta/2) \f$ the denominator of (28) and (29) is
/// \f$ 2E(\cosh\delta+\cos\theta) = (1-E)^2 + 4Ec^2 \f$, a sum of two positive terms: nothing cancels near the poles, and
/// nothing overflows at small R. The half angle is \f$ \pi/(2R) \f$ less \f$ \pi(1-w)/(2R) \f$, so that a small damping ratio is
/// not rounded away. The numerator of (29) cancels at large R; there a second form is taken. Every form is
/// branch-free and proved equal to the paper's in `derivation/evaluation_forms.cpp`; only the selection compares numbers.
#pragma once

#include "denhartog/evaluation/special.hpp"
#include "denhartog/formulas/mode.hpp"

namespace denhartog::evaluation {

/// @brief What one mode contributes at one frequency ratio: (23), (28), (29).
template <class T>
struct ModeFunctions {
    Complex<T> v; ///< complex response function, Eq. (23)
    T u;          ///< first damping function, Eq. (28)
    T g;          ///< second damping function, Eq. (29)
};

/// @brief \f$ v_{di} \f$ with \f$ 1-R^2 \f$ as \f$ (1-R)(1+R) \f$, exact to rounding near resonance.
/// @eq{23}  @derivation{evaluation_forms}  @domain{R > 0, 0 <= zeta < 1}
/// @param R     modal frequency ratio, Eq. (22)
/// @param zeta  modal damping ratio
/// @return      v_di
template <class T>
[[nodiscard]] Complex<T> complex_response(const T& R, const T& zeta) {
    const T a = (1 - R) * (1 + R);
    const T b = 2 * zeta * R;
    const T D = a * a + b * b;
    return {a / D, -b / D};
}

/// @brief What both forms of (28) and (29) are made of.
template <class T>
struct HalfAngle {
    T w;     ///< sqrt(1 - zeta^2)
    T delta; ///< pi zeta / R
    T E;     ///< exp(-delta)
    T s;     ///< sin(theta / 2)
    T c;     ///< cos(theta / 2)
};

/// @brief Half angle and decay over the half-period.
/// \f[ \frac{\theta}{2} = \frac{\pi}{2R} - \frac{\pi(1-w)}{2R}, \qquad \delta = \frac{\pi\zeta}{R} \f]
/// @eq{28,29}  @derivation{evaluation_forms}  @domain{R > 0, 0 <= zeta < 1}
/// @param R     modal frequency ratio, Eq. (22)
/// @param zeta  modal damping ratio
/// @return      w, delta, exp(-delta), sine and cosine of the half angle
template <class T>
[[nodiscard]] HalfAngle<T> half_angle(const T& R, const T& zeta) {
    const T x = 1 / (2 * R);
    const T y = one_minus_w(zeta) / (2 * R);
    const T delta = pi<T>() * zeta / R;
    const T s_x = sin_pi(x), c_x = cos_pi(x);
    const T s_y = sin_pi(y), c_y = cos_pi(y);
    return {sqrt(T((1 - zeta) * (1 + zeta))), delta, exp(T(-delta)), s_x * c_y - c_x * s_y, c_x * c_y + s_x * s_y};
}

/// @brief (28) and (29) in decaying exponentials and half angles.
/// \f[ u = \frac{4Esc}{R\,w\,[(1-E)^2+4Ec^2]}, \qquad g = \frac{(1-E)(1+E) - 4E\frac{\zeta}{w}sc}{(1-E)^2+4Ec^2} \f]
/// @eq{28,29}  @derivation{evaluation_forms}  @domain{R > 0, 0 <= zeta < 1; keeps its digits for R below 2}
/// @param R     modal frequency ratio, Eq. (22)
/// @param zeta  modal damping ratio
/// @return      v, u, g
template <class T>
[[nodiscard]] ModeFunctions<T> mode_functions_half_angle(const T& R, const T& zeta) {
    const HalfAngle<T> h = half_angle(R, zeta);
    const T E_minus_one = exp_minus_one(T(-h.delta));
    const T denominator = E_minus_one * E_minus_one + 4 * h.E * h.c * h.c;
    return {complex_response(R, zeta), 4 * h.E * h.s * h.c / (R * h.w * denominator),
            -(E_minus_one * (1 + h.E) + 4 * h.E * zeta / h.w * h.s * h.c) / denominator};
}

/// @brief (28) and (29) where both arguments are small: the numerator of (29) as a sum of two positive terms.
/// \f[ g = \frac{2E\delta\left[\left(\frac{\sinh\delta}{\delta}-1\right)+\left(1-\frac{\sin\theta}{\theta}\right)\right]}
///              {(1-E)^2+4Ec^2} \f]
/// @eq{28,29}  @derivation{evaluation_forms}  @domain{R > 0, 0 <= zeta < 1; keeps its digits for R of 2 and more}
/// @param R     modal frequency ratio, Eq. (22)
/// @param zeta  modal damping ratio
/// @return      v, u, g
template <class T>
[[nodiscard]] ModeFunctions<T> mode_functions_small_argument(const T& R, const T& zeta) {
    const HalfAngle<T> h = half_angle(R, zeta);
    const T theta = pi<T>() * h.w / R;
    const T E_minus_one = exp_minus_one(T(-h.delta));
    const T denominator = E_minus_one * E_minus_one + 4 * h.E * h.c * h.c;
    return {complex_response(R, zeta), 4 * h.E * h.s * h.c / (R * h.w * denominator),
            2 * h.E * h.delta * (sinhc_minus_one(h.delta) + one_minus_sinc(theta)) / denominator};
}

/// @brief \f$ v_{di} \f$, \f$ u_{di} \f$ and \f$ g_i \f$: the form that keeps its digits at this R.
/// @eq{23,28,29}  @derivation{evaluation_forms}  @domain{R > 0, 0 <= zeta < 1}
/// @param R     modal frequency ratio, Eq. (22)
/// @param zeta  modal damping ratio
/// @return      v, u, g; not finite at the poles that (23), (28), (29) have at zeta = 0
template <class T>
[[nodiscard]] ModeFunctions<T> mode_functions(const T& R, const T& zeta) {
    return R < 2 ? mode_functions_half_angle(R, zeta) : mode_functions_small_argument(R, zeta);
}

/// @brief The braces of (40) and their first two derivatives in \f$ \tau \f$.
template <class T>
struct FrictionMotion {
    T value;        ///< 1 - (1 + g) d - u R q
    T prime;        ///< first derivative in tau
    T double_prime; ///< second derivative in tau
};

/// @brief The braces of (40) with their derivatives from one exponential, one sine and one cosine.
/// @eq{40,A.8,A.9}  @derivation{evaluation_forms}  @domain{0 <= tau <= pi, R > 0, 0 <= zeta < 1}
/// @param tau   non-dimensional time, Eq. (5); radians
/// @param R     modal frequency ratio, Eq. (22)
/// @param zeta  modal damping ratio
/// @param u     first damping function of the mode, Eq. (28)
/// @param g     second damping function of the mode, Eq. (29)
/// @return      value and derivatives; dimensionless
template <class T>
[[nodiscard]] FrictionMotion<T> friction_motion(const T& tau, const T& R, const T& zeta, const T& u, const T& g) {
    const T w = sqrt(T((1 - zeta) * (1 + zeta)));
    const T e = exp(T(-zeta * tau / R));
    const T C = e * cos(T(w * tau / R));
    const T S = e * sin(T(w * tau / R)) / w;
    const T d = C + zeta * S;
    const T Rq_prime = C - zeta * S;
    const T Rq_double_prime = -(2 * zeta * Rq_prime + S) / R;
    return {1 - (1 + g) * d - u * R * S, (1 + g) * S / R - u * Rq_prime, (1 + g) * Rq_prime / (R * R) - u * Rq_double_prime};
}

} // namespace denhartog::evaluation
