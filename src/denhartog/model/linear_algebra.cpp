/// @file
/// @brief Eigen's symmetric eigensolver and triangular solves for the four number types.
#include "denhartog/model/symmetric_eigenproblem.hpp"

#include <Eigen/Eigenvalues>

#include "denhartog/number/errors.hpp"
#include "denhartog/number/multiprecision.hpp"

namespace denhartog {

template <class T>
SymmetricEigenproblem<T> symmetric_eigenproblem(const Matrix<T>& A) {
    const Eigen::SelfAdjointEigenSolver<Matrix<T>> solved(A);
    if (solved.info() != Eigen::Success) throw PrecisionError("the natural frequencies of the system did not converge");
    return {{solved.eigenvalues().begin(), solved.eigenvalues().end()}, solved.eigenvectors()};
}

template <class T>
Matrix<T> divide_out(const Matrix<T>& L, const Matrix<T>& X) {
    const auto lower = L.template triangularView<Eigen::Lower>();
    const Matrix<T> half = lower.solve(X);
    return lower.solve(Matrix<T>(half.transpose()));
}

template SymmetricEigenproblem<double> symmetric_eigenproblem(const Matrix<double>&);
template SymmetricEigenproblem<long double> symmetric_eigenproblem(const Matrix<long double>&);
template SymmetricEigenproblem<Real50> symmetric_eigenproblem(const Matrix<Real50>&);
template SymmetricEigenproblem<Real100> symmetric_eigenproblem(const Matrix<Real100>&);
template Matrix<double> divide_out(const Matrix<double>&, const Matrix<double>&);
template Matrix<long double> divide_out(const Matrix<long double>&, const Matrix<long double>&);
template Matrix<Real50> divide_out(const Matrix<Real50>&, const Matrix<Real50>&);
template Matrix<Real100> divide_out(const Matrix<Real100>&, const Matrix<Real100>&);

} // namespace denhartog
