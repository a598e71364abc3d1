// The motion while the contact is held, and the friction ratio that holds it: the stuck modes under the load, each by itself or
// coupled by damping, and (88). The load on a contact at rest is that of this motion, a constant, and what is left of the start,
// which loses energy: `LastingRest::verdict` compares their sum with mu beta, and says whether the rest lasts. Read
// `stuck_response` first.
#include "denhartog/stick_slip/stuck_response.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "denhartog/formulas/stuck.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/model/natural_modes.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/number/why.hpp"
#include "denhartog/number/work_counted.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

// The modulus, even if its square is at an end of the range of a double.
double amplitude_of(const Complex<double>& X) {
    const double square = squared_modulus(X);
    return square > 0x1p-900 && square < 0x1p900 ? std::sqrt(square) : elementary::hypot(X.re, X.im);
}

double rounding(std::size_t modes) { return 4 * static_cast<int>(modes) * double_epsilon; }

// Amplitude of an uncoupled mode under the force p in phase; D is the diagonal entry of the damping, 2 zeta r_n.
Complex<double> mode_amplitude(double p, double r_n, double D, double r, double tolerance) {
    if (p == 0) return {0, 0};
    const double a = (r_n - r) * (r_n + r), b = r * D, least = tolerance * r_n * r_n;
    if (std::abs(a) <= least && std::abs(b) <= least) throw DomainError(Why::stuck_mode_resonates);
    return amplitude_of_mode(p, a, b);
}

// Amplitudes of coupled modes: the complex system as a real one of twice the size, its rows and columns scaled.
std::vector<Complex<double>> coupled_amplitudes(const StuckConfiguration& stuck, const std::vector<Complex<double>>& p,
                                                double r) {
    const auto n = static_cast<Eigen::Index>(p.size());
    Matrix<double> A = Matrix<double>::Zero(2 * n, 2 * n);
    Column scale(2 * n), force(2 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double r_n = stuck.r_n[static_cast<std::size_t>(i)];
        A(i, i) = A(n + i, n + i) = (r_n - r) * (r_n + r);
        scale(i) = scale(n + i) = 1 / sqrt(r_n * r_n + r * r);
        force(i) = p[static_cast<std::size_t>(i)].re;
        force(n + i) = p[static_cast<std::size_t>(i)].im;
    }
    A.topRightCorner(n, n) = -r * stuck.damping;
    A.bottomLeftCorner(n, n) = r * stuck.damping;
    A = scale.asDiagonal() * A * scale.asDiagonal();
    const LinearSystem system(A);
    if (!(system.reciprocal_condition() > rounding(p.size()))) throw DomainError(Why::stuck_mode_resonates);
    force = scale.cwiseProduct(system.solve(scale.cwiseProduct(force)));
    std::vector<Complex<double>> q;
    for (Eigen::Index i = 0; i < n; ++i) q.push_back({force(i), force(n + i)});
    return q;
}

std::vector<Complex<double>> mode_amplitudes(const StuckConfiguration& stuck, const std::vector<Complex<double>>& p, double r) {
    if (!stuck.modes_diagonalise_damping) return coupled_amplitudes(stuck, p, r);
    std::vector<Complex<double>> q;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto n = static_cast<Eigen::Index>(i);
        const auto to = [&](double force) {
            return mode_amplitude(force, stuck.r_n[i], stuck.damping(n, n), r, rounding(p.size()));
        };
        q.push_back(to(p[i].re));
        if (p[i].im != 0) q.back() = q.back() + times_i(to(p[i].im));
    }
    return q;
}

StuckMass motion_of(const Complex<double>& X) {
    StuckMass mass{X, amplitude_of(X), std::nullopt};
    if (mass.amplitude == 0) return mass;
    mass.phase = X.im == 0 ? (X.re < 0 ? pi<double>() : 0.0) : -argument(X);
    return mass;
}

} // namespace

StuckResponse stuck_response(const StuckConfiguration& stuck, Mass load, double r) {
    check_frequency_ratio(r);
    const std::size_t n = stuck.masses.size();
    if (load.index > n && stuck.load.empty())
        throw InputError("load", "must be one of the masses", std::to_string(load.index + 1));
    StuckResponse response{r, Mass{stuck.contact.a}, load, {}, {}, {}};
    std::vector<Complex<double>> X(n + 1, Complex<double>{0, 0}); // of all masses
    const std::vector<Complex<double>> p = load_on_stuck_modes(stuck, load);
    if (std::ranges::any_of(p, [](const Complex<double>& force) { return force.re != 0 || force.im != 0; })) {
        const std::vector<Complex<double>> q = mode_amplitudes(stuck, p, r);
        for (std::size_t k = 0; k <= n; ++k)
            for (std::size_t i = 0; i < n; ++i)
                X[k] = X[k] + stuck.shapes(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) * q[i];
    }
    std::vector<Complex<double>> others;
    for (const Mass& k : stuck.masses) others.push_back(X[k.index]);
    HeldRow<double> row{stuck.k_j, stuck.c_j, stuck.m_j, direct_load(stuck, load)};
    response.contact_load = row.load(r, others);
    row.c.assign(n, 0);
    response.elastic_load = row.load(r, others);
    for (const Complex<double>& X_k : X) response.masses.push_back(motion_of(X_k));
    for (const StuckMass& mass : response.masses)
        if (!std::isfinite(mass.amplitude)) throw PrecisionError(Why::stuck_response_out_of_range, Outcome::out_of_range);
    return response;
}

std::optional<StuckChain> stuck_chain(const System<double>& s, const StuckConfiguration& stuck) {
    const Mass load = load_row(s);
    if (!is_chain(s) || contact_moves_apart(s) || load.index >= number_of_masses(s)) return std::nullopt;
    StuckChain chain;
    if (load == s.contact) return chain;
    const auto j = static_cast<std::ptrdiff_t>(s.contact.index);
    const bool before = load.index < s.contact.index;
    const auto N = static_cast<std::ptrdiff_t>(s.mass_ratios.size());
    const std::ptrdiff_t first = before ? 0 : j + 1, last = before ? j : N; // masses; in the stuck configuration one less after j
    const auto gamma = s.mass_ratios.begin(), kappa = s.stiffness_ratios.begin();
    if (last - first > 1) ++work_counted.eigen_solves;
    NaturalModes modes = chain_modes(std::vector<double>(gamma + first, gamma + last),
                                     std::vector<double>(kappa + first, before ? kappa + last + 1 : kappa + last));
    const Matrix<double> C = stuck.C.block(before ? 0 : j, before ? 0 : j, last - first, last - first);
    for (std::ptrdiff_t k = first; k < last; ++k) chain.masses.push_back(Mass{static_cast<std::size_t>(k)});
    for (std::size_t i = 0; i < modes.r_n.size(); ++i) {
        const auto phi_i = modes.phi.col(static_cast<Eigen::Index>(i));
        chain.zeta.push_back(phi_i.dot(C * phi_i) / (2 * modes.r_n[i]));
    }
    chain.r_n = std::move(modes.r_n);
    chain.phi = std::move(modes.phi);
    chain.kappa = before ? s.stiffness_ratios[s.contact.index] : s.stiffness_ratios[s.contact.index + 1];
    return chain;
}

StickingBoundary sticking_boundary(const StuckResponse& response, const std::optional<StuckChain>& chain, double mu) {
    check_static_friction(mu);
    StickingBoundary b{paper::sticking_limit(response.contact_load, mu), paper::sticking_limit(response.elastic_load, mu), {}};
    if (chain && !chain->kappa) b.paper = paper::sticking_limit_under_load(mu);
    if (!chain || !chain->kappa) return b;
    const auto load = static_cast<Eigen::Index>(response.load.index - chain->masses.front().index);
    const Eigen::Index neighbour = response.load.index < response.contact.index ? chain->phi.rows() - 1 : 0;
    Complex<double> X{0, 0}; // of the mass next to the contact
    for (Eigen::Index n = 0; n < chain->phi.cols(); ++n) {
        const double r_n = chain->r_n[static_cast<std::size_t>(n)], D = 2 * chain->zeta[static_cast<std::size_t>(n)] * r_n;
        X = X + chain->phi(neighbour, n) * mode_amplitude(chain->phi(load, n), r_n, D, response.r, rounding(chain->r_n.size()));
    }
    b.paper = paper::sticking_limit_by_spring(*chain->kappa, amplitude_of(X), mu);
    return b;
}

LastingRest::LastingRest(const ContactSystem& system, const Excitation& excitation)
    : system_(&system), e_(excitation), terms_(modulus(direct_load(system.stuck, system.load))) {
    const StuckConfiguration& s = system.stuck;
    Tried<StuckResponse> found = tried([&] { return stuck_response(s, system.load, e_.r); });
    if (found.outcome != Outcome::at_a_pole) response_ = std::move(found.required());
    const std::size_t n = s.masses.size();
    for (std::size_t a = 0; a < n && response_; ++a)
        terms_ += (std::abs(s.k_j[a]) + e_.r * std::abs(s.c_j[a]) + e_.r * e_.r * std::abs(s.m_j[a])) *
                  response_->masses[s.masses[a].index].amplitude;
    follows_ = s.carried;
    double stiffness = 0, fastest = 0;
    const Column k = s.phi.transpose() * column(s.k_j), c = s.phi.transpose() * column(s.c_j),
                 m = s.phi.transpose() * column(s.m_j);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t a = 0; a <= n; ++a) follows_[a] -= s.shapes(a, i) * k(i) / (s.r_n[i] * s.r_n[i]);
        stiffness += k(i) * k(i) / (s.r_n[i] * s.r_n[i]);
        fastest = std::max(fastest, s.r_n[i] + s.damping.row(i).cwiseAbs().sum());
    }
    // In units of r times the energy norm, that is, of displacements times natural frequency ratios.
    weight_ = sqrt(stiffness) + c.norm() + fastest * m.norm();
}

State LastingRest::steady_state(double x_j) const {
    State z = at_rest(follows_.size());
    for (std::size_t k = 0; k < follows_.size(); ++k) {
        z.x[k] = follows_[k] * x_j + response_->masses[k].X.re;
        z.x_prime[k] = -response_->masses[k].X.im;
    }
    if (const Contact& contact = system_->stuck.contact; !contact.others.empty())
        contact.hold(z.x_prime.data()); // to the last bit: it rests
    return z;
}

double LastingRest::reach() const {
    if (!response_) return -1;
    const StuckConfiguration& s = system_->stuck;
    const double holds = e_.mu * e_.beta;
    const double rounding =
        64 * static_cast<int>(s.masses.size() + 1) * double_epsilon * (holds + terms_) * std::max(1.0, s.k_jj / s.k_contact);
    return (holds - modulus(response_->contact_load) - rounding) / s.k_contact;
}

MassMotion LastingRest::motion(std::size_t k, double x_j) const {
    if (k == system_->contact.index) return {std::abs(x_j), x_j < 0 ? pi<double>() : 0.0};
    const double offset = follows_[k] * x_j;
    const StuckMass& mass = response_->masses[k];
    // Below zero the extremum comes half a period later, and half a period more is what a negative one adds to its phase.
    return {std::abs(offset) + mass.amplitude, mass.phase.value_or(offset < 0 ? pi<double>() : 0.0)};
}

LastingRest::Verdict LastingRest::verdict(const State& z) const {
    if (!response_) return Verdict::open;
    const StuckConfiguration& s = system_->stuck;
    const double x_j = s.contact.of(z.x), holds = e_.mu * e_.beta, constant = std::abs(s.k_contact * x_j);
    const double margin = holds - modulus(response_->contact_load) - constant;
    const double rounding =
        16 * static_cast<int>(s.masses.size() + 1) * double_epsilon * (holds + terms_ + constant + std::abs(s.k_jj * x_j));
    if (margin < -rounding) return Verdict::open;
    const State steady = steady_state(x_j);
    const Column q = s.momentum * (column(z.x) - column(steady.x)), p = s.momentum * (column(z.x_prime) - column(steady.x_prime));
    double energy = 0;
    for (std::size_t i = 0; i < s.masses.size(); ++i) energy += s.r_n[i] * s.r_n[i] * q(i) * q(i) + e_.r * e_.r * p(i) * p(i);
    const double free = weight_ * sqrt(energy);
    if (free < margin) return Verdict::lasts;
    return margin <= rounding && free <= rounding ? Verdict::on_boundary : Verdict::open;
}

} // namespace denhartog
