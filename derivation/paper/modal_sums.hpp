/// @file
/// @brief The motion of a mass as a sum over its modes, from the modal relations (26), (27) and (A.15).
#pragma once

#include <ginac/ginac.h>
#include <utility>
#include <vector>

namespace denhartog::derivation {

/// @brief Which mass a sum is taken for: its row of mode shapes.
enum class Row { mass, contact };

/// @brief A mode's initial values in the steady state, for a given phase.
struct ModalStart {
    GiNaC::ex psi_k;           ///< mode shape at the mass
    GiNaC::ex psi_j;           ///< mode shape at the mass in contact
    GiNaC::ex harmonic_cosine; ///< psi_l R^2 times Re{v exp(i phi)}
    GiNaC::ex harmonic_sine;   ///< psi_l R^2 times -Im{v exp(i phi)}
    GiNaC::ex eta_0;           ///< initial displacement by (26)
    GiNaC::ex eta_prime_0;     ///< initial velocity by (27)
};

/// @brief Initial values of the mode i, (26) and (27) solved for them. @param re, im v_di @param c cos(phi_j) @param s sin(phi_j)
/// @return  eta_0, eta'_0 in the symbols of one mode
[[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> derived_start(const GiNaC::ex& re, const GiNaC::ex& im, const GiNaC::ex& c,
                                                            const GiNaC::ex& s);

/// @brief The modes' initial values. @param N number of modes @param c cos(phi_j) @param s sin(phi_j) @return one a mode
[[nodiscard]] std::vector<ModalStart> derived_starts(int N, const GiNaC::ex& c, const GiNaC::ex& s);

/// @brief Real and imaginary part of the complex response of a mass. @param N number of modes @param row which mass
/// @return the two sums
[[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> derived_response(int N, Row row);

/// @brief Displacement and velocity of a mass at tau = 0. @param N number of modes @param row which mass
/// @param c  cos(phi_j) @param s sin(phi_j) @return the two sums
[[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> derived_start_of_mass(int N, Row row, const GiNaC::ex& c, const GiNaC::ex& s);

/// @brief Displacement of a mass over the half-period, from the modes' initial values. @param N number of modes
/// @param row  which mass @param starts (eta_0, eta'_0) of each mode @return x_k(tau)
[[nodiscard]] GiNaC::ex derived_displacement_of_mass(int N, Row row, const std::vector<std::pair<GiNaC::ex, GiNaC::ex>>& starts);

/// @brief cos(phi_j) and sin(phi_j) from Re{V exp(i phi)} and Im{V exp(i phi)}. @param re, im V @param c, s the two values
/// @return  the cosine and the sine
[[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> derived_phase_of_contact(const GiNaC::ex& re, const GiNaC::ex& im,
                                                                       const GiNaC::ex& c, const GiNaC::ex& s);

/// @brief cos(phi_j) and sin(phi_j) of the steady state: Re{V exp(i phi)} is the root of (38), Im{V exp(i phi)} is -beta U.
/// @param re, im  V_dj @param U U_dj
/// @return        the cosine and the sine
[[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> derived_steady_phase(const GiNaC::ex& re, const GiNaC::ex& im, const GiNaC::ex& U);

/// @brief Displacement and velocity of a mass at tau = 0 in the steady state, from Re and -Im of V_dk exp(i phi_j).
/// @return  x_k0 and x'_k0 in the symbols V_kr, V_ki, V_jr, V_ji, U_j, U_k, G_k
[[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> derived_initial_state();

} // namespace denhartog::derivation
