// The masses at evenly spaced instants. Read `sampled_solution`: the closed form and the stuck response are
// recurrences, a motion with stops is followed from phase to phase, and where double does not have the digits the reference
// answers.
#include "denhartog/solve/sampled_solution.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/reference.hpp"
#include "denhartog/evaluation/even_samples.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/scene/limits.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/friction_motion.hpp"
#include "denhartog/solve/quantities.hpp"
#include "denhartog/solve/solve.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

using evaluation::ErrorOfSamples;
using Number = Bounded<double>;

// The error of a brace of (40) by those of its mode: errors of R and zeta are forces on it, by the energy of the free motion.
ErrorOfSamples error_of_brace(const ModeSums<Number>& s, std::size_t i) {
    const double R = s.R[i].least(), error_of_R = s.R[i].e / R, half_period = pi<double>();
    const double energy = 1 + s.g[i].most() + s.R[i].most() * s.u[i].most();
    const double force = 2 * half_period / (R * R) * energy * (s.zeta[i].e + s.zeta[i].most() * error_of_R + error_of_R);
    return {s.g[i].e + half_period * s.u[i].e + std::min(half_period, s.R[i].most()) * force, s.g[i].e / R + s.u[i].e + force};
}

// The motion of the masses over the half-period, and what the errors of its numbers make of it.
evaluation::LinearSum motion_of_masses(const ModeSums<Number>& s, std::size_t N, const Number& beta,
                                       std::vector<ErrorOfSamples>& errors) {
    const std::size_t n = s.R.size();
    evaluation::LinearSum motion{0, {}, {}, std::vector<double>(N), {}, {}, {}};
    std::vector<ErrorOfSamples> errors_of_braces;
    for (std::size_t i = 0; i < n; ++i) {
        motion.coordinates.push_back({s.R[i].x, s.zeta[i].x, s.w[i].x, 1, -s.g[i].x, -s.u[i].x});
        errors_of_braces.push_back(error_of_brace(s, i));
    }
    for (std::size_t k = 0; k < N; ++k) {
        const MassInMotion<Number> mass(s, k, beta);
        motion.A.push_back(mass.h.A.x);
        motion.B.push_back(mass.h.B.x);
        motion.harmonic.push_back(std::abs(mass.h.A.x) + std::abs(mass.h.B.x));
        ErrorOfSamples error{mass.h.A.e + mass.h.B.e, mass.h.A.e + mass.h.B.e};
        for (std::size_t i = 0; i < n; ++i) {
            const Number weight = beta * mass.weights[i];
            const double size = evaluation::largest_size(motion.coordinates[i], pi<double>());
            error.x += weight.e * size + weight.most() * errors_of_braces[i].x;
            error.x_prime += weight.e * size / s.R[i].least() + weight.most() * errors_of_braces[i].x_prime;
            motion.shapes.push_back(weight.x);
        }
        errors.push_back(error);
    }
    return motion;
}

// The period from half-period to half-period of x_j, each of which mirrors that before; so does half of the instants the other.
SampledSolution over_period(evaluation::LinearSum motion, double phi_j, std::size_t samples) {
    const std::size_t N = motion.A.size(), all = samples % 2 == 0 ? samples / 2 : samples;
    const double step = 2 * pi<double>() / static_cast<double>(samples);
    SampledSolution s(samples, 1, N);
    const auto mirror = [&] {
        for (std::vector<double>* numbers : {&motion.A, &motion.B, &motion.shapes})
            for (double& each : *numbers) each = -each;
    };
    if (phi_j > 0) mirror();
    double turn = phi_j > 0 ? phi_j - pi<double>() : phi_j; // the last of x_j until tau = 0
    for (std::size_t from = 0; from < all; turn += pi<double>(), mirror()) {
        const double first = step * static_cast<double>(from) - turn, left = std::ceil((pi<double>() - first) / step);
        const std::size_t count = std::min(all - from, static_cast<std::size_t>(std::max(0.0, left)));
        if (count > 0) evaluation::even_samples(motion, {first, step, count}, &s.x[from * N], &s.x_prime[from * N]);
        from += count;
    }
    for (std::vector<double>* numbers : {&s.x, &s.x_prime})
        for (std::size_t n = all * N; n < numbers->size(); ++n) (*numbers)[n] = -(*numbers)[n - all * N];
    return s;
}

// None where double does not tell.
std::optional<SampledClosedForm> in_double(const Scene<double>& scene, double phi_j, std::size_t samples, double tolerance,
                                           bool known_to_slide) {
    const auto basis = modes_with_errors(scene.system);
    if (basis->coupled()) return std::nullopt;
    const Number beta = as_input(*scene.beta);
    const ModeSums<Number> sums = bounded_sums(scene.system, *basis, as_input(*scene.r));
    SampledClosedForm all{{}, {}, {{}, {"closed form", "double", {}}}};
    Quantities<Number>& q = all.found.numbers;
    if (!known_to_slide) {
        q = quantities_in_double(scene, sums, {});
        if (!(std::abs(q.beta_lim.x - beta.x) > q.beta_lim.e)) return std::nullopt;
        if (!q.X_j) return all;
    }
    const SteadyState<Number> state = steady_state_without_maxima(sums, beta);
    q.X_j = state.X_j;
    std::vector<ErrorOfSamples> errors;
    evaluation::LinearSum motion = motion_of_masses(sums, number_of_masses(scene.system), beta, errors);
    const std::vector<ErrorOfSamples> lost =
        evaluation::loss_of_samples(motion, {0, 2 * pi<double>() / static_cast<double>(samples), samples / 2 + 1});
    for (std::size_t k = 0; k < errors.size(); ++k) {
        errors[k].x += lost[k].x;
        errors[k].x_prime += lost[k].x_prime;
        const double most = tolerance * state.masses[k].amplitude_monoharmonic.x;
        if (!(errors[k].x <= most && errors[k].x_prime <= most)) return std::nullopt;
    }
    all.errors = std::move(errors);
    all.motion = over_period(std::move(motion), phi_j, samples);
    return all;
}

constexpr double most_lost_to_rounding = error_of_samples / 1024; // of the amplitude of a mass, where a motion has stops

// Stops over a period; one that lasts beyond its end is the first.
std::size_t stops_in(const std::vector<Phase>& phases) {
    const auto rests = [](const Phase& p) { return p.direction == 0 && p.end > p.start; };
    const auto stops = static_cast<std::size_t>(std::ranges::count_if(phases, rests));
    return stops > 1 && rests(phases.front()) && rests(phases.back()) ? stops - 1 : stops;
}

// Follows the motion of an answer over its period, in double. False where double does not have the digits: the motion does not
// come back to its start, by `error_of_samples` of each amplitude and speed, or has other stops than the answer.
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
    const Tried<std::vector<State>> states = samples_by_reference(source, solution, all.tau, error_of_samples, guesses);
    if (!states.is_answered()) throw PrecisionError(Why::samples_uncertain + states.why, states.outcome);
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

// True of a phase that is certain enough for the samples that were taken with it.
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

SampledClosedForm sampled_closed_form(const SceneSource& source, double phi_j, std::size_t samples, int digits,
                                      bool known_to_slide) {
    const Scene<double>& scene = source->in_double();
    if (digits >= 1 && digits <= most_digits_in_double) { // else, and where it is refused, `quantities` asks the reference
        auto seen = tried([&] { return in_double(scene, phi_j, samples, aim_of(digits).tolerance, known_to_slide); });
        if (seen.is_answered() && *seen.value) return **std::move(seen.value);
    }
    std::vector<double> tau = SampledSolution(samples, 1, 0).tau;
    for (double& instant : tau) instant -= phi_j;
    SampledClosedForm all{{}, {}, quantities(source, tau, digits, PointNumbers::motion)};
    const Quantities<Number>& q = all.found.numbers;
    if (!q.X_j) return all;
    all.motion = SampledSolution(samples, 1, q.x_size.size());
    const auto value = [](const Number& x) { return x.x; };
    std::ranges::transform(q.x, all.motion.x.begin(), value);
    std::ranges::transform(q.x_prime, all.motion.x_prime.begin(), value);
    return all;
}

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
