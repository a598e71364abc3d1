/// @file
/// @brief Singular values and right singular vectors of a bidiagonal matrix, every value with high relative accuracy.
#pragma once

#include <vector>

#include "denhartog/number/effort.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief Singular values, ascending, with their right singular vectors as columns.
struct SingularValues {
    std::vector<double> sigma; ///< singular values, ascending, N values
    Matrix<double> V;          ///< right singular vectors, orthonormal, N x N; column i belongs to sigma[i]
    long sweeps = 0;           ///< QR sweeps that it took
};

/// @brief Singular values of the upper bidiagonal matrix with diagonal d and superdiagonal e.
///
/// Implicit-zero-shift QR iteration, J. Demmel and W. Kahan, "Accurate singular values of bidiagonal matrices", SIAM J. Sci.
/// Stat. Comput. 11 (1990) 873-912. The entries of a bidiagonal matrix determine each of its singular values to the relative
/// accuracy that they have themselves, however far apart the values lie. A sweep without shift keeps that accuracy; a sweep with
/// a shift costs a factor of largest over smallest value of its block and is used only where that factor is at most 4 N. d has N
/// >= 1 values, finite and not zero, and e has N - 1. Each sweep is paid from a budget. PrecisionError where the iteration does not
/// converge.
[[nodiscard]] SingularValues bidiagonal_singular_values(std::vector<double> d, std::vector<double> e, Effort* effort = nullptr);

/// @brief The same, to the last bit, with V of the rows wanted alone, in that order: the values cost N^2, a row another N^2, all
/// rows N^3.
[[nodiscard]] SingularValues bidiagonal_singular_values(std::vector<double> d, std::vector<double> e,
                                                        const std::vector<std::size_t>& rows, Effort* effort = nullptr);

} // namespace denhartog
