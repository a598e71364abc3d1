/// @file
/// @brief The motion that is shipped, put into the equation of motion (12) and the conditions (25), (30).
#pragma once

#include <ginac/ginac.h>
#include <vector>

#include "derivation/algebra/symbols.hpp"

namespace denhartog::derivation {

/// @brief A system with any modal matrix; the mass matrix is any positive one, diagonal or not.
///
/// With \f$ \Psi^T\overline{M}\Psi = 1 \f$, (17), the matrices follow from the modal matrix, and from the frequencies and damping
/// ratios of `symbolic_modes`.
struct WholeSystem {
    GiNaC::matrix Psi; ///< modal matrix, every entry a symbol
    GiNaC::matrix M;   ///< non-dimensional mass matrix
    GiNaC::matrix C;   ///< non-dimensional damping matrix
    GiNaC::matrix K;   ///< non-dimensional stiffness matrix
};

/// @brief The system. @param N  1, 2 or 3 @return the system
[[nodiscard]] const WholeSystem& whole_system(int N);

/// @brief The shipped motion of all masses.
struct WholeMotion {
    std::vector<GiNaC::ex> x; ///< displacements (46), functions of tau
    GiNaC::ex load;           ///< cos(tau + phi_j) with the phase (39)
    GiNaC::ex amplitude;      ///< of the mass in contact, (38)
};

/// @brief The shipped motion. @param N number of masses @param j the mass in contact, from 0 @param l the loaded mass, from 0
/// @param m  frequency ratios, damping ratios and damping functions of the modes
/// @return   the motion
[[nodiscard]] WholeMotion whole_motion(int N, int j, int l, const SymbolicModes& m);

/// @brief The residuals of the shipped motion, with all shipped formulas in it, in (12), in (25) for every mass, and in (30).
/// @param N  number of masses @param j the mass in contact, from 0 @param l the loaded mass, from 0
/// @return   expressions that are to be zero
[[nodiscard]] std::vector<GiNaC::ex> whole_conditions(int N, int j, int l);

} // namespace denhartog::derivation
