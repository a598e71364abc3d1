#include <algorithm>

#include "denhartog/answer/held_solution.hpp"
#include "denhartog/answer/orbit_solution.hpp"
#include "denhartog/model/coordinates.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/solve/orbit_in_50_digits.hpp"
#include "denhartog/solve/solve_task.hpp"

namespace denhartog {
namespace {

double relative_error(const SolveTask& task, const OrbitSolution& solution) {
    if (task.question.asked == Asked::amplitude) return solution.relative_amplitude;
    return std::max(solution.relative_amplitude, solution.phase_error);
}

template <class T>
void write_orbit(const SolveTask& task, ExactSolver<T>& solver, const PeriodicOrbit<T>& orbit, OrbitSolution solution,
                 Solution& s) {
    const auto all = [&](std::vector<T> numbers, const auto& error) {
        std::vector<Certified> out;
        add_displacements(solver.system().coordinates, numbers);
        for (std::size_t k = 0; k < numbers.size(); ++k)
            out.push_back(certified(Bounded<T>(numbers[k], error(k)), task.aim.digits));
        return out;
    };
    s.relative_error = relative_error(task, solution);
    s.masses = std::move(solution.masses);
    s.stops = std::move(solution.stops);
    s.start = SolvedState{all(orbit.start.x, [&](std::size_t) { return orbit.error_bound; }),
                          all(orbit.start.x_prime, [&](std::size_t k) { return orbit.velocity_errors[k]; })};
    s.periods = orbit.periods;
    s.symmetric = orbit.symmetric;
    if (task.question.asked == Asked::motion) s.stability = stability_of(orbit);
}

void orbit_in_50_digits(const SolveTask& task, const PeriodicOrbit<double>& near, Solution& s) {
    const OrbitSearch<Real50> how{.contact_only = task.question.mass == task.scene.system.contact,
                                  .with_stability = task.question.asked == Asked::motion};
    find_in_50_digits(task.source, near, how, [&](ExactSolver<Real50>& solver, const PeriodicOrbit<Real50>& orbit) {
        write_orbit(task, solver, orbit, orbit_solution(solver, orbit, task.aim.digits, task.question.mass), s);
    });
}

// From double to 50 digits Newton's method takes two steps, each over the orbit, and then the orbit is looked at. In chains of 1 to 60
// masses it came to 9 to 15 times what it takes to follow the orbit once. Where that is not allowed, nothing is begun.
void require_effort(const PeriodicOrbit<double>& orbit, std::size_t N) {
    constexpr long times = 8;
    const long needed = times * orbit.effort_in_50_digits, left = SearchEffort(default_effort(N)).left();
    if (needed > left)
        throw PrecisionError("finding the motion takes some " + std::to_string(needed) + " operations, and " +
                             std::to_string(left) + " are left of the work allowed");
}

// The effort is spent, and with it the way to know whether a motion stops that double does not see stop.
void require_known_stops(const SolveTask& task, const PrecisionError& e, const Solution& s) {
    if (QuestionEffort::exhausted() && !must_stop(task, s))
        throw PrecisionError(std::string("double does not tell whether the contact stops, and ") + e.what() +
                             ". This much is certain: " + s.regime.reason);
}

} // namespace

bool must_stop(const SolveTask& task, const Solution& s) {
    return s.regime.regime == Regime::stick_slip && (task.scene.mu == 1 || every_motion_is_damped(*task.known.basis));
}

void answer_by_stuck_response(const SolveTask& task, const std::optional<Certified>& rests_at, Solution& s) {
    const auto attempt = [&]<class T>(std::type_identity<T>) {
        HeldSolution held;
        if constexpr (std::same_as<T, double>) {
            const std::shared_ptr<const ContactSystem<T>> moving =
                task.moving ? task.moving : moving_in_double(task.source, task.known);
            held = held_solution(task.scene, moving->stuck, *task.known.basis, task.aim.digits, task.question.mass);
        } else {
            const Scene<T> scene = scene_in<T>(task.source);
            const ModalBasis<T> basis = modal_basis(scene.system);
            held = held_solution(scene, stuck_configuration(scene.system, basis), with_errors(scene.system, basis),
                                 task.aim.digits, task.question.mass);
        }
        s.masses = held.masses;
        s.rest_interval = held.rest_interval;
        s.rest_interval->rests_at = rests_at;
        s.sticking_by_88 = held.sticking_by_88;
        return Attempted{held.relative};
    };
    const Certainty found = certify(task.aim, attempt);
    s.method = {"stuck response", name(found.precision),
                "its residual in the equations of motion bounds the error: " + found.why};
    s.relative_error = found.relative;
}

std::optional<std::size_t> stops_in_50_digits(const SolveTask& task, const PeriodicOrbit<double>& orbit, const Solution& s) {
    std::optional<std::size_t> stops;
    if (highest_precision(task.aim, number_of_masses(task.scene.system)) == Precision::in_double) return stops;
    try {
        find_in_50_digits(task.source, orbit, {.contact_only = true, .with_stability = false},
                          [&](const auto&, const PeriodicOrbit<Real50>& found) { stops = found.stops.size(); });
    } catch (const PrecisionError& e) {
        require_known_stops(task, e, s);
    }
    return stops;
}

void answer_by_orbit_in_50_digits(const SolveTask& task, ExactSolver<Real50>& solver, const PeriodicOrbit<Real50>& orbit,
                                  Solution& s) {
    write_orbit(task, solver, orbit, orbit_solution(solver, orbit, task.aim.digits, task.question.mass), s);
    s.method = {"exact solver", name(Precision::in_50_digits),
                "its residual bounds the error: " + verdict({s.relative_error}, task.aim)};
}

void answer_by_orbit(const SolveTask& task, ExactSolver<double>& solver, const PeriodicOrbit<double>& orbit, bool open,
                     Solution& s) {
    const OrbitSolution in_double = orbit_solution(solver, orbit, task.aim.digits, task.question.mass);
    const double error = relative_error(task, in_double);
    const std::size_t N = number_of_masses(task.scene.system);
    const auto attempt = [&]<class T>(std::type_identity<T>) {
        if constexpr (std::same_as<T, double>)
            write_orbit(task, solver, orbit, in_double, s);
        else if constexpr (std::same_as<T, Real50>) {
            if (!open) require_effort(orbit, N);
            orbit_in_50_digits(task, orbit, s);
        }
        return Attempted{s.relative_error, !open || std::same_as<T, Real50>, "double does not tell whether the contact stops"};
    };
    s.method.model = "exact solver";
    try {
        const Certainty found = certify(task.aim, attempt, highest_precision(task.aim, N, Precision::in_50_digits));
        s.method.precision = name(found.precision);
        s.method.why = "its residual bounds the error: " + found.why;
    } catch (const PrecisionError& e) {
        if (task.question.digits)
            throw PrecisionError("the exact solver does not reach the " + in_words(task.aim) + ": double precision gives " +
                                 std::to_string(digits_of(error)) + ", and 50 digits give at most " +
                                 std::to_string(most_digits_in(Precision::in_50_digits)) + "; " + e.what());
        if (open) require_known_stops(task, e, s);
        write_orbit(task, solver, orbit, in_double, s);
        s.method.precision = name(Precision::in_double);
        s.method.why = "its residual bounds the error: " + verdict({error}, task.aim) + "; in 50 digits: " + e.what();
    }
}

} // namespace denhartog
