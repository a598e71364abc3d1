#include "denhartog/sums/coupled_friction.hpp"

#include <boost/math/special_functions/fpclassify.hpp>
#include <cmath>
#include <span>

#include "denhartog/evaluation/coupled_damping.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog {
namespace {

using std::abs;
using std::sqrt;

template <class T>
using BoundedMatrix = Matrix<Bounded<T>>;

template <class T>
BoundedMatrix<T> as_inputs(const Matrix<T>& A) {
    return A.unaryExpr([](const T& entry) { return as_input(entry); });
}

template <class T>
T size_of_errors(const BoundedMatrix<T>& A) {
    T sum(0);
    for (const Bounded<T>& entry : A.reshaped()) sum += entry.e * entry.e;
    return sqrt(sum);
}

// The factor L of A = L L^T.
template <class T>
BoundedMatrix<T> factor(const BoundedMatrix<T>& A) {
    const Eigen::Index N = A.rows();
    BoundedMatrix<T> L = BoundedMatrix<T>::Constant(N, N, Bounded<T>(0));
    for (Eigen::Index j = 0; j < N; ++j)
        for (Eigen::Index i = j; i < N; ++i) {
            Bounded<T> left = A(i, j);
            for (Eigen::Index k = 0; k < j; ++k) left -= L(i, k) * L(j, k);
            if (i > j) {
                L(i, j) = left / L(j, j);
                continue;
            }
            if (!(left.x > 2 * left.e))
                throw PrecisionError("masses or stiffnesses of the system differ by more than the number type has digits");
            L(i, i) = sqrt(left);
        }
    return L;
}

// L^-1 X for a lower triangular L.
template <class T>
BoundedMatrix<T> solved(const BoundedMatrix<T>& L, BoundedMatrix<T> X) {
    for (Eigen::Index c = 0; c < X.cols(); ++c)
        for (Eigen::Index i = 0; i < L.rows(); ++i) {
            for (Eigen::Index k = 0; k < i; ++k) X(i, c) -= L(i, k) * X(k, c);
            X(i, c) /= L(i, i);
        }
    return X;
}

template <class T>
BoundedMatrix<T> identity(Eigen::Index N) {
    BoundedMatrix<T> one = BoundedMatrix<T>::Constant(N, N, Bounded<T>(0));
    for (Eigen::Index i = 0; i < N; ++i) one(i, i) = Bounded<T>(1);
    return one;
}

template <class T>
Matrix<T> values(const BoundedMatrix<T>& A) {
    return A.unaryExpr([](const Bounded<T>& entry) { return entry.x; });
}
template <class T>
Matrix<T> errors(const BoundedMatrix<T>& A) {
    return A.unaryExpr([](const Bounded<T>& entry) { return entry.e; });
}

// A column a mass, and where the contact has a row of its own the difference of those of its masses.
template <class T>
BoundedMatrix<T> with_contact(BoundedMatrix<T> columns, const System<T>& s) {
    if (!s.contact_with) return columns;
    const auto j = static_cast<Eigen::Index>(s.contact.index), k = static_cast<Eigen::Index>(s.contact_with->index);
    columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
    for (Eigen::Index i = 0; i < columns.rows(); ++i) columns(i, columns.cols() - 1) = columns(i, j) - columns(i, k);
    return columns;
}

// Rows are kept as columns, so that each is one piece.
template <class T>
std::span<const T> row_of(const Matrix<T>& columns, std::size_t k) {
    return {&columns(0, static_cast<Eigen::Index>(k)), static_cast<std::size_t>(columns.rows())};
}
template <class T>
std::span<const T> numbers(const Column<T>& column) {
    return {column.data(), static_cast<std::size_t>(column.size())};
}

// Error of a step of one over the largest rate, over the size of what is carried: that of the power series by columns, and of the
// doublings of its matrix.
template <class T>
T rounding_of_step(Eigen::Index rows) {
    const int n = static_cast<int>(rows), terms = 16 + std::numeric_limits<T>::digits / 3;
    return unit_of<T>() * (sqrt(T(n)) * 3 * (n + terms) + n * n);
}

} // namespace

template <class T>
CoupledFriction<T>::CoupledFriction(const System<T>& system, const T& r) {
    set_coordinates(system, r);
    motion_ = CoupledMotion<T>(A_, std::max(T(1), size_of_A_), CoupledMotion<T>::Asked::instants_of_one_start, nullptr);
    set_start();
    motion_.start(c_);
}

template <class T>
void CoupledFriction<T>::set_coordinates(const System<T>& system, const T& r) {
    const auto N = static_cast<Eigen::Index>(number_of_masses(system));
    const auto j = static_cast<Eigen::Index>(contact_row(system).index);
    const BoundedMatrix<T> L = factor(as_inputs(mass_matrix(system))), G = factor(as_inputs(stiffness_matrix(system)));
    const BoundedMatrix<T> P = solved(L, G);
    const BoundedMatrix<T> half = solved(L, as_inputs(system.damping_matrix));
    const BoundedMatrix<T> B = solved(L, BoundedMatrix<T>(half.transpose()));
    const Bounded<T> bounded_r = as_input(r);
    std::vector<Bounded<T>> rows_of_P, rows_of_B;
    for (Eigen::Index i = 0; i < N; ++i)
        for (Eigen::Index k = 0; k < N; ++k) {
            const Bounded<T>&below = B(i, k), &above = B(k, i);
            rows_of_P.push_back(P(i, k));
            rows_of_B.push_back({T((below.x + above.x) / 2), T(std::max(below.e, above.e))});
        }
    const std::vector<Bounded<T>> rates = evaluation::energy_rates(
        std::span<const Bounded<T>>(rows_of_P), std::span<const Bounded<T>>(rows_of_B), static_cast<std::size_t>(N), bounded_r);
    const BoundedMatrix<T> A =
        Eigen::Map<const Eigen::Matrix<Bounded<T>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(rates.data(), 2 * N, 2 * N);
    A_ = values(A);
    size_of_A_ = A_.norm();
    error_of_A_ = size_of_errors(A);
    if (!boost::math::isfinite(size_of_A_) || !boost::math::isfinite(error_of_A_))
        throw PrecisionError("a rate of the damped system is beyond the range of the number type");
    const BoundedMatrix<T> inverse_of_G = with_contact(solved(G, identity<T>(N)), system);
    const BoundedMatrix<T> velocity = with_contact(solved(L, identity<T>(N)), system);
    BoundedMatrix<T> displacement = inverse_of_G;
    for (Bounded<T>& entry : displacement.reshaped()) entry *= bounded_r;
    displacement_ = {values(displacement), errors(displacement)};
    velocity_ = {values(velocity), errors(velocity)};
    rest_.resize(N);
    error_of_rest_ = T(0);
    inverse_inertia_ = Bounded<T>(0);
    for (Eigen::Index i = 0; i < N; ++i) {
        const Bounded<T> entry = inverse_of_G(i, j) / bounded_r;
        rest_(i) = entry.x;
        error_of_rest_ += entry.e;
        inverse_inertia_ += velocity(i, j) * velocity(i, j);
    }
    inverse_inertia_ = inverse_inertia_ / bounded_r / bounded_r;
}

template <class T>
void CoupledFriction<T>::set_start() {
    const Eigen::Index n = A_.rows();
    const T steps = 1 + pi<T>() * size_of_A_, of_exponential = T(pi<T>() * error_of_A_ + steps * rounding_of_step<T>(n));
    const PrecisionError too_few_digits(
        "the number type has too few digits to follow the motion under friction over half a period");
    if (!(of_exponential < T(1) / 16 && steps < T(0x1p52))) throw too_few_digits;
    const LinearSystem<T> system(Matrix<T>(T(2) * Matrix<T>::Identity(n, n) + motion_.growth_over_half_period()));
    const Matrix<T> inverse = system.inverse();
    Column<T> force = Column<T>::Zero(n);
    force.head(n / 2) = T(2) * rest_;
    c_ = product(inverse, force);
    const T size = inverse.norm(), lost = 2 * size * (of_exponential + 8 * static_cast<int>(n) * unit_of<T>());
    if (!(lost < T(1) / 16)) {
        if (steps * unit_of<T>() < T(1) / 65536 && size > T(1) / 16 / sqrt(unit_of<T>()))
            throw DomainError(
                "a motion without damping mirrors itself every half-period: friction at this frequency ratio has no "
                "steady motion");
        throw too_few_digits;
    }
    error_of_c_ = 2 * (lost * c_.norm() + size * error_of_rest_);
}

template <class T>
const CoupledState<T>& CoupledFriction<T>::at(const T& tau) const {
    constexpr std::size_t most_remembered = 4096;
    const auto found = known_.find(tau);
    if (found != known_.end()) return found->second;
    if (known_.size() >= most_remembered) known_.clear();
    CoupledState<T> s;
    s[0] = motion_.at(tau);
    for (std::size_t n = 1; n < s.size(); ++n) s[n] = motion_.rates(s[n - 1]);
    return known_.emplace(tau, std::move(s)).first->second;
}

template <class T>
T CoupledFriction<T>::error_at(const T& tau) const {
    return error_of_c_ + (tau * error_of_A_ + (1 + tau * size_of_A_) * rounding_of_step<T>(A_.rows())) * c_.norm();
}

template <class T>
T CoupledFriction<T>::derivative(std::size_t k, int order, const CoupledState<T>& s) const {
    const std::size_t N = size();
    return evaluation::derivative_under_friction(row_of(velocity_.value, k),
                                                 numbers(s[static_cast<std::size_t>(order - 1)]).last(N));
}

template <class T>
T CoupledFriction<T>::largest_derivative(std::size_t k, int order, const CoupledState<T>& s) const {
    return velocity_.value.col(static_cast<Eigen::Index>(k)).norm() * s[static_cast<std::size_t>(order - 1)].norm() *
           (1 + 64 * static_cast<int>(A_.rows()) * unit_of<T>());
}

template <class T>
T CoupledFriction<T>::rate_of_demand(std::size_t k, const CoupledState<T>& s) const {
    return velocity_.value.col(static_cast<Eigen::Index>(k)).norm() * Column<T>(s[3] + s[1]).norm() *
           (1 + 64 * static_cast<int>(A_.rows()) * unit_of<T>());
}

// A row times a half of the coordinates, which are off by no more than the error in size.
template <class T>
Bounded<T> CoupledFriction<T>::along(const Rows& rows, std::size_t k, const Column<T>& half, const T& error) const {
    const auto row = rows.value.col(static_cast<Eigen::Index>(k));
    const auto of_row = rows.error.col(static_cast<Eigen::Index>(k));
    T sum(0), size(0), of_rows(0), of_row_squared(0);
    for (Eigen::Index i = 0; i < half.size(); ++i) {
        const T each = row(i) * half(i);
        sum += each;
        size += abs(each);
        of_rows += of_row(i) * abs(half(i));
        of_row_squared += of_row(i) * of_row(i);
    }
    const T rounding = static_cast<int>(half.size() + 2) * unit_of<T>() * size;
    return Bounded<T>::of(sum, T(of_rows + (row.norm() + sqrt(of_row_squared)) * error), rounding);
}

template <class T>
evaluation::FrictionMotion<T> CoupledFriction<T>::motion(std::size_t k, const T& tau) const {
    const CoupledState<T>& s = at(tau);
    const T x =
        evaluation::displacement_under_friction(row_of(displacement_.value, k), numbers(rest_), numbers(s[0]).first(size()));
    return {x, derivative(k, 1, s), derivative(k, 2, s)};
}

template <class T>
evaluation::FrictionMotion<Bounded<T>> CoupledFriction<T>::motion(std::size_t k, const Bounded<T>& tau) const {
    const Eigen::Index N = A_.rows() / 2;
    const CoupledState<T>& s = at(tau.x);
    const T of_state = error_at(tau.x) + tau.e * (s[1].norm() + tau.e * s[2].norm());
    const T of_rate =
        size_of_A_ * of_state + (error_of_A_ + 4 * static_cast<int>(N + 1) * unit_of<T>() * size_of_A_) * s[0].norm();
    const Column<T> moved = rest_ - s[0].head(N);
    const T of_moved = of_state + error_of_rest_ + unit_of<T>() * moved.norm();
    return {along(displacement_, k, moved, of_moved), -along(velocity_, k, s[0].tail(N), of_state),
            -along(velocity_, k, s[1].tail(N), of_rate)};
}

template class CoupledFriction<double>;

} // namespace denhartog
