/// @file
/// @brief Equations exactly as the text at hand prints them, where the derivation refutes them.
///
/// For the derivation, the tests, the figures and the conformance kit only; nothing that answers a question includes this file.
/// Each function bears the name and the parameters of its correct counterpart.
#pragma once

#include <cstddef>
#include <span>

#include "denhartog/formulas/boundary.hpp"
#include "denhartog/formulas/motion.hpp"
#include "denhartog/formulas/resonance.hpp"
#include "denhartog/formulas/system.hpp"

namespace denhartog::as_printed {

/// @brief (2) with the displacement under sgn. @eq{2}
/// @param F      kinetic friction force @param sgn_x sign of the displacement of the mass in contact
/// @return       the force as printed
template <class T>
[[nodiscard]] T friction_force(const T& F, const T& sgn_x) {
    return -F * sgn_x;
}

/// @brief (4) with one unit vector for load and friction: entry of what stands on the left minus the right. @eq{4}
/// @param linear  entry of M x'' + C x' + K x
/// @param e_i     entry of the one unit vector
/// @param F       kinetic friction force @param sgn sign of the velocity of the mass in contact
/// @param load    P cos(omega t)
/// @return        the residual of the equation as printed
template <class T>
[[nodiscard]] T equation_of_motion_residual(const T& linear, const T& e_i, const T& F, const T& sgn, const T& load) {
    return linear + F * e_i * sgn - load * e_i;
}

/// @brief (5) with the stiffness ratio kappa_1 = 1 in place of k_1. @eq{5}
/// @param x        displacement @param kappa_1 first stiffness ratio @param P amplitude of the load
/// @return         the displacement as printed
template <class T>
[[nodiscard]] T non_dimensional_displacement(const T& x, const T& kappa_1, const T& P) {
    return kappa_1 * x / P;
}

/// @brief Right side of (16) with one row of the modal matrix for contact and load. @eq{16}
/// @param psi_i  entry of the one vector @param beta friction ratio @param load cos(tau + phi_j)
/// @return       the modal load as printed
template <class T>
[[nodiscard]] T modal_load(const T& psi_i, const T& beta, const T& load) {
    return psi_i * beta + psi_i * load;
}

/// @brief The braces of (40), (41), (46) and (A.15): sine and cosine exchanged in the bracket. @eq{40,41,46,A.15}
/// @param tau   non-dimensional time @param R modal frequency ratio @param zeta modal damping ratio
/// @param u     first damping function of the mode @param g second damping function of the mode
/// @return      the braces as printed
template <class T>
[[nodiscard]] T friction_motion(const T& tau, const T& R, const T& zeta, const T& u, const T& g) {
    const T w = sqrt(1 - zeta * zeta);
    const T e = exp(-zeta * tau / R);
    return 1 - (1 + g) * e * (sin(w * tau / R) + zeta / w * cos(w * tau / R)) - u * R / w * e * sin(w * tau / R);
}

/// @brief (40) and (A.15). @eq{40,A.15}
/// @param tau  non-dimensional time @param m the mode @param start initial values
/// @param u    first damping function of the mode @param g second damping function of the mode @param beta friction ratio
/// @return     the modal displacement as printed
template <class T>
[[nodiscard]] T modal_displacement(const T& tau, const ModeInScene<T>& m, const InitialValues<T>& start, const T& u, const T& g,
                                   const T& beta) {
    return (start.eta_0 + m.psi_ji * m.R * m.R * g * beta) * cos(tau) +
           (start.eta_prime_0 + m.psi_ji * m.R * m.R * u * beta) * sin(tau) +
           beta * m.psi_ji * m.R * m.R * friction_motion(tau, m.R, m.zeta, u, g);
}

/// @brief The sum in (41) and (46). @eq{41,46}
/// @param tau    non-dimensional time @param psi_k mode shapes at the mass k @param psi_j mode shapes at the mass in contact
/// @param R      modal frequency ratios @param zeta modal damping ratios
/// @param u      first damping functions of the modes @param g second damping functions of the modes
/// @return       the sum as printed
template <class T>
[[nodiscard]] T friction_motion_of_mass(const T& tau, std::span<const T> psi_k, std::span<const T> psi_j, std::span<const T> R,
                                        std::span<const T> zeta, std::span<const T> u, std::span<const T> g) {
    T sum(0);
    for (std::size_t i = 0; i < R.size(); ++i)
        sum = sum + psi_k[i] * psi_j[i] * R[i] * R[i] * friction_motion(tau, R[i], zeta[i], u[i], g[i]);
    return sum;
}

/// @brief Real part of (44). @eq{44}
/// @param V_dk  complex response function of the mass @param V_dj that of the mass in contact
/// @param U_dj  first damping function of the mass in contact @param G_k second damping function of the mass
/// @param beta  friction ratio
/// @return      the displacement at tau = 0 as printed
template <class T>
[[nodiscard]] T initial_displacement(const Complex<T>& V_dk, const Complex<T>& V_dj, const T& U_dj, const T& G_k,
                                     const T& beta) {
    const T Delta = argument(V_dk) - argument(V_dj);
    return -beta * G_k + modulus(V_dk) / modulus(V_dj) * paper::contact_root(V_dj, U_dj, beta) * cos(Delta);
}

/// @brief Real part of (45). @eq{45}
/// @param V_dk  complex response function of the mass @param V_dj that of the mass in contact
/// @param U_dj  first damping function of the mass in contact @param U_dk that of the mass @param beta friction ratio
/// @return      the velocity at tau = 0 as printed
template <class T>
[[nodiscard]] T initial_velocity(const Complex<T>& V_dk, const Complex<T>& V_dj, const T& U_dj, const T& U_dk, const T& beta) {
    const T Delta = argument(V_dk) - argument(V_dj);
    return beta * (modulus(V_dk) / modulus(V_dj) * U_dj * cos(Delta) - U_dk);
}

/// @brief (50): the ratio of the moduli multiplies the first term only. @eq{50}
/// @param V_dk  complex response function of the mass @param V_dj that of the mass in contact
/// @param U_dj  first damping function of the mass in contact @param G_k second damping function of the mass
/// @param beta  friction ratio
/// @return      X_kC as printed
template <class T>
[[nodiscard]] T monoharmonic_cosine(const Complex<T>& V_dk, const Complex<T>& V_dj, const T& U_dj, const T& G_k,
                                    const T& beta) {
    const T Delta = argument(V_dk) - argument(V_dj);
    return modulus(V_dk) / modulus(V_dj) * paper::contact_root(V_dj, U_dj, beta) * cos(Delta) + beta * U_dj * sin(Delta) -
           beta * G_k;
}

/// @brief (52): the sign of \f$ U_{dk}\sin\Delta \f$. @eq{52}
/// @param V_dk  complex response function of the mass @param V_dj that of the mass in contact
/// @param U_dj  first damping function of the mass in contact @param U_dk that of the mass
/// @param G_k   second damping function of the mass @param beta friction ratio
/// @return      the monoharmonic amplitude as printed
template <class T>
[[nodiscard]] T displacement_transmissibility(const Complex<T>& V_dk, const Complex<T>& V_dj, const T& U_dj, const T& U_dk,
                                              const T& G_k, const T& beta) {
    const T Delta = argument(V_dk) - argument(V_dj);
    return sqrt(squared_modulus(V_dk) + beta * beta * (G_k * G_k + U_dk * U_dk) -
                2 * beta * (modulus(V_dk) / modulus(V_dj)) *
                    (paper::contact_root(V_dj, U_dj, beta) * (G_k * cos(Delta) + U_dk * sin(Delta)) +
                     beta * U_dj * (G_k * sin(Delta) + U_dk * cos(Delta))));
}

/// @brief The expression under the maximum of (57): another bracket, and no \f$ \cos\tau \f$. @eq{57}
/// @param tau   non-dimensional time @param R modal frequency ratio @param zeta modal damping ratio
/// @param u     first damping function of the mode @param g second damping function of the mode
/// @return      the expression as printed
template <class T>
[[nodiscard]] T s_d_integrand(const T& tau, const T& R, const T& zeta, const T& u, const T& g) {
    const T w = sqrt(1 - zeta * zeta);
    const T e = exp(-zeta * tau / R);
    return ((1 + g) * e * R / w * sin(w * tau / R) -
            u * R * R * e * (sin(w * tau / R) + zeta / w * cos(w * tau / R))) /
           sin(tau);
}

/// @brief (70): the bracket with the opposite sign. @eq{70}
/// @param tau   non-dimensional time @param R modal frequency ratio @param zeta modal damping ratio
/// @param u     first damping function of the mode @param g second damping function of the mode
/// @return      the expansion as printed
template <class T>
[[nodiscard]] T s_d_expansion(const T& tau, const T& R, const T& zeta, const T& u, const T& g) {
    const T a = 1 - zeta * tau / R;
    return ((1 + g) * a * tau - u * R * R * (1 - a * a)) / tau;
}

/// @brief (81): the product of the first damping functions with another sign, without \f$ 2\beta\psi_{ki}/\psi_{ji} \f$. @eq{81}
/// @param V_k_abs  amplitude of the complex response function of the mass @param U_k its first damping function
/// @param U_j      first damping function of the mass in contact @param G_k second damping function of the mass
/// @param beta     friction ratio
/// @return         the amplitude at resonance as printed
template <class T>
[[nodiscard]] T transmissibility_at_resonance(const T& V_k_abs, const T& U_k, const T& U_j, const T& G_k, const T& beta) {
    return sqrt(T(V_k_abs * V_k_abs + beta * beta * (G_k * G_k + U_k * U_k) -
                  beta * (2 * V_k_abs * paper::magnitude(G_k) - paper::magnitude(U_j) * paper::magnitude(U_k))));
}

/// @brief (82) with the complex \f$ V_{dk} \f$ in place of its modulus. @eq{82}
/// @param V_k   complex response function of the mass @param G_k second damping function of the mass @param beta friction ratio
/// @return      the amplitude at resonance as printed
template <class T>
[[nodiscard]] T transmissibility_at_resonance_without_U(const Complex<T>& V_k, const T& G_k, const T& beta) {
    return modulus(Complex<T>{V_k.re - beta * paper::magnitude(G_k), V_k.im});
}

/// @brief (86) for j = l with \f$ \mu \f$ in place of its square. @eq{86} @param mu ratio of static to kinetic friction
/// @return  the friction ratio as printed
template <class T>
[[nodiscard]] T friction_ratio_limit_at_high_frequency(const T& mu) {
    return 2 / sqrt(T(4 * mu + pi<T>() * pi<T>()));
}

/// @brief (A.7): the sign of the first term. @eq{A.7}
/// @param tau    non-dimensional time @param m the mode @param start initial values
/// @param beta   friction ratio @param phi_j phase of the force at tau = 0
/// @return       the modal velocity as printed
template <class T>
[[nodiscard]] T modal_velocity_from_start(const T& tau, const ModeInScene<T>& m, const InitialValues<T>& start, const T& beta,
                                          const T& phi_j) {
    const Complex<T> v = paper::complex_response(m.R, m.zeta);
    const T dp = paper::d_prime(tau, m.R, m.zeta);
    const T qp = paper::q_prime(tau, m.R, m.zeta);
    return -dp * start.eta_0 + m.R * qp * start.eta_prime_0 - m.psi_ji * m.R * m.R * dp * beta -
           m.psi_li * m.R * m.R * ((sin(tau) + dp) * times_cosine(v, phi_j) + (cos(tau) - m.R * qp) * times_sine(v, phi_j));
}

/// @brief (A.12) with the natural frequency in place of the coefficient Q: the cosine. @eq{A.12}
/// @param p      coefficients, Eq. (A.11) @param Omega natural frequency of the mode
/// @return       v_di cos(phi_j) as printed
template <class T>
[[nodiscard]] T v_cosine_from_system(const PhaseSystem<T>& p, const T& Omega) {
    return (p.B * p.R - p.C * Omega) / (p.A * Omega - p.B * p.P);
}

} // namespace denhartog::as_printed
