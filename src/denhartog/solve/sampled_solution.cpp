#include "denhartog/solve/sampled_solution.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/reference.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/solve/quantities.hpp"
#include "denhartog/solve/solve_by_reference.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

// Stops over a period; one that lasts beyond its end is the first.
std::size_t stops_in(const std::vector<Phase>& phases) {
    const auto rests = [](const Phase& p) { return p.direction == 0 && p.end > p.start; };
    const auto stops = static_cast<std::size_t>(std::ranges::count_if(phases, rests));
    return stops > 1 && rests(phases.front()) && rests(phases.back()) ? stops - 1 : stops;
}

// The motion of an answer over its period, in double. None where it does not come back to its start, by
// `error_of_samples` of what each mass does, or has other stops than the answer: where double does not have the digits.
std::optional<std::vector<State>> along_orbit(ExactSolver& solver, const State& start, const Solution& solution,
                                              const std::vector<double>& tau) {
    const ExactMotion& motion = solver.run(start, 0.0, 2 * pi<double>() * solution.periods);
    if (motion.status != MotionStatus::complete || stops_in(motion.phases) != solution.stops.size()) return std::nullopt;
    const State end = motion.end;
    std::vector<State> states;
    std::vector<double> speed(start.x.size(), 0);
    std::size_t n = 0;
    for (const double instant : tau) {
        while (n + 1 < motion.phases.size() && motion.phases[n].end < instant) ++n;
        State& state = states.emplace_back(solver.state_at(n, instant));
        for (std::size_t k = 0; k < speed.size(); ++k) speed[k] = std::max(speed[k], std::abs(state.x_prime[k]));
    }
    for (std::size_t k = 0; k < speed.size(); ++k) {
        const Certified& amplitude = solution.masses[k].amplitude;
        const auto returns = [&](double to, double from, double size) {
            return std::abs(to - from) <= amplitude.error + error_of_samples * size;
        };
        if (!returns(end.x[k], start.x[k], amplitude.value) ||
            !returns(end.x_prime[k], start.x_prime[k], std::max(speed[k], amplitude.value)))
            return std::nullopt;
    }
    return states;
}

// The state of an answer at the maximum of the force.
State start_of(const Solution& solution) {
    State start;
    for (const Certified& x : solution.start->x) start.x.push_back(x.value);
    for (const Certified& v : solution.start->x_prime) start.x_prime.push_back(v.value);
    return start;
}

std::vector<State> by_reference(const SceneSource& source, const Solution& solution, const std::vector<double>& tau) {
    try {
        return samples_by_reference(source, solution, tau, error_of_samples,
                                    [&] { return guesses_at(PreparedSystem{source}, source); });
    } catch (const PrecisionError& e) {
        throw PrecisionError(std::string("the samples of the motion are not certain to 6 digits: ") + e.what());
    }
}

// The motion in double, or by the reference where the answer needed it or double does not repeat it.
std::vector<State> of_orbit(const SceneSource& source, const Solution& solution, const std::vector<double>& tau) {
    if (solution.method.precision == "double") {
        const Scene<double>& scene = source->in_double();
        const ContactSystem system = contact_system(scene.system);
        ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
        std::optional<std::vector<State>> states = along_orbit(solver, start_of(solution), solution, tau);
        if (states) return *std::move(states);
    }
    return by_reference(source, solution, tau);
}

std::vector<State> of_stuck_masses(const std::vector<SolvedMass>& masses, const std::vector<double>& tau) {
    std::vector<State> states;
    for (const double instant : tau) {
        State state;
        for (const SolvedMass& m : masses) {
            const double angle = instant - (m.phase ? m.phase->value : 0), amplitude = m.phase ? m.amplitude.value : 0;
            state.x.push_back(amplitude * elementary::cos(angle));
            state.x_prime.push_back(-amplitude * elementary::sin(angle));
        }
        states.push_back(std::move(state));
    }
    return states;
}

std::vector<State> of_closed_form(const SceneSource& source, double phi_j, std::vector<double> tau) {
    constexpr int digits = 10;
    for (double& instant : tau) instant -= phi_j;
    const Quantities<Bounded<double>> q = quantities(source, tau, digits, PointNumbers::motion).numbers;
    if (!q.X_j)
        throw PrecisionError("beta = " + number_to_text(*source->in_double().beta) +
                             " equals beta_lim to the digits of the answer, so that its motion is not known");
    std::vector<State> states(tau.size());
    for (std::size_t n = 0; n < q.x.size(); ++n) {
        State& state = states[n / q.x_size.size()];
        state.x.push_back(q.x[n].x);
        state.x_prime.push_back(q.x_prime[n].x);
    }
    return states;
}

// Whether a phase is certain enough for the samples that were taken with it.
bool is_certain_enough(const Certified& phase, const Solution& solution, const std::vector<State>& states) {
    for (std::size_t k = 0; k < solution.masses.size(); ++k) {
        const Certified& amplitude = solution.masses[k].amplitude;
        for (const State& at : states)
            if (phase.error * std::abs(at.x_prime[k]) > amplitude.error + error_of_samples * amplitude.value) return false;
    }
    return true;
}

// By the closed form with the phase of the answer, or by the reference where a mass moves too fast for the digits of that phase.
std::vector<State> of_sliding(const SceneSource& source, const Solution& solution, const std::vector<double>& tau) {
    const std::optional<Certified>& phase =
        solution.between ? solution.between->phase : mass_of(solution, solution.contact).phase;
    if (phase) {
        std::vector<State> states = of_closed_form(source, phase->value, tau);
        if (is_certain_enough(*phase, solution, states)) return states;
    }
    return by_reference(source, solution, tau);
}

} // namespace

SampledSolution sampled_solution(const SceneSource& source, const Solution& solution, std::size_t samples) {
    check_samples("samples", samples, number_of_masses(source->in_double().system));
    const double period = 2 * pi<double>() * solution.periods;
    SampledSolution all;
    for (std::size_t n = 0; n < samples; ++n) all.tau.push_back(period * static_cast<double>(n) / static_cast<double>(samples));
    if (solution.method.proved)
        all.states = by_reference(source, solution, all.tau);
    else if (solution.start)
        all.states = of_orbit(source, solution, all.tau);
    else if (solution.rest_interval)
        all.states = of_stuck_masses(solution.masses, all.tau);
    else
        all.states = of_sliding(source, solution, all.tau);
    return all;
}

} // namespace denhartog
