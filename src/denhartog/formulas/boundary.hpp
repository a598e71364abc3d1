/// @file
/// @brief The domain of validity of the sliding solution: (54), (55), (58), (59), (63), (66)-(69), (72).
///
/// Each condition is given as the amount by which it holds, so that it is met if the value is positive.
#pragma once

#include <cstddef>
#include <span>

#include "denhartog/formulas/modal_coordinate.hpp"

namespace denhartog::paper {

/// @brief Velocity of the mass in contact over \f$ -\sin\tau \f$: (54)a holds at \f$ \tau \f$ where it is positive.
/// \f[ -\frac{\bar{x}_j'}{\sin\tau} = \overline{X}_j + \beta G_j - \beta\sum_i\psi_{ji}^2 s_i(\tau) \f]
/// @eq{54,55}  @derivation{paper/section_2_6_domain_of_validity}  @domain{0 < tau < pi}
/// @param X_j   amplitude of the mass in contact, Eq. (38)
/// @param G_j   second damping function of the mass in contact, Eq. (35)
/// @param S     sum over the modes of the expression of (57) at tau, or its maximum
/// @param beta  friction ratio, Eq. (11)
/// @return      the margin
template <class T>
[[nodiscard]] T sliding_margin(const T& X_j, const T& G_j, const T& S, const T& beta) {
    return X_j + beta * G_j - beta * S;
}

/// @brief Load on the contact other than friction and inertia; stops are excluded at \f$ \tau=0 \f$ where its size exceeds
/// \f$ \mu\beta \f$, (54)b.
/// \f[ \sum_k \overline{C}_{jk}\bar{x}_k' + \sum_k \overline{K}_{jk}\bar{x}_k - \delta_{lj}\cos(\tau+\phi_j) \f]
/// @eq{54}  @derivation{paper/section_2_6_domain_of_validity}  @domain{diagonal mass matrix; arrays of one length N}
/// @param C_j      row j of the non-dimensional damping matrix, Eq. (7), N values
/// @param K_j      row j of the non-dimensional stiffness matrix, Eq. (7), N values
/// @param x        displacements, N values
/// @param x_prime  velocities with respect to tau, N values
/// @param delta_lj 1 if the load acts on the mass in contact, else 0
/// @param tau      non-dimensional time, Eq. (5); radians
/// @param phi_j    phase of the mass in contact, Eq. (39); radians
/// @return         the load, in units of P
template <class T>
[[nodiscard]] T contact_load(std::span<const T> C_j, std::span<const T> K_j, std::span<const T> x, std::span<const T> x_prime,
                             int delta_lj, const T& tau, const T& phi_j) {
    T load = -delta_lj * cos(tau + phi_j);
    for (std::size_t k = 0; k < x.size(); ++k) load = load + C_j[k] * x_prime[k] + K_j[k] * x[k];
    return load;
}

/// @brief Contribution of a mode to the load on the contact at \f$ \tau=0 \f$, the left side of (59) without the bars.
/// @eq{59}  @derivation{paper/section_2_6_domain_of_validity}  @domain{R > 0, 0 <= zeta < 1}
/// @param m        the mode
/// @param start    initial values, Eq. (24)
/// @param cos_phi  cos(phi_j)
/// @return         2 zeta Omega eta'_0 + Omega^2 eta_0 - psi_li cos(phi_j)
template <class T>
[[nodiscard]] T modal_contact_load(const ModeInScene<T>& m, const InitialValues<T>& start, const T& cos_phi) {
    const T Omega = 1 / m.R;
    return 2 * m.zeta * Omega * start.eta_prime_0 + Omega * Omega * start.eta_0 - m.psi_li * cos_phi;
}

/// @brief Contribution of a mode without \f$ \cos\phi_j \f$, the left side of (63) without the bars.
/// \f[ \eta_{i0} - \beta\psi_{ji}\left[(1-R_i^2)g_i + 2\zeta_i R_i u_{di}\right] \f]
/// @eq{63}  @derivation{paper/section_2_6_domain_of_validity}  @domain{R > 0, 0 <= zeta < 1}
/// @param m      the mode
/// @param eta_0  modal displacement at tau = 0
/// @param u      first damping function of the mode, Eq. (28)
/// @param g      second damping function of the mode, Eq. (29)
/// @param beta   friction ratio, Eq. (11)
/// @return       the contribution of the mode
template <class T>
[[nodiscard]] T modal_contact_load_by_functions(const ModeInScene<T>& m, const T& eta_0, const T& u, const T& g, const T& beta) {
    return eta_0 - beta * m.psi_ji * ((1 - m.R * m.R) * g + 2 * m.zeta * m.R * u);
}

/// @brief Load on the contact at \f$ \tau=0 \f$ over \f$ \gamma_j r^2 \f$, the left side of (66) without the bars.
/// \f[ \overline{X}_j + \beta G_j - \beta H_j \f]
/// @eq{66}  @derivation{paper/section_2_6_domain_of_validity}  @domain{sliding regime}
/// @param X_j   amplitude of the mass in contact, Eq. (38)
/// @param G_j   second damping function of the mass in contact, Eq. (35)
/// @param H_j   Eq. (64)
/// @param beta  friction ratio, Eq. (11)
/// @return      the load over gamma_j r^2
template <class T>
[[nodiscard]] T contact_load_at_start(const T& X_j, const T& G_j, const T& H_j, const T& beta) {
    return X_j + beta * G_j - beta * H_j;
}

/// @brief Friction ratio at which the root of (38) falls to \f$ \beta S \f$.
/// \f[ \sqrt{\frac{|V_{dj}|^2}{U_{dj}^2+S^2}} \f]
///
/// With \f$ S = S_{dj} \f$ it is (58), with \f$ S = H_j+\mu/(\gamma_j r^2) \f$ it is (67), with
/// \f$ S = H_j-\mu/(\gamma_j r^2) \f$ it is (68), and with the larger of the first two it is (69), \f$ \beta_{\lim} \f$.
/// @eq{58,67,68,69}  @derivation{paper/section_2_6_domain_of_validity}  @domain{S > 0; (68) excludes nothing if its S is not positive}
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param S     what the amplitude has to exceed, per unit of friction ratio
/// @return      the friction ratio; dimensionless
template <class T>
[[nodiscard]] T friction_ratio_limit(const Complex<T>& V_dj, const T& U_dj, const T& S) {
    return sqrt(squared_modulus(V_dj) / (U_dj * U_dj + S * S));
}

/// @brief The expression that (67) has in place of \f$ S_{dj} \f$: \f$ H_j + \mu/(\gamma_j r^2) \f$; with mu = 1 it is (72).
/// @eq{67,72}  @derivation{paper/section_2_6_domain_of_validity}  @domain{mu >= 1; with mu = 1 a lower bound of S_dj}
/// @param H_j             Eq. (64)
/// @param mu              ratio of static to kinetic friction
/// @param sum_of_squares  sum of psi_ji^2 over the modes, Eq. (65)
/// @return                what X_j + beta G_j has to exceed, per unit of friction ratio
template <class T>
[[nodiscard]] T static_friction_demand(const T& H_j, const T& mu, const T& sum_of_squares) {
    return H_j + mu * sum_of_squares;
}

} // namespace denhartog::paper
