/// @file
/// @brief Forms of (44), (45) without an angle, for which a node (a mass with no response function) is no exception.
///
/// V_dk, U_dk, G_k are (33)-(35) of a mass, with j those of the mass in contact, and beta is the friction ratio (11).
#pragma once

#include <span>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/evaluation/mode_values.hpp"

namespace denhartog::evaluation {

/// @brief Displacement and velocity of a mass at the maximum of the displacement of the mass in contact.
template <class T>
struct InitialState {
    T x_k0;       ///< displacement, Eq. (44)
    T x_prime_k0; ///< velocity with respect to tau, Eq. (45)
};

/// @brief The harmonic part of the motion of a mass: \f$ A\cos\tau + B\sin\tau \f$.
template <class T>
struct HarmonicPart {
    T A; ///< factor of the cosine
    T B; ///< factor of the sine
};

/// @brief Displacement of a mass with its first two derivatives in tau.
template <class T>
struct MotionOfMass {
    T x;              ///< displacement, Eq. (46)
    T x_prime;        ///< velocity
    T x_double_prime; ///< acceleration
};

/// @brief The harmonic part of (46) as corrected, with \f$ |V_{dk}|\cos\Delta/|V_{dj}| \f$ as
/// \f$ \mathrm{Re}\{V_{dk}V_{dj}^*\}/|V_{dj}|^2 \f$.
/// @eq{42,43,46}  @derivation{forms/evaluation_forms}  @domain{sliding regime, Eq. (69); V_dj not zero}
template <class T>
[[nodiscard]] HarmonicPart<T> harmonic_part(const Complex<T>& V_dk, const Complex<T>& V_dj, const T& U_dj, const T& beta) {
    const T root = contact_root(V_dj, U_dj, beta);
    const T square = squared_modulus(V_dj);
    const T cosine = (V_dk.re * V_dj.re + V_dk.im * V_dj.im) / square;
    const T sine = (V_dk.im * V_dj.re - V_dk.re * V_dj.im) / square;
    return {root * cosine + beta * U_dj * sine, beta * U_dj * cosine - root * sine};
}

/// @brief (44) and (45) as corrected: the harmonic part less what friction has of it at tau = 0.
/// @eq{44,45}  @derivation{forms/evaluation_forms}  @domain{sliding regime, Eq. (69); V_dj not zero}
/// @return x_k0 and x'_k0, in units of P / k_1
template <class T>
[[nodiscard]] InitialState<T> initial_state(const Complex<T>& V_dk, const Complex<T>& V_dj, const T& U_dj, const T& U_dk,
                                            const T& G_k, const T& beta) {
    const HarmonicPart<T> h = harmonic_part(V_dk, V_dj, U_dj, beta);
    return {h.A - beta * G_k, h.B - beta * U_dk};
}

/// @brief Motion of a mass over the half-period: (46) as corrected, with (40) from the motions of the modes, and its derivatives.
/// @eq{40,46}  @derivation{forms/evaluation_of_motion}  @domain{sliding regime, Eq. (69); 0 <= tau <= pi}
/// @param C     cosine of the non-dimensional time tau, which is zero at a maximum of x_j
/// @param S     sine of tau
/// @param h     the harmonic part
/// @param beta  friction ratio, Eq. (11)
/// @param w     weights psi_ki psi_ji R_i^2 of the modes in (40)
/// @param y     braces of (40) of the modes at tau, and their derivatives
/// @param so_far  weighted sums over the modes before these
/// @return      displacement, velocity, acceleration, in units of P / k_1
template <class T>
[[nodiscard]] MotionOfMass<T> motion_of_mass(const T& C, const T& S, const HarmonicPart<T>& h, const T& beta,
                                             std::span<const T> w, std::span<const FrictionMotion<T>> y,
                                             const FrictionMotion<T>& so_far = {T(0), T(0), T(0)}) {
    T F_k = so_far.value, F_prime = so_far.prime, F_double_prime = so_far.double_prime;
    for (std::size_t i = 0; i < y.size(); ++i) {
        F_k = F_k + w[i] * y[i].value;
        F_prime = F_prime + w[i] * y[i].prime;
        F_double_prime = F_double_prime + w[i] * y[i].double_prime;
    }
    return {h.A * C + h.B * S + beta * F_k, h.B * C - h.A * S + beta * F_prime, beta * F_double_prime - h.A * C - h.B * S};
}

} // namespace denhartog::evaluation
