/// @file
/// @brief Natural frequency ratios and mode shapes of the undamped system, (13)-(17), of a chain and of any other system.
#pragma once

#include <optional>
#include <vector>

#include "denhartog/number/effort.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief Natural frequency ratios and mode shapes normalised with the mass matrix in units of m_1.
struct NaturalModes {
    std::vector<double> r_n; ///< natural frequency ratios, ascending
    Matrix<double> phi;      ///< mode shapes, mass by mode, phi^T M phi = 1
};

/// @brief Modes of a chain with the shapes at some masses, a row for each in that order, and each mode with any sign: N^2
/// operations a row. PrecisionError where the iteration does not converge.
///
/// The stiffness matrix of a chain is a product F^T F with F bidiagonal, one row a spring: its elongation times the root of its
/// stiffness, on displacements times the roots of the masses. No entry of F is a difference, so that its singular values, the
/// natural frequency ratios, come with an error of about N eps of themselves, however stiff the springs. There are N springs where
/// the last mass is free, N + 1 where the last spring joins it to the ground. The work is paid from a budget, as in all that
/// follows. @eq{14,15}
[[nodiscard]] NaturalModes chain_modes(const std::vector<double>& gamma, const std::vector<double>& kappa,
                                       const std::vector<Mass>& masses, Effort* effort = nullptr);

/// @brief Modes of a chain with the shapes at all masses. @eq{14,15}
[[nodiscard]] NaturalModes chain_modes(const std::vector<double>& gamma, const std::vector<double>& kappa,
                                       Effort* effort = nullptr);

/// @brief Modes of any system: errors of the squared frequencies are about N eps of the highest one, but of masses of very
/// different size, see `graded_modes`. L is the factor of the mass matrix. PrecisionError where the digits do not tell the
/// lowest from zero, or the iteration does not converge. @eq{14,15}
[[nodiscard]] NaturalModes general_modes(const Matrix<double>& L, const Matrix<double>& K, Effort* effort = nullptr);

/// @brief The factor by which springs multiply relative errors of their entries on the way to those of squared natural frequencies:
/// the trace of the inverse of K, its rows and columns scaled to a diagonal of ones. None where modes are not graded: L is not
/// diagonal, the masses are not very different, or differ by less than the factor.
[[nodiscard]] std::optional<double> condition_of_graded(const Matrix<double>& L, const Matrix<double>& K);

/// @brief Modes of masses of very different size, to the digits that the springs leave; none where there is no factor above.
///
/// With \f$ \mathbf K = \mathbf G\mathbf G^T \f$ and lumped masses, the natural frequency ratios are the singular values of
/// \f$ \mathbf G^T\mathbf M^{-1/2} \f$, whose columns are as small as the masses are large. One-sided Jacobi rotations keep the
/// digits of each column: the error of every natural frequency is a fraction of itself, however light a mass is; see J. Demmel
/// and K. Veselić, SIAM Journal on Matrix Analysis and Applications 13 (1992), 1204. @eq{14,15}
[[nodiscard]] std::optional<NaturalModes> graded_modes(const Matrix<double>& L, const Matrix<double>& K,
                                                       Effort* effort = nullptr);

/// @brief PrecisionError for the first mode that is beyond the range of a double; `why` is the sentence that says so.
void require_finite(const std::vector<double>& r_n, const Matrix<double>& phi, Why why);

/// @brief Fixes the signs of mode shapes: positive is the first component that has more than three eighths of the size of the
/// largest.
void fix_signs(Matrix<double>& phi);

/// @brief Singular values of the upper bidiagonal matrix with diagonal d and superdiagonal e, ascending, as natural frequency ratios;
/// the right singular vectors as mode shapes, of which there are the rows wanted.
///
/// Implicit-zero-shift QR iteration, J. Demmel and W. Kahan, "Accurate singular values of bidiagonal matrices", SIAM J. Sci.
/// Stat. Comput. 11 (1990) 873-912. The entries of a bidiagonal matrix determine each of its singular values to the relative
/// accuracy that they have themselves, however far apart the values lie. A sweep without shift keeps that accuracy; a sweep with
/// a shift costs a factor of largest over smallest value of its block and is used only where that factor is at most 4 N. d has N
/// >= 1 values, finite and not zero, and e has N - 1. The values cost N^2, a row another N^2; each sweep is paid from a budget.
/// PrecisionError where the iteration does not converge.
[[nodiscard]] NaturalModes bidiagonal_singular_values(std::vector<double> d, std::vector<double> e,
                                                      const std::vector<std::size_t>& rows, Effort* effort = nullptr);

} // namespace denhartog
