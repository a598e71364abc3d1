// The choice of the model that answers a question in double. Read `answer` first: it asks the closed form, follows the start from
// rest where that is needed, and takes the stuck response where the contact rests. `solve_in_double` puts the cheapest model
// before it. `decide`, in `decision.cpp`, asks double and then the reference.
#include "denhartog/solve/solve.hpp"

#include <algorithm>
#include <utility>

#include "denhartog/answer/certify.hpp"
#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/number/tried.hpp"
#include "denhartog/scene/point_rules.hpp"
#include "denhartog/sliding/bounded_modes.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/stick_slip/exact_motion.hpp"

namespace denhartog {
namespace {

// A question to a scene, prepared.
struct SolveTask {
    SceneSource source;                          // the scene
    Question question;                           // the question
    const Scene<double>& scene;                  // the scene in double, which `source` holds
    Aim aim;                                     // the digits
    ModesInDouble known;                         // its modal basis
    std::shared_ptr<const ContactSystem> moving; // for the exact solver; none where it is still to be prepared
    AnswerInDouble& found;                       // the answer so far
    Refusal sliding{};                           // why boundaries and closed form are not known, where they are not
};

// True where amplitude or phase of the contact is all that is asked for.
bool asks_for_contact(const Question& question, const System<double>& s) {
    return question.mass == contact_row(s) && !question.all &&
           (question.asked == Asked::amplitude || question.asked == Asked::phase);
}

// The modes of a system as its contact has them.
ContactModes modes_of_contact(const System<double>& s) {
    const bool same = contact_row(s) == load_row(s);
    const std::vector<Mass> rows = same ? std::vector<Mass>{s.contact} : std::vector<Mass>{s.contact, load_row(s)};
    return contact_modes(std::make_shared<const ModalBasis<Bounded<double>>>(bounded_basis_at(s, rows)), Mass{0},
                         Mass{same ? 0U : 1U});
}

Work work_so_far() { return {eigen_solves(), mode_evaluations(), phases_propagated()}; }

Solution with_work_since(const Work& before, Solution s) {
    const Work after = work_so_far();
    s.work = {after.eigen_solves - before.eigen_solves, after.mode_evaluations - before.mode_evaluations,
              after.phases_propagated - before.phases_propagated};
    return s;
}

// Amplitude or phase of the contact alone, sliding at mu = 1: the cheapest model. False where it does not answer.
bool answer_by_contact(const PreparedSystem& p, const SolvePoint& at, const Question& question, Solution& s) {
    if (!p.contact || !asks_for_contact(question, p.scene().system)) return false;
    const Aim aim = aim_of(question.digits);
    if (aim.digits > most_digits_in_double) return false;
    const auto contact = tried([&] { return contact_solution(*p.contact, as_input(at.r), as_input(at.beta)); });
    if (!contact.is_answered() || !*contact.value) return false; // the next model says where a pole is
    const ContactSolution& found = **contact.value;
    const double relative = found.amplitude.e / found.amplitude.x;
    const Attempted attempted{question.asked == Asked::phase ? std::max(relative, found.phase.e) : relative};
    if (!(attempted.relative <= aim.tolerance)) return false;
    s.slides_below = exactly(found.slides_below.x * (1 - aim.tolerance)); // its rounding must not raise it
    s.masses = {{certified(found.amplitude), certified(found.phase), std::nullopt}};
    s.method = {"closed form", "double", verdict(attempted, aim)};
    s.relative_error = attempted.relative;
    s.only = s.contact;
    s.regime = {Regime::continuous, {}, false, Why::certainly_slides};
    return true;
}

// True where a motion that turns twice in a period has stops, seen or not. One that turns more often the reference finds.
bool must_stop(const SolveTask& task, const Solution& s) {
    return s.regime.regime == Regime::stick_slip && (task.scene.mu == 1 || every_motion_is_damped(*task.known.basis));
}

// The stuck response as the answer; `rests_at` is where the contact rests, if that was followed.
void answer_by_stuck_response(const SolveTask& task, const std::optional<Certified>& rests_at, Solution& s) {
    const std::shared_ptr<const ContactSystem> moving = task.moving ? task.moving : moving_in_double(task.source, task.known);
    set_stuck_response(task.scene, moving->stuck, *task.known.basis, task.question.mass, s);
    s.rest_interval->rests_at = rests_at;
    s.method = {"stuck response", "double", Why::bound_by_equations + verdict({s.relative_error}, task.aim)};
}

void set_regime(const SolveTask& task, Regime met, const Reasons& reason, Solution& s) {
    const bool known = task.sliding.is_answered();
    if (known)
        take_regime(met, s.regime);
    else
        s.regime.regime = met;
    if (task.scene.mu > 1 || !known || met == Regime::continuous) s.regime.reason += reason;
}

// Takes the regime from the stops of a motion that is not the closed form's. `open`: double does not tell if it stops.
void set_regime_by_stops(const SolveTask& task, const PeriodicOrbit& orbit, bool open, Solution& s) {
    const bool must = orbit.stops.empty() && must_stop(task, s);
    if (!orbit.stops.empty()) {
        const bool slides = task.sliding.is_answered() && s.regime.regime == Regime::continuous; // a motion that does, besides
        set_regime(task, Regime::stick_slip, slides ? Why::rest_leads_to_stops : Why::stops, s);
    } else if (must) {
        s.regime.reason += {Why::no_stop_seen, orbit.error_bound};
    } else if (open) {
        s.regime.reason += Why::stops_open;
    } else {
        const Outcome outcome = task.sliding.outcome;
        const bool known = outcome == Outcome::answered, sliding = known && every_motion_is_damped(*task.known.basis);
        set_regime(task, Regime::continuous,
                   sliding                                  ? Why::rest_leads_to_sliding
                   : known || outcome == Outcome::at_a_pole ? Why::slides_otherwise
                                                            : Why::does_not_stop,
                   s);
    }
}

void answer_by_boundaries(SolveTask& task, const std::string& model, Solution& s) {
    s.masses.clear();
    s.from_ground.clear();
    s.method.model = model;
    s.method.precision = "double";
    s.sticking_by_88 = sticking_by_88(task.scene);
    if (!s.sticking_by_88) return;
    const Bounded<double> by_88(s.sticking_by_88->value, s.sticking_by_88->error);
    s.relative_error = std::max(s.relative_error, relative_error(by_88));
}

// A fast mode, which the exact solver follows, as the reason why it found no motion; none where its modes are slow.
Reasons cost_of_fast_mode(const ExactSolver& solver, const PeriodicOrbit& none) {
    constexpr double fast = 1000;
    const double fastest = solver.highest_over_force();
    if (!(fastest > fast) || !none.more_digits_may_tell) return {};
    return {Why::fast_mode, fastest};
}

Refusal none_from_rest(const SolveTask& task, Outcome outcome, const Reasons& why, const Solution& s) {
    if (task.sliding.outcome == Outcome::at_a_pole) return {Outcome::at_a_pole, task.sliding.why + why};
    if (is_exhausted(task.source->effort)) outcome = Outcome::budget_spent;
    Reasons all = Why::none_from_rest + why;
    if (task.sliding.is_answered()) all += Why::certain; // else the boundaries are not known
    return {outcome, all + s.regime.reason};
}

// The steady motion of a regime that the boundaries tell, where the one from rest is not known. A sliding motion is in `s`
// already.
Refusal answer_by_regime(SolveTask& task, Solution& s) {
    if (task.question.asked == Asked::regime)
        answer_by_boundaries(task, "boundaries", s);
    else if (s.regime.regime == Regime::permanent_sticking)
        answer_by_stuck_response(task, std::nullopt, s);
    return {};
}

// At a pole no boundary tells whether the motion grows for ever. Stops may be rounding of one that does if none is longer than
// this, in radians: an error of beta by a last digit makes some that are a tenth as long.
bool hardly_stops(const PeriodicOrbit& orbit) {
    constexpr double short_stop = 1e-4;
    return !orbit.stops.empty() &&
           std::ranges::all_of(orbit.stops, [](const Stop& stop) { return stop.end - stop.start < short_stop; });
}

// The motion from rest by the exact solver; the closed form or the stuck response give the numbers where it leads there. With
// mu = 1 and damping all starts lead to one motion; with mu above 1 rest mostly leads to the sliding motion if there is one.
Refusal answer_from_rest(SolveTask& task, Solution& s) {
    if (!task.moving) task.moving = moving_in_double(task.source, task.known);
    const ContactSystem& system = *task.moving;
    const bool known = task.sliding.is_answered(), told = known && !s.regime.on_boundary,
               sticks = s.regime.regime == Regime::stick_slip;
    if (!system.rounded_because.empty()) {
        if (!told || sticks) return none_from_rest(task, Outcome::digits_missing, system.rounded_because, s);
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
    if (known && s.regime.regime == Regime::continuous) {
        near = sliding_at_maximum_of_force(
            values_of(bounded_sums(task.scene.system, *task.known.basis, as_input(*task.scene.r), task.source->effort)),
            *task.scene.beta);
        how.guess = &near;
    }
    const PeriodicOrbit& orbit = task.found.orbit.emplace(periodic_orbit(solver, at_rest(system.basis.r_n.size()), how));
    if (!is_from_start(orbit)) {
        const bool found = orbit.status == OrbitStatus::not_from_start;
        s.not_from_rest = orbit.reason + cost_of_fast_mode(solver, orbit);
        const bool by_regime = told && (s.regime.regime == Regime::continuous || !(found || sticks));
        if (by_regime && !is_exhausted(task.source->effort)) return answer_by_regime(task, s);
        if (!found) return none_from_rest(task, Outcome::not_converged, s.not_from_rest, s);
    }
    const bool rests = orbit.status == OrbitStatus::permanently_stuck;
    // With mu = 1 the boundaries tell that it never rests for ever: only rounding does not see it move.
    if (rests && task.scene.mu == 1 && told && sticks)
        return {Outcome::digits_missing, Reasons(Why::moves_too_little) + Why::certain + s.regime.reason};
    const bool slides = known && !rests && !s.masses.empty() &&
                        (must_be_sliding_motion(orbit, every_motion_is_damped(*task.known.basis)) ||
                         is_sliding_motion(orbit, s.masses[system.contact.index].amplitude.value));
    if (rests) {
        set_regime(task, Regime::permanent_sticking, Why::from_the_start + orbit.reason, s);
    } else if (slides && orbit.stops.empty()) {
        set_regime(task, Regime::continuous, Why::rest_leads_to_sliding, s);
    } else {
        const bool open = known ? stops_are_open(orbit, sticks, orbit.stops.empty() && must_stop(task, s), slides)
                                : task.sliding.outcome == Outcome::at_a_pole && hardly_stops(orbit);
        task.found.open = open;
        task.found.regime_is_certain = !open || must_stop(task, s);
        if (!regime_alone) {
            set_motion_of_orbit(task.scene, task.question, solver, orbit, s);
            s.method = {"exact solver", "double",
                        Why::bound_by_residual + verdict({s.relative_error, !open, Why::stops_open}, task.aim)};
        }
        set_regime_by_stops(task, orbit, open, s);
        if (!regime_alone) {
            if (s.not_from_rest.empty()) s.regime.reason += orbit.reason;
            return {};
        }
    }
    if (regime_alone) {
        answer_by_boundaries(task, "boundaries and exact solver", s);
        return {};
    }
    if (rests) answer_by_stuck_response(task, place_of_rest(orbit), s);
    if (task.question.asked == Asked::motion) s.stability = stability_of(orbit);
    return {};
}

Refusal answer(SolveTask& task, Solution& s) {
    Tried<Solution> sliding = tried([&] { return sliding_solution(task.source, task.question, task.known.basis); });
    if (sliding.is_answered()) {
        s = *std::move(sliding.value);
    } else if (sliding.outcome == Outcome::at_a_pole || task.scene.mu > 1) {
        s.regime.reason = Why::boundaries_unknown + sliding.why;
        task.sliding = std::move(sliding);
    } else {
        return sliding;
    }
    const bool follows = !task.sliding.is_answered() || (task.scene.mu > 1 && *task.scene.beta > 0);
    const bool sticks = s.regime.regime == Regime::stick_slip;
    if (!follows && !sticks) return answer_by_regime(task, s);
    if (Refusal none = answer_from_rest(task, s); !none.is_answered()) {
        if (follows || task.question.asked != Asked::regime) return none;
        task.found.open = true; // beyond the boundary the contact may turn more than twice in a period, and never stop
        return answer_by_regime(task, s);
    }
    const Why followed = s.not_from_rest.empty() ? Why::from_rest_followed : Why::from_rest_elsewhere;
    if (follows || task.scene.mu > 1 || !every_motion_is_damped(*task.known.basis)) s.method.why = followed + s.method.why;
    return {};
}

// True if a whole motion is asked for, and double leaves open when the contact stops or breaks away, and with that how often; or if
// the motion is stable, in a system whose every free motion decays.
bool is_vague(const SolveTask& task, const Solution& s) {
    if (!s.stability || s.stops.empty()) return false;
    const auto is_unknown = [](const Certified& instant) { return instant.error >= pi<double>(); };
    for (const SolvedStop& stop : s.stops)
        if (is_unknown(stop.start) || is_unknown(stop.end)) return true;
    if (s.stability->stable || !every_motion_is_damped(*task.known.basis)) return false;
    const std::vector<Certified>& sizes = s.stability->multipliers; // none where they were not found
    return sizes.empty() || !(sizes.front().value - sizes.front().error > 1);
}

AnswerInDouble solve_in_double(const PreparedSystem& p, const SolvePoint& at, const Question& question) {
    AnswerInDouble found;
    Solution& s = *found.value;
    set_point(p.scene().system, at.r, at.beta, p.scene().mu, question.asked, s);
    if (answer_by_contact(p, at, question, s)) {
        say_whether_unique(*p.contact->basis, p.contact->contact, p.scene().system, p.scene().mu, s);
    } else {
        const SceneSource source = source_at(p, at);
        SolveTask task{source, question, source->in_double(), aim_of(question.digits), {p.bounded}, p.moving, found};
        if (!task.known.basis) task.known = modes_in_double(source);
        if (Refusal none = answer(task, s); !none.is_answered()) return {{std::move(none)}};
        say_whether_unique(*task.known.basis, contact_row(task.scene.system), task.scene.system, task.scene.mu, s);
        s.digits_reached = s.relative_error <= task.aim.tolerance;
        found.open = found.open || !task.sliding.is_answered();
        found.vague = is_vague(task, s);
        if (question.all) {
            if (!task.moving) task.moving = moving_in_double(source, task.known);
            s.motions = other_motions(task.scene, *task.moving, task.known.basis, source->effort);
        }
    }
    finish_lists(p.scene().system, question, s);
    return found;
}

} // namespace

void check(const Question& question, std::size_t N) {
    (void)aim_of(question.digits);
    if (question.mass) check_mass(*question.mass, N, "mass");
}

PreparedSystem prepare(const SceneSource& source, const Question& question, Prepared points) {
    PreparedSystem p{source};
    check(p.scene());
    const System<double>& s = p.scene().system;
    check(question, number_of_masses(s));
    const bool in_phase = s.load_phases.empty() && !load_depends_on_frequency(s);
    if (s.damping_matrix.size() == 0 && p.scene().mu == 1 && in_phase && asks_for_contact(question, s))
        p.contact = tried([&] { return modes_of_contact(s); }).value; // without, another model answers
    if (points == Prepared::every_regime) {
        const ModesInDouble modes = modes_in_double(source);
        p.bounded = modes.basis;
        p.moving = moving_in_double(source, modes);
    }
    return p;
}

PreparedSystem with_static_friction(PreparedSystem system, double mu) {
    system.source = with_static_friction(system.source, mu);
    return system;
}

SceneSource source_at(const PreparedSystem& p, const SolvePoint& at) {
    const SceneSource source = at.source != nullptr ? *at.source : at_point(p.source, at.r, at.beta);
    return at.effort != nullptr ? with_effort(source, at.effort) : source;
}

AnswerInDouble answer_in_double(const PreparedSystem& p, const SolvePoint& at, const Question& question) {
    Tried<AnswerInDouble> found = tried([&] { return solve_in_double(p, at, question); });
    if (found.is_answered()) return *std::move(found.value);
    return {{Refusal(std::move(found))}};
}

Solution solve(const SceneSource& source, const Question& question) {
    const Work before = work_so_far();
    const PreparedSystem p = prepare(source, question);
    const SolvePoint at{frequency_ratio_of(p.scene()), friction_ratio_of(p.scene()), &source};
    return with_work_since(before, std::move(decide(p, at, question).required()));
}

Solution solve(const PreparedSystem& system, double r, double beta, const Question& question, Effort* effort) {
    const Work before = work_so_far();
    return with_work_since(before, std::move(decide(system, {r, beta, nullptr, effort}, question).required()));
}

} // namespace denhartog
