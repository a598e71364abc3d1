/// @file
/// @brief Floquet multipliers of a periodic orbit with bounds, and whether they are certainly inside the unit circle.
#pragma once

#include <complex>
#include <vector>

#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief A Floquet multiplier.
struct Multiplier {
    std::complex<double> value; ///< the multiplier
    double error;               ///< bound of the error of its size: of the n-th largest size, where this is the n-th
};

/// @brief Size of a multiplier, the same on every machine. @param multiplier one @return its absolute value
[[nodiscard]] double size_of(const std::complex<double>& multiplier);

/// @brief Whether a multiplier is certainly inside the unit circle. @param multiplier one @return true if so
[[nodiscard]] inline bool is_inside(const Multiplier& multiplier) { return size_of(multiplier.value) + multiplier.error < 1; }

/// @brief Eigenvalues of a map's Jacobian.
/// @param jacobian  a square matrix
/// @return          its eigenvalues by descending size; none where they were not found
[[nodiscard]] std::vector<std::complex<double>> eigenvalues(const Matrix<double>& jacobian);

/// @brief Eigenvalues of a map's Jacobian, each with a bound of the error of its size.
///
/// The matrix is made triangular by a unitary one, and then diagonal but for what couples eigenvalues of nearly the same value.
/// Gershgorin's discs of what the error leaves beside the diagonal hold as many eigenvalues of the true matrix as they are discs,
/// also if it is scaled so that couplings shrink: a multiple zero without as many eigenvectors is known to a root of the error.
/// @param jacobian  a square matrix
/// @param error     bound of its error, in Euclid's norm
/// @param most      bound of the true sizes from elsewhere; infinite where there is none
/// @return          its eigenvalues by descending size; none where they were not found
[[nodiscard]] std::vector<Multiplier> multipliers_of(const Matrix<double>& jacobian, double error, double most);

/// @brief Multipliers of a map applied twice. @param multipliers of the map applied once @return their squares by descending size
[[nodiscard]] std::vector<Multiplier> squared(std::vector<Multiplier> multipliers);

/// @brief Whether the powers of a Jacobian tend to zero: all its eigenvalues are inside the unit circle.
///
/// The matrix is squared until its norm is below 1; the error of the powers is bounded along the way, so that eigenvalues that
/// are ill-conditioned, as the zeros of a contact that sticks, do no harm.
/// @param jacobian  a square matrix
/// @param error     bound of its error, in the largest sum of a row
/// @return          true where every matrix within the error has them inside
[[nodiscard]] bool contracts(const Matrix<double>& jacobian, double error);

} // namespace denhartog
