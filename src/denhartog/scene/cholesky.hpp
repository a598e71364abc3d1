// Cholesky factors that say where a matrix stops being positive definite. Included by source files only.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "denhartog/number/errors.hpp"
#include "denhartog/scene/scene.hpp"

namespace denhartog {

// The factor L of A = L L^T, or the order of the leading minor at which there is none.
template <class T>
struct Cholesky {
    Matrix<T> L;                  // lower triangular; complete where `failed_order` is 0
    std::size_t failed_order = 0; // order of the first leading minor that is not positive, 0 where all are
    bool singular = false;        // that minor is zero to working precision, not clearly negative
};

// Factors a symmetric matrix. A pivot that is below N eps times the diagonal entry it was left over from has lost all its digits:
// it counts as zero.
template <class T>
[[nodiscard]] Cholesky<T> cholesky(const Matrix<T>& A) {
    using std::sqrt;
    const Eigen::Index N = A.rows();
    const T tolerance = std::numeric_limits<T>::epsilon() * static_cast<int>(N);
    Cholesky<T> result{Matrix<T>::Zero(N, N), 0, false};
    Matrix<T>& L = result.L;
    for (Eigen::Index j = 0; j < N; ++j) {
        L.col(j).tail(N - j) = A.col(j).tail(N - j);
        if (j > 0) L.col(j).tail(N - j).noalias() -= L.block(j, 0, N - j, j) * L.row(j).head(j).transpose();
        const T pivot = L(j, j);
        const T smallest = tolerance * A(j, j);
        if (!(pivot > smallest && A(j, j) > 0)) {
            result.failed_order = static_cast<std::size_t>(j) + 1;
            result.singular = A(j, j) >= 0 && pivot >= -smallest;
            return result;
        }
        L.col(j).tail(N - j) /= T(sqrt(pivot));
    }
    return result;
}

// The factor of a mass matrix that was positive definite as it was given. Throws PrecisionError where rounding leaves it
// indefinite.
template <class T>
[[nodiscard]] Matrix<T> factor_of_masses(const Matrix<T>& M) {
    Cholesky<T> factor = cholesky(M);
    if (factor.failed_order > 0) throw PrecisionError("the mass matrix is too near to a singular one for the number type");
    return std::move(factor.L);
}

} // namespace denhartog
