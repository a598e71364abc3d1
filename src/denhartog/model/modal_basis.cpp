// Free vibrations of the undamped system, and their damping. `modal_basis` is (13)-(19): its shapes and frequencies come from
// `natural_modes`, its damping ratios are given or, by `set_modal_damping`, those of a damping matrix.
#include "denhartog/model/modal_basis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include "denhartog/formulas/system.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/number/work_counted.hpp"
#include "denhartog/scene/cholesky.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/scene/scene_rules.hpp"

namespace denhartog {
namespace {

using std::abs;
using std::sqrt;

/// A matrix as a row-major array of the formulas.
std::vector<double> to_array(const Matrix<double>& A) {
    const Matrix<double> rows = A.transpose();
    return {rows.data(), rows.data() + rows.size()};
}

/// The mass ratios where the masses are coupled by nothing but springs; empty else.
std::vector<double> lumped_masses(const System<double>& s) {
    if (s.mass_matrix.size() == 0) return s.mass_ratios;
    std::vector<double> gamma;
    if (is_diagonal(s.mass_matrix))
        for (const double mass : s.mass_matrix.diagonal()) gamma.push_back(mass);
    return gamma;
}

// Distance of A B from B A, over the sizes of both.
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

// Refuses a damping matrix that feeds energy into a motion; a zero eigenvalue may be below zero by rounding to double.
void check_passive(const Matrix<double>& C) {
    const double least = symmetric_eigenproblem(C).values.front();
    const double rounding = 16 * static_cast<double>(C.rows()) * std::numeric_limits<double>::epsilon();
    if (least < -rounding * C.cwiseAbs().maxCoeff())
        throw InputError("damping_matrix", "must take energy out of every motion: must have no negative eigenvalue",
                         number_in_digits(static_cast<double>(least), 3));
}

// Modal damping ratios from the damping matrix, 2 zeta_i r_n,i = phi_i^T C phi_i, and D. The modes move by themselves where
// K M^-1 C = C M^-1 K. Of one mode, of a matrix of zeros, and up to the distance `neglected` from that, if it is not 0, the ratios
// count alone. Else the matrix counts, whether it couples the modes or not; that is told too. The distance does not tell it alone:
// beside a stiff mode with much damping two soft ones leave no trace in it.
void set_modal_damping(const Matrix<double>& L, const Matrix<double>& K, const Matrix<double>& C, double neglected,
                       FrequencyErrors errors, ModalBasis<double>& basis) {
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

} // namespace

Matrix<double> mass_factor(const System<double>& s) {
    const std::vector<double> gamma = lumped_masses(s);
    if (gamma.empty()) return factor_of_masses(s.mass_matrix);
    Matrix<double> L = Matrix<double>::Zero(static_cast<Eigen::Index>(gamma.size()), static_cast<Eigen::Index>(gamma.size()));
    for (std::size_t i = 0; i < gamma.size(); ++i) L(i, i) = sqrt(gamma[i]);
    return L;
}

ModalBasis<double> modal_basis(const System<double>& s, Effort* effort) {
    check(s);
    const std::size_t N = number_of_masses(s);
    const std::vector<double> gamma = lumped_masses(s);
    const bool lumped = !gamma.empty() && !s.stiffness_ratios.empty();
    if (N > 1 && s.damping_matrix.size() > 0) check_passive(s.damping_matrix);
    ModalBasis<double> basis;
    if (N == 1) {
        const double m = gamma[0];
        const double k = lumped ? s.stiffness_ratios[0] : s.stiffness_matrix(0, 0);
        basis = {{sqrt(k / m)}, Matrix<double>::Constant(1, 1, 1 / sqrt(m)), {}};
    } else {
        NaturalModes modes =
            lumped ? chain_modes(gamma, s.stiffness_ratios, effort) : general_modes(mass_factor(s), stiffness_matrix(s), effort);
        ++work_counted.eigen_solves;
        basis = {std::move(modes.r_n), std::move(modes.phi), {}};
    }
    if (s.damping_matrix.size() > 0)
        set_modal_damping(mass_factor(s), stiffness_matrix(s), s.damping_matrix, s.damping_tolerance,
                          lumped ? FrequencyErrors::each : FrequencyErrors::highest, basis);
    else
        basis.zeta = s.damping_ratios;
    fix_signs(basis.phi);
    if (const Matrix<double> others = further_rows(s); others.size() > 0) {
        const Matrix<double> further = product(others, basis.phi);
        basis.phi.conservativeResize(basis.phi.rows() + further.rows(), Eigen::NoChange);
        basis.phi.bottomRows(further.rows()) = further;
    }
    require_finite(basis.r_n, basis.phi, Why::mode_out_of_range);
    return basis;
}

ModalBasis<double> modal_basis_at(const System<double>& s, const std::vector<Mass>& masses, Effort* effort) {
    check(s);
    NaturalModes modes = chain_modes(s.mass_ratios, s.stiffness_ratios, masses, effort);
    ++work_counted.eigen_solves;
    ModalBasis<double> basis{std::move(modes.r_n), std::move(modes.phi), s.damping_ratios};
    require_finite(basis.r_n, basis.phi, Why::mode_out_of_range);
    return basis;
}

template <class T>
bool every_motion_is_damped(const ModalBasis<T>& basis) {
    if (!basis.coupled()) return std::ranges::all_of(basis.zeta, [](const T& zeta) { return zeta > T(0); });
    const Matrix<double> D = basis.D.unaryExpr([](const T& entry) { return double(ValueOf<T>::of(entry)); });
    const double rounding = 256 * static_cast<int>(D.rows()) * std::numeric_limits<double>::epsilon() * D.cwiseAbs().maxCoeff();
    return symmetric_eigenproblem(D).values.front() > rounding;
}

NonDimensionalMatrices non_dimensional_matrices(const System<double>& s, const ModalBasis<double>& basis, double r) {
    check_frequency_ratio(r);
    const std::size_t N = number_of_masses(s);
    const auto n = static_cast<Eigen::Index>(N);
    NonDimensionalMatrices result{Matrix<double>::Zero(n, n), Matrix<double>::Zero(n, n), stiffness_matrix(s)};
    if (s.mass_matrix.size() > 0)
        result.M = s.mass_matrix.unaryExpr([&](double m) { return paper::non_dimensional_mass_by_ratios(m, r); });
    else
        for (std::size_t i = 0; i < N; ++i) result.M(i, i) = paper::non_dimensional_mass_by_ratios(s.mass_ratios[i], r);
    if (damping_matrix_counts(s, basis)) {
        result.C = r * s.damping_matrix;
        return result;
    }
    std::vector<double> Omega(N);
    for (std::size_t i = 0; i < N; ++i) Omega[i] = basis.r_n[i] / r;
    const Matrix<double> C =
        to_matrix(paper::damping_matrix(std::span<const double>(to_array(result.M)),
                                        std::span<const double>(to_array(Matrix<double>(basis.phi.topRows(n) / r))),
                                        std::span<const double>(Omega), std::span<const double>(basis.zeta)),
                  N);
    result.C = (C + C.transpose()) / 2.0;
    return result;
}

Matrix<double> rounding_between_modes(const Matrix<double>& C, const Matrix<double>& D, const NaturalModes& modes,
                                      FrequencyErrors errors) {
    const double tolerance = rounding_of_modes(modes.r_n.size()), highest = modes.r_n.back();
    // An entry of a mode is good to the rounding of the root of the entry of the inverse mass matrix, the sum over all modes.
    const Matrix<double> forces = product(Matrix<double>(C.cwiseAbs()), Matrix<double>(modes.phi.cwiseAbs()));
    const Matrix<double> sizes_of_entries = transpose_times(Matrix<double>(modes.phi.rowwise().norm()), forces);
    Matrix<double> rounding = Matrix<double>::Zero(D.rows(), D.cols());
    for (Eigen::Index i = 0; i < D.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k) {
            const double &r_i = modes.r_n[static_cast<std::size_t>(i)], &r_k = modes.r_n[static_cast<std::size_t>(k)];
            const double error_of_squares = tolerance * (errors == FrequencyErrors::each ? r_i * r_k : highest * highest);
            const double apart = (r_i - r_k) * (r_i + r_k), angle = error_of_squares < apart ? error_of_squares / apart : 1.0;
            rounding(i, k) = rounding(k, i) =
                tolerance * (sizes_of_entries(0, i) + sizes_of_entries(0, k)) + angle * abs(D(i, i) - D(k, k));
        }
    return rounding;
}

bool couples_a_pair(const Matrix<double>& D, const Matrix<double>& rounding) {
    for (Eigen::Index i = 0; i < D.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k)
            if (abs(D(i, k)) > rounding(i, k)) return true;
    return false;
}

void turn_coinciding_modes(const Matrix<double>& C, double tolerance, const std::vector<double>& r_n, Matrix<double>& phi) {
    const std::size_t N = r_n.size();
    for (std::size_t first = 0, last = 0; first < N; first = last + 1) {
        last = first;
        while (last + 1 < N && r_n[last + 1] - r_n[last] <= tolerance * r_n.back()) ++last;
        if (last == first) continue;
        const auto at = static_cast<Eigen::Index>(first);
        const auto count = static_cast<Eigen::Index>(last - first + 1);
        const Matrix<double> columns = phi.middleCols(at, count);
        const Matrix<double> within = in_coordinates(columns, C);
        const SymmetricEigenproblem solved = symmetric_eigenproblem(Matrix<double>((within + within.transpose()) / 2.0));
        phi.middleCols(at, count) = product(columns, solved.vectors);
    }
}

double largest_coupling(const Matrix<double>& D, std::optional<double> rounding) {
    if (D.size() == 0) return 0;
    const double least = rounding.value_or(rounding_of_modes(static_cast<std::size_t>(D.rows())) * D.cwiseAbs().maxCoeff());
    double largest(0);
    for (Eigen::Index i = 0; i < D.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k) {
            if (D(i, k) == 0) continue;
            largest = std::max(largest, abs(D(i, k)) / sqrt(std::max(D(i, i) * D(k, k), least * least)));
        }
    return largest;
}

template bool every_motion_is_damped(const ModalBasis<double>&);
template bool every_motion_is_damped(const ModalBasis<Bounded<double>>&);

} // namespace denhartog
