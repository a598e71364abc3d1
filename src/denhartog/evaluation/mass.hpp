/// @file
/// @brief What callers get for (44), (45): no angle is formed, and a node (a mass with no response function) is no exception.
#pragma once

#include "denhartog/evaluation/contact.hpp"

namespace denhartog::evaluation {

/// @brief Displacement and velocity of a mass at the maximum of the displacement of the mass in contact.
template <class T>
struct InitialState {
    T x_k0;       ///< displacement, Eq. (44)
    T x_prime_k0; ///< velocity with respect to tau, Eq. (45)
};

/// @brief (44) and (45) as corrected, with \f$ |V_{dk}|\cos\Delta/|V_{dj}| \f$ as \f$ \mathrm{Re}\{V_{dk}V_{dj}^*\}/|V_{dj}|^2 \f$.
/// @eq{44,45}  @derivation{evaluation_forms}  @domain{sliding regime, Eq. (69); V_dj not zero}
/// @param V_dk  complex response function of the mass, Eq. (33)
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param U_dk  first damping function of the mass, Eq. (34)
/// @param G_k   second damping function of the mass, Eq. (35)
/// @param beta  friction ratio, Eq. (11)
/// @return      x_k0 and x'_k0, in units of P / k_1
template <class T>
[[nodiscard]] InitialState<T> initial_state(const Complex<T>& V_dk, const Complex<T>& V_dj, const T& U_dj, const T& U_dk,
                                            const T& G_k, const T& beta) {
    const T root = contact_root(V_dj, U_dj, beta);
    const T square = squared_modulus(V_dj);
    const T cosine = (V_dk.re * V_dj.re + V_dk.im * V_dj.im) / square;
    const T sine = (V_dk.im * V_dj.re - V_dk.re * V_dj.im) / square;
    return {root * cosine + beta * U_dj * sine - beta * G_k, beta * U_dj * cosine - root * sine - beta * U_dk};
}

} // namespace denhartog::evaluation
