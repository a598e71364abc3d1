/// @file
/// @brief Floquet multipliers of a periodic orbit, and whether they are certainly inside the unit circle.
#pragma once

#include <complex>
#include <vector>

#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief Size of a multiplier, the same on every machine. @param multiplier one @return its absolute value
[[nodiscard]] double size_of(const std::complex<double>& multiplier);

/// @brief Eigenvalues of a map's Jacobian.
/// @param jacobian  a square matrix
/// @return          its eigenvalues by descending size; none where they were not found
[[nodiscard]] std::vector<std::complex<double>> multipliers_of(const Matrix<double>& jacobian);

/// @brief Multipliers of a map applied twice. @param multipliers of the map applied once @return their squares by descending size
[[nodiscard]] std::vector<std::complex<double>> squared(std::vector<std::complex<double>> multipliers);

/// @brief Whether the powers of a Jacobian tend to zero: all its eigenvalues are inside the unit circle.
///
/// The matrix is squared until its norm is below 1; the error of the powers is bounded along the way, so that eigenvalues that
/// are ill-conditioned, as the zeros of a contact that sticks, do no harm.
/// @param jacobian  a square matrix
/// @param error     bound of its error, in the largest sum of a row
/// @return          true where every matrix within the error has them inside
[[nodiscard]] bool contracts(const Matrix<double>& jacobian, double error);

} // namespace denhartog
