// The verdicts and what is counted of them: the scores of each group, with the median and worst number of right digits, the worst
// answers first, and whether an implementation conforms, `conforms`.
#include "conformance/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

// Name and rank of each verdict, in the order of the enumeration.
struct OfVerdict {
    std::string_view name;
    int badness;
};

constexpr std::array<OfVerdict, number_of_verdicts> verdicts{{{"pass", 0},
                                                              {"pass-loose", 1},
                                                              {"inaccurate", 2},
                                                              {"as-printed", 4},
                                                              {"wrong", 4},
                                                              {"wrong-regime", 4},
                                                              {"rejected", 0},
                                                              {"not-rejected", 4},
                                                              {"skipped", 3},
                                                              {"crash", 5},
                                                              {"timeout", 5},
                                                              {"stall", 5}}};

int rank_of_tier(const std::string& tier) { return tier == "must" ? 0 : tier == "should" ? 1 : 2; }

double median(std::vector<double> sorted) {
    const std::size_t n = sorted.size();
    return n % 2 == 1 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2;
}

} // namespace

std::string_view name(Verdict verdict) { return verdicts.at(static_cast<std::size_t>(verdict)).name; }

std::optional<Verdict> verdict_named(std::string_view name) {
    const auto found = std::ranges::find(verdicts, name, &OfVerdict::name);
    if (found == verdicts.end()) return std::nullopt;
    return static_cast<Verdict>(found - verdicts.begin());
}

int badness(Verdict verdict) { return verdicts.at(static_cast<std::size_t>(verdict)).badness; }

bool is_right(Verdict verdict) { return badness(verdict) <= 1; }

bool is_wrong_value(Verdict verdict) {
    return badness(verdict) == 2 || (badness(verdict) == 4 && verdict != Verdict::not_rejected);
}

bool is_broken(Verdict verdict) { return badness(verdict) == 5; }

double digits(double error) {
    constexpr double most = 17;
    if (!(error > 0)) return most;
    return error < 1 ? std::min(-elementary::log10(error), most) : 0;
}

Counts counts_of(std::span<const Judged> judged) {
    Counts counts{};
    for (const Judged& one : judged) ++counts[static_cast<std::size_t>(one.verdict)];
    return counts;
}

std::vector<Score> scores(std::span<const Judged> judged) {
    std::map<std::pair<int, std::string>, std::vector<Judged>> parts;
    for (const Judged& one : judged) parts[{rank_of_tier(one.vector->tier), one.vector->group}].push_back(one);
    std::vector<Score> all;
    for (const auto& [key, part] : parts) {
        Score score{part.front().vector->tier, key.second, part.size(), counts_of(part), std::nullopt, std::nullopt};
        std::vector<double> of_answers;
        for (const Judged& one : part)
            if (one.error) of_answers.push_back(digits(*one.error));
        std::sort(of_answers.begin(), of_answers.end());
        if (!of_answers.empty()) {
            score.median_digits = median(of_answers);
            score.worst_digits = of_answers.front();
        }
        all.push_back(std::move(score));
    }
    return all;
}

std::optional<double> error_over_tolerance(const Judged& judged) {
    if (!judged.error) return std::nullopt;
    if (judged.vector->tolerance.pass > 0) return *judged.error / judged.vector->tolerance.pass;
    return *judged.error > 0 ? std::numeric_limits<double>::infinity() : 0;
}

std::vector<const Judged*> worst_first(std::span<const Judged> judged) {
    std::vector<const Judged*> worst;
    for (const Judged& one : judged)
        if (!is_right(one.verdict) && one.verdict != Verdict::skipped) worst.push_back(&one);
    const auto size = [](const Judged& one) {
        return error_over_tolerance(one).value_or(std::numeric_limits<double>::infinity());
    };
    const auto order = [&](const Judged* one) {
        const int bad = badness(one->verdict);
        return std::tuple(!is_broken(one->verdict), !one->vector->word.empty(), place_in_chain(one->vector->question), -bad,
                          -size(*one));
    };
    std::ranges::stable_sort(worst, {}, order);
    return worst;
}

bool conforms(std::span<const Judged> judged, const std::set<std::string>& needed) {
    bool anything = false;
    for (const Judged& one : judged) {
        const bool skipped = one.verdict == Verdict::skipped;
        anything = anything || !skipped;
        if (one.vector->tier == "must" && !skipped && !is_right(one.verdict)) return false;
        if (skipped && !one.answered && needed.contains(one.vector->question.quantity)) return false;
    }
    return anything;
}

} // namespace denhartog::conformance
