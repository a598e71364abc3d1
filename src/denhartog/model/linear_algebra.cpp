// Products, linear systems and symmetric eigenproblems of doubles. Products are formed in an order of our own, `times`, since
// that of Eigen depends on the processor; the factorizations are Eigen's.
#include "denhartog/model/linear_algebra.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <limits>

#include "denhartog/model/detail/product_of_doubles.hpp"
#include "denhartog/number/why.hpp"

namespace denhartog {
namespace {

// Eigen's own products of doubles add up in an order that depends on the processor and its caches.
template <class Left, class Right>
auto times(const Left& A, const Right& B) {
    const Eigen::Ref<const Matrix<double>> a(A), b(B);
    Eigen::Matrix<double, Eigen::Dynamic, Right::ColsAtCompileTime> product(a.rows(), b.cols());
    product_of_doubles({a.data(), a.rows(), a.cols(), a.outerStride()}, {b.data(), b.rows(), b.cols(), b.outerStride()},
                       product.data());
    return product;
}

} // namespace

SymmetricEigenproblem symmetric_eigenproblem(const Matrix<double>& A, Effort* effort) {
    pay_for_products(effort, 9 * static_cast<long>(A.rows() * A.rows() * A.rows()));
    const Eigen::SelfAdjointEigenSolver<Matrix<double>> solved(A);
    if (solved.info() != Eigen::Success) throw PrecisionError(Why::modes_not_converged, Outcome::not_converged);
    const Column values = solved.eigenvalues();
    return {{values.begin(), values.end()}, solved.eigenvectors()};
}

Matrix<double> divide_out(const Matrix<double>& L, const Matrix<double>& X) {
    const auto lower = L.triangularView<Eigen::Lower>();
    const Matrix<double> half = lower.solve(X);
    return lower.solve(Matrix<double>(half.transpose()));
}

Matrix<double> divided_by_transpose(const Matrix<double>& L, const Matrix<double>& X) {
    return L.transpose().triangularView<Eigen::Upper>().solve(X);
}

Matrix<double> product(const Matrix<double>& A, const Matrix<double>& B) { return times(A, B); }

Column product(const Matrix<double>& A, const Column& x) { return times(A, x); }

Column product_of_sizes(const Matrix<double>& A, const Column& x) { return times(A.cwiseAbs(), x.cwiseAbs()); }

Matrix<double> transpose_times(const Matrix<double>& X, const Matrix<double>& A) { return times(X.transpose(), A); }

Matrix<double> in_coordinates(const Matrix<double>& X, const Matrix<double>& A) { return times(transpose_times(X, A), X); }

struct LinearSystem::Factors {
    Eigen::PartialPivLU<Matrix<double>> of;
};

LinearSystem::LinearSystem(const Matrix<double>& A) : factors_(new Factors{Eigen::PartialPivLU<Matrix<double>>(A)}) {}

LinearSystem::~LinearSystem() = default;

LinearSystem::LinearSystem(LinearSystem&&) noexcept = default;

Column LinearSystem::solve(const Column& b) const {
    const Column x = factors_->of.solve(b);
    return x;
}

Matrix<double> LinearSystem::inverse() const {
    const Matrix<double> inverse = factors_->of.inverse();
    return inverse;
}

double LinearSystem::reciprocal_condition() const { return factors_->of.rcond(); }

bool LinearSystem::is_regular() const {
    const auto pivots = factors_->of.matrixLU().diagonal().cwiseAbs();
    return pivots.minCoeff() > 16 * std::numeric_limits<double>::epsilon() * pivots.maxCoeff();
}

} // namespace denhartog
