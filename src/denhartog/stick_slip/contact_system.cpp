/// @file
/// @brief A system with its modes, sliding and stuck, for the exact solver.
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {

namespace {

// The part of the damping that the stuck modes leave out, in the modes of sliding.
void add_left_out_of_stuck_modes(ContactSystem& c) {
    const StuckConfiguration& stuck = c.stuck;
    if (stuck.left_out.size() == 0 || !(stuck.left_out.maxCoeff() > 0)) return;
    const Matrix<double> shares = product(stuck.momentum, c.basis.phi).cwiseAbs();
    const Matrix<double> left_out = in_coordinates(shares, stuck.left_out);
    c.damping_error = c.damping_error.size() > 0 ? Matrix<double>(c.damping_error + left_out) : left_out;
}

// Rounding error of each entry of the damping, for modes that are known to more digits.
Matrix<double> rounding_of_damping(const ModalBasis<double>& basis) {
    const auto N = static_cast<Eigen::Index>(basis.r_n.size());
    Matrix<double> D = Matrix<double>::Zero(N, N);
    for (Eigen::Index i = 0; i < N; ++i) {
        const auto n = static_cast<std::size_t>(i);
        D(i, i) += 4 * unit_of<double>() * basis.zeta[n] * basis.r_n[n];
    }
    if (basis.coupled()) D += unit_of<double>() * basis.D.cwiseAbs();
    return D;
}

// Error of each entry of the damping, for modes that were found in double.
Matrix<double> error_of_damping(const System<double>& s, const ModalBasis<double>& basis) {
    if (s.damping_matrix.size() == 0) return {};
    const Matrix<double> sizes = basis.phi.cwiseAbs(), of_C = s.damping_matrix.cwiseAbs();
    return in_coordinates(sizes, of_C) * ((static_cast<int>(sizes.cols()) + 2) * unit_of<double>());
}

} // namespace

ContactSystem contact_system(const System<double>& s) { return contact_system(s, with_errors(s, modal_basis(s))); }

ContactSystem contact_system(const System<double>& s, const ModalBasis<Bounded<double>>& modes, const RoundedModes* held,
                             Effort* effort) {
    ContactSystem out;
    out.contact = contact_row(s);
    out.load = load_row(s);
    out.basis = values_of(modes);
    Matrix<double>& phi = out.basis.phi;
    const std::optional<Mass> load_im = load_rows(s).im;
    for (Eigen::Index i = 0; i < phi.cols(); ++i)
        out.modal_load.push_back({phi(static_cast<Eigen::Index>(out.load.index), i),
                                  load_im ? phi(static_cast<Eigen::Index>(load_im->index), i) : 0.0});
    out.contact_shape = phi.row(static_cast<Eigen::Index>(out.contact.index)).transpose();
    out.stuck = stuck_configuration(s, out.basis, held, effort);
    phi.conservativeResize(phi.cols(), Eigen::NoChange);
    out.stuck_load = load_on_stuck_modes(out.stuck, s.load);
    for (const Bounded<double>& r_n : modes.r_n) out.detuned.push_back(r_n.e / r_n.x);
    out.damping_error = held ? rounding_of_damping(out.basis) : error_of_damping(s, out.basis);
    add_left_out_of_stuck_modes(out);
    out.damping_fixes_modes = damping_matrix_counts(s, out.basis);
    // phi^T M phi = 1, so that phi^T M is the inverse of phi; the mass matrix keeps it free of an inversion.
    const std::size_t N = out.basis.r_n.size();
    if (held) {
        out.momentum = held->momentum;
    } else if (s.mass_matrix.size() > 0) {
        out.momentum = transpose_times(out.basis.phi, s.mass_matrix);
    } else {
        out.momentum.resize(N, N);
        for (std::size_t i = 0; i < N; ++i)
            for (std::size_t k = 0; k < N; ++k) out.momentum(i, k) = out.basis.phi(k, i) * s.mass_ratios[k];
    }
    return out;
}

void add_static_load(ContactSystem& system, const std::vector<double>& s) {
    const auto N = static_cast<Eigen::Index>(s.size());
    const Eigen::Map<const Column> force(s.data(), N);
    const Column modal = system.basis.phi.transpose() * force, stuck = system.stuck.shapes.transpose() * force;
    system.constant.modal.assign(modal.begin(), modal.end());
    system.constant.stuck.assign(stuck.begin(), stuck.end());
    system.constant.direct = system.stuck.contact.over(s[system.stuck.contact.a]);
}

void take_load_away(ContactSystem& system) {
    system.modal_load.assign(system.modal_load.size(), {});
    system.stuck_load.assign(system.stuck_load.size(), {});
    system.stuck.load.assign(system.modal_load.size(), {});
}

} // namespace denhartog
