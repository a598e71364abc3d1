#include "denhartog/solve/sampled_solution.hpp"

#include <cmath>

#include "denhartog/model/coordinates.hpp"
#include "denhartog/number/elementary.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/number/number_text.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/solve/quantities.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {
namespace {

// From the start of an orbit along it.
std::vector<State<double>> along_orbit(const Scene<double>& scene, const SolvedState& from, const std::vector<double>& tau,
                                       double period) {
    State<double> start;
    for (const Certified& x : from.x) start.x.push_back(x.value);
    for (const Certified& v : from.x_prime) start.x_prime.push_back(v.value);
    for (std::vector<double>* part : {&start.x, &start.x_prime}) take_to_coordinates(scene.system.coordinates, *part);
    const ContactSystem<double> system = contact_system(scene.system);
    ExactSolver<double> solver(system, {*scene.r, *scene.beta, scene.mu});
    const std::vector<Phase<double>> phases = solver.run(start, 0, period).phases;
    std::vector<State<double>> states;
    std::size_t n = 0;
    for (const double instant : tau) {
        while (n + 1 < phases.size() && phases[n].end < instant) ++n;
        states.push_back(solver.state_at(n, instant));
        for (std::vector<double>* part : {&states.back().x, &states.back().x_prime})
            take_to_masses(scene.system.coordinates, *part);
    }
    return states;
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

// The phase of the contact is that of the answer.
std::vector<State<double>> of_closed_form(const Scene<double>& scene, double phi_j, std::vector<double> tau) {
    constexpr int digits = 10;
    for (double& instant : tau) instant -= phi_j;
    const Quantities<Bounded<double>> q = quantities(scene_source(scene), tau, digits, PointNumbers::motion).numbers;
    if (!q.X_j)
        throw PrecisionError("beta = " + number_to_text(*scene.beta) +
                             " equals beta_lim to the digits of the answer, so that its motion is not known");
    std::vector<State<double>> states(tau.size());
    for (std::size_t n = 0; n < q.x.size(); ++n) {
        State<double>& state = states[n / q.x_size.size()];
        state.x.push_back(q.x[n].x);
        state.x_prime.push_back(q.x_prime[n].x);
    }
    return states;
}

} // namespace

SampledSolution sampled_solution(const Scene<double>& of_masses, const Solution& solution, std::size_t samples) {
    const Scene<double> scene = in_own_coordinates(of_masses);
    check_samples("samples", samples, number_of_masses(scene.system));
    const double period = 2 * pi<double>() * solution.periods;
    SampledSolution all;
    for (std::size_t n = 0; n < samples; ++n) all.tau.push_back(period * static_cast<double>(n) / static_cast<double>(samples));
    if (solution.start) {
        all.states = along_orbit(scene, *solution.start, all.tau, period);
    } else if (solution.rest_interval) {
        all.states = of_stuck_masses(solution.masses, all.tau);
    } else {
        const std::optional<Certified>& phase =
            solution.between ? solution.between->phase : mass_of(solution, solution.contact).phase;
        if (!phase) throw PrecisionError("the contact moves by less than the error of its amplitude: its phase is not known");
        all.states = of_closed_form(of_masses, phase->value, all.tau);
    }
    return all;
}

} // namespace denhartog
