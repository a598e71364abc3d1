#include "denhartog/answer/held_solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "denhartog/answer/certify.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {
namespace {

using std::abs;

// A number that is written as a double has to be one.
void require_in_range(double number, const char* name) {
    if (!std::isfinite(number))
        throw PrecisionError(std::string(name) + " is beyond the range of a double; 16 digits and more are written as text");
}

// Bounds of the errors of the complex amplitudes, and of the load that they bring to the contact. The equations of motion with
// the contact held are taken as real ones of twice the size.
struct HeldErrors {
    std::vector<double> masses; // of those that move, in the order of the stuck configuration
    double load;
};

// Bounds of what errors of the modes make of the damping matrix (19): those of frequencies, of ratios and of the modes' sizes, and
// modes that rounding turns towards each other, which have different damping. A mode far from all others is turned as well.
Matrix<double> errors_of_damping(const Scene<double>& scene, const ModalBasis<Bounded<double>>& basis) {
    const System<double>& s = scene.system;
    const auto N = static_cast<Eigen::Index>(basis.r_n.size());
    if (damping_matrix_counts(s, basis)) return Matrix<double>::Zero(N, N);
    const Matrix<double> phi = basis.phi.topRows(N).unaryExpr([](const Bounded<double>& entry) { return abs(entry.x); });
    const double unit = 2 * basis.r_n.back().e / basis.r_n.back().x; // what the solver is trusted with
    std::vector<Bounded<double>> rates;                              // of decay, (18)
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) rates.push_back(2.0 * basis.zeta[i] * basis.r_n[i]);
    Matrix<double> in_modes = Matrix<double>::Zero(N, N);
    for (Eigen::Index i = 0; i < N; ++i)
        for (Eigen::Index k = 0; k < N; ++k) {
            const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(k);
            const double of_both = unit * (rates[a].x + rates[b].x);
            in_modes(i, k) += of_both;
            if (k == i) {
                in_modes(i, i) += rates[a].e;
                continue;
            }
            const double angle = angle_of_turn(basis.r_n[a], basis.r_n[b]), apart = abs(rates[a].x - rates[b].x);
            in_modes(i, k) += angle * apart;
            in_modes(i, i) += angle * angle * apart; // a mode turned by a right angle has the other's damping
        }
    Matrix<double> momentum = s.mass_matrix.size() > 0 ? product(Matrix<double>(s.mass_matrix.cwiseAbs()), phi) : phi;
    if (s.mass_matrix.size() == 0)
        for (Eigen::Index k = 0; k < N; ++k) momentum.row(k) *= s.mass_ratios[static_cast<std::size_t>(k)];
    return in_coordinates(Matrix<double>(momentum.transpose()), in_modes);
}

// (88) as printed on numbers that carry their bounds: modes of the masses on the load's side of the contact, damping read from the
// diagonal.
Bounded<double> bounded_limit_by_88(const Scene<double>& scene, const StuckConfiguration<double>& stuck,
                                    const Matrix<double>& of_damping, const StuckChain& chain, const StuckResponse& response) {
    const Bounded<double> mu = as_input(scene.mu), r = as_input(*scene.r);
    if (!chain.kappa) return paper::sticking_limit_under_load(mu);
    const auto n = static_cast<Eigen::Index>(chain.masses.size());
    const auto first = static_cast<Eigen::Index>(chain.masses.front().index);
    const Eigen::Index of_stuck = chain.masses.front().index > scene.system.contact.index ? first - 1 : first;
    System<double> moving; // as much of it as the bounds need
    moving.mass_ratios.assign(scene.system.mass_ratios.begin() + first, scene.system.mass_ratios.begin() + first + n);
    moving.stiffness_ratios.assign(scene.system.stiffness_ratios.begin() + first,
                                   scene.system.stiffness_ratios.begin() + first + n);
    moving.damping_matrix = stuck.C.block(of_stuck, of_stuck, n, n);
    const Matrix<double> left_out = of_damping.block(first, first, n, n);
    const ModalBasis<Bounded<double>> modes = with_errors(moving, ModalBasis<double>{chain.r_n, chain.phi, chain.zeta, {}, 0.0});
    const auto [neighbour, load] = rows_of_neighbour_and_load(chain, response);
    Complex<Bounded<double>> X{Bounded<double>(0), Bounded<double>(0)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const Bounded<double>& r_n = modes.r_n[static_cast<std::size_t>(i)];
        const Column<double> size = chain.phi.col(i).cwiseAbs();
        Bounded<double> D = Bounded<double>(2) * modes.zeta[static_cast<std::size_t>(i)] * r_n;
        D.e += 2.0 * size.dot(product(left_out, size));
        X = X + modes.phi(neighbour, i) *
                    amplitude_of_mode(modes.phi(load, i), Bounded<double>((r_n - r) * (r_n + r)), Bounded<double>(r * D));
    }
    return paper::sticking_limit_by_spring(as_input(*chain.kappa), modulus(X), mu);
}

std::optional<Certified> limit_by_88(const Scene<double>& scene, const StuckConfiguration<double>& stuck,
                                     const Matrix<double>& of_damping, const StuckResponse& response) {
    const std::optional<StuckChain> chain = stuck_chain(scene.system, stuck);
    const std::optional<double> paper = sticking_boundary(response, chain, scene.mu).paper;
    if (!paper) return std::nullopt;
    require_in_range(*paper, "permanent sticking by (88)");
    const Bounded<double> bounded = bounded_limit_by_88(scene, stuck, of_damping, *chain, response);
    return certified(Bounded<double>(*paper, bounded.e + abs(bounded.x - *paper)));
}

HeldErrors errors_of(const Scene<double>& scene, const StuckConfiguration<double>& stuck, const Matrix<double>& damping_errors,
                     const StuckResponse& response) {
    const auto n = static_cast<Eigen::Index>(stuck.masses.size());
    const double r = *scene.r, eps = unit_of<double>(), rounding = 8 * static_cast<int>(n + 1) * eps;
    const std::vector<double> p = load_vector(scene.system);
    HeldErrors errors{{}, eps * std::max(1.0, abs(direct_load(stuck, scene.system.load))) + rounding * scene.mu * *scene.beta};
    if (n == 0) return errors;
    const Matrix<double> stiffness = stuck.K - r * r * stuck.M, damping = r * stuck.C;
    Matrix<double> A(2 * n, 2 * n);
    A << stiffness, -damping, damping, stiffness;
    Column<double> X(2 * n), b = Column<double>::Zero(2 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Mass k = stuck.masses[static_cast<std::size_t>(i)];
        X(i) = response.masses[k.index].X.re;
        X(n + i) = response.masses[k.index].X.im;
        b(i) = p[k.index] + (k.index == stuck.contact.b ? p[stuck.contact.a] : 0);
    }
    const Column<double> size = X.cwiseAbs();
    const Matrix<double> entries = stuck.K.cwiseAbs() + r * r * stuck.M.cwiseAbs();
    Column<double> terms(2 * n);
    terms << product(entries, Column<double>(size.head(n))), product(entries, Column<double>(size.tail(n)));
    terms += Column<double>::Constant(2 * n, damping.cwiseAbs().maxCoeff() * size.sum());
    const Matrix<double> of_damping = r * damping_errors;
    Column<double> moving = Column<double>::Zero(n + 1), of_C(2 * n); // sizes of all masses
    for (Eigen::Index i = 0; i < n; ++i)
        moving(static_cast<Eigen::Index>(stuck.masses[static_cast<std::size_t>(i)].index)) = size(i) + size(n + i);
    const auto a = static_cast<Eigen::Index>(stuck.contact.a);
    if (stuck.contact.b) moving(a) = moving(static_cast<Eigen::Index>(*stuck.contact.b));
    Column<double> forces = product(of_damping, moving);
    errors.load += forces(a);
    if (stuck.contact.b) forces(static_cast<Eigen::Index>(*stuck.contact.b)) += forces(a);
    for (Eigen::Index i = 0; i < n; ++i)
        of_C(i) = of_C(n + i) = forces(static_cast<Eigen::Index>(stuck.masses[static_cast<std::size_t>(i)].index));
    const Column<double> left_over = (b - product(A, X)).cwiseAbs() + rounding * (terms + b.cwiseAbs()) + of_C;
    const Column<double> error = 2.0 * (product_of_sizes(LinearSystem<double>(A).inverse(), left_over) + eps * size);
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto m = static_cast<std::size_t>(i);
        const double of_mass = error(i) + error(n + i);
        if (!(of_mass - of_mass == 0)) throw DomainError("the load excites a resonance of the system with the contact held");
        errors.masses.push_back(of_mass);
        errors.load += (abs(stuck.k_j[m]) + r * abs(stuck.c_j[m]) + r * r * abs(stuck.m_j[m])) *
                       (of_mass + rounding * (size(i) + size(n + i)));
    }
    return errors;
}

// The static compliance of the contact, (K^-1)_jj, with its bound: by what a solution of the equations of rest leaves over.
Bounded<double> compliance_of(const StuckConfiguration<double>& stuck) {
    const auto n = static_cast<Eigen::Index>(stuck.masses.size());
    Matrix<double> K(n + 1, n + 1);
    K.topLeftCorner(n, n) = stuck.K;
    for (Eigen::Index i = 0; i < n; ++i) K(i, n) = K(n, i) = stuck.k_j[static_cast<std::size_t>(i)];
    K(n, n) = stuck.k_jj;
    const double rounding = 8 * static_cast<int>(n + 1) * unit_of<double>();
    const Matrix<double> inverse = LinearSystem<double>(K).inverse();
    const Column<double> x = inverse.col(n), unit = Column<double>::Unit(n + 1, n);
    const Column<double> left_over = (unit - product(K, x)).cwiseAbs() + rounding * (product_of_sizes(K, x) + unit);
    return {x(n), 2 * inverse.row(n).cwiseAbs().dot(left_over)};
}

} // namespace

HeldSolution held_solution(const Scene<double>& scene, const StuckConfiguration<double>& stuck,
                           const ModalBasis<Bounded<double>>& basis, std::optional<Mass> only) {
    const System<double>& s = scene.system;
    const StuckResponse response = stuck_response(stuck, load_row(s), *scene.r);
    const Matrix<double> of_damping = errors_of_damping(scene, basis);
    const HeldErrors errors = errors_of(scene, stuck, of_damping, response);
    const std::vector<StuckMass>& masses = response.masses;
    std::vector<double> error_of(masses.size(), 0.0);
    for (std::size_t n = 0; n < stuck.masses.size(); ++n) error_of[stuck.masses[n].index] = errors.masses[n];
    if (stuck.contact.b) error_of[stuck.contact.a] = error_of[*stuck.contact.b];
    HeldSolution solution;
    double largest(0);
    for (const StuckMass& mass : masses) {
        largest = std::max(largest, mass.amplitude);
        solution.masses.push_back({exactly(mass.amplitude), std::nullopt, std::nullopt});
    }
    for (std::size_t k = 0; k < masses.size(); ++k) {
        if (k == contact_row(s).index) continue;
        const StuckMass& mass = masses[k];
        const double error = error_of[k];
        solution.masses[k].amplitude = certified(Bounded<double>(mass.amplitude, error));
        if (does_not_move(mass.amplitude, error, largest)) continue;
        const double of_phase =
            error < mass.amplitude ? largest_turn(error, mass.amplitude) + 4 * unit_of<double>() : pi<double>();
        solution.masses[k].phase = certified(Bounded<double>(mass.phase.value_or(0.0), of_phase));
        if (only && k != only->index) continue;
        const double relative = mass.amplitude > 0 ? error / mass.amplitude : 1.0;
        solution.relative = std::max({solution.relative, relative, of_phase});
    }
    if (s.contact_with) solution.masses.push_back({exactly(0), std::nullopt, std::nullopt});
    // On the boundary rounding may leave less than nothing of the interval.
    const double to = rest_interval(stuck, response, scene.mu, *scene.beta).value_or(0.0);
    const Bounded<double> compliance = compliance_of(stuck);
    const double of_compliance = abs(compliance.x * stuck.k_contact - 1) + compliance.e * stuck.k_contact;
    double error = errors.load * compliance.most() + abs(to) * (of_compliance + 4 * unit_of<double>());
    if (!(error - error == 0)) { // the stiffness is singular in this type
        error = std::numeric_limits<double>::infinity();
        solution.relative = std::max(solution.relative, 1.0);
    }
    solution.rest_interval = {certified(Bounded<double>(-to, error)), certified(Bounded<double>(to, error)), std::nullopt};
    require_in_range(to, "the interval of rest");
    solution.sticking_by_88 = limit_by_88(scene, stuck, of_damping, response);
    return solution;
}

std::optional<Certified> sticking_by_88(const Scene<double>& scene) {
    try {
        const ModalBasis<Bounded<double>> basis = with_errors(scene.system, modal_basis(scene.system));
        const StuckConfiguration<double> stuck = stuck_configuration(scene.system, values_of(basis));
        const StuckResponse response = stuck_response(stuck, load_row(scene.system), *scene.r);
        return limit_by_88(scene, stuck, errors_of_damping(scene, basis), response);
    } catch (const DomainError&) {
        return std::nullopt;
    }
}

} // namespace denhartog
