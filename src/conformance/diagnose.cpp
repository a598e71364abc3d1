// Which known mistakes explain the wrong answers of an implementation? Each mistake is weighed by the answers that agree with it
// and by those that contradict it; the best one is named, the answers that it explains are set aside, and the search goes on with
// the rest. Read `diagnose` first, then `findings_of` and `weigh`.
#include "conformance/diagnose.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "conformance/diagnosis/explanations.hpp"
#include "conformance/verdict.hpp"

namespace denhartog::conformance {
namespace {

constexpr std::size_t least_explained = 3;

// Evidence of an answer for or against a mistake.
enum class Says { nothing, agrees, contradicts };

// Whether the mistake's answer would be judged wrong, and the answer of a program that makes it as well.
bool is_wrong(const Vector& v, const Value& mistaken, double near) {
    if (!v.word.empty() || !mistaken.word.empty()) return mistaken.word != v.word;
    if (mistaken.numbers.size() != v.nearest.size()) return true;
    const double apart = difference(quantity(v.question.quantity), mistaken.numbers, v.nearest).size;
    return apart > std::max(v.tolerance.inaccurate * v.scale, near / nearer_than_truth * size_of(mistaken.numbers));
}

// Answers that a guess may hit: names of regimes, and numbers of stops.
bool is_word(const Vector& v) {
    return !v.word.empty() || v.question.quantity == "stops_per_period" || v.question.quantity == "stop_durations";
}

// The answers with what each says about one mistake, made alone or together with those found before, as far as that is known.
struct Evidence {
    std::span<Judged> judged;
    const Mistake& mistake;
    double agreement;
    std::vector<const Answering*> with{}; // the mistakes found before, and this one
    std::map<std::size_t, Says> alone{}, together{};

    [[nodiscard]] Says says(std::size_t n) {
        if (!judged[n].answered || !judged[n].vector->reject.empty()) return Says::nothing;
        const ProtocolQuestion& q = judged[n].vector->question;
        const auto [of_one, is_new] = alone.try_emplace(n);
        if (is_new) of_one->second = look(n, mistake.answer(q));
        if (with.empty() || of_one->second == Says::agrees || !is_wrong_value(judged[n].verdict)) return of_one->second;
        const auto [of_all, is_new_together] = together.try_emplace(n);
        if (is_new_together && mistake.answer.touches(q)) of_all->second = look(n, answer_with_several(with, q));
        return of_all->second == Says::agrees ? Says::agrees : of_one->second;
    }

    [[nodiscard]] Says look(std::size_t n, const std::optional<Value>& value) const {
        const Judged& one = judged[n];
        if (!value) return Says::nothing;
        if (is_wrong_value(one.verdict) && agrees(*one.vector, one.given, *value, agreement)) return Says::agrees;
        return is_wrong(*one.vector, *value, agreement) ? Says::contradicts : Says::nothing;
    }
};

// A mistake with all that speaks for it and against it.
struct Weighed {
    Finding finding;
    std::size_t own = 0;        // answers explained by which it is weighed: those to the quantities of its core, or all
    std::size_t numbers = 0;    // of those explained
    std::size_t made_wrong = 0; // all answers that it would make wrong
    std::size_t wrong = 0;      // wrong answers to the quantities of its core, or to those of which it explains some answer
    bool numbers_asked = false; // whether a number is among these
    Evidence* evidence = nullptr;
};

Weighed weigh(std::span<Judged> judged, Evidence& evidence, const std::vector<std::size_t>& left,
              const std::set<std::size_t>& set_aside) {
    Weighed weighed;
    Finding& finding = weighed.finding;
    finding.mistake = evidence.mistake;
    weighed.evidence = &evidence;
    std::set<std::string> core, of; // the quantities of its core that were answered, all if none was; those that it explains
    std::optional<std::size_t> example;
    const auto asked = [&](std::size_t n) -> const std::string& { return judged[n].vector->question.quantity; };
    for (std::size_t n = 0; n < judged.size(); ++n)
        if (judged[n].answered && std::ranges::find(evidence.mistake.core, asked(n)) != evidence.mistake.core.end())
            core.insert(asked(n));
    const auto is_own = [&](std::size_t n) { return core.empty() || core.contains(asked(n)); };
    for (const std::size_t n : left) {
        if (evidence.says(n) != Says::agrees) continue;
        ++finding.explained;
        weighed.own += is_own(n);
        weighed.numbers += !is_word(*judged[n].vector);
        of.insert(asked(n));
        if (!example || judged[n].error.value_or(0) > judged[*example].error.value_or(0)) example = n;
    }
    if (!example || weighed.own < std::min(least_explained, left.size())) return weighed;
    const auto is_explained = [&](std::size_t n) { return of.contains(asked(n)); };
    for (const std::size_t n : left) weighed.wrong += core.empty() ? is_explained(n) : is_own(n);
    finding.example = &judged[*example];
    for (std::size_t n = 0; n < judged.size(); ++n) {
        if (set_aside.contains(n) || !is_own(n) || evidence.says(n) == Says::nothing) continue;
        ++weighed.made_wrong;
        weighed.numbers_asked = weighed.numbers_asked || !is_word(*judged[n].vector);
        const bool counts = is_right(judged[n].verdict) || !core.empty() || is_explained(n);
        if (evidence.says(n) == Says::contradicts && counts) ++finding.contradicted;
    }
    finding.quantities.assign(of.begin(), of.end());
    finding.weak = finding.explained < least_explained;
    return weighed;
}

bool is_accepted(const Weighed& weighed, std::size_t wrong, const Thresholds& least) {
    if (weighed.own < std::min(least_explained, wrong)) return false;
    if (weighed.numbers_asked ? weighed.numbers == 0 : weighed.own < std::min(least.words, wrong)) return false;
    const bool in_few_digits = weighed.evidence->agreement > 1e-4;
    const double consistency = in_few_digits ? least.of_solvers : least.consistency;
    return share(weighed.own, weighed.own + weighed.finding.contradicted) >= consistency &&
           share(weighed.own, weighed.made_wrong) >= least.of_its_own && share(weighed.own, weighed.wrong) >= least.of_the_wrong;
}

// Some answers to every quantity, wrong ones that are left and right ones, from all over the list.
std::vector<std::size_t> some_answers(std::span<const Judged> judged, const std::vector<std::size_t>& left) {
    constexpr std::size_t wrong_ones = 8, right_ones = 4;
    std::map<std::string, std::vector<std::size_t>> wrong, right;
    for (const std::size_t n : left) wrong[judged[n].vector->question.quantity].push_back(n);
    for (std::size_t n = 0; n < judged.size(); ++n)
        if (judged[n].answered && is_right(judged[n].verdict)) right[judged[n].vector->question.quantity].push_back(n);
    std::vector<std::size_t> some;
    for (const auto& [all, most] : {std::pair(&wrong, wrong_ones), std::pair(&right, right_ones)})
        for (const auto& [quantity, of_one] : *all)
            for (const std::size_t n : spread(of_one, most)) some.push_back(n);
    return some;
}

// Whether a mistake may explain the wrong answers, as some of the answers show. Most mistakes do not, and need no further look.
bool is_possible(std::span<const Judged> judged, Evidence& evidence, const std::vector<std::size_t>& some) {
    std::size_t agrees = 0, contradicts = 0;
    for (const std::size_t n : some) {
        agrees += evidence.says(n) == Says::agrees;
        contradicts += evidence.says(n) == Says::contradicts && is_right(judged[n].verdict) && evidence.mistake.core.empty();
    }
    return agrees > 0 && contradicts <= agrees;
}

// The order in which mistakes are told.
auto order(const Weighed& w) {
    return std::pair(static_cast<long>(w.finding.contradicted) - static_cast<long>(w.finding.explained), w.made_wrong);
}

// The mistake that is told next.
std::optional<Weighed> most_telling(std::span<Judged> judged, std::vector<Evidence>& candidates,
                                    const std::vector<std::size_t>& left, const std::set<std::size_t>& set_aside,
                                    std::size_t wrong, const Thresholds& least) {
    std::optional<Weighed> best;
    if (left.empty()) return best;
    const std::vector<std::size_t> some = some_answers(judged, left);
    for (Evidence& candidate : candidates) {
        if (!is_possible(judged, candidate, some)) continue;
        Weighed weighed = weigh(judged, candidate, left, set_aside);
        if (weighed.finding.example == nullptr || !is_accepted(weighed, wrong, least)) continue;
        if (!best || order(weighed) < order(*best)) best = std::move(weighed);
    }
    return best;
}

// The mistakes that explain wrong answers, one after the other; what one explains is not left to the next.
std::vector<Finding> findings_of(std::span<Judged> judged, std::span<const Mistake> known, std::vector<std::size_t>& left,
                                 std::set<std::size_t>& set_aside, const Thresholds& least, bool of_the_left) {
    std::vector<Finding> findings;
    std::vector<Evidence> candidates;
    std::vector<const Answering*> found;
    for (const Mistake& mistake : known) candidates.push_back({judged, mistake, std::max(mistake.agreement, least.agreement)});
    const std::size_t wrong = left.size();
    while (std::optional<Weighed> best =
               most_telling(judged, candidates, left, set_aside, of_the_left ? left.size() : wrong, least)) {
        const Mistake& mistake = best->evidence->mistake;
        Finding& finding = best->finding;
        const ProtocolQuestion& example = finding.example->vector->question;
        const std::optional<Value> alone = mistake.answer(example);
        const bool is_of_one =
            alone && agrees(*finding.example->vector, finding.example->given, *alone, best->evidence->agreement);
        finding.mistaken = (is_of_one ? alone : answer_with_several(best->evidence->with, example)).value_or(Value{});
        std::erase_if(left, [&](std::size_t n) {
            if (best->evidence->says(n) != Says::agrees) return false;
            if (judged[n].verdict == Verdict::wrong && mistake.as_printed) {
                judged[n].verdict = Verdict::as_printed;
                judged[n].equation = mistake.equation;
                judged[n].reason = "the value of Eq. (" + mistake.equation + ") as printed";
            }
            return set_aside.insert(n).second;
        });
        findings.push_back(finding);
        for (const std::string& name : mistake.besides) {
            const auto other = std::ranges::find(known, name, &Mistake::name);
            if (other == known.end()) continue;
            finding.mistake = *other;
            findings.push_back(finding);
        }
        if (!mistake.answer.touches) continue;
        found.push_back(&mistake.answer);
        for (Evidence& candidate : candidates) {
            if (!candidate.mistake.answer.touches) continue;
            candidate.with = found;
            candidate.with.push_back(&candidate.mistake.answer);
            candidate.together.clear();
        }
    }
    return findings;
}

// The answers that belong to the first link of the chain to which any of them does.
std::vector<const Judged*> in_first_link(const std::vector<const Judged*>& wrong) {
    std::map<std::size_t, std::vector<const Judged*>> links;
    for (const Judged* one : wrong) links[place_in_chain(one->vector->question)].push_back(one);
    return links.empty() ? wrong : links.begin()->second;
}

} // namespace

Diagnosis diagnose(std::span<Judged> judged, std::span<const Mistake> known, const Thresholds& least, bool guess) {
    Diagnosis diagnosis;
    std::vector<std::size_t> left;
    for (std::size_t n = 0; n < judged.size(); ++n) {
        if (judged[n].verdict == Verdict::not_rejected) ++diagnosis.accepted[judged[n].vector->reject];
        if (is_wrong_value(judged[n].verdict)) left.push_back(n);
    }
    diagnosis.wrong = left.size();
    std::set<std::size_t> set_aside;
    diagnosis.findings = findings_of(judged, known, left, set_aside, least, false);
    for (const std::size_t n : left) diagnosis.unexplained.push_back(&judged[n]);
    diagnosis.chain = chain_of(diagnosis.unexplained, judged);
    if (guess && left.size() >= least_explained)
        diagnosis.simple = findings_of(judged, guesses_at(diagnosis.unexplained), left, set_aside, least, true);
    diagnosis.by_quantity = by_quantity(diagnosis.unexplained, judged);
    diagnosis.in_common = properties_in_common(in_first_link(diagnosis.unexplained), judged);
    return diagnosis;
}

} // namespace denhartog::conformance
