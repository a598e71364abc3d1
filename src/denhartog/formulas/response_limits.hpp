/// @file
/// @brief Limits of the response of the mass in contact, (33)-(35) and (38), as modes merge, decouple or grow without
/// number, and at the boundary of the sliding regime.
#pragma once

#include "denhartog/formulas/mode.hpp"

namespace denhartog::limits {

/// @brief (33) of a mass whose own tuned absorber carries the load, where the absorber's mass ratio falls to zero.
///
/// Two masses with \f$ \gamma_2 = \kappa_2 = x \f$, j = 1, l = 2, have natural frequencies with \f$ r_{n,1}\,r_{n,2} = 1 \f$ that
/// merge for x to 0. With \f$ f(\lambda) = v(r/\sqrt\lambda)/\lambda \f$ the sum (33) is minus the divided difference of f
/// between the two \f$ \lambda = r_n^2 \f$, and tends to minus its derivative:
/// \f[ V_{d1} \to -f'(1) = \frac{1+i\zeta r}{(1-r^2+2i\zeta r)^2} \f]
/// (34) and (35) tend to (28) and (29) of the mass alone.
/// @eq{33}  @derivation{forms/response_limits}  @domain{both damping ratios equal; 0 < zeta < 1, or r not 1}
/// @param r     frequency ratio, Eq. (10)
/// @param zeta  damping ratio of both modes
/// @return      V_dj, complex; dimensionless
template <class T>
[[nodiscard]] Complex<T> response_of_merged_modes(const T& r, const T& zeta) {
    const T a = (1 - r) * (1 + r);
    const T b = 2 * zeta * r;
    const T re = a * a - b * b;
    const T im = 2 * a * b;
    const T square = re * re + im * im;
    return {(re + zeta * r * im) / square, (zeta * r * re - im) / square};
}

/// @brief (38) at the boundary (67), where its root is \f$ \beta S \f$.
/// \f[ \overline{X}_j = \beta_{\lim}\,(S - G_j), \qquad S = H_j+\mu\textstyle\sum_i\psi_{ji}^2 \f]
/// @eq{38,67}  @derivation{forms/response_limits}  @domain{beta = beta_lim by (67)}
/// @param beta_lim  friction ratio at the boundary
/// @param S         H_j, Eq. (64), and what static friction adds to it in (67)
/// @param G_j       second damping function of the mass in contact, Eq. (35)
/// @return          amplitude there, in units of P / k_1
template <class T>
[[nodiscard]] T displacement_transmissibility_at_boundary(const T& beta_lim, const T& S, const T& G_j) {
    return beta_lim * (S - G_j);
}

/// @brief Approach of (38) to its value at the boundary (67) from below.
/// \f[ \overline{X}_j\big|_{\beta_{\lim}(1-x)} - \overline{X}_j\big|_{\beta_{\lim}} \sim
///     \beta_{\lim}\left(\frac{U_{dj}^2}{S}+G_j\right)x \f]
/// @eq{38,67}  @derivation{forms/response_limits}  @domain{x -> 0 from above}
/// @param beta_lim  friction ratio at the boundary
/// @param S         H_j, Eq. (64), and what static friction adds to it in (67)
/// @param U_dj      first damping function of the mass in contact, Eq. (34)
/// @param G_j       second damping function of the mass in contact, Eq. (35)
/// @return          the coefficient of x
template <class T>
[[nodiscard]] T slope_at_boundary(const T& beta_lim, const T& S, const T& U_dj, const T& G_j) {
    return beta_lim * (U_dj * U_dj / S + G_j);
}

} // namespace denhartog::limits
