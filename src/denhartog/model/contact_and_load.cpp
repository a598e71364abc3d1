#include "denhartog/model/contact_and_load.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/formulas/system.hpp"

namespace denhartog {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// What the rounding of a diagonal entry of K took, the sum of two springs of a chain.
double rest_of_stiffness(const System<double>& s, const Matrix<double>& K, std::size_t k) {
    if (s.stiffness_matrix.size() > 0 || k + 1 >= s.stiffness_ratios.size()) return 0.0;
    const auto i = static_cast<Eigen::Index>(k);
    return evaluation::sum_error(s.stiffness_ratios[k], s.stiffness_ratios[k + 1], K(i, i));
}

// O^T A O, symmetric to the last bit; O has ones on its diagonal and nothing else, but for row a. Of A's diagonal the rests are
// missing.
Matrix<double> with_contact(const Contact& held, Matrix<double> A, double rest_of_a = 0, double rest_of_b = 0) {
    if (!held.b) return A;
    const auto a = static_cast<Eigen::Index>(held.a), b = static_cast<Eigen::Index>(*held.b);
    const double aa = A(a, a), ab = A(a, b), bb = A(b, b);
    A.col(b) += A.col(a);
    A.row(b) += A.row(a);
    A(a, b) = A(b, a) = evaluation::sum_with_rests<double>(std::array{aa, ab, rest_of_a});
    A(b, b) = evaluation::sum_with_rests<double>(std::array{aa, ab, ab, bb, rest_of_a, rest_of_b});
    if (held.sign > 0) return A;
    A.col(a) = (0.0 - A.col(a).array()).matrix(); // no zero becomes a negative one
    A.row(a) = (0.0 - A.row(a).array()).matrix();
    return A;
}

} // namespace

Matrix<double> mass_matrix(const System<double>& s) {
    if (s.mass_matrix.size() > 0) return s.mass_matrix;
    const auto N = static_cast<Eigen::Index>(s.mass_ratios.size());
    Matrix<double> M = Matrix<double>::Zero(N, N);
    for (Eigen::Index k = 0; k < N; ++k) M(k, k) = s.mass_ratios[static_cast<std::size_t>(k)];
    return M;
}

Matrix<double> stiffness_matrix(const System<double>& s) {
    if (s.stiffness_matrix.size() > 0) return s.stiffness_matrix;
    const auto N = static_cast<Eigen::Index>(s.stiffness_ratios.size());
    const std::vector<double> entries = paper::chain_stiffness_matrix(std::span<const double>(s.stiffness_ratios));
    return Eigen::Map<const RowMajor>(entries.data(), N, N);
}

std::vector<double> error_of_load(const System<double>& s) {
    if (s.load_phases.empty()) return s.load_error;
    std::vector<double> errors = s.load_error;
    errors.resize(s.load_vector.size());
    for (std::size_t k = 0; k < errors.size(); ++k)
        errors[k] += (2 + std::abs(s.load_phases[k])) * std::numeric_limits<double>::epsilon() * std::abs(s.load_vector[k]);
    return errors;
}

HeldMatrices held_matrices(const System<double>& s, const Contact& held, const Matrix<double>& C) {
    const Matrix<double> K = stiffness_matrix(s);
    const double rest_of_a = rest_of_stiffness(s, K, held.a), rest_of_b = held.b ? rest_of_stiffness(s, K, *held.b) : 0.0;
    return {with_contact(held, mass_matrix(s)), with_contact(held, C), with_contact(held, K, rest_of_a, rest_of_b)};
}

} // namespace denhartog
