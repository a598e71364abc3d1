/// @file
/// @brief Modes of masses of very different size, to the digits that the springs leave.
///
/// With \f$ \mathbf K = \mathbf G\mathbf G^T \f$ and lumped masses, the natural frequency ratios are the singular values of
/// \f$ \mathbf G^T\mathbf M^{-1/2} \f$, whose columns are as small as the masses are large. One-sided Jacobi rotations keep the digits of each
/// column: the error of every natural frequency is a fraction of itself, however light a mass is; see J. Demmel and K. Veselić, SIAM
/// Journal on Matrix Analysis and Applications 13 (1992), 1204.
#pragma once

#include <optional>

#include "denhartog/model/natural_modes.hpp"

namespace denhartog {

/// @brief Ratio of the largest mass to the least from which the modes are found so.
inline constexpr double least_contrast_of_masses = 1024;

/// @brief By how much the springs multiply relative errors of their entries on the way to those of squared natural frequencies:
/// the trace of the inverse of K, its rows and columns scaled to a diagonal of ones. None where the modes are not found so: L is
/// not diagonal, the masses are not very different, or differ by less than the factor.
[[nodiscard]] std::optional<double> condition_of_graded(const Matrix<double>& L, const Matrix<double>& K);

/// @brief The modes; none where there is no factor above. @eq{14,15}
[[nodiscard]] std::optional<NaturalModes<double>> graded_modes(const Matrix<double>& L, const Matrix<double>& K);

} // namespace denhartog
