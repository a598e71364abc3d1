#include "denhartog/solve/decision.hpp"

#include <algorithm>
#include <utility>

#include "denhartog/answer/from_ground.hpp"
#include "denhartog/answer/held_solution.hpp"
#include "denhartog/answer/orbit_solution.hpp"

namespace denhartog {
namespace {

// Numbers of the state of an orbit with their errors, that of the contact behind those of the masses where it has a row of its own.
std::vector<Certified> certified_of(std::vector<double> numbers, const ExactSolver& solver, const auto& error) {
    std::vector<Certified> out;
    solver.system().stuck.contact.append(numbers);
    for (std::size_t k = 0; k < numbers.size(); ++k) out.push_back({numbers[k], error(k), {}});
    return out;
}

} // namespace

SceneSource source_at(const PreparedSystem& p, const SolvePoint& at) {
    const SceneSource source = at.source != nullptr ? *at.source : at_point(p.source, at.r, at.beta);
    return at.effort != nullptr ? with_effort(source, at.effort) : source;
}

bool answer_by_contact(const PreparedSystem& p, const SolvePoint& at, const Question& question, Solution& s) {
    if (!p.contact || !asks_for_contact(question, p.scene().system)) return false;
    const Aim aim = aim_of(question.digits);
    if (aim.digits > most_digits_in_double) return false;
    const auto contact = tried([&] { return contact_solution(*p.contact, as_input(at.r), as_input(at.beta)); });
    if (!contact.value || !*contact.value) return false; // the next model says where a pole is
    const ContactSolution& found = **contact.value;
    const double relative = found.amplitude.e / found.amplitude.x;
    const Attempted attempted{question.asked == Asked::phase ? std::max(relative, found.phase.e) : relative};
    if (!is_settled(attempted, aim)) return false;
    s.r = exactly(at.r);
    s.beta = exactly(at.beta);
    s.slides_below = exactly(found.slides_below.x * (1 - aim.tolerance)); // its rounding must not raise it
    s.masses = {{certified(found.amplitude), certified(found.phase), std::nullopt}};
    s.method = {"closed form", "double", verdict(attempted, aim)};
    s.relative_error = attempted.relative;
    s.contact = p.scene().system.contact;
    s.only = s.contact;
    s.regime = {Regime::continuous, {}, false, Why::certainly_slides};
    return true;
}

bool must_stop(const SolveTask& task, const Solution& s) {
    return s.regime.regime == Regime::stick_slip && (task.scene.mu == 1 || every_motion_is_damped(*task.known.basis));
}

void answer_by_stuck_response(const SolveTask& task, const std::optional<Certified>& rests_at, Solution& s) {
    const std::shared_ptr<const ContactSystem> moving = task.moving ? task.moving : moving_in_double(task.source, task.known);
    const HeldSolution held = held_solution(task.scene, moving->stuck, *task.known.basis, task.question.mass);
    s.masses = held.masses;
    s.from_ground = held.from_ground;
    s.rest_interval = held.rest_interval;
    s.rest_interval->rests_at = rests_at;
    s.sticking_by_88 = held.sticking_by_88;
    s.method = {"stuck response", "double", Why::bound_by_equations + verdict({held.relative}, task.aim)};
    s.relative_error = held.relative;
}

void answer_by_orbit(const SolveTask& task, ExactSolver& solver, const PeriodicOrbit& orbit, bool open, Solution& s) {
    const bool all = task.question.asked == Asked::motion && !task.question.mass;
    const Bounded<double> frame = amplitude_of_frame(task.scene);
    OrbitSolution found = orbit_solution(solver, orbit, task.question.mass, all ? frame.x : 0);
    s.masses = std::move(found.masses);
    s.from_ground.clear();
    const bool absolute = task.scene.system.base_motion == BaseMotion::alone; // as they are
    const std::vector<SolvedMass>& seen = absolute ? s.masses : found.from_ground;
    for (std::size_t k = 0; all && k < std::min(seen.size(), number_of_masses(task.scene.system)); ++k)
        s.from_ground.push_back(from_ground(seen[k], absolute ? Bounded<double>(1) : frame));
    s.stops = std::move(found.stops);
    s.start = SolvedState{certified_of(orbit.start.x, solver, [&](std::size_t) { return orbit.error_bound; }),
                          certified_of(orbit.start.x_prime, solver, [&](std::size_t k) { return orbit.velocity_errors[k]; })};
    s.periods = orbit.periods;
    s.symmetric = orbit.symmetric;
    if (task.question.asked == Asked::motion) s.stability = stability_of(orbit);
    s.relative_error = task.question.asked == Asked::amplitude ? found.relative_amplitude
                                                               : std::max(found.relative_amplitude, found.phase_error);
    const Attempted attempted{s.relative_error, !open, Why::stops_open};
    s.method = {"exact solver", "double", Why::bound_by_residual + verdict(attempted, task.aim)};
}

} // namespace denhartog
