// What answers a question: double or the reference? Read `in_turn` first, which has the rule; the functions after it ask it for
// a solution, for the sliding motion alone, and for one number.
#include "denhartog/solve/decision.hpp"

#include <algorithm>
#include <cmath>

#include "denhartog/answer/reference.hpp"
#include "denhartog/number/effort.hpp"

namespace denhartog {
namespace {

constexpr std::size_t most_masses_unasked = 100; // of which the reference is asked where nobody asked for digits

// The answer in double with what the reference failed to prove; none where double does not tell the regime by itself.
AnswerOrNone without_proof(AnswerInDouble found, const AnswerOrNone& proof, Reasons why) {
    RegimeAtPoint& regime = found.solution.regime;
    // The reference tells the regime, though not the motion; double then has only one that may be next to it.
    const bool told = proof.outcome == Outcome::motion_unproved;
    const bool answers = found.is_answered() && found.regime_is_certain && proof.outcome != Outcome::regime_disproved &&
                         !(told && regime.on_boundary);
    Reasons refused = proof.refused;
    if (found.open && !answers && !told)
        refused += Reasons(regime.on_boundary ? Why::as_double_sees : Why::certain) + regime.reason;
    if (told) why.erase(std::ranges::find(why, Why::certain, &Reason::says), why.end());
    if (!answers) return {Outcome::not_certain, {}, why == refused ? why : why + refused};
    found.solution.method.why += refused;
    if (found.open) found.solution.digits_reached = false;
    return found;
}

// The reference for a proof and for more digits than double has; else double, if that settles the question or refuses it at a pole
// that is met by rounding; else the reference, of many masses only if digits were asked for. If that has no proof, what double has,
// or the reasons of both.
template <class ByReference, class Fast>
AnswerOrNone in_turn(std::size_t N, Effort* effort, std::optional<int> digits, bool proved, const ByReference& by_reference,
                     const Fast& fast) {
    if (proved || digits > most_digits_in_double) return by_reference(AnswerInDouble{});
    AnswerInDouble found = fast();
    if (found.is_settled() || std::ranges::count(found.refused, Why::pole_by_rounding, &Reason::says) > 0) return found;
    Reasons why = found.is_answered() ? found.solution.method.why : found.refused;
    if (found.vague) why += Reasons(Why::but) + Why::stability_open;
    count_precision_step();
    AnswerOrNone proof;
    if (is_exhausted(effort))
        proof.refused = Why::work_is_spent;
    else if (!digits && N > most_masses_unasked)
        proof.refused = {Why::not_asked, most_masses_unasked};
    else
        proof = by_reference(found);
    if (proof.outcome == Outcome::at_a_pole) return proof;
    if (found.outcome == Outcome::at_a_pole && !proof.is_answered()) return found;
    if (!proof.is_answered()) return without_proof(std::move(found), proof, std::move(why));
    Solution& s = proof.solution;
    s.method.why = Why::in_double + why + s.method.why;
    if (found.open && found.solution.limits && s.regime.regime == Regime::stick_slip) s.regime.reason += Why::stop_proved;
    return proof;
}

AnswerOrNone with_digits(std::optional<int> digits, AnswerOrNone answer) {
    const Solution& s = answer.solution;
    if (!digits || !answer.is_answered() || s.digits_reached) return answer;
    const int certain = digits_of(s.relative_error);
    Reasons why{Why::digits_missing, *digits, *digits == 1};
    why += certain < *digits ? Reasons(Why::so_many_certain, certain) : Why::regime_uncertain;
    return {Outcome::not_certain, {}, why + s.method.why + Why::end_of_brackets};
}

// `seen` is what double has answered to the question, if it has.
AnswerOrNone answer_by_reference(const PreparedSystem& p, const SolvePoint& at, const Question& question, const InDouble& fast,
                                 const AnswerInDouble& seen) {
    if (question.all && question.proved)
        throw InputError("all", "must not be asked for with a proof: other motions are estimates", "");
    const SceneSource source = source_at(p, at);
    const Scene<double>& scene = source->in_double();
    PreparedSystem prepared = p; // the modes in double are found once
    // The motion that is meant where the friction ratio does not tell: with mu above 1, or at a pole, the one from rest.
    std::optional<AnswerInDouble> rest;
    std::optional<PeriodicOrbit> followed = seen.orbit; // the motion from rest
    const auto guesses = [&] {
        if (!prepared.bounded) {
            const ModesInDouble modes = modes_in_double(source);
            if (modes.rounded_because.empty()) prepared.bounded = modes.basis;
        }
        return guesses_at(prepared, source, followed);
    };
    const auto proof_of = [&](std::optional<Regime> met) { return solution_by_reference(source, {question, met}, guesses); };
    Question of_regime;
    of_regime.asked = Asked::regime;
    AnswerOrNone answer;
    if (scene.mu > 1) {
        rest = seen.is_answered() ? seen : fast(of_regime);
        if (!rest->is_answered()) return *std::move(rest);
        followed = rest->orbit;
        const RegimeAtPoint& met = rest->solution.regime;
        const bool may_hide_a_stop = rest->open && rest->solution.limits && met.regime == Regime::continuous;
        answer = proof_of(may_hide_a_stop ? Regime::stick_slip : met.regime);
        if (answer.outcome == Outcome::regime_disproved && met.on_boundary) { // double may be on the wrong side of it
            AnswerOrNone other = proof_of(Regime::stick_slip);
            other.refused = answer.refused + other.refused;
            answer = std::move(other);
            if (!answer.is_answered()) answer.outcome = Outcome::regime_disproved;
        }
    } else {
        answer = proof_of(std::nullopt);
        if (answer.outcome == Outcome::not_certain || answer.outcome == Outcome::regime_disproved) {
            rest = fast(of_regime);
            if (rest->outcome == Outcome::at_a_pole) return *std::move(rest);
            if (rest->is_answered() && !rest->solution.limits) { // a pole
                followed = rest->orbit;
                answer = proof_of(rest->solution.regime.regime);
            } else {
                rest.reset();
            }
        }
    }
    if (!answer.is_answered()) return answer;
    Solution& s = answer.solution;
    if (rest) {
        if (s.regime.regime == rest->solution.regime.regime && !rest->open) s.regime = rest->solution.regime;
        if (rest->solution.not_from_rest.empty())
            s.method.why = Why::from_rest_unproved + s.method.why;
        else if (!seen.is_answered()) // else double has said it
            s.method.why = Why::from_rest_elsewhere + s.method.why;
        s.not_from_rest = rest->solution.not_from_rest;
    } else if (s.regime.regime == Regime::stick_slip && followed && !is_from_start(*followed)) {
        s.not_from_rest = followed->reason;
    }
    const double mu = s.mu.value == 1 && s.mu.error > 0 ? 2 : scene.mu; // a text may be above 1 by less than double tells
    if (!prepared.bounded && !p.contact) prepared.bounded = modes_in_double(source).basis;
    if (prepared.bounded)
        say_whether_unique(*prepared.bounded, contact_row(scene.system), scene.system, mu, s);
    else
        say_whether_unique(*p.contact->basis, p.contact->contact, scene.system, mu, s);
    if (question.all) {
        Question others = question;
        others.digits.reset();
        AnswerInDouble found = fast(others);
        if (!found.is_answered()) return found;
        s.motions = std::move(found.solution.motions);
    }
    return answer;
}

} // namespace

AnswerOrNone answer_or_reference(const PreparedSystem& p, const SolvePoint& at, const Question& question, const InDouble& fast) {
    const auto by_reference = [&](const AnswerInDouble& seen) { return answer_by_reference(p, at, question, fast, seen); };
    return with_digits(question.digits, in_turn(number_of_masses(p.scene().system), at.effort, question.digits, question.proved,
                                                by_reference, [&] { return fast(question); }));
}

AnswerOrNone decide_sliding(const SceneSource& asked_about, const Question& question,
                            const std::shared_ptr<const ModalBasis<Bounded<double>>>& modes) {
    const ScenePaidFor scene(asked_about);
    const SceneSource& source = scene.source();
    const auto in_double = [&](const Question& asked, const std::shared_ptr<const ModalBasis<Bounded<double>>>& known) {
        return tried_in_double([&] {
            AnswerInDouble found{{Outcome::answered, sliding_solution(source, asked, known)}};
            take_contact_between(source->in_double().system, found.solution);
            keep_asked_mass(asked, found.solution);
            return found;
        });
    };
    const auto by_reference = [&](const AnswerInDouble&) -> AnswerOrNone {
        AnswerOrNone answer = solution_by_reference(source, {question, std::nullopt, true}, {});
        if (answer.is_answered()) return answer;
        AnswerInDouble regime = in_double({Asked::regime, {}}, nullptr); // says where there is a pole
        if (regime.outcome == Outcome::at_a_pole) return regime;
        return answer;
    };
    (void)aim_of(question.digits);
    return in_turn(number_of_masses(source->in_double().system), source->effort, question.digits, question.proved, by_reference,
                   [&] { return in_double(question, modes); });
}

Solution sliding_answer(const SceneSource& source, std::optional<int> digits, bool proved) {
    return required(with_digits(digits, decide_sliding(source, {Asked::motion, digits, false, {}, proved})));
}

} // namespace denhartog
