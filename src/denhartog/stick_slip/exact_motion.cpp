// How does the motion go on from a start, phase by phase? Read `ContactPhases::run` first: it follows (6) with (2) and (3) from event
// to event. `Deviations::carry` takes small deviations of the state through a phase and over the event at its end;
// `contact_system` prepares a system.
#include "denhartog/stick_slip/exact_motion.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/stick_slip/contact_phases.hpp"
#include "denhartog/sums/bounded_modes.hpp"
#include "denhartog/sums/coupled_friction.hpp"

namespace denhartog {
namespace {

constexpr int most_phases_without_length = 60;
constexpr int most_phases_a_period = 20000;

// The acceleration before the event exceeds that after it by jump times w; the event comes d_tau later.
void shift(const Column& w, double jump, const Matrix<double>& d_tau, Matrix<double>& dv) {
    if (jump != 0) dv += jump * w * d_tau;
}

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

void ContactPhases::run(double tau_0, double tau_1, bool with_jacobian) {
    motion.status = MotionStatus::complete;
    motion.phases.clear();
    motion.states.clear();
    touching = 0;
    double tau = tau_0;
    auto [direction, order] = first_direction(tau);
    if (with_jacobian) deviations.start(*this, direction);
    int without_length = 0;
    const double periods = (tau_1 - tau_0) / (2 * pi<double>());
    if (effort == &own) own = {static_cast<long>(static_cast<double>(default_effort(N)) * std::min(1e6, 1 + periods))};
    const long cost_of_phase = static_cast<long>(1 + N * N / 50); // of states taken into modes and back
    const double most = most_phases_a_period * (1 + periods);
    while (tau < tau_1) {
        start_phase(direction, tau);
        motion.states.insert(motion.states.end(), x.begin(), x.end());
        motion.states.insert(motion.states.end(), v.begin(), v.end());
        const double length = tau_1 - tau;
        effort->spend(cost_of_phase);
        const Event event = direction != 0             ? end_of_sliding(direction, length, order)
                            : N == 1 && direct.im == 0 ? end_of_sticking_alone(tau, length)
                                                       : end_of_sticking(length);
        if (event.open) {
            motion.status = MotionStatus::open;
            break;
        }
        const double end = event.found ? tau + event.t : tau_1;
        motion.phases.push_back({direction, tau, end});
        work_counted.phases_propagated.fetch_add(1, std::memory_order_relaxed);
        motion_of(direction).differentiate_at(event.t);
        if (with_jacobian) deviations.carry(*this, direction, event);
        masses_of(direction, 0, x);
        masses_of(direction, 1, v);
        if (event.found) system->stuck.contact.hold(v.data());
        without_length = end > tau ? 0 : without_length + 1;
        if (without_length > most_phases_without_length || static_cast<double>(motion.phases.size()) > most) {
            motion.status = MotionStatus::chattering;
            break;
        }
        tau = end;
        direction = event.next;
        order = event.order;
    }
    motion.touching = touching;
    motion.end.x = x;
    motion.end.x_prime = v;
    if (!with_jacobian || motion.status != MotionStatus::complete) return;
    motion.jacobian.resize(2 * N, 2 * N);
    motion.jacobian.topRows(N) = deviations.dx;
    motion.jacobian.bottomRows(N) = deviations.dv;
}

void ContactPhases::stand_at(std::size_t phase) {
    const auto state = motion.states.begin() + static_cast<std::ptrdiff_t>(2 * N * phase);
    x.assign(state, state + static_cast<std::ptrdiff_t>(N));
    v.assign(state + static_cast<std::ptrdiff_t>(N), state + static_cast<std::ptrdiff_t>(2 * N));
    start_phase(motion.phases[phase].direction, motion.phases[phase].start);
}

ExactSolver::ExactSolver(const ContactSystem& system, const Excitation& excitation)
    : work_(std::make_unique<ContactPhases>(system, excitation)) {}

ExactSolver::~ExactSolver() = default;

void ExactSolver::set(const Excitation& excitation) { work_->set(excitation); }

Effort* ExactSolver::allow(Effort* effort) { return std::exchange(work_->effort, effort != nullptr ? effort : &work_->own); }

Effort& ExactSolver::effort() const { return *work_->effort; }

const ContactSystem& ExactSolver::system() const { return *work_->system; }

const Excitation& ExactSolver::excitation() const { return work_->e; }

const ExactMotion& ExactSolver::run(const State& start, double tau_0, double tau_1, bool with_jacobian) {
    ContactPhases& work = *work_;
    if (start.x.size() != work.N || start.x_prime.size() != work.N)
        throw InputError("start", "must have a displacement and a velocity for each mass", std::to_string(start.x.size()));
    work.x.assign(start.x.begin(), start.x.end());
    work.v.assign(start.x_prime.begin(), start.x_prime.end());
    try {
        work.run(tau_0, tau_1, with_jacobian);
    } catch (const PrecisionError&) {
        if (!work.effort->exhausted()) throw; // an exponential of coupled modes had nothing left to spend
        work.motion.status = MotionStatus::open;
    }
    return work.motion;
}

State ExactSolver::state_at(std::size_t phase, double tau) {
    ContactPhases& work = *work_;
    const Phase& p = work.motion.phases[phase];
    work.stand_at(phase);
    work.motion_of(p.direction).move_to(tau - p.start);
    State state;
    work.masses_of(p.direction, 0, state.x);
    work.masses_of(p.direction, 1, state.x_prime);
    return state;
}

void ExactSolver::sample(std::size_t phase, const evaluation::EvenInstants& at, const std::vector<double>& most_lost, double* x,
                         double* x_prime) {
    ContactPhases& work = *work_;
    const Phase& p = work.motion.phases[phase];
    if (!work.motion_of(p.direction).coupled()) {
        work.stand_at(phase);
        const evaluation::LinearSum motion = work.motion_of_masses(p.direction, p.start);
        const std::vector<evaluation::ErrorOfSamples> lost = evaluation::loss_of_samples(motion, at);
        const auto little = [](const evaluation::ErrorOfSamples& of, double most) { return of.x <= most && of.x_prime <= most; };
        if (std::ranges::equal(lost, most_lost, little)) return evaluation::even_samples(motion, at, x, x_prime);
    }
    for (std::size_t n = 0; n < at.count; ++n) {
        const State state = state_at(phase, at.first + at.step * static_cast<double>(n));
        x = std::ranges::copy(state.x, x).out;
        x_prime = std::ranges::copy(state.x_prime, x_prime).out;
    }
}

void Deviations::start(const ContactPhases& phases, int direction) {
    const std::size_t N = phases.N;
    dx = Matrix<double>::Zero(N, 2 * N);
    dv = Matrix<double>::Zero(N, 2 * N);
    for (std::size_t k = 0; k < N; ++k) dx(k, k) = dv(k, N + k) = 1;
    if (direction != 0) return;
    const StuckConfiguration& stuck = phases.system->stuck;
    if (stuck.contact.has_own_row() || std::ranges::any_of(stuck.m_j, [](double tie) { return tie != 0; }))
        dv -= phases.inertia * phases.w * stuck.contact.row_of(dv);
    stuck.contact.hold(dv);
}

void Deviations::carry(ContactPhases& phases, int direction, const Event& event) {
    const Contact& contact = phases.system->stuck.contact;
    const std::size_t N = phases.N;
    phases.effort->spend(cost_of_products(static_cast<long>(8 * N * N * N)));
    if (direction != 0) {
        dq = product(phases.system->momentum, dx);
        dp = product(phases.system->momentum, dv);
        phases.sliding.carry(event.t, dq, dp);
        dx = product(phases.system->basis.phi, dq);
        dv = product(phases.system->basis.phi, dp);
        if (!event.found) return;
        // x_j' = 0 fixes the instant; the friction force jumps there.
        double acceleration = 0;
        for (std::size_t i = 0; i < N; ++i) acceleration += phases.system->contact_shape(i) * phases.sliding.q[2][i];
        const double jump = event.next == direction ? 0.0
                            : event.next == 0       ? event.load - direction * phases.e.beta
                                                    : -2 * direction * phases.e.beta;
        if (acceleration != 0) shift(phases.w, jump, contact.row_of(dv) / -acceleration, dv);
        if (event.next == 0) contact.hold(dv);
        return;
    }
    if (N > 1) carry_stuck(phases, event);
    if (!event.found || phases.e.mu == 1) return;
    const double rate = phases.load(event.t)[1];
    const Matrix<double> d_rest = contact.row_of(dx);
    Matrix<double> dQ = -phases.system->stuck.k_jj * d_rest;
    const double r2 = phases.e.r * phases.e.r;
    for (std::size_t i = 0; i + 1 < N; ++i) {
        dQ -= phases.k_j[i] * dq.row(i) + phases.c_j[i] * dp.row(i);
        if (phases.m_j[i] == 0) continue;
        const LinearMotion& stuck = phases.sticking;
        Matrix<double> acceleration = -phases.k_j[i] / r2 * d_rest - stuck.omega_0[i] * stuck.omega_0[i] * dq.row(i);
        if (stuck.coupled())
            acceleration -= stuck.D.row(i) * dp;
        else
            acceleration -= 2 * stuck.decay[i] * dp.row(i);
        dQ -= phases.m_j[i] * acceleration;
    }
    shift(phases.w, -event.next * (phases.e.mu - 1) * phases.e.beta, Matrix<double>(dQ / -rate), dv);
}

void Deviations::carry_stuck(ContactPhases& phases, const Event& event) {
    const StuckConfiguration& s = phases.system->stuck;
    const Matrix<double> d_rest = s.contact.row_of(dx);
    dq = product(s.momentum, dx);
    dp = product(s.momentum, dv);
    Matrix<double> at_rest(dq.rows(), dq.cols()); // where the stuck modes would rest for the shifted contact
    for (Eigen::Index i = 0; i < dq.rows(); ++i) {
        const double r_n = s.r_n[static_cast<std::size_t>(i)];
        at_rest.row(i) = -phases.k_j[i] / (r_n * r_n) * d_rest;
    }
    dq -= at_rest;
    phases.sticking.carry(event.t, dq, dp);
    dq += at_rest;
    dx = product(s.shapes, dq) + column(s.carried) * d_rest;
    dv = product(s.shapes, dp);
}

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

State at_maximum_of_force(const ModeSums<double>& sums, const SteadyState<double>& state) {
    Motion<double> at = motion(sums, state, -state.phi_j);
    const std::size_t N = sums.coupled ? sums.coupled->size() : sums.R.size();
    at.x.resize(N); // the coordinates of the system, and no displacements besides
    at.x_prime.resize(N);
    return {std::move(at.x), std::move(at.x_prime)};
}

} // namespace denhartog
