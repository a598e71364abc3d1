#include "derivation/observations/scene_search.hpp"

#include <cmath>

namespace denhartog::derivation {

Witness place_of(const SlidingScene& s) {
    return {{"scene", s.name},
            {"N", std::to_string(s.sums.R.size())},
            {"r", text(s.sums.r)},
            {"beta", text(s.state.beta)},
            {"mu", text(s.mu)}};
}

Outcome refute_by_largest(const std::function<double(const SlidingScene&)>& excess, const Threshold& threshold,
                          const std::function<Witness(const SlidingScene&)>& witness, const std::string& what) {
    const SlidingScene* worst = nullptr;
    double largest = -INFINITY;
    long tried = 0, above = 0;
    for (const SlidingScene& s : sliding_scenes()) {
        const double e = excess(s);
        if (std::isnan(e)) continue;
        ++tried;
        above += e > threshold.taken;
        if (e > largest) {
            largest = e;
            worst = &s;
        }
    }
    Outcome outcome;
    outcome.steps.push_back({what + ": " + std::to_string(above) + " of " + std::to_string(tried) +
                                 " scenes (the paper's and seed " + std::to_string(seed_of_scenes) +
                                 ") are counterexamples, by more than " + text(threshold.taken),
                             ""});
    if (worst != nullptr) {
        refute_above(outcome, largest, threshold);
        outcome.witness = with(witness(*worst), {{"excess", text(largest)}});
    }
    outcome.witness.emplace_back("cases tried", std::to_string(tried));
    return outcome;
}

Outcome refute_by_largest(const std::function<double(const SlidingScene&)>& excess, double tolerance,
                          const std::function<Witness(const SlidingScene&)>& witness, const std::string& what) {
    Outcome outcome = refute_by_largest(excess, Threshold{.taken = tolerance}, witness, what);
    outcome.thresholds.clear(); // the tolerance is for rounding
    if (outcome.verdict != Verdict::refuted) outcome.witness.erase(outcome.witness.begin(), outcome.witness.end() - 1);
    return outcome;
}

} // namespace denhartog::derivation
