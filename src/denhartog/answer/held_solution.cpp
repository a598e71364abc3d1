#include "denhartog/answer/held_solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "denhartog/answer/certify.hpp"
#include "denhartog/formulas/stuck.hpp"
#include "denhartog/model/coordinates.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/stick_slip/stuck_response.hpp"
#include "denhartog/sums/bounded_modes.hpp"

namespace denhartog {
namespace {

using std::abs;

// A number that is written as a double has to be one.
template <class T>
void require_in_range(const T& number, const char* name) {
    if (!std::isfinite(static_cast<double>(number)))
        throw PrecisionError(std::string(name) + " is beyond the range of a double; 16 digits and more are written as text");
}

// Bounds of the errors of the complex amplitudes, and of the load that they bring to the contact. The equations of motion with
// the contact held are taken as real ones of twice the size.
template <class T>
struct HeldErrors {
    std::vector<T> masses; // of those that move, in the order of the stuck configuration
    T load;
};

// Bounds of what errors of the modes make of the damping matrix (19): those of frequencies, of ratios and of the modes' sizes, and
// modes that rounding turns towards each other, which have different damping. A mode far from all others is turned as well.
template <class T>
Matrix<T> errors_of_damping(const Scene<T>& scene, const ModalBasis<Bounded<T>>& basis) {
    const System<T>& s = scene.system;
    const auto N = static_cast<Eigen::Index>(basis.r_n.size());
    if (damping_matrix_counts(s, basis)) return Matrix<T>::Zero(N, N);
    const Matrix<T> phi = basis.phi.topRows(N).unaryExpr([](const Bounded<T>& entry) { return T(abs(entry.x)); });
    const T unit = 2 * basis.r_n.back().e / basis.r_n.back().x; // what the solver is trusted with
    std::vector<Bounded<T>> rates;                              // of decay, (18)
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) rates.push_back(T(2) * basis.zeta[i] * basis.r_n[i]);
    Matrix<T> in_modes = Matrix<T>::Zero(N, N);
    for (Eigen::Index i = 0; i < N; ++i)
        for (Eigen::Index k = 0; k < N; ++k) {
            const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(k);
            const T of_both = unit * (rates[a].x + rates[b].x);
            in_modes(i, k) += of_both;
            if (k == i) {
                in_modes(i, i) += rates[a].e;
                continue;
            }
            const T angle = angle_of_turn(basis.r_n[a], basis.r_n[b]), apart = abs(T(rates[a].x - rates[b].x));
            in_modes(i, k) += angle * apart;
            in_modes(i, i) += angle * angle * apart; // a mode turned by a right angle has the other's damping
        }
    Matrix<T> momentum = s.mass_matrix.size() > 0 ? product(Matrix<T>(s.mass_matrix.cwiseAbs()), phi) : phi;
    if (s.mass_matrix.size() == 0)
        for (Eigen::Index k = 0; k < N; ++k) momentum.row(k) *= s.mass_ratios[static_cast<std::size_t>(k)];
    return in_coordinates(Matrix<T>(momentum.transpose()), in_modes);
}

// (88) as printed on numbers that carry their bounds: modes of the masses on the load's side of the contact, damping read from the
// diagonal.
template <class T>
Bounded<T> bounded_limit_by_88(const Scene<T>& scene, const StuckConfiguration<T>& stuck, const Matrix<T>& of_damping,
                               const StuckChain<T>& chain, const StuckResponse<T>& response) {
    const Bounded<T> mu = as_input(scene.mu), r = as_input(*scene.r);
    if (!chain.kappa) return paper::sticking_limit_under_load(mu);
    const auto n = static_cast<Eigen::Index>(chain.masses.size());
    const auto first = static_cast<Eigen::Index>(chain.masses.front().index);
    const Eigen::Index of_stuck = chain.masses.front().index > scene.system.contact.index ? first - 1 : first;
    System<T> moving; // as much of it as the bounds need
    moving.mass_ratios.assign(scene.system.mass_ratios.begin() + first, scene.system.mass_ratios.begin() + first + n);
    moving.stiffness_ratios.assign(scene.system.stiffness_ratios.begin() + first,
                                   scene.system.stiffness_ratios.begin() + first + n);
    moving.damping_matrix = stuck.C.block(of_stuck, of_stuck, n, n);
    const Matrix<T> left_out = of_damping.block(first, first, n, n);
    const ModalBasis<Bounded<T>> modes = with_errors(moving, ModalBasis<T>{chain.r_n, chain.phi, chain.zeta, {}, T(0)});
    const auto [neighbour, load] = rows_of_neighbour_and_load(chain, response);
    Complex<Bounded<T>> X{Bounded<T>(0), Bounded<T>(0)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const Bounded<T>& r_n = modes.r_n[static_cast<std::size_t>(i)];
        const Column<T> size = chain.phi.col(i).cwiseAbs();
        Bounded<T> D = Bounded<T>(2) * modes.zeta[static_cast<std::size_t>(i)] * r_n;
        D.e += T(2) * size.dot(product(left_out, size));
        X = X +
            modes.phi(neighbour, i) * amplitude_of_mode(modes.phi(load, i), Bounded<T>((r_n - r) * (r_n + r)), Bounded<T>(r * D));
    }
    return paper::sticking_limit_by_spring(as_input(*chain.kappa), modulus(X), mu);
}

template <class T>
std::optional<Certified> limit_by_88(const Scene<T>& scene, const StuckConfiguration<T>& stuck, const Matrix<T>& of_damping,
                                     const StuckResponse<T>& response) {
    const std::optional<StuckChain<T>> chain = stuck_chain(scene.system, stuck);
    const std::optional<T> paper = sticking_boundary(response, chain, scene.mu).paper;
    if (!paper) return std::nullopt;
    require_in_range(*paper, "permanent sticking by (88)");
    const Bounded<T> bounded = bounded_limit_by_88(scene, stuck, of_damping, *chain, response);
    return certified(Bounded<T>(*paper, T(bounded.e + abs(T(bounded.x - *paper)))));
}

template <class T>
HeldErrors<T> errors_of(const Scene<T>& scene, const StuckConfiguration<T>& stuck, const Matrix<T>& damping_errors,
                        const StuckResponse<T>& response) {
    const auto n = static_cast<Eigen::Index>(stuck.masses.size());
    const T r = *scene.r, eps = unit_of<T>(), rounding = 8 * static_cast<int>(n + 1) * eps;
    const std::vector<T> p = load_on_coordinates(scene.system);
    HeldErrors<T> errors{{}, T(eps * std::max(T(1), T(abs(p[scene.system.contact.index]))) + rounding * scene.mu * *scene.beta)};
    if (n == 0) return errors;
    const Matrix<T> stiffness = stuck.K - r * r * stuck.M, damping = r * stuck.C;
    Matrix<T> A(2 * n, 2 * n);
    A << stiffness, -damping, damping, stiffness;
    Column<T> X(2 * n), b = Column<T>::Zero(2 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Mass k = stuck.masses[static_cast<std::size_t>(i)];
        X(i) = response.masses[k.index].X.re;
        X(n + i) = response.masses[k.index].X.im;
        b(i) = p[k.index];
    }
    const Column<T> size = X.cwiseAbs();
    const Matrix<T> entries = stuck.K.cwiseAbs() + r * r * stuck.M.cwiseAbs();
    Column<T> terms(2 * n);
    terms << product(entries, Column<T>(size.head(n))), product(entries, Column<T>(size.tail(n)));
    terms += Column<T>::Constant(2 * n, T(damping.cwiseAbs().maxCoeff() * size.sum()));
    const Matrix<T> of_damping = r * damping_errors;
    Column<T> moving = Column<T>::Zero(n + 1), of_C(2 * n); // sizes of all masses, the contact's among them
    for (Eigen::Index i = 0; i < n; ++i)
        moving(static_cast<Eigen::Index>(stuck.masses[static_cast<std::size_t>(i)].index)) = size(i) + size(n + i);
    const Column<T> forces = product(of_damping, moving);
    for (Eigen::Index i = 0; i < n; ++i)
        of_C(i) = of_C(n + i) = forces(static_cast<Eigen::Index>(stuck.masses[static_cast<std::size_t>(i)].index));
    errors.load += forces(static_cast<Eigen::Index>(scene.system.contact.index));
    const Column<T> left_over = (b - product(A, X)).cwiseAbs() + rounding * (terms + b.cwiseAbs()) + of_C;
    const Column<T> error = T(2) * (product_of_sizes(LinearSystem<T>(A).inverse(), left_over) + eps * size);
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto m = static_cast<std::size_t>(i);
        const T of_mass = error(i) + error(n + i);
        if (!(of_mass - of_mass == 0)) throw DomainError("the load excites a resonance of the system with the contact held");
        errors.masses.push_back(of_mass);
        errors.load += (abs(stuck.k_j[m]) + r * abs(stuck.c_j[m]) + r * r * abs(stuck.m_j[m])) *
                       (of_mass + rounding * (size(i) + size(n + i)));
    }
    return errors;
}

// The masses that are no coordinates, with bounds of their errors.
template <class T>
void add_displacements(const Coordinates<T>& c, std::vector<StuckMass<T>>& masses, std::vector<T>& error_of) {
    const std::size_t N = masses.size();
    for (Eigen::Index n = 0; n < c.displacements.rows(); ++n) {
        Complex<T> X{T(0), T(0)};
        T error(0);
        for (std::size_t k = 0; k < N; ++k) {
            const T& part = c.displacements(n, static_cast<Eigen::Index>(k));
            X = X + part * masses[k].X;
            error += abs(part) * (error_of[k] + 4 * static_cast<int>(N) * unit_of<T>() * masses[k].amplitude);
        }
        masses.push_back(motion_of(X));
        error_of.push_back(error);
    }
}

// The static compliance of the contact, (K^-1)_jj, with its bound: by what a solution of the equations of rest leaves over.
template <class T>
Bounded<T> compliance_of(const StuckConfiguration<T>& stuck) {
    const auto n = static_cast<Eigen::Index>(stuck.masses.size());
    Matrix<T> K(n + 1, n + 1);
    K.topLeftCorner(n, n) = stuck.K;
    for (Eigen::Index i = 0; i < n; ++i) K(i, n) = K(n, i) = stuck.k_j[static_cast<std::size_t>(i)];
    K(n, n) = stuck.k_jj;
    const T rounding = 8 * static_cast<int>(n + 1) * unit_of<T>();
    const Matrix<T> inverse = LinearSystem<T>(K).inverse();
    const Column<T> x = inverse.col(n), unit = Column<T>::Unit(n + 1, n);
    const Column<T> left_over = (unit - product(K, x)).cwiseAbs() + rounding * (product_of_sizes(K, x) + unit);
    return {x(n), T(2 * inverse.row(n).cwiseAbs().dot(left_over))};
}

} // namespace

template <class T>
HeldSolution held_solution(const Scene<T>& scene, const StuckConfiguration<T>& stuck, const ModalBasis<Bounded<T>>& basis,
                           std::optional<Mass> only) {
    const System<T>& s = scene.system;
    const StuckResponse<T> response = stuck_response(stuck, s.contact, s.load, *scene.r);
    const Matrix<T> of_damping = errors_of_damping(scene, basis);
    const HeldErrors<T> errors = errors_of(scene, stuck, of_damping, response);
    std::vector<StuckMass<T>> masses = response.masses;
    std::vector<T> error_of(masses.size(), T(0));
    for (std::size_t n = 0; n < stuck.masses.size(); ++n) error_of[stuck.masses[n].index] = errors.masses[n];
    add_displacements(s.coordinates, masses, error_of);
    HeldSolution solution;
    T largest(0);
    for (const StuckMass<T>& mass : masses) {
        largest = std::max(largest, mass.amplitude);
        solution.masses.push_back({exactly(mass.amplitude), std::nullopt, std::nullopt});
    }
    for (std::size_t k = 0; k < masses.size(); ++k) {
        if (Mass{k} == s.contact) continue;
        const StuckMass<T>& mass = masses[k];
        const T& error = error_of[k];
        solution.masses[k].amplitude = certified(Bounded<T>(mass.amplitude, error));
        if (does_not_move(mass.amplitude, error, largest)) continue;
        const T of_phase = error < mass.amplitude ? T(largest_turn(error, mass.amplitude) + 4 * unit_of<T>()) : pi<T>();
        solution.masses[k].phase = certified(Bounded<T>(mass.phase.value_or(T(0)), of_phase));
        if (only && k != only->index) continue;
        const T relative = mass.amplitude > 0 ? T(error / mass.amplitude) : T(1);
        solution.relative = std::max({solution.relative, static_cast<double>(relative), static_cast<double>(of_phase)});
    }
    // On the boundary rounding may leave less than nothing of the interval.
    const T to = rest_interval(stuck, response, scene.mu, *scene.beta).value_or(T(0));
    const Bounded<T> compliance = compliance_of(stuck);
    const T of_compliance = T(abs(T(compliance.x * stuck.k_contact - 1))) + compliance.e * stuck.k_contact;
    T error = errors.load * compliance.most() + abs(to) * (of_compliance + 4 * unit_of<T>());
    if (!(error - error == 0)) { // the stiffness is singular in this type
        error = std::numeric_limits<T>::infinity();
        solution.relative = std::max(solution.relative, 1.0);
    }
    solution.rest_interval = {certified(Bounded<T>(T(-to), error)), certified(Bounded<T>(to, error)), std::nullopt};
    require_in_range(to, "the interval of rest");
    solution.sticking_by_88 = limit_by_88(scene, stuck, of_damping, response);
    return solution;
}

template <class T>
std::optional<Certified> sticking_by_88(const Scene<T>& scene) {
    try {
        const ModalBasis<Bounded<T>> basis = with_errors(scene.system, modal_basis(scene.system));
        const StuckConfiguration<T> stuck = stuck_configuration(scene.system, values_of(basis));
        const StuckResponse<T> response = stuck_response(stuck, scene.system.contact, scene.system.load, *scene.r);
        return limit_by_88(scene, stuck, errors_of_damping(scene, basis), response);
    } catch (const DomainError&) {
        return std::nullopt;
    }
}

template HeldSolution held_solution(const Scene<double>&, const StuckConfiguration<double>&, const ModalBasis<Bounded<double>>&,
                                    std::optional<Mass>);
template std::optional<Certified> sticking_by_88(const Scene<double>&);

} // namespace denhartog
