/// @file
/// @brief The functions of one vibrating mode: (21)-(23), (28), (29), (61), (71), (A.8), (A.9).
///
/// Throughout \f$ w = \sqrt{1-\zeta^2} \f$ (a symbol of ours); 0 <= zeta < 1 and R > 0.
#pragma once

#include "denhartog/formulas/complex.hpp"

namespace denhartog::paper {

/// @brief Modal frequency ratio \f$ R_i = 1/\Omega_i = \omega/\omega_i \f$.
/// @eq{22}  @derivation{paper/a02_general_solution}  @domain{Omega > 0}
/// @param Omega  non-dimensional natural frequency of the mode, Eq. (15); dimensionless
/// @return       R_i; dimensionless
template <class T>
[[nodiscard]] T modal_frequency_ratio(const T& Omega) {
    return 1 / Omega;
}

/// @brief Complex response function \f$ v_{di} \f$ of a vibrating mode.
/// \f[ v_{di} = \frac{1}{1 - R_i^2 + i\,2\zeta_i R_i} \f]
/// The response of the mode to a unit harmonic load without Coulomb damping.
/// @eq{23}  @derivation{paper/a02_general_solution}  @domain{R > 0, 0 <= zeta < 1; at zeta = 0 a pole at R = 1}
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @param zeta  modal damping ratio; dimensionless
/// @return      v_di, complex; dimensionless
template <class T>
[[nodiscard]] Complex<T> complex_response(const T& R, const T& zeta) {
    const T a = 1 - R * R;
    const T b = 2 * zeta * R;
    return {a / (a * a + b * b), -b / (a * a + b * b)};
}

/// @brief First damping function \f$ u_{di} \f$ of a vibrating mode.
/// \f[ u_{di} = \frac{\sin\theta}{R_i\,w\,(\cosh\delta + \cos\theta)}, \qquad
///     \theta = \pi w / R_i,\quad \delta = \pi\zeta_i / R_i \f]
/// It multiplies the friction ratio in Eq. (27): how much the contact delays this mode.
/// @eq{28}  @derivation{paper/a12_phase}  @domain{R > 0, 0 <= zeta < 1; at zeta = 0 a pole at every R = 1/n, n odd}
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @param zeta  modal damping ratio; dimensionless
/// @return      u_di; dimensionless
template <class T>
[[nodiscard]] T first_damping_function(const T& R, const T& zeta) {
    const T w = sqrt(1 - zeta * zeta);
    const T theta = pi<T>() * w / R;
    const T delta = pi<T>() * zeta / R;
    return sin(theta) / (R * w * (cosh(delta) + cos(theta)));
}

/// @brief Second damping function \f$ g_i \f$ of a vibrating mode.
/// \f[ g_i = \frac{\sinh\delta - \frac{\zeta_i}{w}\sin\theta}{\cosh\delta + \cos\theta}, \qquad
///     \theta = \pi w / R_i,\quad \delta = \pi\zeta_i / R_i \f]
/// It multiplies the friction ratio in Eq. (26): how much the contact shrinks this mode. Zero without damping, never negative.
/// @eq{29}  @derivation{paper/a12_phase}  @domain{R > 0, 0 <= zeta < 1; at zeta = 0 undefined at every R = 1/n, n odd}
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @param zeta  modal damping ratio; dimensionless
/// @return      g_i; dimensionless
template <class T>
[[nodiscard]] T second_damping_function(const T& R, const T& zeta) {
    const T w = sqrt(1 - zeta * zeta);
    const T theta = pi<T>() * w / R;
    const T delta = pi<T>() * zeta / R;
    return (sinh(delta) - zeta / w * sin(theta)) / (cosh(delta) + cos(theta));
}

/// @brief Free motion from unit displacement, \f$ d_i(\tau) \f$.
/// \f[ d_i = e^{-\zeta_i\tau/R_i}\left[\cos\frac{w\tau}{R_i} + \frac{\zeta_i}{w}\sin\frac{w\tau}{R_i}\right] \f]
/// @eq{A.8}  @derivation{paper/a06_displacement}  @domain{R > 0, 0 <= zeta < 1}
/// @param tau   non-dimensional time, Eq. (5); radians
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @param zeta  modal damping ratio; dimensionless
/// @return      d_i(tau); dimensionless
template <class T>
[[nodiscard]] T d(const T& tau, const T& R, const T& zeta) {
    const T w = sqrt(1 - zeta * zeta);
    return exp(-zeta * tau / R) * (cos(w * tau / R) + zeta / w * sin(w * tau / R));
}

/// @brief Free motion from unit velocity over \f$ R_i \f$, \f$ q_i(\tau) \f$.
/// \f[ q_i = \frac{1}{w}\,e^{-\zeta_i\tau/R_i}\sin\frac{w\tau}{R_i} \f]
/// @eq{A.8}  @derivation{paper/a06_displacement}  @domain{R > 0, 0 <= zeta < 1}
/// @param tau   non-dimensional time, Eq. (5); radians
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @param zeta  modal damping ratio; dimensionless
/// @return      q_i(tau); dimensionless
template <class T>
[[nodiscard]] T q(const T& tau, const T& R, const T& zeta) {
    const T w = sqrt(1 - zeta * zeta);
    return exp(-zeta * tau / R) * sin(w * tau / R) / w;
}

/// @brief Rate of \f$ d_i \f$: \f$ d_i' = -q_i/R_i \f$.
/// @eq{A.9}  @derivation{paper/a07_velocity}  @domain{R > 0, 0 <= zeta < 1}
/// @param tau   non-dimensional time, Eq. (5); radians
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @param zeta  modal damping ratio; dimensionless
/// @return      d_i'(tau); dimensionless
template <class T>
[[nodiscard]] T d_prime(const T& tau, const T& R, const T& zeta) {
    return -q(tau, R, zeta) / R;
}

/// @brief Rate of \f$ q_i \f$.
/// \f[ q_i' = \frac{1}{R_i}\,e^{-\zeta_i\tau/R_i}\left[\cos\frac{w\tau}{R_i} - \frac{\zeta_i}{w}\sin\frac{w\tau}{R_i}\right] \f]
/// @eq{A.9}  @derivation{paper/a07_velocity}  @domain{R > 0, 0 <= zeta < 1}
/// @param tau   non-dimensional time, Eq. (5); radians
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @param zeta  modal damping ratio; dimensionless
/// @return      q_i'(tau); dimensionless
template <class T>
[[nodiscard]] T q_prime(const T& tau, const T& R, const T& zeta) {
    const T w = sqrt(1 - zeta * zeta);
    return exp(-zeta * tau / R) * (cos(w * tau / R) - zeta / w * sin(w * tau / R)) / R;
}

/// @brief The braces of (40), from the free motions at an instant.
/// \f[ 1 - (1+g_i)\,d_i - u_{di}R_i\,q_i \f]
/// @eq{40,A.15}  @derivation{paper/a15_modal_displacement}  @domain{R > 0}
/// @param d_i   free motion from unit displacement, Eq. (A.8); dimensionless
/// @param q_i   free motion from unit velocity over R, Eq. (A.8); dimensionless
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @param u     first damping function of the mode, Eq. (28); dimensionless
/// @param g     second damping function of the mode, Eq. (29); dimensionless
/// @return      the braces; dimensionless
template <class T>
[[nodiscard]] T braces(const T& d_i, const T& q_i, const T& R, const T& u, const T& g) {
    return 1 - (1 + g) * d_i - u * R * q_i;
}

/// @brief Rate of `braces`.
/// \f[ (1+g_i)\,\frac{q_i}{R_i} - u_{di}R_i\,q_i', \qquad R_i\,q_i' = d_i - 2\zeta_i q_i \f]
/// @eq{40}  @derivation{paper/a15_modal_displacement}  @domain{R > 0}
/// @param d_i   free motion from unit displacement, Eq. (A.8); dimensionless
/// @param q_i   free motion from unit velocity over R, Eq. (A.8); dimensionless
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @param zeta  modal damping ratio; dimensionless
/// @param u     first damping function of the mode, Eq. (28); dimensionless
/// @param g     second damping function of the mode, Eq. (29); dimensionless
/// @return      derivative of the braces with respect to tau; dimensionless
template <class T>
[[nodiscard]] T braces_prime(const T& d_i, const T& q_i, const T& R, const T& zeta, const T& u, const T& g) {
    return (1 + g) * q_i / R - u * (d_i - 2 * zeta * q_i);
}

/// @brief Cosine of the argument of \f$ v_{di} \f$: \f$ |v_{di}|(1-R_i^2) \f$.
/// @eq{61}  @derivation{paper/section_2_6_domain_of_validity}  @domain{R > 0, 0 <= zeta < 1}
/// @param v     complex response function of the mode, Eq. (23)
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @return      cosine of the argument of v; dimensionless
template <class T>
[[nodiscard]] T cosine_of_response_argument(const Complex<T>& v, const T& R) {
    return modulus(v) * (1 - R * R);
}

/// @brief Sine of the argument of \f$ v_{di} \f$: \f$ -|v_{di}|\,2\zeta_i R_i \f$.
/// @eq{61}  @derivation{paper/section_2_6_domain_of_validity}  @domain{R > 0, 0 <= zeta < 1}
/// @param v     complex response function of the mode, Eq. (23)
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @param zeta  modal damping ratio; dimensionless
/// @return      sine of the argument of v; dimensionless
template <class T>
[[nodiscard]] T sine_of_response_argument(const Complex<T>& v, const T& R, const T& zeta) {
    return -modulus(v) * (2 * zeta * R);
}

/// @brief The function of time whose maximum over (0, pi) is \f$ s_{di} \f$.
/// \f[ \frac{1}{\sin\tau}\left\{(1+g_i)R_i\,q_i(\tau) - u_{di}R_i^2\left[R_i q_i'(\tau) - \cos\tau\right]\right\} \f]
/// The contact keeps sliding in mode i if the amplitude exceeds the friction ratio times this.
/// @eq{57}  @erratum{57}  @derivation{paper/section_2_6_domain_of_validity}  @domain{0 < tau < pi, R > 0, 0 <= zeta < 1}
/// @param tau   non-dimensional time, Eq. (5); radians
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @param zeta  modal damping ratio; dimensionless
/// @param u     first damping function of the mode, Eq. (28); dimensionless
/// @param g     second damping function of the mode, Eq. (29); dimensionless
/// @return      the expression under the maximum; dimensionless
template <class T>
[[nodiscard]] T s_d_integrand(const T& tau, const T& R, const T& zeta, const T& u, const T& g) {
    return ((1 + g) * R * q(tau, R, zeta) - u * R * R * (R * q_prime(tau, R, zeta) - cos(tau))) / sin(tau);
}

/// @brief \f$ s_{di} \f$ near the maximum of the displacement, to first order in \f$ \tau \f$ within the braces.
/// \f[ \frac{1}{\tau}\left\{(1+g_i)\left(1-\frac{\zeta_i\tau}{R_i}\right)\tau
///     - u_{di}R_i^2\left[\left(1-\frac{\zeta_i\tau}{R_i}\right)^2 - 1\right]\right\} \f]
/// @eq{70}  @erratum{70}  @derivation{paper/section_2_6_domain_of_validity}  @domain{0 < tau << 1; error O(tau)}
/// @param tau   non-dimensional time, Eq. (5); radians
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @param zeta  modal damping ratio; dimensionless
/// @param u     first damping function of the mode, Eq. (28); dimensionless
/// @param g     second damping function of the mode, Eq. (29); dimensionless
/// @return      the expansion; dimensionless
template <class T>
[[nodiscard]] T s_d_expansion(const T& tau, const T& R, const T& zeta, const T& u, const T& g) {
    const T a = 1 - zeta * tau / R;
    return ((1 + g) * a * tau - u * R * R * (a * a - 1)) / tau;
}

/// @brief Value of the expression in (57) for \f$ \tau \to 0 \f$: \f$ 1 + g_i + 2\zeta_i R_i u_{di} \f$.
/// @eq{71}  @derivation{paper/section_2_6_domain_of_validity}
/// @domain{R > 0, 0 <= zeta < 1; equal to s_di where the maximum lies at tau = 0, a lower bound of it everywhere}
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @param zeta  modal damping ratio; dimensionless
/// @param u     first damping function of the mode, Eq. (28); dimensionless
/// @param g     second damping function of the mode, Eq. (29); dimensionless
/// @return      the limit; dimensionless
template <class T>
[[nodiscard]] T s_d_at_zero(const T& R, const T& zeta, const T& u, const T& g) {
    return 1 + g + 2 * zeta * R * u;
}

} // namespace denhartog::paper
