/// @file
/// @brief The consequences of (12) and the boundary conditions, step by step.
///
/// None of these contains a formula of `src/denhartog`: each is made from the equation of motion (20) by GiNaC. The unknown
/// \f$ \cos\phi_j, \sin\phi_j \f$ are the symbols `c_phi`, `s_phi`; `v_cos`, `v_sin` stand for
/// \f$ \mathrm{Re}\{v_{di}e^{i\phi_j}\} \f$ and \f$ \mathrm{Im}\{v_{di}e^{i\phi_j}\} \f$.
#pragma once

#include <ginac/ginac.h>
#include <utility>
#include <vector>

#include "derivation/claims/claim.hpp"

namespace denhartog::derivation {

/// @brief Real and imaginary part of the response of a mode to a unit harmonic load, over \f$ R_i^2 \f$: v of (23).
/// @return  the two parts
[[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> derived_complex_response();

/// @brief General solution of (20) with the constants A and B. @return eta(tau)
[[nodiscard]] GiNaC::ex derived_general_solution();

/// @brief A and B from the initial values (A.3). @return A, B
[[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> derived_constants();

/// @brief Displacement from the initial values, in `c_phi`, `s_phi`. @return eta(tau)
[[nodiscard]] GiNaC::ex derived_displacement();

/// @brief The displacement with `v_cos`, `v_sin` in place of `c_phi`, `s_phi`. @return eta(tau)
[[nodiscard]] GiNaC::ex derived_displacement_by_v();

/// @brief \f$ \eta_i(\pi)+\eta_{i0} \f$ and \f$ \eta_i'(\pi)+\eta_{i0}' \f$ in `v_cos`, `v_sin`: what (A.4) sets to zero.
/// @return  the two conditions
[[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> derived_final_conditions();

/// @brief Solution of the conditions (A.4). @return v_cos, v_sin in the initial values
[[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> derived_phase();

/// @brief The phase with the parts that friction makes named by the symbols u and g. @return v_cos, v_sin
[[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> derived_phase_by_functions();

/// @brief First damping function: the part of `v_sin` that friction makes. @return u
[[nodiscard]] GiNaC::ex derived_first_damping_function();

/// @brief Second damping function: the part of `v_cos` that friction makes. @return g
[[nodiscard]] GiNaC::ex derived_second_damping_function();

/// @brief Displacement over the half-period of the steady state, in the symbols u and g. @return eta(tau)
[[nodiscard]] GiNaC::ex derived_modal_displacement();

/// @brief `c_phi`, `s_phi` replaced by the cosine and sine of `phi_j`. @param e an expression @return the same in phi_j
[[nodiscard]] GiNaC::ex in_phi_j(const GiNaC::ex& e);

} // namespace denhartog::derivation
