#include "denhartog/model/linear_algebra.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <concepts>
#include <limits>
#include <type_traits>

#include "denhartog/model/product_of_doubles.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/multiprecision.hpp"

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
        const Matrix<T> rows = A.transpose();
        const Matrix<T> columns = B;
        Eigen::Matrix<T, Eigen::Dynamic, Right::ColsAtCompileTime> product(A.rows(), B.cols());
        T each;
        for (Eigen::Index k = 0; k < product.cols(); ++k)
            for (Eigen::Index i = 0; i < product.rows(); ++i) {
                T sum(0);
                for (Eigen::Index m = 0; m < rows.rows(); ++m) {
                    eval_multiply(each.backend(), rows(m, i).backend(), columns(m, k).backend());
                    eval_add(sum.backend(), each.backend());
                }
                product(i, k) = sum;
            }
        return product;
    }
}

// Factors of more digits than a double has are computed in 100 digits and no other type: Eigen's solvers take the compiler longer
// than all else.
template <class T>
using Inside = std::conditional_t<std::floating_point<T>, T, Real100>;

// The matrix itself where it has the type.
template <class To, class From, int columns>
decltype(auto) taken_to(const Eigen::Matrix<From, Eigen::Dynamic, columns>& A) {
    if constexpr (std::same_as<To, From>)
        return (A);
    else
        return A.unaryExpr([](const From& x) { return static_cast<To>(x); }).eval();
}

// So many times the cube of an order are multiplied for a matrix.
template <class T>
void pay_for(int times, Eigen::Index order) {
    QuestionEffort::pay_for_products<T>(static_cast<long>(times * order * order * order));
}

} // namespace

template <class T>
SymmetricEigenproblem<T> symmetric_eigenproblem(const Matrix<T>& A) {
    pay_for<Inside<T>>(9, A.rows());
    const Eigen::SelfAdjointEigenSolver<Matrix<Inside<T>>> solved(taken_to<Inside<T>>(A));
    if (solved.info() != Eigen::Success) throw PrecisionError("the natural frequencies of the system did not converge");
    const Column<T> values = taken_to<T>(solved.eigenvalues());
    return {{values.begin(), values.end()}, taken_to<T>(solved.eigenvectors())};
}

template <class T>
Matrix<T> divide_out(const Matrix<T>& L, const Matrix<T>& X) {
    pay_for<T>(1, L.rows());
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
void mirror(Matrix<T>& A) {
    const Eigen::Index half = A.rows() / 2;
    for (Eigen::Index k = 0; k < A.cols(); ++k)
        for (Eigen::Index i = 0; i < k; ++i) A(k, i) = (i < half) == (k < half) ? A(i, k) : T(-A(i, k));
}

template <class T>
Matrix<T> square_of_mirrored(const Matrix<T>& A) {
    const Eigen::Index n = A.rows(), half = n / 2;
    Matrix<T> square(n, n);
    T each;
    for (Eigen::Index k = 0; k < n; ++k)
        for (Eigen::Index i = 0; i <= k; ++i) {
            T sum(0);
            for (Eigen::Index m = 0; m < n; ++m) {
                eval_multiply(each.backend(), A(m, i).backend(), A(m, k).backend());
                if (m < half)
                    eval_add(sum.backend(), each.backend());
                else
                    eval_subtract(sum.backend(), each.backend());
            }
            square(i, k) = i < half ? sum : T(-sum);
        }
    mirror(square);
    return square;
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
    pay_for<T>(2, A.rows());
    return times<T>(transpose_times(X, A), X);
}

template <class T>
struct LinearSystem<T>::Factors {
    Eigen::PartialPivLU<Matrix<Inside<T>>> of;
};

template <class T>
LinearSystem<T>::LinearSystem(const Matrix<T>& A) {
    pay_for<Inside<T>>(1, A.rows());
    factors_ = std::unique_ptr<Factors>(new Factors{Eigen::PartialPivLU<Matrix<Inside<T>>>(taken_to<Inside<T>>(A))});
}

template <class T>
LinearSystem<T>::~LinearSystem() = default;

template <class T>
LinearSystem<T>::LinearSystem(LinearSystem&&) noexcept = default;

template <class T>
Column<T> LinearSystem<T>::solve(const Column<T>& b) const {
    const Column<Inside<T>> x = factors_->of.solve(taken_to<Inside<T>>(b));
    return taken_to<T>(x);
}

template <class T>
Matrix<T> LinearSystem<T>::inverse() const {
    pay_for<Inside<T>>(1, factors_->of.rows());
    const Matrix<Inside<T>> inverse = factors_->of.inverse();
    return taken_to<T>(inverse);
}

template <class T>
T LinearSystem<T>::reciprocal_condition() const {
    return static_cast<T>(factors_->of.rcond());
}

template <class T>
bool LinearSystem<T>::is_regular() const {
    const auto pivots = factors_->of.matrixLU().diagonal().cwiseAbs();
    return pivots.minCoeff() > 16 * Inside<T>(std::numeric_limits<T>::epsilon()) * pivots.maxCoeff();
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
template Matrix<Real50> square_of_mirrored(const Matrix<Real50>&);
template Matrix<Real100> square_of_mirrored(const Matrix<Real100>&);
template void mirror(Matrix<double>&);
template void mirror(Matrix<Real50>&);
template void mirror(Matrix<Real100>&);
template Column<double> product(const Matrix<double>&, const Column<double>&);
template Column<double> product_of_sizes(const Matrix<double>&, const Column<double>&);
template Matrix<double> transpose_times(const Matrix<double>&, const Matrix<double>&);
template Column<Real50> product(const Matrix<Real50>&, const Column<Real50>&);
template Column<Real50> product_of_sizes(const Matrix<Real50>&, const Column<Real50>&);
template Matrix<Real50> transpose_times(const Matrix<Real50>&, const Matrix<Real50>&);
template Column<Real100> product(const Matrix<Real100>&, const Column<Real100>&);
template Column<Real100> product_of_sizes(const Matrix<Real100>&, const Column<Real100>&);
template Matrix<Real100> transpose_times(const Matrix<Real100>&, const Matrix<Real100>&);
template Matrix<double> in_coordinates(const Matrix<double>&, const Matrix<double>&);
template Matrix<Real50> in_coordinates(const Matrix<Real50>&, const Matrix<Real50>&);
template Matrix<Real100> in_coordinates(const Matrix<Real100>&, const Matrix<Real100>&);
template class LinearSystem<double>;
template class LinearSystem<Real50>;
template class LinearSystem<Real100>;

} // namespace denhartog
