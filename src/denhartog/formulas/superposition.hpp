/// @file
/// @brief Sums over modes: (33)-(35), (56), (64), (65).
///
/// Rows of the modal matrix are given as arrays over the modes: `psi_k[i]` is \f$ \psi_{ki} \f$, normalised by (17). Each sum
/// goes on from a sum over other modes, so that what one more mode adds is proved of the loop that runs, for any sum before it.
#pragma once

#include <cstddef>
#include <span>

#include "denhartog/formulas/mode.hpp"

namespace denhartog::paper {

/// @brief Complex response function of a mass, \f$ V_{dk} = \sum_i \psi_{ki}\psi_{li}R_i^2 v_{di} \f$.
/// @eq{33}  @derivation{paper/section_2_3_mass_in_contact}  @domain{arrays of one length N}
/// @param psi_k  mode shapes at the mass k, N values
/// @param psi_l  mode shapes at the loaded mass, N values
/// @param R      modal frequency ratios, Eq. (22), N values
/// @param v      complex response functions of the modes, Eq. (23), N values
/// @param so_far sum over the modes before these
/// @return       V_dk, complex; dimensionless
template <class T>
[[nodiscard]] Complex<T> complex_response_of_mass(std::span<const T> psi_k, std::span<const T> psi_l, std::span<const T> R,
                                                  std::span<const Complex<T>> v, const Complex<T>& so_far = {T(0), T(0)}) {
    Complex<T> V = so_far;
    for (std::size_t i = 0; i < v.size(); ++i) V = V + T(psi_k[i] * psi_l[i] * R[i] * R[i]) * v[i];
    return V;
}

/// @brief Complex response function of a mass to forces that are out of phase, \f$ V_{dk} =
/// \sum_i \psi_{ki}(\mathbf{p}^T\boldsymbol\psi_i)R_i^2 v_{di} \f$ with \f$ \mathbf{p} = \mathbf{p}' + \mathrm{i}\mathbf{p}'' \f$.
///
/// The force on the masses is \f$ \mathrm{Re}\{\mathbf{p}\,e^{\mathrm{i}\tau}\} = \mathbf{p}'\cos\tau - \mathbf{p}''\sin\tau \f$.
/// It enters (12) by \f$ \mathbf{p}^T\boldsymbol\psi_i \f$ alone, and linearly, so that (33) holds of both parts.
/// @eq{33}  @derivation{paper/contact_and_load_directions}  @domain{the domain of (33)}
/// @param V_dk_p  (33) with \f$ \mathbf{p}' \f$
/// @param V_dk_q  (33) with \f$ \mathbf{p}'' \f$
/// @return        V_dk, complex; dimensionless
template <class T>
[[nodiscard]] Complex<T> complex_response_to_phases(const Complex<T>& V_dk_p, const Complex<T>& V_dk_q) {
    return V_dk_p + times_i(V_dk_q);
}

/// @brief First damping function of a mass, \f$ U_{dk} = \sum_i \psi_{ki}\psi_{ji}R_i^2 u_{di} \f$.
///
/// With \f$ g_i \f$ in place of \f$ u_{di} \f$ it is the second damping function, \f$ G_k \f$, Eq. (35).
/// @eq{34,35}  @derivation{paper/section_2_3_mass_in_contact}  @domain{arrays of one length N}
/// @param psi_k  mode shapes at the mass k, N values
/// @param psi_j  mode shapes at the mass in contact, N values
/// @param R      modal frequency ratios, Eq. (22), N values
/// @param u      damping functions of the modes, Eq. (28) or (29), N values
/// @param so_far sum over the modes before these
/// @return       U_dk or G_k; dimensionless
template <class T>
[[nodiscard]] T damping_function_of_mass(std::span<const T> psi_k, std::span<const T> psi_j, std::span<const T> R,
                                         std::span<const T> u, const T& so_far = T(0)) {
    T U = so_far;
    for (std::size_t i = 0; i < u.size(); ++i) U = U + psi_k[i] * psi_j[i] * R[i] * R[i] * u[i];
    return U;
}

/// @brief Sum over the modes of the mass in contact, \f$ S_{dj} = \sum_i \psi_{ji}^2 s_{di} \f$.
///
/// With the values of (57)'s expression at one \f$ \tau \f$ it is the sum whose maximum over \f$ \tau \f$ bounds the sliding
/// regime exactly; with the maxima \f$ s_{di} \f$ of the single modes it is the paper's \f$ S_{dj} \f$, which is never smaller.
/// @eq{56}  @derivation{paper/section_2_6_domain_of_validity}  @domain{arrays of one length N}
/// @param psi_j  mode shapes at the mass in contact, N values
/// @param s      values of the modes, N values
/// @param so_far sum over the modes before these
/// @return       the sum; dimensionless
template <class T>
[[nodiscard]] T sum_over_contact(std::span<const T> psi_j, std::span<const T> s, const T& so_far = T(0)) {
    T S = so_far;
    for (std::size_t i = 0; i < s.size(); ++i) S = S + psi_j[i] * psi_j[i] * s[i];
    return S;
}

/// @brief \f$ H_j = \sum_i \psi_{ji}^2(g_i + 2\zeta_i R_i u_{di}) \f$, never negative.
/// @eq{64}  @derivation{paper/section_2_6_domain_of_validity}  @domain{arrays of one length N}
/// @param psi_j  mode shapes at the mass in contact, N values
/// @param R      modal frequency ratios, Eq. (22), N values
/// @param zeta   modal damping ratios, N values
/// @param u      first damping functions of the modes, Eq. (28), N values
/// @param g      second damping functions of the modes, Eq. (29), N values
/// @param so_far sum over the modes before these
/// @return       H_j; dimensionless
template <class T>
[[nodiscard]] T H(std::span<const T> psi_j, std::span<const T> R, std::span<const T> zeta, std::span<const T> u,
                  std::span<const T> g, const T& so_far = T(0)) {
    T sum = so_far;
    for (std::size_t i = 0; i < u.size(); ++i) sum = sum + psi_j[i] * psi_j[i] * (g[i] + 2 * zeta[i] * R[i] * u[i]);
    return sum;
}

/// @brief \f$ \sum_i \psi_{ji}^2 = 1/(\gamma_j r^2) \f$ for a diagonal mass matrix.
/// @eq{65}  @derivation{paper/section_2_6_domain_of_validity}  @domain{gamma_j > 0, r > 0; diagonal mass matrix}
/// @param gamma_j  mass ratio of the mass in contact, Eq. (9); dimensionless
/// @param r        frequency ratio, Eq. (10); dimensionless
/// @return         the sum of squares of the mode shapes at the mass in contact
template <class T>
[[nodiscard]] T sum_of_squares_at_contact(const T& gamma_j, const T& r) {
    return 1 / (gamma_j * r * r);
}

} // namespace denhartog::paper
