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

/// @brief \f$ L^{-T}X \f$. @param L a lower triangular matrix without a zero on its diagonal @param X a matrix of as many rows
/// @return the solution of \f$ L^T Y = X \f$
template <class T>
[[nodiscard]] Matrix<T> divided_by_transpose(const Matrix<T>& L, const Matrix<T>& X);

/// @brief \f$ AB \f$. @param A a matrix @param B a matrix of as many rows as A has columns @return their product
template <class T>
[[nodiscard]] Matrix<T> product(const Matrix<T>& A, const Matrix<T>& B);

/// @brief \f$ Ax \f$. @param A a matrix @param x a column of as many numbers as A has columns @return their product
template <class T>
[[nodiscard]] Column<T> product(const Matrix<T>& A, const Column<T>& x);

/// @brief \f$ |A||x| \f$, entry by entry. @param A a matrix @param x a column of as many numbers as A has columns
/// @return the product of their sizes
template <class T>
[[nodiscard]] Column<T> product_of_sizes(const Matrix<T>& A, const Column<T>& x);

/// @brief \f$ \|A\|_\infty \f$. @param A a matrix, not empty @return the largest sum of the sizes of a row's entries
template <class T>
[[nodiscard]] T largest_row_sum(const Matrix<T>& A) {
    return A.cwiseAbs().rowwise().sum().maxCoeff();
}

/// @brief Whether a matrix has nothing beside its diagonal. @param A a square matrix @return true if so
template <class T>
[[nodiscard]] bool is_diagonal(const Matrix<T>& A) {
    for (Eigen::Index i = 0; i < A.rows(); ++i)
        for (Eigen::Index k = 0; k < A.cols(); ++k)
            if (k != i && A(i, k) != 0) return false;
    return true;
}

/// @brief \f$ X^TA \f$. @param X a matrix @param A a matrix of as many rows @return their product
template <class T>
[[nodiscard]] Matrix<T> transpose_times(const Matrix<T>& X, const Matrix<T>& A);

/// @brief \f$ X^TAX \f$: a matrix in the coordinates of which X has the shapes. @param X shapes, a column each
/// @param A  a square matrix of as many rows
/// @return   the matrix in the new coordinates
template <class T>
[[nodiscard]] Matrix<T> in_coordinates(const Matrix<T>& X, const Matrix<T>& A);

/// @brief A square matrix with its factors, by Gaussian elimination with row exchanges.
template <class T>
class LinearSystem {
public:
    /// @param A  a square matrix
    explicit LinearSystem(const Matrix<T>& A);
    ~LinearSystem();
    /// @param other  a system, which is left without its factors
    LinearSystem(LinearSystem&& other) noexcept;

    /// @brief The solution of \f$ Ax=b \f$. @param b the right side @return x
    [[nodiscard]] Column<T> solve(const Column<T>& b) const;
    /// @brief The inverse. @return \f$ A^{-1} \f$
    [[nodiscard]] Matrix<T> inverse() const;
    /// @brief An estimate of the reciprocal condition number. @return from 0 to 1
    [[nodiscard]] T reciprocal_condition() const;
    /// @brief Whether no pivot is rounding of the others. @return true if so
    [[nodiscard]] bool is_regular() const;

private:
    struct Factors;
    std::unique_ptr<Factors> factors_;
};

} // namespace denhartog
