/// @file
/// @brief Eigenvalues and eigenvectors of a symmetric matrix, and the congruence that makes a general problem one.
///
/// Eigen's solvers, compiled once for the four number types: in multiprecision they take the compiler longer than all else.
#pragma once

#include <vector>

#include "denhartog/model/scene.hpp"

namespace denhartog {

/// @brief Solution of a symmetric eigenproblem.
template <class T>
struct SymmetricEigenproblem {
    std::vector<T> values; ///< eigenvalues, ascending
    Matrix<T> vectors;     ///< orthonormal eigenvectors, a column each
};

/// @brief Solves a symmetric eigenproblem.
/// @param A  a symmetric matrix; its lower triangle is read
/// @return   eigenvalues and eigenvectors
/// @throws   PrecisionError where the iteration does not converge
template <class T>
[[nodiscard]] SymmetricEigenproblem<T> symmetric_eigenproblem(const Matrix<T>& A);

/// @brief \f$ L^{-1}XL^{-T} \f$: a matrix in coordinates in which \f$ LL^T \f$ is the unit matrix.
/// @param L  a lower triangular matrix without a zero on its diagonal
/// @param X  a matrix of the same size
/// @return   the matrix in the new coordinates
template <class T>
[[nodiscard]] Matrix<T> divide_out(const Matrix<T>& L, const Matrix<T>& X);

} // namespace denhartog
