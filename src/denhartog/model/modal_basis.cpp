#include "denhartog/model/modal_basis.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "denhartog/formulas/system.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/model/modal_damping.hpp"
#include "denhartog/model/natural_modes.hpp"
#include "denhartog/number/bounded.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/number/work_counted.hpp"
#include "denhartog/scene/cholesky.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog {
namespace {

using std::sqrt;

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A row-major array of the formulas as a matrix.
Matrix<double> to_matrix(const std::vector<double>& entries, std::size_t N) {
    return Eigen::Map<const RowMajor>(entries.data(), static_cast<Eigen::Index>(N), static_cast<Eigen::Index>(N));
}

/// A matrix as a row-major array of the formulas.
std::vector<double> to_array(const Matrix<double>& A) {
    std::vector<double> entries(static_cast<std::size_t>(A.size()));
    Eigen::Map<RowMajor>(entries.data(), A.rows(), A.cols()) = A;
    return entries;
}

/// The mass ratios where the masses are coupled by nothing but springs; empty else.
std::vector<double> lumped_masses(const System<double>& s) {
    if (s.mass_matrix.size() == 0) return s.mass_ratios;
    std::vector<double> gamma;
    if (is_diagonal(s.mass_matrix))
        for (const double mass : s.mass_matrix.diagonal()) gamma.push_back(mass);
    return gamma;
}

Matrix<double> mass_factor(const System<double>& s, const std::vector<double>& gamma) {
    if (gamma.empty()) return factor_of_masses(s.mass_matrix);
    Matrix<double> L = Matrix<double>::Zero(static_cast<Eigen::Index>(gamma.size()), static_cast<Eigen::Index>(gamma.size()));
    for (std::size_t i = 0; i < gamma.size(); ++i) L(i, i) = sqrt(gamma[i]);
    return L;
}

void require_finite(const ModalBasis<double>& basis) {
    using std::isfinite;
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        bool all = isfinite(basis.r_n[i]) && basis.r_n[i] > 0 && isfinite(basis.zeta[i]);
        for (Eigen::Index k = 0; k < basis.phi.rows(); ++k) all = all && isfinite(basis.phi(k, static_cast<Eigen::Index>(i)));
        if (!all) throw PrecisionError({Why::mode_out_of_range, i + 1});
    }
}

} // namespace

Matrix<double> mass_factor(const System<double>& s) { return mass_factor(s, lumped_masses(s)); }

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
        NaturalModes modes = lumped ? chain_modes(gamma, s.stiffness_ratios, effort)
                                    : general_modes(mass_factor(s, gamma), stiffness_matrix(s), effort);
        ++work_counted.eigen_solves;
        basis = {std::move(modes.r_n), std::move(modes.phi), {}};
    }
    if (s.damping_matrix.size() > 0)
        set_modal_damping(mass_factor(s, gamma), stiffness_matrix(s), s.damping_matrix, s.damping_tolerance,
                          lumped ? FrequencyErrors::of_each : FrequencyErrors::of_highest, basis);
    else
        basis.zeta = s.damping_ratios;
    fix_signs(basis.phi);
    if (const Matrix<double> others = further_rows(s); others.size() > 0) {
        const Matrix<double> further = product(others, basis.phi);
        basis.phi.conservativeResize(basis.phi.rows() + further.rows(), Eigen::NoChange);
        basis.phi.bottomRows(further.rows()) = further;
    }
    require_finite(basis);
    return basis;
}

ModalBasis<double> modal_basis_at(const System<double>& s, const std::vector<Mass>& masses, Effort* effort) {
    const bool chain = is_chain(s) && !s.damping_ratios.empty();
    ModalBasis<double> basis;
    if (chain && s.mass_ratios.size() > 1) {
        check(s);
        NaturalModes modes = chain_modes(s.mass_ratios, s.stiffness_ratios, masses, effort);
        ++work_counted.eigen_solves;
        basis = {std::move(modes.r_n), std::move(modes.phi), s.damping_ratios};
        require_finite(basis);
        return basis;
    }
    const ModalBasis<double> all = modal_basis(s, effort);
    basis = {all.r_n, Matrix<double>(static_cast<Eigen::Index>(masses.size()), all.phi.cols()), all.zeta};
    for (std::size_t n = 0; n < masses.size(); ++n)
        basis.phi.row(static_cast<Eigen::Index>(n)) = all.phi.row(static_cast<Eigen::Index>(masses[n].index));
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

template bool every_motion_is_damped(const ModalBasis<double>&);
template bool every_motion_is_damped(const ModalBasis<Bounded<double>>&);

} // namespace denhartog
