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
    double error;               ///< bound of the error of its size: of the n-th largest size, if this is the n-th
};

/// @brief Size of a multiplier, the same on every machine.
[[nodiscard]] double size_of(const std::complex<double>& multiplier);

/// @brief Whether there are multipliers, and all are certainly inside the unit circle.
[[nodiscard]] bool are_inside(const std::vector<Multiplier>& multipliers);

/// @brief Eigenvalues of a map's Jacobian by descending size, each with a bound of the error of its size; none if they were
/// not found. `error` bounds that of the matrix in Euclid's norm, and `most` the true sizes from elsewhere; each may be infinite.
[[nodiscard]] std::vector<Multiplier> multipliers_of(const Matrix<double>& jacobian, double error, double most);

/// @brief Eigenvalues of a matrix, and vectors that belong to them, to rounding.
struct ApproximateEigenvectors {
    Eigen::VectorXcd values;              ///< the eigenvalues; none if they were not found
    Matrix<std::complex<double>> vectors; ///< an eigenvector of each, in columns
    Matrix<std::complex<double>> inverse; ///< the inverse of these columns
};

/// @brief Eigenvalues and eigenvectors of a matrix, the same by every compiler. Nothing of it is proved.
[[nodiscard]] ApproximateEigenvectors eigenvectors_of(const Matrix<double>& A);

/// @brief Multipliers of a map applied twice, from those of the map applied once.
[[nodiscard]] std::vector<Multiplier> squared(std::vector<Multiplier> multipliers);

} // namespace denhartog
