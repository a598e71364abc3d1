#include "denhartog/model/contact_and_load.hpp"

#include <span>

#include "denhartog/formulas/system.hpp"
#include "denhartog/number/double_double.hpp"
#include "denhartog/scene/converted.hpp"

namespace denhartog {
namespace {

template <class T>
using RowMajor = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// O^T A O, symmetric to the last bit; O has ones on its diagonal and nothing else, but for row a.
template <class T, class W>
Matrix<T> with_contact(const Contact& held, Matrix<W> A) {
    if (held.b) {
        const auto a = static_cast<Eigen::Index>(held.a), b = static_cast<Eigen::Index>(*held.b);
        A.col(b) += A.col(a);
        A.row(b) += A.row(a);
        A.col(a) *= W(held.sign);
        A.row(a) *= W(held.sign);
    }
    return in_type<T>(A);
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
    using W = typename WiderOf<T>::type;
    const System<W> wide = in_type<W>(s);
    return {with_contact<T>(held, mass_matrix(wide)), with_contact<T>(held, in_type<W>(C)),
            with_contact<T>(held, stiffness_matrix(wide))};
}

template Matrix<double> mass_matrix(const System<double>&);
template Matrix<double> stiffness_matrix(const System<double>&);
template HeldMatrices<double> held_matrices(const System<double>&, const Contact&, const Matrix<double>&);

} // namespace denhartog
