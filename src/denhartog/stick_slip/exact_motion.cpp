/// @file
/// @brief The motion from phase to phase.
#include "denhartog/stick_slip/exact_motion.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "denhartog/model/coordinates.hpp"
#include "denhartog/sliding/instants_of_maxima.hpp"
#include "denhartog/stick_slip/deviations.hpp"
#include "denhartog/stick_slip/largest_displacement.hpp"
#include "denhartog/stick_slip/sliding_reach.hpp"

namespace denhartog {
namespace {


constexpr int most_phases_without_length = 60;
constexpr int most_phases_a_period = 20000;

template <class T>
Matrix<T> with_rows(const Matrix<T>& shapes, const Matrix<T>& further) {
    Matrix<T> all(shapes.rows() + further.rows(), shapes.cols());
    all.topRows(shapes.rows()) = shapes;
    if (further.rows() > 0) all.bottomRows(further.rows()) = further;
    return all;
}

} // namespace

/// @brief What the solver computes with.
template <class T>
struct ExactSolver<T>::Work : ContactPhases<T> {
    using ContactPhases<T>::N, ContactPhases<T>::x, ContactPhases<T>::v, ContactPhases<T>::effort;
    using ContactPhases<T>::sliding, ContactPhases<T>::sticking, ContactPhases<T>::system;
    Effort own;
    ExactMotion<T> motion;
    Deviations<T> deviations;

    Work(const ContactSystem<T>& s, const Excitation<T>& e) : ContactPhases<T>(s, e, own) {}

    void run(const T& tau_0, const T& tau_1, bool with_jacobian) {
        motion.status = MotionStatus::complete;
        motion.phases.clear();
        motion.states.clear();
        motion.effort_for_jacobian = 0;
        this->touching = 0;
        T tau = tau_0;
        auto [direction, order] = this->first_direction(tau);
        if (with_jacobian) deviations.start(*this, direction);
        int without_length = 0;
        const double periods = static_cast<double>(T((tau_1 - tau_0) / (2 * pi<T>())));
        if (effort == &own) own = {static_cast<long>(static_cast<double>(default_effort(N)) * std::min(1e6, 1 + periods))};
        const long cost_of_phase = static_cast<long>(1 + N * N / 50); // of states taken into modes and back
        const double most = most_phases_a_period * (1 + periods);
        while (tau < tau_1) {
            this->start_phase(direction, tau);
            motion.states.insert(motion.states.end(), x.begin(), x.end());
            motion.states.insert(motion.states.end(), v.begin(), v.end());
            const T length = tau_1 - tau;
            effort->spend(cost_of_phase);
            const Event<T> event = direction != 0 ? this->end_of_sliding(direction, length, order)
                                   : N == 1       ? this->end_of_sticking_alone(tau, length)
                                                  : this->end_of_sticking(length);
            if (event.open) {
                motion.status = MotionStatus::open;
                break;
            }
            const T end = event.found ? T(tau + event.t) : tau_1;
            motion.phases.push_back({direction, tau, end});
            work_counted.phases_propagated.fetch_add(1, std::memory_order_relaxed);
            LinearMotion<T>& now = direction == 0 ? sticking : sliding;
            now.differentiate_at(event.t);
            if (with_jacobian) {
                const long before = effort->spent;
                deviations.carry(*this, direction, event);
                motion.effort_for_jacobian += effort->spent - before;
            }
            this->masses_of(direction, 0, x);
            this->masses_of(direction, 1, v);
            if (event.found) v[system->contact.index] = T(0);
            without_length = end > tau ? 0 : without_length + 1;
            if (without_length > most_phases_without_length || static_cast<double>(motion.phases.size()) > most) {
                motion.status = MotionStatus::chattering;
                break;
            }
            tau = end;
            direction = event.next;
            order = event.order;
        }
        motion.touching = this->touching;
        motion.end.x = x;
        motion.end.x_prime = v;
        if (!with_jacobian || motion.status != MotionStatus::complete) return;
        motion.jacobian.resize(2 * N, 2 * N);
        motion.jacobian.topRows(N) = deviations.dx;
        motion.jacobian.bottomRows(N) = deviations.dv;
    }

    void stand_at(std::size_t phase) {
        const auto state = motion.states.begin() + static_cast<std::ptrdiff_t>(2 * N * phase);
        x.assign(state, state + static_cast<std::ptrdiff_t>(N));
        v.assign(state + static_cast<std::ptrdiff_t>(N), state + static_cast<std::ptrdiff_t>(2 * N));
        this->start_phase(motion.phases[phase].direction, motion.phases[phase].start);
    }
};

template <class T>
ExactSolver<T>::ExactSolver(const ContactSystem<T>& system, const Excitation<T>& excitation)
    : work_(std::make_unique<Work>(system, excitation)) {}

template <class T>
ExactSolver<T>::~ExactSolver() = default;

template <class T>
ExactSolver<T>::ExactSolver(ExactSolver&&) noexcept = default;

template <class T>
void ExactSolver<T>::set(const Excitation<T>& excitation) {
    work_->set(excitation);
}

template <class T>
Effort* ExactSolver<T>::allow(Effort* effort) {
    return std::exchange(work_->effort, effort != nullptr ? effort : &work_->own);
}

template <class T>
Effort& ExactSolver<T>::effort() const {
    return *work_->effort;
}

template <class T>
const ContactSystem<T>& ExactSolver<T>::system() const {
    return *work_->system;
}

template <class T>
const Excitation<T>& ExactSolver<T>::excitation() const {
    return work_->e;
}

template <class T>
const ExactMotion<T>& ExactSolver<T>::run(const State<T>& start, const T& tau_0, const T& tau_1, bool with_jacobian) {
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

template <class T>
State<T> ExactSolver<T>::state_at(std::size_t phase, const T& tau) {
    Work& work = *work_;
    const Phase<T>& p = work.motion.phases[phase];
    work.stand_at(phase);
    (p.direction == 0 ? work.sticking : work.sliding).move_to(T(tau - p.start));
    State<T> state;
    work.masses_of(p.direction, 0, state.x);
    work.masses_of(p.direction, 1, state.x_prime);
    return state;
}

template <class T>
EndOfPhase<T> ExactSolver<T>::end_of(std::size_t phase) {
    using std::abs;
    Work& work = *work_;
    const Phase<T>& p = work.motion.phases[phase];
    work.stand_at(phase);
    const T length = p.end - p.start;
    const Jet<T> jet = p.direction != 0 ? work.velocity(p.direction, length) : work.load(length);
    return {T(abs(jet.f[1])), jet.second, jet.noise};
}

template <class T>
T ExactSolver<T>::sliding_reach(std::size_t phase) {
    work_->stand_at(phase);
    return denhartog::sliding_reach(*work_, work_->motion.phases[phase].direction);
}

template <class T>
std::vector<Extremum<T>> ExactSolver<T>::largest_displacements(const T& error) {
    using std::abs;
    Work& work = *work_;
    if (work.effort == &work.own) work.own = {default_effort(work.N)};
    const ContactSystem<T>& system = *work.system;
    const std::size_t j = system.contact.index, count = work.N + system.coordinates.replaced.size();
    const T start = work.motion.phases.empty() ? T(0) : work.motion.phases.front().start; // a mass at rest is there as ever
    std::vector<Extremum<T>> largest(count, Extremum<T>{T(0), start});
    std::vector<std::vector<Place<T>>> places(count);
    const auto take = [&](std::size_t k, const T& x, const T& tau) {
        const T size = abs(x);
        if (size >= abs(largest[k].x) - 2 * error) places[k].push_back({tau, tau, tau, size, size, T(0)});
        if (size > abs(largest[k].x)) {
            largest[k].x = x;
            largest[k].instant = tau;
        }
    };
    const auto take_all = [&](std::vector<T> x, const T& tau) {
        add_displacements(system.coordinates, x);
        for (std::size_t k = 0; k < count; ++k) take(k, x[k], tau);
    };
    for (std::size_t n = 0; n < work.motion.phases.size(); ++n) {
        const auto state = work.motion.states.begin() + static_cast<std::ptrdiff_t>(2 * work.N * n);
        take_all({state, state + static_cast<std::ptrdiff_t>(work.N)}, work.motion.phases[n].start);
    }
    if (!work.motion.phases.empty()) take_all(work.motion.end.x, work.motion.phases.back().end);
    const Matrix<T> sliding_shapes = with_rows(system.basis.phi, system.further);
    const Matrix<T> sticking_shapes = with_rows(system.stuck.phi, system.stuck.further);
    for (std::size_t n = 0; n < work.motion.phases.size() && work.N > 1; ++n) {
        const Phase<T>& p = work.motion.phases[n];
        work.stand_at(n);
        const T length = p.end - p.start;
        const bool sticks = p.direction == 0;
        Displacements<T> displacements(sticks ? work.sticking : work.sliding, sticks ? sticking_shapes : sliding_shapes,
                                       *work.effort);
        if (sticks) displacements.carry(system.stuck.carried, work.x[j]);
        for (std::size_t k = 0; k < count; ++k) {
            if (k == j || !(length > 0)) continue;
            const auto row = static_cast<Eigen::Index>(p.direction == 0 && k > j ? k - 1 : k);
            const Maximum<T> found = global_maximum(displacements.size_of(row), T(0), length, displacements.noise(row, T(0)),
                                                    work.effort, T(abs(largest[k].x) - 2 * error), error);
            const auto in_orbit = [&](const T& tau) { return tau < length ? T(p.start + tau) : p.end; };
            for (const Place<T>& place : found.places)
                places[k].push_back({in_orbit(place.from), in_orbit(place.to), in_orbit(place.instant), place.value, place.upper,
                                     place.reach});
            if (found.value > abs(largest[k].x)) take(k, displacements.of(row, found.instant), T(p.start + found.instant));
            if (!found.settled) largest[k].unsure = std::max(largest[k].unsure, T(found.upper - abs(largest[k].x)));
        }
    }
    const auto is_negative = [&](std::size_t k, const T& tau) {
        std::size_t n = 0;
        while (n + 1 < work.motion.phases.size() && work.motion.phases[n].end < tau) ++n;
        State<T> state = state_at(n, tau);
        add_displacements(system.coordinates, state.x);
        return state.x[k] < 0;
    };
    for (std::size_t k = 0; k < count; ++k) {
        if (k == j || places[k].empty()) continue;
        std::erase_if(places[k], [&](const Place<T>& place) { return place.upper < abs(largest[k].x) - 2 * error; });
        largest[k].spread =
            spread_of_phases(joined(std::move(places[k])), work.motion.phases.front().start, work.motion.phases.back().end,
                             largest[k].instant, [&](const T& tau) { return is_negative(k, tau); });
    }
    return largest;
}


template class ExactSolver<double>;

} // namespace denhartog
