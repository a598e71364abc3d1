/// @file
/// @brief The motion from phase to phase.
#include "denhartog/stick_slip/exact_motion.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "denhartog/stick_slip/contact_phases.hpp"

namespace denhartog {
namespace {

constexpr int most_phases_without_length = 60;
constexpr int most_phases_a_period = 20000;

} // namespace

void ExactSolver::Work::run(double tau_0, double tau_1, bool with_jacobian) {
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
        const Event event = direction != 0 ? end_of_sliding(direction, length, order)
                            : N == 1       ? end_of_sticking_alone(tau, length)
                                           : end_of_sticking(length);
        if (event.open) {
            motion.status = MotionStatus::open;
            break;
        }
        const double end = event.found ? tau + event.t : tau_1;
        motion.phases.push_back({direction, tau, end});
        work_counted.phases_propagated.fetch_add(1, std::memory_order_relaxed);
        LinearMotion& now = direction == 0 ? sticking : sliding;
        now.differentiate_at(event.t);
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

void ExactSolver::Work::stand_at(std::size_t phase) {
    const auto state = motion.states.begin() + static_cast<std::ptrdiff_t>(2 * N * phase);
    x.assign(state, state + static_cast<std::ptrdiff_t>(N));
    v.assign(state + static_cast<std::ptrdiff_t>(N), state + static_cast<std::ptrdiff_t>(2 * N));
    start_phase(motion.phases[phase].direction, motion.phases[phase].start);
}

ExactSolver::ExactSolver(const ContactSystem& system, const Excitation& excitation)
    : work_(std::make_unique<Work>(system, excitation)) {}

ExactSolver::~ExactSolver() = default;

ExactSolver::ExactSolver(ExactSolver&&) noexcept = default;

void ExactSolver::set(const Excitation& excitation) { work_->set(excitation); }

Effort* ExactSolver::allow(Effort* effort) { return std::exchange(work_->effort, effort != nullptr ? effort : &work_->own); }

Effort& ExactSolver::effort() const { return *work_->effort; }

const ContactSystem& ExactSolver::system() const { return *work_->system; }

const Excitation& ExactSolver::excitation() const { return work_->e; }

const ExactMotion& ExactSolver::run(const State& start, double tau_0, double tau_1, bool with_jacobian) {
    Work& work = *work_;
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
    Work& work = *work_;
    const Phase& p = work.motion.phases[phase];
    work.stand_at(phase);
    (p.direction == 0 ? work.sticking : work.sliding).move_to(tau - p.start);
    State state;
    work.masses_of(p.direction, 0, state.x);
    work.masses_of(p.direction, 1, state.x_prime);
    return state;
}

EndOfPhase ExactSolver::end_of(std::size_t phase) {
    Work& work = *work_;
    const Phase& p = work.motion.phases[phase];
    work.stand_at(phase);
    const double length = p.end - p.start;
    const Jet<double> jet = p.direction != 0 ? work.velocity(p.direction, length) : work.load(length);
    return {std::abs(jet.f[1]), jet.second, jet.noise};
}

double EndOfPhase::error_of_instant(double error) const {
    const double apart = 4 * (error + noise) / (3 * rate);
    return rate > 0 && 4 * second * apart <= rate ? apart : std::numeric_limits<double>::infinity();
}

double highest_over_force(const ExactSolver& solver) {
    return std::max(1.0, solver.system().basis.r_n.back() / solver.excitation().r);
}

double error_at_ends(const ExactSolver& solver, bool slides, double displacement, const std::vector<double>& velocity) {
    if (slides) return velocity[solver.system().contact.index];
    const StuckConfiguration<double>& stuck = solver.system().stuck;
    const double r = solver.excitation().r, fastest = highest_over_force(solver);
    double of_load = std::abs(stuck.k_jj) * displacement;
    for (std::size_t n = 0; n < stuck.masses.size(); ++n)
        of_load += std::abs(stuck.k_j[n]) * displacement +
                   (r * std::abs(stuck.c_j[n]) + r * r * std::abs(stuck.m_j[n]) * fastest) * velocity[stuck.masses[n].index];
    return of_load;
}

} // namespace denhartog
