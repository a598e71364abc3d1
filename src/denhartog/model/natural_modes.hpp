/// @file
/// @brief Natural frequency ratios and mode shapes of the undamped system, (13)-(17), of a chain and of any other system.
#pragma once

#include <optional>
#include <vector>

#include "denhartog/number/effort.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief Natural frequency ratios and mode shapes normalised with the mass matrix in units of m_1.
struct NaturalModes {
    std::vector<double> r_n; ///< natural frequency ratios, ascending
    Matrix<double> phi;      ///< mode shapes, mass by mode, phi^T M phi = 1
};

/// @brief Modes of a chain: each natural frequency comes with an error of about N eps of itself, however stiff its springs.
///
/// The stiffness matrix of a chain is a product F^T F with F bidiagonal, one row a spring: its elongation times the root of its
/// stiffness, on displacements times the roots of the masses. No entry of F is a difference, so that its singular values, the
/// natural frequency ratios, come with high relative accuracy. There are N springs where the last mass is free, N + 1 where the
/// last spring joins it to the ground. The work is paid from a budget, as in all that follows. PrecisionError where the iteration
/// does not converge.
/// @eq{14,15}
[[nodiscard]] NaturalModes chain_modes(const std::vector<double>& gamma, const std::vector<double>& kappa,
                                       Effort* effort = nullptr);

/// @brief The same with the shapes at a few masses alone, a row for each in that order, and each mode with any sign, in O(N^2) in
/// place of O(N^3). Frequencies are as above to the last bit. @eq{14,15}
[[nodiscard]] NaturalModes chain_modes(const std::vector<double>& gamma, const std::vector<double>& kappa,
                                       const std::vector<Mass>& masses, Effort* effort = nullptr);

/// @brief Modes of any system: errors of the squared frequencies are about N eps of the highest one, but of masses of very
/// different size, see `graded_modes`. L is the factor of the mass matrix. PrecisionError where the digits do not tell the
/// lowest from zero, or the iteration does not converge. @eq{14,15}
[[nodiscard]] NaturalModes general_modes(const Matrix<double>& L, const Matrix<double>& K, Effort* effort = nullptr);

/// @brief Ratio of the largest mass to the least from which modes are graded, see `graded_modes`.
inline constexpr double least_contrast_of_masses = 1024;

/// @brief By how much the springs multiply relative errors of their entries on the way to those of squared natural frequencies:
/// the trace of the inverse of K, its rows and columns scaled to a diagonal of ones. None where modes are not graded: L is not
/// diagonal, the masses are not very different, or differ by less than the factor.
[[nodiscard]] std::optional<double> condition_of_graded(const Matrix<double>& L, const Matrix<double>& K);

/// @brief Modes of masses of very different size, to the digits that the springs leave; none where there is no factor above.
///
/// With \f$ \mathbf K = \mathbf G\mathbf G^T \f$ and lumped masses, the natural frequency ratios are the singular values of
/// \f$ \mathbf G^T\mathbf M^{-1/2} \f$, whose columns are as small as the masses are large. One-sided Jacobi rotations keep the
/// digits of each column: the error of every natural frequency is a fraction of itself, however light a mass is; see J. Demmel
/// and K. Veselić, SIAM Journal on Matrix Analysis and Applications 13 (1992), 1204.
/// @eq{14,15}
[[nodiscard]] std::optional<NaturalModes> graded_modes(const Matrix<double>& L, const Matrix<double>& K,
                                                       Effort* effort = nullptr);

/// @brief Fixes the signs of mode shapes: positive is the first component that has more than three eighths of the size of the
/// largest.
void fix_signs(Matrix<double>& phi);

} // namespace denhartog
