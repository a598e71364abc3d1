#include "conformance/diagnose.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "conformance/grade.hpp"
#include "conformance/in_common.hpp"

namespace denhartog::conformance {
namespace {

constexpr double nearer_than_truth = 0.1;
constexpr std::size_t least_explained = 3;
constexpr double least_consistency = 0.9;

// What an answer says about a mistake.
enum class Says { nothing, agrees, contradicts };

// Whether the mistake's answer would be judged wrong.
bool is_wrong(const Vector& v, const Value& mistaken) {
    if (!v.word.empty() || !mistaken.word.empty()) return mistaken.word != v.word;
    if (mistaken.numbers.size() != v.nearest.size()) return true;
    const double apart = difference(quantity(v.question.quantity), mistaken.numbers, v.nearest).size;
    return apart > v.tolerance.inaccurate * v.scale;
}

bool agrees(const Vector& v, const Value& given, const Value& mistaken, double near) {
    if (!given.word.empty() || !mistaken.word.empty()) return given.word == mistaken.word;
    if (given.numbers.size() != mistaken.numbers.size()) return false;
    const Quantity& asked = quantity(v.question.quantity);
    const double apart = difference(asked, given.numbers, mistaken.numbers).size;
    const double size = asked.angle ? 1 : size_of(mistaken.numbers);
    if (!(apart <= near * (size > 0 ? size : v.scale))) return false;
    if (given.numbers.size() != v.nearest.size()) return true;
    return apart <= nearer_than_truth * difference(asked, given.numbers, v.nearest).size;
}

// The answers with what each says about one mistake, as far as that is known.
class Evidence {
public:
    Evidence(std::span<Judged> all, const Mistake& m, const Signatures& known) : judged(all), mistake(m), signatures(known) {}

    [[nodiscard]] const Mistake& about() const { return mistake; }

    [[nodiscard]] std::optional<Value> mistaken(std::size_t n) const {
        return signatures.answer(mistake.name, judged[n].vector->question);
    }

    [[nodiscard]] Says says(std::size_t n) {
        const auto known = memory.find(n);
        if (known != memory.end()) return known->second;
        return memory[n] = look(n);
    }

private:
    std::span<Judged> judged;
    const Mistake& mistake;
    const Signatures& signatures;
    std::map<std::size_t, Says> memory;

    [[nodiscard]] Says look(std::size_t n) const {
        const Judged& one = judged[n];
        if (!one.answered || !one.vector->reject.empty()) return Says::nothing;
        const std::optional<Value> value = mistaken(n);
        if (!value) return Says::nothing;
        if (is_wrong_value(one.verdict) && agrees(*one.vector, one.given, *value, mistake.agreement)) return Says::agrees;
        return is_wrong(*one.vector, *value) ? Says::contradicts : Says::nothing;
    }
};

Finding weigh(std::span<Judged> judged, Evidence& evidence, const std::vector<std::size_t>& left,
              const std::set<std::size_t>& set_aside) {
    Finding finding;
    finding.mistake = &evidence.about();
    std::set<std::string> of;
    std::optional<std::size_t> example;
    for (const std::size_t n : left) {
        if (evidence.says(n) != Says::agrees) continue;
        ++finding.explained;
        of.insert(judged[n].vector->question.quantity);
        if (!example || judged[n].error.value_or(0) > judged[*example].error.value_or(0)) example = n;
    }
    if (!example) return finding;
    finding.example = &judged[*example];
    finding.mistaken = evidence.mistaken(*example).value_or(Value{});
    for (std::size_t n = 0; n < judged.size(); ++n)
        if (of.contains(judged[n].vector->question.quantity) && !set_aside.contains(n) && evidence.says(n) == Says::contradicts)
            ++finding.contradicted;
    finding.quantities.assign(of.begin(), of.end());
    return finding;
}

bool is_accepted(const Finding& finding, std::size_t left) {
    const auto explained = static_cast<double>(finding.explained);
    const double consistency = explained / (explained + static_cast<double>(finding.contradicted));
    return finding.explained >= std::min(least_explained, left) && consistency >= least_consistency;
}

long balance(const Finding& finding) { return static_cast<long>(finding.explained) - static_cast<long>(finding.contradicted); }

// Answers to whatever quantity that a mistake contradicts: of two that explain the same, the one with fewer is meant.
std::size_t contradicted_anywhere(std::size_t count, Evidence& evidence, const std::set<std::size_t>& set_aside) {
    std::size_t contradicted = 0;
    for (std::size_t n = 0; n < count; ++n)
        if (!set_aside.contains(n) && evidence.says(n) == Says::contradicts) ++contradicted;
    return contradicted;
}

void call_as_printed(Judged& one, const Mistake& mistake) {
    if (one.verdict != Verdict::wrong || !mistake.as_printed) return;
    one.verdict = Verdict::as_printed;
    one.equation = mistake.equation;
    one.reason = "the value of Eq. (" + mistake.equation + ") as printed";
}

} // namespace

Diagnosis diagnose(std::span<Judged> judged, const Signatures& signatures) {
    Diagnosis diagnosis;
    std::vector<std::size_t> left;
    for (std::size_t n = 0; n < judged.size(); ++n) {
        if (judged[n].verdict == Verdict::not_rejected) ++diagnosis.accepted[judged[n].vector->reject];
        if (is_wrong_value(judged[n].verdict)) left.push_back(n);
    }
    diagnosis.wrong = left.size();
    std::vector<Evidence> candidates;
    for (const Mistake& mistake : signatures.mistakes) candidates.emplace_back(judged, mistake, signatures);
    std::set<std::size_t> set_aside;
    while (!left.empty()) {
        Finding best;
        Evidence* of_best = nullptr;
        for (Evidence& candidate : candidates) {
            Finding finding = weigh(judged, candidate, left, set_aside);
            if (finding.explained == 0 || !is_accepted(finding, left.size())) continue;
            if (of_best != nullptr && balance(finding) < balance(best)) continue;
            if (of_best != nullptr && balance(finding) == balance(best) &&
                contradicted_anywhere(judged.size(), candidate, set_aside) >=
                    contradicted_anywhere(judged.size(), *of_best, set_aside))
                continue;
            best = std::move(finding);
            of_best = &candidate;
        }
        if (of_best == nullptr) break;
        std::erase_if(left, [&](std::size_t n) {
            if (of_best->says(n) != Says::agrees) return false;
            call_as_printed(judged[n], *best.mistake);
            return set_aside.insert(n).second;
        });
        diagnosis.findings.push_back(std::move(best));
    }
    for (const std::size_t n : left) {
        for (Evidence& candidate : candidates)
            if (candidate.about().as_printed && candidate.says(n) == Says::agrees) call_as_printed(judged[n], candidate.about());
        diagnosis.unexplained.push_back(&judged[n]);
    }
    diagnosis.by_quantity = by_quantity(diagnosis.unexplained, judged);
    diagnosis.in_common = properties_in_common(diagnosis.unexplained, judged);
    return diagnosis;
}

} // namespace denhartog::conformance
