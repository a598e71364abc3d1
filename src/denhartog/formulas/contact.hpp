/// @file
/// @brief Amplitude and phase of the mass in contact: (31), (32), (36)-(39).
#pragma once

#include "denhartog/formulas/complex.hpp"

namespace denhartog::paper {

/// @brief \f$ V_{dj}\cos\phi_j = \overline{X}_j + \beta G_j \f$, with the reading of `complex.hpp`.
/// @eq{31}  @derivation{paper/section_2_3_mass_in_contact}  @domain{sliding regime, Eq. (69)}
/// @param X_j   amplitude of the mass in contact
/// @param G_j   second damping function of the mass in contact, Eq. (35)
/// @param beta  friction ratio, Eq. (11)
/// @return      V_dj cos(phi_j)
template <class T>
[[nodiscard]] T V_cosine(const T& X_j, const T& G_j, const T& beta) {
    return X_j + beta * G_j;
}

/// @brief \f$ V_{dj}\sin\phi_j = -\beta U_{dj} \f$, with the reading of `complex.hpp`.
/// @eq{32}  @derivation{paper/section_2_3_mass_in_contact}  @domain{sliding regime, Eq. (69)}
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param beta  friction ratio, Eq. (11)
/// @return      V_dj sin(phi_j)
template <class T>
[[nodiscard]] T V_sine(const T& U_dj, const T& beta) {
    return -beta * U_dj;
}

/// @brief \f$ \cos(\phi_j+\angle V_{dj}) = (\overline{X}_j+\beta G_j)/|V_{dj}| \f$.
/// @eq{36}  @derivation{paper/section_2_3_mass_in_contact}  @domain{sliding regime, Eq. (69)}
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param X_j   amplitude of the mass in contact
/// @param G_j   second damping function of the mass in contact, Eq. (35)
/// @param beta  friction ratio, Eq. (11)
/// @return      the cosine
template <class T>
[[nodiscard]] T cosine_of_phase_sum(const Complex<T>& V_dj, const T& X_j, const T& G_j, const T& beta) {
    return (X_j + beta * G_j) / modulus(V_dj);
}

/// @brief \f$ \sin(\phi_j+\angle V_{dj}) = -\beta U_{dj}/|V_{dj}| \f$.
/// @eq{37}  @derivation{paper/section_2_3_mass_in_contact}  @domain{sliding regime, Eq. (69)}
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param beta  friction ratio, Eq. (11)
/// @return      the sine
template <class T>
[[nodiscard]] T sine_of_phase_sum(const Complex<T>& V_dj, const T& U_dj, const T& beta) {
    return -beta * U_dj / modulus(V_dj);
}

/// @brief The root that (38), (44)-(46), (50)-(52) share, \f$ \sqrt{|V_{dj}|^2-(\beta U_{dj})^2} \f$.
/// @eq{38}  @derivation{paper/section_2_3_mass_in_contact}  @domain{beta |U_dj| <= |V_dj|}
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param beta  friction ratio, Eq. (11)
/// @return      the root
template <class T>
[[nodiscard]] T contact_root(const Complex<T>& V_dj, const T& U_dj, const T& beta) {
    return sqrt(squared_modulus(V_dj) - beta * U_dj * (beta * U_dj));
}

/// @brief Displacement transmissibility of the mass in contact.
/// \f[ \overline{X}_j = -\beta G_j + \sqrt{|V_{dj}|^2-(\beta U_{dj})^2} \f]
///
/// The other sign of the root contradicts (54)a, because \f$ \overline{X}_j+\beta G_j > \beta S_{dj} > 0 \f$.
/// @eq{38}  @derivation{paper/section_2_3_mass_in_contact}  @domain{sliding regime, Eq. (69)}
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param G_j   second damping function of the mass in contact, Eq. (35)
/// @param beta  friction ratio, Eq. (11)
/// @return      the amplitude, in units of P / k_1
template <class T>
[[nodiscard]] T displacement_transmissibility_of_contact(const Complex<T>& V_dj, const T& U_dj, const T& G_j, const T& beta) {
    return -beta * G_j + contact_root(V_dj, U_dj, beta);
}

/// @brief Phase of the mass in contact: its maximum lags the maximum of the force by \f$ \phi_j \f$.
/// \f[ \phi_j = \mathrm{atan2}\left(-\frac{\beta U_{dj}}{|V_{dj}|},
///     \sqrt{1-\left(\frac{\beta U_{dj}}{|V_{dj}|}\right)^2}\right) - \angle V_{dj} \f]
/// @eq{39}  @derivation{paper/section_2_3_mass_in_contact}  @domain{sliding regime, Eq. (69)}
/// @param V_dj  complex response function of the mass in contact, Eq. (33)
/// @param U_dj  first damping function of the mass in contact, Eq. (34)
/// @param beta  friction ratio, Eq. (11)
/// @return      phi_j, radians, in (-3 pi/2, 3 pi/2]; wrap it to (-pi, pi]
template <class T>
[[nodiscard]] T phase_of_contact(const Complex<T>& V_dj, const T& U_dj, const T& beta) {
    const T s = beta * U_dj / modulus(V_dj);
    return atan2(T(-s), sqrt(T(1 - s * s))) - argument(V_dj);
}

} // namespace denhartog::paper
