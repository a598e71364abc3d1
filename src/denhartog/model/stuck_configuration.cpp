// The system with the contact held. `stuck_configuration` takes row and column a out of the matrices; `set_modes` has the modes
// of what is left.
#include "denhartog/model/stuck_configuration.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/model/modal_basis.hpp"
#include "denhartog/model/natural_modes.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/number/work_counted.hpp"
#include "denhartog/scene/cholesky.hpp"

namespace denhartog {
namespace {

using std::sqrt;

std::vector<Eigen::Index> indices_of(const std::vector<Mass>& masses) {
    std::vector<Eigen::Index> indices;
    for (const Mass& k : masses) indices.push_back(static_cast<Eigen::Index>(k.index));
    return indices;
}

std::vector<double> entries(const Matrix<double>& A, Eigen::Index row, const std::vector<Eigen::Index>& columns) {
    std::vector<double> values;
    for (const Eigen::Index k : columns) values.push_back(A(row, k));
    return values;
}

/// The masses before the contact, with a spring to the ground and one to the contact; those after it, with one to the contact. No
/// mode moves masses of both.
NaturalModes modes_of_two_chains(const System<double>& s, Effort* effort) {
    const auto j = static_cast<std::ptrdiff_t>(s.contact.index);
    const std::vector<double>&gamma = s.mass_ratios, &kappa = s.stiffness_ratios;
    const auto n = static_cast<Eigen::Index>(gamma.size()) - 1;
    NaturalModes before{{}, Matrix<double>(0, 0)}, after{{}, Matrix<double>(0, 0)};
    if (j > 0)
        before = chain_modes(std::vector<double>(gamma.begin(), gamma.begin() + j),
                             std::vector<double>(kappa.begin(), kappa.begin() + j + 1), effort);
    if (j < n)
        after = chain_modes(std::vector<double>(gamma.begin() + j + 1, gamma.end()),
                            std::vector<double>(kappa.begin() + j + 1, kappa.end()), effort);
    Matrix<double> shapes = Matrix<double>::Zero(n, n);
    shapes.topLeftCorner(j, j) = before.phi;
    shapes.bottomRightCorner(n - j, n - j) = after.phi;
    std::vector<double> r_n = std::move(before.r_n);
    r_n.insert(r_n.end(), after.r_n.begin(), after.r_n.end());
    std::vector<Eigen::Index> order(r_n.size());
    std::iota(order.begin(), order.end(), Eigen::Index(0));
    std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
        return r_n[static_cast<std::size_t>(a)] < r_n[static_cast<std::size_t>(b)];
    });
    std::sort(r_n.begin(), r_n.end());
    return {std::move(r_n), shapes(Eigen::all, order)};
}

NaturalModes stuck_modes(const System<double>& s, const StuckConfiguration& stuck, Effort* effort) {
    if (stuck.masses.size() == 1)
        return {{sqrt(stuck.K(0, 0) / stuck.M(0, 0))}, Matrix<double>::Constant(1, 1, 1 / sqrt(stuck.M(0, 0)))};
    ++work_counted.eigen_solves;
    if (is_chain(s) && !contact_moves_apart(s)) return modes_of_two_chains(s, effort);
    return general_modes(factor_of_masses(stuck.M), stuck.K, effort);
}

/// Tells if D couples no modes; an entry below the rounding of the largest is no coupling.
void set_coupling(StuckConfiguration& stuck, FrequencyErrors errors, double tolerance) {
    const Matrix<double>& D = stuck.damping;
    const Matrix<double> between = rounding_between_modes(stuck.C, D, {stuck.r_n, stuck.phi}, errors);
    stuck.modes_diagonalise_damping = !couples_a_pair(D, between.cwiseMin(tolerance * D.cwiseAbs().maxCoeff()));
    if (!stuck.modes_diagonalise_damping) return;
    stuck.left_out = between + D.cwiseAbs();
    stuck.left_out.diagonal().setZero();
}

/// Modes of the system with the contact held, and their damping.
void set_modes(const System<double>& s, StuckConfiguration& stuck, Effort* effort) {
    NaturalModes modes = stuck_modes(s, stuck, effort);
    const double tolerance = rounding_of_modes(number_of_masses(s));
    turn_coinciding_modes(stuck.C, tolerance, modes.r_n, modes.phi);
    fix_signs(modes.phi);
    stuck.r_n = std::move(modes.r_n);
    stuck.phi = std::move(modes.phi);
    const Matrix<double> D = in_coordinates(stuck.phi, stuck.C);
    stuck.damping = (D + D.transpose()) / 2.0;
    set_coupling(stuck, is_chain(s) && !contact_moves_apart(s) ? FrequencyErrors::each : FrequencyErrors::highest, tolerance);
}

/// Takes modes and damping that more digits have found.
void set_modes(const RoundedModes& held, StuckConfiguration& stuck) {
    stuck.r_n = held.r_n;
    stuck.phi = held.phi;
    stuck.damping = held.damping;
    stuck.modes_diagonalise_damping = is_diagonal(held.damping);
}

} // namespace

StuckConfiguration stuck_configuration(const System<double>& s, const ModalBasis<double>& basis, const RoundedModes* held,
                                       Effort* effort) {
    check(s);
    const std::size_t N = number_of_masses(s);
    StuckConfiguration stuck{};
    stuck.contact = contact_of(contact_vector(s), mass_matrix(s));
    NonDimensionalMatrices all = held_matrices(s, stuck.contact, non_dimensional_matrices(s, basis, 1.0).C);
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
    stuck.k_contact = N == 1 ? stuck.k_jj : 1 / compliance(basis, static_cast<Eigen::Index>(contact_row(s).index));
    if (!s.load_vector.empty()) stuck.load = complex_load(s);
    stuck.carried.assign(N, 0.0);
    stuck.carried[stuck.contact.a] = stuck.contact.over(1);
    stuck.modes_diagonalise_damping = true;
    const auto n = static_cast<Eigen::Index>(N);
    stuck.shapes = Matrix<double>::Zero(n, n - 1);
    stuck.momentum = Matrix<double>::Zero(n - 1, n);
    if (N == 1) return stuck;
    if (held)
        set_modes(*held, stuck);
    else
        set_modes(s, stuck, effort);
    require_finite(stuck.r_n, stuck.phi, Why::stuck_mode_out_of_range);
    stuck.shapes(others, Eigen::all) = stuck.phi;
    stuck.contact.hold(stuck.shapes);
    stuck.momentum(Eigen::all, others) = transpose_times(stuck.phi, stuck.M);
    return stuck;
}

} // namespace denhartog
