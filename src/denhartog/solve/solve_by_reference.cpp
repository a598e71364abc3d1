#include "denhartog/solve/solve_by_reference.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include "denhartog/answer/reference.hpp"
#include "denhartog/number/effort.hpp"

namespace denhartog {
namespace {

constexpr std::size_t most_masses_unasked = 100; // of which the reference is asked where nobody asked for digits

// Double for the digits of every day; the reference for more, for a proof, and for what double leaves open. Where that does not
// tell either, what double has, or the errors of both.
template <class ByReference, class Fast>
Solution in_turn(std::size_t N, std::optional<int> digits, bool proved, const ByReference& by_reference, const Fast& fast) {
    if (proved || digits > most_digits_in_double) return by_reference();
    AnswerInDouble found;
    std::string why;
    std::exception_ptr pole;
    try {
        found = fast();
        if (found.is_settled()) return found.solution;
        why = found.solution.method.why + (found.vague ? ", but double does not tell whether the motion is stable" : "");
    } catch (const DomainError& e) {
        pole = std::current_exception();
        why = e.what();
    } catch (const PrecisionError& e) {
        found.is_answer = false;
        why = e.what();
    }
    count_precision_step();
    bool tells_regime = false; // the reference, though not the motion
    std::string refused = QuestionEffort::exhausted()
                              ? "the work allowed is spent"
                              : "the reference is asked about no more than " + std::to_string(most_masses_unasked) +
                                    " masses unless digits are asked for";
    if ((digits || N <= most_masses_unasked) && !QuestionEffort::exhausted()) {
        try {
            Solution s = by_reference();
            s.method.why = "in double: " + why + "; " + s.method.why;
            if (found.open && found.solution.limits && s.regime.regime == Regime::stick_slip)
                s.regime.reason +=
                    "; double precision does not tell whether the contact stops, and the reference proves that it does";
            return s;
        } catch (const MotionUnproved& e) { // the regime is told, and double has only one that may be next to it
            refused = e.what();
            tells_regime = true;
            found.is_answer = found.is_answer && !found.solution.regime.on_boundary;
        } catch (const RegimeDisproved& e) {
            refused = e.what();
            found.is_answer = false;
        } catch (const PrecisionError& e) {
            refused = e.what();
        }
    }
    if (pole) std::rethrow_exception(pole);
    const RegimeAtPoint& regime = found.solution.regime;
    if (found.open && !found.is_answer && !tells_regime)
        refused += (regime.on_boundary ? ". As double sees it: " : ". This much is certain: ") + regime.reason;
    if (tells_regime) why.resize(std::min(why.size(), why.find(". This much is certain")));
    if (!found.is_answer) throw PrecisionError(why == refused ? why : why + "; " + refused);
    found.solution.method.why += "; " + refused;
    if (found.open) found.solution.digits_reached = false;
    return found.solution;
}

void require_digits(std::optional<int> digits, const Solution& s) {
    if (!digits || s.digits_reached) return;
    const int certain = digits_of(s.relative_error);
    throw PrecisionError("the " + in_words(aim_of(digits)) + " are not reached: " +
                         (certain < *digits ? "only " + std::to_string(certain) + " are certain" : "the regime is not certain") +
                         " (" + s.method.why + ")");
}

// The motion that is meant where the friction ratio does not tell: with mu above 1, or at a pole, the one from rest, as double finds
// it. None where the boundaries tell.
std::optional<AnswerInDouble> from_rest(const Scene<double>& scene, const InDouble& fast) {
    Question of_regime;
    of_regime.asked = Asked::regime;
    AnswerInDouble rest = fast(of_regime);
    if (scene.mu == 1 && rest.solution.limits) return std::nullopt;
    return rest;
}

Solution answer_by_reference(const PreparedSystem& p, const SolvePoint& at, const Question& question, const InDouble& fast) {
    if (question.all && question.proved)
        throw InputError("all", "must not be asked for with a proof: other motions are estimates", "");
    const SceneSource source = source_at(p, at);
    const Scene<double>& scene = source->in_double();
    ReferenceQuestion asked{question.asked, question.digits.value_or(digits_by_default), question.mass};
    PreparedSystem prepared = p; // the modes in double are found once
    const auto guesses = [&] {
        if (!prepared.bounded) {
            const ModesInDouble modes = modes_in_double(source);
            if (modes.rounded_because.empty()) prepared.bounded = modes.basis;
        }
        return guesses_at(prepared, source);
    };
    std::optional<AnswerInDouble> rest;
    Solution s;
    try {
        if (scene.mu > 1) rest = from_rest(scene, fast);
        if (rest) asked.met = rest->solution.regime.regime;
        if (rest && rest->open && rest->solution.limits && asked.met == Regime::continuous)
            asked.met = Regime::stick_slip; // where that may hide a stop
        try {
            s = solution_by_reference(source, asked, guesses);
        } catch (const RegimeDisproved& disproved) { // next to a boundary double may be on its wrong side
            if (!rest || !rest->solution.regime.on_boundary) throw;
            asked.met = Regime::stick_slip;
            try {
                s = solution_by_reference(source, asked, guesses);
            } catch (const PrecisionError& e) {
                throw RegimeDisproved(std::string(disproved.what()) + "; " + e.what());
            }
        }
    } catch (const MotionUnproved&) {
        throw;
    } catch (const PrecisionError&) {
        if (scene.mu > 1) throw;
        try {
            rest = from_rest(scene, fast);
        } catch (const PrecisionError&) { // what the reference says is said
        }
        if (!rest) throw;
        asked.met = rest->solution.regime.regime; // a pole
        s = solution_by_reference(source, asked, guesses);
    }
    if (rest) {
        if (s.regime.regime == rest->solution.regime.regime && !rest->open) s.regime = rest->solution.regime;
        s.method.why = "the start from rest was followed without a proof; " + s.method.why;
    }
    const double mu = s.mu.value == 1 && s.mu.error > 0 ? 2 : scene.mu; // a text may be above 1 by less than double tells
    say_whether_unique(prepared.bounded ? *prepared.bounded
                       : p.contact      ? *p.contact->basis
                                        : *modes_in_double(source).basis,
                       mu, s);
    if (question.all) {
        Question others = question;
        others.digits.reset();
        s.motions = fast(others).solution.motions;
    }
    return s;
}

} // namespace

std::vector<OrbitGuess> guesses_at(const PreparedSystem& p, const SceneSource& source) {
    const Scene<double>& scene = source->in_double();
    std::vector<OrbitGuess> all;
    // Rounding of modes that double does not have itself would keep it from any motion that repeats itself.
    const ModesInDouble modes = p.bounded ? ModesInDouble{p.bounded} : modes_in_double(source);
    if (!modes.rounded_because.empty()) return all;
    const std::shared_ptr<const ContactSystem> moving = p.moving ? p.moving : moving_in_double(source, modes);
    if (!moving->rounded_because.empty()) return all;
    ExactSolver solver(*moving, {*scene.r, *scene.beta, scene.mu});
    OrbitSearch how;
    how.with_stability = false;
    PeriodicOrbit orbit = periodic_orbit(solver, at_rest(moving->basis.r_n.size()), how);
    if (orbit.status == OrbitStatus::permanently_stuck) return all;
    if (orbit.status == OrbitStatus::not_converged)
        orbit.symmetric = true; // rounding may be why; where the motion was last is near
    SearchEffort of_guesses(default_effort(moving->basis.r_n.size()));
    (void)solver.allow(&of_guesses);
    const auto add = [&](const OrbitGuess& guess) {
        if (guess.directions.empty()) return;
        const auto same = [&](const OrbitGuess& other) {
            constexpr double near = 1e-3;
            return other.directions == guess.directions && other.mirrored == guess.mirrored && other.periods == guess.periods &&
                   std::ranges::equal(other.events, guess.events, [](double a, double b) { return std::abs(a - b) < near; });
        };
        if (std::ranges::none_of(all, same)) all.push_back(guess);
    };
    for (const double shortest : {0.0, 1e-9, 1e-6}) add(guess_of(solver, orbit, shortest));
    for (const OrbitGuess& guess : std::vector<OrbitGuess>(all))
        for (const OrbitGuess& other : with_other_stops(guess)) add(other);
    return all;
}

Solution answer_or_reference(const PreparedSystem& p, const SolvePoint& at, const Question& question, const InDouble& fast) {
    const auto by_reference = [&] { return answer_by_reference(p, at, question, fast); };
    Solution s = in_turn(number_of_masses(p.scene().system), question.digits, question.proved, by_reference,
                         [&] { return fast(question); });
    require_digits(question.digits, s);
    return s;
}

Solution sliding_answer(const SceneSource& source, const SlidingQuestion& question, bool proved) {
    const auto by_reference = [&] {
        ReferenceQuestion asked{question.asked, question.digits.value_or(digits_by_default), question.only};
        asked.closed_form_alone = true;
        try {
            return solution_by_reference(source, asked, {});
        } catch (const PrecisionError&) {
            try {
                (void)sliding_solution(source, {Asked::regime}); // says where there is a pole
            } catch (const PrecisionError&) {
            }
            throw;
        }
    };
    (void)aim_of(question.digits);
    return in_turn(number_of_masses(source->in_double().system), question.digits, proved, by_reference, [&] {
        AnswerInDouble found{sliding_solution(source, question)};
        Solution& s = found.solution;
        take_contact_between(source->in_double().system, s);
        if (question.only && !s.masses.empty()) {
            s.masses = {s.masses[question.only->index]};
            s.only = question.only;
        }
        return found;
    });
}

Solution sliding_answer(const SceneSource& source, std::optional<int> digits, bool proved) {
    Solution s = sliding_answer(source, SlidingQuestion{Asked::motion, digits}, proved);
    require_digits(digits, s);
    return s;
}

} // namespace denhartog
