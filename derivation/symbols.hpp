/// @file
/// @brief The paper's symbols, each with the range from which sample points are drawn.
#pragma once

#include <ginac/ginac.h>
#include <vector>

#include "claim.hpp"
#include "denhartog/formulas/modal_coordinate.hpp"
#include "symbolic.hpp"
#include "zero_test.hpp"

namespace denhartog::derivation {

/// @brief Makes a symbol known with its range. @param name name @param latex LaTeX @param low least @param high largest value
/// @return the symbol
GiNaC::ex new_symbol(const std::string& name, const std::string& latex, const GiNaC::numeric& low, const GiNaC::numeric& high);

/// @brief The ranges of the symbols that occur in some expressions.
/// @param expressions  the expressions
/// @return             symbols and ranges; the domain on which a claim about them is sampled
[[nodiscard]] std::vector<Range> domain_of(const std::vector<GiNaC::ex>& expressions);

/// @brief LaTeX of a symbol made by `new_symbol`. @param name its name @return its LaTeX; empty for a name that is none
[[nodiscard]] std::string latex_of_name(const std::string& name);

/// @brief The symbols of one mode, of the contact, and of the derivation.
struct Symbols {
    GiNaC::ex tau, R, zeta, w, beta, mu, psi_ki, psi_ji, psi_li, eta_0, eta_prime_0, phi_j, u, g, A, B, c_phi, s_phi, v_cos, v_sin;
    GiNaC::ex V_kr, V_ki, V_jr, V_ji, U_k, U_j, G_k, G_j, F_k, S, H, X, x_k0, x_prime_k0, r, gamma, omega, t, m_1, m_i, k_1, k_i, P, F, x;
    GiNaC::ex PA, PB, PC, PP, PQ, PR;
};

/// @brief The symbols, made once. @return the symbols
[[nodiscard]] const Symbols& symbols();

/// @brief A mode of the kernels in the symbols of one mode. @return R, zeta, psi_ji, psi_li
[[nodiscard]] ModeInScene<Symbolic> symbolic_mode();

/// @brief The initial values of the kernels. @return eta_0, eta'_0
[[nodiscard]] InitialValues<Symbolic> symbolic_start();

/// @brief Complex response function of the mass in contact, as symbols. @return V_dj
[[nodiscard]] Complex<Symbolic> symbolic_V_j();

/// @brief Complex response function of the mass k, as symbols. @return V_dk
[[nodiscard]] Complex<Symbolic> symbolic_V_k();

/// @brief Symbols of N modes where sums over modes matter.
struct SymbolicModes {
    std::vector<Symbolic> R, zeta, psi_k, psi_j, psi_l, u, g; ///< one value a mode
    std::vector<Complex<Symbolic>> v;                          ///< complex response functions, as symbols
};

/// @brief Symbols of N modes. @param N  1, 2 or 3 @return the symbols
[[nodiscard]] SymbolicModes symbolic_modes(int N);

/// @brief LaTeX of an expression in one line, in its readable form. @param e the expression @return LaTeX
[[nodiscard]] std::string latex(const GiNaC::ex& e);

/// @brief A line of a derivation: what is done, and a formula that comes out, in its readable form.
/// @param text   what is done; formulas in it stand between dollar signs
/// @param left   LaTeX of the left side
/// @param right  the right side, as GiNaC made it
/// @return       the line
[[nodiscard]] Step step(const std::string& text, const std::string& left, const GiNaC::ex& right);

} // namespace denhartog::derivation
