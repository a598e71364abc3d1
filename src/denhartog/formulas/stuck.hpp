/// @file
/// @brief Sticking: the load on the contact, the boundary of permanent sticking, invariant points: (74), (75), (87), (88).
#pragma once

#include <cstddef>
#include <span>

#include "denhartog/formulas/complex.hpp"

namespace denhartog::paper {

/// @brief Load on the contact other than friction and inertia, with its sign; \f$ \Sigma_j \f$ is its size.
/// \f[ \sum_k \overline{C}_{jk}\bar{x}_k' + \sum_k \overline{K}_{jk}\bar{x}_k - \delta_{lj}\cos\tau \f]
/// While the contact rests, friction balances it.
/// @eq{75}  @derivation{paper/section_3_1_numerical}  @domain{diagonal mass matrix; arrays of one length N}
/// @param C_j      row j of the non-dimensional damping matrix, Eq. (7), N values
/// @param K_j      row j of the non-dimensional stiffness matrix, Eq. (7), N values
/// @param x        displacements, N values
/// @param x_prime  velocities with respect to tau, N values
/// @param delta_lj part of the load on the mass in contact: 1 if it acts on that alone, 0 if on another; p_j of several
/// @param tau      non-dimensional time, Eq. (5), zero at a maximum of the force; radians
/// @return         the load, in units of P
template <class T>
[[nodiscard]] T dynamic_load_on_contact(std::span<const T> C_j, std::span<const T> K_j, std::span<const T> x,
                                        std::span<const T> x_prime, const T& delta_lj, const T& tau) {
    T load = -delta_lj * cos(tau);
    for (std::size_t k = 0; k < x.size(); ++k) load = load + C_j[k] * x_prime[k] + K_j[k] * x[k];
    return load;
}

/// @brief Amount by which static friction exceeds the load: a contact at rest stays at rest where it is not negative, (74).
/// \f[ \mu\beta - \Sigma_j \f]
/// @eq{74}  @derivation{paper/section_3_1_numerical}  @domain{contact at rest}
/// @param Sigma_j  size of the load on the contact, Eq. (75)
/// @param mu       ratio of static to kinetic friction, Eq. (3)
/// @param beta     friction ratio, Eq. (11)
/// @return         the margin, in units of P
template <class T>
[[nodiscard]] T sticking_margin(const T& Sigma_j, const T& mu, const T& beta) {
    return mu * beta - Sigma_j;
}

/// @brief Zero where the monoharmonic amplitude (52) of an undamped system does not depend on the friction ratio.
/// \f[ 1 - 2\,\frac{V_k}{V_j}\frac{U_j}{U_k} \f]
///
/// Without damping \f$ \overline{X}_k^2 = V_k^2 + \beta^2U_k^2 \f$ times this. The amplitude is as independent of friction where
/// \f$ U_k = 0 \f$, a factor that the equation divides out.
/// @eq{87}  @derivation{paper/section_4_3_stuck}  @domain{all zeta_i = 0; V_j and U_k not zero}
/// @param V_k  response function of the mass, Eq. (33), real without damping
/// @param V_j  response function of the mass in contact, Eq. (33)
/// @param U_k  first damping function of the mass, Eq. (34)
/// @param U_j  first damping function of the mass in contact, Eq. (34)
/// @return     the function; dimensionless
template <class T>
[[nodiscard]] T invariant_point_function(const T& V_k, const T& V_j, const T& U_k, const T& U_j) {
    return 1 - 2 * (V_k / V_j) * (U_j / U_k);
}

/// @brief Complex amplitude of the load on the held contact.
/// \f[ \sum_k\left(\overline{K}_{jk} + i\,\overline{C}_{jk}\right)\overline{X}_k^* - \delta_{lj} \f]
/// @eq{88}  @derivation{paper/section_4_3_stuck}  @domain{contact held at zero, X_j = 0; arrays of one length}
/// @param C_j      row j of the non-dimensional damping matrix, Eq. (7)
/// @param K_j      row j of the non-dimensional stiffness matrix, Eq. (7); less that of the mass matrix if it is not diagonal
/// @param X        complex amplitudes of the displacements with the contact held, \f$ \bar{x}_k = \mathrm{Re}\{X_ke^{i\tau}\} \f$
/// @param delta_lj part of the load on the mass in contact: 1 if it acts on that alone, 0 if on another; p_j of several,
///                 complex if they are out of phase
/// @return         the amplitude, complex; in units of P
template <class T>
[[nodiscard]] Complex<T> load_on_held_contact(std::span<const T> C_j, std::span<const T> K_j, std::span<const Complex<T>> X,
                                              const Complex<T>& delta_lj) {
    Complex<T> load{-delta_lj.re, -delta_lj.im};
    for (std::size_t k = 0; k < X.size(); ++k)
        load = load + Complex<T>{K_j[k] * X[k].re - C_j[k] * X[k].im, K_j[k] * X[k].im + C_j[k] * X[k].re};
    return load;
}

/// @brief Smallest friction ratio that holds the contact for ever, \f$ \beta^*_{\lim} \f$.
/// \f[ \frac{1}{\mu}\left|\sum_k\left(\overline{K}_{jk}+i\,\overline{C}_{jk}\right)\overline{X}_k^* - \delta_{lj}\right| \f]
/// @eq{88}  @erratum{88}  @derivation{paper/section_4_3_stuck}  @domain{mu >= 1}
/// @param load  complex amplitude of the load on the held contact
/// @param mu    ratio of static to kinetic friction, Eq. (3)
/// @return      the friction ratio; dimensionless
template <class T>
[[nodiscard]] T sticking_limit(const Complex<T>& load, const T& mu) {
    return modulus(load) / mu;
}

/// @brief The form of \f$ \beta^*_{\lim} \f$ in the first two lines of (88): \f$ \kappa\overline{X}^*/\mu \f$.
///
/// The spring between the contact and its neighbour on the side of the load. The damping forces of the moving masses on the
/// contact are left out.
/// @eq{88}  @derivation{paper/section_4_3_stuck}
/// @domain{chain, j not l; exact if row j of the damping matrix is zero off its diagonal}
/// @param kappa  stiffness ratio of the spring: kappa_j if j > l, kappa_{j+1} if j < l
/// @param X      amplitude of the neighbour with the contact held
/// @param mu     ratio of static to kinetic friction, Eq. (3)
/// @return       the friction ratio; dimensionless
template <class T>
[[nodiscard]] T sticking_limit_by_spring(const T& kappa, const T& X, const T& mu) {
    return kappa * X / mu;
}

/// @brief The third line of (88): \f$ \beta^*_{\lim} = 1/\mu \f$ if the load acts on the contact, as no other mass moves then.
/// @eq{88}  @derivation{paper/section_4_3_stuck}  @domain{j = l; mu >= 1}
/// @param mu  ratio of static to kinetic friction, Eq. (3)
/// @return    the friction ratio; dimensionless
template <class T>
[[nodiscard]] T sticking_limit_under_load(const T& mu) {
    return 1 / mu;
}

} // namespace denhartog::paper
