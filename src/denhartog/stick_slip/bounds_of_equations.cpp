// Bounds of what the equations of a motion with stops are made of in double: of the modes, in `contact_system`; of (6) with the
// contact held, in `held_response`, which needs what errors of the modes make of the damping matrix, `errors_of_C`.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"

namespace denhartog {
namespace {

// Error of each entry of the damping in the modes of sliding: of modes that were found in double or, `held`, are known to more digits;
// and what the stuck modes leave out of it.
Matrix<double> error_of_damping(const System<double>& s, const ModalBasis<double>& basis, const StuckConfiguration& stuck,
                                bool held) {
    const double unit = unit_of<double>();
    Matrix<double> D;
    if (held) {
        D = Matrix<double>::Zero(basis.phi.cols(), basis.phi.cols());
        for (std::size_t i = 0; i < basis.r_n.size(); ++i) D(i, i) += 4 * unit * basis.zeta[i] * basis.r_n[i];
        if (basis.coupled()) D += unit * basis.D.cwiseAbs();
    } else if (s.damping_matrix.size() > 0) {
        const Matrix<double> sizes = basis.phi.cwiseAbs(), C = s.damping_matrix.cwiseAbs();
        D = in_coordinates(sizes, C) * ((static_cast<int>(sizes.cols()) + 2) * unit);
    }
    if (stuck.left_out.size() == 0 || !(stuck.left_out.maxCoeff() > 0)) return D;
    const Matrix<double> shares = product(stuck.momentum, basis.phi).cwiseAbs(),
                         left_out = in_coordinates(shares, stuck.left_out);
    return D.size() > 0 ? Matrix<double>(D + left_out) : left_out;
}

// Forces with their errors, and bounds of the damping's, in the coordinates of a held contact.
void take_into_held(const Contact& contact, std::vector<Complex<double>>& p, std::vector<double>& error_of_p,
                    Matrix<double>& error_of_C) {
    const auto a = static_cast<Eigen::Index>(contact.a);
    for (const BesideContact& other : contact.others) {
        const auto k = static_cast<Eigen::Index>(other.k);
        const double share = other.share, size = std::abs(share);
        const Complex<double> passed = share * p[contact.a];
        if (size != 1) error_of_p.resize(p.size());
        if (!error_of_p.empty())
            error_of_p[other.k] += size * error_of_p[contact.a] +
                                   (size == 1 ? 0 : 2 * unit_of<double>() * (std::abs(passed.re) + std::abs(passed.im)));
        p[other.k] = p[other.k] + passed;
        error_of_C.col(k) += size * error_of_C.col(a);
        error_of_C.row(k) += size * error_of_C.row(a);
    }
}

} // namespace

ContactSystem contact_system(const System<double>& s) { return contact_system(s, with_errors(s, modal_basis(s))); }

ContactSystem contact_system(const System<double>& s, const ModalBasis<Bounded<double>>& modes, const RoundedModes* held,
                             Effort* effort) {
    ContactSystem out = contact_system(s, values_of(modes), held, effort);
    for (const Bounded<double>& r_n : modes.r_n) out.detuned.push_back(r_n.e / r_n.x);
    out.damping_error = error_of_damping(s, out.basis, out.stuck, held != nullptr);
    return out;
}

HeldResponse held_response(const Scene<double>& scene, const StuckConfiguration& stuck, Matrix<double> error_of_C) {
    const std::size_t N = stuck.masses.size() + 1, a = stuck.contact.a;
    std::vector<Complex<double>> p = complex_load(scene.system);
    std::vector<double> error_of_p = error_of_load(scene.system);
    const double error_of_direct = error_of_p.empty() ? 0 : std::abs(stuck.contact.over(error_of_p[a]));
    take_into_held(stuck.contact, p, error_of_p, error_of_C);
    std::vector<Complex<double>> forces;
    std::vector<double> errors;
    std::vector<Eigen::Index> others;
    for (const Mass& k : stuck.masses) {
        forces.push_back(p[k.index]);
        if (!error_of_p.empty()) errors.push_back(error_of_p[k.index]);
        others.push_back(static_cast<Eigen::Index>(k.index));
    }
    const Bounded<double> r = as_input(*scene.r);
    std::vector<Complex<Bounded<double>>> moving;
    if (N > 1)
        moving = harmonic_responses(harmonic_system(stuck.M, stuck.C, stuck.K, error_of_C(others, others), r), forces, errors);
    HeldResponse held{std::vector<Complex<Bounded<double>>>(N), {}};
    HeldRow<Bounded<double>> row;
    for (std::size_t i = 0; i + 1 < N; ++i) {
        if (!std::isfinite(moving[i].re.e + moving[i].im.e)) throw DomainError(Why::held_system_resonates);
        held.X[stuck.masses[i].index] = moving[i];
        const double c = stuck.c_j[i],
                     error_of_c = std::abs(stuck.contact.over(error_of_C(static_cast<Eigen::Index>(a), others[i])));
        row.c.emplace_back(c, error_of_c + unit_of<double>() * std::abs(c));
        row.k.push_back(as_input(stuck.k_j[i]));
        row.m.push_back(as_input(stuck.m_j[i]));
    }
    std::optional<Bounded<double>> re, im; // of mass a, which goes with those beside it
    for (const BesideContact& other : stuck.contact.others) {
        const Bounded<double> share =
            std::abs(other.share) == 1 ? Bounded<double>(other.share) : as_input(other.share); // +-1: exact
        add_times(re, share, held.X[other.k].re);
        add_times(im, share, held.X[other.k].im);
    }
    if (re) held.X[a] = {*re, *im};
    const Complex<double> direct = direct_load(stuck, scene.system.load);
    const bool as_given = std::abs(stuck.contact.w_a) == 1;
    const auto bounded = [error_of_direct, as_given](double part) {
        return part == 1 && as_given ? Bounded<double>(1) : Bounded<double>(part, as_input(part).e + error_of_direct);
    };
    row.direct = {bounded(direct.re), bounded(direct.im)};
    held.load = modulus(row.load(r, moving));
    return held;
}

Bounded<double> compliance_of(const StuckConfiguration& stuck) {
    const auto n = static_cast<Eigen::Index>(stuck.masses.size());
    Matrix<double> K(n + 1, n + 1);
    K.topLeftCorner(n, n) = stuck.K;
    for (Eigen::Index i = 0; i < n; ++i) K(i, n) = K(n, i) = stuck.k_j[static_cast<std::size_t>(i)];
    K(n, n) = stuck.k_jj;
    const Bounded<double> found = BoundedSystem(K, Matrix<double>::Zero(n + 1, n + 1)).solved(Column::Unit(n + 1, n)).back();
    const double by_modes = 1 / stuck.k_contact; // a number also where K is singular in double
    return {by_modes, found.e + std::abs(found.x - by_modes)};
}

// The bounds are those of frequencies, of ratios and of the modes' sizes, and of modes that rounding turns towards each other, which
// have different damping. A mode far from all others is turned as well.
Matrix<double> errors_of_C(const System<double>& s, const ModalBasis<Bounded<double>>& basis) {
    const auto N = static_cast<Eigen::Index>(basis.r_n.size());
    if (damping_matrix_counts(s, basis)) return Matrix<double>::Zero(N, N);
    const Matrix<double> phi = basis.phi.topRows(N).unaryExpr([](const Bounded<double>& entry) { return std::abs(entry.x); });
    const double unit = 2 * basis.r_n.back().e / basis.r_n.back().x; // what the solver is trusted with
    std::vector<Bounded<double>> rates;                              // of decay, (18)
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) rates.push_back(2.0 * basis.zeta[i] * basis.r_n[i]);
    Matrix<double> in_modes = Matrix<double>::Zero(N, N);
    for (Eigen::Index i = 0; i < N; ++i)
        for (Eigen::Index k = 0; k < N; ++k) {
            const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(k);
            const double rounding_of_both = unit * (rates[a].x + rates[b].x);
            in_modes(i, k) += rounding_of_both;
            if (k == i) {
                in_modes(i, i) += rates[a].e;
                continue;
            }
            const double angle = angle_of_turn(basis.r_n[a], basis.r_n[b]), apart = std::abs(rates[a].x - rates[b].x);
            in_modes(i, k) += angle * apart;
            in_modes(i, i) += angle * angle * apart; // a mode turned by a right angle has the other's damping
        }
    Matrix<double> momentum = s.mass_matrix.size() > 0 ? product(Matrix<double>(s.mass_matrix.cwiseAbs()), phi) : phi;
    if (s.mass_matrix.size() == 0)
        for (Eigen::Index k = 0; k < N; ++k) momentum.row(k) *= s.mass_ratios[static_cast<std::size_t>(k)];
    return in_coordinates(Matrix<double>(momentum.transpose()), in_modes);
}

} // namespace denhartog
