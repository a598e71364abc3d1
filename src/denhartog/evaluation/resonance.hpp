/// @file
/// @brief Forms of (79), (80), (83)-(85) that keep their digits at small damping ratios.
///
/// With \f$ x = \pi\zeta/2 \f$, \f$ \sinh(2x)/(\cosh(2x)-1) = \coth x \f$, so that nothing is subtracted; the form of the print
/// loses all digits below \f$ \zeta \approx 10^{-8} \f$. The boundary is \f$ \tanh(x)/(2\zeta) = \tfrac{\pi}{4}\,\tanh(x)/x \f$,
/// which has its value at \f$ \zeta = 0 \f$, and the peak is \f$ \coth x \f$ times the distance from that boundary: it is
/// positive exactly where the friction ratio is below the boundary as computed, and its rounding error is that of a friction
/// ratio off by a few units in the last place.
///
/// psi_ki, psi_li, psi_ji are the mode's shape (17) at mass k, the load and the contact, zeta its damping ratio, beta the
/// friction ratio (11).
#pragma once

#include "denhartog/evaluation/special.hpp"
#include "denhartog/formulas/resonance.hpp"

namespace denhartog::evaluation {

/// @brief \f$ \tanh(x)/x = (\sinh(x)/x)/\cosh x \f$, 1 at x = 0. @param x a number @return the quotient
template <class T>
[[nodiscard]] T tanhc(const T& x) {
    return (1 + sinhc_minus_one(x)) / cosh(x);
}

/// @brief (79) as \f$ \coth(\pi\zeta/2) \f$.
/// @eq{79}  @derivation{forms/evaluation_forms}  @domain{0 < zeta << 1}
template <class T>
[[nodiscard]] T second_damping_function_at_resonance(const T& zeta) {
    const T x = pi<T>() * zeta / 2;
    return cosh(x) / sinh(x);
}

/// @brief (80) as \f$ \psi_{ki}\psi_{ji}\coth(\pi\zeta_i/2) \f$.
/// @eq{80}  @derivation{forms/evaluation_forms}  @domain{0 < zeta << 1}
template <class T>
[[nodiscard]] T second_damping_function_at_resonance(const T& psi_ki, const T& psi_ji, const T& zeta) {
    return psi_ki * psi_ji * second_damping_function_at_resonance(zeta);
}

/// @brief (85) as \f$ \left|\psi_{li}/\psi_{ji}\right|\,\tfrac{\pi}{4}\,\tanh(x)/x \f$, \f$ x = \pi\zeta_i/2 \f$.
/// @eq{85}  @derivation{forms/evaluation_forms}  @domain{0 <= zeta << 1, psi_ji not zero; zeta = 0 gives pi/4 |psi_li/psi_ji|}
template <class T>
[[nodiscard]] T friction_ratio_limit_at_resonance(const T& psi_li, const T& psi_ji, const T& zeta) {
    return paper::magnitude(psi_li) / paper::magnitude(psi_ji) * (pi<T>() / 4 * tanhc(T(pi<T>() * zeta / 2)));
}

/// @brief (83) as \f$ |\psi_{ki}|\left[|\psi_{li}|\tfrac{\pi}{4}\tanh(x)/x - |\psi_{ji}|\beta\right]\coth(x) \f$,
/// \f$ x = \pi\zeta_i/2 \f$: the hyperbolic cotangent, which may be all but out of range, comes last.
/// @eq{83}  @derivation{forms/evaluation_forms}  @domain{0 < zeta << 1, beta below (85)}
/// @return the approximate amplitude, in units of P / k_1; negative beyond (85), where it means nothing
template <class T>
[[nodiscard]] T resonant_peak(const T& psi_ki, const T& psi_li, const T& psi_ji, const T& zeta, const T& beta) {
    const T limit = pi<T>() / 4 * tanhc(T(pi<T>() * zeta / 2));
    const T margin = paper::magnitude(psi_li) * limit - paper::magnitude(psi_ji) * beta;
    return paper::magnitude(psi_ki) * margin * second_damping_function_at_resonance(zeta);
}

/// @brief (84) as \f$ \coth(x)\left[\tfrac{\pi}{4}\tanh(x)/x - \beta\right] \f$, \f$ x = \pi\zeta/2 \f$.
/// @eq{84}  @derivation{forms/evaluation_forms}  @domain{0 < zeta << 1, beta below (85)}
/// @return the approximate amplitude, in units of P / k_1; negative beyond (85), where it means nothing
template <class T>
[[nodiscard]] T resonant_peak_of_single_mass(const T& zeta, const T& beta) {
    return second_damping_function_at_resonance(zeta) * (pi<T>() / 4 * tanhc(T(pi<T>() * zeta / 2)) - beta);
}

} // namespace denhartog::evaluation
