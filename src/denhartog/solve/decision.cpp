// What answers a question: double or the reference? Read `in_turn` first, which has the rule; the functions after it ask it for
// a solution and for the sliding motion alone. And is the motion of an answer the only one? See `say_whether_unique`.
#include "denhartog/solve/decision.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "denhartog/answer/reference.hpp"
#include "denhartog/model/contact_and_load.hpp"
#include "denhartog/number/effort.hpp"
#include "denhartog/sliding/coupled_sums.hpp"
#include "denhartog/sliding/friction_motion.hpp"
#include "elementary/elementary.hpp"

namespace denhartog {
namespace {

using Number = Bounded<double>;

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

// The reference for a proof and for more digits than double has; else double, if that settles the question or refuses it at a
// pole that is met by rounding; else the reference, of many masses only if digits were asked for. If that has no proof, what
// double has, or the reasons of both.
template <class ByReference, class Fast>
AnswerOrNone in_turn(std::size_t N, Effort* effort, const Question& question, const ByReference& by_reference, const Fast& fast) {
    if (question.proved || question.digits > most_digits_in_double) return by_reference(AnswerInDouble{});
    AnswerInDouble found = fast();
    if (found.is_settled() || std::ranges::count(found.refused, Why::pole_by_rounding, &Reason::says) > 0) return found;
    Reasons why = found.is_answered() ? found.solution.method.why : found.refused;
    if (found.vague) why += Reasons(Why::but) + Why::stability_open;
    count_precision_step();
    AnswerOrNone proof;
    if (is_exhausted(effort))
        proof.refused = Why::work_is_spent;
    else if (!question.digits && N > most_masses_unasked)
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
    Question regime_alone;
    regime_alone.asked = Asked::regime;
    AnswerOrNone answer;
    if (scene.mu > 1) {
        rest = seen.is_answered() ? seen : fast(regime_alone);
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
            rest = fast(regime_alone);
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

// Whether a number may be an even integer.
bool may_be_even(const Number& n) {
    const double nearest = 2 * std::round(n.x / 2);
    return std::abs(n.x - nearest) <= n.e + unit_of<double>() * std::abs(n.x);
}

// What keeps friction from damping the modes that nothing else damps.
struct FreeModes {
    bool settle = true;                // nothing
    std::optional<std::size_t> kept{}; // one mode that has an even number of periods in one of the force, and nothing else
};

constexpr double most_periods = 1000; // of a mode in one of the force, beyond which it is not told how large its share may be

FreeModes free_modes(const ModalBasis<Number>& basis, Mass contact, const Number& r) {
    FreeModes found;
    std::vector<Number> periods; // of the modes without damping, in a period of the force
    bool others_settle = true;
    for (std::size_t i = 0; i < basis.r_n.size(); ++i) {
        if (basis.zeta[i].x > basis.zeta[i].e) continue;
        const Number& shape = basis.phi(static_cast<Eigen::Index>(contact.index), static_cast<Eigen::Index>(i));
        const Number n = basis.r_n[i] / r;
        if (may_be_even(n) && n.x <= most_periods && !found.kept && std::abs(shape.x) > shape.e)
            found.kept = i;
        else if (may_be_even(n) || may_be_even(n + Number(1)) || !(std::abs(shape.x) > shape.e))
            others_settle = false;
        for (const Number& other : periods)
            if (may_be_even(n - other) || may_be_even(n + other)) others_settle = false;
        periods.push_back(n);
    }
    found.settle = others_settle && !found.kept;
    if (!others_settle) found.kept.reset();
    return found;
}

// Says that mode i may keep any share of the sliding motion, and how far the contact then moves at most: until its velocity over
// the half-period would change its sign.
void say_what_is_kept(std::size_t i, const System<double>& system, Solution& s) {
    const auto basis = modes_with_errors(system);
    const ModeSums<double> sums = values_of(bounded_sums(system, *basis, as_input(s.r.value)));
    const std::size_t j = sums.contact.index;
    const MassInMotion<double> contact(sums, j, s.beta->value);
    const auto at = [&](double tau) { return motion_with(contact, friction_share(sums, j, tau)); };
    const double n = std::round(basis->r_n[i].x / s.r.value);
    const auto share = [&](double tau) { // as a displacement of the contact
        const double rate = std::abs(n * elementary::sin(n * tau));
        return rate > 0 ? std::abs(at(tau).x_prime) / rate : std::numeric_limits<double>::max();
    };
    double least = std::min(std::abs(at(0).x_double_prime), std::abs(at(pi<double>()).x_double_prime)) / (n * n); // at both ends
    constexpr int looks = 16, bits = 26; // in each half-turn of the mode; half the bits of a double for the instant
    const int pieces = looks * static_cast<int>(n);
    const double step = pi<double>() / pieces;
    std::vector<double> shares;
    for (int k = 0; k < pieces; ++k) shares.push_back(share(k * step));
    for (std::size_t k = 1; k + 1 < shares.size(); ++k) {
        if (shares[k] > std::min(shares[k - 1], shares[k + 1])) continue;
        const double middle = static_cast<double>(k) * step;
        least = std::min(least, boost::math::tools::brent_find_minima(share, middle - step, middle + step, bits).second);
    }
    constexpr double trusted = 1e-10;
    const double most = at(0).x + least;
    s.kept_mode = KeptMode{i, {most, trusted * most, {}}};
    s.not_from_rest = {Why::any_share, i + 1, n, most};
}

} // namespace

AnswerOrNone answer_or_reference(const PreparedSystem& p, const SolvePoint& at, const Question& question, const InDouble& fast) {
    const auto by_reference = [&](const AnswerInDouble& seen) { return answer_by_reference(p, at, question, fast, seen); };
    return with_digits(question.digits, in_turn(number_of_masses(p.scene().system), at.effort, question, by_reference,
                                                [&] { return fast(question); }));
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
    return in_turn(number_of_masses(source->in_double().system), source->effort, question, by_reference,
                   [&] { return in_double(question, modes); });
}

Solution sliding_answer(const SceneSource& source, std::optional<int> digits, bool proved) {
    return required(with_digits(digits, decide_sliding(source, {Asked::motion, digits, false, {}, proved})));
}

void say_whether_unique(const ModalBasis<Number>& basis, Mass contact, const System<double>& system, double mu, Solution& s) {
    const double beta = s.beta->value;
    if (beta == 0) mu = 1; // without friction static friction is none either
    s.unique = mu == 1 && every_motion_is_damped(basis);
    const bool slides = s.regime.regime == Regime::continuous && !s.regime.on_boundary && s.not_from_rest.empty();
    const bool friction_alone = mu == 1 && !s.unique && !basis.coupled() && beta > 0;
    const bool stops = !s.stops.empty() || s.rest_interval;
    if (s.unique) {
        s.unique_because = {Why::unique, basis.coupled()};
        return;
    }
    if (friction_alone && (slides || (stops && basis.r_n.size() == 1))) {
        const FreeModes free = slides ? free_modes(basis, contact, as_input(s.r.value)) : FreeModes{};
        s.unique = free.settle;
        if (free.settle) {
            s.not_from_rest.clear(); // every start leads there
            s.unique_because = {Why::unique, 2};
        }
        if (free.kept) {
            say_what_is_kept(*free.kept, system, s);
            s.unique_because = Why::share_kept;
        }
        if (free.settle || free.kept) return;
    }
    const bool held = s.regime.regime == Regime::permanent_sticking,
               open = mu == 1 && !s.start && s.regime.regime != Regime::stick_slip;
    if (s.not_from_rest.empty() && (open || (held && basis.r_n.size() > 1 && !every_motion_is_damped(basis))))
        s.not_from_rest = Why::may_last;
    const bool elsewhere = !s.not_from_rest.empty() && (mu > 1 || s.start);
    s.unique_because = {Why::may_depend, elsewhere ? 0 : mu > 1 ? 1 : basis.coupled() ? 2 : 3};
}

} // namespace denhartog
