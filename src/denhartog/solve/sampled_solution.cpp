#include "denhartog/solve/sampled_solution.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/answer/reference.hpp"
#include "denhartog/evaluation/even_samples.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/solve/decision.hpp"
#include "denhartog/solve/sampled_closed_form.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

constexpr double most_lost_to_rounding = error_of_samples / 1024; // of the amplitude of a mass, where a motion has stops

// Stops over a period; one that lasts beyond its end is the first.
std::size_t stops_in(const std::vector<Phase>& phases) {
    const auto rests = [](const Phase& p) { return p.direction == 0 && p.end > p.start; };
    const auto stops = static_cast<std::size_t>(std::ranges::count_if(phases, rests));
    return stops > 1 && rests(phases.front()) && rests(phases.back()) ? stops - 1 : stops;
}

// The motion of an answer over its period, in double. False where it does not come back to its start, by `error_of_samples` of
// what each mass does, or has other stops than the answer: where double does not have the digits.
bool is_along_orbit(ExactSolver& solver, const State& start, const Solution& solution, SampledSolution& all) {
    const double period = 2 * pi<double>() * solution.periods;
    const ExactMotion& motion = solver.run(start, 0.0, period);
    if (motion.status != MotionStatus::complete || stops_in(motion.phases) != solution.stops.size()) return false;
    const State end = motion.end;
    const std::size_t N = start.x.size(), samples = all.tau.size();
    std::vector<double> most_lost;
    for (const SolvedMass& mass : solution.masses) most_lost.push_back(most_lost_to_rounding * mass.amplitude.value);
    for (std::size_t phase = 0, n = 0; phase < motion.phases.size(); ++phase) {
        const bool last = phase + 1 == motion.phases.size();
        const auto after = last ? all.tau.end() : std::ranges::upper_bound(all.tau, motion.phases[phase].end);
        const std::size_t first = std::exchange(n, static_cast<std::size_t>(after - all.tau.begin()));
        if (n > first)
            solver.sample(phase, {all.tau[first], period / static_cast<double>(samples), n - first}, most_lost, &all.x[first * N],
                          &all.x_prime[first * N]);
    }
    for (std::size_t k = 0; k < N; ++k) {
        const Certified& amplitude = solution.masses[k].amplitude;
        double size = amplitude.value; // of the velocity
        for (std::size_t n = k; n < all.x_prime.size(); n += N) size = std::max(size, std::abs(all.x_prime[n]));
        const auto returns = [&](double to, double from, double of) {
            return std::abs(to - from) <= amplitude.error + error_of_samples * of;
        };
        if (!returns(end.x[k], start.x[k], amplitude.value) || !returns(end.x_prime[k], start.x_prime[k], size)) return false;
    }
    return true;
}

// The state of an answer at the maximum of the force.
State start_of(const Solution& solution) {
    State start;
    for (const Certified& x : solution.start->x) start.x.push_back(x.value);
    for (const Certified& v : solution.start->x_prime) start.x_prime.push_back(v.value);
    return start;
}

std::vector<OrbitGuess> guesses_near(const SceneSource& source) {
    std::optional<PeriodicOrbit> followed;
    return guesses_at(PreparedSystem{source}, source, followed);
}

void sample_by_reference(const SceneSource& asked_about, const Solution& solution, SampledSolution& all) {
    const ScenePaidFor paid(asked_about);
    const SceneSource& source = paid.source();
    const auto guesses = [&] { return guesses_near(source); };
    const auto states = tried([&] { return samples_by_reference(source, solution, all.tau, error_of_samples, guesses); });
    if (!states.value) throw PrecisionError(Why::samples_uncertain + states.why);
    all = SampledSolution(std::move(all.tau), *states.value);
}

// The motion in double, or by the reference where the answer needed it or double does not repeat it.
void sample_orbit(const SceneSource& source, const Solution& solution, SampledSolution& all) {
    if (solution.method.precision == "double") {
        const Scene<double>& scene = source->in_double();
        const ContactSystem system = contact_system(scene.system);
        ExactSolver solver(system, {*scene.r, *scene.beta, scene.mu});
        if (is_along_orbit(solver, start_of(solution), solution, all)) return;
    }
    sample_by_reference(source, solution, all);
}

// Each mass moves harmonically, and loses next to nothing.
void sample_stuck_masses(const std::vector<SolvedMass>& masses, SampledSolution& all) {
    evaluation::LinearSum motion{0, {}, {}, std::vector<double>(masses.size()), {}, {}, {}};
    for (const SolvedMass& m : masses) {
        const double amplitude = m.phase ? m.amplitude.value : 0, phase = m.phase ? m.phase->value : 0;
        motion.A.push_back(amplitude * elementary::cos(phase));
        motion.B.push_back(amplitude * elementary::sin(phase));
    }
    const std::size_t samples = all.tau.size();
    evaluation::even_samples(motion, {0, 2 * pi<double>() / static_cast<double>(samples), samples}, all.x.data(),
                             all.x_prime.data());
}

// Whether a phase is certain enough for the samples that were taken with it.
bool is_certain_enough(const Certified& phase, const Solution& solution, const std::vector<double>& x_prime) {
    for (std::size_t k = 0, N = solution.masses.size(); k < N; ++k) {
        const double allowed = solution.masses[k].amplitude.error + error_of_samples * solution.masses[k].amplitude.value;
        for (std::size_t n = k; n < x_prime.size(); n += N)
            if (phase.error * std::abs(x_prime[n]) > allowed) return false;
    }
    return true;
}

// By the closed form with the phase of the answer, or by the reference where a mass moves too fast for the digits of that phase.
void sample_sliding(const SceneSource& source, const Solution& solution, SampledSolution& all) {
    const std::optional<Certified>& phase =
        solution.between ? solution.between->phase : mass_of(solution, solution.contact).phase;
    if (!phase) return sample_by_reference(source, solution, all);
    constexpr int digits = 10;
    SampledClosedForm sampled = sampled_closed_form(source, phase->value, all.tau.size(), digits, !solution.regime.on_boundary);
    if (!sampled.found.numbers.X_j) throw PrecisionError({Why::motion_at_boundary, *source->in_double().beta});
    if (!is_certain_enough(*phase, solution, sampled.motion.x_prime)) return sample_by_reference(source, solution, all);
    all = std::move(sampled.motion);
}

} // namespace

SampledSolution::SampledSolution(std::size_t samples, int periods, std::size_t N)
    : tau(samples), x(samples * N), x_prime(samples * N) {
    const double period = 2 * pi<double>() * periods;
    for (std::size_t n = 0; n < samples; ++n) tau[n] = period * static_cast<double>(n) / static_cast<double>(samples);
}

SampledSolution::SampledSolution(std::vector<double> instants, const std::vector<State>& states) : tau(std::move(instants)) {
    for (const State& state : states) {
        x.insert(x.end(), state.x.begin(), state.x.end());
        x_prime.insert(x_prime.end(), state.x_prime.begin(), state.x_prime.end());
    }
}

State SampledSolution::at(std::size_t n) const {
    const auto N = static_cast<std::ptrdiff_t>(x.size() / tau.size()), from = static_cast<std::ptrdiff_t>(n) * N;
    return {{x.begin() + from, x.begin() + from + N}, {x_prime.begin() + from, x_prime.begin() + from + N}};
}

std::vector<State> SampledSolution::states() const {
    std::vector<State> all;
    for (std::size_t n = 0; n < tau.size(); ++n) all.push_back(at(n));
    return all;
}

Energies energies(const SceneSource& source, const Solution& solution, std::optional<int> digits) {
    if (solution.masses.empty() || solution.only || solution.asked != Asked::motion)
        throw InputError("energies", "must be of an answer to the question for the whole motion", "");
    const ScenePaidFor paid(source);
    return energies_by_reference(paid.source(), solution, digits.value_or(digits_by_default),
                                 [&] { return guesses_near(paid.source()); });
}

SampledSolution sampled_solution(const SceneSource& source, const Solution& solution, std::size_t samples) {
    const std::size_t N = number_of_masses(source->in_double().system);
    check_samples("samples", samples, N);
    SampledSolution all(samples, solution.periods, N);
    if (solution.method.proved)
        sample_by_reference(source, solution, all);
    else if (solution.start)
        sample_orbit(source, solution, all);
    else if (solution.rest_interval)
        sample_stuck_masses(solution.masses, all);
    else
        sample_sliding(source, solution, all);
    return all;
}

} // namespace denhartog
