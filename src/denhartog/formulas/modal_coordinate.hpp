/// @file
/// @brief The motion of one modal coordinate over the half-period: (20), (21), (26), (27), (40), (60), (62), (A.1)-(A.15).
/// @details The half-period \f$ 0 \le \tau \le \pi \f$ runs from a maximum of the displacement of the mass in contact to its
/// minimum. A product of \f$ v_{di} \f$ with \f$ \cos\phi_j \f$ or \f$ \sin\phi_j \f$ is read as in `complex.hpp`.
#pragma once

#include "denhartog/formulas/mode.hpp"

namespace denhartog {

/// @brief A vibrating mode as the mass in contact and the loaded mass see it.
template <class T>
struct ModeInScene {
    T R;      ///< modal frequency ratio, Eq. (22)
    T zeta;   ///< modal damping ratio, Eq. (18)
    T psi_ji; ///< component of the mode shape at the mass in contact, Eq. (17)
    T psi_li; ///< component of the mode shape at the loaded mass, Eq. (17)
};

/// @brief Initial values of a modal coordinate, Eq. (24).
template <class T>
struct InitialValues {
    T eta_0;       ///< displacement at tau = 0
    T eta_prime_0; ///< velocity at tau = 0, with respect to tau
};

/// @brief The constants of the general solution (21).
template <class T>
struct IntegrationConstants {
    T A; ///< factor of the cosine
    T B; ///< factor of the sine
};

/// @brief Coefficients of the two conditions (A.10), Eq. (A.11), with \f$ v_{di} \f$ taken out of the first four.
/// @details The unknowns are \f$ v_{di}\cos\phi_j \f$ and \f$ v_{di}\sin\phi_j \f$, so that the system is real.
template <class T>
struct PhaseSystem {
    T A; ///< factor of v cos(phi_j) in the condition on the displacement
    T B; ///< factor of v sin(phi_j) in the condition on the displacement
    T C; ///< known term of the condition on the displacement
    T P; ///< factor of v cos(phi_j) in the condition on the velocity
    T Q; ///< factor of v sin(phi_j) in the condition on the velocity
    T R; ///< known term of the condition on the velocity
};

namespace paper {

/// @brief Residual of the equation of motion of a modal coordinate; zero for a motion.
/// \f[ \eta_i'' + \frac{2\zeta_i}{R_i}\eta_i' + \frac{1}{R_i^2}\eta_i - \psi_{ji}\beta - \psi_{li}\cos(\tau+\phi_j) \f]
/// @eq{20,A.1}  @derivation{paper/a02_general_solution}  @domain{0 <= tau <= pi}
/// @param eta               modal displacement
/// @param eta_prime         its first derivative in tau
/// @param eta_double_prime  its second derivative in tau
/// @param tau    non-dimensional time, Eq. (5); radians
/// @param m      the mode
/// @param beta   friction ratio, Eq. (11); dimensionless
/// @param phi_j  phase of the force at tau = 0; radians
/// @return       the residual
template <class T>
[[nodiscard]] T modal_equation_residual(const T& eta, const T& eta_prime, const T& eta_double_prime, const T& tau,
                                        const ModeInScene<T>& m, const T& beta, const T& phi_j) {
    const T Omega = 1 / m.R;
    return eta_double_prime + 2 * m.zeta * Omega * eta_prime + Omega * Omega * eta - m.psi_ji * beta -
           m.psi_li * cos(tau + phi_j);
}

/// @brief General solution of (20).
/// \f[ \eta_i = e^{-\zeta_i\tau/R_i}\left[A_i\cos\frac{w\tau}{R_i} + B_i\sin\frac{w\tau}{R_i}\right]
///     + \psi_{ji}R_i^2\beta + \psi_{li}R_i^2 v_{di}\cos(\tau+\phi_j) \f]
/// @eq{21,A.2}  @derivation{paper/a02_general_solution}  @domain{0 <= tau <= pi, R > 0, 0 <= zeta < 1}
/// @param tau    non-dimensional time, Eq. (5); radians
/// @param m      the mode
/// @param c      integration constants, Eq. (A.5)
/// @param beta   friction ratio, Eq. (11); dimensionless
/// @param phi_j  phase of the force at tau = 0; radians
/// @return       eta_i(tau)
template <class T>
[[nodiscard]] T general_solution(const T& tau, const ModeInScene<T>& m, const IntegrationConstants<T>& c, const T& beta,
                                 const T& phi_j) {
    const T w = sqrt(1 - m.zeta * m.zeta);
    const Complex<T> v = complex_response(m.R, m.zeta);
    return exp(-m.zeta * tau / m.R) * (c.A * cos(w * tau / m.R) + c.B * sin(w * tau / m.R)) + m.psi_ji * m.R * m.R * beta +
           m.psi_li * m.R * m.R * times_cosine(v, T(tau + phi_j));
}

/// @brief Integration constants from the initial values.
/// \f[ A_i = \eta_{i0} - \psi_{ji}R_i^2\beta - \psi_{li}R_i^2 v_{di}\cos\phi_j, \qquad
///     B_i = \frac{R_i}{w}\left(\eta_{i0}' + \psi_{li}R_i^2 v_{di}\sin\phi_j\right) + \frac{\zeta_i A_i}{w} \f]
/// @eq{A.5}  @derivation{paper/a05_constants}  @domain{R > 0, 0 <= zeta < 1}
/// @param m      the mode
/// @param start  initial values, Eq. (24)
/// @param beta   friction ratio, Eq. (11); dimensionless
/// @param phi_j  phase of the force at tau = 0; radians
/// @return       A_i and B_i
template <class T>
[[nodiscard]] IntegrationConstants<T> integration_constants(const ModeInScene<T>& m, const InitialValues<T>& start, const T& beta,
                                                            const T& phi_j) {
    const T w = sqrt(1 - m.zeta * m.zeta);
    const Complex<T> v = complex_response(m.R, m.zeta);
    const T A = start.eta_0 - m.psi_ji * m.R * m.R * beta - m.psi_li * m.R * m.R * times_cosine(v, phi_j);
    const T B = m.R / w * (start.eta_prime_0 + m.psi_li * m.R * m.R * times_sine(v, phi_j)) + m.zeta * A / w;
    return {A, B};
}

/// @brief Modal displacement from its initial values.
/// \f[ \eta_i = d_i\eta_{i0} + R_i q_i\eta_{i0}' + \psi_{ji}R_i^2(1-d_i)\beta
///     + \psi_{li}R_i^2 v_{di}\left[(\cos\tau-d_i)\cos\phi_j + (R_i q_i-\sin\tau)\sin\phi_j\right] \f]
/// @eq{A.6}  @derivation{paper/a06_displacement}  @domain{0 <= tau <= pi, R > 0, 0 <= zeta < 1}
/// @param tau    non-dimensional time, Eq. (5); radians
/// @param m      the mode
/// @param start  initial values, Eq. (24)
/// @param beta   friction ratio, Eq. (11); dimensionless
/// @param phi_j  phase of the force at tau = 0; radians
/// @return       eta_i(tau)
template <class T>
[[nodiscard]] T modal_displacement_from_start(const T& tau, const ModeInScene<T>& m, const InitialValues<T>& start, const T& beta,
                                              const T& phi_j) {
    const Complex<T> v = complex_response(m.R, m.zeta);
    const T d_i = d(tau, m.R, m.zeta);
    const T q_i = q(tau, m.R, m.zeta);
    return d_i * start.eta_0 + m.R * q_i * start.eta_prime_0 + m.psi_ji * m.R * m.R * (1 - d_i) * beta +
           m.psi_li * m.R * m.R * ((cos(tau) - d_i) * times_cosine(v, phi_j) + (m.R * q_i - sin(tau)) * times_sine(v, phi_j));
}

/// @brief Modal velocity from the initial values.
/// \f[ \eta_i' = d_i'\eta_{i0} + R_i q_i'\eta_{i0}' - \psi_{ji}R_i^2 d_i'\beta
///     - \psi_{li}R_i^2 v_{di}\left[(\sin\tau+d_i')\cos\phi_j + (\cos\tau-R_i q_i')\sin\phi_j\right] \f]
/// @eq{A.7}  @erratum{A.7}  @derivation{paper/a07_velocity}  @domain{0 <= tau <= pi, R > 0, 0 <= zeta < 1}
/// @param tau    non-dimensional time, Eq. (5); radians
/// @param m      the mode
/// @param start  initial values, Eq. (24)
/// @param beta   friction ratio, Eq. (11); dimensionless
/// @param phi_j  phase of the force at tau = 0; radians
/// @return       eta_i'(tau), derivative with respect to tau
template <class T>
[[nodiscard]] T modal_velocity_from_start(const T& tau, const ModeInScene<T>& m, const InitialValues<T>& start, const T& beta,
                                          const T& phi_j) {
    const Complex<T> v = complex_response(m.R, m.zeta);
    const T dp = d_prime(tau, m.R, m.zeta);
    const T qp = q_prime(tau, m.R, m.zeta);
    return dp * start.eta_0 + m.R * qp * start.eta_prime_0 - m.psi_ji * m.R * m.R * dp * beta -
           m.psi_li * m.R * m.R * ((sin(tau) + dp) * times_cosine(v, phi_j) + (cos(tau) - m.R * qp) * times_sine(v, phi_j));
}

/// @brief Coefficients of the conditions at the end of the half-period, without the common \f$ v_{di} \f$.
/// \f[ \begin{aligned} \mathcal{A} &= -\psi_{li}R_i^2[1+d_i(\pi)], & \mathcal{B} &= \psi_{li}R_i^3 q_i(\pi), &
///     \mathcal{C} &= [1+d_i(\pi)]\eta_{i0} + R_i q_i(\pi)\eta_{i0}' + \psi_{ji}R_i^2[1-d_i(\pi)]\beta \\[2pt]
///     \mathcal{P} &= \psi_{li}R_i q_i(\pi), & \mathcal{Q} &= \psi_{li}R_i^2[1+R_i q_i'(\pi)], &
///     \mathcal{R} &= -\tfrac{q_i(\pi)}{R_i}\eta_{i0}+[1+R_i q_i'(\pi)]\eta_{i0}' + \psi_{ji}R_i q_i(\pi)\beta \end{aligned} \f]
/// @eq{A.11}  @derivation{paper/a10_final_conditions}  @domain{R > 0, 0 <= zeta < 1}
/// @param m      the mode
/// @param start  initial values, Eq. (24)
/// @param beta   friction ratio, Eq. (11); dimensionless
/// @return       the six coefficients
template <class T>
[[nodiscard]] PhaseSystem<T> phase_system(const ModeInScene<T>& m, const InitialValues<T>& start, const T& beta) {
    const T d_pi = d(pi<T>(), m.R, m.zeta);
    const T q_pi = q(pi<T>(), m.R, m.zeta);
    const T qp_pi = q_prime(pi<T>(), m.R, m.zeta);
    return {-m.psi_li * m.R * m.R * (1 + d_pi),
            m.psi_li * m.R * m.R * m.R * q_pi,
            (1 + d_pi) * start.eta_0 + m.R * q_pi * start.eta_prime_0 + m.psi_ji * m.R * m.R * (1 - d_pi) * beta,
            m.psi_li * m.R * q_pi,
            m.psi_li * m.R * m.R * (1 + m.R * qp_pi),
            -q_pi / m.R * start.eta_0 + (1 + m.R * qp_pi) * start.eta_prime_0 + m.psi_ji * m.R * q_pi * beta};
}

/// @brief Residual of the condition on the displacement at \f$ \tau=\pi \f$, \f$ \mathcal{A}c+\mathcal{B}s+\mathcal{C} \f$.
/// @eq{A.10}  @derivation{paper/a10_final_conditions}
/// @param p      coefficients, Eq. (A.11)
/// @param v_cos  v_di cos(phi_j)
/// @param v_sin  v_di sin(phi_j)
/// @return       the residual, zero for the steady state
template <class T>
[[nodiscard]] T final_displacement_residual(const PhaseSystem<T>& p, const T& v_cos, const T& v_sin) {
    return p.A * v_cos + p.B * v_sin + p.C;
}

/// @brief Residual of the condition on the velocity at \f$ \tau=\pi \f$, \f$ \mathcal{P}c+\mathcal{Q}s+\mathcal{R} \f$.
/// @eq{A.10}  @derivation{paper/a10_final_conditions}
/// @param p      coefficients, Eq. (A.11)
/// @param v_cos  v_di cos(phi_j)
/// @param v_sin  v_di sin(phi_j)
/// @return       the residual, zero for the steady state
template <class T>
[[nodiscard]] T final_velocity_residual(const PhaseSystem<T>& p, const T& v_cos, const T& v_sin) {
    return p.P * v_cos + p.Q * v_sin + p.R;
}

/// @brief Solution of (A.10) for the cosine, \f$ (\mathcal{BR}-\mathcal{CQ})/(\mathcal{AQ}-\mathcal{BP}) \f$.
/// @eq{A.12}  @derivation{paper/a12_phase}  @domain{AQ - BP not zero}
/// @param p  coefficients, Eq. (A.11)
/// @return   v_di cos(phi_j)
template <class T>
[[nodiscard]] T v_cosine_from_system(const PhaseSystem<T>& p) {
    return (p.B * p.R - p.C * p.Q) / (p.A * p.Q - p.B * p.P);
}

/// @brief Solution of (A.10) for the sine, \f$ (\mathcal{CP}-\mathcal{AR})/(\mathcal{AQ}-\mathcal{BP}) \f$.
/// @eq{A.12}  @derivation{paper/a12_phase}  @domain{AQ - BP not zero}
/// @param p  coefficients, Eq. (A.11)
/// @return   v_di sin(phi_j)
template <class T>
[[nodiscard]] T v_sine_from_system(const PhaseSystem<T>& p) {
    return (p.C * p.P - p.A * p.R) / (p.A * p.Q - p.B * p.P);
}

/// @brief \f$ v_{di}\cos\phi_j = (\eta_{i0}+\psi_{ji}R_i^2 g_i\beta)/(\psi_{li}R_i^2) \f$.
///
/// With the reading of `complex.hpp` and divided by \f$ |v_{di}| \f$ this is the first line of (60).
/// @eq{26,60,A.13}  @derivation{paper/a12_phase}  @domain{psi_li not zero, R > 0, 0 <= zeta < 1}
/// @param m      the mode
/// @param start  initial values, Eq. (24)
/// @param g      second damping function of the mode, Eq. (29); dimensionless
/// @param beta   friction ratio, Eq. (11); dimensionless
/// @return       v_di cos(phi_j)
template <class T>
[[nodiscard]] T v_cosine(const ModeInScene<T>& m, const InitialValues<T>& start, const T& g, const T& beta) {
    return (start.eta_0 + m.psi_ji * m.R * m.R * g * beta) / (m.psi_li * m.R * m.R);
}

/// @brief \f$ v_{di}\sin\phi_j = -(\eta_{i0}'+\psi_{ji}R_i^2 u_{di}\beta)/(\psi_{li}R_i^2) \f$.
///
/// With the reading of `complex.hpp` and divided by \f$ |v_{di}| \f$ this is the second line of (60).
/// @eq{27,60,A.14}  @derivation{paper/a12_phase}  @domain{psi_li not zero, R > 0, 0 <= zeta < 1}
/// @param m      the mode
/// @param start  initial values, Eq. (24)
/// @param u      first damping function of the mode, Eq. (28); dimensionless
/// @param beta   friction ratio, Eq. (11); dimensionless
/// @return       v_di sin(phi_j)
template <class T>
[[nodiscard]] T v_sine(const ModeInScene<T>& m, const InitialValues<T>& start, const T& u, const T& beta) {
    return -(start.eta_prime_0 + m.psi_ji * m.R * m.R * u * beta) / (m.psi_li * m.R * m.R);
}

/// @brief \f$ \cos\phi_j \f$ from the initial values of one mode.
/// \f[ \cos\phi_j = \frac{\eta_{i0}+\psi_{ji}R_i^2 g_i\beta}{\psi_{li}R_i^2}(1-R_i^2)
///     + \frac{\eta_{i0}'+\psi_{ji}R_i^2 u_{di}\beta}{\psi_{li}R_i^2}(2\zeta_i R_i) \f]
/// @eq{62}  @derivation{paper/section_2_6_domain_of_validity}  @domain{psi_li not zero, R > 0, 0 <= zeta < 1}
/// @param m      the mode
/// @param start  initial values, Eq. (24)
/// @param u      first damping function of the mode, Eq. (28); dimensionless
/// @param g      second damping function of the mode, Eq. (29); dimensionless
/// @param beta   friction ratio, Eq. (11); dimensionless
/// @return       cos(phi_j)
template <class T>
[[nodiscard]] T cosine_of_phase(const ModeInScene<T>& m, const InitialValues<T>& start, const T& u, const T& g, const T& beta) {
    return (start.eta_0 + m.psi_ji * m.R * m.R * g * beta) / (m.psi_li * m.R * m.R) * (1 - m.R * m.R) +
           (start.eta_prime_0 + m.psi_ji * m.R * m.R * u * beta) / (m.psi_li * m.R * m.R) * (2 * m.zeta * m.R);
}

/// @brief Non-harmonic part of a mode's motion under unit friction, the braces of (40).
/// \f[ 1 - (1+g_i)\,d_i(\tau) - u_{di}R_i\,q_i(\tau) \f]
/// @eq{40,41,46,A.15}  @erratum{40}  @derivation{paper/a15_modal_displacement}
/// @domain{0 <= tau <= pi, R > 0, 0 <= zeta < 1}
/// @param tau   non-dimensional time, Eq. (5); radians
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @param zeta  modal damping ratio; dimensionless
/// @param u     first damping function of the mode, Eq. (28); dimensionless
/// @param g     second damping function of the mode, Eq. (29); dimensionless
/// @return      the braces; dimensionless
template <class T>
[[nodiscard]] T friction_motion(const T& tau, const T& R, const T& zeta, const T& u, const T& g) {
    return braces(d(tau, R, zeta), q(tau, R, zeta), R, u, g);
}

/// @brief Rate of `friction_motion`, \f$ (1+g_i)\,q_i/R_i - u_{di}R_i\,q_i' \f$.
/// @eq{40}  @derivation{paper/a15_modal_displacement}  @domain{0 <= tau <= pi, R > 0, 0 <= zeta < 1}
/// @param tau   non-dimensional time, Eq. (5); radians
/// @param R     modal frequency ratio, Eq. (22); dimensionless
/// @param zeta  modal damping ratio; dimensionless
/// @param u     first damping function of the mode, Eq. (28); dimensionless
/// @param g     second damping function of the mode, Eq. (29); dimensionless
/// @return      derivative of the braces with respect to tau; dimensionless
template <class T>
[[nodiscard]] T friction_motion_prime(const T& tau, const T& R, const T& zeta, const T& u, const T& g) {
    return braces_prime(d(tau, R, zeta), q(tau, R, zeta), R, zeta, u, g);
}

/// @brief Modal displacement over the half-period.
/// \f[ \eta_i = (\eta_{i0}+\psi_{ji}R_i^2 g_i\beta)\cos\tau + (\eta_{i0}'+\psi_{ji}R_i^2 u_{di}\beta)\sin\tau
///     + \beta\psi_{ji}R_i^2\left\{1 - (1+g_i)d_i(\tau) - u_{di}R_i q_i(\tau)\right\} \f]
/// @eq{40,A.15}  @erratum{40}  @derivation{paper/a15_modal_displacement}  @domain{0 <= tau <= pi, R > 0, 0 <= zeta < 1}
/// @param tau    non-dimensional time, Eq. (5); radians
/// @param m      the mode
/// @param start  initial values, Eq. (24)
/// @param u      first damping function of the mode, Eq. (28); dimensionless
/// @param g      second damping function of the mode, Eq. (29); dimensionless
/// @param beta   friction ratio, Eq. (11); dimensionless
/// @return       eta_i(tau)
template <class T>
[[nodiscard]] T modal_displacement(const T& tau, const ModeInScene<T>& m, const InitialValues<T>& start, const T& u, const T& g,
                                   const T& beta) {
    return (start.eta_0 + m.psi_ji * m.R * m.R * g * beta) * cos(tau) +
           (start.eta_prime_0 + m.psi_ji * m.R * m.R * u * beta) * sin(tau) +
           beta * m.psi_ji * m.R * m.R * friction_motion(tau, m.R, m.zeta, u, g);
}

} // namespace paper
} // namespace denhartog
