/// @file
/// @brief Products, linear systems and symmetric eigenproblems: Eigen's, compiled once.
#pragma once

#include <memory>
#include <vector>

#include "denhartog/number/effort.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

/// @brief A column of numbers.
using Column = Eigen::Matrix<double, Eigen::Dynamic, 1>;

/// @brief Solution of a symmetric eigenproblem.
struct SymmetricEigenproblem {
    std::vector<double> values; ///< eigenvalues, ascending
    Matrix<double> vectors;     ///< orthonormal eigenvectors, a column each
};

/// @brief Solves an eigenproblem by the lower triangle of a symmetric matrix; PrecisionError where it does not converge.
[[nodiscard]] SymmetricEigenproblem symmetric_eigenproblem(const Matrix<double>& A, Effort* effort = nullptr);

/// @brief \f$ L^{-1}XL^{-T} \f$ with a lower triangular L: a matrix in coordinates in which \f$ LL^T \f$ is the unit matrix.
[[nodiscard]] Matrix<double> divide_out(const Matrix<double>& L, const Matrix<double>& X);

/// @brief \f$ L^{-T}X \f$ with a lower triangular L.
[[nodiscard]] Matrix<double> divided_by_transpose(const Matrix<double>& L, const Matrix<double>& X);

/// @brief \f$ AB \f$.
[[nodiscard]] Matrix<double> product(const Matrix<double>& A, const Matrix<double>& B);

/// @brief \f$ Ax \f$.
[[nodiscard]] Column product(const Matrix<double>& A, const Column& x);

/// @brief \f$ |A||x| \f$, entry by entry.
[[nodiscard]] Column product_of_sizes(const Matrix<double>& A, const Column& x);

/// @brief \f$ \|A\|_\infty \f$, the largest sum of the sizes of a row's entries.
[[nodiscard]] inline double largest_row_sum(const Matrix<double>& A) { return A.cwiseAbs().rowwise().sum().maxCoeff(); }

/// @brief True if a matrix has nothing beside its diagonal.
[[nodiscard]] inline bool is_diagonal(const Matrix<double>& A) {
    for (Eigen::Index i = 0; i < A.rows(); ++i)
        for (Eigen::Index k = 0; k < A.cols(); ++k)
            if (k != i && A(i, k) != 0) return false;
    return true;
}

/// @brief \f$ X^TA \f$.
[[nodiscard]] Matrix<double> transpose_times(const Matrix<double>& X, const Matrix<double>& A);

/// @brief \f$ X^TAX \f$: a matrix in the coordinates of which X has the shapes.
[[nodiscard]] Matrix<double> in_coordinates(const Matrix<double>& X, const Matrix<double>& A);

/// @brief A square matrix with its factors, by Gaussian elimination with row exchanges.
class LinearSystem {
public:
    explicit LinearSystem(const Matrix<double>& A); ///< factors a square matrix
    ~LinearSystem();
    LinearSystem(LinearSystem&& other) noexcept; ///< takes the factors of another system, which is left without

    /// @brief The solution of \f$ Ax=b \f$.
    [[nodiscard]] Column solve(const Column& b) const;
    /// @brief The inverse.
    [[nodiscard]] Matrix<double> inverse() const;
    /// @brief An estimate of the reciprocal condition number, from 0 to 1.
    [[nodiscard]] double reciprocal_condition() const;
    /// @brief True if no pivot is rounding of the others.
    [[nodiscard]] bool is_regular() const;

private:
    struct Factors;
    std::unique_ptr<Factors> factors_;
};

} // namespace denhartog
