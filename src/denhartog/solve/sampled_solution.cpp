#include "denhartog/solve/sampled_solution.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/answer/certify.hpp"
#include "denhartog/elementary/elementary.hpp"
#include "denhartog/model/coordinates.hpp"
#include "denhartog/model/linear_algebra.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/solve/orbit_in_50_digits.hpp"
#include "denhartog/solve/quantities.hpp"
#include "denhartog/solve/solve.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {
namespace {

// Stops over a period; one that lasts beyond its end is the first.
template <class T>
std::size_t stops_in(const std::vector<Phase<T>>& phases) {
    const auto rests = [](const Phase<T>& p) { return p.direction == 0 && p.end > p.start; };
    const auto stops = static_cast<std::size_t>(std::ranges::count_if(phases, rests));
    return stops > 1 && rests(phases.front()) && rests(phases.back()) ? stops - 1 : stops;
}

// The motion of an answer over its period, by the solver that found it. None where it does not come back to its start, by
// `error_of_samples` of what each mass does, or has other stops than the answer: where the number type does not have the digits.
template <class T>
std::optional<std::vector<State<double>>> along_orbit(ExactSolver<T>& solver, State<T> start, const Solution& solution,
                                                      const std::vector<double>& tau) {
    const auto to_masses = [&solver](State<T>& state) {
        for (std::vector<T>* part : {&state.x, &state.x_prime}) take_to_masses(solver.system().coordinates, *part);
    };
    const ExactMotion<T>& motion = solver.run(start, T(0), T(2 * pi<T>() * solution.periods));
    if (motion.status != MotionStatus::complete || stops_in(motion.phases) != solution.stops.size()) return std::nullopt;
    State<T> end = motion.end;
    to_masses(start);
    to_masses(end);
    std::vector<State<double>> states;
    std::vector<double> speed(start.x.size(), 0);
    std::size_t n = 0;
    for (const double instant : tau) {
        while (n + 1 < motion.phases.size() && motion.phases[n].end < instant) ++n;
        State<T> at = solver.state_at(n, T(instant));
        to_masses(at);
        State<double>& state = states.emplace_back();
        for (std::size_t k = 0; k < speed.size(); ++k) {
            state.x.push_back(static_cast<double>(at.x[k]));
            state.x_prime.push_back(static_cast<double>(at.x_prime[k]));
            speed[k] = std::max(speed[k], std::abs(state.x_prime[k]));
        }
    }
    for (std::size_t k = 0; k < speed.size(); ++k) {
        const Certified& amplitude = solution.masses[k].amplitude;
        const auto returns = [&](const T& to, const T& from, double size) {
            return size_of_number(T(to - from)) <= amplitude.error + error_of_samples * size;
        };
        if (!returns(end.x[k], start.x[k], amplitude.value) ||
            !returns(end.x_prime[k], start.x_prime[k], std::max(speed[k], amplitude.value)))
            return std::nullopt;
    }
    return states;
}

// What 50 digits need to know of the orbit.
PeriodicOrbit<double> orbit_of(const Solution& solution, const Coordinates<double>& coordinates) {
    PeriodicOrbit<double> orbit;
    orbit.periods = solution.periods;
    orbit.symmetric = solution.symmetric;
    for (const Certified& x : solution.start->x) {
        orbit.start.x.push_back(x.value);
        orbit.error_bound = std::max(orbit.error_bound, x.error + std::abs(x.value) * unit_of<double>());
    }
    for (const Certified& v : solution.start->x_prime) orbit.start.x_prime.push_back(v.value);
    for (std::vector<double>* part : {&orbit.start.x, &orbit.start.x_prime}) take_to_coordinates(coordinates, *part);
    const Matrix<double>& sums = coordinates.of_masses; // of the masses that the contact is between
    if (sums.size() > 0) orbit.error_bound *= std::max(1.0, largest_row_sum(sums));
    return orbit;
}

// The motion in double, or in 50 digits where the answer needed them or double does not repeat it.
std::vector<State<double>> of_orbit(const SceneSource& source, const Solution& solution, const std::vector<double>& tau) {
    const Scene<double>& scene = source->in_double();
    const PeriodicOrbit<double> orbit = orbit_of(solution, scene.system.coordinates);
    std::optional<std::vector<State<double>>> states;
    if (solution.method.precision == name(Precision::in_double)) {
        const ContactSystem<double> system = contact_system(scene.system);
        ExactSolver<double> solver(system, {*scene.r, *scene.beta, scene.mu});
        states = along_orbit(solver, orbit.start, solution, tau);
        if (states) return *states;
    }
    const std::string failed = "the samples of the motion are not certain to 6 digits: ";
    try {
        find_in_50_digits(source, orbit, {.contact_only = true, .with_stability = false},
                          [&](ExactSolver<Real50>& solver, const PeriodicOrbit<Real50>& found) {
                              states = along_orbit(solver, found.start, solution, tau);
                          });
    } catch (const PrecisionError& e) {
        throw PrecisionError(failed + e.what());
    }
    if (!states) throw PrecisionError(failed + "the motion from its start does not repeat itself");
    return *states;
}

std::vector<State<double>> of_stuck_masses(const std::vector<SolvedMass>& masses, const std::vector<double>& tau) {
    std::vector<State<double>> states;
    for (const double instant : tau) {
        State<double> state;
        for (const SolvedMass& m : masses) {
            const double angle = instant - (m.phase ? m.phase->value : 0), amplitude = m.phase ? m.amplitude.value : 0;
            state.x.push_back(amplitude * elementary::cos(angle));
            state.x_prime.push_back(-amplitude * elementary::sin(angle));
        }
        states.push_back(std::move(state));
    }
    return states;
}

std::vector<State<double>> of_closed_form(const SceneSource& source, double phi_j, std::vector<double> tau) {
    constexpr int digits = 10;
    for (double& instant : tau) instant -= phi_j;
    const Quantities<Bounded<double>> q = quantities(source, tau, digits, PointNumbers::motion).numbers;
    if (!q.X_j)
        throw PrecisionError("beta = " + number_to_text(*source->in_double().beta) +
                             " equals beta_lim to the digits of the answer, so that its motion is not known");
    std::vector<State<double>> states(tau.size());
    for (std::size_t n = 0; n < q.x.size(); ++n) {
        State<double>& state = states[n / q.x_size.size()];
        state.x.push_back(q.x[n].x);
        state.x_prime.push_back(q.x_prime[n].x);
    }
    return states;
}

// Whether a phase is certain enough for the samples that were taken with it.
bool is_certain_enough(const Certified& phase, const Solution& solution, const std::vector<State<double>>& states) {
    for (std::size_t k = 0; k < solution.masses.size(); ++k) {
        const Certified& amplitude = solution.masses[k].amplitude;
        for (const State<double>& at : states)
            if (phase.error * std::abs(at.x_prime[k]) > amplitude.error + error_of_samples * amplitude.value) return false;
    }
    return true;
}

// The phase of the contact is that of the answer, or has more digits where a mass moves too fast for those.
std::vector<State<double>> of_sliding(const SceneSource& source, const Solution& solution, const std::vector<double>& tau) {
    const auto phase_of = [](const Solution& s) {
        const std::optional<Certified>& phase = s.between ? s.between->phase : mass_of(s, s.contact).phase;
        if (!phase) throw PrecisionError("the contact moves by less than the error of its amplitude: its phase is not known");
        return *phase;
    };
    constexpr int more_digits = 15;
    Certified phase = phase_of(solution);
    std::vector<State<double>> states = of_closed_form(source, phase.value, tau);
    if (is_certain_enough(phase, solution, states)) return states;
    phase = phase_of(solve(source, {Asked::motion, more_digits}));
    states = of_closed_form(source, phase.value, tau);
    if (is_certain_enough(phase, solution, states)) return states;
    throw PrecisionError("the phase of the contact is not certain enough for the samples of the fastest mass");
}

} // namespace

SampledSolution sampled_solution(const SceneSource& source, const Solution& solution, std::size_t samples) {
    check_samples("samples", samples, number_of_masses(source->in_double().system));
    const double period = 2 * pi<double>() * solution.periods;
    SampledSolution all;
    for (std::size_t n = 0; n < samples; ++n) all.tau.push_back(period * static_cast<double>(n) / static_cast<double>(samples));
    if (solution.start)
        all.states = of_orbit(source, solution, all.tau);
    else if (solution.rest_interval)
        all.states = of_stuck_masses(solution.masses, all.tau);
    else
        all.states = of_sliding(source, solution, all.tau);
    return all;
}

} // namespace denhartog
