#include <algorithm>

#include "denhartog/answer/held_solution.hpp"
#include "denhartog/answer/orbit_solution.hpp"
#include "denhartog/solve/solve_task.hpp"

namespace denhartog {
namespace {

double relative_error(const SolveTask& task, const OrbitSolution& solution) {
    if (task.question.asked == Asked::amplitude) return solution.relative_amplitude;
    return std::max(solution.relative_amplitude, solution.phase_error);
}

void write_orbit(const SolveTask& task, ExactSolver& solver, const PeriodicOrbit& orbit, OrbitSolution solution, Solution& s) {
    const auto all = [&](std::vector<double> numbers, const auto& error) {
        std::vector<Certified> out;
        solver.system().stuck.contact.append(numbers);
        for (std::size_t k = 0; k < numbers.size(); ++k) out.push_back({numbers[k], error(k), {}});
        return out;
    };
    s.masses = std::move(solution.masses);
    s.stops = std::move(solution.stops);
    s.start = SolvedState{all(orbit.start.x, [&](std::size_t) { return orbit.error_bound; }),
                          all(orbit.start.x_prime, [&](std::size_t k) { return orbit.velocity_errors[k]; })};
    s.periods = orbit.periods;
    s.symmetric = orbit.symmetric;
    if (task.question.asked == Asked::motion) s.stability = stability_of(orbit);
}

} // namespace

bool must_stop(const SolveTask& task, const Solution& s) {
    return s.regime.regime == Regime::stick_slip && (task.scene.mu == 1 || every_motion_is_damped(*task.known.basis));
}

void answer_by_stuck_response(const SolveTask& task, const std::optional<Certified>& rests_at, Solution& s) {
    const std::shared_ptr<const ContactSystem> moving = task.moving ? task.moving : moving_in_double(task.source, task.known);
    const HeldSolution held = held_solution(task.scene, moving->stuck, *task.known.basis, task.question.mass);
    s.masses = held.masses;
    s.rest_interval = held.rest_interval;
    s.rest_interval->rests_at = rests_at;
    s.sticking_by_88 = held.sticking_by_88;
    s.method = {"stuck response", "double",
                "its residual in the equations of motion bounds the error: " + verdict({held.relative}, task.aim)};
    s.relative_error = held.relative;
}

void answer_by_orbit(const SolveTask& task, ExactSolver& solver, const PeriodicOrbit& orbit, bool open, Solution& s) {
    const OrbitSolution found = orbit_solution(solver, orbit, task.question.mass);
    write_orbit(task, solver, orbit, found, s);
    s.relative_error = relative_error(task, found);
    const Attempted attempted{s.relative_error, !open, "double does not tell whether the contact stops"};
    s.method = {"exact solver", "double", "its residual bounds the error: " + verdict(attempted, task.aim)};
}

} // namespace denhartog
