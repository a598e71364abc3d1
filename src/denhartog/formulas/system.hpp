/// @file
/// @brief The system and its non-dimensional form: (1)-(5), (7)-(11), (19), (73).
///
/// Square matrices are row-major arrays of N times N values; masses count from 0 here and from 1 in the paper.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "denhartog/number/number.hpp"

namespace denhartog::paper {

/// @brief Stiffness matrix of the chain of Fig. 1: spring i joins mass i to the mass before it, the first one to the ground.
/// @eq{1}  @derivation{paper/section_2_1_formulation}  @domain{N >= 1}
/// @param k  stiffnesses of the springs, N values
/// @return   K, N x N, row-major, in the units of k
template <class T>
[[nodiscard]] std::vector<T> chain_stiffness_matrix(std::span<const T> k) {
    const std::size_t N = k.size();
    std::vector<T> K(N * N); // entries start at zero
    for (std::size_t i = 0; i + 1 < N; ++i) {
        K[i * N + i] = k[i] + k[i + 1];
        K[i * N + i + 1] = -k[i + 1];
        K[(i + 1) * N + i] = -k[i + 1];
    }
    K[N * N - 1] = k[N - 1];
    return K;
}

/// @brief Friction force on the mass in contact, \f$ F_f = -F\,\mathrm{sgn}(\dot{x}_j) \f$.
/// @eq{2}  @erratum{2}  @derivation{paper/section_2_1_formulation}
/// @param F         kinetic friction force
/// @param sgn_x_dot a value of Eq. (3)'s set at the velocity of the mass in contact
/// @return          the force, in the units of F
template <class T>
[[nodiscard]] T friction_force(const T& F, const T& sgn_x_dot) {
    return -F * sgn_x_dot;
}

/// @brief Non-dimensional time, \f$ \tau = \omega t \f$.
/// @eq{5}  @derivation{paper/section_2_1_formulation}
/// @param omega  circular frequency of the load
/// @param t      time
/// @return       tau; radians
template <class T>
[[nodiscard]] T non_dimensional_time(const T& omega, const T& t) {
    return omega * t;
}

/// @brief Non-dimensional displacement, \f$ \bar{x} = k_1 x/P \f$.
/// @eq{5}  @derivation{paper/section_2_1_formulation}  @domain{P not zero}
/// @param x    displacement
/// @param k_1  stiffness of the first spring
/// @param P    amplitude of the load
/// @return     the displacement in units of P / k_1
template <class T>
[[nodiscard]] T non_dimensional_displacement(const T& x, const T& k_1, const T& P) {
    return k_1 * x / P;
}

/// @brief Entry of the non-dimensional mass matrix, \f$ \omega^2 m/k_1 \f$.
/// @eq{7}  @derivation{paper/section_2_1_formulation}  @domain{k_1 > 0}
/// @param m      entry of M
/// @param omega  circular frequency of the load
/// @param k_1    stiffness of the first spring
/// @return       the entry; dimensionless
template <class T>
[[nodiscard]] T non_dimensional_mass(const T& m, const T& omega, const T& k_1) {
    return omega * omega / k_1 * m;
}

/// @brief Entry of the non-dimensional damping matrix, \f$ \omega c/k_1 \f$.
/// @eq{7}  @derivation{paper/section_2_1_formulation}  @domain{k_1 > 0}
/// @param c      entry of C
/// @param omega  circular frequency of the load
/// @param k_1    stiffness of the first spring
/// @return       the entry; dimensionless
template <class T>
[[nodiscard]] T non_dimensional_damping(const T& c, const T& omega, const T& k_1) {
    return omega / k_1 * c;
}

/// @brief Stiffness over that of the first spring: entry of \f$ \overline{K} \f$ (7), stiffness ratio \f$ \kappa_i \f$ (73).
/// @eq{7,73}  @derivation{paper/section_2_1_formulation}  @domain{k_1 > 0}
/// @param k    a stiffness, or an entry of K
/// @param k_1  stiffness of the first spring
/// @return     the ratio; dimensionless
template <class T>
[[nodiscard]] T stiffness_ratio(const T& k, const T& k_1) {
    return k / k_1;
}

/// @brief Entry of the non-dimensional mass matrix by ratios, \f$ \gamma_i r^2 \f$.
/// @eq{8}  @derivation{paper/section_2_1_formulation}
/// @param gamma  mass ratio, Eq. (9)
/// @param r      frequency ratio, Eq. (10)
/// @return       the entry; dimensionless
template <class T>
[[nodiscard]] T non_dimensional_mass_by_ratios(const T& gamma, const T& r) {
    return gamma * r * r;
}

/// @brief Mass ratio, \f$ \gamma_i = m_i/m_1 \f$.
/// @eq{9}  @derivation{paper/section_2_1_formulation}  @domain{m_1 > 0}
/// @param m_i  a mass
/// @param m_1  the first mass
/// @return     the ratio; dimensionless
template <class T>
[[nodiscard]] T mass_ratio(const T& m_i, const T& m_1) {
    return m_i / m_1;
}

/// @brief Frequency ratio, \f$ r = \omega\sqrt{m_1/k_1} \f$.
/// @eq{10}  @derivation{paper/section_2_1_formulation}  @domain{m_1 > 0, k_1 > 0}
/// @param omega  circular frequency of the load
/// @param m_1    the first mass
/// @param k_1    stiffness of the first spring
/// @return       r; dimensionless
template <class T>
[[nodiscard]] T frequency_ratio(const T& omega, const T& m_1, const T& k_1) {
    return omega * sqrt(T(m_1 / k_1));
}

/// @brief Friction ratio, \f$ \beta = F/P \f$.
/// @eq{11}  @derivation{paper/section_2_1_formulation}  @domain{P not zero}
/// @param F  kinetic friction force
/// @param P  amplitude of the load
/// @return   beta; dimensionless
template <class T>
[[nodiscard]] T friction_ratio(const T& F, const T& P) {
    return F / P;
}

/// @brief An entry of a product of two matrices, one more factor pair after the other.
/// @eq{19}  @derivation{paper/section_2_1_formulation}
/// @param row     of the first, N values
/// @param column  of the second, N values
/// @param so_far  sum over the pairs before these
/// @return        the sum over all
template <class T>
[[nodiscard]] T entry_of_product(std::span<const T> row, std::span<const T> column, const T& so_far = T(0)) {
    T entry = so_far;
    for (std::size_t n = 0; n < row.size(); ++n) entry = entry + row[n] * column[n];
    return entry;
}

/// @brief An entry of the damping matrix, mode by mode.
/// \f[ \overline{C}_{kn} = \sum_i 2\zeta_i\Omega_i(\overline{M}\psi_i)_k(\overline{M}\psi_i)_n \f]
/// @eq{19}  @derivation{paper/section_2_1_formulation}
/// @param Omega    non-dimensional natural frequencies, N values, Eq. (15)
/// @param zeta     modal damping ratios, N values, Eq. (18)
/// @param M_psi_k  entries k of mass matrix times mode shape, N values
/// @param M_psi_n  entries n of the same, N values
/// @param so_far   sum over the modes before these
/// @return         the sum over all
template <class T>
[[nodiscard]] T entry_of_damping(std::span<const T> Omega, std::span<const T> zeta, std::span<const T> M_psi_k,
                                 std::span<const T> M_psi_n, const T& so_far = T(0)) {
    T entry = so_far;
    for (std::size_t i = 0; i < Omega.size(); ++i) entry = entry + 2 * zeta[i] * Omega[i] * M_psi_k[i] * M_psi_n[i];
    return entry;
}

/// @brief Non-dimensional damping matrix from modal damping ratios.
/// \f[ \overline{C} = \sum_i 2\zeta_i\Omega_i(\overline{M}\psi_i)(\overline{M}\psi_i)^T \f]
/// @eq{19}  @derivation{paper/section_2_1_formulation}  @domain{mode shapes normalised by (17)}
/// @param M      non-dimensional mass matrix, N x N, row-major, Eq. (8)
/// @param Psi    modal matrix, N x N, row-major, mass by mode, Eq. (14)
/// @param Omega  non-dimensional natural frequencies, N values, Eq. (15)
/// @param zeta   modal damping ratios, N values, Eq. (18)
/// @return       C, N x N, row-major
template <class T>
[[nodiscard]] std::vector<T> damping_matrix(std::span<const T> M, std::span<const T> Psi, std::span<const T> Omega,
                                            std::span<const T> zeta) {
    const std::size_t N = Omega.size();
    std::vector<T> M_Psi(N * N), column(N);
    for (std::size_t i = 0; i < N; ++i) {
        for (std::size_t n = 0; n < N; ++n) column[n] = Psi[n * N + i];
        for (std::size_t k = 0; k < N; ++k) M_Psi[k * N + i] = entry_of_product(M.subspan(k * N, N), std::span<const T>(column));
    }
    std::vector<T> C(N * N);
    const std::span<const T> rows(M_Psi);
    for (std::size_t k = 0; k < N; ++k)
        for (std::size_t n = 0; n < N; ++n)
            C[k * N + n] = entry_of_damping(Omega, zeta, rows.subspan(k * N, N), rows.subspan(n * N, N));
    return C;
}

} // namespace denhartog::paper
