// Sliding of a system whose damping couples the modes: the motion with the symmetry (25) under a constant force of one sign, in
// energy coordinates, and linear systems in place of the sums (33)-(35): there are no modes to sum over. Read `coupled_sums` at the end first,
// then `CoupledFriction::set_coordinates` and `set_start`; `motion` is the brace of (41) at an instant.
#include "denhartog/sliding/coupled_sums.hpp"

#include <algorithm>
#include <boost/math/special_functions/fpclassify.hpp>
#include <cmath>
#include <limits>
#include <span>

#include "denhartog/evaluation/coupled_damping.hpp"
#include "denhartog/number/why.hpp"

namespace denhartog {
namespace {

using std::abs;
using std::sqrt;

using BoundedMatrix = Matrix<Bounded<double>>;

BoundedMatrix as_inputs(const Matrix<double>& A) {
    return A.unaryExpr([](double entry) { return as_input(entry); });
}

double size_of_errors(const BoundedMatrix& A) {
    double sum(0);
    for (const Bounded<double>& entry : A.reshaped()) sum += entry.e * entry.e;
    return sqrt(sum);
}

// The factor L of A = L L^T.
BoundedMatrix factor(const BoundedMatrix& A) {
    const Eigen::Index N = A.rows();
    BoundedMatrix L = BoundedMatrix::Constant(N, N, Bounded<double>(0));
    for (Eigen::Index j = 0; j < N; ++j)
        for (Eigen::Index i = j; i < N; ++i) {
            Bounded<double> left = A(i, j);
            for (Eigen::Index k = 0; k < j; ++k) left -= L(i, k) * L(j, k);
            if (i > j) {
                L(i, j) = left / L(j, j);
                continue;
            }
            if (!(left.x > 2 * left.e)) throw PrecisionError(Why::entries_differ);
            L(i, i) = sqrt(left);
        }
    return L;
}

// L^-1 X for a lower triangular L.
BoundedMatrix solved(const BoundedMatrix& L, BoundedMatrix X) {
    for (Eigen::Index c = 0; c < X.cols(); ++c)
        for (Eigen::Index i = 0; i < L.rows(); ++i) {
            for (Eigen::Index k = 0; k < i; ++k) X(i, c) -= L(i, k) * X(k, c);
            X(i, c) /= L(i, i);
        }
    return X;
}

Matrix<double> values(const BoundedMatrix& A) {
    return A.unaryExpr([](const Bounded<double>& entry) { return entry.x; });
}
Matrix<double> errors(const BoundedMatrix& A) {
    return A.unaryExpr([](const Bounded<double>& entry) { return entry.e; });
}

// A column a mass, and where the contact has a row of its own w^T of them.
BoundedMatrix with_contact(BoundedMatrix columns, const System<double>& s) {
    if (!contact_moves_apart(s)) return columns;
    const Eigen::Index N = columns.cols();
    columns.conservativeResize(Eigen::NoChange, N + 1);
    for (Eigen::Index i = 0; i < columns.rows(); ++i)
        columns(i, N) =
            along_contact<Bounded<double>>(s, [&](std::size_t k) { return columns(i, static_cast<Eigen::Index>(k)); });
    return columns;
}

// Rows are kept as columns, so that each is one piece.
std::span<const double> row_of(const Matrix<double>& columns, std::size_t k) {
    return {&columns(0, static_cast<Eigen::Index>(k)), static_cast<std::size_t>(columns.rows())};
}
std::span<const double> numbers(const Column& column) { return {column.data(), static_cast<std::size_t>(column.size())}; }

// Error of a step of one over the largest rate, over the size of what is carried: that of the power series by columns, and of the
// doublings of its matrix.
double rounding_of_step(Eigen::Index rows) {
    const int n = static_cast<int>(rows), terms = 16 + std::numeric_limits<double>::digits / 3;
    return unit_of<double>() * (std::sqrt(static_cast<double>(n)) * 3 * (n + terms) + n * n);
}

} // namespace

CoupledFriction::CoupledFriction(const System<double>& system, double r, Effort* effort) {
    set_coordinates(system, r);
    motion_ = CoupledMotion(A_, std::max(1.0, size_of_A_), CoupledMotion::Asked::instants_of_one_start, &effort);
    set_start();
    motion_.pay_no_more();
    motion_.start(c_);
}

void CoupledFriction::set_coordinates(const System<double>& system, double r) {
    const auto N = static_cast<Eigen::Index>(number_of_masses(system));
    const auto j = static_cast<Eigen::Index>(contact_row(system).index);
    const BoundedMatrix L = factor(as_inputs(mass_matrix(system))), G = factor(as_inputs(stiffness_matrix(system)));
    const BoundedMatrix P = solved(L, G);
    const BoundedMatrix half = solved(L, as_inputs(system.damping_matrix));
    const BoundedMatrix B = solved(L, BoundedMatrix(half.transpose()));
    const Bounded<double> bounded_r = as_input(r);
    std::vector<Bounded<double>> rows_of_P, rows_of_B;
    for (Eigen::Index i = 0; i < N; ++i)
        for (Eigen::Index k = 0; k < N; ++k) {
            const Bounded<double>&below = B(i, k), &above = B(k, i);
            rows_of_P.push_back(P(i, k));
            rows_of_B.push_back({(below.x + above.x) / 2, std::max(below.e, above.e)});
        }
    const std::vector<Bounded<double>> rates =
        evaluation::energy_rates(std::span<const Bounded<double>>(rows_of_P), std::span<const Bounded<double>>(rows_of_B),
                                 static_cast<std::size_t>(N), bounded_r);
    const BoundedMatrix A = Eigen::Map<const Eigen::Matrix<Bounded<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
        rates.data(), 2 * N, 2 * N);
    A_ = values(A);
    size_of_A_ = A_.norm();
    error_of_A_ = size_of_errors(A);
    if (!boost::math::isfinite(size_of_A_) || !boost::math::isfinite(error_of_A_))
        throw PrecisionError(Why::rate_out_of_range, Outcome::out_of_range);
    const BoundedMatrix inverse_of_G = with_contact(solved(G, BoundedMatrix::Identity(N, N)), system);
    const BoundedMatrix velocity = with_contact(solved(L, BoundedMatrix::Identity(N, N)), system);
    BoundedMatrix displacement = inverse_of_G;
    for (Bounded<double>& entry : displacement.reshaped()) entry *= bounded_r;
    displacement_ = {values(displacement), errors(displacement)};
    velocity_ = {values(velocity), errors(velocity)};
    rest_.resize(N);
    error_of_rest_ = 0.0;
    inverse_inertia_ = Bounded<double>(0);
    for (Eigen::Index i = 0; i < N; ++i) {
        const Bounded<double> entry = inverse_of_G(i, j) / bounded_r;
        rest_(i) = entry.x;
        error_of_rest_ += entry.e;
        inverse_inertia_ += velocity(i, j) * velocity(i, j);
    }
    inverse_inertia_ = inverse_inertia_ / bounded_r / bounded_r;
}

void CoupledFriction::set_start() {
    const Eigen::Index n = A_.rows();
    const double steps = 1 + pi<double>() * size_of_A_,
                 error_of_exponential = pi<double>() * error_of_A_ + steps * rounding_of_step(n);
    const PrecisionError too_few_digits(Why::friction_without_digits);
    if (!(error_of_exponential < 1.0 / 16 && steps < 0x1p52)) throw too_few_digits;
    const LinearSystem system(Matrix<double>(2.0 * Matrix<double>::Identity(n, n) + motion_.growth_over_half_period()));
    const Matrix<double> inverse = system.inverse();
    Column force = Column::Zero(n);
    force.head(n / 2) = 2.0 * rest_;
    c_ = product(inverse, force);
    const double size = inverse.norm(), lost = 2 * size * (error_of_exponential + 8 * static_cast<int>(n) * unit_of<double>());
    if (!(lost < 1.0 / 16)) {
        if (steps * unit_of<double>() < 1.0 / 65536 && size > 1.0 / 16 / sqrt(unit_of<double>()))
            throw DomainError(Why::motion_mirrors_itself);
        throw too_few_digits;
    }
    error_of_c_ = 2 * (lost * c_.norm() + size * error_of_rest_);
}

const CoupledState& CoupledFriction::at(double tau) const {
    constexpr std::size_t most_remembered = 4096;
    const auto found = known_.find(tau);
    if (found != known_.end()) return found->second;
    if (known_.size() >= most_remembered) known_.clear();
    CoupledState s;
    s[0] = motion_.at(tau);
    for (std::size_t n = 1; n < s.size(); ++n) s[n] = motion_.rates(s[n - 1]);
    return known_.emplace(tau, std::move(s)).first->second;
}

double CoupledFriction::error_at(double tau) const {
    return error_of_c_ + (tau * error_of_A_ + (1 + tau * size_of_A_) * rounding_of_step(A_.rows())) * c_.norm();
}

double CoupledFriction::derivative(std::size_t k, int order, const CoupledState& s) const {
    const std::size_t N = size();
    return evaluation::derivative_under_friction(row_of(velocity_.value, k),
                                                 numbers(s[static_cast<std::size_t>(order - 1)]).last(N));
}

double CoupledFriction::largest_derivative(std::size_t k, int order, const CoupledState& s) const {
    return velocity_.value.col(static_cast<Eigen::Index>(k)).norm() * s[static_cast<std::size_t>(order - 1)].norm() *
           (1 + 64 * static_cast<int>(A_.rows()) * unit_of<double>());
}

double CoupledFriction::rate_of_demand(std::size_t k, const CoupledState& s) const {
    return velocity_.value.col(static_cast<Eigen::Index>(k)).norm() * Column(s[3] + s[1]).norm() *
           (1 + 64 * static_cast<int>(A_.rows()) * unit_of<double>());
}

// A row times a half of the coordinates, which are off by no more than the error in size.
Bounded<double> CoupledFriction::along(const Rows& rows, std::size_t k, const Column& half, double error) const {
    const auto row = rows.value.col(static_cast<Eigen::Index>(k));
    const auto errors_of_row = rows.error.col(static_cast<Eigen::Index>(k));
    double sum(0), size(0), error_of_rows(0), square_of_row_errors(0);
    for (Eigen::Index i = 0; i < half.size(); ++i) {
        const double each = row(i) * half(i);
        sum += each;
        size += abs(each);
        error_of_rows += errors_of_row(i) * abs(half(i));
        square_of_row_errors += errors_of_row(i) * errors_of_row(i);
    }
    const double rounding = static_cast<int>(half.size() + 2) * unit_of<double>() * size;
    return Bounded<double>::of(sum, error_of_rows + (row.norm() + sqrt(square_of_row_errors)) * error, rounding);
}

evaluation::FrictionMotion<double> CoupledFriction::motion(std::size_t k, double tau) const {
    const CoupledState& s = at(tau);
    const double x =
        evaluation::displacement_under_friction(row_of(displacement_.value, k), numbers(rest_), numbers(s[0]).first(size()));
    return {x, derivative(k, 1, s), derivative(k, 2, s)};
}

evaluation::FrictionMotion<Bounded<double>> CoupledFriction::motion(std::size_t k, const Bounded<double>& tau) const {
    const Eigen::Index N = A_.rows() / 2;
    const CoupledState& s = at(tau.x);
    const double error_of_state = error_at(tau.x) + tau.e * (s[1].norm() + tau.e * s[2].norm());
    const double error_of_rate =
        size_of_A_ * error_of_state + (error_of_A_ + 4 * static_cast<int>(N + 1) * unit_of<double>() * size_of_A_) * s[0].norm();
    const Column moved = rest_ - s[0].head(N);
    const double error_of_moved = error_of_state + error_of_rest_ + unit_of<double>() * moved.norm();
    return {along(displacement_, k, moved, error_of_moved), -along(velocity_, k, s[0].tail(N), error_of_state),
            -along(velocity_, k, s[1].tail(N), error_of_rate)};
}

BoundedSystem::BoundedSystem(const Matrix<double>& A, const Matrix<double>& error)
    : A_(A), error_(error + (4 * static_cast<int>(A.rows() + 2) * unit_of<double>()) * A.cwiseAbs()) {
    const LinearSystem system(A_);
    is_regular_ = system.is_regular();
    inverse_ = system.inverse();
}

std::vector<Bounded<double>> BoundedSystem::solved(const Column& b, const Column& error_of_b) const {
    const Column x = product(inverse_, b);
    const Column left_over =
        (b - product(A_, x)).cwiseAbs() + product_of_sizes(error_, x) + (4 * unit_of<double>()) * b.cwiseAbs() + error_of_b;
    const Column error = 2.0 * (product_of_sizes(inverse_, left_over) + unit_of<double>() * x.cwiseAbs());
    std::vector<Bounded<double>> all;
    for (Eigen::Index k = 0; k < x.size(); ++k) all.emplace_back(x(k), error(k));
    return all;
}

BoundedSystem harmonic_system(const Matrix<double>& M, const Matrix<double>& C, const Matrix<double>& K,
                              const Matrix<double>& error_of_C, const Bounded<double>& r) {
    const Eigen::Index n = K.rows();
    const double error_of_r = 2 * r.e / r.x;
    const Matrix<double> inertia = (r.x * r.x) * M, damping = r.x * C, rest = K - inertia;
    const Matrix<double> error_of_rest =
                             error_of_r * inertia.cwiseAbs() + (4 * unit_of<double>()) * (K.cwiseAbs() + inertia.cwiseAbs()),
                         error_of_damping = error_of_r * damping.cwiseAbs() + r.x * error_of_C;
    Matrix<double> A(2 * n, 2 * n), error(2 * n, 2 * n);
    A << rest, -damping, damping, rest;
    error << error_of_rest, error_of_damping, error_of_damping, error_of_rest;
    return {A, error};
}

std::vector<Complex<Bounded<double>>> harmonic_responses(const BoundedSystem& system, const std::vector<Complex<double>>& forces,
                                                         const std::vector<double>& errors) {
    const std::size_t n = forces.size();
    Column b = Column::Zero(static_cast<Eigen::Index>(2 * n)), error_of_b = b;
    for (std::size_t k = 0; k < n; ++k) {
        const auto row = static_cast<Eigen::Index>(k), row_of_sine = static_cast<Eigen::Index>(n + k);
        b(row) = forces[k].re;
        b(row_of_sine) = forces[k].im;
        if (!errors.empty()) error_of_b(row) = error_of_b(row_of_sine) = errors[k];
    }
    const std::vector<Bounded<double>> X = system.solved(b, error_of_b);
    std::vector<Complex<Bounded<double>>> V;
    for (std::size_t k = 0; k < n; ++k) V.push_back({X[k], X[n + k]});
    return V;
}

ModeSums<Bounded<double>> coupled_sums(const System<double>& system, const Bounded<double>& r, Effort* effort) {
    const auto friction = std::make_shared<const CoupledFriction>(system, r.x, effort);
    const Matrix<double> M = mass_matrix(system), C = system.damping_matrix;
    const BoundedSystem motion = harmonic_system(M, C, stiffness_matrix(system), Matrix<double>::Zero(C.rows(), C.rows()), r);
    if (!motion.is_regular()) throw DomainError(Why::response_33_is_infinite);
    const auto to = [&](const std::vector<Complex<double>>& forces, const std::vector<double>& errors) {
        std::vector<Complex<Bounded<double>>> V = harmonic_responses(motion, forces, errors);
        if (contact_moves_apart(system))
            V.push_back({along_contact<Bounded<double>>(system, [&](std::size_t k) { return V[k].re; }),
                         along_contact<Bounded<double>>(system, [&](std::size_t k) { return V[k].im; })});
        return V;
    };
    ModeSums<Bounded<double>> s;
    s.r = r;
    s.contact = contact_row(system);
    s.load = load_row(system);
    s.load_im = load_rows(system).im;
    s.V = to(complex_load(system), error_of_load(system));
    std::vector<Complex<double>> w;
    for (const double each : contact_vector(system)) w.push_back({each, 0});
    s.Y_jj = (s.load == s.contact ? s.V : to(w, {}))[s.contact.index];
    for (std::size_t k = 0; k < s.V.size(); ++k) {
        const evaluation::FrictionMotion<Bounded<double>> start = friction->motion(k, Bounded<double>(0));
        s.U.push_back(-start.prime);
        s.G.push_back(-start.value);
        if (k == s.contact.index) s.H_j = start.double_prime - friction->inverse_inertia();
    }
    s.sum_of_squares = friction->inverse_inertia();
    s.coupled = friction;
    return s;
}

} // namespace denhartog
