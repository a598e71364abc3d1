/// @file
/// @brief Natural frequencies and products of mode shapes of a chain from its characteristic polynomial.
#pragma once

#include "tests/support/half_period.hpp"

namespace denhartog::conformance::generator {

/// @brief Natural modes without an eigenvector.
template <class T>
struct DeterminantModes {
    std::vector<T> lambda; ///< roots of det(K - lambda M), ascending: squares of the natural frequency ratios
    Matrix<T> products;    ///< phi_ki phi_ji with phi^T M phi = 1 for one j: mass k by mode i
};

/// @brief Roots of the characteristic polynomial det(K - lambda M) by Sturm's count and bisection. Both matrices are positive
/// definite, and no root exceeds the bound. Gives squares of the natural frequency ratios, ascending.
template <class T>
[[nodiscard]] std::vector<T> determinant_roots(const Matrix<T>& M, const Matrix<T>& K, const T& bound);

/// @brief Roots of the characteristic polynomial of a chain by Sturm's count and bisection, and residues of its receptance.
///
/// \f$ ((K-\lambda M)^{-1})_{kj} = \sum_i \phi_{ki}\phi_{ji}/(\lambda_i-\lambda) \f$, and by Cramer's rule the left side is a
/// product of leading and trailing minors over the determinant: each product is minus a residue. M is diagonal, K tridiagonal; j
/// counts from 0.
template <class T>
[[nodiscard]] DeterminantModes<T> determinant_modes(const Matrix<T>& M, const Matrix<T>& K, Eigen::Index j);

} // namespace denhartog::conformance::generator
