#include "denhartog/model/stuck_configuration.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/model/modal_damping.hpp"
#include "denhartog/model/natural_modes.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/work_counted.hpp"
#include "denhartog/scene/cholesky.hpp"

namespace denhartog {
namespace {

using std::abs;
using std::sqrt;

std::vector<Eigen::Index> indices_of(const std::vector<Mass>& masses) {
    std::vector<Eigen::Index> indices;
    for (const Mass& k : masses) indices.push_back(static_cast<Eigen::Index>(k.index));
    return indices;
}

template <class T>
std::vector<T> entries(const Matrix<T>& A, Eigen::Index row, const std::vector<Eigen::Index>& columns) {
    std::vector<T> values;
    for (const Eigen::Index k : columns) values.push_back(A(row, k));
    return values;
}

/// The masses before the contact, with a spring to the ground and one to the contact; those after it, with one to the contact. No
/// mode moves masses of both.
template <class T>
NaturalModes<T> modes_of_two_chains(const System<T>& s) {
    const auto j = static_cast<std::ptrdiff_t>(s.contact.index);
    const std::vector<T>&gamma = s.mass_ratios, &kappa = s.stiffness_ratios;
    const auto n = static_cast<Eigen::Index>(gamma.size()) - 1;
    NaturalModes<T> before{{}, Matrix<T>(0, 0)}, after{{}, Matrix<T>(0, 0)};
    if (j > 0)
        before =
            chain_modes(std::vector<T>(gamma.begin(), gamma.begin() + j), std::vector<T>(kappa.begin(), kappa.begin() + j + 1));
    if (j < n)
        after =
            chain_modes(std::vector<T>(gamma.begin() + j + 1, gamma.end()), std::vector<T>(kappa.begin() + j + 1, kappa.end()));
    NaturalModes<T> both{std::vector<T>(static_cast<std::size_t>(n)), Matrix<T>::Zero(n, n)};
    std::size_t b = 0, a = 0;
    for (std::size_t i = 0; i < both.r_n.size(); ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        const bool take_before = a == after.r_n.size() || (b < before.r_n.size() && before.r_n[b] <= after.r_n[a]);
        if (take_before) {
            both.r_n[i] = before.r_n[b];
            both.phi.col(column).head(j) = before.phi.col(static_cast<Eigen::Index>(b++));
        } else {
            both.r_n[i] = after.r_n[a];
            both.phi.col(column).tail(n - j) = after.phi.col(static_cast<Eigen::Index>(a++));
        }
    }
    return both;
}

template <class T>
NaturalModes<T> stuck_modes(const System<T>& s, const StuckConfiguration<T>& stuck) {
    if (stuck.masses.size() == 1)
        return {{sqrt(T(stuck.K(0, 0) / stuck.M(0, 0)))}, Matrix<T>::Constant(1, 1, T(1 / sqrt(stuck.M(0, 0))))};
    ++work_counted.eigen_solves;
    if (is_chain(s) && !s.contact_with) return modes_of_two_chains(s);
    return general_modes(factor_of_masses(stuck.M), stuck.K);
}

/// Whether the modes couple, and how much; an entry below the rounding of the largest is compared with that rounding.
template <class T>
void set_coupling(StuckConfiguration<T>& stuck, FrequencyErrors errors, const T& tolerance) {
    const Matrix<T>& D = stuck.damping;
    const T rounding = tolerance * D.cwiseAbs().maxCoeff();
    stuck.coupling = largest_coupling(D, rounding);
    const Matrix<T> between = rounding_between_modes(stuck.C, D, {stuck.r_n, stuck.phi}, errors);
    stuck.modes_diagonalise_damping = !couples_a_pair(D, between);
    for (Eigen::Index i = 0; i < D.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k)
            stuck.modes_diagonalise_damping = stuck.modes_diagonalise_damping && abs(D(i, k)) <= rounding;
    if (!stuck.modes_diagonalise_damping) return;
    stuck.left_out = between + D.cwiseAbs();
    stuck.left_out.diagonal().setZero();
}

/// Modes of the system with the contact held, and what damping makes of them.
template <class T>
void set_modes(const System<T>& s, StuckConfiguration<T>& stuck) {
    NaturalModes<T> modes = stuck_modes(s, stuck);
    const T tolerance = rounding_of_modes<T>(stuck.masses.size() + 1);
    turn_coinciding_modes(stuck.C, tolerance, modes.r_n, modes.phi);
    fix_signs(modes.phi);
    stuck.r_n = std::move(modes.r_n);
    stuck.phi = std::move(modes.phi);
    const Matrix<T> D = in_coordinates(stuck.phi, stuck.C);
    stuck.damping = (D + D.transpose()) / T(2);
    set_coupling(stuck, is_chain(s) && !s.contact_with ? FrequencyErrors::of_each : FrequencyErrors::of_highest, tolerance);
}

/// The same from elsewhere.
template <class T>
void set_modes(const RoundedModes<T>& held, StuckConfiguration<T>& stuck) {
    stuck.r_n = held.r_n;
    stuck.phi = held.phi;
    stuck.damping = held.damping;
    stuck.coupling = largest_coupling(held.damping);
    stuck.modes_diagonalise_damping = stuck.coupling == 0;
}

template <class T>
void require_finite(const StuckConfiguration<T>& stuck) {
    using std::isfinite;
    for (std::size_t i = 0; i < stuck.r_n.size(); ++i) {
        bool all = isfinite(stuck.r_n[i]) && stuck.r_n[i] > 0;
        for (const T& entry : stuck.phi.col(static_cast<Eigen::Index>(i))) all = all && isfinite(entry);
        if (!all) throw PrecisionError("stuck mode " + std::to_string(i + 1) + " is beyond the range of the number type");
    }
}

} // namespace

template <class T>
StuckConfiguration<T> stuck_configuration(const System<T>& s, const ModalBasis<T>& basis, const RoundedModes<T>* held) {
    check(s);
    const std::size_t N = number_of_masses(s);
    StuckConfiguration<T> stuck{};
    stuck.contact = contact_of(s.contact, s.contact_with, mass_matrix(s));
    HeldMatrices<T> all = held_matrices(s, stuck.contact, non_dimensional_matrices(s, basis, T(1)).C);
    if (held) all.C = held->C;
    const auto j = static_cast<Eigen::Index>(stuck.contact.a);
    for (std::size_t k = 0; k < N; ++k)
        if (k != stuck.contact.a) stuck.masses.push_back(Mass{k});
    const std::vector<Eigen::Index> others = indices_of(stuck.masses);
    stuck.M = all.M(others, others);
    stuck.C = all.C(others, others);
    stuck.K = all.K(others, others);
    stuck.m_j = entries(all.M, j, others);
    stuck.c_j = entries(all.C, j, others);
    stuck.k_j = entries(all.K, j, others);
    stuck.k_jj = all.K(j, j);
    stuck.k_contact = N == 1 ? stuck.k_jj : T(1 / compliance(basis, static_cast<Eigen::Index>(contact_row(s).index)));
    stuck.load = s.load_vector;
    stuck.carried.assign(N, T(0));
    stuck.carried[stuck.contact.a] = T(stuck.contact.sign);
    stuck.coupling = T(0);
    stuck.modes_diagonalise_damping = true;
    const auto n = static_cast<Eigen::Index>(N);
    stuck.shapes = Matrix<T>::Zero(n, n - 1);
    stuck.momentum = Matrix<T>::Zero(n - 1, n);
    if (N == 1) return stuck;
    if (held)
        set_modes(*held, stuck);
    else
        set_modes(s, stuck);
    require_finite(stuck);
    stuck.shapes(others, Eigen::all) = stuck.phi;
    if (stuck.contact.b) stuck.shapes.row(j) = stuck.shapes.row(static_cast<Eigen::Index>(*stuck.contact.b));
    stuck.momentum(Eigen::all, others) = transpose_times(stuck.phi, stuck.M);
    return stuck;
}

template StuckConfiguration<double> stuck_configuration(const System<double>&, const ModalBasis<double>&,
                                                        const RoundedModes<double>*);

} // namespace denhartog
