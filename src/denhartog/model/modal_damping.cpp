#include "denhartog/model/modal_damping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/model/natural_modes.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/scene/cholesky.hpp"
#include "denhartog/scene/scene_rules.hpp"

namespace denhartog {
namespace {

// How far A B is from B A, over the sizes of both.
double distance_from_commuting(const Matrix<double>& A, const Matrix<double>& B) {
    const Matrix<double> AB = product(A, B);
    const double sizes = A.norm() * B.norm(), distance = Matrix<double>(AB - AB.transpose()).norm();
    return sizes > 0 ? distance / sizes : 0.0;
}

void check_ratio(double zeta, std::size_t i, const Matrix<double>& C, const ModalBasis<double>& basis) {
    const auto rounding = [&] { // of the terms of the ratio
        const Column sizes = basis.phi.col(static_cast<Eigen::Index>(i)).cwiseAbs();
        return rounding_of_modes(basis.r_n.size()) * sizes.dot(product_of_sizes(C, sizes)) / basis.r_n[i];
    };
    if (zeta < 0 && -zeta <= rounding()) throw PrecisionError({Why::damping_lost, i + 1});
    const std::string rule = "must give mode " + std::to_string(i + 1) + " a damping ratio ";
    if (zeta < 0) throw InputError("damping_matrix", rule + "that is not negative", number_to_text(zeta));
    if (!(zeta <= largest_damping_ratio)) throw InputError("damping_matrix", rule + "of at most 1e300", number_to_text(zeta));
}

} // namespace

void check_passive(const Matrix<double>& C) {
    const double least = symmetric_eigenproblem(C).values.front();
    const double rounding = 16 * static_cast<double>(C.rows()) * std::numeric_limits<double>::epsilon();
    if (least < -rounding * C.cwiseAbs().maxCoeff())
        throw InputError("damping_matrix", "must take energy out of every motion: must have no negative eigenvalue",
                         number_in_digits(static_cast<double>(least), 3));
}

Matrix<double> rounding_between_modes(const Matrix<double>& C, const Matrix<double>& D, const NaturalModes& modes,
                                      FrequencyErrors errors) {
    using std::abs;
    const double tolerance = rounding_of_modes(modes.r_n.size()), highest = modes.r_n.back();
    // An entry of a mode is good to the rounding of the root of the entry of the inverse mass matrix, the sum over all modes.
    const Matrix<double> forces = product(Matrix<double>(C.cwiseAbs()), Matrix<double>(modes.phi.cwiseAbs()));
    const Matrix<double> sizes_of_entries = transpose_times(Matrix<double>(modes.phi.rowwise().norm()), forces);
    Matrix<double> rounding = Matrix<double>::Zero(D.rows(), D.cols());
    for (Eigen::Index i = 0; i < D.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k) {
            const double &r_i = modes.r_n[static_cast<std::size_t>(i)], &r_k = modes.r_n[static_cast<std::size_t>(k)];
            const double error_of_squares = tolerance * (errors == FrequencyErrors::of_each ? r_i * r_k : highest * highest);
            const double apart = (r_i - r_k) * (r_i + r_k), angle = error_of_squares < apart ? error_of_squares / apart : 1.0;
            rounding(i, k) = rounding(k, i) =
                tolerance * (sizes_of_entries(0, i) + sizes_of_entries(0, k)) + angle * abs(D(i, i) - D(k, k));
        }
    return rounding;
}

bool couples_a_pair(const Matrix<double>& D, const Matrix<double>& rounding) {
    using std::abs;
    for (Eigen::Index i = 0; i < D.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k)
            if (abs(D(i, k)) > rounding(i, k)) return true;
    return false;
}

void turn_coinciding_modes(const Matrix<double>& C, double tolerance, const std::vector<double>& r_n, Matrix<double>& phi) {
    const std::size_t N = r_n.size();
    for (std::size_t first = 0, last = 0; first < N; first = last + 1) {
        last = first;
        while (last + 1 < N && coincides_with_next(r_n, last, tolerance)) ++last;
        if (last == first) continue;
        const auto at = static_cast<Eigen::Index>(first);
        const auto count = static_cast<Eigen::Index>(last - first + 1);
        const Matrix<double> columns = phi.middleCols(at, count);
        const Matrix<double> within = in_coordinates(columns, C);
        const SymmetricEigenproblem solved = symmetric_eigenproblem(Matrix<double>((within + within.transpose()) / 2.0));
        phi.middleCols(at, count) = product(columns, solved.vectors);
    }
}

double largest_coupling(const Matrix<double>& D, double rounding) {
    using std::abs;
    using std::sqrt;
    double largest(0);
    for (Eigen::Index i = 0; i < D.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k) {
            if (D(i, k) == 0) continue;
            const double product = std::max(D(i, i) * D(k, k), rounding * rounding);
            largest = std::max(largest, abs(D(i, k)) / sqrt(product));
        }
    return largest;
}

void set_modal_damping(const Matrix<double>& L, const Matrix<double>& K, const Matrix<double>& C, double neglected,
                       FrequencyErrors errors, ModalBasis<double>& basis) {
    using std::abs;
    const std::size_t N = basis.r_n.size();
    const double tolerance = rounding_of_modes(N);
    basis.distance_from_classical = N > 1 ? distance_from_commuting(divide_out(L, K), divide_out(L, C)) : 0.0;
    const bool commutes = basis.distance_from_classical <= tolerance,
               modal = N == 1 || C.isZero(0) || (neglected > 0 && basis.distance_from_classical <= neglected);
    if (commutes || modal) turn_coinciding_modes(C, tolerance, basis.r_n, basis.phi);
    fix_signs(basis.phi); // D goes with them
    const Matrix<double> D = in_coordinates(basis.phi, C);
    const double size = D.cwiseAbs().maxCoeff();
    if (!modal) {
        basis.D = (D + D.transpose()) / 2.0;
        basis.couples = !commutes || couples_a_pair(D, rounding_between_modes(C, D, {basis.r_n, basis.phi}, errors));
    }
    basis.zeta.assign(N, 0.0);
    for (std::size_t i = 0; i < N; ++i) {
        const auto n = static_cast<Eigen::Index>(i);
        const bool nothing = abs(D(n, n)) <= tolerance * size;
        basis.zeta[i] = nothing && D(n, n) < 0 ? 0.0 : D(n, n) / (2 * basis.r_n[i]);
        check_ratio(basis.zeta[i], i, C, basis);
    }
}

} // namespace denhartog
