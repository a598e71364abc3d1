/// @file
/// @brief The response at a natural frequency ratio of a lightly damped system: (76)-(85).
///
/// At \f$ r = r_{n,i} \f$, that is \f$ R_i = 1 \f$, one mode outgrows the others as its damping ratio falls. The amplitudes here
/// are the leading terms for \f$ \zeta_i \to 0 \f$ after \f$ R_i \to 1 \f$; in the opposite order (23) and (29) have other
/// limits. With damping ratios of all modes that fall alike, the relative errors of (77), (79), (80), (83) and (84) are of second
/// order in \f$ \zeta_i \f$, that of (85) is of first order.
#pragma once

#include "denhartog/formulas/complex.hpp"

namespace denhartog::paper {

/// @brief \f$ |x| = \sqrt{x^2} \f$, free of branches; in double for sizes from 1e-154 to 1e154, and zero.
/// @param x  a real number
/// @return   its size
template <class T>
[[nodiscard]] T magnitude(const T& x) {
    return sqrt(T(x * x));
}

/// @brief Complex response function of a mass at the resonance of mode i, \f$ V_{dk} \cong -i\,\psi_{ki}\psi_{li}/(2\zeta_i) \f$.
/// @eq{76}  @derivation{paper/section_4_1_resonance}  @domain{R_i = 1, 0 < zeta_i << 1, psi_ki and psi_li not zero}
/// @param psi_ki  mode shape at the mass k, normalised by (17)
/// @param psi_li  mode shape at the loaded mass
/// @param zeta    modal damping ratio of mode i; dimensionless
/// @return        V_dk, complex; in units of P / k_1
template <class T>
[[nodiscard]] Complex<T> complex_response_at_resonance(const T& psi_ki, const T& psi_li, const T& zeta) {
    return {T(0), -psi_ki * psi_li / (2 * zeta)};
}

/// @brief Amplitude of the complex response function at resonance, \f$ |V_{dk}| \cong |\psi_{ki}\psi_{li}|/(2\zeta_i) \f$.
/// @eq{77}  @derivation{paper/section_4_1_resonance}  @domain{R_i = 1, 0 < zeta_i << 1, psi_ki and psi_li not zero}
/// @param psi_ki  mode shape at the mass k, normalised by (17)
/// @param psi_li  mode shape at the loaded mass
/// @param zeta    modal damping ratio of mode i; dimensionless
/// @return        |V_dk|, in units of P / k_1
template <class T>
[[nodiscard]] T complex_response_amplitude_at_resonance(const T& psi_ki, const T& psi_li, const T& zeta) {
    return magnitude(psi_ki) * magnitude(psi_li) / (2 * zeta);
}

/// @brief Cosine of \f$ \angle V_{dk}-\angle V_{dj} \f$ at resonance, \f$ \mathrm{sgn}(\psi_{ki}\psi_{ji}) \f$; the sine is zero.
/// @eq{78}  @derivation{paper/section_4_1_resonance}  @domain{R_i = 1, 0 < zeta_i << 1, psi_ki, psi_ji and psi_li not zero}
/// @param psi_ki  mode shape at the mass k
/// @param psi_ji  mode shape at the mass in contact
/// @return        1 or -1
template <class T>
[[nodiscard]] T cosine_of_phase_difference_at_resonance(const T& psi_ki, const T& psi_ji) {
    return psi_ki * psi_ji / (magnitude(psi_ki) * magnitude(psi_ji));
}

/// @brief Second damping function of mode i at its resonance.
/// \f[ g_i \cong \frac{\sinh(\pi\zeta_i)}{\cosh(\pi\zeta_i)-1} \f]
/// @eq{79}  @derivation{paper/section_4_1_resonance}  @domain{R_i = 1, 0 < zeta_i << 1; relative error 3 zeta_i^2 / 4}
/// @param zeta  modal damping ratio of mode i; dimensionless
/// @return      g_i; dimensionless
template <class T>
[[nodiscard]] T second_damping_function_at_resonance(const T& zeta) {
    const T delta = pi<T>() * zeta;
    return sinh(delta) / (cosh(delta) - 1);
}

/// @brief Second damping function of a mass at the resonance of mode i.
/// \f[ G_k \cong \psi_{ki}\psi_{ji}\frac{\sinh(\pi\zeta_i)}{\cosh(\pi\zeta_i)-1} \f]
/// @eq{80}  @derivation{paper/section_4_1_resonance}  @domain{R_i = 1, 0 < zeta_i << 1, psi_ki and psi_ji not zero}
/// @param psi_ki  mode shape at the mass k, normalised by (17)
/// @param psi_ji  mode shape at the mass in contact
/// @param zeta    modal damping ratio of mode i; dimensionless
/// @return        G_k; dimensionless
template <class T>
[[nodiscard]] T second_damping_function_at_resonance(const T& psi_ki, const T& psi_ji, const T& zeta) {
    return psi_ki * psi_ji * second_damping_function_at_resonance(zeta);
}

/// @brief (52) at resonance with \f$ \sqrt{|V_{dj}|^2-(\beta U_{dj})^2} \approx |V_{dj}| \f$.
/// \f[ \overline{X}_k \cong \left[|V_{dk}|^2 + \beta^2(G_k^2+U_{dk}^2)
///     - 2\beta\left(|V_{dk}||G_k| + \beta\frac{\psi_{ki}}{\psi_{ji}}U_{dj}U_{dk}\right)\right]^{1/2} \f]
/// The quotient of the mode shapes is \f$ |V_{dk}|/|V_{dj}| \f$ by (77) with the sign (78).
/// @eq{81}  @erratum{81}  @derivation{paper/section_4_1_resonance}  @domain{R_i = 1, 0 < zeta_i << 1, psi_ki and psi_ji not zero}
/// @param V_k_abs  amplitude of the complex response function of the mass, Eq. (77)
/// @param U_k      first damping function of the mass, Eq. (34)
/// @param U_j      first damping function of the mass in contact, Eq. (34)
/// @param G_k      second damping function of the mass, Eq. (80)
/// @param psi_ki   mode shape at the mass k
/// @param psi_ji   mode shape at the mass in contact
/// @param beta     friction ratio, Eq. (11)
/// @return         the approximate amplitude, in units of P / k_1
template <class T>
[[nodiscard]] T transmissibility_at_resonance(const T& V_k_abs, const T& U_k, const T& U_j, const T& G_k, const T& psi_ki,
                                              const T& psi_ji, const T& beta) {
    return sqrt(T(V_k_abs * V_k_abs + beta * beta * (G_k * G_k + U_k * U_k) -
                  2 * beta * (V_k_abs * magnitude(G_k) + beta * (psi_ki / psi_ji) * U_j * U_k)));
}

/// @brief Amplitude at resonance without the first damping functions, \f$ \overline{X}_k \cong \big||V_{dk}|-\beta|G_k|\big| \f$.
/// @eq{82}  @erratum{82}  @derivation{paper/section_4_1_resonance}  @domain{R_i = 1, 0 < zeta_i << 1, beta below (85)}
/// @param V_k_abs  amplitude of the complex response function of the mass, Eq. (77)
/// @param G_k      second damping function of the mass, Eq. (80)
/// @param beta     friction ratio, Eq. (11)
/// @return         the approximate amplitude, in units of P / k_1
template <class T>
[[nodiscard]] T transmissibility_at_resonance_without_U(const T& V_k_abs, const T& G_k, const T& beta) {
    return magnitude(T(V_k_abs - beta * magnitude(G_k)));
}

/// @brief Height of the resonant peak of a mass at mode i.
/// \f[ \overline{X}_k \cong \frac{|\psi_{ki}\psi_{li}|}{2\zeta_i}
///     - |\psi_{ki}\psi_{ji}|\frac{\sinh(\pi\zeta_i)}{\cosh(\pi\zeta_i)-1}\,\beta \f]
/// Falls linearly with the friction ratio and reaches zero at (85).
/// @eq{83}  @derivation{paper/section_4_1_resonance}  @domain{R_i = 1, 0 < zeta_i << 1, beta below (85)}
/// @param psi_ki  mode shape at the mass k, normalised by (17)
/// @param psi_li  mode shape at the loaded mass
/// @param psi_ji  mode shape at the mass in contact
/// @param zeta    modal damping ratio of mode i; dimensionless
/// @param beta    friction ratio, Eq. (11)
/// @return        the approximate amplitude, in units of P / k_1
template <class T>
[[nodiscard]] T resonant_peak(const T& psi_ki, const T& psi_li, const T& psi_ji, const T& zeta, const T& beta) {
    return magnitude(psi_ki) * magnitude(psi_li) / (2 * zeta) -
           magnitude(psi_ki) * magnitude(psi_ji) * second_damping_function_at_resonance(zeta) * beta;
}

/// @brief Height of the resonant peak of a single mass.
/// \f[ \overline{X} = \frac{1}{2\zeta} - \frac{\sinh(\pi\zeta)}{\cosh(\pi\zeta)-1}\,\beta \f]
/// @eq{84}  @derivation{paper/section_4_1_resonance}  @domain{r = 1, 0 < zeta << 1, beta below (85)}
/// @param zeta  damping ratio; dimensionless
/// @param beta  friction ratio, Eq. (11)
/// @return      the approximate amplitude, in units of P / k_1
template <class T>
[[nodiscard]] T resonant_peak_of_single_mass(const T& zeta, const T& beta) {
    return 1 / (2 * zeta) - second_damping_function_at_resonance(zeta) * beta;
}

/// @brief Friction ratio up to which the response is continuous at the resonance of mode i, \f$ \beta_{n,i} \f$.
/// \f[ \beta_{n,i} \cong \left|\frac{\psi_{li}}{\psi_{ji}}\right|\frac{\cosh(\pi\zeta_i)-1}{2\zeta_i\sinh(\pi\zeta_i)} \f]
/// For \f$ \zeta_i \to 0 \f$ it tends to \f$ \tfrac{\pi}{4}|\psi_{li}/\psi_{ji}| \f$. It is where (83) reaches zero, and for
/// small damping ratios it lies above the boundary (69).
/// @eq{85}  @derivation{paper/section_4_1_resonance}
/// @domain{R_i = 1, 0 < zeta_i << 1, psi_ji not zero; relative error of first order in zeta_i}
/// @param psi_li  mode shape at the loaded mass
/// @param psi_ji  mode shape at the mass in contact
/// @param zeta    modal damping ratio of mode i; dimensionless
/// @return        the friction ratio; dimensionless
template <class T>
[[nodiscard]] T friction_ratio_limit_at_resonance(const T& psi_li, const T& psi_ji, const T& zeta) {
    const T delta = pi<T>() * zeta;
    return magnitude(psi_li) / magnitude(psi_ji) * ((cosh(delta) - 1) / (2 * zeta * sinh(delta)));
}

} // namespace denhartog::paper
