/// @file
/// @brief Modal damping ratios from a damping matrix, and the matrix in the modes.
#include "denhartog/model/modal_damping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "denhartog/model/coordinates.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/model/natural_modes.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/cholesky.hpp"
#include "denhartog/scene/scene_rules.hpp"

namespace denhartog {
namespace {

// How far A B is from B A, over the sizes of both.
template <class T>
T distance_from_commuting(const Matrix<T>& A, const Matrix<T>& B) {
    const Matrix<T> AB = product(A, B);
    const T sizes = A.norm() * B.norm(), distance = Matrix<T>(AB - AB.transpose()).norm();
    return sizes > 0 ? T(distance / sizes) : T(0);
}

template <class T>
void check_ratio(const T& zeta, std::size_t i, const Matrix<T>& C, const ModalBasis<T>& basis) {
    const auto rounding = [&] { // of the terms of the ratio
        const Column<T> sizes = basis.phi.col(static_cast<Eigen::Index>(i)).cwiseAbs();
        return T(rounding_of_modes<T>(basis.r_n.size()) * sizes.dot(product_of_sizes(C, sizes)) / basis.r_n[i]);
    };
    if (zeta < 0 && -zeta <= rounding())
        throw PrecisionError("damping_matrix: rounding does not leave the damping of mode " + std::to_string(i + 1) + " a digit");
    const std::string rule = "must give mode " + std::to_string(i + 1) + " a damping ratio ";
    if (zeta < 0) throw InputError("damping_matrix", rule + "that is not negative", number_to_text(zeta));
    if (!(zeta <= largest_damping_ratio)) throw InputError("damping_matrix", rule + "of at most 1e300", number_to_text(zeta));
}

} // namespace

template <class T>
void check_passive(const Matrix<T>& C) {
    const T least = symmetric_eigenproblem(C).values.front();
    const double rounding = 16 * static_cast<double>(C.rows()) * std::numeric_limits<double>::epsilon();
    if (least < -rounding * C.cwiseAbs().maxCoeff())
        throw InputError("damping_matrix", "must take energy out of every motion: must have no negative eigenvalue",
                         number_in_digits(static_cast<double>(least), 3));
}

template <class T>
Matrix<T> damping_in_modes(const Matrix<T>& C, const std::vector<T>& r_n, Matrix<T>& phi) {
    std::vector<Eigen::Index> starts{0}; // of the groups of modes that coincide, and the end of the last
    for (std::size_t i = 1; i < r_n.size(); ++i)
        if (r_n[i] - r_n[i - 1] > rounding_of_modes<T>(r_n.size()) * r_n[i]) starts.push_back(static_cast<Eigen::Index>(i));
    starts.push_back(phi.cols());
    for (std::size_t n = 1; n < starts.size(); ++n) {
        const Eigen::Index at = starts[n - 1], count = starts[n] - at;
        if (count == 1) continue;
        const Matrix<T> columns = phi.middleCols(at, count);
        const Matrix<T> within = in_coordinates(columns, C);
        const SymmetricEigenproblem<T> solved = symmetric_eigenproblem(Matrix<T>((within + within.transpose()) / T(2)));
        phi.middleCols(at, count) = product(columns, solved.vectors);
    }
    fix_signs(phi);
    const Matrix<T> both = in_coordinates(phi, C);
    Matrix<T> D = (both + both.transpose()) / T(2);
    for (std::size_t n = 1; n < starts.size(); ++n) {
        auto within = D.block(starts[n - 1], starts[n - 1], starts[n] - starts[n - 1], starts[n] - starts[n - 1]);
        within = Matrix<T>(within.diagonal().asDiagonal());
    }
    return D;
}

template <class T>
T largest_coupling(const Matrix<T>& D) {
    using std::abs;
    using std::sqrt;
    if (D.size() == 0) return T(0);
    const T rounding = rounding_of_modes<T>(static_cast<std::size_t>(D.rows())) * D.cwiseAbs().maxCoeff();
    T largest(0);
    for (Eigen::Index i = 0; i < D.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k) {
            if (D(i, k) == 0) continue;
            const T product = std::max(T(D(i, i) * D(k, k)), T(rounding * rounding));
            largest = std::max(largest, T(abs(D(i, k)) / sqrt(product)));
        }
    return largest;
}

template <class T>
void set_modal_damping(const Matrix<T>& L, const Matrix<T>& K, const Matrix<T>& C, double neglected, ModalBasis<T>& basis) {
    using std::abs;
    const std::size_t N = basis.r_n.size();
    basis.distance_from_classical = N > 1 ? distance_from_commuting(divide_out(L, K), divide_out(L, C)) : T(0);
    if (N > 1) check_passive(C);
    const bool neglects = neglected > 0 && basis.distance_from_classical <= T(neglected);
    Matrix<T> D = damping_in_modes(C, basis.r_n, basis.phi);
    const T size = D.cwiseAbs().maxCoeff();
    basis.zeta.assign(N, T(0));
    for (std::size_t i = 0; i < N; ++i) {
        const T& D_ii = D(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i));
        const bool nothing = abs(D_ii) <= rounding_of_modes<T>(N) * size;
        basis.zeta[i] = nothing && D_ii < 0 ? T(0) : T(D_ii / (2 * basis.r_n[i]));
        check_ratio(basis.zeta[i], i, C, basis);
    }
    if (N > 1 && size > 0 && !neglects) basis.D = std::move(D);
}

template void check_passive(const Matrix<double>&);
template double largest_coupling(const Matrix<double>&);
template Matrix<double> damping_in_modes(const Matrix<double>&, const std::vector<double>&, Matrix<double>&);
template void set_modal_damping(const Matrix<double>&, const Matrix<double>&, const Matrix<double>&, double, ModalBasis<double>&);

} // namespace denhartog
