// The multipliers of an orbit, which say whether it is stable. `multipliers_of` finds the eigenvalues of the derivative of the map with a
// bound of the error of each size. It makes the matrix triangular by a unitary one, then diagonal but for what couples eigenvalues of
// nearly the same value. Gershgorin's discs of what the error leaves beside the diagonal hold as many eigenvalues of the true matrix as
// they are discs, also if it is scaled so that couplings shrink: a multiple zero without as many eigenvectors is known to a root of
// the error.
#include "denhartog/orbit/floquet.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/bounded_arithmetic.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

using ComplexMatrix = Matrix<std::complex<double>>;

bool is_larger(const std::complex<double>& a, const std::complex<double>& b) {
    const double size_a = size_of(a), size_b = size_of(b);
    return size_a != size_b ? size_a > size_b : a.imag() > b.imag();
}

// Product and inverse of complex numbers, the same by every compiler: the language's call a function of its own.
std::complex<double> times(const std::complex<double>& a, const std::complex<double>& b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

std::complex<double> inverse_of(const std::complex<double>& z) {
    const double size = size_of(z);
    return {z.real() / size / size, -z.imag() / size / size};
}

// A block of two rows, whose eigenvalues are no real numbers, made triangular by a unitary matrix, which goes into Q.
void make_triangular(ComplexMatrix& R, ComplexMatrix& Q, Eigen::Index i, const std::complex<double>& eigenvalue) {
    const std::complex<double> v_1 = R(i, i + 1), v_2 = eigenvalue - R(i, i);
    const double size = elementary::hypot(size_of(v_1), size_of(v_2));
    const std::complex<double> a = v_1 / size, b = v_2 / size; // the matrix has the columns (a, b) and (-b*, a*)
    const auto turn = [&](ComplexMatrix& A, Eigen::Index rows) {
        for (Eigen::Index row = 0; row < rows; ++row) {
            const std::complex<double> left = A(row, i), right = A(row, i + 1);
            A(row, i) = times(left, a) + times(right, b);
            A(row, i + 1) = times(right, std::conj(a)) - times(left, std::conj(b));
        }
    };
    turn(R, i + 2);
    turn(Q, Q.rows());
    for (Eigen::Index column = i; column < R.cols(); ++column) {
        const std::complex<double> upper = R(i, column), lower = R(i + 1, column);
        R(i, column) = times(std::conj(a), upper) + times(std::conj(b), lower);
        R(i + 1, column) = times(a, lower) - times(b, upper);
    }
    R(i, i) = eigenvalue;
    R(i + 1, i + 1) = std::conj(eigenvalue);
    R(i + 1, i) = 0;
}

// A matrix as Q R Q^-1.
struct TriangularForm {
    ComplexMatrix R; // a triangular matrix that has the same eigenvalues, on its diagonal; empty if it was not found
    ComplexMatrix Q; // a unitary matrix, or empty if it is not asked for
};

TriangularForm triangular_form(const Matrix<double>& jacobian, bool with_Q = false) {
    if (jacobian.rows() == 0 || !jacobian.allFinite()) return {};
    const Eigen::RealSchur<Matrix<double>> schur(jacobian, with_Q);
    if (schur.info() != Eigen::Success) return {};
    const Matrix<double>& T = schur.matrixT();
    ComplexMatrix R = T.cast<std::complex<double>>(), Q;
    if (with_Q) Q = schur.matrixU().cast<std::complex<double>>();
    for (Eigen::Index i = 0; i + 1 < T.rows(); ++i) {
        if (T(i + 1, i) == 0) continue;
        const double p = 0.5 * (T(i, i) - T(i + 1, i + 1));
        const double largest = std::max({std::abs(p), std::abs(T(i + 1, i)), std::abs(T(i, i + 1))}); // scales the square
        const double p_1 = p / largest, below = T(i + 1, i) / largest, above = T(i, i + 1) / largest;
        make_triangular(R, Q, i, {T(i + 1, i + 1) + p, largest * std::sqrt(std::abs(p_1 * p_1 + below * above))});
    }
    return {R, Q};
}

// Of an upper triangular matrix with ones on its diagonal.
ComplexMatrix inverse_of_triangular(const ComplexMatrix& Y) {
    const Eigen::Index n = Y.rows();
    ComplexMatrix inverse = ComplexMatrix::Identity(n, n);
    for (Eigen::Index k = 0; k < n; ++k)
        for (Eigen::Index i = k - 1; i >= 0; --i) {
            std::complex<double> sum = 0;
            for (Eigen::Index m = i + 1; m <= k; ++m) sum += times(Y(i, m), inverse(m, k));
            inverse(i, k) = -sum;
        }
    return inverse;
}

// A triangular matrix as Y (diagonal + couplings) Y^-1, the couplings between eigenvalues that are close.
struct Decoupled {
    ComplexMatrix Y, inverse; // Y and Y^-1
    Matrix<double> couplings; // their sizes
    std::vector<int> depth;   // how many couplings lead to an eigenvalue, one after the other
};

// Eigenvalues no farther apart than `close` stay coupled; if `least` is given they are taken for that far apart at least, and
// none do.
Decoupled decoupled(const ComplexMatrix& R, double close, double least = -1) {
    const Eigen::Index n = R.rows();
    ComplexMatrix left = ComplexMatrix::Zero(n, n);
    Decoupled d{ComplexMatrix::Identity(n, n), {}, Matrix<double>::Zero(n, n), std::vector<int>(static_cast<std::size_t>(n))};
    for (Eigen::Index k = 0; k < n; ++k)
        for (Eigen::Index i = k - 1; i >= 0; --i) {
            std::complex<double> rest = 0;
            for (Eigen::Index m = i + 1; m <= k; ++m) rest += times(R(i, m), d.Y(m, k)) - times(d.Y(i, m), left(m, k));
            const std::complex<double> apart = R(k, k) - R(i, i);
            if (least >= 0 || size_of(apart) > close) {
                d.Y(i, k) = times(rest, inverse_of(size_of(apart) > least ? apart : least));
                continue;
            }
            left(i, k) = rest;
            d.couplings(i, k) = size_of(rest);
            int& depth = d.depth[static_cast<std::size_t>(k)];
            depth = std::max(depth, 1 + d.depth[static_cast<std::size_t>(i)]);
        }
    d.inverse = inverse_of_triangular(d.Y);
    return d;
}

struct SizeRange {
    double from, to;
};

// Narrows the range of the n-th largest size. An interval holds one size; intervals that overlap hold as many as they are.
void intersect_with_joined(std::vector<SizeRange>& known, std::vector<SizeRange> intervals) {
    std::ranges::sort(intervals, std::greater{}, &SizeRange::to);
    for (std::size_t first = 0; first < intervals.size();) {
        SizeRange joined = intervals[first];
        std::size_t end = first + 1;
        for (; end < intervals.size() && !(intervals[end].to < joined.from); ++end)
            joined.from = std::min(joined.from, intervals[end].from);
        for (; first < end; ++first)
            known[first] = {std::max(known[first].from, joined.from), std::min(known[first].to, joined.to)};
    }
}

// Intervals that hold the sizes of the eigenvalues of a triangular matrix whose entries have an error, the largest first.
std::vector<SizeRange> intervals_of_sizes(const ComplexMatrix& R, double error, double most) {
    const Eigen::Index n = R.rows();
    const double norm = R.norm();
    std::vector<SizeRange> known(static_cast<std::size_t>(n), {0, std::min(most, norm + error)});
    if (!(error < norm)) return known;
    const Decoupled d = decoupled(R, std::sqrt(error / norm) * norm);
    Eigen::VectorXd rows(n), columns(n); // norms, of Y^-1 and of Y
    for (Eigen::Index i = 0; i < n; ++i) {
        rows(i) = d.inverse.row(i).norm();
        columns(i) = d.Y.col(i).norm();
    }
    const double units = 16 * static_cast<double>(n) * unit_of<double>();
    const double spread = error + units * (norm + error + d.couplings.norm() * columns.norm());
    const bool is_coupled = std::ranges::any_of(d.depth, [](int depth) { return depth > 0; });
    for (int halvings = 0; halvings <= 30; halvings += 2) { // of the scale from one depth to the next
        const auto scale = [&](Eigen::Index i, Eigen::Index k) {
            return std::ldexp(1.0, halvings * (d.depth[static_cast<std::size_t>(i)] - d.depth[static_cast<std::size_t>(k)]));
        };
        std::vector<SizeRange> intervals;
        for (Eigen::Index i = 0; i < n; ++i) {
            double radius = 0;
            for (Eigen::Index k = 0; k < n; ++k) radius += (d.couplings(i, k) + rows(i) * columns(k) * spread) * scale(i, k);
            const double size = size_of(R(i, i)), reach = radius < most ? radius : std::numeric_limits<double>::infinity();
            intervals.push_back({size - reach, size + reach});
        }
        intersect_with_joined(known, std::move(intervals));
        if (!is_coupled) break;
    }
    return known;
}

} // namespace

double size_of(const std::complex<double>& multiplier) { return elementary::hypot(multiplier.real(), multiplier.imag()); }

bool are_inside(const std::vector<Multiplier>& multipliers) {
    return !multipliers.empty() &&
           std::ranges::all_of(multipliers, [](const Multiplier& each) { return size_of(each.value) + each.error < 1; });
}

std::vector<Multiplier> multipliers_of(const Matrix<double>& jacobian, double error, double most) {
    const ComplexMatrix R = triangular_form(jacobian).R;
    const double rounding = 32 * static_cast<double>(R.rows()) * unit_of<double>() * jacobian.norm(); // of making it triangular
    const std::vector<SizeRange> intervals = intervals_of_sizes(R, error + rounding, most);
    std::vector<Multiplier> multipliers;
    for (Eigen::Index n = 0; n < R.rows(); ++n) multipliers.push_back({R(n, n), 0});
    std::ranges::sort(multipliers, is_larger, &Multiplier::value);
    for (std::size_t n = 0; n < multipliers.size(); ++n) {
        const double size = size_of(multipliers[n].value);
        multipliers[n].error = std::max(size - std::max(0.0, intervals[n].from), intervals[n].to - size);
    }
    return multipliers;
}

ApproximateEigenvectors eigenvectors_of(const Matrix<double>& A) {
    const auto [R, Q] = triangular_form(A, true);
    const Eigen::Index n = R.rows();
    const auto [Y, inverse, couplings, depth] = decoupled(R, 0, unit_of<double>() * R.norm());
    ApproximateEigenvectors found{R.diagonal(), ComplexMatrix::Zero(n, n), ComplexMatrix::Zero(n, n)};
    for (Eigen::Index k = 0; k < n; ++k)
        for (Eigen::Index i = 0; i <= k; ++i)
            for (Eigen::Index row = 0; row < n; ++row) {
                found.vectors(row, k) += times(Q(row, i), Y(i, k));
                found.inverse(i, row) += times(inverse(i, k), std::conj(Q(row, k)));
            }
    return found;
}

std::vector<Multiplier> squared(std::vector<Multiplier> multipliers) {
    for (Multiplier& each : multipliers) {
        const double re = each.value.real(), im = each.value.imag(), size = size_of(each.value);
        each = {{re * re - im * im, 2 * re * im}, each.error * (2 * size + each.error) + 4 * unit_of<double>() * size * size};
    }
    std::ranges::sort(multipliers, is_larger, &Multiplier::value);
    return multipliers;
}

} // namespace denhartog
