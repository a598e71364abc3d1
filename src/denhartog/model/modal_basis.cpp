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
#include "denhartog/number/errors.hpp"
#include "denhartog/number/work_counted.hpp"
#include "denhartog/scene/cholesky.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog {
namespace {

using std::sqrt;

template <class T>
using RowMajor = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A row-major array of the formulas as a matrix.
template <class T>
Matrix<T> to_matrix(const std::vector<T>& entries, std::size_t N) {
    return Eigen::Map<const RowMajor<T>>(entries.data(), static_cast<Eigen::Index>(N), static_cast<Eigen::Index>(N));
}

/// A matrix as a row-major array of the formulas.
template <class T>
std::vector<T> to_array(const Matrix<T>& A) {
    std::vector<T> entries(static_cast<std::size_t>(A.size()));
    Eigen::Map<RowMajor<T>>(entries.data(), A.rows(), A.cols()) = A;
    return entries;
}

/// The mass ratios where the masses are coupled by nothing but springs; empty else.
template <class T>
std::vector<T> lumped_masses(const System<T>& s) {
    if (s.mass_matrix.size() == 0) return s.mass_ratios;
    std::vector<T> gamma;
    if (is_diagonal(s.mass_matrix))
        for (const T& mass : s.mass_matrix.diagonal()) gamma.push_back(mass);
    return gamma;
}

template <class T>
Matrix<T> mass_factor(const System<T>& s, const std::vector<T>& gamma) {
    if (gamma.empty()) return factor_of_masses(s.mass_matrix);
    Matrix<T> L = Matrix<T>::Zero(static_cast<Eigen::Index>(gamma.size()), static_cast<Eigen::Index>(gamma.size()));
    for (std::size_t i = 0; i < gamma.size(); ++i) L(i, i) = sqrt(gamma[i]);
    return L;
}

template <class T>
void require_finite(const ModalBasis<T>& basis) {
    using std::isfinite;
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        bool all = isfinite(basis.r_n[i]) && basis.r_n[i] > 0 && isfinite(basis.zeta[i]);
        for (Eigen::Index k = 0; k < basis.phi.rows(); ++k) all = all && isfinite(basis.phi(k, static_cast<Eigen::Index>(i)));
        if (!all) throw PrecisionError("mode " + std::to_string(i + 1) + " is beyond the range of the number type");
    }
}

} // namespace

template <class T>
Matrix<T> mass_factor(const System<T>& s) {
    return mass_factor(s, lumped_masses(s));
}

template <class T>
ModalBasis<T> modal_basis(const System<T>& s) {
    check(s);
    const std::size_t N = number_of_masses(s);
    const std::vector<T> gamma = lumped_masses(s);
    const bool lumped = !gamma.empty() && !s.stiffness_ratios.empty();
    if (N > 1 && s.damping_matrix.size() > 0) check_passive(s.damping_matrix);
    ModalBasis<T> basis;
    if (N == 1) {
        const T m = gamma[0];
        const T k = lumped ? s.stiffness_ratios[0] : s.stiffness_matrix(0, 0);
        basis = {{sqrt(T(k / m))}, Matrix<T>::Constant(1, 1, T(1 / sqrt(m))), {}};
    } else {
        NaturalModes<T> modes =
            lumped ? chain_modes(gamma, s.stiffness_ratios) : general_modes(mass_factor(s, gamma), stiffness_matrix(s));
        ++work_counted.eigen_solves;
        basis = {std::move(modes.r_n), std::move(modes.phi), {}};
    }
    if (s.damping_matrix.size() > 0)
        set_modal_damping(mass_factor(s, gamma), stiffness_matrix(s), s.damping_matrix, s.damping_tolerance,
                          lumped ? FrequencyErrors::of_each : FrequencyErrors::of_highest, basis);
    else
        basis.zeta = s.damping_ratios;
    fix_signs(basis.phi);
    if (const Matrix<T> others = further_rows(s); others.size() > 0) {
        const Matrix<T> further = product(others, basis.phi);
        basis.phi.conservativeResize(basis.phi.rows() + further.rows(), Eigen::NoChange);
        basis.phi.bottomRows(further.rows()) = further;
    }
    require_finite(basis);
    return basis;
}

template <class T>
ModalBasis<T> modal_basis_at(const System<T>& s, const std::vector<Mass>& masses) {
    const bool chain = is_chain(s) && !s.damping_ratios.empty();
    ModalBasis<T> basis;
    if (chain && s.mass_ratios.size() > 1) {
        check(s);
        NaturalModes<T> modes = chain_modes(s.mass_ratios, s.stiffness_ratios, masses);
        ++work_counted.eigen_solves;
        basis = {std::move(modes.r_n), std::move(modes.phi), s.damping_ratios};
        require_finite(basis);
        return basis;
    }
    const ModalBasis<T> all = modal_basis(s);
    basis = {all.r_n, Matrix<T>(static_cast<Eigen::Index>(masses.size()), all.phi.cols()), all.zeta};
    for (std::size_t n = 0; n < masses.size(); ++n)
        basis.phi.row(static_cast<Eigen::Index>(n)) = all.phi.row(static_cast<Eigen::Index>(masses[n].index));
    return basis;
}

template <class T>
bool every_motion_is_damped(const ModalBasis<T>& basis) {
    if (!basis.coupled()) return std::ranges::all_of(basis.zeta, [](const T& zeta) { return zeta > T(0); });
    using Value = typename ValueOf<T>::type;
    const Matrix<Value> D = basis.D.unaryExpr([](const T& entry) { return Value(ValueOf<T>::of(entry)); });
    const Value rounding = 256 * static_cast<int>(D.rows()) * std::numeric_limits<Value>::epsilon() * D.cwiseAbs().maxCoeff();
    return symmetric_eigenproblem(D).values.front() > rounding;
}

template <class T>
NonDimensionalMatrices<T> non_dimensional_matrices(const System<T>& s, const ModalBasis<T>& basis, const T& r) {
    check_frequency_ratio(r);
    const std::size_t N = number_of_masses(s);
    const auto n = static_cast<Eigen::Index>(N);
    NonDimensionalMatrices<T> result{Matrix<T>::Zero(n, n), Matrix<T>::Zero(n, n), stiffness_matrix(s)};
    if (s.mass_matrix.size() > 0)
        result.M = s.mass_matrix.unaryExpr([&](const T& m) { return paper::non_dimensional_mass_by_ratios(m, r); });
    else
        for (std::size_t i = 0; i < N; ++i) result.M(i, i) = paper::non_dimensional_mass_by_ratios(s.mass_ratios[i], r);
    if (damping_matrix_counts(s, basis)) {
        result.C = r * s.damping_matrix;
        return result;
    }
    std::vector<T> Omega(N);
    for (std::size_t i = 0; i < N; ++i) Omega[i] = basis.r_n[i] / r;
    const Matrix<T> C = to_matrix(paper::damping_matrix(std::span<const T>(to_array(result.M)),
                                                        std::span<const T>(to_array(Matrix<T>(basis.phi.topRows(n) / r))),
                                                        std::span<const T>(Omega), std::span<const T>(basis.zeta)),
                                  N);
    result.C = (C + C.transpose()) / T(2);
    return result;
}

template Matrix<double> mass_factor(const System<double>&);
template ModalBasis<double> modal_basis(const System<double>&);
template ModalBasis<double> modal_basis_at(const System<double>&, const std::vector<Mass>&);
template bool every_motion_is_damped(const ModalBasis<double>&);
template bool every_motion_is_damped(const ModalBasis<Bounded<double>>&);
template NonDimensionalMatrices<double> non_dimensional_matrices(const System<double>&, const ModalBasis<double>&, const double&);

} // namespace denhartog
