#include "denhartog/model/natural_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/scene/cholesky.hpp"

namespace denhartog {
namespace {

constexpr int most_sweeps = 40;

double along(const Matrix<double>& A, Eigen::Index p, Eigen::Index q) {
    double sum = 0;
    for (Eigen::Index i = 0; i < A.rows(); ++i) sum += A(i, p) * A(i, q);
    return sum;
}

void rotate(Matrix<double>& A, Eigen::Index p, Eigen::Index q, double cosine, double sine) {
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
        const double x = A(i, p), y = A(i, q);
        A(i, p) = cosine * x - sine * y;
        A(i, q) = sine * x + cosine * y;
    }
}

// Rotates columns until each two are orthogonal to rounding; V takes the rotations.
void orthogonalise(Matrix<double>& A, Matrix<double>& V, Effort* effort) {
    const Eigen::Index N = A.cols();
    const double rounding = static_cast<double>(N) * std::numeric_limits<double>::epsilon();
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        bool rotated = false;
        for (Eigen::Index p = 0; p < N; ++p) {
            pay(effort, static_cast<long>(N * N) / 16); // sums and rotations of up to N pairs of columns
            for (Eigen::Index q = p + 1; q < N; ++q) {
                const double a = along(A, p, p), b = along(A, q, q), c = along(A, p, q);
                if (std::abs(c) <= rounding * std::sqrt(a) * std::sqrt(b)) continue;
                rotated = true;
                const double zeta = (b - a) / (2 * c);
                const double tangent = (zeta >= 0 ? 1 : -1) / (std::abs(zeta) + std::sqrt(1 + zeta * zeta));
                const double cosine = 1 / std::sqrt(1 + tangent * tangent);
                rotate(A, p, q, cosine, cosine * tangent);
                rotate(V, p, q, cosine, cosine * tangent);
            }
        }
        if (!rotated) return;
    }
}

// Factor of a stiffness matrix whose modes are graded, and the condition that `condition_of_graded` gives.
struct GradedStiffness {
    Cholesky<double> factor;
    double condition;
};

std::optional<GradedStiffness> graded_stiffness(const Matrix<double>& L, const Matrix<double>& K) {
    if (L.rows() < 2 || !is_diagonal(L)) return std::nullopt;
    const Column masses = L.diagonal().cwiseAbs2();
    const double contrast = masses.maxCoeff() / masses.minCoeff();
    if (!(contrast >= least_contrast_of_masses)) return std::nullopt;
    Cholesky<double> factor = cholesky(K);
    if (factor.failed_order > 0) return std::nullopt;
    const Matrix<double> inverse = LinearSystem(K).inverse();
    double trace = 0;
    for (Eigen::Index i = 0; i < K.rows(); ++i) trace += inverse(i, i) * K(i, i);
    if (!(trace <= contrast)) return std::nullopt;
    return GradedStiffness{std::move(factor), std::max(trace, static_cast<double>(K.rows()))};
}

} // namespace

std::optional<double> condition_of_graded(const Matrix<double>& L, const Matrix<double>& K) {
    const std::optional<GradedStiffness> graded = graded_stiffness(L, K);
    return graded ? std::optional(graded->condition) : std::nullopt;
}

std::optional<NaturalModes> graded_modes(const Matrix<double>& L, const Matrix<double>& K, Effort* effort) {
    const std::optional<GradedStiffness> graded = graded_stiffness(L, K);
    if (!graded) return std::nullopt;
    const Eigen::Index N = K.rows();
    Matrix<double> A = graded->factor.L.transpose(), V = Matrix<double>::Identity(N, N);
    for (Eigen::Index k = 0; k < N; ++k) A.col(k) /= L(k, k);
    orthogonalise(A, V, effort);
    std::vector<double> sizes;
    for (Eigen::Index i = 0; i < N; ++i) sizes.push_back(std::sqrt(along(A, i, i)));
    std::vector<std::size_t> order(sizes.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, [&](std::size_t i, std::size_t k) { return sizes[i] < sizes[k]; });
    NaturalModes modes{{}, Matrix<double>(N, N)};
    for (const std::size_t i : order) {
        const auto column = static_cast<Eigen::Index>(modes.r_n.size());
        for (Eigen::Index k = 0; k < N; ++k) modes.phi(k, column) = V(k, static_cast<Eigen::Index>(i)) / L(k, k);
        modes.r_n.push_back(sizes[i]);
    }
    return modes;
}

} // namespace denhartog
