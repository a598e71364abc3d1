#include "denhartog/model/contact_and_load.hpp"

#include <array>
#include <span>

#include "denhartog/evaluation/contact.hpp"
#include "denhartog/formulas/system.hpp"

namespace denhartog {
namespace {

template <class T>
using RowMajor = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// What the rounding of a diagonal entry of K took, the sum of two springs of a chain.
template <class T>
T rest_of_stiffness(const System<T>& s, const Matrix<T>& K, std::size_t k) {
    if (s.stiffness_matrix.size() > 0 || k + 1 >= s.stiffness_ratios.size()) return T(0);
    const auto i = static_cast<Eigen::Index>(k);
    return evaluation::sum_error(s.stiffness_ratios[k], s.stiffness_ratios[k + 1], K(i, i));
}

// O^T A O, symmetric to the last bit; O has ones on its diagonal and nothing else, but for row a. Of A's diagonal the rests are
// missing.
template <class T>
Matrix<T> with_contact(const Contact& held, Matrix<T> A, const T& rest_of_a = T(0), const T& rest_of_b = T(0)) {
    if (!held.b) return A;
    const auto a = static_cast<Eigen::Index>(held.a), b = static_cast<Eigen::Index>(*held.b);
    const T aa = A(a, a), ab = A(a, b), bb = A(b, b);
    A.col(b) += A.col(a);
    A.row(b) += A.row(a);
    A(a, b) = A(b, a) = evaluation::sum_with_rests<T>(std::array{aa, ab, rest_of_a});
    A(b, b) = evaluation::sum_with_rests<T>(std::array{aa, ab, ab, bb, rest_of_a, rest_of_b});
    if (held.sign > 0) return A;
    A.col(a) = (T(0) - A.col(a).array()).matrix(); // no zero becomes a negative one
    A.row(a) = (T(0) - A.row(a).array()).matrix();
    return A;
}

} // namespace

template <class T>
Matrix<T> mass_matrix(const System<T>& s) {
    if (s.mass_matrix.size() > 0) return s.mass_matrix;
    const auto N = static_cast<Eigen::Index>(s.mass_ratios.size());
    Matrix<T> M = Matrix<T>::Zero(N, N);
    for (Eigen::Index k = 0; k < N; ++k) M(k, k) = s.mass_ratios[static_cast<std::size_t>(k)];
    return M;
}

template <class T>
Matrix<T> stiffness_matrix(const System<T>& s) {
    if (s.stiffness_matrix.size() > 0) return s.stiffness_matrix;
    const auto N = static_cast<Eigen::Index>(s.stiffness_ratios.size());
    const std::vector<T> entries = paper::chain_stiffness_matrix(std::span<const T>(s.stiffness_ratios));
    return Eigen::Map<const RowMajor<T>>(entries.data(), N, N);
}

template <class T>
HeldMatrices<T> held_matrices(const System<T>& s, const Contact& held, const Matrix<T>& C) {
    const Matrix<T> K = stiffness_matrix(s);
    const T rest_of_a = rest_of_stiffness(s, K, held.a), rest_of_b = held.b ? rest_of_stiffness(s, K, *held.b) : T(0);
    return {with_contact(held, mass_matrix(s)), with_contact(held, C), with_contact(held, K, rest_of_a, rest_of_b)};
}

template Matrix<double> mass_matrix(const System<double>&);
template Matrix<double> stiffness_matrix(const System<double>&);
template HeldMatrices<double> held_matrices(const System<double>&, const Contact&, const Matrix<double>&);

} // namespace denhartog
