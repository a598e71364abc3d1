#include "denhartog/solve/solve.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/model/point_rules.hpp"
#include "denhartog/number/errors.hpp"
#include "denhartog/solve/orbit_solution.hpp"
#include "denhartog/solve/other_motions.hpp"
#include "denhartog/solve/solve_task.hpp"

namespace denhartog {
namespace {

Work work_so_far() { return {eigen_solves(), mode_evaluations(), phases_propagated()}; }

void say_whether_unique(const std::vector<double>& damping_ratios, double mu, Solution& s) {
    const bool damped = std::ranges::all_of(damping_ratios, [](double zeta) { return zeta > 0; });
    s.unique = mu == 1 && damped;
    if (s.unique)
        s.unique_because =
            "mu = 1 and every mode is damped: the velocities of any two motions under the same force become the same";
    else if (mu > 1)
        s.unique_because = "not known: with mu > 1 the motion may depend on the start; this is the one from rest";
    else
        s.unique_because = "not known: a mode has no damping, and the motion may depend on the start";
}

// Whether an orbit is the sliding motion of the closed form.
bool is_closed_form(const SolveTask& task, const PeriodicOrbit<double>& orbit) {
    return std::visit(
        [&](const auto& response) {
            if (!response.steady_state || !orbit.stops.empty() || !orbit.symmetric || orbit.periods != 1) return false;
            const double X_j = static_cast<double>(response.steady_state->X_j);
            return std::abs(orbit.contact.amplitude - X_j) <= 16 * orbit.error_bound + 1e-9 * X_j;
        },
        task.found.response);
}

// The regime that was met; the one that the boundaries have instead, which then exists besides at mu > 1.
void set_regime(const SolveTask& task, Regime met, const std::string& reason, Solution& s) {
    if (!task.pole && s.regime.regime != met) {
        std::erase(s.regime.other, met);
        if (s.regime.regime == Regime::continuous) s.regime.other.push_back(s.regime.regime);
    }
    s.regime.regime = met;
    if (task.scene.mu > 1 || task.pole || met == Regime::continuous) s.regime.reason += "; " + reason;
}

// The motion from rest by the exact solver; the closed form or the stuck response give the numbers where it leads there.
void answer_from_rest(const SolveTask& task, const std::string& followed, Solution& s) {
    const bool regime_alone = task.question.asked == Asked::regime;
    const std::shared_ptr<const ContactSystem<double>> moving =
        task.moving ? task.moving : std::make_shared<const ContactSystem<double>>(contact_system(task.scene.system));
    const ContactSystem<double>& system = *moving;
    ExactSolver<double> solver(system, {*task.scene.r, *task.scene.beta, task.scene.mu});
    OrbitSearch<double> how;
    how.contact_only = regime_alone || task.question.mass == system.contact;
    how.with_stability = task.question.asked == Asked::motion;
    const PeriodicOrbit<double> orbit = periodic_orbit(solver, at_rest<double>(task.basis.r_n.size()), how);
    if (orbit.status == OrbitStatus::not_converged) {
        if (task.pole) throw DomainError(*task.pole + "; " + orbit.reason);
        throw PrecisionError("no steady motion was found from the start from rest: " + orbit.reason);
    }
    const bool rests = orbit.status == OrbitStatus::permanently_stuck;
    const bool slides = !task.pole && !rests && is_closed_form(task, orbit);
    if (rests)
        set_regime(task, Regime::permanent_sticking, "from the start from rest " + orbit.reason, s);
    else if (slides)
        set_regime(task, Regime::continuous, "the motion from rest is the sliding motion", s);
    else if (orbit.stops.empty())
        set_regime(task, Regime::continuous, "the contact does not stop, but the motion is not that of the closed form", s);
    else
        set_regime(task, Regime::stick_slip, "the contact stops in every period", s);
    if (regime_alone) return answer_by_boundaries(task, "boundaries and exact solver", followed, s);
    if (!rests && !slides) return answer_by_orbit(task, solver, orbit, followed, s);
    if (slides)
        answer_by_closed_form(task, s);
    else
        answer_by_stuck_response(task, orbit.start.x[system.contact.index], s);
    s.method.why = followed + s.method.why;
    if (task.question.asked == Asked::motion) s.stability = stability_of(orbit);
}

void climb(SolveTask& task, Solution& s) {
    const bool alone = task.question.asked == Asked::regime;
    const bool few = task.question.asked == Asked::amplitude || task.question.asked == Asked::phase;
    if (few && task.scene.mu == 1 && !task.contact_tried && answer_by_few_modes(task, s)) return;
    find_boundary(task);
    const std::string followed = "the start from rest was followed; ";
    if (task.pole) {
        s.regime.reason = "the boundaries are not known: " + *task.pole;
        return answer_from_rest(task, followed, s);
    }
    s.regime = std::visit([](const auto& response) { return *response.regime; }, task.found.response);
    if (task.scene.mu > 1 && *task.scene.beta > 0) return answer_from_rest(task, followed, s);
    if (alone) return answer_by_boundaries(task, "boundaries", "", s);
    switch (s.regime.regime) {
    case Regime::continuous: return answer_by_closed_form(task, s);
    case Regime::permanent_sticking: return answer_by_stuck_response(task, std::nullopt, s);
    case Regime::stick_slip: return answer_from_rest(task, s.unique ? "" : followed, s);
    }
}

// Of all masses the one that was asked about.
template <class Numbers>
void keep(const Mass& mass, Numbers& numbers) {
    if (numbers.masses.empty()) return;
    numbers.masses = {numbers.masses[mass.index]};
    numbers.only = mass;
}

void keep_asked_mass(const Question& question, Solution& s) {
    if (!question.mass) return;
    std::visit(
        [&](auto& numbers) {
            if (!numbers.only) keep(*question.mass, numbers);
        },
        s.numbers);
    for (OtherMotion& motion : s.motions) motion.masses = {motion.masses[question.mass->index]};
}

Solution solve_at(const PreparedSystem& p, const SolvePoint& at, const Question& question, const Work& before) {
    Solution s;
    s.asked = question.asked;
    if (answer_by_contact(p, at, question, s)) {
        say_whether_unique(p.scene.system.damping_ratios, p.scene.mu, s);
    } else {
        SolveTask task = solve_task(p, at, question);
        say_whether_unique(task.basis.zeta, p.scene.mu, s);
        climb(task, s);
        if (question.digits && !(s.relative_error <= task.tolerance))
            throw PrecisionError("the " + task.aim + " are not reached, only " + std::to_string(digits_of(s.relative_error)) +
                                 " are sure");
        if (question.all) s.motions = other_motions(task.scene);
        keep_asked_mass(question, s);
    }
    const Work after = work_so_far();
    s.work = {after.eigen_solves - before.eigen_solves, after.mode_evaluations - before.mode_evaluations,
              after.phases_propagated - before.phases_propagated};
    return s;
}

} // namespace

Solution solve(const SceneSource& source, const Question& question) {
    const Work before = work_so_far();
    const PreparedSystem p = prepare(source, question);
    if (!p.scene.r) throw InputError("r", "must be given", "nothing");
    if (!p.scene.beta) throw InputError("beta", "must be given", "nothing");
    return solve_at(p, {*p.scene.r, *p.scene.beta, &source}, question, before);
}

Solution solve(const PreparedSystem& system, double r, double beta, const Question& question) {
    check(question, number_of_masses(system.scene.system));
    check_frequency_ratio(r);
    check_friction_ratio(beta);
    return solve_at(system, {r, beta, nullptr}, question, work_so_far());
}

} // namespace denhartog
