#include "denhartog/solve/solve.hpp"

#include <algorithm>
#include <utility>

#include "denhartog/answer/from_ground.hpp"
#include "denhartog/answer/held_solution.hpp"
#include "denhartog/answer/orbit_solution.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/scene/converted.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/solve/decision.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {
namespace {

Work work_so_far() { return {eigen_solves(), mode_evaluations(), phases_propagated()}; }

Solution with_work_since(const Work& before, Solution s) {
    const Work after = work_so_far();
    s.work = {after.eigen_solves - before.eigen_solves, after.mode_evaluations - before.mode_evaluations,
              after.phases_propagated - before.phases_propagated};
    return s;
}

void set_regime(const SolveTask& task, Regime met, const Reasons& reason, Solution& s) {
    if (!task.unknown.empty())
        s.regime.regime = met;
    else
        take_regime(met, s.regime);
    if (task.scene.mu > 1 || !task.unknown.empty() || met == Regime::continuous) s.regime.reason += reason;
}

// What the stops of a motion that is not the closed form's say. `open`: double does not tell whether it stops.
void set_regime_by_stops(const SolveTask& task, const PeriodicOrbit& orbit, bool open, Solution& s) {
    const bool must = orbit.stops.empty() && must_stop(task, s);
    if (!orbit.stops.empty()) {
        const bool slides = task.unknown.empty() && s.regime.regime == Regime::continuous; // a motion that does, besides
        set_regime(task, Regime::stick_slip, slides ? Why::rest_leads_to_stops : Why::stops, s);
    } else if (must) {
        s.regime.reason += {Why::no_stop_seen, orbit.error_bound};
    } else if (open) {
        s.regime.reason += Why::stops_open;
    } else {
        const bool known = task.unknown.empty(), sliding = known && every_motion_is_damped(*task.known.basis);
        set_regime(task, Regime::continuous,
                   sliding                 ? Why::rest_leads_to_sliding
                   : known || task.at_pole ? Why::slides_otherwise
                                           : Why::does_not_stop,
                   s);
    }
}

void answer_by_boundaries(SolveTask& task, const std::string& model, Solution& s) {
    s.masses.clear();
    s.from_ground.clear();
    s.method.model = model;
    s.sticking_by_88 = sticking_by_88(task.scene);
    if (!s.sticking_by_88) return;
    const Bounded<double> by_88(s.sticking_by_88->value, s.sticking_by_88->error);
    s.relative_error = std::max(s.relative_error, relative_error(by_88));
}

// What a fast mode costs the exact solver, which follows it, if that is much.
Reasons cost_of_fast_mode(const ExactSolver& solver, const PeriodicOrbit& none) {
    constexpr double fast = 1000;
    const double fastest = solver.highest_over_force();
    if (!(fastest > fast) || !none.more_digits_may_tell) return {};
    return {Why::fast_mode, fastest};
}

[[noreturn]] void fail_from_rest(const SolveTask& task, const Reasons& why, const Solution& s) {
    if (task.at_pole) throw DomainError(task.unknown + why);
    throw PrecisionError(Why::none_from_rest + why + Why::certain + s.regime.reason);
}

// The steady motion of a regime that the boundaries tell, where the one from rest is not known. A sliding motion is in `s` already.
void answer_by_regime(SolveTask& task, Solution& s) {
    if (task.question.asked == Asked::regime) return answer_by_boundaries(task, "boundaries", s);
    if (s.regime.regime == Regime::permanent_sticking) answer_by_stuck_response(task, std::nullopt, s);
}

// The motion from rest by the exact solver; the closed form or the stuck response give the numbers where it leads there. With
// mu = 1 and damping all starts lead to one motion; with mu above 1 rest mostly leads to the sliding motion if there is one.
void answer_from_rest(SolveTask& task, Solution& s) {
    if (!task.moving) task.moving = moving_in_double(task.source, task.known);
    const ContactSystem& system = *task.moving;
    const bool told = task.unknown.empty() && !s.regime.on_boundary, sticks = s.regime.regime == Regime::stick_slip;
    if (!system.rounded_because.empty()) {
        if (!told || sticks) fail_from_rest(task, system.rounded_because, s);
        s.not_from_rest = system.rounded_because;
        return answer_by_regime(task, s);
    }
    const bool regime_alone = task.question.asked == Asked::regime;
    ExactSolver solver(system, {*task.scene.r, *task.scene.beta, task.scene.mu});
    OrbitSearch how;
    how.contact_only = regime_alone || task.question.mass == system.contact;
    how.with_stability = task.question.asked == Asked::motion;
    how.effort = task.source->effort;
    State near;
    if (task.unknown.empty() && s.regime.regime == Regime::continuous) {
        near = sliding_at_maximum_of_force(
            values_of(bounded_sums(task.scene.system, *task.known.basis, as_input(*task.scene.r), task.source->effort)),
            *task.scene.beta);
        how.guess = &near;
    }
    const PeriodicOrbit& orbit = task.orbit.emplace(periodic_orbit(solver, at_rest(system.basis.r_n.size()), how));
    if (!is_from_start(orbit)) {
        const bool found = orbit.status == OrbitStatus::not_from_start;
        s.not_from_rest = orbit.reason + cost_of_fast_mode(solver, orbit);
        const bool by_regime = told && (s.regime.regime == Regime::continuous || !(found || sticks));
        if (by_regime && !is_exhausted(task.source->effort)) return answer_by_regime(task, s);
        if (!found) fail_from_rest(task, s.not_from_rest, s);
    }
    const bool rests = orbit.status == OrbitStatus::permanently_stuck;
    // With mu = 1 the boundaries tell that it never rests for ever: only rounding does not see it move.
    if (rests && task.scene.mu == 1 && told && sticks)
        throw PrecisionError(Reasons(Why::moves_too_little) + Why::certain + s.regime.reason);
    const bool slides = task.unknown.empty() && !rests && !s.masses.empty() &&
                        (must_be_sliding_motion(orbit, every_motion_is_damped(*task.known.basis)) ||
                         is_sliding_motion(orbit, s.masses[system.contact.index].amplitude.value));
    if (rests) {
        set_regime(task, Regime::permanent_sticking, Why::from_the_start + orbit.reason, s);
    } else if (slides && orbit.stops.empty()) {
        set_regime(task, Regime::continuous, Why::rest_leads_to_sliding, s);
    } else {
        const bool open = task.unknown.empty() && stops_are_open(orbit, s.regime.regime == Regime::stick_slip,
                                                                 orbit.stops.empty() && must_stop(task, s), slides);
        task.regime_is_certain = !open || must_stop(task, s);
        if (!regime_alone) answer_by_orbit(task, solver, orbit, open, s);
        set_regime_by_stops(task, orbit, open, s);
        task.open = task.open || open;
        if (!regime_alone) {
            if (s.not_from_rest.empty()) s.regime.reason += orbit.reason;
            return;
        }
    }
    if (regime_alone) {
        answer_by_boundaries(task, "boundaries and exact solver", s);
        return;
    }
    if (rests) answer_by_stuck_response(task, place_of_rest(orbit), s);
    if (task.question.asked == Asked::motion) s.stability = stability_of(orbit);
}

void answer(SolveTask& task, Solution& s) {
    Tried<Solution> sliding = tried([&] {
        return sliding_solution(task.source, {task.question.asked, task.question.digits, task.question.mass, task.known.basis});
    });
    task.at_pole = sliding.at_pole;
    if (task.at_pole || (!sliding.value && task.scene.mu > 1)) {
        task.unknown = sliding.why;
        s.regime.reason = Why::boundaries_unknown + sliding.why;
    } else {
        s = std::move(sliding.required());
    }
    const bool follows = !task.unknown.empty() || (task.scene.mu > 1 && *task.scene.beta > 0);
    const bool sticks = s.regime.regime == Regime::stick_slip;
    if (follows || (sticks && task.question.asked != Asked::regime)) {
        answer_from_rest(task, s);
        const Why followed = s.not_from_rest.empty() ? Why::from_rest_followed : Why::from_rest_elsewhere;
        if (follows || task.scene.mu > 1 || !every_motion_is_damped(*task.known.basis)) s.method.why = followed + s.method.why;
    } else {
        answer_by_regime(task, s);
    }
}

void keep_asked_mass(const Question& question, Solution& s) {
    if (!question.mass) return;
    s.from_ground.clear();
    if (!s.only && !s.masses.empty()) {
        s.masses = {s.masses[question.mass->index]};
        s.only = question.mass;
    }
    for (OtherMotion& motion : s.motions) motion.masses = {motion.masses[question.mass->index]};
}

// Whether double leaves open if a motion with stops is stable, in a system whose every free motion decays.
bool is_vague(const SolveTask& task, const Solution& s) {
    if (!s.stability || s.stops.empty() || s.stability->stable || !every_motion_is_damped(*task.known.basis)) return false;
    const std::vector<Certified>& sizes = s.stability->multipliers; // none where they were not found
    return sizes.empty() || !(sizes.front().value - sizes.front().error > 1);
}

AnswerInDouble solve_in_double(const PreparedSystem& p, const SolvePoint& at, const Question& question) {
    AnswerInDouble found{{Outcome::answered}};
    Solution& s = found.solution;
    s.asked = question.asked;
    if (answer_by_contact(p, at, question, s)) {
        say_whether_unique(*p.contact->basis, p.contact->contact, p.scene().system, p.scene().mu, s);
    } else {
        const SceneSource source = source_at(p, at);
        SolveTask task{source, question, source->in_double(), aim_of(question.digits), {p.bounded}, p.moving};
        if (!task.known.basis) task.known = modes_in_double(source);
        s.r = exactly(at.r);
        s.beta = exactly(at.beta);
        s.contact = p.scene().system.contact;
        answer(task, s);
        say_whether_unique(*task.known.basis, contact_row(task.scene.system), task.scene.system, task.scene.mu, s);
        s.asked = question.asked;
        s.digits_reached = s.relative_error <= task.aim.tolerance;
        found.open = task.open || !task.unknown.empty();
        found.regime_is_certain = task.regime_is_certain;
        found.vague = is_vague(task, s);
        found.orbit = std::move(task.orbit);
        if (question.all) {
            if (!task.moving) task.moving = moving_in_double(source, task.known);
            s.motions = other_motions(task.scene, *task.moving, task.known.basis, source->effort);
        }
        keep_asked_mass(question, s);
    }
    take_contact_between(p.scene().system, s);
    if (const auto base = amplitude_of_base(p.scene().system.base_motion, as_input(at.r))) s.base_amplitude = certified(*base);
    s.mu = exactly(p.scene().mu);
    return found;
}

} // namespace

AnswerOrNone decide(const PreparedSystem& prepared, const SolvePoint& asked_about, const Question& question) {
    const std::size_t N = number_of_masses(prepared.scene().system);
    check(question, N);
    check_frequency_ratio(asked_about.r);
    check_friction_ratio(asked_about.beta);
    const SceneSource& source = asked_about.source != nullptr ? *asked_about.source : prepared.source;
    const GivenEffort effort(asked_about.effort != nullptr ? asked_about.effort : source->effort, N);
    SolvePoint at = asked_about;
    at.effort = effort.get();
    std::optional<PreparedSystem> there; // where what is prepared has the load of another frequency
    if (load_depends_on_frequency(prepared.scene().system)) there.emplace(PreparedSystem{source_at(prepared, at)});
    const PreparedSystem& p = there ? *there : prepared;
    return answer_or_reference(p, at, question,
                               [&](const Question& of) { return tried_in_double([&] { return solve_in_double(p, at, of); }); });
}

Solution solve(const SceneSource& source, const Question& question) {
    const Work before = work_so_far();
    const PreparedSystem p = prepare(source, question);
    const SolvePoint at{frequency_ratio_of(p.scene()), friction_ratio_of(p.scene()), &source};
    return with_work_since(before, required(decide(p, at, question)));
}

Solution solve(const PreparedSystem& system, double r, double beta, const Question& question, Effort* effort) {
    const Work before = work_so_far();
    return with_work_since(before, required(decide(system, {r, beta, nullptr, effort}, question)));
}

} // namespace denhartog
