#include "denhartog/model/linear_algebra.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <concepts>
#include <limits>
#include <type_traits>

#include "denhartog/model/product_of_doubles.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog {
namespace {

// Eigen's own products of doubles add up in an order that depends on the processor and its caches.
template <class T, class Left, class Right>
auto times(const Left& A, const Right& B) {
    if constexpr (std::same_as<T, double>) {
        const Eigen::Ref<const Matrix<double>> a(A), b(B);
        Eigen::Matrix<double, Eigen::Dynamic, Right::ColsAtCompileTime> product(a.rows(), b.cols());
        product_of_doubles({a.data(), a.rows(), a.cols(), a.outerStride()}, {b.data(), b.rows(), b.cols(), b.outerStride()},
                           product.data());
        return product;
    } else {
        return A.lazyProduct(B).eval();
    }
}

// So many times the cube of an order are multiplied for a matrix.
void pay_for(int times, Eigen::Index order) {
    QuestionEffort::pay_for_products(static_cast<long>(times * order * order * order));
}

} // namespace

template <class T>
SymmetricEigenproblem<T> symmetric_eigenproblem(const Matrix<T>& A) {
    pay_for(9, A.rows());
    const Eigen::SelfAdjointEigenSolver<Matrix<T>> solved(A);
    if (solved.info() != Eigen::Success) throw PrecisionError("the natural frequencies of the system did not converge");
    const Column<T> values = solved.eigenvalues();
    return {{values.begin(), values.end()}, solved.eigenvectors()};
}

template <class T>
Matrix<T> divide_out(const Matrix<T>& L, const Matrix<T>& X) {
    pay_for(1, L.rows());
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
    return times<T>(A, B);
}

template <class T>
Column<T> product(const Matrix<T>& A, const Column<T>& x) {
    return times<T>(A, x);
}

template <class T>
Column<T> product_of_sizes(const Matrix<T>& A, const Column<T>& x) {
    return times<T>(A.cwiseAbs(), x.cwiseAbs());
}

template <class T>
Matrix<T> transpose_times(const Matrix<T>& X, const Matrix<T>& A) {
    return times<T>(X.transpose(), A);
}

template <class T>
Matrix<T> in_coordinates(const Matrix<T>& X, const Matrix<T>& A) {
    pay_for(2, A.rows());
    return times<T>(transpose_times(X, A), X);
}

template <class T>
struct LinearSystem<T>::Factors {
    Eigen::PartialPivLU<Matrix<T>> of;
};

template <class T>
LinearSystem<T>::LinearSystem(const Matrix<T>& A) {
    pay_for(1, A.rows());
    factors_ = std::unique_ptr<Factors>(new Factors{Eigen::PartialPivLU<Matrix<T>>(A)});
}

template <class T>
LinearSystem<T>::~LinearSystem() = default;

template <class T>
LinearSystem<T>::LinearSystem(LinearSystem&&) noexcept = default;

template <class T>
Column<T> LinearSystem<T>::solve(const Column<T>& b) const {
    const Column<T> x = factors_->of.solve(b);
    return x;
}

template <class T>
Matrix<T> LinearSystem<T>::inverse() const {
    pay_for(1, factors_->of.rows());
    const Matrix<T> inverse = factors_->of.inverse();
    return inverse;
}

template <class T>
T LinearSystem<T>::reciprocal_condition() const {
    return static_cast<T>(factors_->of.rcond());
}

template <class T>
bool LinearSystem<T>::is_regular() const {
    const auto pivots = factors_->of.matrixLU().diagonal().cwiseAbs();
    return pivots.minCoeff() > 16 * T(std::numeric_limits<T>::epsilon()) * pivots.maxCoeff();
}

template SymmetricEigenproblem<double> symmetric_eigenproblem(const Matrix<double>&);
template Matrix<double> divide_out(const Matrix<double>&, const Matrix<double>&);
template Matrix<double> divided_by_transpose(const Matrix<double>&, const Matrix<double>&);
template Matrix<double> product(const Matrix<double>&, const Matrix<double>&);
template Column<double> product(const Matrix<double>&, const Column<double>&);
template Column<double> product_of_sizes(const Matrix<double>&, const Column<double>&);
template Matrix<double> transpose_times(const Matrix<double>&, const Matrix<double>&);
template Matrix<double> in_coordinates(const Matrix<double>&, const Matrix<double>&);
template class LinearSystem<double>;

} // namespace denhartog
