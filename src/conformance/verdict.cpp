#include "conformance/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "denhartog/elementary/elementary.hpp"

namespace denhartog::conformance {
namespace {

constexpr std::array<std::string_view, number_of_verdicts> names{"pass",    "pass-loose",   "inaccurate", "as-printed",
                                                                 "wrong",   "wrong-regime", "rejected",   "not-rejected",
                                                                 "skipped", "crash",        "timeout",    "stall"};

int rank_of_tier(const std::string& tier) { return tier == "must" ? 0 : tier == "should" ? 1 : 2; }

double median(std::vector<double> sorted) {
    const std::size_t n = sorted.size();
    return n % 2 == 1 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2;
}

} // namespace

std::string_view name(Verdict verdict) { return names.at(static_cast<std::size_t>(verdict)); }

std::optional<Verdict> verdict_named(std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<Verdict>(found - names.begin());
}

bool is_right(Verdict verdict) {
    return verdict == Verdict::pass || verdict == Verdict::pass_loose || verdict == Verdict::rejected;
}

bool is_wrong_value(Verdict verdict) {
    return verdict == Verdict::inaccurate || verdict == Verdict::as_printed || verdict == Verdict::wrong ||
           verdict == Verdict::wrong_regime;
}

int badness(Verdict verdict) {
    switch (verdict) {
    case Verdict::pass:
    case Verdict::rejected: return 0;
    case Verdict::pass_loose: return 1;
    case Verdict::inaccurate: return 2;
    case Verdict::skipped: return 3;
    case Verdict::as_printed:
    case Verdict::wrong:
    case Verdict::wrong_regime:
    case Verdict::not_rejected: return 4;
    case Verdict::crash:
    case Verdict::timeout:
    case Verdict::stall: return 5;
    }
    return 5;
}

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
    std::stable_sort(worst.begin(), worst.end(), [&](const Judged* a, const Judged* b) {
        if (badness(a->verdict) != badness(b->verdict)) return badness(a->verdict) > badness(b->verdict);
        return size(*a) > size(*b);
    });
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
