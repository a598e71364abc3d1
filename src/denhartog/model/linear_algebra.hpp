/// @file
/// @brief Products, linear systems and symmetric eigenproblems: Eigen's, compiled once.
#pragma once

#include <memory>
#include <vector>

#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief A column of numbers.
template <class T>
using Column = Eigen::Matrix<T, Eigen::Dynamic, 1>;

/// @brief Solution of a symmetric eigenproblem.
template <class T>
struct SymmetricEigenproblem {
    std::vector<T> values; ///< eigenvalues, ascending
    Matrix<T> vectors;     ///< orthonormal eigenvectors, a column each
};

/// @brief Solves an eigenproblem by the lower triangle of a symmetric matrix; PrecisionError where the iteration does not
/// converge.
template <class T>
[[nodiscard]] SymmetricEigenproblem<T> symmetric_eigenproblem(const Matrix<T>& A);

/// @brief \f$ L^{-1}XL^{-T} \f$ with a lower triangular L: a matrix in coordinates in which \f$ LL^T \f$ is the unit matrix.
template <class T>
[[nodiscard]] Matrix<T> divide_out(const Matrix<T>& L, const Matrix<T>& X);

/// @brief \f$ L^{-T}X \f$ with a lower triangular L.
template <class T>
[[nodiscard]] Matrix<T> divided_by_transpose(const Matrix<T>& L, const Matrix<T>& X);

/// @brief \f$ AB \f$.
template <class T>
[[nodiscard]] Matrix<T> product(const Matrix<T>& A, const Matrix<T>& B);

/// @brief \f$ Ax \f$.
template <class T>
[[nodiscard]] Column<T> product(const Matrix<T>& A, const Column<T>& x);

/// @brief \f$ |A||x| \f$, entry by entry.
template <class T>
[[nodiscard]] Column<T> product_of_sizes(const Matrix<T>& A, const Column<T>& x);

/// @brief \f$ \|A\|_\infty \f$, the largest sum of the sizes of a row's entries.
template <class T>
[[nodiscard]] T largest_row_sum(const Matrix<T>& A) {
    return A.cwiseAbs().rowwise().sum().maxCoeff();
}

/// @brief Whether a matrix has nothing beside its diagonal.
template <class T>
[[nodiscard]] bool is_diagonal(const Matrix<T>& A) {
    for (Eigen::Index i = 0; i < A.rows(); ++i)
        for (Eigen::Index k = 0; k < A.cols(); ++k)
            if (k != i && A(i, k) != 0) return false;
    return true;
}

/// @brief \f$ X^TA \f$.
template <class T>
[[nodiscard]] Matrix<T> transpose_times(const Matrix<T>& X, const Matrix<T>& A);

/// @brief \f$ X^TAX \f$: a matrix in the coordinates of which X has the shapes.
template <class T>
[[nodiscard]] Matrix<T> in_coordinates(const Matrix<T>& X, const Matrix<T>& A);

/// @brief A square matrix with its factors, by Gaussian elimination with row exchanges.
template <class T>
class LinearSystem {
public:
    /// @brief Factors a square matrix.
    explicit LinearSystem(const Matrix<T>& A);
    ~LinearSystem();
    /// @brief Takes the factors of another system, which is left without.
    LinearSystem(LinearSystem&& other) noexcept;

    /// @brief The solution of \f$ Ax=b \f$.
    [[nodiscard]] Column<T> solve(const Column<T>& b) const;
    /// @brief The inverse.
    [[nodiscard]] Matrix<T> inverse() const;
    /// @brief An estimate of the reciprocal condition number, from 0 to 1.
    [[nodiscard]] T reciprocal_condition() const;
    /// @brief Whether no pivot is rounding of the others.
    [[nodiscard]] bool is_regular() const;

private:
    struct Factors;
    std::unique_ptr<Factors> factors_;
};

} // namespace denhartog
