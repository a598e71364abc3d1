#include <algorithm>

#include "denhartog/number/errors.hpp"
#include "denhartog/solve/held_solution.hpp"
#include "denhartog/solve/orbit_solution.hpp"
#include "denhartog/solve/solve_task.hpp"

namespace denhartog {
namespace {

constexpr int most_digits_in_double = 14;
constexpr int most_digits_of_orbit = 45;

template <class T>
void write_held(const SolveTask& task, const HeldSolution<T>& held, std::optional<double> rests_at, const std::string& why,
                Solution& s) {
    Solved<T> numbers = numbers_with_boundary<T>(task, s);
    numbers.masses = held.masses;
    numbers.rest_interval = held.rest_interval;
    if (rests_at) numbers.rest_interval->rests_at = T(*rests_at);
    numbers.sticking_by_88 = held.sticking_by_88;
    s.numbers = std::move(numbers);
    s.method = {"stuck response", precision_of<T>(), why};
    s.relative_error = held.relative;
}

template <class T>
double relative_error(const SolveTask& task, const OrbitSolution<T>& solution) {
    if (task.question.asked == Asked::amplitude) return solution.relative_amplitude;
    return std::max(solution.relative_amplitude, solution.phase_error);
}

template <class T>
void write_orbit(const SolveTask& task, const PeriodicOrbit<T>& orbit, const OrbitSolution<T>& solution, const std::string& why,
                 Solution& s) {
    Solved<T> numbers = numbers_with_boundary<T>(task, s);
    numbers.masses = solution.masses;
    numbers.stops = orbit.stops;
    numbers.start = orbit.start;
    s.numbers = std::move(numbers);
    s.method = {"exact solver", precision_of<T>(), why};
    if (!orbit.reason.empty()) s.regime.reason += "; " + orbit.reason;
    s.relative_error = relative_error(task, solution);
    s.periods = orbit.periods;
    s.symmetric = orbit.symmetric;
    if (task.question.asked == Asked::motion) s.stability = stability_of(orbit);
}

// The same orbit in 50 digits; its stability is that of double.
bool answer_in_50_digits(const SolveTask& task, const PeriodicOrbit<double>& near, const std::string& before, Solution& s) {
    const Scene<Real50> scene = task.source.in_50_digits();
    const ContactSystem<Real50> system = contact_system(scene.system);
    ExactSolver<Real50> solver(system, {*scene.r, *scene.beta, scene.mu});
    State<Real50> start;
    start.x.assign(near.start.x.begin(), near.start.x.end());
    start.x_prime.assign(near.start.x_prime.begin(), near.start.x_prime.end());
    OrbitSearch<Real50> how;
    how.periods_before = near.periods;
    how.follow_start = false;
    how.with_stability = false;
    how.contact_only = task.question.mass == system.contact;
    PeriodicOrbit<Real50> orbit = periodic_orbit(solver, start, how);
    if (orbit.status != OrbitStatus::periodic || orbit.periods != near.periods || orbit.symmetric != near.symmetric ||
        orbit.stops.size() != near.stops.size())
        return false;
    const OrbitSolution<Real50> solution = orbit_solution(solver, orbit, task.question.mass);
    if (!(relative_error(task, solution) <= task.tolerance)) return false;
    orbit.multipliers = near.multipliers;
    orbit.stable = near.stable;
    write_orbit(task, orbit, solution, before + "in 50 digits it has the " + task.aim, s);
    return true;
}

} // namespace

void answer_by_stuck_response(const SolveTask& task, std::optional<double> rests_at, Solution& s) {
    if (task.wanted <= most_digits_in_double && !task.scene.system.damping_ratios.empty()) {
        const HeldSolution<double> held =
            held_solution(task.scene, task.moving ? task.moving->stuck : stuck_configuration(task.scene.system, task.basis),
                          task.question.mass);
        if (held.relative <= task.tolerance)
            return write_held(task, held, rests_at,
                              "what it leaves over in the equations of motion bounds its error: it has the " + task.aim, s);
    }
    if (task.wanted <= most_digits_in_double) {
        const HeldSolution<double> held = held_solution(task.scene, task.source.in_50_digits(), task.question.mass);
        if (held.relative <= task.tolerance)
            return write_held(task, held, rests_at, "checked in 50 digits: it has the " + task.aim, s);
    }
    const HeldSolution<Real50> held = held_solution(task.source.in_50_digits(), task.source.in_100_digits(), task.question.mass);
    const std::string verdict = held.relative <= task.tolerance ? "it has the " : "it has not the ";
    write_held(task, held, rests_at, "checked in 100 digits: " + verdict + task.aim, s);
}

void answer_by_orbit(const SolveTask& task, ExactSolver<double>& solver, const PeriodicOrbit<double>& orbit,
                     const std::string& followed, Solution& s) {
    const OrbitSolution<double> solution = orbit_solution(solver, orbit, task.question.mass);
    const double error = relative_error(task, solution);
    if (task.wanted <= most_digits_in_double && error <= task.tolerance)
        return write_orbit(task, orbit, solution, followed + "the residual bounds the error: it has the " + task.aim, s);
    const std::string sure = std::to_string(digits_of(error));
    const std::string before = followed + "in double " + sure + " digits are sure; ";
    if (task.wanted <= most_digits_of_orbit && answer_in_50_digits(task, orbit, before, s)) return;
    if (task.question.digits)
        throw PrecisionError("the " + task.aim + " are not reached by the exact solver, which has at most " +
                             std::to_string(most_digits_of_orbit) + ": in double " + sure + " are sure");
    write_orbit(task, orbit, solution, before + "it has not the " + task.aim, s);
}

} // namespace denhartog
