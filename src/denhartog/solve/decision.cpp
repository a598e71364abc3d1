// The choice between double and the reference. Read `in_turn` first, which has the rule; `decide` asks it for the steady motion,
// `decide_sliding` for the sliding motion alone.
#include "denhartog/solve/solve.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "denhartog/answer/modes_in_double.hpp"
#include "denhartog/answer/reference.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/scene/point_rules.hpp"

namespace denhartog {
namespace {

constexpr std::size_t most_masses_unasked = 100; // of which the reference is asked where nobody asked for digits

// The answer in double with what the reference failed to prove; none where double does not tell the regime by itself.
Tried<Solution> without_proof(AnswerInDouble found, const AnswerByReference& proof, Reasons why) {
    // The reference tells the regime, though not the motion; double then has only one that may be next to it.
    const bool told = proof.regime_holds == true;
    const bool on_boundary = found.is_answered() && found.value->regime.on_boundary;
    const bool answers = found.is_answered() && found.regime_is_certain && proof.regime_holds != false && !(told && on_boundary);
    Reasons refused = proof.why;
    if (found.open && !answers && !told) {
        const bool only_seen = on_boundary || !found.value->limits;
        refused += Reasons(only_seen ? Why::as_double_sees : Why::certain) + found.value->regime.reason;
    }
    if (told) why.erase(std::ranges::find(why, Why::certain, &Reason::says), why.end());
    if (!answers) { // more work may help; else it is as double found it, if double has no answer at all
        const bool by_double = !found.is_answered() && proof.outcome != Outcome::budget_spent;
        return {by_double ? found.outcome : proof.outcome, why == refused ? why : why + refused};
    }
    found.value->method.why += refused;
    if (found.open) found.value->digits_reached = false;
    return found;
}

// The reference for a proof and for more digits than double has; else double, if that settles the question; else the
// reference, of many masses only if digits were asked for. If that has no proof, what double has, or the reasons of both. At a
// pole that is met by rounding a motion that slides throughout stays refused.
template <class ByReference, class Fast>
Tried<Solution> in_turn(std::size_t N, Effort* effort, const Question& question, const ByReference& by_reference,
                        const Fast& fast) {
    if (question.proved || question.digits > most_digits_in_double) return by_reference(nullptr);
    AnswerInDouble found = fast();
    if (found.is_settled()) return found;
    // Regime and boundaries are there as they are elsewhere, and so is a contact that friction stops; of a motion that slides
    // throughout rounding decides the amplitude.
    Reasons pole;
    std::ranges::copy_if(found.is_answered() ? found.value->regime.reason : found.why, std::back_inserter(pole),
                         [](const Reason& reason) { return reason.says == Why::pole_by_rounding; });
    Reasons why = found.is_answered() ? found.value->method.why : found.why;
    if (found.vague) {
        const std::optional<Stability>& seen = found.value->stability;
        why += Reasons(Why::but) + (seen && !seen->stable ? Why::stability_open : Why::grazes);
    }
    count_precision_step();
    AnswerByReference proof = is_exhausted(effort) ? AnswerByReference{{Outcome::budget_spent, Why::work_is_spent}}
                              : !question.digits && N > most_masses_unasked
                                  ? AnswerByReference{{Outcome::digits_missing, {Why::not_asked, most_masses_unasked}}}
                                  : by_reference(&found);
    const bool slides = proof.is_answered() && proof.value->beta && proof.value->regime.regime == Regime::continuous;
    if (!pole.empty() && slides && question.asked != Asked::regime)
        return Refusal{Outcome::at_a_pole, found.is_answered() ? pole : found.why};
    if (proof.outcome == Outcome::at_a_pole) return proof;
    if (found.outcome == Outcome::at_a_pole && !proof.is_answered()) return found;
    if (!proof.is_answered()) return without_proof(std::move(found), proof, std::move(why));
    Solution& s = *proof.value;
    s.method.why = Why::in_double + why + s.method.why;
    if (found.open && found.value->limits && s.regime.regime == Regime::stick_slip) s.regime.reason += Why::stop_proved;
    return proof;
}

Tried<Solution> with_digits(std::optional<int> digits, Tried<Solution> answer) {
    if (!digits || !answer.is_answered() || answer.value->digits_reached) return answer;
    const Solution& s = *answer.value;
    const int certain = digits_of(s.relative_error);
    Reasons why{Why::digits_missing, *digits, *digits == 1};
    why += certain < *digits ? Reasons(Why::so_many_certain, certain) : Why::regime_uncertain;
    return {Outcome::digits_missing, why + s.method.why + Why::end_of_brackets};
}

// `seen` is what double has answered to the question, null where it was not asked.
AnswerByReference answer_by_reference(const PreparedSystem& p, const SolvePoint& at, const Question& question,
                                      const AnswerInDouble* seen) {
    if (question.all && question.proved)
        throw InputError("all", "must not be asked for with a proof: other motions are estimates", "");
    const SceneSource source = source_at(p, at);
    const Scene<double>& scene = source->in_double();
    PreparedSystem prepared = p; // the modes in double are found once
    // The motion that is meant where the friction ratio does not tell: with mu above 1, or at a pole, the one from rest.
    std::optional<AnswerInDouble> rest;
    std::optional<PeriodicOrbit> followed; // the motion from rest
    if (seen != nullptr) followed = seen->orbit;
    const bool is_seen = seen != nullptr && seen->is_answered();
    const auto guesses = [&] {
        if (!prepared.bounded) {
            const ModesInDouble modes = modes_in_double(source);
            if (modes.rounded_because.empty()) prepared.bounded = modes.basis;
        }
        return guesses_at(prepared, source, followed);
    };
    const auto proof_of = [&](std::optional<Regime> met, bool with_boundary = false) {
        return solution_by_reference(source, {question, met, with_boundary}, guesses);
    };
    Question regime_alone;
    regime_alone.asked = Asked::regime;
    AnswerByReference answer;
    if (scene.mu > 1) {
        rest = is_seen ? *seen : answer_in_double(p, at, regime_alone);
        if (!rest->is_answered()) return {*std::move(rest)};
        followed = rest->orbit;
        const RegimeAtPoint& met = rest->value->regime;
        const bool may_hide_a_stop = rest->open && rest->value->limits && met.regime == Regime::continuous;
        const Regime meant = may_hide_a_stop ? Regime::stick_slip : met.regime;
        answer = proof_of(meant, !rest->value->limits); // next to a pole it has the boundaries that double has not
        if (!answer.is_answered() && !answer.regime_holds && !rest->value->limits) answer = proof_of(meant);
        if (answer.regime_holds == false && met.on_boundary) { // double may be on the wrong side of it
            AnswerByReference other = proof_of(Regime::stick_slip);
            other.why = answer.why + other.why;
            answer = std::move(other);
            if (!answer.is_answered()) answer.regime_holds = false;
        }
    } else {
        answer = proof_of(std::nullopt);
        // The boundaries do not tell whether a motion beyond them stops: it may turn more than twice in a period instead.
        if (question.asked == Asked::regime && answer.is_answered() && answer.value->regime.regime == Regime::stick_slip)
            if (AnswerByReference moves = proof_of(Regime::stick_slip, true); moves.is_answered()) answer = std::move(moves);
        if (!answer.is_answered() && answer.regime_holds != true) {
            rest = answer_in_double(p, at, regime_alone);
            if (rest->outcome == Outcome::at_a_pole) return {*std::move(rest)};
            if (rest->is_answered() && !rest->value->limits) { // a pole
                followed = rest->orbit;
                answer = proof_of(rest->value->regime.regime);
            } else {
                rest.reset();
            }
        }
    }
    if (!answer.is_answered()) return answer;
    Solution& s = *answer.value;
    if (rest) {
        const Solution& from_rest = *rest->value;
        const Reasons& seen_from_rest = from_rest.regime.reason;
        if (s.limits && !from_rest.limits) // the reasons of double begin with why it has no boundaries
            std::copy(std::ranges::find(seen_from_rest, Why::from_the_start, &Reason::says), seen_from_rest.end(),
                      std::back_inserter(s.regime.reason));
        else if (s.regime.regime == from_rest.regime.regime && (!rest->open || s.regime.reason.empty()))
            s.regime = from_rest.regime; // the reference has no reason of its own where it has no boundaries
        if (from_rest.not_from_rest.empty())
            s.method.why = Why::from_rest_unproved + s.method.why;
        else if (!is_seen) // else double has said it
            s.method.why = Why::from_rest_elsewhere + s.method.why;
        s.not_from_rest = from_rest.not_from_rest;
    } else if (s.regime.regime == Regime::stick_slip && followed && !is_from_start(*followed)) {
        s.not_from_rest = followed->reason;
    }
    const double mu = s.mu.value == 1 && s.mu.error > 0 ? 2 : scene.mu; // a text may be above 1 by less than double tells
    if (!prepared.bounded && !p.contact) prepared.bounded = modes_in_double(source).basis;
    const auto& modes = prepared.bounded ? prepared.bounded : p.contact->basis;
    say_whether_unique(*modes, prepared.bounded ? contact_row(scene.system) : p.contact->contact, scene.system, mu, s);
    if (question.all) {
        Question others = question;
        others.digits.reset();
        AnswerInDouble found = seen != nullptr ? *seen : answer_in_double(p, at, others);
        if (!found.is_answered()) return {std::move(found)};
        s.motions = std::move(found.value->motions);
    }
    return answer;
}

} // namespace

Tried<Solution> decide(const PreparedSystem& prepared, const SolvePoint& asked_about, const Question& question) {
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
    const auto in_double = [&] { return answer_in_double(p, at, question); };
    const auto by_reference = [&](const AnswerInDouble* seen) { return answer_by_reference(p, at, question, seen); };
    return with_digits(question.digits, in_turn(N, at.effort, question, by_reference, in_double));
}

Tried<Solution> decide_sliding(const SceneSource& asked_about, const Question& question,
                               const std::shared_ptr<const ModalBasis<Bounded<double>>>& modes) {
    const ScenePaidFor scene(asked_about);
    const SceneSource& source = scene.source();
    const auto in_double = [&](const Question& asked) {
        AnswerInDouble found{tried([&] { return sliding_solution(source, asked, modes); })};
        if (found.is_answered()) finish_lists(source->in_double().system, asked, *found.value);
        return found;
    };
    const auto by_reference = [&](const AnswerInDouble*) -> AnswerByReference {
        AnswerByReference answer = solution_by_reference(source, {question, std::nullopt, false, true}, {});
        if (answer.is_answered()) return answer;
        AnswerInDouble regime = in_double({Asked::regime, {}}); // says where there is a pole
        if (regime.outcome == Outcome::at_a_pole) return {std::move(regime)};
        return answer;
    };
    (void)aim_of(question.digits);
    return in_turn(number_of_masses(source->in_double().system), source->effort, question, by_reference,
                   [&] { return in_double(question); });
}

Solution sliding_answer(const SceneSource& source, std::optional<int> digits, bool proved) {
    return std::move(with_digits(digits, decide_sliding(source, {Asked::motion, digits, false, {}, proved})).required());
}

} // namespace denhartog
