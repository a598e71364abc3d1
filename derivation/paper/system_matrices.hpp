/// @file
/// @brief A system of N masses with symbolic matrices whose modes are known: for the steps that go through (13)-(19).
#pragma once

#include <ginac/ginac.h>
#include <vector>

namespace denhartog::derivation {

/// @brief Symbolic system: any diagonal mass matrix, any orthogonal modal matrix, any natural frequencies.
///
/// The modal matrix is \f$ \overline{M}^{-1/2}Q \f$ with a rotation Q by Cayley's formula, rational in its parameters. Stiffness
/// and damping matrices follow from natural frequencies and damping ratios. All systems with distinct frequencies have this form.
struct SymbolicSystem {
    GiNaC::matrix M;              ///< non-dimensional mass matrix
    GiNaC::matrix C;              ///< non-dimensional damping matrix
    GiNaC::matrix K;              ///< non-dimensional stiffness matrix
    GiNaC::matrix Psi;            ///< modal matrix
    std::vector<GiNaC::ex> Omega; ///< natural frequencies
    std::vector<GiNaC::ex> zeta;  ///< damping ratios
    std::vector<GiNaC::ex> gamma; ///< mass ratios
    GiNaC::ex r;                  ///< frequency ratio
};

/// @brief The symbolic system. @param N  1, 2 or 3 @return the system
[[nodiscard]] const SymbolicSystem& symbolic_system(int N);

} // namespace denhartog::derivation
