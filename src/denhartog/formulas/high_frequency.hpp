/// @file
/// @brief The boundary of continuous motion at high frequency ratios, (86), and at low ones.
#pragma once

#include "denhartog/number/number.hpp"

namespace denhartog::paper {

/// @brief The friction ratio that (69) tends to for \f$ r \to \infty \f$ if load and friction act on one mass.
/// \f[ \beta_\infty = \frac{2}{\sqrt{4\mu^2+\pi^2}} \f]
/// Neither the damping ratios nor the number of masses matter. If the load acts on another mass, j not l, (69) tends to zero.
/// @eq{86}  @erratum{86}  @derivation{paper/section_4_2_low_high_frequency}  @domain{j = l, mu >= 1; the limit r to infinity}
/// @param mu  ratio of static to kinetic friction, Eq. (3)
/// @return    the friction ratio; dimensionless
template <class T>
[[nodiscard]] T friction_ratio_limit_at_high_frequency(const T& mu) {
    return 2 / sqrt(T(4 * mu * mu + pi<T>() * pi<T>()));
}

/// @brief Leading term of (69) for \f$ r \to 0 \f$ if every mode is damped.
/// \f[ \beta_{\lim} \sim \frac{\gamma_jr^2}{1+\mu}\,|V_{dj}|_{r=0} \f]
/// The first damping functions are then smaller than every power of r, and the second ones 1 but for that. Without damping (69)
/// is of the same order, but has zeros at every scale, and over \f$ r^2 \f$ no limit.
/// @eq{69}  @derivation{paper/section_4_2_low_high_frequency}  @domain{r -> 0, every zeta_i > 0; pi zeta_i / R_i has to be large}
/// @param V_j_static  displacement of the mass in contact under a static load P without friction, in units of P / k_1
/// @param gamma_j     mass ratio of the mass in contact; dimensionless
/// @param r           frequency ratio; dimensionless
/// @param mu          ratio of static to kinetic friction, Eq. (3)
/// @return            the friction ratio; dimensionless
template <class T>
[[nodiscard]] T friction_ratio_limit_at_low_frequency(const T& V_j_static, const T& gamma_j, const T& r, const T& mu) {
    return gamma_j * r * r * sqrt(T(V_j_static * V_j_static)) / (1 + mu);
}

} // namespace denhartog::paper
