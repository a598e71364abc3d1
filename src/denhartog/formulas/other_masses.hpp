/// @file
/// @brief Amplitude and phase of the masses not in contact, monoharmonic approximation: (48)-(53).
#pragma once

#include "denhartog/formulas/contact.hpp"

namespace denhartog::paper {

/// @brief Monoharmonic approximation of a displacement, \f$ \bar{x}_{k0}\cos\tau + \bar{x}_{k0}'\sin\tau \f$.
/// @eq{48,49}  @derivation{paper/section_2_5_other_masses}
/// @domain{sliding regime; exact at tau = 0 and pi, error of first order in beta between}
/// @param tau         non-dimensional time, Eq. (5); radians
/// @param x_k0        displacement at tau = 0, Eq. (44)
/// @param x_prime_k0  velocity at tau = 0, Eq. (45)
/// @return            the approximate displacement, in units of P / k_1
template <class T>
[[nodiscard]] T monoharmonic_displacement(const T& tau, const T& x_k0, const T& x_prime_k0) {
    return x_k0 * cos(tau) + x_prime_k0 * sin(tau);
}

/// @brief Factor of \f$ \cos\tau \f$ in (49).
/// \f[ \overline{X}_{k_C} = \frac{|V_{dk}|}{|V_{dj}|}\left[\sqrt{|V_{dj}|^2-(\beta U_{dj})^2}\cos\Delta
///     + \beta U_{dj}\sin\Delta\right] - \beta G_k, \qquad \Delta = \angle V_{dk}-\angle V_{dj} \f]
/// @eq{50}  @erratum{50}  @derivation{paper/section_2_5_other_masses}  @domain{sliding regime, Eq. (69)}
/// @param V_dk  complex response function of the mass, Eq. (33)
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param G_k   second damping function of the mass, Eq. (35)
/// @param beta  friction ratio, Eq. (11)
/// @return      X_kC, in units of P / k_1
template <class T>
[[nodiscard]] T monoharmonic_cosine(const Complex<T>& V_dk, const Complex<T>& V_dj, const T& U_dj, const T& G_k,
                                    const T& beta) {
    const T Delta = argument(V_dk) - argument(V_dj);
    return modulus(V_dk) / modulus(V_dj) * (contact_root(V_dj, U_dj, beta) * cos(Delta) + beta * U_dj * sin(Delta)) -
           beta * G_k;
}

/// @brief Factor of \f$ \sin\tau \f$ in (49).
/// \f[ \overline{X}_{k_S} = \frac{|V_{dk}|}{|V_{dj}|}\left[\beta U_{dj}\cos\Delta
///     - \sqrt{|V_{dj}|^2-(\beta U_{dj})^2}\sin\Delta\right] - \beta U_{dk}, \qquad \Delta = \angle V_{dk}-\angle V_{dj} \f]
/// @eq{51}  @derivation{paper/section_2_5_other_masses}  @domain{sliding regime, Eq. (69)}
/// @param V_dk  complex response function of the mass, Eq. (33)
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param U_dk  first damping function of the mass, Eq. (34)
/// @param beta  friction ratio, Eq. (11)
/// @return      X_kS, in units of P / k_1
template <class T>
[[nodiscard]] T monoharmonic_sine(const Complex<T>& V_dk, const Complex<T>& V_dj, const T& U_dj, const T& U_dk, const T& beta) {
    const T Delta = argument(V_dk) - argument(V_dj);
    return modulus(V_dk) / modulus(V_dj) * (beta * U_dj * cos(Delta) - contact_root(V_dj, U_dj, beta) * sin(Delta)) -
           beta * U_dk;
}

/// @brief Monoharmonic displacement transmissibility of a mass.
/// \f[ \overline{X}_k \cong \Big\{|V_{dk}|^2 + \beta^2(G_k^2+U_{dk}^2) - 2\beta\frac{|V_{dk}|}{|V_{dj}|}\Big[
///     \sqrt{|V_{dj}|^2-(\beta U_{dj})^2}\,(G_k\cos\Delta - U_{dk}\sin\Delta)
///     + \beta U_{dj}\,(G_k\sin\Delta + U_{dk}\cos\Delta)\Big]\Big\}^{1/2} \f]
/// @eq{52}  @erratum{52}  @derivation{paper/section_2_5_other_masses}  @domain{sliding regime, Eq. (69)}
/// @param V_dk  complex response function of the mass, Eq. (33)
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param U_dk  first damping function of the mass, Eq. (34)
/// @param G_k   second damping function of the mass, Eq. (35)
/// @param beta  friction ratio, Eq. (11)
/// @return      the approximate amplitude, in units of P / k_1
template <class T>
[[nodiscard]] T displacement_transmissibility(const Complex<T>& V_dk, const Complex<T>& V_dj, const T& U_dj, const T& U_dk,
                                              const T& G_k, const T& beta) {
    const T Delta = argument(V_dk) - argument(V_dj);
    return sqrt(squared_modulus(V_dk) + beta * beta * (G_k * G_k + U_dk * U_dk) -
                2 * beta * (modulus(V_dk) / modulus(V_dj)) *
                    (contact_root(V_dj, U_dj, beta) * (G_k * cos(Delta) - U_dk * sin(Delta)) +
                     beta * U_dj * (G_k * sin(Delta) + U_dk * cos(Delta))));
}

/// @brief Monoharmonic phase of a mass behind the mass in contact, \f$ \phi_{kj} \f$.
/// \f[ \cos\phi_{kj} = \overline{X}_{k_C}/\overline{X}_k, \qquad \sin\phi_{kj} = \overline{X}_{k_S}/\overline{X}_k \f]
/// @eq{53}  @derivation{paper/section_2_5_other_masses}  @domain{sliding regime; X_kC and X_kS not both zero}
/// @param X_kC  factor of the cosine, Eq. (50)
/// @param X_kS  factor of the sine, Eq. (51)
/// @return      phi_kj, radians, in (-pi, pi]
template <class T>
[[nodiscard]] T phase_behind_contact(const T& X_kC, const T& X_kS) {
    return atan2(X_kS, X_kC);
}

} // namespace denhartog::paper
