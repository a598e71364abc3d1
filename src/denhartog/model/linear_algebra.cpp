#include "denhartog/model/linear_algebra.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

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

template <class T>
Matrix<T> divided_by_transpose(const Matrix<T>& L, const Matrix<T>& X) {
    return L.transpose().template triangularView<Eigen::Upper>().solve(X);
}

template <class T>
Matrix<T> product(const Matrix<T>& A, const Matrix<T>& B) {
    return A * B;
}

template <class T>
Matrix<T> transpose_times(const Matrix<T>& X, const Matrix<T>& A) {
    return X.transpose() * A;
}

template <class T>
Matrix<T> in_coordinates(const Matrix<T>& X, const Matrix<T>& A) {
    return X.transpose() * A * X;
}

template <class T>
struct LinearSystem<T>::Factors {
    Eigen::PartialPivLU<Matrix<T>> of;
};

template <class T>
LinearSystem<T>::LinearSystem(const Matrix<T>& A) : factors_(new Factors{Eigen::PartialPivLU<Matrix<T>>(A)}) {}

template <class T>
LinearSystem<T>::~LinearSystem() = default;

template <class T>
LinearSystem<T>::LinearSystem(LinearSystem&&) noexcept = default;

template <class T>
Column<T> LinearSystem<T>::solve(const Column<T>& b) const {
    return factors_->of.solve(b);
}

template <class T>
Matrix<T> LinearSystem<T>::inverse() const {
    return factors_->of.inverse();
}

template <class T>
T LinearSystem<T>::reciprocal_condition() const {
    return factors_->of.rcond();
}

template <class T>
bool LinearSystem<T>::is_regular() const {
    const auto pivots = factors_->of.matrixLU().diagonal().cwiseAbs();
    return pivots.minCoeff() > 16 * std::numeric_limits<T>::epsilon() * pivots.maxCoeff();
}

template SymmetricEigenproblem<double> symmetric_eigenproblem(const Matrix<double>&);
template SymmetricEigenproblem<Real50> symmetric_eigenproblem(const Matrix<Real50>&);
template SymmetricEigenproblem<Real100> symmetric_eigenproblem(const Matrix<Real100>&);
template Matrix<double> divide_out(const Matrix<double>&, const Matrix<double>&);
template Matrix<Real50> divide_out(const Matrix<Real50>&, const Matrix<Real50>&);
template Matrix<Real100> divide_out(const Matrix<Real100>&, const Matrix<Real100>&);
template Matrix<double> divided_by_transpose(const Matrix<double>&, const Matrix<double>&);
template Matrix<Real50> divided_by_transpose(const Matrix<Real50>&, const Matrix<Real50>&);
template Matrix<Real100> divided_by_transpose(const Matrix<Real100>&, const Matrix<Real100>&);
template Matrix<double> product(const Matrix<double>&, const Matrix<double>&);
template Matrix<Real50> product(const Matrix<Real50>&, const Matrix<Real50>&);
template Matrix<Real100> product(const Matrix<Real100>&, const Matrix<Real100>&);
template Matrix<double> transpose_times(const Matrix<double>&, const Matrix<double>&);
template Matrix<Real50> transpose_times(const Matrix<Real50>&, const Matrix<Real50>&);
template Matrix<Real100> transpose_times(const Matrix<Real100>&, const Matrix<Real100>&);
template Matrix<double> in_coordinates(const Matrix<double>&, const Matrix<double>&);
template Matrix<Real50> in_coordinates(const Matrix<Real50>&, const Matrix<Real50>&);
template Matrix<Real100> in_coordinates(const Matrix<Real100>&, const Matrix<Real100>&);
template class LinearSystem<double>;
template class LinearSystem<Real50>;
template class LinearSystem<Real100>;

} // namespace denhartog
