// What do the masses do while the contact is held, and where may it rest? Read `held_response` first: Section 4.3 for any
// contact. After it come (88) as printed, and what errors of the modes make of the damping matrix, which is an error of both.
#include "denhartog/answer/models_in_double.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "denhartog/answer/certify.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

using std::abs;

// What mass a goes with another one, as it is held; 1 and -1 are exact.
Bounded<double> share_of(const BesideContact& other) {
    return abs(other.share) == 1 ? Bounded<double>(other.share) : as_input(other.share);
}

// Forces with their errors, and bounds of the damping's, in the coordinates of a held contact.
void take_into_held(const Contact& contact, std::vector<Complex<double>>& p, std::vector<double>& error_of_p,
                    Matrix<double>& error_of_C) {
    const auto a = static_cast<Eigen::Index>(contact.a);
    for (const BesideContact& other : contact.others) {
        const auto k = static_cast<Eigen::Index>(other.k);
        const double share = other.share, size = abs(share);
        const Complex<double> passed = share * p[contact.a];
        if (size != 1) error_of_p.resize(p.size());
        if (!error_of_p.empty())
            error_of_p[other.k] +=
                size * error_of_p[contact.a] + (size == 1 ? 0 : 2 * unit_of<double>() * (abs(passed.re) + abs(passed.im)));
        p[other.k] = p[other.k] + passed;
        error_of_C.col(k) += size * error_of_C.col(a);
        error_of_C.row(k) += size * error_of_C.row(a);
    }
}

// The response with the contact held at zero.
struct HeldResponse {
    std::vector<Complex<Bounded<double>>> X; // of all masses
    Bounded<double> load;                    // on the contact, in size
};

HeldResponse held_response(const Scene<double>& scene, const StuckConfiguration& stuck, Matrix<double> error_of_C) {
    const std::size_t N = stuck.masses.size() + 1, a = stuck.contact.a;
    std::vector<Complex<double>> p = complex_load(scene.system);
    std::vector<double> error_of_p = error_of_load(scene.system);
    const double error_of_direct = error_of_p.empty() ? 0 : abs(stuck.contact.over(error_of_p[a]));
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
    HeldResponse held{{N, {Bounded<double>(0), Bounded<double>(0)}}, {}};
    std::vector<Bounded<double>> C_j, K_j;
    for (std::size_t i = 0; i + 1 < N; ++i) {
        const Complex<Bounded<double>>& X = held.X[stuck.masses[i].index] = moving[i];
        if (!std::isfinite(X.re.e + X.im.e)) throw DomainError(Why::held_system_resonates);
        const double c = stuck.c_j[i], error_of_c = abs(stuck.contact.over(error_of_C(static_cast<Eigen::Index>(a), others[i])));
        C_j.push_back(r * Bounded<double>(c, error_of_c + unit_of<double>() * abs(c)));
        K_j.push_back(as_input(stuck.k_j[i]) - r * r * as_input(stuck.m_j[i]));
    }
    std::optional<Bounded<double>> re, im; // of mass a
    for (const BesideContact& other : stuck.contact.others) {
        add_times(re, share_of(other), held.X[other.k].re);
        add_times(im, share_of(other), held.X[other.k].im);
    }
    if (re) held.X[a] = {*re, *im};
    const Complex<double> direct = direct_load(stuck, scene.system.load);
    const bool as_given = abs(stuck.contact.w_a) == 1;
    const auto bounded = [error_of_direct, as_given](double part) {
        return part == 1 && as_given ? Bounded<double>(1) : Bounded<double>(part, as_input(part).e + error_of_direct);
    };
    held.load = modulus(paper::load_on_held_contact<Bounded<double>>(C_j, K_j, moving, {bounded(direct.re), bounded(direct.im)}));
    return held;
}

// The static compliance of the contact, (K^-1)_jj.
Bounded<double> compliance_of(const StuckConfiguration& stuck) {
    const auto n = static_cast<Eigen::Index>(stuck.masses.size());
    Matrix<double> K(n + 1, n + 1);
    K.topLeftCorner(n, n) = stuck.K;
    for (Eigen::Index i = 0; i < n; ++i) K(i, n) = K(n, i) = stuck.k_j[static_cast<std::size_t>(i)];
    K(n, n) = stuck.k_jj;
    const Bounded<double> found = BoundedSystem(K, Matrix<double>::Zero(n + 1, n + 1)).solved(Column::Unit(n + 1, n)).back();
    const double by_modes = 1 / stuck.k_contact; // a number also where K is singular in double
    return {by_modes, found.e + abs(found.x - by_modes)};
}

// A number that is written as a double has to be one.
void require_in_range(double number, int what) {
    if (!std::isfinite(number)) throw PrecisionError({Why::out_of_double, what}, Outcome::out_of_range);
}

// (88) as printed: modes of the masses on the load's side of the contact, damping read from the diagonal.
std::optional<Certified> limit_by_88(const Scene<double>& scene, const StuckConfiguration& stuck,
                                     const Matrix<double>& error_of_C) {
    const System<double>& s = scene.system;
    const Bounded<double> mu = as_input(scene.mu), r = as_input(*scene.r);
    const std::optional<StuckChain> chain = stuck_chain(s, stuck);
    if (!chain) return std::nullopt;
    if (!chain->kappa) return certified(paper::sticking_limit_under_load(mu));
    const auto n = static_cast<Eigen::Index>(chain->masses.size()),
               first = static_cast<Eigen::Index>(chain->masses.front().index);
    const Mass loaded = load_row(s);
    const bool before = loaded.index < s.contact.index;
    const Eigen::Index first_held = before ? first : first - 1, load = static_cast<Eigen::Index>(loaded.index) - first;
    System<double> moving; // as much of it as the bounds need
    moving.mass_ratios.assign(s.mass_ratios.begin() + first, s.mass_ratios.begin() + first + n);
    moving.stiffness_ratios.assign(s.stiffness_ratios.begin() + first, s.stiffness_ratios.begin() + first + n);
    moving.damping_matrix = stuck.C.block(first_held, first_held, n, n);
    const Matrix<double> left_out = error_of_C.block(first, first, n, n);
    const ModalBasis<Bounded<double>> modes =
        with_errors(moving, ModalBasis<double>{chain->r_n, chain->phi, chain->zeta, {}, 0.0});
    Complex<Bounded<double>> X{Bounded<double>(0), Bounded<double>(0)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const Bounded<double>& r_n = modes.r_n[static_cast<std::size_t>(i)];
        const Column size = chain->phi.col(i).cwiseAbs();
        Bounded<double> D = Bounded<double>(2) * modes.zeta[static_cast<std::size_t>(i)] * r_n;
        D.e += 2.0 * size.dot(product(left_out, size));
        const Bounded<double> a((r_n - r) * (r_n + r)), b(r * D);
        if (abs(a.x) <= a.e && abs(b.x) <= b.e) return std::nullopt; // a resonance
        X = X + modes.phi(before ? n - 1 : 0, i) * amplitude_of_mode(modes.phi(load, i), a, b);
    }
    const Bounded<double> limit = paper::sticking_limit_by_spring(as_input(*chain->kappa), modulus(X), mu);
    require_in_range(limit.x, 1);
    return certified(limit);
}

// Bounds of what errors of the modes make of the damping matrix (19): those of frequencies, of ratios and of the modes' sizes,
// and modes that rounding turns towards each other, which have different damping. A mode far from all others is turned as well.
Matrix<double> errors_of_C(const Scene<double>& scene, const ModalBasis<Bounded<double>>& basis) {
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
            const double rounding_of_both = unit * (rates[a].x + rates[b].x);
            in_modes(i, k) += rounding_of_both;
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

// A mass of a complex amplitude; `largest` is that of all masses.
SolvedMass mass_of(const Complex<Bounded<double>>& X, double largest) {
    SolvedMass mass{exactly(0), std::nullopt, std::nullopt};
    const double amplitude = elementary::hypot(X.re.x, X.im.x), error = X.re.e + X.im.e + 2 * unit_of<double>() * amplitude;
    if (does_not_move(amplitude, error, largest)) {
        mass.amplitude.error = amplitude + error;
        return mass;
    }
    const double error_of_phase = error < amplitude ? largest_turn(error, amplitude) + 4 * unit_of<double>() : pi<double>();
    mass.amplitude = certified({amplitude, error});
    mass.phase = certified({-elementary::atan2(X.im.x, X.re.x), error_of_phase});
    return mass;
}

} // namespace

HeldSolution held_solution(const Scene<double>& scene, const StuckConfiguration& stuck, const ModalBasis<Bounded<double>>& basis,
                           std::optional<Mass> only) {
    const System<double>& s = scene.system;
    const Matrix<double> error_of_C = errors_of_C(scene, basis);
    const HeldResponse held = held_response(scene, stuck, error_of_C);
    const Bounded<double> compliance = compliance_of(stuck);
    HeldSolution solution;
    double largest = held.load.x * compliance.x; // no mass moves where the load acts on the contact
    for (const Complex<Bounded<double>>& X : held.X) largest = std::max(largest, modulus(X).x);
    for (std::size_t k = 0; k < held.X.size(); ++k) {
        const bool rests = k == contact_row(s).index;
        solution.masses.push_back(rests ? SolvedMass{exactly(0), std::nullopt, std::nullopt} : mass_of(held.X[k], largest));
        const auto& [amplitude, phase, none] = solution.masses.back();
        if (!phase || (only && k != only->index)) continue;
        solution.relative =
            std::max({solution.relative, amplitude.value > 0 ? amplitude.error / amplitude.value : 1.0, phase->error});
    }
    const Bounded<double> frame = amplitude_of_frame(scene);
    for (const Complex<Bounded<double>>& X : held.X)
        if (s.base_motion != BaseMotion::none)
            solution.from_ground.push_back(from_ground(mass_of({X.re + frame, X.im}, std::max(largest, frame.x)),
                                                       s.base_motion == BaseMotion::alone ? Bounded<double>(1) : frame));
    if (contact_moves_apart(s)) solution.masses.push_back({exactly(0), std::nullopt, std::nullopt});
    Bounded<double> to = (as_input(scene.mu) * as_input(*scene.beta) - held.load) * compliance;
    if (!std::isfinite(to.e)) {
        to.e = std::numeric_limits<double>::infinity();
        solution.relative = std::max(solution.relative, 1.0);
    }
    to.x = std::max(to.x, 0.0); // on the boundary rounding may leave less than nothing
    require_in_range(to.x, 2);
    solution.rest_interval = {certified(-to), certified(to), std::nullopt};
    solution.sticking_by_88 = limit_by_88(scene, stuck, error_of_C);
    return solution;
}

std::optional<Certified> sticking_by_88(const Scene<double>& scene) {
    const ModalBasis<Bounded<double>> basis = with_errors(scene.system, modal_basis(scene.system));
    return limit_by_88(scene, stuck_configuration(scene.system, values_of(basis)), errors_of_C(scene, basis));
}

} // namespace denhartog
