#include "denhartog/model/modal_damping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "denhartog/model/contact_and_load.hpp"
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
Matrix<T> rounding_between_modes(const Matrix<T>& C, const Matrix<T>& D, const NaturalModes<T>& modes, FrequencyErrors errors) {
    using std::abs;
    const T tolerance = rounding_of_modes<T>(modes.r_n.size()), highest = modes.r_n.back();
    // An entry of a mode is good to the rounding of the root of the entry of the inverse mass matrix, the sum over all modes.
    const Matrix<T> forces = product(Matrix<T>(C.cwiseAbs()), Matrix<T>(modes.phi.cwiseAbs()));
    const Matrix<T> of_entries = transpose_times(Matrix<T>(modes.phi.rowwise().norm()), forces);
    Matrix<T> rounding = Matrix<T>::Zero(D.rows(), D.cols());
    for (Eigen::Index i = 0; i < D.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k) {
            const T &r_i = modes.r_n[static_cast<std::size_t>(i)], &r_k = modes.r_n[static_cast<std::size_t>(k)];
            const T of_squares = tolerance * (errors == FrequencyErrors::of_each ? T(r_i * r_k) : T(highest * highest));
            const T apart = (r_i - r_k) * (r_i + r_k), angle = of_squares < apart ? T(of_squares / apart) : T(1);
            rounding(i, k) = rounding(k, i) =
                tolerance * (of_entries(0, i) + of_entries(0, k)) + angle * abs(T(D(i, i) - D(k, k)));
        }
    return rounding;
}

template <class T>
bool couples_a_pair(const Matrix<T>& D, const Matrix<T>& rounding) {
    using std::abs;
    for (Eigen::Index i = 0; i < D.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k)
            if (abs(D(i, k)) > rounding(i, k)) return true;
    return false;
}

template <class T>
void turn_coinciding_modes(const Matrix<T>& C, const T& tolerance, const std::vector<T>& r_n, Matrix<T>& phi) {
    const std::size_t N = r_n.size();
    for (std::size_t first = 0, last = 0; first < N; first = last + 1) {
        last = first;
        while (last + 1 < N && coincides_with_next(r_n, last, tolerance)) ++last;
        if (last == first) continue;
        const auto at = static_cast<Eigen::Index>(first);
        const auto count = static_cast<Eigen::Index>(last - first + 1);
        const Matrix<T> columns = phi.middleCols(at, count);
        const Matrix<T> within = in_coordinates(columns, C);
        const SymmetricEigenproblem<T> solved = symmetric_eigenproblem(Matrix<T>((within + within.transpose()) / T(2)));
        phi.middleCols(at, count) = product(columns, solved.vectors);
    }
}

template <class T>
T largest_coupling(const Matrix<T>& D, const T& rounding) {
    using std::abs;
    using std::sqrt;
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
void set_modal_damping(const Matrix<T>& L, const Matrix<T>& K, const Matrix<T>& C, double neglected, FrequencyErrors errors,
                       ModalBasis<T>& basis) {
    using std::abs;
    const std::size_t N = basis.r_n.size();
    const T tolerance = rounding_of_modes<T>(N);
    basis.distance_from_classical = N > 1 ? distance_from_commuting(divide_out(L, K), divide_out(L, C)) : T(0);
    const bool commutes = basis.distance_from_classical <= tolerance,
               modal = N == 1 || C.isZero(0) || (neglected > 0 && basis.distance_from_classical <= T(neglected));
    if (commutes || modal) turn_coinciding_modes(C, tolerance, basis.r_n, basis.phi);
    fix_signs(basis.phi); // D goes with them
    const Matrix<T> D = in_coordinates(basis.phi, C);
    const T size = D.cwiseAbs().maxCoeff();
    if (!modal) {
        basis.D = (D + D.transpose()) / T(2);
        basis.couples = !commutes || couples_a_pair(D, rounding_between_modes(C, D, {basis.r_n, basis.phi}, errors));
    }
    basis.zeta.assign(N, T(0));
    for (std::size_t i = 0; i < N; ++i) {
        const auto n = static_cast<Eigen::Index>(i);
        const bool nothing = abs(D(n, n)) <= tolerance * size;
        basis.zeta[i] = nothing && D(n, n) < 0 ? T(0) : T(D(n, n) / (2 * basis.r_n[i]));
        check_ratio(basis.zeta[i], i, C, basis);
    }
}

template void check_passive(const Matrix<double>&);
template Matrix<double> rounding_between_modes(const Matrix<double>&, const Matrix<double>&, const NaturalModes<double>&,
                                               FrequencyErrors);
template bool couples_a_pair(const Matrix<double>&, const Matrix<double>&);
template double largest_coupling(const Matrix<double>&, const double&);
template void turn_coinciding_modes(const Matrix<double>&, const double&, const std::vector<double>&, Matrix<double>&);
template void set_modal_damping(const Matrix<double>&, const Matrix<double>&, const Matrix<double>&, double, FrequencyErrors,
                                ModalBasis<double>&);

} // namespace denhartog
