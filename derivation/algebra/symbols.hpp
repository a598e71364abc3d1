/// @file
/// @brief The paper's symbols, each with the range from which sample points are drawn.
#pragma once

#include <ginac/ginac.h>
#include <vector>

#include "denhartog/formulas/modal_coordinate.hpp"
#include "derivation/algebra/symbolic.hpp"
#include "derivation/algebra/zero_test.hpp"
#include "derivation/claims/claim.hpp"

namespace denhartog::derivation {

/// @brief Makes a symbol known with the range of its samples; it is not negative anywhere where no sample is.
/// @param name name @param latex LaTeX @param low least @param high largest sample
/// @return the symbol
GiNaC::ex new_symbol(const std::string& name, const std::string& latex, const GiNaC::numeric& low, const GiNaC::numeric& high);

/// @brief Makes a symbol with bounds on all of its values.
/// @param name name @param latex LaTeX @param low least @param high largest sample @param bounds of all its values
/// @return the symbol
GiNaC::ex new_symbol(const std::string& name, const std::string& latex, const GiNaC::numeric& low, const GiNaC::numeric& high,
                     const Bounds& bounds);

/// @brief The ranges of the symbols that occur in some expressions.
/// @param expressions  the expressions
/// @return             symbols and ranges; the domain on which a claim about them is sampled
[[nodiscard]] std::vector<Range> domain_of(const std::vector<GiNaC::ex>& expressions);

/// @brief LaTeX of a symbol made by `new_symbol`. @param name its name @return its LaTeX; empty for a name that is none
[[nodiscard]] std::string latex_of_name(const std::string& name);

/// @brief The symbols of one mode, of the contact, and of the derivation.
struct Symbols {
    GiNaC::ex tau;         ///< non-dimensional time
    GiNaC::ex R;           ///< frequency ratio of the mode
    GiNaC::ex zeta;        ///< its damping ratio
    GiNaC::ex w;           ///< sqrt(1 - zeta^2)
    GiNaC::ex beta;        ///< friction ratio
    GiNaC::ex mu;          ///< static over kinetic friction
    GiNaC::ex psi_ki;      ///< mode shape at the mass k
    GiNaC::ex psi_ji;      ///< mode shape at the mass in contact
    GiNaC::ex psi_li;      ///< mode shape at the loaded mass
    GiNaC::ex eta_0;       ///< initial modal displacement
    GiNaC::ex eta_prime_0; ///< initial modal velocity
    GiNaC::ex phi_j;       ///< phase of the mass in contact
    GiNaC::ex u;           ///< first damping function of the mode
    GiNaC::ex g;           ///< second damping function of the mode
    GiNaC::ex A;           ///< first integration constant
    GiNaC::ex B;           ///< second integration constant
    GiNaC::ex c_phi;       ///< cos(phi_j)
    GiNaC::ex s_phi;       ///< sin(phi_j)
    GiNaC::ex v_cos;       ///< v cos(phi_j) in the reading of (A.10)
    GiNaC::ex v_sin;       ///< v sin(phi_j) in the same reading
    GiNaC::ex V_kr;        ///< real part of V_dk
    GiNaC::ex V_ki;        ///< imaginary part of V_dk
    GiNaC::ex V_jr;        ///< real part of V_dj
    GiNaC::ex V_ji;        ///< imaginary part of V_dj
    GiNaC::ex U_k;         ///< U_dk
    GiNaC::ex U_j;         ///< U_dj
    GiNaC::ex G_k;         ///< G_k
    GiNaC::ex G_j;         ///< G_j
    GiNaC::ex F_k;         ///< sum over the modes in (41)
    GiNaC::ex S;           ///< S_dj
    GiNaC::ex H;           ///< H_j
    GiNaC::ex X;           ///< amplitude of the mass in contact
    GiNaC::ex x_k0;        ///< initial displacement of the mass k
    GiNaC::ex x_prime_k0;  ///< its initial velocity
    GiNaC::ex r;           ///< frequency ratio
    GiNaC::ex gamma;       ///< mass ratio
    GiNaC::ex omega;       ///< circular frequency of the load
    GiNaC::ex t;           ///< time
    GiNaC::ex m_1;         ///< first mass
    GiNaC::ex m_i;         ///< mass i
    GiNaC::ex k_1;         ///< first stiffness
    GiNaC::ex k_i;         ///< stiffness i
    GiNaC::ex P;           ///< amplitude of the load
    GiNaC::ex F;           ///< friction force
    GiNaC::ex x;           ///< displacement
    GiNaC::ex p_j;         ///< part of the load on the mass in contact, where the load is on several
    GiNaC::ex q_j;         ///< the same of its part that leads by a quarter of a period
    GiNaC::ex PA;          ///< coefficient A of (A.11)
    GiNaC::ex PB;          ///< coefficient B of (A.11)
    GiNaC::ex PC;          ///< coefficient C of (A.11)
    GiNaC::ex PP;          ///< coefficient P of (A.11)
    GiNaC::ex PQ;          ///< coefficient Q of (A.11)
    GiNaC::ex PR;          ///< coefficient R of (A.11)
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
    std::vector<Symbolic> R;          ///< frequency ratios
    std::vector<Symbolic> zeta;       ///< damping ratios
    std::vector<Symbolic> psi_k;      ///< mode shapes at the mass k
    std::vector<Symbolic> psi_j;      ///< mode shapes at the mass in contact
    std::vector<Symbolic> psi_l;      ///< mode shapes at the loaded mass
    std::vector<Symbolic> u;          ///< first damping functions
    std::vector<Symbolic> g;          ///< second damping functions
    std::vector<Complex<Symbolic>> v; ///< complex response functions, as symbols
};

/// @brief Symbols of N modes. @param N  1, 2 or 3 @return the symbols
[[nodiscard]] SymbolicModes symbolic_modes(int N);

/// @brief Sums over any number of modes, as symbols: what the loops have when one more mode comes. (N) marks them.
struct PartialSums {
    GiNaC::ex V_r;      ///< real part of the complex response of a mass, (33)
    GiNaC::ex V_i;      ///< its imaginary part
    GiNaC::ex U;        ///< first damping function of the mass, (34)
    GiNaC::ex G;        ///< second damping function of the mass, (35)
    GiNaC::ex x;        ///< displacement of the mass at tau = 0
    GiNaC::ex x_prime;  ///< its velocity there
    GiNaC::ex F;        ///< sum in (41)
    GiNaC::ex F_prime;  ///< its rate
    GiNaC::ex F_second; ///< the rate of that
    GiNaC::ex S;        ///< sum (56) at one tau
    GiNaC::ex H;        ///< sum (64)
    GiNaC::ex squares;  ///< sum (65)
    GiNaC::ex entry;    ///< an entry of a matrix
};

/// @brief The symbols of partial sums. @return the symbols
[[nodiscard]] const PartialSums& partial_sums();

/// @brief LaTeX of an expression in one line, in its readable form. @param e the expression @return LaTeX
[[nodiscard]] std::string latex(const GiNaC::ex& e);

/// @brief A line of a derivation: what is done, and a formula that comes out, in its readable form.
/// @param text   what is done; formulas in it stand between dollar signs
/// @param left   LaTeX of the left side
/// @param right  the right side, as GiNaC made it
/// @return       the line
[[nodiscard]] Step step(const std::string& text, const std::string& left, const GiNaC::ex& right);

} // namespace denhartog::derivation
