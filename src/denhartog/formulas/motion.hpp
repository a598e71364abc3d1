/// @file
/// @brief The motion of every mass over the half-period: (41)-(47).
///
/// Products of \f$ V_{dk} \f$ with \f$ \cos\phi_j \f$ and \f$ \sin\phi_j \f$ are read as in `complex.hpp`; the initial values
/// (44) and (45) are then real, and (46) follows from (41).
#pragma once

#include <cstddef>
#include <span>

#include "denhartog/formulas/contact.hpp"
#include "denhartog/formulas/modal_coordinate.hpp"

namespace denhartog::paper {

/// @brief Non-harmonic part of the motion of a mass under unit friction, the sum in (41) and (46).
/// \f[ \sum_i \psi_{ki}\psi_{ji}R_i^2\left\{1-(1+g_i)d_i(\tau)-u_{di}R_i q_i(\tau)\right\} \f]
/// @eq{41,46}  @erratum{41}  @derivation{paper/section_2_4_time_response}  @domain{0 <= tau <= pi; arrays of one length N}
/// @param tau    non-dimensional time, Eq. (5); radians
/// @param psi_k  mode shapes at the mass k, N values
/// @param psi_j  mode shapes at the mass in contact, N values
/// @param R      modal frequency ratios, Eq. (22), N values
/// @param zeta   modal damping ratios, N values
/// @param u      first damping functions of the modes, Eq. (28), N values
/// @param g      second damping functions of the modes, Eq. (29), N values
/// @param so_far sum over the modes before these
/// @return       the sum
template <class T>
[[nodiscard]] T friction_motion_of_mass(const T& tau, std::span<const T> psi_k, std::span<const T> psi_j, std::span<const T> R,
                                        std::span<const T> zeta, std::span<const T> u, std::span<const T> g,
                                        const T& so_far = T(0)) {
    T sum = so_far;
    for (std::size_t i = 0; i < R.size(); ++i)
        sum = sum + psi_k[i] * psi_j[i] * R[i] * R[i] * friction_motion(tau, R[i], zeta[i], u[i], g[i]);
    return sum;
}

/// @brief Displacement of a mass from its initial values.
/// \f[ \bar{x}_k = (\bar{x}_{k0}+\beta G_k)\cos\tau + (\bar{x}_{k0}'+\beta U_{dk})\sin\tau
///     + \beta\sum_i\psi_{ki}\psi_{ji}R_i^2\left\{1-(1+g_i)d_i(\tau)-u_{di}R_i q_i(\tau)\right\} \f]
/// @eq{41}  @erratum{41}  @derivation{paper/section_2_4_time_response}  @domain{0 <= tau <= pi, sliding regime, Eq. (69)}
/// @param tau        non-dimensional time, Eq. (5); radians
/// @param x_k0       displacement at tau = 0, Eq. (44)
/// @param x_prime_k0 velocity at tau = 0, Eq. (45)
/// @param G_k        second damping function of the mass, Eq. (35)
/// @param U_dk       first damping function of the mass, Eq. (34)
/// @param beta       friction ratio, Eq. (11)
/// @param F_k        `friction_motion_of_mass` at tau
/// @return           the displacement, in units of P / k_1
template <class T>
[[nodiscard]] T displacement(const T& tau, const T& x_k0, const T& x_prime_k0, const T& G_k, const T& U_dk, const T& beta,
                             const T& F_k) {
    return (x_k0 + beta * G_k) * cos(tau) + (x_prime_k0 + beta * U_dk) * sin(tau) + beta * F_k;
}

/// @brief \f$ V_{dk}\cos\phi_j = \bar{x}_{k0}+\beta G_k \f$, with the reading of `complex.hpp`.
/// @eq{42}  @derivation{paper/section_2_4_time_response}  @domain{sliding regime, Eq. (69)}
/// @param x_k0  displacement at tau = 0
/// @param G_k   second damping function of the mass, Eq. (35)
/// @param beta  friction ratio, Eq. (11)
/// @return      V_dk cos(phi_j)
template <class T>
[[nodiscard]] T V_k_cosine(const T& x_k0, const T& G_k, const T& beta) {
    return x_k0 + beta * G_k;
}

/// @brief \f$ V_{dk}\sin\phi_j = -(\bar{x}_{k0}'+\beta U_{dk}) \f$, with the reading of `complex.hpp`.
/// @eq{43}  @derivation{paper/section_2_4_time_response}  @domain{sliding regime, Eq. (69)}
/// @param x_prime_k0  velocity at tau = 0
/// @param U_dk        first damping function of the mass, Eq. (34)
/// @param beta        friction ratio, Eq. (11)
/// @return            V_dk sin(phi_j)
template <class T>
[[nodiscard]] T V_k_sine(const T& x_prime_k0, const T& U_dk, const T& beta) {
    return -(x_prime_k0 + beta * U_dk);
}

/// @brief Displacement of a mass at the maximum of the displacement of the mass in contact.
/// \f[ \bar{x}_{k0} = -\beta G_k + \frac{|V_{dk}|}{|V_{dj}|}\left[\sqrt{|V_{dj}|^2-(\beta U_{dj})^2}\cos\Delta
///     + \beta U_{dj}\sin\Delta\right], \qquad \Delta = \angle V_{dk}-\angle V_{dj} \f]
/// @eq{44}  @erratum{44}  @derivation{paper/section_2_4_time_response}  @domain{sliding regime, Eq. (69)}
/// @param V_dk  complex response function of the mass, Eq. (33)
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param G_k   second damping function of the mass, Eq. (35)
/// @param beta  friction ratio, Eq. (11)
/// @return      the displacement at tau = 0, in units of P / k_1
template <class T>
[[nodiscard]] T initial_displacement(const Complex<T>& V_dk, const Complex<T>& V_dj, const T& U_dj, const T& G_k, const T& beta) {
    const T Delta = argument(V_dk) - argument(V_dj);
    return -beta * G_k + modulus(V_dk) / modulus(V_dj) * (contact_root(V_dj, U_dj, beta) * cos(Delta) + beta * U_dj * sin(Delta));
}

/// @brief Velocity of a mass at the maximum of the displacement of the mass in contact.
/// \f[ \bar{x}_{k0}' = -\beta U_{dk} + \frac{|V_{dk}|}{|V_{dj}|}\left[\beta U_{dj}\cos\Delta
///     - \sqrt{|V_{dj}|^2-(\beta U_{dj})^2}\sin\Delta\right], \qquad \Delta = \angle V_{dk}-\angle V_{dj} \f]
/// @eq{45}  @erratum{45}  @derivation{paper/section_2_4_time_response}  @domain{sliding regime, Eq. (69)}
/// @param V_dk  complex response function of the mass, Eq. (33)
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param U_dk  first damping function of the mass, Eq. (34)
/// @param beta  friction ratio, Eq. (11)
/// @return      the velocity at tau = 0 with respect to tau, in units of P / k_1
template <class T>
[[nodiscard]] T initial_velocity(const Complex<T>& V_dk, const Complex<T>& V_dj, const T& U_dj, const T& U_dk, const T& beta) {
    const T Delta = argument(V_dk) - argument(V_dj);
    return -beta * U_dk +
           modulus(V_dk) / modulus(V_dj) * (beta * U_dj * cos(Delta) - contact_root(V_dj, U_dj, beta) * sin(Delta));
}

/// @brief Displacement of a mass in the steady state.
/// \f[ \bar{x}_k = \frac{|V_{dk}|}{|V_{dj}|}\left[\sqrt{|V_{dj}|^2-(\beta U_{dj})^2}\cos(\tau+\Delta)
///     + \beta U_{dj}\sin(\tau+\Delta)\right] + \beta\sum_i\psi_{ki}\psi_{ji}R_i^2\{1-(1+g_i)d_i-u_{di}R_i q_i\} \f]
/// @eq{46}  @erratum{46}  @derivation{paper/section_2_4_time_response}  @domain{0 <= tau <= pi, sliding regime, Eq. (69)}
/// @param tau   non-dimensional time, Eq. (5); radians
/// @param V_dk  complex response function of the mass, Eq. (33)
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param beta  friction ratio, Eq. (11)
/// @param F_k   `friction_motion_of_mass` at tau
/// @return      the displacement, in units of P / k_1
template <class T>
[[nodiscard]] T steady_displacement(const T& tau, const Complex<T>& V_dk, const Complex<T>& V_dj, const T& U_dj, const T& beta,
                                    const T& F_k) {
    const T Delta = argument(V_dk) - argument(V_dj);
    return modulus(V_dk) / modulus(V_dj) * (contact_root(V_dj, U_dj, beta) * cos(tau + Delta) + beta * U_dj * sin(tau + Delta)) +
           beta * F_k;
}

/// @brief Phase of a mass from the instant of its largest displacement: \f$ \phi_j+\tau_{k,\max} \f$, plus pi for a minimum.
/// @eq{47}  @derivation{paper/section_2_5_other_masses}  @domain{0 <= tau_k_max <= pi}
/// @param phi_j      phase of the mass in contact, Eq. (39); radians
/// @param tau_k_max  instant of the largest absolute displacement in [0, pi]; radians
/// @param minimum    0 if the displacement is positive there, 1 if it is negative
/// @return           phi_k, radians; wrap it to (-pi, pi]
template <class T>
[[nodiscard]] T phase_of_mass(const T& phi_j, const T& tau_k_max, int minimum) {
    return phi_j + tau_k_max + minimum * pi<T>();
}

} // namespace denhartog::paper
