// The motion from a start, phase by phase. Read `ExactSolver::follow` first: it follows (6) with (2) and (3) from event
// to event. `Deviations::carry` takes small deviations of the state through a phase and over the event at its end;
// `contact_system` prepares a system.
#include "denhartog/stick_slip/exact_motion.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "denhartog/evaluation/even_samples.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/coupled_sums.hpp"

namespace denhartog {
namespace {

constexpr int most_phases_without_length = 60;
constexpr int most_phases_a_period = 20000;

// The acceleration before the event exceeds that after it by jump times w; the event comes d_tau later.
void shift(const Column& w, double jump, const Matrix<double>& d_tau, Matrix<double>& dv) {
    if (jump != 0) dv += jump * w * d_tau;
}

} // namespace

void ExactSolver::follow(double tau_0, double tau_1, bool with_jacobian) {
    motion_.status = MotionStatus::complete;
    motion_.phases.clear();
    motion_.states.clear();
    motion_.touching = 0;
    double tau = tau_0;
    auto [direction, order] = first_direction(tau);
    if (with_jacobian) deviations_.start(*this, direction);
    int without_length = 0;
    const double periods = (tau_1 - tau_0) / (2 * pi<double>());
    if (effort_ == &own_) own_ = {static_cast<long>(static_cast<double>(default_effort(N_)) * std::min(1e6, 1 + periods))};
    const long cost_of_phase = static_cast<long>(1 + N_ * N_ / 50); // of states taken into modes and back
    const double most = most_phases_a_period * (1 + periods);
    while (tau < tau_1) {
        start_phase(direction, tau);
        motion_.states.insert(motion_.states.end(), z_.x.begin(), z_.x.end());
        motion_.states.insert(motion_.states.end(), z_.x_prime.begin(), z_.x_prime.end());
        effort_->spend(cost_of_phase);
        const Event event = direction != 0 ? end_of_sliding(direction, tau_1 - tau, order) : end_of_sticking(tau, tau_1 - tau);
        if (event.open) {
            motion_.status = MotionStatus::open;
            break;
        }
        const double end = event.found ? tau + event.t : tau_1;
        motion_.phases.push_back({direction, tau, end});
        work_counted.phases_propagated.fetch_add(1, std::memory_order_relaxed);
        LinearMotion& motion = motion_of(direction);
        if (with_jacobian) {
            motion.differentiate_at(event.t);
            deviations_.carry(*this, direction, event);
        } else {
            motion.move_to(event.t);
        }
        masses_of(direction, 0, z_.x);
        masses_of(direction, 1, z_.x_prime);
        if (event.found) system_->stuck.contact.hold(z_.x_prime.data());
        without_length = end > tau ? 0 : without_length + 1;
        if (without_length > most_phases_without_length || static_cast<double>(motion_.phases.size()) > most) {
            motion_.status = MotionStatus::chattering;
            break;
        }
        tau = end;
        direction = event.next;
        order = event.order;
    }
    motion_.end = z_;
    if (!with_jacobian || motion_.status != MotionStatus::complete) return;
    motion_.jacobian.resize(2 * N_, 2 * N_);
    motion_.jacobian << deviations_.dx, deviations_.dv;
}

void ExactSolver::stand_at(std::size_t phase) {
    z_ = motion_.start_of(phase);
    start_phase(motion_.phases[phase].direction, motion_.phases[phase].start);
}

const ExactMotion& ExactSolver::run(const State& start, double tau_0, double tau_1, bool with_jacobian) {
    if (start.x.size() != N_ || start.x_prime.size() != N_)
        throw InputError("start", "must have a displacement and a velocity for each mass", std::to_string(start.x.size()));
    z_ = start;
    const Tried<bool> followed = tried([&] {
        follow(tau_0, tau_1, with_jacobian);
        return true;
    });
    if (followed.outcome == Outcome::budget_spent) // an exponential of coupled modes had nothing left to spend
        motion_.status = MotionStatus::open;
    else
        require(followed);
    return motion_;
}

State ExactSolver::state_at(std::size_t phase, double tau) {
    const Phase& p = motion_.phases[phase];
    stand_at(phase);
    motion_of(p.direction).move_to(tau - p.start);
    State state;
    masses_of(p.direction, 0, state.x);
    masses_of(p.direction, 1, state.x_prime);
    return state;
}

// The motion of the masses from the start of the phase, at tau, that was taken into coordinates last.
evaluation::LinearSum ExactSolver::motion_of_masses(int direction, double tau) const {
    const LinearMotion& part = direction == 0 ? sticking_ : sliding_;
    const Matrix<double>& shapes = direction == 0 ? system_->stuck.shapes : system_->basis.phi;
    const std::size_t n = part.size();
    const std::vector<double> none(N_);
    evaluation::LinearSum sum{tau, {}, std::vector<double>(N_ * n), none, none, none, none};
    const auto [sin_0, cos_0] = sine_cosine(tau);
    for (std::size_t i = 0; i < n; ++i) {
        const double omega = part.omega_0[i], zeta = part.decay[i] / omega, at_rest = part.G[i] / (omega * omega);
        Complex<double> X = part.F[i] * evaluation::response_by_R_squared(part.gap[i], part.decay[i]);
        if (!part.lead.empty()) X = evaluation::product(part.lead[i], X);
        const auto [s, s_prime] = evaluation::free_start({part.q[0][i], part.q[1][i]}, 0.0, X, cos_0, sin_0);
        sum.coordinates.push_back({1 / omega, zeta, evaluation::w_if_oscillating(zeta), at_rest, s, s_prime});
        for (std::size_t k = 0; k < N_; ++k) {
            const double shape = sum.shapes[k * n + i] = shapes(k, i);
            sum.A[k] += shape * X.re;
            sum.B[k] -= shape * X.im;
            sum.harmonic[k] += std::abs(shape) * (std::abs(X.re) + std::abs(X.im));
        }
    }
    if (direction == 0)
        for (std::size_t k = 0; k < N_; ++k) sum.constant[k] = rest_ * system_->stuck.carried[k];
    return sum;
}

void ExactSolver::sample(std::size_t phase, const evaluation::EvenInstants& at, const std::vector<double>& most_lost, double* x,
                         double* x_prime) {
    const Phase& p = motion_.phases[phase];
    if (!motion_of(p.direction).coupled()) {
        stand_at(phase);
        const evaluation::LinearSum motion = motion_of_masses(p.direction, p.start);
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

void Deviations::start(const ExactSolver& at, int direction) {
    const std::size_t N = at.N_;
    dx = Matrix<double>::Zero(N, 2 * N);
    dv = Matrix<double>::Zero(N, 2 * N);
    for (std::size_t k = 0; k < N; ++k) dx(k, k) = dv(k, N + k) = 1;
    if (direction != 0) return;
    const StuckConfiguration& stuck = at.system_->stuck;
    if (stuck.contact.has_own_row() || std::ranges::any_of(stuck.m_j, [](double tie) { return tie != 0; }))
        dv -= at.inertia_ * at.w_ * stuck.contact.row_of(dv);
    stuck.contact.hold(dv);
}

void Deviations::carry(ExactSolver& at, int direction, const Event& event) {
    const Contact& contact = at.system_->stuck.contact;
    const std::size_t N = at.N_;
    at.effort_->spend(cost_of_products(static_cast<long>(8 * N * N * N)));
    if (direction != 0) {
        dq = product(at.system_->momentum, dx);
        dp = product(at.system_->momentum, dv);
        at.sliding_.carry(event.t, dq, dp);
        dx = product(at.system_->basis.phi, dq);
        dv = product(at.system_->basis.phi, dp);
        if (!event.found) return;
        // x_j' = 0 fixes the instant; the friction force jumps there.
        double acceleration = 0;
        for (std::size_t i = 0; i < N; ++i) acceleration += at.system_->contact_shape(i) * at.sliding_.q[2][i];
        const double jump = event.next == direction ? 0.0
                            : event.next == 0       ? event.load - direction * at.e_.beta
                                                    : -2 * direction * at.e_.beta;
        if (acceleration != 0) shift(at.w_, jump, contact.row_of(dv) / -acceleration, dv);
        if (event.next == 0) contact.hold(dv);
        return;
    }
    if (N > 1) carry_stuck(at, event);
    if (!event.found || at.e_.mu == 1) return;
    const double rate = at.load(event.t)[1];
    const Matrix<double> d_rest = contact.row_of(dx);
    Matrix<double> dQ = -at.system_->stuck.k_jj * d_rest;
    const double r2 = at.e_.r * at.e_.r;
    for (std::size_t i = 0; i + 1 < N; ++i) {
        dQ -= at.k_j_[i] * dq.row(i) + at.c_j_[i] * dp.row(i);
        if (at.m_j_[i] == 0) continue;
        const LinearMotion& stuck = at.sticking_;
        const Matrix<double> damping = stuck.coupled() ? Matrix<double>(stuck.D.row(i) * dp) : 2 * stuck.decay[i] * dp.row(i);
        dQ -= at.m_j_[i] * Matrix<double>(-at.k_j_[i] / r2 * d_rest - stuck.omega_0[i] * stuck.omega_0[i] * dq.row(i) - damping);
    }
    shift(at.w_, -event.next * (at.e_.mu - 1) * at.e_.beta, Matrix<double>(dQ / -rate), dv);
}

void Deviations::carry_stuck(ExactSolver& at, const Event& event) {
    const StuckConfiguration& s = at.system_->stuck;
    const Matrix<double> d_rest = s.contact.row_of(dx);
    dq = product(s.momentum, dx);
    dp = product(s.momentum, dv);
    Matrix<double> at_rest(dq.rows(), dq.cols()); // where the stuck modes would rest for the shifted contact
    for (std::size_t i = 0; i < s.r_n.size(); ++i) at_rest.row(i) = -at.k_j_[i] / (s.r_n[i] * s.r_n[i]) * d_rest;
    dq -= at_rest;
    at.sticking_.carry(event.t, dq, dp);
    dq += at_rest;
    dx = product(s.shapes, dq) + column(s.carried) * d_rest;
    dv = product(s.shapes, dp);
}

ContactSystem contact_system(const System<double>& s, ModalBasis<double> basis, const RoundedModes* held, Effort* effort) {
    ContactSystem out;
    out.contact = contact_row(s);
    out.load = load_row(s);
    out.basis = std::move(basis);
    Matrix<double>& phi = out.basis.phi;
    const std::optional<Mass> load_im = load_rows(s).im;
    for (Eigen::Index i = 0; i < phi.cols(); ++i)
        out.modal_load.push_back({phi(static_cast<Eigen::Index>(out.load.index), i),
                                  load_im ? phi(static_cast<Eigen::Index>(load_im->index), i) : 0.0});
    out.contact_shape = phi.row(static_cast<Eigen::Index>(out.contact.index)).transpose();
    out.stuck = stuck_configuration(s, out.basis, held, effort);
    phi.conservativeResize(phi.cols(), Eigen::NoChange);
    out.stuck_load = load_on_stuck_modes(out.stuck, s.load);
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
